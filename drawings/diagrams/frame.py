"""The frame of the kinematic diagrams: rows one under another over the crank angle, the scale of time (разметка)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import Curve
from drawings.kinds.row_frame import Proportions, RowPlate
from drawings.kinds.smooth import smooth
from drawings.page.scale import Drafting
from drawings.paper.walk import PLACES
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import TURN, Axis, ChordError, Course, Diagrams, chord_error
from plans.model.motion import Floats

TRAVEL, VELOCITY, ACCELERATION = KEYS = ("travel", "velocity", "acceleration")  # from the top
SLIDING, TURNING = ("S", "v", "a"), ("ψ", "ω", "ε")
AHEAD = ("Δψ", "Δω", "ε")  # of an output that turns fully: what it is ahead of an even turn
STEPS = 360  # of a turn at least: a degree, of which no curve on paper shows the corners
NOUGHT = 1e-9  # of what the row above would make it: a rounding, which no scale is told of


class DiagramRow(NamedTuple):
    """A row: its points by the plans, what is drawn thick and thin, the points and values by chords."""

    key: str
    letter: str
    unit: str
    at: Floats  # (M,): of the plans, at the positions; NaN at gaps
    results: tuple[Curve, ...]
    thin: tuple[Curve, ...]
    chords: Curve  # where the values by chords belong, and these; nothing in the first row
    off: ChordError | None = None  # of the values by chords
    flat: bool = False  # whether it shows nothing that a scale could be told of

    @property
    def rays(self) -> Curve:
        """The values to which the rays of its pole go: those by chords."""
        return self.chords

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest value, zero among them; nothing of a row that shows nothing."""
        if self.flat:
            return 0.0, 0.0
        own = np.concatenate([self.at, *(one.y for one in (*self.results, *self.thin, self.chords))])
        return float(np.nanmin(own, initial=0.0)), float(np.nanmax(own, initial=0.0))


def letters_of(own: DiagramsStudy) -> tuple[str, str, str]:
    """Give the letters of the rows."""
    if own.course.travel.sliding:
        return SLIDING
    return AHEAD if own.course.count.turns else TURNING


def rows_of(own: DiagramsStudy) -> tuple[DiagramRow, ...]:
    """Give the rows from the top."""
    found = own.drawn
    axis, nodes = found.axis, found.axis.nodes(STEPS)
    dense = [own.course.at(row) for row in nodes]
    travel = _row(own, 0, found.at.s, _curves(nodes, [one.s for one in dense]))
    chords = tuple(Curve(axis.turned[run], found.at.s[run]) for run in axis.runs)
    return (
        travel._replace(thin=chords),
        _by_chords(_row(own, 1, found.at.v, _curves(nodes, [one.v for one in dense])), own, axis.middles),
        _by_chords(_row(own, 2, found.even, _curves(nodes, _even(found, dense))), own, axis.places),
    )


def _row(own: DiagramsStudy, order: int, at: Floats, curves: tuple[Curve, ...]) -> DiagramRow:
    nothing = Curve(np.zeros(0), np.zeros(0))
    return DiagramRow(KEYS[order], letters_of(own)[order], own.units[order], at, curves, (), nothing)


def _by_chords(row: DiagramRow, own: DiagramsStudy, places: Floats) -> DiagramRow:
    """Let the values by chords be the result, and what is exact stand thin beside them."""
    found, fast = own.drawn, row.key == VELOCITY
    values, exact = (found.speeds, found.true_speeds) if fast else (found.growths, found.true_growths)
    there, off = ~np.isnan(values), chord_error(values, exact)
    above = float(np.nanmax(np.abs(found.at.s if fast else found.speeds), initial=0.0))
    flat = bool(np.nanmax(np.abs(values), initial=0.0) <= NOUGHT * own.course.omega * above)
    results = () if flat else tuple(_smooth(found.axis, places, values))
    chords = Curve(places[there], values[there])
    return row._replace(results=results, thin=() if flat else row.results, chords=chords, off=off, flat=flat)


