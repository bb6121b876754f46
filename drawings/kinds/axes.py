"""Axes of graphs: a part of the turn with its numbers, the pole, arrows and ticks (оси графиков)."""

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from drawings.layout.labels import NEAR, Labels
from drawings.layout.picture import Figure
from drawings.lettering.lettering import spaced, text_width
from drawings.lettering.words import telling
from drawings.page.page import Scale
from drawings.paper.hand import Field, Hand
from drawings.paper.strokes import Group, Kind, Line, Statement, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.figure import Dimension
from drawings.symbols.symbols import arrowhead, pole
from plans.model.motion import Floats

LEFT, RIGHT, OVER, UNDER = math.pi, 0.0, math.pi / 2, -math.pi / 2
CLOSE = 2.0  # ways from a spot to its letter: what is no farther than these and the letter may be taken for the spot
NUMBERED = 1.8  # sizes of a number beside an axis that what is drawn along it keeps off
BETWEEN = 3.0  # mm from a part's title to its scales
STACKED = 1.6  # sizes of a text from a title to the scales under it


class Letter(NamedTuple):
    """A lettering that looks for its place: beside which spot, or `further` ones, on which side, how far off, mm."""

    at: complex
    text: str
    size: float
    side: float
    gap: float = 1.2
    further: tuple[complex, ...] = ()


class Part(NamedTuple):
    """A graph or a loop on paper: its lines, its letters; those of small numbers come last."""

    name: str
    lines: tuple[Stroke, ...]
    letters: tuple[Letter, ...]

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give it whole, its letters placed among the lines of all figures."""
        return (Group((*self.lines, Group(tuple(placed(self.name, self.letters, labels)))), self.name),)


def placed(name: str, letters: Iterable[Letter], labels: Labels) -> Iterator[Stroke]:
    """Place the letters of a figure, the largest first; one keeps off the spots of others of its size close by."""
    every = sorted(letters, key=lambda letter: -letter.size)
    for letter in every:
        apart = [(other.at, tied(abs(other.at - letter.at))) for other in every if other.size == letter.size]
        others = [(spot, spot) for spot, far in apart if 0 < far < CLOSE * (letter.gap + NEAR[-1]) + letter.size]
        yield telling(name, labels.beside(*letter[:3], letter.gap, letter.side, others, letter.further))


class Parts(NamedTuple):
    """A figure of several parts, those that bear no letters first."""

    still: tuple[Group, ...]
    parts: tuple[Figure, ...]

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        return *self.still, *(line for part in self.parts for line in part.lines)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give all the parts, lettered: poles, which come last, first, for their dimensions' letters have one place."""
        lettered = [part.letter(labels) for part in reversed(self.parts)]
        return *self.still, *(group for groups in reversed(lettered) for group in groups)


def caption(title: str, scales: str, field: Field, hand: Hand, stacked: bool = False) -> Group:
    """Write a part's title and its scales at the top of a field, on one line or stacked, in its middle if they fit."""
    start = complex(max(field.centre.real - wide(title, scales, hand, stacked) / 2, field.left), field.top - hand.title)
    then = start + (-STACKED * 1j * hand.text if stacked else text_width(Text(0j, title, hand.title)) + BETWEEN)
    return Group((Text(start, title, hand.title, "start", True), Text(then, scales, hand.text, "start", True)))


def wide(title: str, scales: str, hand: Hand, stacked: bool = False) -> float:
    """Give the length of a caption, mm."""
    both = text_width(Text(0j, title, hand.title)), text_width(Text(0j, scales, hand.text))
    return max(both) if stacked else sum(both) + BETWEEN


class Pole(NamedTuple):
    """A pole on the axis of the abscissas, left of zero, and the values that its rays cut off the axis of ordinates."""

    letters: tuple[str, str]  # of the pole and of its distance
    distance: float  # mm
    places: Floats  # (n,): the abscissas where the values belong, true units
    values: Floats  # (n,): true units
    apart: float  # mm between the ends of two rays that are drawn
    off: complex  # mm from the axis to the dimension of the distance
    side: float = OVER  # of that dimension on which its letter stands

    def part(self, name: str, axes: "Axes", hand: Hand) -> Part:
        """Draw the pole, and rays to values that lie apart, each value carried to where it belongs."""
        at, (letter, text) = axes.zero - self.distance, self.letters
        size = Dimension(text, at, axes.zero, self.off)
        ends = (self.values / axes.up.mu).tolist()
        kept = spaced(ends, self.apart)  # those whose ends lie apart, and leave the numbers of the axis their room
        clear = [k for k in kept if abs(ends[k]) >= NUMBERED * hand.number]
        rays = (line for k in clear or kept for line in self._ray(k, at, axes, hand))
        base = Line(at, axes.zero, hand.drafted)
        letters = (Letter(at, letter, hand.letter, LEFT), Letter(size.middle, text, hand.letter, self.side))
        return Part(name, (base, *rays, *size.draw(hand), pole(at)), letters)

    def _ray(self, k: int, at: complex, axes: "Axes", hand: Hand) -> Iterator[Stroke]:
        """Draw the ray of a value, and what it cuts off carried from the axis to where it belongs."""
        value = float(self.values[k])
        cut = axes.on(0.0, value)
        yield Line(at, cut, hand.drafted)
        if tied(abs(cut - axes.zero)):
            yield Line(cut, axes.on(float(self.places[k]), value), hand.drafted)


BEYOND = 9.0  # mm that an axis goes beyond the graph, for its arrowhead


class Plot(NamedTuple):
    """A curve in true units, its abscissas and ordinates, (N,); where it jumps two of its points have one abscissa."""

    x: Floats
    y: Floats


class Axes(NamedTuple):
    """Where the values of a graph lie on paper: its zero, mm, and the scale and the direction of each axis."""

    zero: complex
    across: Scale
    up: Scale
    along: complex = 1 + 0j  # the way of the abscissas on paper
    rise: complex = 1j  # that of the ordinates

    def on(self, x: float, y: float = 0.0) -> complex:
        """Give the place on paper of true values, mm."""
        return self.zero + self.along * (x / self.across.mu) + self.rise * (y / self.up.mu)

    def below(self, y: float) -> bool:
        """Tell whether a true value lies below the axis of abscissas: none that is but rounding does."""
        return tied(y / self.up.mu) < 0

    def lines(
        self, across: tuple[float, float], up: tuple[float, float], hand: Hand, figure: str = ""
    ) -> Iterator[Stroke]:
        """Draw both axes over ranges of true values, each with its arrowhead beyond the end; they state a figure's."""
        (left, right), (low, high) = across, up
        level = arrow(self.on(left), self.on(right) + BEYOND * self.along, hand)
        upright = arrow(self.on(0.0, low), self.on(0.0, high) + BEYOND * self.rise, hand)
        if not figure:
            yield from (*level, *upright)
            return
        yield stating(Statement(Kind.AXIS, figure, "x", scale=self.across.mu), *level)
        yield stating(Statement(Kind.AXIS, figure, "y", scale=self.up.mu), *upright)


def arrow(start: complex, end: complex, hand: Hand) -> Iterator[Stroke]:
    """Draw an axis with its arrowhead."""
    yield Line(start, end, hand.other)
    head = arrowhead(start, end, hand.symbol)
    if head is not None:
        yield head
