"""The profile on a written sheet: read back within what it states, and a follower rolled over it returns the law."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from drawings.checks.cam.profiles import Analysed, analysed, wrong
from drawings.checks.cam.rolling import apart, rolled
from drawings.figures.cam.profile_curve import profile_curve
from drawings.figures.cam.profile_view import OUTER, PITCH, WORKING
from drawings.layout.place import Place
from drawings.measure.measure import Measured, check, measure
from drawings.measure.measured_profile import MeasuredProfile
from drawings.page.scale import Scale
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Circle, Group, Leaf, LineStyle, numeral
from drawings.pens.svg import svg
from drawings.symbols.figure import Subject, point
from geometry.curve import CubicPiece, Piece, RoundPiece, sampled, straight
from plans.analytic.cam.contour import contour
from plans.analytic.cam.laws import travel
from plans.cam.path import ProfilePath, path
from plans.model.cam import GROOVE, ROLLER, TRANSLATING
from plans.model.cam_motion import ANALYSIS, CamFound, Extreme, Flaw, Sizes
from tests.parts import first, some
from tests.plans import cam_cases as cases
from tests.plans.cam_cases import Case, every, roller_of, titled

MM = 1e-3
PLAN, MU = "profile", 0.5 * MM
PLACE = Place(210.3 + 190.7j, 0j, Scale(MU, "l", "m"))
CASES = first(every())
USUAL = cases.cam(TRANSLATING, ROLLER, 1, closure=GROOVE)


def written(case: Case, place: Place = PLACE, turned: float = 0.0) -> bytes:
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


def theirs(case: Case, parts: int = 180, *flaws: Flaw) -> Analysed:
    cam, sizes = case
    none = contour(cam, sizes, roller_of(cam), np.zeros(0))
    return analysed(CamFound(ANALYSIS, cam, sizes, roller_of(cam), none, flaws=flaws), parts)


def faults(sheet: bytes, case: Case, *flaws: Flaw) -> str:
    measured = measure(sheet)
    wrongs = [*wrong(measured.profiles, PLAN, theirs(case, 180, *flaws))]
    return "; ".join([*map(str, wrongs), *(f"{miss.key.name} is not where it says" for miss in check(measured))])


@pytest.mark.parametrize("turned", [pytest.param(0.0, marks=pytest.mark.rest), 37.5])
def test_profile_is_read_back_as_it_was_drawn(turned: float) -> None:
    case = USUAL, cases.sizes(USUAL)
    found = curves(measure(written(case, turned=turned)))
    for name, away in {WORKING: -0.01, PITCH: 0.0, OUTER: 0.01}.items():
        drawn, own = path(*case, away), found[name]
        assert [type(piece) for piece in own.pieces if isinstance(piece, CubicPiece)] == [
            CubicPiece for piece in drawn.pieces if isinstance(piece, CubicPiece)
        ]
        assert drawn.deviation <= own.deviation < 1.1 * drawn.deviation
        assert own.quantum == pytest.approx(math.sqrt(2) * 1e-6 * MU)
        spots = np.array([piece.at(share) for piece in drawn.pieces for share in (0.1, 0.5, 0.9)])
        assert apart(own.pieces, True, spots).max() <= own.quantum


@pytest.mark.parametrize("case", CASES, ids=titled)
def test_what_is_written_is_right(case: Case) -> None:
    assert faults(written(case), case) == ""


@pytest.mark.parametrize("case", some(every(), every=36), ids=titled)
def test_law_comes_back_at_3600_angles(case: Case) -> None:
    """The way along the normal that a profile is off, over the cosine of the pressure angle: so much is S."""
    cam, sizes = case
    own = theirs(case, 3600)
    found = curves(measure(written(case)))
    for name in {WORKING, OUTER} & found.keys():
        one = found[name]
        s = rolled(one.pieces, cam, sizes, roller_of(cam), own.contour.turned, outer=name == OUTER)
        off = np.abs(s - travel(cam, own.contour.turned).s) / own.rate()
        assert (off <= one.deviation + one.quantum + 1e-15).all()
        assert off.max() > one.deviation / 4  # it is the file that is told, not the law


@pytest.mark.parametrize("case", first([one for one in every() if one[0].follower.end == ROLLER]), ids=titled)
def test_roller_touches_the_written_profile_by_shapely(case: Case) -> None:
    shapely = pytest.importorskip("shapely")
    cam, _ = case
    sag = 1e-8  # m: a fifth of it is lost at the middle of a chord
    profile = curves(measure(written(case)))[WORKING]
    line = shapely.LineString([(spot.real, spot.imag) for spot in sampled(profile.pieces, sag)])
    pitch = theirs(case, 720).contour.pitch
    gap = shapely.distance(line, shapely.points(pitch.real, pitch.imag)) - roller_of(cam)
    assert np.abs(gap).max() <= profile.deviation + profile.quantum + sag


def test_figure_may_be_moved_but_not_turned_or_stretched() -> None:
    """Pole and curves go together in a group; what is turned no longer begins where it says."""
    case = USUAL, cases.sizes(USUAL)
    sheet = written(case).decode()

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


def edited(change: Callable[[str], str]) -> str:
    """Say what is wrong with a usual sheet after its profile's path data were changed."""
    case = USUAL, cases.sizes(USUAL)
    sheet = written(case).decode()
    data = next(data for data in re.findall(r' d="([^"]*)"', _bearer(sheet, WORKING)))
    assert change(data) != data
    return faults(sheet.replace(data, change(data)).encode(), case)


