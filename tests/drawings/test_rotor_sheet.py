"""The sheet of a rotor: measured back against the analysis alone; a careless draughtsman's faults withhold it."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from functools import partial
from pathlib import Path

import pytest
from drawings.checks.rotor.verify_rotor import check, faults

from drawings.checks.verify import SelfCheckFailed, verify
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf, Text
from drawings.pens.svg import svg
from drawings.report.rotor_report import residuals
from drawings.sheets.rotor import leaves, sheets
from plans.checks.rotor_comparison import compare_rotor
from plans.model.rotor import Plane, Rotor
from plans.rotor.study import RotorStudy
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.pages import texts
from tests.drawings.slips import Change, changed, dropped, note, reworded, row_dropped, shifted, turned, without
from tests.parts import first
from tests.plans.rotors import DYNAMIC, STATIC, dynamic, mass, masses, static

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
SCENES = ("fan", "flywheel", "four-masses")
SHEET = (
    'sheets = ["rotor"]\nrotor.masses = [{ moment = 1, angle = 0 }]\n[sheet]\nformat = "A3"\nlanguage = "LANGUAGE"\n'
)


@pytest.fixture(scope="module")
def fan() -> tuple[Study, Leaf]:
    study = Study(read_scene(GALLERY / "fan.toml"))
    (leaf,) = leaves(study)
    return study, leaf


def written(leaf: Leaf, folder: Path) -> Path:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    return path


def drawn(rotor: Rotor, folder: Path, language: str = "en") -> tuple[tuple[Leaf, ...], list[Measured]]:
    """Draw a rotor's sheets, write them, and check each as it is read back."""
    scene, study = parse_scene(SHEET.replace("LANGUAGE", language)), RotorStudy(rotor)
    comparison = compare_rotor(study)
    found = sheets(scene, study, comparison)
    see = partial(check, study=study, comparison=comparison, drafting=drafting_of(scene))
    return found, [verify(written(leaf, folder), leaf, see).measured for leaf in found]


@pytest.mark.parametrize("name", first(SCENES))
def test_a_gallery_scene_is_measured_back(name: str, tmp_path: Path) -> None:
    study = Study(read_scene(GALLERY / f"{name}.toml"))
    for leaf in leaves(study):
        measured = verify(written(leaf, tmp_path), leaf, partial(faults, study=study)).measured
        count = len(study["rotor"].rotor.masses)
        assert {one.plan for one in measured.vectors} <= {"couples", "unbalances"}
        assert len([one for one in measured.vectors if one.plan == "unbalances"]) > count


def test_the_residual_of_the_sheet_is_of_the_finest_grade(fan) -> None:
    """Residual unbalance measured back from the written coordinates: far below what any grade asks."""
    study, leaf = fan
    found = residuals(study.comparison("rotor").analysis, [leaf])
    assert found.keys() == {"I", "II"}
    assert all(0 < off < 1e-6 for off in found.values())
    assert study["rotor"].rotor.quality(*found.values()) < 0.4


