"""What messages and the comparison of cams say: crossings, corners, places in the file, heads over their columns."""

from __future__ import annotations

from pathlib import Path

from drawings.cam.notes import CamNotes
from drawings.page.scale import drafting_of
from plans.model.cam_motion import CamFlaw, Extreme
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.conftest import Run
from tests.plans.test_cam_marks import one


def notes_of(study: Study) -> CamNotes:
    (found,) = study["cam"].found
    return CamNotes(found, drafting_of(study.scene))


def test_crossings_and_corners_are_told_for_what_they_are() -> None:
    notes = notes_of(Study(parse_scene(one())))
    told = [notes.flaw(0, CamFlaw("crossing", 1.0, 1.1, Extreme(lost, 1.0))) for lost in (1e-3, 0.0, float("nan"))]
    assert [text.rpartition("cut away")[2][:11] for text in told] == [", and up to", ", but none ", ", and on wh"]
    corner = notes.flaw(0, CamFlaw("undercut", 0.0, 0.0, Extreme(0.0, 0.0)))
    assert corner.startswith("Corner at φ = 0° (hard shock)")


def test_what_cannot_be_made_is_told_with_its_place(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "cam.toml"
    scene.write_text(one("flat", "[cam.limits]\nrise = 30\n").replace("30 mm", "0 mm"), "utf-8")
    code, _, err = run("solve", scene)
    assert code == 3
    assert f"{scene}:4:1: cam[0].follower: cam K1: its follower does not move" in err


def test_the_head_of_the_comparison_stands_over_its_columns(run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "cams.toml"
    scene.write_text(one() + one(name="the other one"), "utf-8")
    _, out, _ = run("compare", scene)
    head, first, *_ = out.splitlines()
    assert head.index(" difference") > first.index("0.03") > head.index("quantity") + len("S the other one")
