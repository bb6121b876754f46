"""A rotor by the command: solved by both roads, compared, explained, timed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from plans.rotor.reading import notes_of
from plans.scene.scene import parse_scene
from tests.drawings.conftest import Run
from tests.gallery import GALLERY

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


def test_only_what_is_asked_for_is_told_and_made(run: Run) -> None:
    code, out, err = run("solve", FAN, "--only", "couples", "--trace")
    assert code == 0
    assert json.loads(out)["rotor"].keys() == {"couple"}
    (made,) = (line for line in err.splitlines() if line.startswith(("made", "построено", "сделано")))
    assert "реакции" not in made and "reactions" not in made


def test_both_roads_agree(run: Run) -> None:
    code, out, _ = run("compare", FAN, "--json")
    names = {(one["plan"], one["name"]) for one in json.loads(out)["findings"]}
    assert code == 0
    assert {("unbalances", "m_ID_I"), ("unbalances", "m_IID_II"), ("reactions", "R_A")} <= names
    assert {("equilibrium", "ΣmD"), ("equilibrium", "ΣmDh")} <= names


def test_explain_tells_moments_first_then_forces(run: Run) -> None:
    code, out, _ = run("explain", FAN, "m_IID_II", "--json")
    steps = json.loads(out)
    plans = [step["plan"] for step in steps]
    assert code == 0
    assert (steps[-1]["name"], steps[-1]["op"]) == ("m_IID_II", "join")
    assert [step["name"] for step in steps].index("m_ID_Ih_I") < [step["name"] for step in steps].index("m_ID_I")
    assert {"couples", "unbalances"} == set(plans)
    assert all(step["why"] for step in steps)


def test_a_mark_that_no_polygon_has_is_told_with_the_near_ones(run: Run) -> None:
    code, out, err = run("explain", FAN, "m_1D_2")
    assert (code, out) == (3, "")
    assert "m_1D_1" in err


def test_what_vanishes_is_explained_as_zero(run: Run, tmp_path: Path) -> None:
    """Rounding alone is nothing: neither a reaction of a balanced rotor, nor what closes a star of masses."""
    told = json.loads(run("explain", FAN, "R_A'", "--json")[1])
    assert (told[-1]["name"], told[-1]["value"]) == ("R_A'", "(0, 0) N")
    rows = ", ".join(f"{{ moment = 1, angle = {angle}, place = 1 }}" for angle in (17, 137, 257))
    star = tmp_path / "star.toml"
    planes = "[{ place = 0.3 }, { place = 0 }]"
    star.write_text(f'sheets = ["rotor"]\nrotor.masses = [{rows}]\nrotor.planes = {planes}\n', "utf-8")
    told = json.loads(run("explain", star, "m_ID_I", "--json")[1])
    assert [one["value"] for one in told[-3:]] == ["(0, 0) kg*m2", "(0, 0) kg*m2", "(0, 0) kg*m"]
    assert [one["name"] for one in told[-3:]] == ["m_ID_Ih_I:3", "m_ID_Ih_I", "m_ID_I"]


@pytest.mark.parametrize("mark", ["m_прD_пр", "m_cwD_cw"])
def test_a_mark_is_known_by_its_letters_in_any_language(run: Run, mark: str) -> None:
    code, out, _ = run("explain", GALLERY / "flywheel.toml", mark, "--json")
    assert (code, json.loads(out)[-1]["name"]) == (0, "m_cwD_cw")


def test_the_steps_have_the_letters_of_the_sheet(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "flywheel.toml"
    scene.write_text(
        (GALLERY / "flywheel.toml").read_text("utf-8").replace("[sheet]", '[sheet]\nlanguage = "ru"'), "utf-8"
    )
    out = run("explain", scene, "m_cwD_cw")[1]
    assert "m_прD_пр:1" in out and "_cw" not in out.partition("\n")[2]


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
