"""The note on a linkage: data, structure, and the vector equations of its plans with numbers put in."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

import drawings
from drawings.linkage.equations import equations
from drawings.linkage.report import data, structure
from drawings.page.page import Scale
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import some
from tests.plans.scenes import changed

GALLERY = Path(drawings.__file__).parent / "gallery"
SCALES = {2: {"velocities": Scale(0.01, "v", "m/s"), "accelerations": Scale(0.05, "a", "m/s2")}}
MATH = re.compile(r"\$\$(.+?)\$\$|\$(.+?)\$")


@cache
def study(name: str, *changes: tuple[str, str]) -> Study:
    """Study a scene of the gallery, with parts of it changed."""
    return Study(parse_scene(changed((GALLERY / f"{name}.toml").read_text("utf-8"), *changes)))


@cache
def note(name: str, *changes: tuple[str, str]) -> str:
    """Write what a note says of a scene in position 2, at scales of plans."""
    made = study(name, *changes)
    linkage, motion = made["linkage"], made.comparison("linkage").construction
    return "\n".join([*data(linkage), *structure(linkage), *equations(linkage, motion, SCALES, [2])])


BOOK = ('start = "extreme"', "start = 0")  # position 2 is at 60 degrees


def test_the_shaper_has_the_numbers_of_the_worked_example() -> None:
    """M3.8 at φ = 60°: v_A3A = 0.4586441577, ω_3 = 2.421846089, a^k = 2.221531119, CA = 0.4578713072, ω_4 = -1.114."""
    told = note("shaper", BOOK)
    for line in (
        r"- $v_{A} = \omega_{1} l_{OA} = 10 \cdot 0.12 = 1.2\text{ m/s}$",
        r"- $v_{A_{3}A} = aa_{3} \cdot \mu_{v} = 45.864 \cdot 0.01 = 0.45864\text{ m/s}$",
        r"- $a_{A_{3}A}^{k} = 2 \omega_{3} v_{A_{3}A} = 2 \cdot 2.4218 \cdot 0.45864 = 2.2215\text{ m/s}^{2}$",
        r"- $a_{A_{3}A}^{r} = k_{A}a_{3} \cdot \mu_{a} = 163.48 \cdot 0.05 = 8.174\text{ m/s}^{2}$",
        r"- $v_{A_{3}} = v_{A_{3}C} = pa_{3} \cdot \mu_{v} = 110.89 \cdot 0.01 = 1.1089\text{ m/s}$",
        r"- $\omega_{3} = v_{A_{3}C} / l_{CA} = 1.1089 / 0.45787 = 2.4218\text{ rad/s}$, counter-clockwise",
        r"- $\varepsilon_{4} = a_{DB}^{t} / l_{BD} = 3.4767 / 0.2 = 17.383\text{ rad/s}^{2}$, counter-clockwise",
        r"- $v_{D} = pd \cdot \mu_{v} = 169.76 \cdot 0.01 = 1.6976\text{ m/s}$",
    ):
        assert f"\n{line}\n" in f"{told}\n"
    assert r"= 0.2228 / 0.2 = 1.114\text{ rad/s}$, clockwise" in told


KINDS = ("crank-rocker", "slider-crank", "shaper", "tangent", "scotch-yoke", "walking-leg", "oscillating-cylinder")


@pytest.mark.parametrize("name", some(KINDS, 2))
@pytest.mark.parametrize("language", some(["en", "ru"], 2))
def test_markdown_leaves_the_formulas_alone(name: str, language: str) -> None:
    """GitHub reads Markdown before math: no mark of emphasis, no escape, no bar of a table may stand in a formula."""
    text = (GALLERY / f"{name}.toml").read_text("utf-8")
    old = re.search(r'language = ".."\n', text)
    change = (old[0], f'language = "{language}"\n') if old else ("[sheet]\n", f'[sheet]\nlanguage = "{language}"\n')
    told = note(name, change)
    found = [one or other for one, other in MATH.findall(told)]
    assert len(found) > 20
    for formula in found:
        assert not re.search(r"[*|~<>#`]|\\[^A-Za-z]|(?<![A-Za-z0-9])_", formula), formula
        assert formula == formula.strip() and formula.count("{") == formula.count("}"), formula
        assert not re.search("[а-яё]", re.sub(r"\\text\{.*?\}", "", formula)), formula
    assert not re.search(r"\$\d", re.sub(MATH, "", told))
