"""The tables of techniques, sheets, reports, sessions: all that they name is there, and none hides another."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from drawings.commands import cli
from drawings.report.report import report_of
from drawings.sheets.kind import sheet_kind
from plans.techniques import TECHNIQUES, name_of, techniques
from tests.parts import some
from tests.plans.scenes import scene

# A four-bar of which some positions are out of reach, with masses, and a rotor on whose bearings nothing is asked.
BOTH = scene(
    'sheets = ["forces", "rotor"]', frame="O = [0, 0]; C = [0.3, 0]", links="OA AB BC",
    lengths="OA = 0.2; AB = 0.2; BC = 0.2", sketch="A = [0.1, 0.17]; B = [0.25, 0.2]",
    drive="link = 1; speed = 10; start = 60; positions = 12", masses="2 = { mass = 1 }",
    rotor='bearings = [-0.1, 0.6]; speed = "1500 rpm"',
    rotor_masses=["mass = 1; radius = 0.1; angle = 30; place = 0.1"],
    rotor_planes=["place = 0.5; radius = 0.1", "place = 0; radius = 0.1"],
)  # fmt: skip


@pytest.mark.parametrize("name", TECHNIQUES)
def test_a_technique_has_an_object_a_report_and_a_kind_for_each_of_its_sheets(name: str) -> None:
    technique = techniques()[name]
    assert name_of(technique) == name and report_of(name).chapters
    assert all(
        sheet_kind(sheet).leaves and set(technique.plans) & set(technique.sheets[sheet]) for sheet in technique.sheets
    )


def trace_of(err: str) -> str:
    """Give the plans that a trace says were made."""
    return next(line for line in err.splitlines() if line.startswith("made:")).removeprefix("made: ")


@pytest.fixture
def both(tmp_path: Path) -> Path:
    path = tmp_path / "both.toml"
    path.write_text(BOTH, "utf-8")
    return path


def test_no_technique_hides_the_numbers_of_another(both: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["solve", str(both)]) == 4
    told = json.loads(capsys.readouterr().out)
    assert set(told["reactions"]) == {"0-1", "0-3", "1-2", "2-3"}
    assert set(told["rotor"]["corrections"]) == {"I", "II"}


@pytest.mark.parametrize(
    "command", some([("solve",), ("solve", "--by", "analysis"), ("compare",), ("compare", "--json")], 2)
)
def test_gaps_of_one_technique_are_not_hidden_by_another(command: tuple[str, ...], both: Path) -> None:
    assert cli.main([*command, str(both)]) == 4


def test_a_rotor_beside_a_linkage_asks_nothing_of_it(both: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cli.main(["solve", str(both), "--only", "positions,couples", "--trace"])
    made = trace_of(capsys.readouterr().err)
    assert "velocities" not in made
    assert "positions" in made
