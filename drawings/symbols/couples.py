"""Forces and couples, and symbols of gears and couplings (силы, пары сил, передачи)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise
from typing import NamedTuple, TypeAlias

from drawings.layout.labels import Labels, Lines
from drawings.layout.parallel_offsets import Segment
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Group, Line, Polyline, Stroke, stated
from drawings.symbols.figure import Arm, plain_name
from drawings.symbols.symbols import ARROW_HALF, ARROW_LENGTH, TurnArrow, arrowhead, fit, fit_dashes

BESIDE = 1.4  # mm from the free end of a force to its letter
ALONG = (0.4, 0.6)  # of a force, from its free end: where its letter may stand beside its shaft
ASIDE = math.radians(55)  # the letter stands ahead of the free end, to the left of the line of action


class ForceArrow(NamedTuple):
    """A force on paper: its letter, its point, its unit direction and its length in mm.

    It starts from its point or, `ending`, comes to it; one that stands off it is led to it by a thin line. Of an
    `unknown` one only the line of action is known.
    """

    letter: str  # marked up: "R^t_{34}"
    at: complex
    direction: complex
    length: float
    ending: bool = False
    unknown: bool = False
    lead: complex | None = None  # where the thin line begins

    @property
    def start(self) -> complex:
        """Where it begins."""
        return self.at - self.direction * self.length if self.ending else self.at

    @property
    def tip(self) -> complex:
        """Where its arrowhead ends."""
        return self.start + self.direction * self.length

    @property
    def shaft(self) -> Line:
        """Its own line."""
        return Line(self.start, self.tip)

    @property
    def free(self) -> complex:
        """The end that is not at its point: there stands its letter."""
        return self.start if self.ending else self.tip

    @property
    def beside(self) -> bool:
        """Whether it stands beside its line of action: the thin line leads across it."""
        run = 0j if self.lead is None else (self.at - self.lead) / self.direction
        return abs(run.imag) > abs(run.real)

    def draw(self, hand: Hand) -> Group:
        """Draw it: known in full lines with a filled head, unknown dashed with an open one."""
        if self.unknown:
            style = fit(hand.path, abs(self.tip - self.start))
            return Group((Line(self.start, self.tip, style), *_open_head(self, hand)), "", self._marked, self.letter)
        head = arrowhead(self.start, self.tip, hand.symbol)
        shaft = Line(self.start, self.tip, hand.result)
        return Group((shaft,) if head is None else (shaft, head), "", self._marked, self.letter)

    @property
    def _marked(self) -> dict[str, str]:
        return {"kind": "force", "name": plain_name(self.letter), "direction": stated(self.direction)}

    def letter_beside(self, labels: Labels, hand: Hand, others: Lines = ()) -> Stroke:
        """Letter it at its free end, or else beside its shaft, no nearer to `others`."""
        ahead = cmath.phase(self.direction) + (math.pi if self.ending else 0.0)
        further = [self.free + share * (self.at - self.free) for share in ALONG]
        return labels.beside(self.free, self.letter, hand.letter, BESIDE, ahead + ASIDE, others, further)


def not_to_scale(
    letter: str, direction: complex, at: complex, length: float, ending: bool = False, unknown: bool = False
) -> ForceArrow:
    """Give a force that only shows where and which way it acts, of some length on paper, mm."""
    return ForceArrow(letter, at, direction / abs(direction), length, ending, unknown)


def _open_head(force: ForceArrow, hand: Hand) -> tuple[Stroke, ...]:
    """Draw an open arrowhead: two thin lines of the size of a filled one."""
    along = force.direction * hand.symbol
    base, wing = force.tip - along * ARROW_LENGTH, 1j * along * ARROW_HALF
    return (Polyline((base + wing, force.tip, base - wing), False, hand.other),)


HALF, THREE_QUARTERS = math.pi, 1.5 * math.pi  # rad: the arcs of a couple
RADIUS = 8.0  # mm, to the factor of the hand's symbols
SIDE = 0.3 * math.tau  # rad that arcs about one place face apart at the least: three can, in steps of thirty degrees
OFF_ARC = 1.2  # mm from the arc to its letter
CHORDS = (0.0, 0.25, 0.5, 0.75, 1.0)  # shares of an arc between which it is felt as straight


class CoupleArc(NamedTuple):
    """A couple about a place on paper: +1 counter-clockwise, -1 clockwise; the arc's middle faces a direction, rad."""

    letter: str
    at: complex
    sense: int
    radius: float = RADIUS
    facing: float = math.pi / 2
    sweep: float = THREE_QUARTERS

    @property
    def place(self) -> complex:
        """The middle of the arc: beside it stands the letter."""
        return self.at + cmath.rect(self.radius, self.facing)

    @property
    def chords(self) -> list[Segment]:
        """The arc as it is felt, in straight pieces."""
        turns = (self.facing + self.sweep * (share - 0.5) for share in CHORDS)
        return [*pairwise(self.at + cmath.rect(self.radius, turn) for turn in turns)]

    def crowded(self, others: Iterable[CoupleArc]) -> int:
        """Count the arcs about the same place that face nearly the same way: whose a letter is could not be told.

        >>> [CoupleArc("M_2", 0j, 1).crowded([CoupleArc("M_3", 0j, 1, facing=turn)]) for turn in (0.6, 4.7)]
        [1, 0]
        """
        return sum(math.cos(other.facing - self.facing) > math.cos(SIDE) for other in others)

    def draw(self, hand: Hand) -> Group:
        """Draw the arc and its head."""
        start = self.facing - self.sense * self.sweep / 2
        arrow = TurnArrow(self.at, self.radius, start, self.sense * self.sweep).draw(hand, hand.relative)
        data = {"kind": "couple", "name": plain_name(self.letter), "sense": f"{self.sense:+d}"}
        return Group(arrow, "", data, self.letter)

    def letter_beside(self, labels: Labels, hand: Hand, others: Lines = ()) -> Stroke:
        """Letter it beyond the middle of its arc, or beside another place of that, no nearer to `others`."""
        further = [spot for spot, _ in self.chords[1:]]
        return labels.beside(self.place, self.letter, hand.letter, OFF_ARC, self.facing, others, further)


