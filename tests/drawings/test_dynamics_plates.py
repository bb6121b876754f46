"""The sheet of a machine's motion: measured back against published values, and what rounding may not tell."""

from __future__ import annotations

import math
import re
from functools import cache

import pytest

from drawings.dynamics.sheet import Machine, sheets
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured, check, measure
from drawings.measure.measured import MeasuredVector
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups, texts
from drawings.pens.svg import svg
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import first
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


def measured(leaf: Leaf) -> Measured:
    found = measure(svg(lettered(leaf)))
    assert check(found) == []
    return found


def vectors(paper: str) -> dict[tuple[str, str], MeasuredVector]:
    return {(one.plan, one.name): one for leaf in exact(paper) for one in measured(leaf).vectors}


@pytest.mark.rest
@pytest.mark.parametrize("paper", first(["A1", "A3"]))
def test_published_segments_are_measured_back(paper: str) -> None:
    """M4.9: o1k and o1l in mm of 4 J, to what the written coordinates resolve."""
    found = vectors(paper)
    for name, length in (("o1k", 5.316480454), ("o1l", -52.69712643)):
        one = found["loop", name]
        assert abs(one.value - 4j * length) <= 2e-4 * one.scale


@pytest.mark.parametrize("paper", first(["A1", "A3"]))
def test_published_angles_are_measured_back(paper: str) -> None:
    """M4.9: the angles are those of scales of 4 J/mm and 0.0025 kg*m2/mm."""
    found = vectors(paper)
    scales = next(" ".join(texts_of(leaf, "loop")) for leaf in exact(paper) if texts_of(leaf, "loop"))
    energy, inertia = (float(re.search(rf"μ{letter} = ([\d.]+)", scales)[1]) for letter in "TJ")
    for name, angle in (("ψmax", 2.939081068), ("ψmin", 2.713436623)):
        along = found["loop", name].value
        slope = math.tan(math.radians(angle)) * (4 / 0.0025) * inertia / energy
        assert along.imag / along.real == pytest.approx(slope, abs=3e-4 / abs(along))


def texts_of(leaf: Leaf, name: str) -> list[str]:
    return [one.plain for group in groups(leaf.groups) if group.name == name for one in texts((group,))]
