"""A rotor: solved, compared and explained by the command, and what its sheet says."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

import pytest

from drawings.paper.strokes import Leaf
from drawings.reading.measure import Measured
from drawings.rotor.sheet import leaves
from plans.model.rotor import Plane, Rotor
from plans.rotor.reading import notes_of
from plans.rotor.study import RotorStudy
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.conftest import Run
from tests.drawings.held import faults_on, measured
from tests.drawings.pages import texts
from tests.gallery import GALLERY
from tests.parts import first
from tests.plans.rotors import DYNAMIC, STATIC, mass

FAN = GALLERY / "fan.toml"


def test_solve_gives_the_textbook_s_values_by_both_roads(run: Run) -> None:
    """Methods M7.3, book (8.5)."""
    for by in ("construction", "analysis"):
        code, out, err = run("solve", FAN, "--by", by)
        found = json.loads(out)
        assert (code, err, found["by"]) == (0, "", by)
        told = found["rotor"]
        first, second = told["corrections"]["I"], told["corrections"]["II"]
        assert f"{first['moment']['size']:.11f}" == "0.04770639338"
        assert f"{second['moment']['size']:.11f}" == "0.06181309812"
        assert (first["mass"], second["radius"]) == (0.5, 0.1)
        assert told["reactions"]["after"]["A"] == {"vector": [0.0, 0.0], "size": 0.0, "angle": None}
        assert told["quality"]["grade"] == "G4000"


def test_what_vanishes_is_explained_as_zero(run: Run, tmp_path: Path) -> None:
    """Rounding alone is nothing: neither a reaction of a balanced rotor, nor what closes a star of masses."""
    told = json.loads(run("explain", FAN, "R_A'", "--json")[1])
    assert (told[-1]["name"], told[-1]["value"]) == ("R_A'", "(0, 0) N")
    rows = ", ".join(f"{{ moment = 1, angle = {angle}, place = 1 }}" for angle in (17, 137, 257))
    star = tmp_path / "star.toml"
    planes = "[{ place = 0.3 }, { place = 0 }]"
    star.write_text(f'sheets = ["rotor"]\nrotor.masses = [{rows}]\nrotor.planes = {planes}\n', "utf-8")
    told = json.loads(run("explain", star, "m_ID_I", "--json")[1])
    assert [one["value"] for one in told[-3:]] == ["(0, 0) kg·m²", "(0, 0) kg·m²", "(0, 0) kg·m"]
    assert [one["name"] for one in told[-3:]] == ["m_ID_Ih_I:3", "m_ID_Ih_I", "m_ID_I"]


@pytest.mark.parametrize("mark", ["m_прD_пр", "m_cwD_cw"])
def test_a_mark_is_known_by_its_letters_in_any_language(run: Run, mark: str) -> None:
    code, out, _ = run("explain", GALLERY / "flywheel.toml", mark, "--json")
    assert (code, json.loads(out)[-1]["name"]) == (0, "m_cwD_cw")


def test_a_rotor_has_no_positions(run: Run) -> None:
    assert run("explain", FAN, "R_A", "--position", 0)[0] == 0
    code, out, err = run("explain", FAN, "R_A", "--position", 99)
    assert (code, out) == (3, "")
    assert "--position 99" in err


def test_reactions_are_offered_where_there_are_some(run: Run) -> None:
    assert "R_A, R_A'" in run("explain", FAN, "R_C")[2]
    err = run("explain", GALLERY / "flywheel.toml", "R_C")[2]
    assert "m_cwD_cw" in err and "R_A" not in err and "also" not in err


def test_a_reaction_that_is_not_found_is_told_what_it_needs(run: Run) -> None:
    code, out, err = run("explain", GALLERY / "flywheel.toml", "R_A'")
    assert (code, out) == (3, "")
    assert "bearings and a speed" in err


@pytest.mark.parametrize(("angle", "noted"), [(180, False), (90, True)])
def test_one_plane_is_noted_where_a_couple_about_it_is_left(angle: int, noted: bool) -> None:
    """Two masses in one plane that is not the plane of correction."""
    rows = f'{{ moment = 1, angle = 0, place = "0.5 m" }}, {{ moment = 1, angle = {angle}, place = "0.5 m" }}'
    scene = parse_scene(f'sheets = ["rotor"]\nrotor.masses = [{rows}]\n')
    assert bool(list(notes_of(scene))) == noted


SHEET = (
    'sheets = ["rotor"]\nrotor.masses = [{ moment = 1, angle = 0 }]\n[sheet]\nformat = "A3"\nlanguage = "LANGUAGE"\n'
)


def drawn(rotor: Rotor, language: str = "en") -> tuple[tuple[Leaf, ...], list[Measured]]:
    """Draw a rotor's sheets, and measure each as it stands in its file."""
    study = Study(parse_scene(SHEET.replace("LANGUAGE", language)))
    study._made["rotor"] = RotorStudy(rotor)
    found = leaves(study)
    assert faults_on(study, "rotor", found) == []
    return found, [measured(leaf) for leaf in found]


def test_a_moment_beyond_the_last_plane_is_negative() -> None:
    """A mass 2 m beyond plane II turns the other way about it: m·D·h = 4·(−2) kg·m², at the angle of the mass."""
    planes = (Plane("I", Fraction(3)), Plane("II", Fraction(2)))
    beyond, within = mass(1, "4", "1", 40, "0"), mass(2, "4", "1", 130, "4")
    (leaf,), _ = drawn(Rotor((beyond, within), planes))
    table = [text.plain for group in leaf.groups if "masses" in group.name for text in texts(group)]
    assert {"−2000", "−8", "40"} <= set(table) and "8" in table


def test_a_mark_that_no_polygon_has_is_told_with_the_near_ones(run: Run) -> None:
    code, out, err = run("explain", FAN, "m_1D_2")
    assert (code, out) == (3, "")
    assert "m_1D_1" in err


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
