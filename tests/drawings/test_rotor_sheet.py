"""The sheet of a rotor: what is left unbalanced, what needs no counterweight, many and stiff masses."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from drawings.rotor.report import residuals
from drawings.rotor.sheet import leaves
from plans.model.rotor import Plane, Rotor
from plans.rotor.study import RotorStudy
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.held import faults_on, measured
from tests.drawings.pages import texts
from tests.parts import first
from tests.plans.rotors import DYNAMIC, STATIC, mass, masses, static

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
SHEET = (
    'sheets = ["rotor"]\nrotor.masses = [{ moment = 1, angle = 0 }]\n[sheet]\nformat = "A3"\nlanguage = "LANGUAGE"\n'
)


@pytest.fixture(scope="module")
def fan() -> tuple[Study, Leaf]:
    study = Study(read_scene(GALLERY / "fan.toml"))
    (leaf,) = leaves(study)
    return study, leaf


def drawn(rotor: Rotor, language: str = "en") -> tuple[tuple[Leaf, ...], list[Measured]]:
    """Draw a rotor's sheets, and measure each as it stands in its file."""
    study = Study(parse_scene(SHEET.replace("LANGUAGE", language)))
    study._made["rotor"] = RotorStudy(rotor)
    found = leaves(study)
    assert faults_on(study, "rotor", found) == []
    return found, [measured(leaf) for leaf in found]


def test_the_residual_of_the_sheet_is_of_the_finest_grade(fan: tuple[Study, Leaf]) -> None:
    """Residual unbalance measured back from the written coordinates: far below what any grade asks."""
    study, leaf = fan
    found = residuals(study.comparison("rotor").analysis, [leaf])
    assert found.keys() == {"I", "II"}
    assert all(0 < off < 1e-6 for off in found.values())
    assert study["rotor"].rotor.quality(*found.values()) < 0.4


def star(count: int, start: int = 17, place: str = "0.37") -> tuple:
    return tuple(mass(k + 1, "0.3", "0.1", start + Fraction(360 * k, count), place) for k in range(count))


@pytest.mark.parametrize("planes", first([STATIC, DYNAMIC]))
def test_a_balanced_rotor_has_no_counterweight_and_no_closing_vector(planes) -> None:
    """Catalogue J1, J5 on paper: no arrow in a random direction."""
    rotor = Rotor(star(5), planes, (Fraction(0), Fraction(1)), 300.0, 20.0, 6.3)
    found, seen = drawn(rotor)
    assert not [mark for one in seen for mark in one.marks if mark.name.startswith(("m_I", "m_cw"))]
    words = [text.plain for leaf in found for group in leaf.groups for text in texts(group)]
    assert any("closes by itself" in word for word in words)
    assert found[0].description.count("= 0: nothing to balance") == len(planes)


def test_one_plane_says_that_a_couple_is_left() -> None:
    """Catalogue J2 on paper."""
    (leaf,), _ = drawn(static(), "ru")
    assert "Одна плоскость: только статическое уравновешивание" in leaf.description


@pytest.mark.rest
@pytest.mark.parametrize("many", first([(39, 40 + 41), (1000, 2 + 3), (60, 2 + 3), (9, 10 + 11), (20, 21 + 22)]))
def test_many_masses(many: tuple[int, int]) -> None:
    """Catalogue J6: numbers alone, then one vector for all masses, and always the table."""
    count, vectors = many
    angle = Fraction(137507764, 1000000)
    around = tuple(mass(k + 1, "0.7", "0.13", angle * (k + 1) % 360, f"{k + 1}e-3") for k in range(count))
    rotor = Rotor(around, (Plane("I", Fraction(1), 0.1), Plane("II", Fraction(0), 0.1)), (), 100.0)
    found, seen = drawn(rotor)
    assert sum(len(one.vectors) for one in seen) == vectors
    rows = {text.plain for leaf in found for group in leaf.groups if "masses" in group.name for text in texts(group)}
    assert {str(k + 1) for k in range(count)} <= rows


@pytest.mark.rest
@pytest.mark.parametrize("apart", first(["1e-6", "1e6"]))
@pytest.mark.parametrize("heavy", ["1e-9", "1e9"])
def test_stiff_rotors_are_drawn(apart: str, heavy: str) -> None:
    rows = [(heavy, "0.12", 20, "0.10"), ("1.1", "0.09", 130, "0.25"), ("0.6", "0.15", 250, "0.42")]
    planes = (Plane("I", Fraction(apart), 0.1), Plane("II", Fraction(0), 0.1))
    drawn(Rotor(masses(rows), planes, (Fraction("-0.1"), Fraction("0.6")), -100.0, 20.0, 6.3))


@pytest.mark.rest
def test_what_rounding_hides_may_be_missing() -> None:
    """A moment 10^42 times less than another, and planes a picometre apart."""
    pair = mass(1, "1e21", "1", 0, "0"), mass(2, "1e-21", "1", 10, "1")
    bare = tuple(one._replace(mass=None, radius=None) for one in pair)
    near = Plane("I", Fraction(0)), Plane("II", Fraction(1, 10**12))
    for planes in (near, near[:1], STATIC, DYNAMIC):
        drawn(Rotor(bare, planes))


def test_a_moment_beyond_the_last_plane_is_negative() -> None:
    """A mass 2 m beyond plane II turns the other way about it: m·D·h = 4·(−2) kg·m², at the angle of the mass."""
    planes = (Plane("I", Fraction(3)), Plane("II", Fraction(2)))
    beyond, within = mass(1, "4", "1", 40, "0"), mass(2, "4", "1", 130, "4")
    (leaf,), _ = drawn(Rotor((beyond, within), planes))
    table = [text.plain for group in leaf.groups if "masses" in group.name for text in texts(group)]
    assert {"−2000", "−8", "40"} <= set(table) and "8" in table
