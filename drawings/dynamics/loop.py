"""Wittenbauer's loop with its tangents, and the equations beside it (диаграмма энергомасс)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from drawings.dynamics.graphs import Dense, DrawnStrips
from drawings.kinds.axes import BEYOND, LEFT, OVER, RIGHT, UNDER, Axes, Letter, Part
from drawings.kinds.graph import Graph
from drawings.lettering.lettering import spaced
from drawings.lettering.words import Phrase, Slot, joined, telling
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Group, Kind, Line, Polyline, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Dimension, Subject
from drawings.symbols.symbols import pole
from plans.model.dynamics import TURN, Cycle, Flywheel, Touch

NAME = "loop-equations"
LINES = 6
STEP = 1.8  # sizes of a letter from line to line
DIGITS = 5


def height(drafting: Drafting) -> float:
    """Give the height of the equations, mm."""
    return (LINES + 0.5) * STEP * drafting.hand.text


def write(wheel: Flywheel, axes: Axes, corner: complex, drafting: Drafting) -> Group:
    """Write the equations from their upper left corner on."""
    size, angles = drafting.hand.text, _angles(wheel, axes, drafting)
    rows = angles, _segments(wheel, axes, drafting), *_origin(wheel, axes, drafting), _wheel(wheel, drafting)
    lines = (Text(corner - 1j * size * (1 + STEP * k), line, size, "start", True) for k, line in enumerate(rows))
    return Group(tuple(telling(NAME, line) for line in lines))


def _angles(wheel: Flywheel, axes: Axes, drafting: Drafting) -> str:
    """Write the angles of the tangents on paper."""
    low, high = (math.degrees(math.atan(slope * axes.across.mu / axes.up.mu)) for slope in wheel.slopes)
    angles = ("ψ_{max}", high), ("ψ_{min}", low)
    slots = ((letter, drafting.slot(Slot(letter, value, DIGITS))) for letter, value in angles)
    return joined(";  ", (joined("", (f"{letter} = ", slot, "°")) for letter, slot in slots))


def _segments(wheel: Flywheel, axes: Axes, drafting: Drafting) -> str:
    """Write the segments of the axis of energy, mm."""
    low, high = (cut / axes.up.mu for cut in wheel.cuts)
    return joined(";  ", (_size(*segment, "mm", drafting) for segment in (("o_1k", high), ("o_1l", low))))


def _origin(wheel: Flywheel, axes: Axes, drafting: Drafting) -> Iterator[str]:
    """Write where the origin of the whole diagram lies, mm from that of the loop."""
    x, y = -wheel.whole / axes.across.mu, -wheel.energy / axes.up.mu
    slope, cut = "(o_1l − o_1k)/(tg ψ_{max} − tg ψ_{min})", "o_1k + x_O·tg ψ_{max}"
    yield from (_size("x_O", x, "mm", drafting, slope), _size("y_O", y, "mm", drafting, cut))
    across, up = (drafting.true(segment, axis.letter) for segment, axis in (("x_O", axes.across), ("y_O", axes.up)))
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


LOOP = "loop"
PAPER = Scale(1.0, "l", "mm")  # of points whose axes have different scales: they are measured in mm
DOT = 0.6  # mm, radius of a point of the loop
TAIL = 6.0  # sizes of a letter that a tangent goes beyond the axis of energy, towards the origin
DROP = 1.6  # sizes of a letter that it goes below what it cuts off at most
BREAK = 1.4  # mm, half the zigzag where it is broken off
OFFS = (2.0, 3.6)  # sizes of a letter from the axis to the dimensions of o1l and o1k
ARM = 4.0  # sizes of a letter, radius of the arcs of the angles
CUTS, ANGLES = ("l", "k"), ("ψ_{min}", "ψ_{max}")


@dataclass(frozen=True)
class ShownTangent:
    """A tangent of the loop: that at psi_min, which touches from below, or that at psi_max from above."""

    across: tuple[float, float]  # kg*m2: the least and the greatest inertia of the loop, zero among them
    top: float  # J: the greatest energy
    wheel: Flywheel
    axes: Axes
    hand: Hand
    which: int

    @property
    def cut(self) -> complex:
        """Where it cuts the axis of energy, on paper."""
        return self.axes.on(0.0, self.wheel.cuts[self.which])

    @property
    def slope(self) -> float:
        """Tangent of its angle on paper."""
        return self.wheel.slopes[self.which] * self.axes.across.mu / self.axes.up.mu

    @property
    def along(self) -> complex:
        """Its direction on paper."""
        return complex(1.0, self.slope) / abs(complex(1.0, self.slope))

    @property
    def end(self) -> complex:
        """Its right end: beyond the loop, but its angle not beyond the row that the loop stands in."""
        length = self.across[1] / self.axes.across.mu + BEYOND
        above = (self.top - self.wheel.cuts[self.which]) / self.axes.up.mu + BEYOND - self.arm * self.along.imag
        return self.cut + min(length, above / self.slope) * complex(1.0, self.slope)

    @property
    def arm(self) -> float:
        """How far it is drawn beyond its right end, mm: for the arc of its angle, no farther than the axis goes."""
        return min(ARM * self.hand.letter + BREAK, BEYOND / self.along.imag)

    @property
    def start(self) -> complex:
        """Where the loop begins on it, from the left."""
        return self.cut + self.across[0] / self.axes.across.mu * complex(1.0, self.slope)

    @property
    def right(self) -> bool:
        """Whether its piece on the right of the axis of energy is measured, at whose end the angle is lettered."""
        return abs(self.end - self.cut) >= min(abs(self.start - self.cut), self.arm)

    @property
    def tail(self) -> complex:
        """Its left end, where it is broken off: some way beyond axis and loop, little below."""
        size = self.hand.letter
        return self.start - min(TAIL * size, DROP * size / self.slope) * complex(1.0, self.slope)

    @property
    def lines(self) -> Iterator[Stroke]:
        """The tangent from its break on, measurable from the axis on; angle, dimension."""
        hand, name = self.hand, ANGLES[self.which]
        tip = self.end + self.arm * self.along
        far, near = (tip, self.start) if self.right else (self.start, tip)
        yield _broken_off(self.tail, self.start, self.along, hand)
        data = Subject(LOOP, PAPER.letter, None).data("vector", _plain(name), far - self.cut, PAPER)
        yield Group((Line(self.cut, far, hand.relative),), "", data, name)
        yield Line(self.cut, near, hand.relative)
        yield from self._angle()
        yield from self._segment()
        yield stating(Statement(Kind.POINT, LOOP, CUTS[self.which]), Circle(self.cut, DOT * hand.symbol, INK))

    def _angle(self) -> Iterator[Stroke]:
        """Draw the angle to the axis of inertia at the right end."""
        hand = self.hand
        yield Line(self.end, self.end + self.arm, hand.drafted)
        arc = Arc(self.end, self.arm - BREAK, 0.0, cmath.phase(self.along), hand.other)
        yield stating(Statement(Kind.ANGLE, LOOP, ANGLES[self.which]), arc)

    @property
    def dimension(self) -> Dimension | None:
        """The segment from o1 to the cut, dimensioned beside the axis of energy; None where it is a point."""
        off = self.across[0] / self.axes.across.mu - OFFS[self.which] * self.hand.letter + 0j
        short = abs(self.cut - self.axes.zero) < 1.0
        return None if short else Dimension(f"o_{{1}}{CUTS[self.which]}", self.axes.zero, self.cut, off)

    def _segment(self) -> Iterator[Stroke]:
        size = self.dimension
        if size is None:
            return
        line, *rest = size.draw(self.hand)
        cut = self.wheel.cuts[self.which]
        data = Subject(LOOP, self.axes.up.letter, None).data("vector", _plain(size.letter), 1j * cut, self.axes.up)
        yield Group((line,), "", data, size.letter)
        yield from rest

    @property
    def letters(self) -> Iterator[Letter]:
        """The angle, the cut and the segment, lettered."""
        size, side = self.hand.letter, OVER if self.which else UNDER
        middle = self.end + (self.arm - BREAK) * cmath.rect(1.0, cmath.phase(self.along) / 2)
        yield Letter(middle if self.right else self.cut, ANGLES[self.which], size, RIGHT if self.right else side)
        yield Letter(self.cut, CUTS[self.which], size, math.pi / 4 if self.which else -math.pi / 4)
        if self.dimension is not None:
            yield Letter(self.dimension.middle, self.dimension.letter, size, LEFT)


def _broken_off(tail: complex, start: complex, along: complex, hand: Hand) -> Stroke:
    """Draw a line to a place where it is broken off: a zigzag across it, and a little more of it."""
    step, off = BREAK * along, BREAK * 1.4j * along
    return Polyline(
        (start, tail, tail - step / 2 + off, tail - 1.5 * step - off, tail - 2 * step, tail - 5 * step),
        False,
        hand.relative,
    )


def _plain(name: str) -> str:
    return name.replace("_", "").replace("{", "").replace("}", "")


APART = 1.6  # sizes of a number from one numbered point to the next
SAME = 1e-9  # rad: angles that differ by less are one edge
TURNED = ("Δφ slowest", "Δφ fastest")  # what the angle at a point of touch is called, as in the notes
TOUCH = 1.1  # mm, radius of a point that a tangent touches


@dataclass(frozen=True)
class ShownLoop:
    """What the loop shows: the account of the turn, its dense curve, its strips, the flywheel if one is asked for."""

    cycle: Cycle
    dense: Dense
    strips: DrawnStrips
    flywheel: Flywheel | None

    @property
    def curve(self) -> tuple[np.ndarray, np.ndarray]:
        """The loop densely: inertia above that of position 0, kg*m2, and surplus energy, J."""
        energy = self.cycle.driving * self.dense.turned + self.dense.work
        return self.dense.varying, energy

    @property
    def across(self) -> tuple[float, float]:
        """The least and the greatest inertia, zero among them, kg*m2."""
        inertia, _ = self.curve
        return min(float(inertia.min()), 0.0), max(float(inertia.max()), 0.0)

    @property
    def up(self) -> tuple[float, float]:
        """The least and the greatest energy, zero and what the tangents cut off among them, J."""
        _, energy = self.curve
        cuts = self.flywheel.cuts if self.flywheel else ()
        return min(float(energy.min()), 0.0, *cuts), max(float(energy.max()), 0.0, *cuts)

    @property
    def rests(self) -> tuple[tuple[str, Touch], ...]:
        """The points between two edges that tangents touch, by the names of their angles."""
        touches = self.flywheel.touches if self.flywheel else ()
        rows = zip(ANGLES, touches, self.touched, strict=False)
        return tuple((angle, touch) for angle, touch, edges in rows if not edges)

    @property
    def touches(self) -> tuple[int, ...]:
        """The edges that the tangents touch, where they touch one."""
        return tuple(k for edges in self.touched for k in edges)

    @property
    def touched(self) -> tuple[Sequence[int], ...]:
        """The edge that each tangent touches, where it touches one."""
        return tuple(self._touched())

    def _touched(self) -> Iterator[Sequence[int]]:
        for touch in self.flywheel.touches if self.flywheel else ():
            # The last edge is the first again: rounding alone decides which of the two is touched.
            at = touch.turned if touch.turned < TURN - SAME else 0.0
            yield np.flatnonzero(np.isclose(self.strips.turned, at, rtol=0, atol=SAME)).tolist()[:1]


def loop_part(loop: ShownLoop, axes: Axes, drafting: Drafting) -> Part:
    """Draw the loop on its axes; both tangents are broken off on their way to the origin of the whole diagram."""
    hand = drafting.hand
    numbered = _numbered(loop, axes, hand)
    lines = [*axes.lines(loop.across, loop.up, hand, LOOP), *_curve(loop, axes, hand)]
    lines += [*_points(loop, numbered, axes, hand), *_rests(loop, axes, hand)]
    ends = (loop.across[1], f"ΔJ, {drafting.word('kg*m2')}"), (loop.up[1], f"ΔT, {drafting.word('J')}")
    energy, inertia = Graph(LOOP, axes, hand).ends(*ends)
    letters = [inertia, energy, Letter(axes.zero, "o_{1}", hand.letter, -3 * math.pi / 4)]
    letters += [*_turned(loop, axes, drafting), *_numbers(loop, numbered, axes, hand)]
    if loop.flywheel is not None:
        for k in (0, 1):
            tangent = ShownTangent(loop.across, loop.up[1], loop.flywheel, axes, hand, k)
            lines += tangent.lines
            letters += tangent.letters
    return Part(LOOP, tuple(lines), tuple(letters))


def _curve(loop: ShownLoop, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    places = tuple(axes.on(float(x), float(y)) for x, y in zip(*loop.curve, strict=True))
    yield stating(Statement(Kind.CURVE, LOOP, "ΔT(ΔJ)"), Polyline(places, True, hand.result))


def _places(loop: ShownLoop, axes: Axes) -> list[complex]:
    """Give the places of all edges on paper, the last one without, which is the first again."""
    pairs = zip(loop.cycle.varying[:-1].tolist(), loop.cycle.surplus[:-1].tolist(), strict=True)
    return [axes.on(*pair) for pair in pairs]


def _numbered(loop: ShownLoop, axes: Axes, hand: Hand) -> tuple[int, ...]:
    """Choose the points whose numbers have room: those that tangents touch first, between edges too, then jumps."""
    places = _places(loop, axes)
    spots = [*places, *(axes.on(touch.varying, touch.surplus) for _, touch in loop.rests)]
    order = (*range(len(places), len(spots)), *loop.touches, *loop.strips.jumps, *loop.strips.candidates[:-1])
    return tuple(sorted(k for k in spaced(spots, APART * hand.number, order) if k < len(places)))


def _points(loop: ShownLoop, numbered: Sequence[int], axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw the points of the edges about the loop's own origin; the numbered ones can be measured, in mm."""
    subject = Subject(LOOP, PAPER.letter, None)
    yield Group((pole(axes.zero),), "", subject.data("pole", "o1", 0j, PAPER), "o_{1}")
    places = _places(loop, axes)
    for k in (k for k in loop.strips.marked(numbered) if k < len(places)):
        name, place = loop.strips.names[k], places[k]
        dot = Circle(place, (TOUCH if k in loop.touches else DOT) * hand.symbol, INK)
        value = complex(loop.cycle.varying[k] / axes.across.mu, loop.cycle.surplus[k] / axes.up.mu)
        data = subject._replace(position=k).data("point", name, value, PAPER)
        yield _touching(loop, k, Group((dot,), "", data, name) if k in numbered else dot)