def _bearer(sheet: str, name: str) -> str:
    return next(tag for tag in re.findall(r"<path [^>]*>", sheet) if f'data-name="{name}"' in tag)


def _shifted(data: str) -> str:
    """Move the end of one cubic by 0.005 mm, that is 0.0025 mm of the cam."""
    first = re.search(r"C(\S+) (\S+) (\S+) (\S+) (\d+)\.(\d+)", data)
    assert first is not None
    x = float(f"{first[5]}.{first[6]}") + 0.005
    return data.replace(first[0], f"C{first[1]} {first[2]} {first[3]} {first[4]} {x:.6f}", 1)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (_shifted, r"profile on profile, 0\.00\d+ mm off at [\d.]+° \(against the analysis\)"),
        pytest.param(
            lambda data: data.replace("Z", "").rsplit("C", 1)[0],
            r"the polygon profile does not close",
            marks=pytest.mark.rest,
        ),
        pytest.param(
            lambda data: data.replace(" 0 0 1 ", " 0 0 0 ", 1), r"profile on profile, .* mm off", marks=pytest.mark.rest
        ),
    ],
)
def test_edited_profile_is_seen(change: Callable[[str], str], told: str) -> None:
    assert re.search(told, edited(change))


def test_profile_that_no_follower_can_go_along_is_held_by_its_points_alone() -> None:
    cam = replace(cases.cam(), phases=cases.phases(cases.USUAL, 0.02))
    case = cam, cases.sizes(cam, -0.01, 0.011)
    undercut = Flaw("undercut", 1.0, 1.4, Extreme(0.0, 1.2))
    assert faults(written(case), case, undercut) == ""
    assert re.search(
        r"profile on profile: a follower rolled over it misses the law by [\d.]+ mm at", faults(written(case), case)
    )


PLAIN = cases.cam()
SIZES = cases.sizes(PLAIN)
Change = Callable[[ProfilePath], ProfilePath]


def mirrored(drawn: ProfilePath) -> ProfilePath:
    def turned(piece: Piece) -> Piece:
        if isinstance(piece, CubicPiece):
            return CubicPiece(*(-point.conjugate() for point in piece))
        return RoundPiece(-piece.start.conjugate(), -piece.centre.conjugate(), -piece.sweep)

    return replace(drawn, pieces=tuple(map(turned, drawn.pieces)))


def chorded(drawn: ProfilePath) -> ProfilePath:
    pieces = (straight(one.start, one.end) if isinstance(one, RoundPiece) else one for one in drawn.pieces)
    return replace(drawn, pieces=tuple(pieces))


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda _: path(PLAIN, SIZES, 0.01), r"profile on profile, 20 mm off at"),  # the roller added
        (lambda _: path(PLAIN, SIZES), r"profile on profile, 10 mm off at"),  # the pitch curve for the profile
        (mirrored, r"profile on profile, .* off at"),
        (
            lambda _: path(replace(PLAIN, sense=-1), SIZES, -0.01),
            r"profile on profile, .* off at",
        ),  # turned with the cam
        (lambda _: path(PLAIN, SIZES._replace(offset=-0.012), -0.01), r"profile on profile, .* off at"),
        (chorded, r"profile on profile, .* off at"),  # dwells as chords
        (lambda drawn: replace(drawn, deviation=1e-12), r"profile on profile, .* off at"),  # understated
        (
            lambda _: path(PLAIN, SIZES, -0.01, 36, exact=False),
            r"profile on profile is drawn 0\.00\d+ mm off",
        ),  # coarse
        (lambda drawn: replace(drawn, pieces=drawn.pieces[:-1]), r"profile on profile, .* off at"),  # a dwell lost
    ],
)
def test_fault_of_drawing_is_seen(change: Change, told: str) -> None:
    drawn = profile_curve(change(path(PLAIN, SIZES, -0.01)), PLACE, PLAN, WORKING, LineStyle())
    assert re.search(told, faults(sheet_of(drawn), (PLAIN, SIZES)))


def test_fault_of_placing_is_seen() -> None:
    drawn = path(PLAIN, SIZES, -0.01)
    beside = Place(PLACE.origin + 0.001, 0j, PLACE.scale)
    enlarged = Place(PLACE.origin, 0j, Scale(MU / 1.0001, "l", "m"))
    for place in (beside, enlarged):
        group = profile_curve(drawn, place, PLAN, WORKING, LineStyle())
        told = Group(group.strokes, "", {**group.data, "scale": numeral(MU)})
        assert "profile is not where it says" in faults(sheet_of(told), (PLAIN, SIZES))
    assert faults(sheet_of(), (PLAIN, SIZES)) == "profile on profile is missing"
    other = profile_curve(drawn, PLACE, PLAN, OUTER, LineStyle())
    assert "outer on profile (the analysis has none)" in faults(sheet_of(other), (PLAIN, SIZES))


def test_a_roller_smaller_than_the_steps_of_looking_finds_a_long_straight_profile() -> None:

    whole = replace(USUAL, translates=True)
    turned = np.linspace(0.3, 0.35, 7)
    level = rolled((straight(0j, whole.sense + 0j),), whole, Sizes(0.0), 1e-4, turned)
    assert level == pytest.approx(np.full(7, 1e-4), abs=1e-12)


def test_a_place_beside_two_strands_is_nearest_to_its_own() -> None:
    long, back = straight(0j, 1 + 0j), straight(1 + 0j, 0.9 + 0.003j)
    spots = np.linspace(0.9, 1.0, 53).astype(np.complex128)
    assert apart((long, back, straight(back.end, 0.9 + 1j)), False, spots) == pytest.approx(np.zeros(53), abs=1e-9)
