"""What the report, the comparison and the messages of cams say: units, rounding, forces, faces, places in the file."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from drawings.cam.notes import CamNotes
from drawings.cam.report import chapters, without_rounding
from drawings.page.scale import drafting_of
from plans.model.cam_motion import Extreme, Flaw
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.conftest import Run
from tests.gallery import GALLERY
from tests.plans.test_cam_marks import SIZES, SLIDE, TURNING, one

LOAD = "[cam.load]\nmass = 2\nforce = 100\n"


def notes_of(study: Study) -> CamNotes:
    (found,) = study["cam"].found
    return CamNotes(found, drafting_of(study.scene))


def test_a_cam_that_translates_has_its_own_units_and_no_rounding() -> None:
    study = Study(parse_scene(SLIDE))
    values = [*chapters(study, {}).values]
    assert any("| i | x, mm | S, mm | S' | S'', 1/m |" in line for line in values)
    middle = next(line for line in values if line.startswith("| 4 |"))  # S' = 2 h/x, S'' = 0, an inflection
    assert middle.split(" | ")[1:5] == ["30", "15", "1", "0"]
    assert middle.endswith("| ∞ |")
    units = {one.name: one.unit for one in study.comparison("cam").findings}
    assert (units["S'"], units["S''"]) == ("1", "1/m")


def test_rounding_beside_the_largest_is_nothing() -> None:
    assert without_rounding(np.array([1.0, 1e-15, -1e-3, np.inf])).tolist() == [1.0, 0.0, -1e-3, np.inf]
    assert without_rounding(np.zeros(2)).tolist() == [0.0, 0.0]


@pytest.mark.parametrize("end", ["pointed", "roller"])
def test_forces_are_told_and_a_roller_does_not_wear(end: str, run: Run, tmp_path: Path) -> None:
    scene = tmp_path / "cam.toml"
    scene.write_text(one(end, SIZES, TURNING + LOAD), "utf-8")
    _, out, _ = run("solve", scene)
    forces = json.loads(out)["cams"]["K1"]["forces"]
    assert forces["least"]["value"] < forces["most"]["value"]
    assert ("wear" in forces) == (end == "pointed")
    conditions = "\n".join(chapters(Study(read_scene(scene)), {}).conditions)
    assert "Force at the contact: from " in conditions
    assert ("by which it wears" in conditions) == (end == "pointed")


def test_a_face_that_is_long_enough_is_no_complaint() -> None:
    flat = one("flat", '[cam.limits]\ncurvature = "5 mm"\n').replace("lift =", 'reach = "60 mm"\nlift =')
    notes = notes_of(Study(parse_scene(flat)))
    (asked, *_), (face,) = notes.asked(), notes.face()
    assert "reach of the face 60 mm" in asked
    assert face.endswith("to the other; it reaches 60 mm")
    assert "must" not in face


def test_crossings_and_corners_are_told_for_what_they_are() -> None:
    notes = notes_of(Study(parse_scene(one())))
    told = [notes.flaw(0, Flaw("crossing", 1.0, 1.1, Extreme(lost, 1.0))) for lost in (1e-3, 0.0, float("nan"))]
    assert [text.rpartition("cut away")[2][:11] for text in told] == [", and up to", ", but none ", ", and on wh"]
    corner = notes.flaw(0, Flaw("undercut", 0.0, 0.0, Extreme(0.0, 0.0)))
    assert corner.startswith("Corner at φ = 0° (hard shock)")


def test_the_setting_of_a_single_cam_is_told() -> None:
    scene = parse_scene(one().replace("speed =", "setting = 306.9\nspeed ="))
    assert any("306.9°" in line for line in chapters(Study(scene), {}).subject)


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


def test_contact_under_a_rocker_is_counted_from_under_its_pivot() -> None:
    """It stays to one side of the pivot, near the foot of the cam's centre."""
    study = Study(read_scene(GALLERY / "flat-rocker-cam.toml"))
    (said,) = notes_of(study).face()
    near, far = study["cam"].found[0].face
    assert 0 < near < 0.11 < far
    assert said.startswith(f"Contact goes from {1000 * near:.4g} mm to {1000 * far:.4g} mm along the face")
