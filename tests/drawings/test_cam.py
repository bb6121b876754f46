"""Sheets of cams: the profile, the coordinates, the rolling follower, the figure of the law, the report."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from drawings.cam import law_diagrams
from drawings.cam import profile as profile_figure
from drawings.cam.coordinates import faults, turns
from drawings.cam.law_diagrams import LawFrame
from drawings.cam.law_frame import LawPlate
from drawings.cam.manufacturing import Manufacture, manufacture
from drawings.cam.notes import ACCELERATION, TRAVEL, VELOCITY, CamNotes
from drawings.cam.profile_view import OUTER, PITCH, WORKING, ProfileView, profile_curve
from drawings.cam.sheet import leaves as sheets_of_cams
from drawings.cam.sheet import workshop_sheets
from drawings.checks.verify import SelfCheckFailed
from drawings.commands.draw import draw
from drawings.files.atomic_files import Enclosure
from drawings.files.coordinate_table import written
from drawings.layout.picture import Place, Spot
from drawings.page.page import Drafting, Field, Scale, drafting_of
from drawings.paper.hand import hand_of
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Circle, Curve, Group, Leaf, LineStyle
from drawings.paper.walk import flat, texts
from drawings.pens.svg import svg
from drawings.reading.measure import Measured, MeasuredProfile, check, measure
from drawings.rotor.sheet import SHEETS
from drawings.symbols.figure import Subject, point
from geometry.errors import LimitError
from plans.analytic.cam.contour import contour
from plans.cam.course import FollowerCourse
from plans.cam.diagrams import LawDiagrams
from plans.cam.diagrams import law_diagrams as diagrams_of
from plans.cam.path import path
from plans.cam.profile.profile import profile
from plans.model.cam import DWELL, GROOVE, POINTED, RETURN, RISE, ROCKING, ROLLER, TRANSLATING, Follower, Law
from plans.model.cam_motion import CamFlaw, CamFound, Contour, Extreme
from plans.scene.scene import Scene, parse_scene, read_scene
from plans.study import Study
from plans.words.words import message
from tests.drawings.cam_contours import apart, view_of
from tests.drawings.conftest import Run
from tests.drawings.exhibits import SHEET, exhibited, read_back
from tests.gallery import GALLERY
from tests.parts import first
from tests.plans import cam_cases as cases
from tests.plans.cam_cases import Case, every, roller_of, titled
from tests.plans.law_cams import STEADY, law_cam, usual
from tests.plans.test_cam_marks import one


def scene(size: str = "A3", language: str = "en") -> Scene:
    return parse_scene(SHEET.format(format=size, language=language))


@cache
def made(name: str, size: str = "A3", language: str = "en") -> tuple[Manufacture, tuple[Leaf, ...]]:
    shown = manufacture(view_of(name).found)
    return shown, workshop_sheets(scene(size, language), [shown])


def test_a_smaller_format_lies_as_the_scene_wants_it() -> None:
    """A4 only stands upright: a scene that wants its sheets lying has the profile on no less than A3."""
    lying = scene().changed(sheet=scene().sheet.changed(orientation="landscape"))
    assert [leaf.width for leaf in workshop_sheets(lying, [made("wedge")[0]])] == [420.0]


def test_where_nothing_takes_it_at_its_own_size_it_lies_on_the_format_of_the_scene() -> None:
    (leaf,) = made("rocker", "A4")[1]
    assert leaf.width == 210.0
    assert {one.scale for one in read_back(leaf).vectors} == {0.002}


def test_sizes_hardly_larger_than_their_letters_stand_beside_another_draft_in_which_all_is_larger() -> None:
    found = read_scene(GALLERY / "feed-cam.toml")
    leaves = sheets_of_cams(Study(found.changed(sheet=found.sheet.changed(format="A3"))))
    assert any(text.plain.endswith("(2:1)") for leaf in leaves for text in texts(leaf.groups))


PAPER = 1.5e-7  # m: rounding of a point on a sheet, at its smallest scale in these tests


@cache
def exhibit(name: str, size: str = "A1", language: str = "en") -> tuple[ProfileView, Leaf, Measured]:
    leaf = exhibited([(profile_figure, view_of(name))], size, language)
    return view_of(name), leaf, read_back(leaf)


def test_a_clockwise_cam_is_the_mirror_of_the_other() -> None:
    marks = [
        {(one.name, one.position): one.value for one in exhibit(name)[2].points if one.name in "PK"}
        for name in ("groove", "clockwise")
    ]
    assert marks[0].keys() == marks[1].keys()
    assert all(abs(value + marks[1][key].conjugate()) < PAPER for key, value in marks[0].items())


def test_an_undercut_is_drawn_through_and_named() -> None:
    """Nothing is trimmed: the whole curve is there, thin and dashed, the contour between its loops in main lines."""
    view, leaf, measured = exhibit("undercut")
    assert {one.kind for one in view.found.flaws} >= {"undercut", "crossing"}
    told = [text.plain for text in texts(leaf.groups)]
    assert told.count("undercut") == told.count("crosses itself") == 2
    curves = [one for one in flat(leaf.groups) if isinstance(one, Curve)]
    contour = [one.pieces for one in curves if one.style.width == hand_of("A1").main]
    assert len(contour) > 2
    (dashed,) = (one for one in curves if one.style.width == hand_of("A1").thin)
    assert dashed.style.dash and sum(map(len, contour)) < len(dashed.pieces) + len(contour)
    (profile,) = (one for one in measured.profiles if one.name == "profile")
    assert profile.gap < PAPER


USUAL = cases.cam(TRANSLATING, ROLLER, -1, closure=GROOVE)
CASE = USUAL, cases.sizes(USUAL)


def drawn(case: Case) -> Contour:
    cam, sizes = case
    return profile(FollowerCourse(cam), sizes, roller_of(cam), turns(cam)).contour


def told(content: bytes, case: Case) -> list[str]:
    cam, sizes = case
    return [str(one) for one in faults(content, CamFound(cam, sizes, roller_of(cam), drawn(case)), "profile.csv")]


def test_lost_row_is_seen() -> None:
    rows = written(USUAL, drawn(CASE)).splitlines(keepends=True)
    assert "x_mm in row 361 of profile.csv (against the analysis)" in told(b"".join(rows[:-1]), CASE)


def test_row_on_a_jump_of_the_acceleration_is_of_one_side_for_both_roads() -> None:
    """At 40 of 100 degrees the valve's acceleration jumps: 40 parts of 360 are a rounding beside 0.4 of the phase."""
    study = Study(read_scene(GALLERY / "valve-cam.toml"))
    (drawing,) = study["cam"].drawings.values()
    joints = np.array(drawing.course.joints)
    plain, own = np.linspace(0.0, drawing.cam.turn, 361), turns(drawing.cam)
    assert np.isin(joints, own).all() and not np.isin(joints, plain).all()
    assert [*faults(written(drawing.cam, drawing.profile(own).contour), drawing.found, "profile.csv")] == []


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
    contour = profile(FollowerCourse(cam), cases.sizes(cam), 0.0, turns(cam)).contour
    assert written(cam, contour).count(b"\n") == 3602  # with its heading, and the first again at the end
    with pytest.raises(LimitError, match=r"coordinates = 100000: more than COORDINATES_LIMIT = 36000"):
        parse_scene(scene.format(count=100000))


