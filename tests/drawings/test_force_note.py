"""The note on forces: inertia forces, equations of moments, force plans and the lever, with numbers put in."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest

import drawings
from drawings.note.force_equations import drawn_scales, equations
from drawings.paper.strokes import Group, Leaf
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.test_linkage_note import BOOK, MATH

GALLERY = Path(drawings.__file__).parent / "gallery"
UNRUBBED = (re.compile(r"\[friction\][^[]*"), "")  # friction has a chapter of its own


@cache
def study(name: str, *changes: tuple[str, str]) -> Study:
    """Study the forces of a scene of the gallery without friction, with parts of it changed."""
    text = UNRUBBED[0].sub("", (GALLERY / f"{name}.toml").read_text("utf-8"))
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return Study(parse_scene(text))


def leaves(made: Study, position: int, scale: float = 20.0) -> dict[str, list[Leaf]]:
    """Give a force sheet whose force plans and lever are drawn to scales."""
    cuts = [f"forces-{cut.label}" for cut in made["forces"].drafts().plans.plan.cuts]
    marks = [Group((), "", {"plan": plan, "scale": str(scale)}) for plan in cuts]
    marks.append(Group((), "", {"plan": "lever", "scale": "0.02"}))
    return {"forces": [cast(Leaf, SimpleNamespace(groups=tuple(marks), metadata={"position": position}))]}


@cache
def note(made: Study, position: int) -> str:
    """Write what a note says of the forces in one position."""
    scales = drawn_scales(leaves(made, position))
    return "\n".join([*equations(made["forces"], made.comparison("forces"), scales), ""])


def test_the_shaper_has_the_numbers_of_the_worked_example() -> None:
    """M5.7: R^t_34 = 10.633, R_34 = 1644.1, R_12 = 2559.2, R_03 = 865, P = 1685.2, R_01 = 4103.3 N, M = 285.04 N m."""
    told = note(study("shaper-loaded", BOOK), 2)
    for line in (
        r"- $\Phi_{5} = m_{5} a_{S_{5}} = 25 \cdot 4.9463 = 123.66\text{ N}$",
        r"- $M_{3}^{\Phi} = -J_{3} \varepsilon_{3} = -0.6 \cdot 6.3759 = -3.8256\text{ N·m}$",
        r"- $R_{34} = 82.205 \cdot 20 = 1644.1\text{ N}$",
        r"- $R_{03} = 43.25 \cdot 20 = 865\text{ N}$",
        r"- $R_{01} = 205.16 \cdot 20 = 4103.3\text{ N}$",
    ):
        assert f"\n{line}\n" in told
    for ends in (
        r"/ 0.2 = 10.633\text{ N}$",
        r"/ 0.45787 = 2559.2\text{ N}$",
        r"/ 0.16914 = 1685.2\text{ N}$",
        r"/ 10 = 285.04\text{ N·m}$",
    ):
        assert f"{ends}\n" in told
    assert r"$$\sum M_{D} = -R_{34}^{t} l_{BD} " in told
    assert r"| $\sum$ |  |  | $-142520$ |" in told  # the power of all forces is -2850.376673 W


@pytest.mark.parametrize(
    ("name", "position"), [("shaper-loaded", 2), ("squeezer", 1), ("toggle-press", 5), ("scotch-yoke", 2)]
)
def test_markdown_leaves_the_equations_alone(name: str, position: int) -> None:
    made = study(name)
    told = note(made, position)
    found = [one or other for one, other in MATH.findall(told)]
    assert len(found) > 15
    for formula in found:
        assert not re.search(r"[*|~<>#`]|\\[^A-Za-z]|(?<![A-Za-z0-9])_", formula), formula
        assert formula.count("{") == formula.count("}"), formula
        assert not re.search("[а-яё]", re.sub(r"\\text\{.*?\}", "", formula)), formula
