"""The frame of a law's diagrams: rows one under another over the cam's turn, their pole distances (разметка)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from drawings.cam.notes import ACCELERATION, TRAVEL, VELOCITY, letters, units
from drawings.kinds.axes import Plot
from drawings.kinds.row_frame import Proportions, RowPlate
from drawings.kinds.smooth import cubics
from drawings.lettering.words import Slot
from drawings.page.page import Drafting, Scale
from geometry.strips import middles
from plans.cam.diagrams import LawDiagrams
from plans.model.cam import TABLE, Cam
from plans.model.motion import Floats

LETTERS = {ACCELERATION: "''", VELOCITY: "'", TRAVEL: ""}
STEPS = 360  # of a turn at least: a degree, of which no curve on paper shows the corners
IMPULSE = 0.3  # of the height of a diagram: how far the arrow of an impulse goes beyond it


class LawRow(NamedTuple):
    """A row: values at the edges after and before a jump, the curve, what it was drawn by, the exact one beside it.

    `impulses` are the edges at which S'' is infinite, each with its sense.
    """

    key: str
    letter: str
    unit: str
    after: Floats  # (n + 1,)
    before: Floats
    result: Plot
    chords: tuple[Plot, ...] = ()
    exact: Plot | None = None
    rays: Plot = Plot(np.zeros(0), np.zeros(0))  # the mean ordinates, in the middles of their strips
    impulses: tuple[tuple[int, int], ...] = ()
    error: float = 0.0  # the largest, in shares of the largest value
    given: tuple[tuple[float, float], ...] = ()  # points of tables

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest value, zero among them, with room for the arrows of impulses."""
        low, high = min(float(self.result.y.min()), 0.0), max(float(self.result.y.max()), 0.0)
        senses = {sense for _, sense in self.impulses}
        spare = IMPULSE * ((high - low) or 1.0)
        return low - spare * (-1 in senses), high + spare * (1 in senses)

    @property
    def flat(self) -> bool:
        """Whether it shows nothing that a scale could be told of."""
        return not self.result.y.any()


def rows(shown: LawDiagrams) -> tuple[LawRow, ...]:
    """Give the rows from the top."""
    return _acceleration(shown), _velocity(shown), _travel(shown)


def _row(shown: LawDiagrams, key: str, after: Floats, before: Floats, result: Plot) -> LawRow:
    cam = shown.strips.course.cam
    return LawRow(key, letters(cam)[0] + LETTERS[key], units(cam)[key], after, before, result)


def _acceleration(shown: LawDiagrams) -> LawRow:
    strips = shown.strips
    begin, end = strips.after.bend[:-1], strips.before.bend[1:]
    x = _dense(shown)
    y = strips.course.at(x.ravel()).bend.reshape(x.shape)
    y[:, 0], y[:, -1] = begin, end
    hard = [k for k in strips.hard if k < len(begin) or strips.course.cam.translates]
    impulses = tuple((k, int(math.copysign(1, _jump(shown, k)))) for k in hard)
    sides = _sides(shown, begin, end, strips.jumps)
    rays = Plot(middles(strips.edges), shown.means)
    return _row(shown, ACCELERATION, *sides, _joined(x, y, sides))._replace(rays=rays, impulses=impulses)


def _jump(shown: LawDiagrams, k: int) -> float:
    """Give by how much S' jumps at an edge."""
    shocks = shown.strips.course.shocks
    return min(shocks, key=lambda shock: (shock.order, abs(shock.turned - shown.strips.edges[k]))).jump


def _velocity(shown: LawDiagrams) -> LawRow:
    strips, (begin, end) = shown.strips, shown.slope
    x = _dense(shown)
    y = cubics(x, (begin, end), (strips.after.bend[:-1], strips.before.bend[1:]))
    sides = _sides(shown, begin, end, strips.hard)
    chords = tuple(Plot(run.edges, run.values) for run in shown.slopes)
    exact = strips.course.at(x.ravel()).slope.reshape(x.shape)
    exact[:, -1] = strips.before.slope[1:]
    row = _row(shown, VELOCITY, *sides, _joined(x, y, sides))
    rays, course = Plot(middles(strips.edges), shown.travel.means), Plot(x.ravel(), exact.ravel())
    return row._replace(chords=chords, rays=rays, exact=course, error=shown.slope_departure.share)


def _travel(shown: LawDiagrams) -> LawRow:
    strips, values = shown.strips, shown.travel.values
    x = _dense(shown)
    y = cubics(x, (values[:-1], values[1:]), shown.slope)
    row = _row(shown, TRAVEL, values, values, Plot(x.ravel(), y.ravel()))
    exact = Plot(x.ravel(), strips.course.at(x.ravel()).s)
    chords, given = (Plot(strips.edges, values),), tuple(_given(strips.course.cam))
    return row._replace(chords=chords, exact=exact, error=shown.travel_departure.share, given=given)