SLIPS: list[tuple[Change, str]] = [
    (dropped("m_2D_2", "unbalances"), "m_2D_2 on unbalances is missing"),
    (dropped("m_ID_Ih_I", "couples"), "m_ID_Ih_I on couples is missing"),
    (turned("m_IID_II", "unbalances"), "m_IID_II on unbalances (against the analysis)"),
    (turned("m_1D_1h_1", "couples"), "m_1D_1h_1 on couples (against the analysis)"),
    (shifted("m_3D_3", "unbalances", 0.001), "m_3D_3 on unbalances (against the analysis)"),
    (shifted("m_I", "along", 0.001j), "m_I on along (against the analysis)"),
    (shifted("m_3", "across", 0.001), "m_3 on across (against the analysis)"),
    (dropped("m_II", "along"), "m_II on along is missing"),
    (reworded("0,061813", "0,061814"), "0,061814 for II in the table of masses"),
    (reworded("33,823", "33,833"), "33,833 for I in the table of masses"),
    (reworded("4608,5", "4608,9"), "4608,9 for R_A in the table of results"),
    (reworded("±0,00096", "±0,00095"), "±0,00095 for m_IID_II in the table of results"),
    (reworded("±0,00016", "—"), "— for ΣmDh in the table of results"),
    (reworded("от руки", "расх., %"), "in the table of results"),
    (note("95 из 100", "99 из 100"), "notes"),
    (note("10^{−11}", "10^{−13}"), "(against the analysis)"),
    (without("notes"), "ΣmDh is missing from the notes"),
    (note("0,61813", "0,61814"), "in the notes"),
    (note("95,413", "95,414"), "in the notes"),
    (note("4608,5", "4608,6"), "in the notes"),
    (note("−121,94", "121,94"), "in the notes"),
    (note("401,1", "401,2"), "in the notes"),
    (note("1942", "1943"), "in the notes"),
    (without("masses-1"), "1 is missing from the table of masses"),
    (without("results-1"), "ΣmD is missing from the table of results"),
    (reworded("0,8", "0,9"), "0,9 for 1 in the table of masses"),
    (reworded("95,413", "95,414"), "95,414 for I in the table of masses"),
    (reworded("0,61813", "0,6181"), "0,6181 for II in the table of masses"),
    (reworded("420", "−420"), "−420 for 3 in the table of masses"),
    (reworded("0,0378", "0,0379"), "0,0379 for 3 in the table of masses"),
    (reworded("130", "—"), "— for 2 in the table of masses"),
    (reworded("m, кг", "D, мм"), "Масса in the table of masses"),
    (row_dropped("2"), "2 is missing from the table of masses"),
    (row_dropped("II"), "II is missing from the table of masses"),
    (row_dropped("R_{B}, Н"), "R_B is missing from the table of results"),
    (lambda s: None if isinstance(s, Text) and s.plain == "0,0378" else s, "the row of 3 in the table of masses"),
    (lambda s: None if isinstance(s, Text) and s.plain == "m2D2" else s, "the letter m_2D_2 on unbalances"),
    (
        lambda s: (
            replace(s, content=s.content.replace("0,002", "0,004"))
            if isinstance(s, Text) and isinstance(s.content, str) and "mD}" in s.content
            else s
        ),
        "the scale",
    ),
]


@pytest.mark.parametrize("slip", first(SLIPS))
def test_a_planted_fault_is_seen(fan, slip: tuple[Change, str], tmp_path: Path) -> None:
    (study, leaf), (change, wrong) = fan, slip
    spoilt = changed(leaf, change)
    assert spoilt != leaf
    with pytest.raises(SelfCheckFailed) as told:
        verify(written(spoilt, tmp_path), spoilt, partial(faults, study=study))
    assert wrong in str(told.value)
    assert not re.search(r"\b(the|is|on|in|for|against)\b", said(told.value, "ru"))


def star(count: int, start: int = 17, place: str = "0.37") -> tuple:
    return tuple(mass(k + 1, "0.3", "0.1", start + Fraction(360 * k, count), place) for k in range(count))


@pytest.mark.parametrize("planes", first([STATIC, DYNAMIC]))
def test_a_balanced_rotor_has_no_counterweight_and_no_closing_vector(planes, tmp_path: Path) -> None:
    """Catalogue J1, J5 on paper: no arrow in a random direction."""
    rotor = Rotor(star(5), planes, (Fraction(0), Fraction(1)), 300.0, 20.0, 6.3)
    found, measured = drawn(rotor, tmp_path)
    assert not [mark for one in measured for mark in one.marks if mark.name.startswith(("m_I", "m_cw"))]
    words = [text.plain for leaf in found for group in leaf.groups for text in texts(group)]
    assert any("closes by itself" in word for word in words)
    assert found[0].description.count("= 0: nothing to balance") == len(planes)


def test_one_plane_says_that_a_couple_is_left(tmp_path: Path) -> None:
    """Catalogue J2 on paper."""
    (leaf,), _ = drawn(static(), tmp_path, "ru")
    assert "Одна плоскость: только статическое уравновешивание" in leaf.description


