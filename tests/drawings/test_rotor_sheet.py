"""The sheet of a rotor: what is left unbalanced, what needs no counterweight, many and stiff masses."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from drawings.paper.strokes import Leaf
from drawings.reading.measure import Measured
from drawings.rotor.report import residuals
from drawings.rotor.sheet import leaves
from plans.model.rotor import Plane, Rotor
from plans.rotor.study import RotorStudy
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.held import faults_on, measured
from tests.drawings.pages import texts
from tests.parts import first
from tests.plans.rotors import DYNAMIC, STATIC, mass, static

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


def test_a_moment_beyond_the_last_plane_is_negative() -> None:
    """A mass 2 m beyond plane II turns the other way about it: m·D·h = 4·(−2) kg·m², at the angle of the mass."""
    planes = (Plane("I", Fraction(3)), Plane("II", Fraction(2)))
    beyond, within = mass(1, "4", "1", 40, "0"), mass(2, "4", "1", 130, "4")
    (leaf,), _ = drawn(Rotor((beyond, within), planes))
    table = [text.plain for group in leaf.groups if "masses" in group.name for text in texts(group)]
    assert {"−2000", "−8", "40"} <= set(table) and "8" in table