Mark: TypeAlias = ForceArrow | CoupleArc | Arm


def letter_each(marks: Sequence[Mark], labels: Labels, hand: Hand, by: Sequence[Mark | Line] = ()) -> Iterator[Stroke]:
    """Letter forces, couples or arms, each nearer to its own than to any other of them or of what they stand `by`."""
    lines = [_lines(mark, hand) for mark in (*marks, *by)]
    for k, mark in enumerate(marks):
        yield mark.letter_beside(labels, hand, [*chain(*lines[:k], *lines[k + 1 :])])


def _lines(mark: Mark | Line, hand: Hand) -> Lines:
    """Give the line of a mark, or the chords of an arc."""
    if isinstance(mark, CoupleArc):
        return mark.chords
    if isinstance(mark, Line):
        return ((mark.start, mark.end),)
    return (mark.reach(hand) if isinstance(mark, Arm) else (mark.start, mark.tip),)


CONTACT = 0.9  # radius of the pitch point
TANGENT, ACTION = 22.0, 30.0  # mm: half of the pitch tangent drawn, and half of the line of action
LEAST = 0.05  # mm: a shorter arc is a point
ANGLE = 16.0  # radius of the arc of the pressure angle
ARC = math.radians(32)  # half of the arc of the pitch circle drawn where the whole would not fit
COILS, COIL = 5, 3.0  # zigzags of a spring, and half its width
STRAIGHT = 0.2  # share of a spring's length that is straight at either end
HALF_TOOTH, PLATE = 6.0, 1.6  # half the height of a coupling's plates, and the gap between them


class Gear(NamedTuple):
    """A toothed wheel on paper: its shaft, the radius of its pitch circle in mm, the pitch point's direction, rad.

    `action` is the unit direction of the force on the wheel along the line of action.
    """

    centre: complex
    radius: float
    at: float
    action: complex

    @property
    def contact(self) -> complex:
        """The pitch point, where the pinion meets the wheel."""
        return self.centre + cmath.rect(self.radius, self.at)

    @property
    def tangent(self) -> complex:
        """The direction of the pitch tangent on the side of the force."""
        across = 1j * cmath.rect(1.0, self.at)
        return across if (self.action * across.conjugate()).real >= 0 else -across

    def slants(self, hand: Hand) -> bool:
        """Tell whether there is a pressure angle to be seen."""
        return abs(_turn(self)) * ANGLE * hand.symbol > LEAST

    def angle(self, hand: Hand) -> tuple[complex, float]:
        """Give the middle of the pressure angle's arc, and its direction from the pitch point: for the letter."""
        turn = cmath.phase(self.action) - _turn(self) / 2
        return self.contact + cmath.rect(ANGLE * hand.symbol, turn), turn

    def draw(self, hand: Hand, whole: bool = True) -> tuple[Stroke, ...]:
        """Draw pitch circle, pitch tangent, line of action and the arc of the pressure angle between them."""
        contact, factor = self.contact, hand.symbol
        low, high = (0.0, 2 * math.pi) if whole else (self.at - ARC, self.at + ARC)
        circle = Arc(self.centre, self.radius, low, high, hand.axis)
        tangent, action = self.tangent * TANGENT * factor, self.action * ACTION * factor
        turn = _turn(self)
        first = cmath.phase(self.action) - max(turn, 0.0)
        arc = Arc(contact, ANGLE * factor, first, first + abs(turn), hand.drafted)
        lines = [Line(contact - half, contact + half, hand.drafted) for half in (tangent, action)]
        slant = [arc] if self.slants(hand) else []
        return *fit_dashes([circle]), *lines, *slant, Circle(contact, CONTACT * factor, INK)


def _turn(gear: Gear) -> float:
    """Give the angle from the pitch tangent to the line of action, rad."""
    return cmath.phase(gear.action / gear.tangent)


def spring(start: complex, end: complex, hand: Hand, coils: int = COILS) -> Polyline:
    """Draw a spring (пружина) between two places: a zigzag with straight ends."""
    length = abs(end - start)
    if length == 0:
        return Polyline((start, end), False, hand.relative)
    along = (end - start) / length
    across = 1j * along * min(COIL * hand.symbol, length / 4)
    first, last = STRAIGHT * length, (1 - STRAIGHT) * length
    step = (last - first) / (2 * coils)
    turns = [start + along * (first + (k + 0.5) * step) + (across if k % 2 else -across) for k in range(2 * coils)]
    return Polyline((start, start + along * first, *turns, start + along * last, end), False, hand.relative)


def coupling(at: complex, direction: complex, hand: Hand, reach: float = 12.0) -> tuple[Line, ...]:
    """Draw a coupling (муфта): two plates facing each other across a shaft that runs in some direction."""
    factor, signs = hand.symbol, (-1, 1)
    plates = [at + sign * direction * PLATE / 2 * factor for sign in signs]
    half = 1j * direction * HALF_TOOTH * factor
    ends = zip(plates, signs, strict=True)
    shafts = (Line(plate, plate + sign * direction * reach * factor, hand.result) for plate, sign in ends)
    return *(Line(plate - half, plate + half, hand.result) for plate in plates), *shafts
