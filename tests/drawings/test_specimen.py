"""What the pen writes is what was laid out: a specimen with every kind of line and letter."""

from __future__ import annotations

import cmath
import math

import pytest

from drawings.checks.differences import differences, plain
from drawings.paper.strokes import (
    INK,
    Arc,
    Circle,
    Curve,
    Fill,
    Group,
    Leaf,
    Line,
    LineStyle,
    Polyline,
    Stroke,
    Text,
    stated,
)
from drawings.reading.sheet import SeenSheet
from geometry.curve import CubicPiece, RoundPiece
from tests.drawings.held import seen
from tests.drawings.slips import Change, changed, rewritten

MAIN, THIN, DASHED = LineStyle(0.5), LineStyle(0.25), LineStyle(0.25, (4.0, 1.5))
GREY = INK._replace(fill="#333333")
SCALE = {"plan": "velocities", "quantity": "v", "scale": "0.01", "unit": "m/s"}


def vector(name: str, start: complex, end: complex) -> Group:
    head = tuple(end + cmath.rect(size, cmath.phase(end - start) + turn) for size, turn in ((0, 0), (3, 2.9), (3, 3.4)))
    data = {"kind": "vector", "name": name, "value": stated((end - start) * 0.01), **SCALE}
    return Group((Line(start, end, MAIN), Fill(head)), data=data, title=name)


def lettering() -> tuple[Stroke, ...]:
    """Texts of every kind: on levels, slanted, centred, turned, with accents, in both scripts."""
    return (
        Text(60 + 120j, "План скоростей, положение 3", 5.0, anchor="middle", slanted=True),
        Text(70 + 110j, "v_{BA} = 0,375 м/с²;  a^n_{3} = −13.8", 3.5, slanted=True),
        Text(60 + 100j, "№ 38: Ø25 h6 (G\u0304_5)", 2.5, anchor="end"),
        Text(10 + 60j, "Подп. и дата", 2.5, rotation=90.0),
        Text(100 + 60j, "38° — 83°", 3.5, rotation=50.0),
        Text(100 + 20j, "TMM.03.08.00", 5.0, slanted=True, rotation=180.0),
    )


def specimen() -> Leaf:
    """Lay out a sheet with every kind of line and letter."""
    pole = Group((Circle(40 + 40j, 0.6, MAIN),), data={"kind": "pole", "name": "p", "value": "0 0", **SCALE})
    bend = CubicPiece(90 + 70j, 95 + 80j, 105 + 80j, 110 + 72j)
    lines = (
        Polyline((0j, 148j, 210 + 148j, 210 + 0j), closed=True, style=LineStyle(0.25, fill="#ffffff")),
        Line(5 + 5j, 205 + 5j, LineStyle(0.7, cap="round")),
        Polyline((20 + 20j, 30 + 27j, 41 + 22j, 55 + 33j), style=DASHED),
        Arc(150 + 60j, 20.0, 0.3, 5.2, MAIN),
        Arc(150 + 60j, 30.0, 0.2, 1.4, DASHED),
        Circle(180 + 100j, 7.5, LineStyle(0.5, fill="#ffffff")),
        Fill((180 + 100j, 184 + 101j, 184 + 99j)),
        Curve((bend, RoundPiece(bend.end, 110 + 62j, -math.pi * 0.75)), style=MAIN),
        Curve((CubicPiece(120 + 20j, 125 + 35j, 140 + 35j, 150 + 20j),), style=THIN),
    )
    plan = Group((pole, vector("p b", 40 + 40j, 62 + 51j), vector("b c", 62 + 51j, 58 + 66j)), "velocities")
    texts = Group((Line(60 + 98j, 20 + 98j, THIN), Group(lettering()), *lettering()[:1]), "table", title="Table")
    letters = Group((Text(63 + 52j, "b"), Text(59 + 67j, "c"), Text(36 + 36j, "p")), "letters")
    return Leaf(210.0, 148.0, (Group(lines, "frame"), plan, texts, letters), "Specimen", "Every kind of line")


def drawn(leaf: Leaf, mode: str) -> SeenSheet:
    found = seen(leaf, mode).seen
    assert isinstance(found, SeenSheet)
    return found


def otherwise(leaf: Leaf, sheet: SeenSheet) -> list[str]:
    return [str(one) for one in differences(plain(leaf, sheet.leaf.lettering), sheet)]


@pytest.mark.parametrize("mode", ["strokes", "text"])
def test_the_specimen_is_seen_as_it_was_laid_out(mode: str) -> None:
    sheet = drawn(specimen(), mode)
    assert sheet.unseen == ()
    assert sheet.leaf.lettering == mode
    assert otherwise(specimen(), sheet) == []


OTHER: dict[str, Change] = {
    "a line moved": lambda one: one._replace(end=one.end + 0.01) if isinstance(one, Line) else one,
    "a circle grown": lambda one: one._replace(radius=one.radius + 0.01) if isinstance(one, Circle) else one,
    "an arc cut short": lambda one: one._replace(end_angle=one.end_angle - 0.01) if isinstance(one, Arc) else one,
    "dashes lost": lambda one: one._replace(style=THIN) if isinstance(one, Polyline) else one,
    "a thick line thin": lambda one: one._replace(style=THIN) if isinstance(one, Line) else one,
    "ink of another colour": lambda one: one._replace(style=GREY) if isinstance(one, Text) else one,
    "lettering aside": lambda one: one._replace(at=one.at + 0.1j) if isinstance(one, Text) else one,
    "lettering turned": lambda one: one._replace(rotation=one.rotation + 1.0) if isinstance(one, Text) else one,
    "another letter": rewritten("c", "b"),
    "a head lost": lambda one: None if isinstance(one, Fill) else one,
}


@pytest.mark.parametrize("mode", ["strokes", "text"])
def test_what_is_written_otherwise_is_told(mode: str) -> None:
    for name, change in OTHER.items():
        assert otherwise(specimen(), drawn(changed(specimen(), change), mode)) != [], name
