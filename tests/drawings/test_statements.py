"""What ink states is read off it, and off nothing else; what is read is held to what is expected."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

from drawings.checks import hold
from drawings.checks.expected import NOTES, Expected, by_hand, cells
from drawings.checks.readers import frames, read
from drawings.lettering.lettering import lettered
from drawings.lettering.words import joined, phrase, slotted
from drawings.paper.strokes import (
    Arc,
    Circle,
    Curve,
    Fill,
    Group,
    Key,
    Kind,
    Leaf,
    Line,
    Polyline,
    Statement,
    Stroke,
    Text,
)
from drawings.paper.walk import stating
from drawings.pens.svg import svg
from drawings.reading.measure import measure
from geometry.curve import CubicPiece

MU = 0.02  # true units a mm
SLANTED = cmath.rect(1.0, 0.3)  # a turned axis


def leaf(*strokes: Stroke) -> Leaf:
    return Leaf(100.0, 100.0, (Group(strokes, "figure"),))


def stated(kind: Kind, *strokes: Stroke, name: str = "x", scale: float = MU) -> Group:
    return stating(Statement(kind, "figure", name, scale=scale), *strokes)


def value(kind: Kind, *strokes: Stroke, others: Sequence[Stroke] = (), scale: float = MU) -> Any:
    """Read what strokes state on a leaf with others."""
    own = stated(kind, *strokes, scale=scale)
    return read(own, frames(leaf(*others, own)).get(("figure", None))).value


def head(tip: complex, way: complex, size: float = 3.0) -> Fill:
    back, out = tip - size * way, 0.2 * size * way * 1j
    return Fill((back + out, tip, back - out))


def about(zero: complex, across: float = 0.1, up: float = 5.0) -> tuple[Group, Group]:
    """Lay the two turned axes of a graph that cross in its zero."""
    level = stated(Kind.AXIS, Line(zero - 3 * SLANTED, zero + 60 * SLANTED), name="x", scale=across)
    upright = Line(zero - 4j * SLANTED, zero + 30j * SLANTED)
    return level, stated(Kind.AXIS, upright, head(upright.end, 1j * SLANTED), name="y", scale=up)


def on(x: float, y: float, zero: complex = 20 + 20j) -> complex:
    """Give where a value of the graph lies on paper."""
    return zero + SLANTED * complex(x / 0.1, y / 5.0)


# Readers


def test_a_vector_is_its_line_and_no_arrowhead_of_it() -> None:
    line = Line(10 + 10j, 40 + 50j)
    assert value(Kind.VECTOR, line, head(40 + 50j, 0.6 + 0.8j)) == pytest.approx(MU * (30 + 40j))


def test_a_point_lies_about_the_pole_of_its_figure() -> None:
    data = {"kind": "pole", "plan": "figure", "scale": str(MU), "value": "0.1 -0.2"}
    pole = Group((Circle(30 + 30j, 0.5),), data=data)
    assert value(Kind.POINT, Circle(35 + 40j, 1.0), others=[pole]) == pytest.approx(0.2 + 0j)
    assert value(Kind.POINT, Line(35 + 40j, 35 + 45j), others=[pole]) == pytest.approx(0.2 + 0j)


@pytest.mark.parametrize("bent", [False, True])
def test_a_curve_is_read_about_turned_axes(bent: bool) -> None:
    spots = [on(0, 0), on(1, 50), on(2, 20)]
    pieces = (
        CubicPiece(spots[0], *np.linspace(spots[0], spots[1], 4)[1:]),
        CubicPiece(spots[1], spots[1], spots[2], spots[2]),
    )
    curve = Curve(pieces) if bent else Polyline(tuple(spots))
    found = value(Kind.CURVE, curve, others=about(20 + 20j))
    assert found[0] == pytest.approx(0) and found[-1] == pytest.approx(2 + 20j)
    assert any(abs(one - (1 + 50j)) < 1e-9 for one in found)


def test_a_dimension_is_as_long_as_from_tip_to_tip_also_with_its_arrows_outside() -> None:
    inside = Line(10 + 0j, 50 + 0j), head(10 + 0j, -1 + 0j), head(50 + 0j, 1 + 0j)
    outside = Line(0j, 60 + 0j), head(10 + 0j, 1 + 0j), head(50 + 0j, -1 + 0j)
    assert [value(Kind.LENGTH, *one) for one in (inside, outside)] == pytest.approx([40 * MU, 40 * MU])
    assert value(Kind.LENGTH, Line(10 + 0j, 40 + 40j)) == pytest.approx(50 * MU)


def test_an_angle_is_the_sweep_of_its_arc() -> None:
    assert value(Kind.ANGLE, Arc(0j, 9.0, 6.0, 0.5), Text(9 + 1j, "31°")) == pytest.approx(0.5 - 6.0 + math.tau)


def test_a_straight_arrow_has_a_way_and_a_bent_one_a_sense() -> None:
    assert value(Kind.DIRECTION, Line(0j, 3 + 4j), head(3 + 4j, 0.6 + 0.8j)) == pytest.approx(0.6 + 0.8j)
    arc, tips = Arc(5 + 5j, 10.0, 0.0, 2.0), (15 + 5j, 5 + 5j + cmath.rect(10.0, 2.0))
    assert value(Kind.DIRECTION, arc, head(tips[1], 1j * cmath.rect(1.0, 2.0))) == 1
    assert value(Kind.DIRECTION, arc, head(tips[0], -1j)) == -1
    assert value(Kind.DIRECTION, arc, Polyline(head(tips[0], -1j).points)) == -1  # an open head


def test_a_text_is_read_without_its_levels() -> None:
    assert value(Kind.LETTER, Text(0j, "a^n_{BA}")) == "anBA"


# Phrases

SAID = joined(";  ", [slotted("K = ", "K", "1,4545"), slotted("H = ", "H", "−480", " mm")])


def told(*lines: str) -> dict[tuple[Kind, str], list[Any]]:
    """Read what lines of one phrase say, by quantity."""
    strokes = (Text(complex(10, 90 - 5 * k), line) for k, line in enumerate(lines))
    own = stating(Statement(Kind.PHRASE, NOTES, SAID.template), *strokes)
    found = hold.readings(measure(svg(lettered(Leaf(100.0, 100.0, (Group((), "frame"),))))), leaf(own))
    return {(key[0], key[2]): [one.value for one in values] for key, values in found.items()}


@pytest.mark.parametrize("lines", [(str(SAID),), ("K = 1,4545;", "H = −480 mm"), ("K =", "1,4545;  H = −480", "mm")])
def test_a_phrase_is_read_back_over_the_breaks_of_its_lines(lines: tuple[str, ...]) -> None:
    assert told(*lines) == {(Kind.PHRASE, "K"): ["1,4545"], (Kind.PHRASE, "H"): ["−480"]}


def test_a_phrase_that_says_something_else_states_none_of_its_quantities() -> None:
    assert {key for key in told("K is 1,4545") if key[1] in "KH"} == set()
    assert phrase("en", "sheet", number=1).template == str(phrase("en", "sheet", number=1))


# What is read, held to what is expected


def faults(*groups: Stroke, due: Sequence[Expected] = ()) -> list[str]:
    """Hold what a leaf states against a table; what is in it must stand."""
    blank = measure(svg(lettered(Leaf(100.0, 100.0, (Group((), "frame"),)))))
    rows: dict[Key, Expected] = {row.key: row for row in due}
    return [str(one) for one in hold.faults(hold.readings(blank, leaf(*groups)), rows, rows)]


def hand(error: float, most: float) -> Expected:
    """Give what must be read of a cell of what a hand may be out."""
    return next(cells("figure", "x", [by_hand(error, most)]))._replace(name="x")


def due(kind: Kind, true: Any, allowed: float = 0.0, **more: Any) -> Expected:
    return Expected(kind, "figure", "x", true, allowed, **more)


LINE = stated(Kind.VECTOR, Line(0j, 30 + 40j))
CURVED = stated(Kind.CURVE, Polyline(tuple(on(x, 10 * x) for x in (0.0, 1.0, 2.0))))
JUMPED = stated(Kind.CURVE, Polyline((on(0, 10), on(1, 10), on(1, 30), on(2, 30))))
PATH = np.exp(np.linspace(0, 2j * np.pi, 181))
RING = stated(Kind.CURVE, Polyline(tuple(10 * PATH[:-1]), closed=True))


def number(text: str) -> Group:
    return stated(Kind.NUMBER, Text(0j, text), scale=0.0)


def line(y: float) -> Callable[[Any], Any]:
    return lambda x: y * x


@pytest.mark.parametrize(
    ("ink", "row", "says"),
    [
        (LINE, due(Kind.VECTOR, 0.6 + 0.8j), ""),
        (LINE, due(Kind.VECTOR, 0.6 - 0.8j), "(against the analysis)"),
        (LINE, due(Kind.VECTOR, 0.61 + 0.8j), "(against the analysis)"),
        (LINE, due(Kind.VECTOR, 0.61 + 0.8j, 0.011), ""),
        (LINE, due(Kind.VECTOR, -9.0, math.inf), ""),
        (LINE, None, "(the analysis has none)"),
        (None, due(Kind.VECTOR, 1.0), "is missing"),
        (None, due(Kind.VECTOR, 1.0, may_lack=True), ""),
        (CURVED, due(Kind.CURVE, line(10), ends=(0.0, 2.0)), ""),
        (CURVED, due(Kind.CURVE, line(10.1), ends=(0.0, 2.0)), "(against the analysis)"),
        (CURVED, due(Kind.CURVE, line(10), ends=(0.0, 2.1)), "(against the analysis)"),
        (JUMPED, due(Kind.CURVE, lambda x: np.where(x < 1, 10.0, 30.0), ends=(0.0, 2.0)), ""),
        (JUMPED, due(Kind.CURVE, lambda x: np.where(x < 1.1, 10.0, 30.0), ends=(0.0, 2.0)), "(against the analysis)"),
        (RING, due(Kind.CURVE, 10 * MU * PATH), ""),
        (RING, due(Kind.CURVE, 10.2 * MU * PATH), "(against the analysis)"),
        (RING, due(Kind.CURVE, 10 * MU * PATH[:-20]), "(against the analysis)"),
        (number("12,35"), due(Kind.NUMBER, 12.349), ""),
        (number("12.36"), due(Kind.NUMBER, 12.349), "(against the analysis)"),
        (number("−12,35"), due(Kind.NUMBER, 12.349), "(against the analysis)"),
        (number("120"), due(Kind.NUMBER, 119.96, digits=4), ""),
        (number("350"), due(Kind.NUMBER, -10.0, period=360.0), ""),
        (number("350"), due(Kind.NUMBER, -10.0), "(against the analysis)"),
        (number("—"), due(Kind.NUMBER, math.nan), ""),
        (number("±0,0021"), hand(0.00213, 1.0), ""),
        (number("±0,021"), hand(0.00213, 1.0), "(against the analysis)"),
        (number("—"), hand(3.0, 1.0), ""),
        (stated(Kind.LETTER, Text(0j, "v_{BA}")), due(Kind.LETTER, "vBA"), ""),
        (stated(Kind.LETTER, Text(0j, "v_{AB}")), due(Kind.LETTER, "vBA"), "(against the analysis)"),
    ],
)  # fmt: skip
def test_what_is_read_is_held(ink: Group | None, row: Expected | None, says: str) -> None:
    graph = about(20 + 20j) if ink in (CURVED, JUMPED) else ()
    found = faults(*graph, *([ink] if ink else []), due=[row] if row else [])
    assert len(found) == bool(says)
    assert all(says in one for one in found)


def test_a_figure_at_another_scale_or_turned_is_told() -> None:
    level, upright = about(20 + 20j)
    row = due(Kind.CURVE, line(10), ends=(0.0, 2.0))
    assert faults(level, upright, CURVED, due=[row]) == []
    coarser = upright._replace(states=upright.states._replace(scale=6.0)) if upright.states else upright
    turned = stated(Kind.AXIS, Line(20 + 20j, 80 + 20j), name="x", scale=0.1)
    for axes in ((level, coarser), (turned, upright)):
        assert len(faults(*axes, CURVED, due=[row])) == 1
