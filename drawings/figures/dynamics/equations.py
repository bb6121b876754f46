"""What the loop gives, worked out beside it: angles, segments, the origin off the paper, flywheel (расчёт по петле)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.figures.graphs.axes import Axes
from drawings.lettering.phrase import Phrase, Slot, joined, telling
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
        telling(NAME, Text(corner - 1j * size * (1 + STEP * k), line, size, "start", True))
        for k, line in _rows(wheel, axes, drafting)
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
    slots = (
        (letter, drafting.slot(Slot(letter, value, DIGITS))) for letter, value in (("ψ_{max}", high), ("ψ_{min}", low))
    )
    return joined(";  ", (joined("", (f"{letter} = ", slot, "°")) for letter, slot in slots))


def _segments(wheel: Flywheel, axes: Axes, drafting: Drafting) -> str:
    """Write the segments of the axis of energy, mm."""
    low, high = (cut / axes.up.mu for cut in wheel.cuts)
    return joined(";  ", (_size(*one, "mm", drafting) for one in (("o_1k", high), ("o_1l", low))))


def _origin(wheel: Flywheel, axes: Axes, drafting: Drafting) -> Iterator[str]:
    """Write where the origin of the whole diagram lies, mm from that of the loop."""
    x, y = -wheel.whole / axes.across.mu, -wheel.energy / axes.up.mu
    slope, cut = "(o_1l − o_1k)/(tg ψ_{max} − tg ψ_{min})", "o_1k + x_O·tg ψ_{max}"
    parts = (_size("x_O", x, "mm", drafting, slope), _size("y_O", y, "mm", drafting, cut))
    yield joined(";  ", parts)
    across, up = (drafting.true(one, axis.letter) for one, axis in (("x_O", axes.across), ("y_O", axes.up)))
    inertia = _size("J_0", wheel.whole, "kg*m2", drafting, f"−{across}")
    yield joined(";  ", (inertia, _size("T_0", wheel.energy, "J", drafting, f"−{up}")))


def _wheel(wheel: Flywheel, drafting: Drafting) -> str:
    """Write the inertia of the flywheel, or that none is needed."""
    whole, there = Slot("J_0", wheel.whole, DIGITS), Slot("J_0^*", wheel.own + wheel.present, DIGITS)
    if wheel.needed <= 0:
        return drafting.phrase("needs no flywheel", there=there, whole=whole)
    numbers = joined(" − ", (drafting.slot(whole), drafting.slot(there)))
    letter = f"{drafting.letter('J_{fly}')} = J_0 − J_0^* = "
    return joined("", (letter, numbers, " = ", _number("J_{fly}", wheel.inertia, "kg*m2", drafting)))


def _size(letter: str, value: float, unit: str, drafting: Drafting, formula: str = "") -> Phrase:
    """Write a quantity by its formula, then by its number and unit."""
    return joined(" = ", filter(None, (letter, formula, _number(letter, value, unit, drafting))))


def _number(letter: str, value: float, unit: str, drafting: Drafting) -> Phrase:
    return joined(" ", (drafting.slot(Slot(letter, value, DIGITS)), drafting.word(unit)))
