"""The profile on a written sheet: read back within what it states, and a roller in its place touches it."""

from __future__ import annotations

import numpy as np
import pytest

from drawings.cam.profile_view import OUTER, PITCH, WORKING, profile_curve
from drawings.layout.picture import Place
from drawings.page.scale import Scale
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Circle, Group, Leaf, LineStyle
from drawings.pens.svg import svg
from drawings.reading.measure import Measured, MeasuredProfile, check, measure
from drawings.symbols.figure import Subject, point
from plans.analytic.cam.contour import contour
from plans.cam.path import path
from plans.model.cam import GROOVE, ROLLER, TRANSLATING
from plans.model.cam_motion import Contour
from tests.drawings.cam_contours import apart
from tests.parts import first
from tests.plans import cam_cases as cases
from tests.plans.cam_cases import Case, every, roller_of, titled

MM = 1e-3
PLAN, MU = "profile", 0.5 * MM
PLACE = Place(210.3 + 190.7j, 0j, Scale(MU, "l", "m"))
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


def theirs(case: Case, parts: int) -> Contour:
    """Give what the closed forms have at equal parts of the turn; a rocker over the very ends may miss the profile."""
    cam, sizes = case
    turned = np.linspace(0.0, cam.turn, parts, endpoint=cam.translates)
    return contour(cam, sizes, roller_of(cam), turned[1:-1] if cam.translates and cam.rocks else turned)


@pytest.mark.parametrize("case", first([one for one in every() if one[0].follower.end == ROLLER]), ids=titled)
def test_roller_touches_the_written_profile_by_shapely(case: Case) -> None:
    cam, _ = case
    sag = 1e-8  # m: a fifth of it is lost at the middle of a chord
    profile = curves(measure(written(case)))[WORKING]
    gap = apart(profile.pieces, theirs(case, 720).pitch, sag) - roller_of(cam)
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
