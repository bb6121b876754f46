"""Curves of arcs and cubics on paper: written, boxed, inked, dashed, and read back as an editor may write them."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import numpy as np
import pytest

from drawings.bench import plain_pen
from drawings.lettering.lettering import GRAIN, bounds
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Circle, Curve, Group, Leaf, LineStyle
from drawings.pens.svg import svg
from drawings.reading.pathdata import curve, pieces
from drawings.symbols.symbols import fit_dashes
from geometry.curve import CubicPiece, RoundPiece, straight
from tests.drawings.conftest import Run
from tests.rows import over

CUBIC = CubicPiece(10 + 20j, 10 + 60j, 60 + 60j, 60 + 20j)
PIECES = (CUBIC, RoundPiece(60 + 20j, 35 + 20j, -math.pi))  # clockwise below
STROKE = Curve(PIECES, True)


def test_box_goes_round_a_curve() -> None:
    assert bounds(STROKE) == pytest.approx((10, -5, 60, 50), abs=GRAIN)


def test_dashes_fit_the_length_of_a_curve() -> None:
    arc = Curve((RoundPiece(10 + 0j, 0j, math.pi),), style=LineStyle(dash=(4.0, 1.5)))
    (fitted,) = fit_dashes([arc])
    dash, gap = fitted.style.dash  # type: ignore[union-attr]
    count = (10 * math.pi + gap) / (dash + gap)
    assert count == pytest.approx(round(count), abs=0.01)
    assert list(fit_dashes([STROKE])) == [STROKE]


def test_plain_pen_draws_a_curve() -> None:
    assert b" A 25.0 25.0" in plain_pen.svg(Leaf(100, 100, (Group((STROKE,), "figure"),))).replace(b",", b" ")


@over(
    "data",
    [
        "M0 0c10 0 10 0 20 10s10 10 20 10",
        "M0,0 C10,0 10,0 20,10 S 30 20 40 20",
        "m0 0C10 0 10 0 20 10 30 20 30 20 40 20",
    ],
)
def test_cubics_are_read_as_editors_write_them(data: str) -> None:
    first, second = pieces(curve(data))
    assert (first.at(0.5), second.at(0.5)) == (10 + 1.25j, 30 + 18.75j)


def test_lines_and_parabolas_are_cubics_too() -> None:
    *lines, last = pieces(curve("M0 0h3V4L1 1Q2 3 3 1"))
    assert lines == [straight(0j, 3 + 0j), straight(3 + 0j, 3 + 4j), straight(3 + 4j, 1 + 1j)]
    assert last.at(0.5) == pytest.approx(2 + 2j)


@over(
    "data, told",
    [
        ("M0 0L1 1M2 2L3 3", "in several pieces"),
        ("M0 0", "has no length"),
        ("", "has no length"),
        ("M0 0Q1 1 2 0T4 0", "a T"),
        ("M0 0A2 1 0 0 0 3 0", "an arc of an ellipse"),
        ("M0 0A0 0 0 0 0 3 0", "an arc of an ellipse"),
        ("M0 0A1e300 1e300 0 0 0 3 0", "an arc of an ellipse"),
        ("M-1e308 -1e308A1 1 0 0 0 1e308 1e308", "off every paper"),
        ("M3 0A1 1 0 0 0 3 0", "ends where it begins"),
        ("M0 0C1 1 nan 2 3 3", "is not a number"),
        ("M0 0C1 1 2 2", "is not a number"),
    ],
)
def test_what_is_no_curve_is_refused(data: str, told: str) -> None:
    with pytest.raises(SheetRefused, match=told):
        curve(data)


PROFILE = {"kind": "profile", "plan": "p", "quantity": "l", "name": "Q", "unit": "m", "scale": "0.001"}


def sheet(**data: str) -> bytes:
    own = PROFILE | {"value": "-0.025 0", "deviation": "0.0000001"} | data
    pole = {"kind": "pole", "plan": "p", "quantity": "l", "name": "O", "value": "0 0", "unit": "m", "scale": "0.001"}
    groups = (Group((Circle(35 + 20j, 1.0),), data=pole), Group((STROKE,), data=own))
    return svg(Leaf(100, 100, (Group(groups, "figure"),)))


def test_measure_lists_profiles(run: Run, tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_bytes(sheet())
    code, out, _ = run("measure", tmp_path / "a.svg")
    assert code == 0
    assert re.search(r"^p +Q +3 pieces, stated within 1e-07 m, rounded to 1e-09 m$", out, re.MULTILINE)
    code, out, _ = run("measure", tmp_path / "a.svg", "--json")
    (found,) = json.loads(out)["profiles"]
    assert found["pieces"][0]["cubic"] == [
        pytest.approx(spot) for spot in np.reshape([-25, 0, -25, 40, 25, 40, 25, 0], (4, 2)) / 1e3
    ]
    assert [found["pieces"][k]["sweep"] for k in (1, 2)] == pytest.approx([-90, -90])


def test_profile_that_is_not_where_it_says_is_told(run: Run, tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_bytes(sheet(value="-0.0251 0"))
    code, out, _ = run("measure", tmp_path / "a.svg")
    assert code == 5
    assert re.search(r"^p +Q +.*DIFFERS from the stated$", out, re.MULTILINE)


@over(
    "data, told",
    [
        ({"deviation": "-1"}, "its deviation -1.0 is below zero"),
        ({"deviation": "much"}, "its deviation: 'much' is not a number"),
        ({"turned": "left"}, "its turned: 'left' is not a number"),
        ({"plan": "q"}, "has no pole"),
    ],
)
def test_profile_that_cannot_be_placed_is_refused(data: dict[str, str], told: str, run: Run, tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_bytes(sheet(**data))
    code, _, err = run("measure", tmp_path / "a.svg")
    assert code == 7
    assert told in err
