"""The sheet of a machine's motion: measured back against published values, and what rounding may not tell."""

from __future__ import annotations

from functools import cache

from drawings.dynamics.sheet import Machine, sheets
from drawings.paper.strokes import Leaf
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.dynamics_scenes import text

FLYWHEEL = 'fluctuation = "1/25"\nflywheel = { diameter = 0.9 }'


@cache
def study(paper: str = "A1", language: str = "en", asked: str = FLYWHEEL, standard: str = "GOST") -> Study:
    sheet = f'[sheet]\nformat = "{paper}"\nlanguage = "{language}"\nstandard = "{standard}"\n'
    return Study(parse_scene(text(asked=asked) + sheet))


@cache
def exact(paper: str) -> tuple[Leaf, ...]:
    """Lay out the exact motion of the machine of M4.9, without the error of the strips."""
    own = study(paper)
    found = own.comparison("dynamics").exact
    return sheets(own.scene, Machine(own["dynamics"].task, found, found))