def test_static_moments_alone_are_drawn_by_their_angles(tmp_path: Path) -> None:
    bare = tuple(one._replace(mass=None, radius=None) for one in masses())
    rotor = Rotor(bare, (Plane("I", Fraction(1)), Plane("II", Fraction(0))))
    _, (measured,) = drawn(rotor, tmp_path)
    assert {one.plan for one in measured.points} == set()
    assert len(measured.vectors) == 4 + 5


@pytest.mark.rest
@pytest.mark.parametrize("many", first([(39, 40 + 41), (1000, 2 + 3), (60, 2 + 3), (9, 10 + 11), (20, 21 + 22)]))
def test_many_masses(many: tuple[int, int], tmp_path: Path) -> None:
    """Catalogue J6: numbers alone, then one vector for all masses, and always the table."""
    count, vectors = many
    angle = Fraction(137507764, 1000000)
    around = tuple(mass(k + 1, "0.7", "0.13", angle * (k + 1) % 360, f"{k + 1}e-3") for k in range(count))
    rotor = Rotor(around, (Plane("I", Fraction(1), 0.1), Plane("II", Fraction(0), 0.1)), (), 100.0)
    found, measured = drawn(rotor, tmp_path)
    assert sum(len(one.vectors) for one in measured) == vectors
    rows = {text.plain for leaf in found for group in leaf.groups if "masses" in group.name for text in texts(group)}
    assert {str(k + 1) for k in range(count)} <= rows


@pytest.mark.rest
@pytest.mark.parametrize("apart", first(["1e-6", "1e6"]))
@pytest.mark.parametrize("heavy", ["1e-9", "1e9"])
def test_stiff_rotors_are_drawn(apart: str, heavy: str, tmp_path: Path) -> None:
    rows = [(heavy, "0.12", 20, "0.10"), ("1.1", "0.09", 130, "0.25"), ("0.6", "0.15", 250, "0.42")]
    planes = (Plane("I", Fraction(apart), 0.1), Plane("II", Fraction(0), 0.1))
    drawn(Rotor(masses(rows), planes, (Fraction("-0.1"), Fraction("0.6")), -100.0, 20.0, 6.3), tmp_path)


@pytest.mark.rest
def test_planes_that_lie_together_on_paper_are_drawn(tmp_path: Path) -> None:
    far = Fraction(10**6)
    planes = (Plane("I", far + Fraction(1, 10**9), 0.1), Plane("II", far, 0.1))
    drawn(Rotor(masses(), planes, (Fraction(0), far)), tmp_path)


@pytest.mark.rest
def test_what_rounding_hides_may_be_missing(tmp_path: Path) -> None:
    """A moment 10^42 times less than another, and planes a picometre apart."""
    pair = mass(1, "1e21", "1", 0, "0"), mass(2, "1e-21", "1", 10, "1")
    bare = tuple(one._replace(mass=None, radius=None) for one in pair)
    near = Plane("I", Fraction(0)), Plane("II", Fraction(1, 10**12))
    for planes in (near, near[:1], STATIC, DYNAMIC):
        drawn(Rotor(bare, planes), tmp_path)


@pytest.mark.rest
@pytest.mark.parametrize("language", ["en", "ru"])
def test_both_languages_say_the_same_of_a_rotor(language: str, tmp_path: Path) -> None:
    (leaf,), _ = drawn(
        dynamic(speed=314.0, mass=20.0, grade=6.3, bearings=(Fraction(-1), Fraction(1))), tmp_path, language
    )
    comma = "," if language == "ru" else "."
    assert f"0{comma}061813" in leaf.description and f"33{comma}823" in leaf.description


def test_a_moment_beyond_the_last_plane_is_negative(tmp_path: Path) -> None:
    """A mass 2 m beyond plane II turns the other way about it: m·D·h = 4·(−2) kg·m², at the angle of the mass."""
    planes = (Plane("I", Fraction(3)), Plane("II", Fraction(2)))
    beyond, within = mass(1, "4", "1", 40, "0"), mass(2, "4", "1", 130, "4")
    (leaf,), _ = drawn(Rotor((beyond, within), planes), tmp_path)
    table = [text.plain for group in leaf.groups if "masses" in group.name for text in texts(group)]
    assert {"−2000", "−8", "40"} <= set(table) and "8" in table
