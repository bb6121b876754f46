"""The figure of a cam's profile: its marks lie where formulas put them, its letters are clear of all lines."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from drawings.checks.letters import unlettered
from drawings.figures.cam import profile_figure
from drawings.figures.cam.profile_view import ProfileView
from drawings.measure.measure import Measured
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Circle, Curve, Group, Leaf, Line, Polyline
from drawings.paper.walk import flat, texts, walk
from geometry.curve import RoundPiece
from plans.model.cam import DWELL
from tests.drawings.cam_contours import EVERY, levers, view_of
from tests.drawings.collisions import collisions
from tests.drawings.exhibits import exhibited, read_back
from tests.parts import first, some

PAPER = 1.5e-7  # m: rounding of a point on a sheet, at its smallest scale in these tests


@cache
def exhibit(name: str, size: str = "A1", language: str = "en") -> tuple[ProfileView, Leaf, Measured]:
    leaf = exhibited([(profile_figure, view_of(name))], size, language)
    return view_of(name), leaf, read_back(leaf)


def near(found: complex, true: complex, scale: float) -> bool:
    return abs(found - true) <= 3e-4 * scale


@pytest.mark.parametrize("name", first(EVERY))
def test_marks_lie_where_formulas_put_them(name: str) -> None:
    """P and Q in the cam, K in the frame, O1 turned back; the curves begin where the first of them are."""
    view, _, measured = exhibit(name)
    cam, turned = view.cam, view.contour.turned
    tip, lever = levers(cam, view.sizes, turned)
    back = np.exp(-1j * cam.sense * turned) if not cam.translates else np.ones_like(tip)
    pitch = tip * back if not cam.translates else tip + cam.sense * turned
    true = {"P": pitch, "Q": pitch - view.found.roller * lever / abs(lever) * back, "K": tip}
    true["O_1"] = view.sizes.pivot * back
    true["K"] = view.axis + 1j * tip.imag if cam.flat else tip
    points = [one for one in measured.points if one.position is not None]
    assert len(points) >= len(turned) // 2
    for one in points:
        assert near(one.value, true[one.name][one.position], one.scale), one.key
    for one in measured.vectors:
        if one.name == "Q":
            assert near(one.value, true["Q"][one.position] - pitch[one.position], one.scale)


@pytest.mark.parametrize(
    "case",
    first([(name, size, language) for name in EVERY for size, language in (("A4", "ru"), ("A1", "en"))]),
)
def test_letters_are_clear_of_all_lines(case: tuple[str, str, str]) -> None:
    _, leaf, _ = exhibit(*case)
    assert collisions(leaf) == []
    assert list(unlettered(leaf)) == []


@pytest.mark.parametrize("name", some(["groove", "rocker", "flat", "radial"], 2))
def test_sizes_are_drawn_as_long_as_they_are(name: str) -> None:
    view, _, measured = exhibit(name)
    found = {one.name: one.value for one in measured.vectors if one.name != "Q"}
    assert abs(found["R_0"]) == pytest.approx(view.sizes.base, abs=PAPER)
    assert found.get("L", view.sizes.pivot) == pytest.approx(view.sizes.pivot, abs=PAPER)
    assert found.get("e", view.axis) == pytest.approx(view.axis, abs=PAPER)


@pytest.mark.parametrize("name", ["groove", "flat", "flat rocker"])
def test_dwells_are_arcs_about_the_shaft(name: str) -> None:
    view, _, measured = exhibit(name)
    (profile,) = (one for one in measured.profiles if one.name == "profile")
    arcs = [piece for piece in profile.pieces if isinstance(piece, RoundPiece)]
    still = sum(one.angle for one in view.cam.phases if one.kind == DWELL)
    assert sum(one.sweep for one in arcs) == pytest.approx(-view.cam.sense * still, abs=1e-5)
    assert all(abs(one.centre) < PAPER for one in arcs)
    assert {one.name for one in measured.profiles} == {"groove": {"profile", "pitch", "outer"}}.get(name, {"profile"})


def test_a_clockwise_cam_is_the_mirror_of_the_other() -> None:
    marks = [
        {(one.name, one.position): one.value for one in exhibit(name)[2].points if one.name in "PK"}
        for name in ("groove", "clockwise")
    ]
    assert marks[0].keys() == marks[1].keys()
    assert all(abs(value + marks[1][key].conjugate()) < PAPER for key, value in marks[0].items())


def test_positions_are_numbered_against_the_rotation() -> None:
    view, _, measured = exhibit("groove")
    first, later = (one.value for one in measured.points if one.name == "P" and one.position in (0, 4))
    assert (later / first).imag < 0 < view.cam.sense


@pytest.mark.parametrize(
    ("language", "letters"),
    [("en", ["φrise = 120°", "φdwell = 30°", "φrest = 120°"]), ("ru", ["φу = 120°", "φд.в = 30°", "φб.в = 120°"])],
)
def test_phases_senses_and_sizes_are_lettered(language: str, letters: list[str]) -> None:
    told = [text.plain for text in texts(exhibit("groove", "A1", language)[1].groups)]
    point = "." if language == "en" else ","
    for one in (*letters, "ω", "−ω", "O", f"R0 = 32{point}66", f"e = 2{point}22", f"ρmin = 29{point}61"):
        assert told.count(one) == 1, one


def test_lines_are_those_of_their_roles() -> None:
    """Main lines the profile, dash-dot its pitch curve, thin the construction."""
    hand = hand_of("A1")
    _, leaf, _ = exhibit("groove")
    widths = [(one.style.width, bool(one.style.dash)) for one in flat(leaf.groups) if isinstance(one, Curve)]
    assert widths == [(hand.construction, True), (hand.main, False), (hand.main, False)]


def test_an_undercut_is_drawn_through_and_named() -> None:
    """Nothing is trimmed: the whole curve is there, thin and dashed, the contour between its loops in main lines."""
    view, leaf, measured = exhibit("undercut")
    assert {one.kind for one in view.found.flaws} >= {"undercut", "crossing"}
    told = [text.plain for text in texts(leaf.groups)]
    assert told.count("undercut") == told.count("crosses itself") == 2
    curves = [one for one in flat(leaf.groups) if isinstance(one, Curve)]
    contour = [one.pieces for one in curves if one.style.width == hand_of("A1").main]
    ends = sorted((one[0].start for one in contour), key=abs), sorted((one[-1].end for one in contour), key=abs)
    assert len(contour) > 2
    assert all(abs(start - end) < 0.02 for start, end in zip(*ends, strict=True))  # mm: it goes on over each crossing
    (dashed,) = (one for one in curves if one.style.width == hand_of("A1").thin)
    assert dashed.style.dash
    assert sum(map(len, contour)) < len(dashed.pieces) + len(contour)
    (profile,) = (one for one in measured.profiles if one.name == "profile")
    assert profile.gap < PAPER
    assert {one.style.width for one in flat(leaf.groups) if isinstance(one, Curve)} == {
        hand_of("A1").thin,
        hand_of("A1").construction,
        hand_of("A1").main,
    }
    sound = [one for one in flat(exhibit("groove")[1].groups) if isinstance(one, Polyline)]
    assert not [one for one in sound if one.style.width > hand_of("A1").main]


@pytest.mark.rest
def test_points_that_crowd_are_not_all_numbered() -> None:
    crowded, roomy = (
        {one.position for one in exhibit(name, size)[2].points if one.name == "P"}
        for name, size in (("groove", "A4"), ("groove", "A1"))
    )
    assert crowded < roomy == set(range(len(view_of("groove").contour.turned)))


def test_rollers_are_as_large_as_the_roller() -> None:
    view, leaf, measured = exhibit("groove")
    scale = measured.points[0].scale
    sizes = [one.radius * scale for one in flat(leaf.groups) if isinstance(one, Circle)]
    assert sum(math.isclose(size, view.found.roller, abs_tol=1e-9) for size in sizes) >= 4


@pytest.mark.parametrize("name", first(["offset", "clockwise", "flat", "rocker"]))
def test_turned_axes_go_through_their_points(name: str) -> None:
    """The frame is turned against the cam: an axis, an arm or a face of it is at each point."""
    view, leaf, _ = exhibit(name)
    thin = [one for one in flat(leaf.groups) if isinstance(one, Line) and abs(one.end - one.start) > 20]
    starts, ends = np.array([one.start for one in thin]), np.array([one.end for one in thin])
    (zero,) = (one for one in walk(leaf.groups) if isinstance(one, Group) and one.data.get("kind") == "pole")
    assert isinstance(zero.strokes[0], Circle)
    scale, origin = float(zero.data["scale"]), zero.strokes[0].centre
    for spot in view.contour.pitch / scale + origin:
        share = np.clip(((spot - starts) * (ends - starts).conj()).real / abs(ends - starts) ** 2, 0, 1)
        assert abs(starts + share * (ends - starts) - spot).min() < 1e-6
