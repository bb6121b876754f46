"""Coordinates of a profile as a file beside its sheet: right, closed, held to the analysis, of its set."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from drawings.cam.coordinates import enclosures, faults, turns
from drawings.checks.verify import SelfCheckFailed
from drawings.commands.draw import draw
from drawings.files.coordinate_table import read, written
from drawings.files.file_error import Enclosure
from drawings.paper.strokes import SheetError
from drawings.rotor.sheet import SHEETS
from geometry.errors import LimitError
from plans.cam.course import Course
from plans.cam.path import path
from plans.cam.profile.profile import profile
from plans.model.cam import GROOVE, ROLLER, TRANSLATING
from plans.model.cam_motion import CamFound, Contour
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from plans.words.words import message
from tests.drawings.cam_contours import apart
from tests.drawings.planting import DrawingFault, planted
from tests.gallery import GALLERY
from tests.parts import first
from tests.plans import cam_cases as cases
from tests.plans.cam_cases import Case, every, roller_of, titled

MM = 1e-3
LAST = 1e-6  # mm: the last digit that is written
USUAL = cases.cam(TRANSLATING, ROLLER, -1, closure=GROOVE)
CASE = USUAL, cases.sizes(USUAL)


def drawn(case: Case) -> Contour:
    cam, sizes = case
    return profile(Course(cam), sizes, roller_of(cam), turns(cam)).contour


def told(content: bytes, case: Case) -> list[str]:
    cam, sizes = case
    found = CamFound(cam, sizes, roller_of(cam), drawn(case))
    return [str(one) for one in faults(content, found, "profile.csv")]


@pytest.mark.parametrize("case", first(every()), ids=titled)
def test_coordinates_are_those_of_the_analysis_and_on_the_drawn_path(case: Case) -> None:
    cam, sizes = case
    content = written(cam, drawn(case))
    assert told(content, case) == []
    found = read(content)
    spots = (np.array(found["x_mm"]) + 1j * np.array(found["y_mm"])) * MM
    own = path(cam, sizes, -roller_of(cam))
    assert len(spots) == cam.coordinates + 1
    assert apart(own.pieces, spots, LAST * MM).max() <= own.deviation + 2 * LAST * MM
    if not cam.translates:
        assert abs(spots[-1] - spots[0]) <= 2 * LAST * MM
        assert found["turned_deg"][-1] == 360
        assert found["angle_deg"][-1] - found["angle_deg"][0] == pytest.approx(-360 * cam.sense, abs=2 * LAST)
        assert found["theta_deg"][0] == 0  # θ of the sheet is counted against the rotation
        assert found["theta_deg"][-1] == pytest.approx(360, abs=2 * LAST)


def test_columns_are_told_by_what_there_is() -> None:
    groove = list(read(written(USUAL, drawn(CASE))))
    assert groove[:2] == ["turned_deg", "s_mm"] and groove[-2:] == ["pressure_deg", "curvature_radius_mm"]
    assert {"radius_mm", "outer_x_mm", "pitch_angle_deg"} <= set(groove)
    slide = cases.cam(translates=True, phases=cases.phases(cases.USUAL, cases.LIFT, 0.3))
    assert not [name for name in read(written(slide, drawn((slide, cases.sizes(slide))))) if "angle" in name]


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        (b"\r\n90.000000,", b"\r\n90.000002,", "turned_deg in row 91 of profile.csv (against the analysis)"),
        (b"outer_x_mm", b"other_x_mm", "the column outer_x_mm of profile.csv"),
        (b"curvature_radius_mm", b"radius", "the column curvature_radius_mm of profile.csv"),
    ],
)
def test_wrong_coordinate_is_seen(old: bytes, new: bytes, fault: str) -> None:
    content = written(USUAL, drawn(CASE))
    assert content.count(old) == 1
    assert fault in told(content.replace(old, new), CASE)


def test_lost_row_is_seen() -> None:
    content = written(USUAL, drawn(CASE))
    rows = content.splitlines(keepends=True)
    assert "x_mm in row 361 of profile.csv (against the analysis)" in told(b"".join(rows[:-1]), CASE)


@pytest.mark.parametrize(
    ("right", "wrong", "column"),
    [
        ("np.abs(points) * MM", "np.abs(points) * MM * 1.01", "radius_mm"),
        ("-cam.sense * (found", "cam.sense * (found", "theta_deg"),
        ("points.imag * MM", "-points.imag * MM", "y_mm"),
        ("contour.pressure * DEGREES", "contour.pressure", "pressure_deg"),
        ("contour.travel.s * s", "contour.travel.s * s * 1.01", "s_mm"),
    ],
)
def test_a_fault_of_the_table_is_seen(right: str, wrong: str, column: str) -> None:
    file = "drawings/files/coordinate_table.py"
    with planted(DrawingFault(column, "", file, right, wrong)):
        content = written(USUAL, drawn(CASE))
    assert f"{column} in row" in " ".join(told(content, CASE))


def test_row_on_a_jump_of_the_acceleration_is_of_one_side_for_both_roads() -> None:
    """At 40 of 100 degrees the valve's acceleration jumps: 40 parts of 360 are a rounding beside 0.4 of the phase."""
    study = Study(read_scene(GALLERY / "valve-cam.toml"))
    (drawing,) = study["cam"].drawings.values()
    joints = np.array(drawing.course.joints)
    plain, own = np.linspace(0.0, drawing.cam.turn, 361), turns(drawing.cam)
    assert np.isin(joints, own).all() and not np.isin(joints, plain).all()
    assert [*faults(written(drawing.cam, drawing.profile(own).contour), drawing.found, "profile.csv")] == []