def _even(found: Diagrams, dense: list[Course]) -> list[Floats]:
    return [one.even(found.lead) for one in dense]


def _curves(nodes: Sequence[Floats], values: list[Floats]) -> tuple[Curve, ...]:
    return tuple(Curve(x, y) for x, y in zip(nodes, values, strict=True))


def _smooth(axis: Axis, places: Floats, values: Floats) -> Iterator[Curve]:
    """Join the values by chords of each run smoothly; those of a whole turn go on from its end to its beginning."""
    for run, nodes in zip(axis.runs, axis.nodes(STEPS), strict=True):
        own = slice(run.start, run.stop - (len(values) < len(axis.turned)))
        there = ~np.isnan(values[own])
        x, y = places[own][there], values[own][there]
        if axis.closed:
            x, y = _around(x, y)
        if len(x) > 1:
            at = np.sort(np.concatenate([_within(nodes, x), _within(x, nodes)]))
            yield Curve(at, smooth(x, y, at))


def _within(places: Floats, ends: Floats) -> Floats:
    """Give the places between the first and the last of others."""
    counted, (first, last) = places.round(PLACES), ends[[0, -1]].round(PLACES)
    return np.asarray(places[(first <= counted) & (counted <= last)])


def _around(x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Let a row of a turn go on a little beyond both its ends."""
    if x[-1] - x[0] >= TURN - np.diff(x).min() / 2:  # its end is its beginning
        x, y = x[:-1], y[:-1]
    return np.concatenate([x[-2:] - TURN, x, x[:2] + TURN]), np.concatenate([y[-2:], y, y[:2]])


NAME = "diagrams"
# Twelve coarser scales differ by five hundred times and more.
PROPORTIONS = Proportions(high=0.9, left=10.4, right=1.8, pole=(2.8, 8.0), coarser=12, rises=False)
# Graphs of a part of a turn, all three as high as one another, want a pole half the axis away: what goes forth alone
# has a course three times as long for its speed as what comes back too.
FORTH = PROPORTIONS._replace(left=22.4, pole=(2.8, 20.0))
PER_CENT = 2  # digits of an error


@dataclass(frozen=True)
class DiagramsPlate(RowPlate[DiagramRow]):
    """Diagrams to be drafted: their rows and the paper about them."""

    own: DiagramsStudy
    drafting: Drafting

    @property
    def proportions(self) -> Proportions:
        """How the figure is laid out."""
        return PROPORTIONS if self.axis.closed else FORTH

    @property
    def axis(self) -> Axis:
        """The axis of all rows."""
        return self.own.axis

    @property
    def omega(self) -> float:
        """How fast the crank turns, rad/s."""
        return self.own.course.omega

    @cached_property
    def rows(self) -> tuple[DiagramRow, ...]:
        """The rows from the top."""
        return rows_of(self.own)

    @property
    def length(self) -> float:
        """How far the axis goes, rad."""
        return float(self.axis.turned[-1])

    def named(self, key: str) -> str:
        """Name a part of the figure."""
        return f"{NAME}-{key}"

    @property
    def above(self) -> float:
        """Paper over the first row, mm: the heading of the figure."""
        return 3 * self.hand.title

    @property
    def widest(self) -> str:
        """The pole distance behind the scale of a row, as long as it may be."""
        return f"H_1 = 55.55 {self.drafting.word('mm')}"

    def title(self, row: DiagramRow) -> str:
        """Give the title of a row: its letter over the crank angle."""
        return f"{row.letter}(φ)"

    def said(self, row: DiagramRow) -> Iterator[str]:
        """Tell by how much the chords are off, or that the row shows nothing."""
        if row.flat:
            yield self.drafting.word("diagram flat")
        elif row.off is not None:
            yield self.drafting.word("chords off", off=self.drafting.number(100 * row.off.share, PER_CENT))