MM = 1e-3
PLAN, MU = "profile", 0.5 * MM
PLACE = Place(210.3 + 190.7j, 0j, Scale(MU, "l", "m"))
TURNED = cases.cam(TRANSLATING, ROLLER, 1, closure=GROOVE)


def rolled(case: Case, place: Place = PLACE, turned: float = 0.0) -> bytes:
    """Write a sheet with all curves of a cam."""
    cam, sizes = case
    roller = roller_of(cam)
    away = {WORKING: -roller, PITCH: 0.0} | ({OUTER: roller} if cam.closure == GROOVE else {})
    curves = [
        profile_curve(path(cam, sizes, off), place, PLAN, name, LineStyle(), turned) for name, off in away.items()
    ]
    return sheet_of(*curves, place=place)


def sheet_of(*groups: Group, place: Place = PLACE) -> bytes:
    pole = point(Subject(PLAN, "l", None), "O", 0j, place, Circle(place.on(0j), 1.0), "pole")
    return svg(Leaf(420, 420, (Group((pole, *groups), "figure"),)))


def curves(measured: Measured) -> dict[str, MeasuredProfile]:
    return {one.name: one for one in measured.profiles}


def theirs(case: Case, parts: int) -> Contour:
    """Give what the closed forms have at equal parts of the turn; a rocker over the very ends may miss the profile."""
    cam, sizes = case
    turned = np.linspace(0.0, cam.turn, parts, endpoint=cam.translates)
    return contour(cam, sizes, roller_of(cam), turned[1:-1] if cam.translates and cam.rocks else turned)


