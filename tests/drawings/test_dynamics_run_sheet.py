"""The sheets of a machine with a motor: its tachogram is held, load and table stay beside the graphs."""

from __future__ import annotations

import pytest

from drawings.lettering.extent import bounds
from drawings.page.page import page_of
from drawings.paper.walk import groups
from drawings.report.dynamics_report import chapters
from tests.drawings.held import faults_on
from tests.drawings.slips import changed, dropped, stretched, without
from tests.drawings.test_dynamics_sheet import ASKED, in_part, scaled, sheet, traced
from tests.parts import first

MOTOR = (
    "shafts = [{ inertia = 0.4, ratio = 2.5 }]\n"
    "motor = { rotor = 0.02, ratio = 8, breakdown = 40, slip = 0.2, synchronous = 105 }\nrun = { brake = 100 }\n"
)


def test_the_tachogram_is_held_and_the_report_tells_the_run_by_both_roads() -> None:
    study, found = sheet("A1", "ru", ASKED + MOTOR)
    assert faults_on(study, "dynamics", found) == []
    changes = {name: in_part("tachogram", scaled(name)) for name in ("t_1", "t_2", "t_3", "ω_{уст}", "δ")}
    changes |= {"ω": in_part("tachogram", traced(0, 0.3j)), "long": stretched("t_1", "tachogram")}
    for name, change in {**changes, "lost": dropped("t_1", "tachogram"), "all": without("tachogram-numbers")}.items():
        assert faults_on(study, "dynamics", [changed(one, change) for one in found]), name
    told = "\n".join(chapters(study, {"dynamics": found}).values)
    assert "DOP853" in told or "Radau" in told or "LSODA" in told
    assert told.count("по таблице |") == told.count("решателем |") == 3


def test_a_run_leaves_load_and_table_beside_the_graphs() -> None:
    _, (first, second) = sheet("A1", "ru", ASKED + MOTOR)
    assert first.metadata["figures"] == ["machine", "load_diagram-F_us"]
    assert {"positions-1", "notes"} <= {one.name for one in groups(first.groups)}
    assert second.metadata["figures"] == ["flywheel_sketch", "before", "tachogram"]


@pytest.mark.rest
@pytest.mark.parametrize("language", first(["ru", "en"]))
def test_captions_stay_inside_the_frame_of_a_small_sheet(language: str) -> None:
    study, found = sheet("A4", language, ASKED + MOTOR)
    field = page_of(study.scene).field
    for figure in (one for leaf in found for one in groups(leaf.groups) if one.name in CAPTIONED):
        left, _, right, _ = bounds(figure)
        assert field.left < left and right < field.right


CAPTIONED = ("moments", "works", "surplus", "speeds", "inertia", "loop", "load_diagram-F_us", "tachogram", "before")