@pytest.mark.parametrize("sheet", ["cam", "profile"])
def test_name_that_cannot_be_lettered_is_refused_at_its_line(tmp_path: Path, sheet: str) -> None:
    text = (GALLERY / "valve-cam.toml").read_text("utf-8").replace("[[cam]]", '[[cam]]\nname = "雪"')
    scene = tmp_path / "cam.toml"
    scene.write_text(text.replace('sheets = ["cam", "profile"]', f'sheets = ["{sheet}"]'), "utf-8")
    with pytest.raises(SheetError, match=r"cam.toml:8:1: cam\.0\.name: .* lacks '雪'"):
        draw(scene, tmp_path)


SHAFT = GALLERY / "fan.toml"


def right(study: Study) -> Iterator[Enclosure]:
    yield Enclosure("masses.csv", f"{study.scene.title}\r\n".encode(), lambda written: ())


def wrong(study: Study) -> Iterator[Enclosure]:
    yield Enclosure("masses.csv", b"1", lambda written: [message("wrong.column", name=written.decode(), file="it")])


def enclosed(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setitem(SHEETS, "rotor", SHEETS["rotor"]._replace(enclosures=globals()[name]))


def test_enclosure_is_of_the_set(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    enclosed(monkeypatch, "right")
    sheets = draw(SHAFT, tmp_path)
    assert tmp_path / "fan-masses.csv" in sheets.paths
    assert (tmp_path / "fan-masses.csv").read_bytes().endswith(b"\r\n")
    listed = json.loads((tmp_path / "fan-manifest.json").read_text("utf-8"))["files"]
    assert "fan-masses.csv" in {entry["name"] for entry in listed}


def test_an_enclosure_that_is_wrong_is_withheld(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    enclosed(monkeypatch, "wrong")
    with pytest.raises(SelfCheckFailed, match="the column 1 of it"):
        draw(SHAFT, tmp_path)
    assert not (tmp_path / "fan-masses.csv").exists()


def test_as_many_coordinates_as_the_scene_asks_for_up_to_a_limit() -> None:
    scene = """
title = "a"
[[cam]]
coordinates = {count}
follower = {{ motion = "translating", end = "pointed", lift = "30 mm" }}
sizes = {{ base = "50 mm", offset = "5 mm" }}
phases = [{{ kind = "rise", angle = 180, law = "sine" }}, {{ kind = "return", angle = 180, law = "sine" }}]
"""
    (cam,) = (one.cam for one in Study(parse_scene(scene.format(count=3600)))["cam"].drawings.values())
    contour = profile(Course(cam), cases.sizes(cam), 0.0, turns(cam)).contour
    assert written(cam, contour).count(b"\n") == 3602  # with its heading, and the first again at the end
    with pytest.raises(LimitError, match=r"coordinates = 100000: more than COORDINATES_LIMIT = 36000"):
        parse_scene(scene.format(count=100000))


EDGE = """
title = "a"
[[cam]]
follower = { motion = "translating", end = "flat", lift = "30 mm" }
limits = { curvature = 0 }
phases = [{ kind = "rise", angle = 120, law = "sine" }, { kind = "dwell", angle = 30 },
    { kind = "return", angle = 90, law = "cosine" }, { kind = "dwell", angle = "rest" }]
"""


def test_a_profile_with_an_edge_at_a_numbered_position_is_held_too() -> None:
    """There the radius of curvature is 0 but for rounding: both roads and the coordinates are held by ρ itself."""
    study = Study(parse_scene(EDGE))
    compared = study.comparison("cam")
    (own,) = compared.construction.cams
    assert np.abs(own.contour.radius).min() < 1e-15
    assert compared.worst <= 1
    assert own.flaws == compared.analysis.cams[0].flaws == ()
    (told,) = enclosures(study)
    assert [*told.faults(told.content)] == []
    text = told.content.decode()
    (row, *_) = (line for line in text.splitlines() if ",0.000000" in line and line.startswith("150.0"))
    wrong = text.replace(row, ",".join([*row.split(",")[:-1], "0.000002"]))
    assert [*told.faults(wrong.encode())] != []
