"""Sheets of synthesis: each kind of task is drawn, measures back, and is written as a scene that is drawn too."""

from __future__ import annotations

import pytest

from drawings.commands.cli import main
from plans.scene.scene import read_scene

TASKS = [
    "crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 15",
    "crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 15\nframe = 0.441",  # on both circles
    "crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 15\nplace = 160\nbeyond = true",
    "crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 0\nframe = 0.441",
    "slider_crank]\nstroke = 0.12\noffset = 0.03\noverlap = 6.5\nratio = 5",  # theme 6, task 7
    "slider_crank]\nstroke = 0.12\nratio = 4",
    "slider_crank]\nstroke = 0.12\nratio = 4\npressure = 20",
    "slider_crank]\nstroke = 0.12\noffset = 0.05\nratio = 2.2",  # two mechanisms
    "rocker_slider]\nstroke = 0.12\npressure = 20\nratio = 10",  # theme 6, task 8
    "rocker_slider]\nstroke = 0.15\nangles = [8, 30]\nratio = 0.5",  # theme 6, task 9
    "rod_positions]\nplaces = [[0, 0], [0.3, 0.1], [0.4, 0.3]]\nangles = [0, 30, 80]\nhinges = [[0, 0.1], [0.3, 0.05]]",
    "rod_positions]\nplaces = [[0, 0], [0.3, 0.1]]\nangles = [0, 34]\npivots = [[-0.2, -0.2], [0.4, -0.3]]"
    "\narms = [0.5, 0.4]",
    "function_points]\ninputs = [30, 60, 95]\noutputs = [0, 18, 45]\ncrank = 0.1\nframe = 0.3",
    "dwell]\ncrank = 0.1\ncoupler = 0.23\nrocker = 0.25\nframe = 0.21\narm = 0.47\nlean = 60\n"
    "dwell = [149, 219]\noutput = 0.13",
]


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("task", TASKS)
def test_a_sheet_of_synthesis_measures_back(tmp_path, task, language) -> None:
    path = tmp_path / "task.toml"
    path.write_text(f'[synthesis.{task}\n\n[sheet]\nlanguage = "{language}"\n', encoding="utf-8")
    assert main(["draw", str(path), "-o", str(tmp_path)]) == 0
    assert (tmp_path / "task-synthesis.svg").exists()


def test_a_scene_is_written_once(tmp_path, capsys) -> None:
    task, made = tmp_path / "task.toml", tmp_path / "made.toml"
    task.write_text(f'title = "A \\"pump\\""\n[synthesis.{TASKS[4]}\n', encoding="utf-8")
    assert main(["synthesise", str(task), "-o", str(made)]) == 0
    assert read_scene(made).title == 'A "pump"'
    assert main(["synthesise", str(task), "-o", str(made)]) == 7
    assert "made.toml" in capsys.readouterr().err


def test_a_whole_project_is_drawn_in_one_command(tmp_path) -> None:
    """The task, the kinematics of what it gives, and forces by the loads of a file, which tells the drive too."""
    task, tables, made, drawn = (tmp_path / name for name in ("task.toml", "loads.toml", "made.toml", "out"))
    task.write_text(f"[synthesis.{TASKS[5]}\n", encoding="utf-8")
    tables.write_text(LOADS, encoding="utf-8")
    assert main(["synthesise", str(task), "-o", str(made), "--tables", str(tables), "--draw", str(drawn)]) == 0
    sheets = {path.name for path in drawn.glob("*.svg")}
    assert sheets == {"task-synthesis.svg", "made-kinematics.svg", "made-forces.svg"}
    assert read_scene(made).sheet.language == "en"


LOADS = """
sheets = ["kinematics", "forces"]
[drive]
link = 1
speed = "100 rpm"
positions = 12

[masses]
3 = { mass = 5 }

[loads]
gravity = 9.81
[[loads.forces]]
on = 3
point = "B"
against = "motion"
value = 200
"""


def test_marks_are_places_in_metres(tmp_path, capsys) -> None:
    path = tmp_path / "task.toml"
    path.write_text(f"[synthesis.{TASKS[0]}\n", encoding="utf-8")
    assert main(["explain", str(path), "M"]) == 0
    assert "(0, -0.10102) m" in capsys.readouterr().out  # methods M1.5
