"""Tasks of synthesis as commands: what is found is written as a scene, which is drawn too."""

from __future__ import annotations

from drawings.commands.cli import main
from plans.scene.scene import read_scene


def test_a_scene_is_written_once(tmp_path, capsys) -> None:
    task, made = tmp_path / "task.toml", tmp_path / "made.toml"
    task.write_text(
        'title = "A \\"pump\\""\n[synthesis.slider_crank]\nstroke = 0.12\noffset = 0.03\nratio = 5\n'
        '[sheet]\ndrawn = "Lee"\n',
        encoding="utf-8",
    )
    assert main(["synthesise", str(task), "-o", str(made)]) == 0
    assert read_scene(made).title == 'A "pump"' and read_scene(made).sheet.drawn == "Lee"
    assert main(["synthesise", str(task), "-o", str(made)]) == 7
    assert "made.toml" in capsys.readouterr().err


def test_a_whole_project_is_drawn_in_one_command(tmp_path) -> None:
    """The task, the kinematics of what it gives, and forces by the loads of a file, which tells the drive too."""
    task, tables, made, drawn = (tmp_path / name for name in ("task.toml", "loads.toml", "made.toml", "out"))
    task.write_text("[synthesis.slider_crank]\nstroke = 0.12\nratio = 4\n", encoding="utf-8")
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
    path.write_text("[synthesis.crank_rocker]\nrocker = 0.3\nswing = 40\noverlap = 15\n", encoding="utf-8")
    assert main(["explain", str(path), "M"]) == 0
    assert "(0, -0.10102) m" in capsys.readouterr().out  # methods M1.5