@pytest.mark.parametrize("case", first([one for one in every() if one[0].follower.end == ROLLER]), ids=titled)
def test_roller_touches_the_written_profile_by_shapely(case: Case) -> None:
    cam, _ = case
    sag = 1e-8  # m: a fifth of it is lost at the middle of a chord
    profile = curves(measure(rolled(case)))[WORKING]
    gap = apart(profile.pieces, theirs(case, 720).pitch, sag) - roller_of(cam)
    assert np.abs(gap).max() <= profile.deviation + profile.quantum + sag


def test_figure_may_be_moved_but_not_turned_or_stretched() -> None:
    """Pole and curves go together in a group; what is turned no longer begins where it says."""
    case = TURNED, cases.sizes(TURNED)
    sheet = rolled(case).decode()

    def transformed(how: str) -> Measured:
        return measure(sheet.replace('<g id="figure">', f'<g id="figure" transform="{how}">').encode())

    straight, moved = (curves(one)[WORKING] for one in (measure(sheet.encode()), transformed("translate(12 -7)")))
    assert moved.pieces[0].start == straight.pieces[0].start
    assert moved.pieces[7].at(0.3) == pytest.approx(straight.pieces[7].at(0.3), abs=1e-15)
    assert not check(transformed("translate(12 -7)"))
    for how in ("rotate(0.01)", "scale(1.0001)"):
        assert {miss.key.name for miss in check(transformed(how))} == {WORKING, PITCH, OUTER}
    with pytest.raises(SheetRefused, match=r"profile .*: it is stretched"):
        transformed("scale(1 1.1)")


CAMS = {
    "smooth": usual(Law("sine"), Law("3-4-5")),
    "soft": usual(STEADY, Law("cosine")),
    "no dwell": law_cam((RISE, 180, Law("cosine")), (RETURN, 180, Law("cosine")), divisions=12),
    "rocker": usual(Law("sine"), lift=math.radians(25), follower=Follower(ROCKING, POINTED, 0.12)),
    "level": law_cam((DWELL, 360, None)),
}


@cache
def found(name: str) -> LawDiagrams:
    return diagrams_of(CAMS[name])


def framed(name: str, size: str = "A1") -> LawFrame:
    plate = LawPlate(found(name), Drafting(hand_of(size)))
    room = law_diagrams.measure(found(name), plate.drafting)
    scale = Scale(0.02, "φ", "rad")
    return LawFrame(plate, Spot(Field(0, 0, *room.size(scale)), scale))


@pytest.mark.parametrize("name", ["smooth", "soft", "no dwell", "rocker"])
def test_the_scale_of_an_integral_follows_from_its_pole(name: str) -> None:
    """mu_S' = mu_S'' mu_phi H1 and mu_S = mu_S' mu_phi H2; both poles have room beside the graph."""
    frame = framed(name)
    own = {row.key: row for row in frame.plate.rows}
    for key, below in ((ACCELERATION, VELOCITY), (VELOCITY, TRAVEL)):
        distance = frame.distance(own[below])
        assert distance is not None
        assert frame.scales[below].mu == pytest.approx(frame.scales[key].mu * frame.spot.scale.mu * distance)
        size, (least, most) = frame.plate.hand.letter, frame.plate.proportions.pole
        assert least * size <= distance <= most * size


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
    assert f"{scene}:4:1: cam[0].follower: cam “K1”: its follower does not move" in err


@pytest.mark.parametrize("motion", ["translating", 'rocking"\nswing = 14 #'])
def test_under_a_flat_face_without_a_least_curvature_a_cusp_is_drawn(motion: str, run: Run, tmp_path: Path) -> None:
    """It has no 1/ρ, and no circle."""
    scene = tmp_path / "cam.toml"
    text = one("flat", "[cam.sizes]\ncentre = 0.11\n" if "swing" in motion else "").replace("translating", motion)
    scene.write_text(text.replace("lift = ", "# ") if "swing" in motion else text, "utf-8")
    assert run("draw", scene, "-o", tmp_path)[0] == 0
