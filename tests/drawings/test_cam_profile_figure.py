"""The figure of a cam's profile: a mirror, an undercut."""

from __future__ import annotations

from functools import cache

from drawings.cam import profile as profile_figure
from drawings.cam.profile_view import ProfileView
from drawings.measure.measure import Measured
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Curve, Leaf
from drawings.paper.walk import flat, texts
from tests.drawings.cam_contours import view_of
from tests.drawings.exhibits import exhibited, read_back

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
    assert dashed.style.dash
    assert sum(map(len, contour)) < len(dashed.pieces) + len(contour)
    (profile,) = (one for one in measured.profiles if one.name == "profile")
    assert profile.gap < PAPER