def _given(cam: Cam) -> Iterator[tuple[float, float]]:
    """Give the points of all tables."""
    for phase in cam.moving():
        if phase.law is not None and phase.law.name == TABLE:
            yield from ((phase.start + k * phase.angle, phase.level + s * phase.change) for k, s in phase.law.points)


def _dense(shown: LawDiagrams) -> Floats:
    """Divide each strip finely, (n, m) rad."""
    edges = shown.strips.edges
    shares = np.linspace(0.0, 1.0, 1 + math.ceil(STEPS / (len(edges) - 1)))
    return np.asarray(edges[:-1, None] + shares * np.diff(edges)[:, None])


def _sides(shown: LawDiagrams, begin: Floats, end: Floats, jumps: tuple[int, ...]) -> tuple[Floats, Floats]:
    """Give the values at the edges after and before a jump; the jump at the end of a turn stands at its beginning."""
    after, before = np.append(begin, end[-1]), np.append(begin[0], end)
    translates, last = shown.strips.course.cam.translates, len(begin)
    if 0 in jumps:
        before[0] = 0.0 if translates else end[-1]
    if last in jumps and translates:
        after[-1] = 0.0
    return after, before


def _joined(x: Floats, y: Floats, sides: tuple[Floats, Floats]) -> Plot:
    """Join the strips to one curve, upright where it jumps."""
    after, before = sides
    return Plot(np.concatenate([x[:1, 0], x.ravel(), x[-1:, -1]]), np.concatenate([before[:1], y.ravel(), after[-1:]]))


NAME = "law"
# Four coarser scales differ by ten times.
PROPORTIONS = Proportions(high=0.6, left=7.2, right=1.8, pole=(1.55, 4.8), coarser=4, rises=True)
PER_CENT = 2  # digits of an error
ROUNDED = 1e-9  # of the largest value: chords that are exact but for the roundings of their steps
LEVEL = 4.4  # sizes of a number from the lowest row to the dimensions of the phases
BELOW = 2.2  # and from these to the end


def name_of(cam: Cam) -> str:
    """Give the name of the figure of a cam's law."""
    return f"{NAME}-{cam.name}"


@dataclass(frozen=True)
class LawPlate(RowPlate[LawRow]):
    """Diagrams of a law to be drafted: their rows and the paper about them."""

    shown: LawDiagrams
    drafting: Drafting
    proportions: ClassVar[Proportions] = PROPORTIONS

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.shown.strips.course.cam

    @cached_property
    def rows(self) -> tuple[LawRow, ...]:
        """The rows from the top."""
        return rows(self.shown)

    @property
    def length(self) -> float:
        """How far the cam turns, rad, or travels, m."""
        return self.cam.turn

    def named(self, key: str) -> str:
        """Name a part of the figure."""
        return f"{name_of(self.cam)}-{key}"

    @property
    def below(self) -> float:
        """Paper under the last row, mm: the dimensions of the phases."""
        return (LEVEL + BELOW) * self.hand.number

    @property
    def widest(self) -> str:
        """The scale of the turn behind that of a row, as long as it may be."""
        return self.drafting.scale(Scale(0.025, *self.axis))

    @property
    def axis(self) -> tuple[str, str]:
        """The letter and the unit of the cam's turn."""
        return letters(self.cam)[1], "m" if self.cam.translates else "rad"

    def title(self, row: LawRow) -> str:
        """Give the title of a row."""
        key = "turn" if row.key == TRAVEL and self.cam.rocks else row.key
        return f"{self.drafting.word(f'law {key}')} {row.letter}"

    def said(self, row: LawRow) -> Iterator[str]:
        """Tell where there are shocks, or by how much the chords are off."""
        if row.key != ACCELERATION:
            off = row.error if row.error > ROUNDED else 0.0
            yield self.drafting.phrase("chords off", off=Slot("off", 100 * off, PER_CENT))
            return
        strips = self.shown.strips
        soft = [k for k in strips.jumps if k not in strips.hard]
        kinds = (("hard shocks", strips.hard), ("soft shocks", soft))
        # The end of a turn is its beginning.
        named = ((key, ", ".join(dict.fromkeys(strips.names[k] for k in edges))) for key, edges in kinds)
        sentences = [self.drafting.word(key, places=places) for key, places in named if places]
        if sentences:
            yield ";  ".join(sentences)