def _touching(loop: ShownLoop, k: int, mark: Stroke) -> Stroke:
    """Give the mark of a point as what it states: by its name, that a tangent touches there."""
    for touched, angle in zip(loop.touched, ANGLES, strict=False):
        mark = stating(Statement(Kind.POINT, LOOP, angle), mark) if k in touched else mark
    return mark


def _rests(loop: ShownLoop, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Mark the points between two edges that tangents touch."""
    for angle, touch in loop.rests:
        mark = Circle(axes.on(touch.varying, touch.surplus), TOUCH * hand.symbol, INK)
        yield stating(Statement(Kind.POINT, LOOP, angle), mark)


def _turned(loop: ShownLoop, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    """Letter them with the angle turned since position 0."""
    for angle, touch in loop.rests:
        slot = drafting.slot(Slot(TURNED[ANGLES.index(angle)], math.degrees(touch.turned)))
        place, side = axes.on(touch.varying, touch.surplus), UNDER if angle == ANGLES[0] else OVER
        yield Letter(place, joined("", (slot, "°")), drafting.hand.number, side, 1.4)


def _numbers(loop: ShownLoop, numbered: Sequence[int], axes: Axes, hand: Hand) -> Iterator[Letter]:
    """Number the points outward from the middle of the loop."""
    places = _places(loop, axes)
    heart = sum(places) / len(places)
    for k in numbered:
        away = places[k] - heart
        yield Letter(places[k], loop.strips.names[k], hand.number, cmath.phase(away) if away else OVER, 1.4)
