"""What the loop gives, worked out beside it: angles, segments, the origin off the paper, flywheel (расчёт по петле)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.figures.graphs.axes import Axes
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Text
from plans.model.dynamics import Flywheel

NAME = "loop-equations"
LINES = 5
STEP = 1.8  # sizes of a letter from line to line
DIGITS = 5


def height(drafting: Drafting) -> float:
    """Give the height of the equations, mm."""
    return (LINES + 0.5) * STEP * drafting.hand.text


def write(wheel: Flywheel, axes: Axes, corner: complex, drafting: Drafting) -> Group:
    """Write the equations from their upper left corner on."""
    size = drafting.hand.text
    lines = (
        Text(corner - 1j * size * (1 + STEP * k), line, size, "start", True) for k, line in _rows(wheel, axes, drafting)
    )
    return Group(tuple(lines))


def _rows(wheel: Flywheel, axes: Axes, drafting: Drafting) -> Iterator[tuple[int, str]]:
    yield from enumerate(
        (
            _angles(wheel, axes, drafting),
            _segments(wheel, axes, drafting),
            *_origin(wheel, axes, drafting),
            _wheel(wheel, drafting),
        )
    )


def _angles(wheel: Flywheel, axes: Axes, drafting: Drafting) -> str:
    """Write the angles of the tangents on paper."""
    low, high = (math.degrees(math.atan(slope * axes.across.mu / axes.up.mu)) for slope in wheel.slopes)
    number = drafting.number
    return f"ψ_{{max}} = {number(high, DIGITS)}°;  ψ_{{min}} = {number(low, DIGITS)}°"


def _segments(wheel: Flywheel, axes: Axes, drafting: Drafting) -> str:
    """Write the segments of the axis of energy, mm."""
    low, high = (drafting.number(cut / axes.up.mu, DIGITS) for cut in wheel.cuts)
    mm = drafting.word("mm")
    return f"o_1k = {high} {mm};  o_1l = {low} {mm}"


def _origin(wheel: Flywheel, axes: Axes, drafting: Drafting) -> Iterator[str]:
    """Write where the origin of the whole diagram lies, mm from that of the loop."""
    number, mm = drafting.number, drafting.word("mm")
    x, y = (number(-value, DIGITS) for value in (wheel.whole / axes.across.mu, wheel.energy / axes.up.mu))
    yield f"x_O = (o_1l − o_1k)/(tg ψ_{{max}} − tg ψ_{{min}}) = {x} {mm};  y_O = o_1k + x_O·tg ψ_{{max}} = {y} {mm}"
    inertia, energy = number(wheel.whole, DIGITS), number(wheel.energy, DIGITS)
    across, up = (drafting.true(one, axis.letter) for one, axis in (("x_O", axes.across), ("y_O", axes.up)))
    yield f"J_0 = −{across} = {inertia} {drafting.word('kg*m2')};  T_0 = −{up} = {energy} {drafting.word('J')}"


def _wheel(wheel: Flywheel, drafting: Drafting) -> str:
    """Write the inertia of the flywheel, or that none is needed."""
    number, unit = drafting.number, drafting.word("kg*m2")
    whole, there = number(wheel.whole, DIGITS), number(wheel.own + wheel.present, DIGITS)
    if wheel.needed <= 0:
        return drafting.word("needs no flywheel", there=there, whole=whole)
    letter = drafting.letter("J_{fly}")
    return f"{letter} = J_0 − J_0^* = {whole} − {there} = {number(wheel.inertia, DIGITS)} {unit}"
