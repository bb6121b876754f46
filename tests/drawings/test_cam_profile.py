"""A cam to be made: the figure of its profile, the format that its sheet lies on, what that tells a workshop."""

from __future__ import annotations

from functools import cache

import pytest

from drawings.cam import profile as profile_figure
from drawings.cam import size_view
from drawings.cam.manufacturing import Manufacture, manufacture
from drawings.cam.profile_view import ProfileView
from drawings.cam.sheet import workshop_sheets
from drawings.page.scale import drafting_of
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Curve, Leaf
from drawings.paper.walk import flat, texts
from drawings.reading.measure import Measured
from plans.cam.numbers import results
from plans.scene.scene import Scene, parse_scene
from tests.drawings.cam_contours import view_of
from tests.drawings.exhibits import SHEET, exhibited, read_back


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


@pytest.mark.parametrize(
    ("name", "rows"),
    [
        (
            "groove",
            {"R0, mm": "32.665", "e, mm": "2.2204", "S0, mm": "32.589", "rr, mm": "13.066", "ρmin, mm": "29.610"},
        ),
        ("rocker", {"L, mm": "136.37", "ψ0, °": "14.866", "Ψ, °": "25.000"}),
    ],
)
def test_sizes_are_told_as_the_book_has_them(name: str, rows: dict[str, str]) -> None:
    """Numbers of M2.7, M2.9 and M2.13."""
    found = view_of(name).found
    own = results(found)
    block = size_view.sizes(own, own, True, drafting_of(scene()))
    told = {line.name.replace("_", "").replace("{", "").replace("}", ""): line.cells for line in block.lines}
    assert {name: told[name][0] for name in rows} == rows
    assert told["Ψ, °" if name == "rocker" else "H, mm"][1] == "given"


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
