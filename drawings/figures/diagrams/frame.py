"""The frame of the kinematic diagrams: rows one under another over one axis, their scales and poles (разметка)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise, product

from drawings.figures.diagrams.rows import KEYS, DiagramRow, rows_of
from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.layout.picture import Margins, Picture, Spot
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale, fitting
from drawings.paper.formats import Field
from drawings.paper.hand import Hand
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Axis

NAME = "diagrams"
HIGH = 0.9  # height of all rows, in lengths of the axis
TALLEST = 0.42  # share of it that one row takes at most
LONG = 24.0  # sizes of a letter that the axis has at least: its positions are numbered
RIGHT, LETTERS = 1.8, 2.4  # paper on the right of the graphs, and on the left for the letters of a pole, likewise
# Least and greatest pole distance, likewise. Graphs of a part of a turn, all three as high as one another, want a pole
# half the axis away: what goes forth alone has a course three times as long for its speed as what comes back too.
POLE, FARTHER = (2.8, 8.0), 20.0
LARGER = 1 + 1e-9  # times an extent that fits: no two standard scales lie so near
COARSER = 12  # scales tried beyond the largest: they differ by five hundred times and more


@dataclass(frozen=True)
class DiagramsPlate:
    """Diagrams to be drafted: their rows and the paper about them."""

    own: DiagramsStudy
    drafting: Drafting

    @property
    def hand(self) -> Hand:
        """The hand that draws."""
        return self.drafting.hand

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

    @staticmethod
    def named(key: str) -> str:
        """Name a part of the figure."""
        return f"{NAME}-{key}"

    @property
    def beside(self) -> float:
        """Half the paper beside the graphs, mm."""
        return (self.left + RIGHT * self.hand.letter + BEYOND) / 2

    @property
    def left(self) -> float:
        """The paper on the left of the graphs, mm."""
        return self.farthest + LETTERS * self.hand.letter

    @property
    def farthest(self) -> float:
        """The greatest distance of a pole, mm."""
        return (POLE[1] if self.axis.closed else FARTHER) * self.hand.letter

    @property
    def over(self) -> float:
        """Paper over the lines of a row, mm: the end of an axis, its title, what is told under that."""
        return BEYOND + self.hand.title + 2 * self.hand.text + 0.4 * self.hand.letter

    @property
    def under(self) -> float:
        """Paper under the lines of a row, mm: numbers."""
        return 2 * self.hand.number

    @property
    def above(self) -> float:
        """Paper over the first row, mm: the heading of the figure."""
        return 3 * self.hand.title

    def room(self, heading: float) -> Picture:
        """Give the room of the figure; its scale is that of the crank angle."""
        high = self.length * HIGH
        margins = Margins(self.beside, 0.0, self.above + len(self.rows) * (self.over + self.under))
        middle, least = complex(self.length, high) / 2, LONG * self.hand.letter
        return Picture(NAME, self.length, high, middle, "φ", "rad", margins, heading, least)


@dataclass(frozen=True)
class DiagramsFrame:
    """The diagrams at their scale: the fields of their rows, their axes, their pole distances."""

    plate: DiagramsPlate
    spot: Spot

    @property
    def length(self) -> float:
        """The length of the axis of the crank angle, mm."""
        return self.plate.length / self.spot.scale.mu

    @property
    def time(self) -> Scale:
        """The scale of time along that axis."""
        return Scale(self.spot.scale.mu / self.plate.omega, "t", "s")

    @cached_property
    def fields(self) -> dict[str, Field]:
        """The fields of the rows' lines, as wide as the axis."""
        box, plate = self.spot.box, self.plate
        left, top, fields = box.left + plate.left, box.top - plate.above, {}
        for row in plate.rows:
            top -= plate.over
            high = self.heights[row.key]
            fields[row.key] = Field(left, top - high, left + self.length, top)
            top -= high + plate.under
        return fields

    @cached_property
    def heights(self) -> dict[str, float]:
        """The heights of the rows, mm: what their graphs take at their scales, and a part of what is left."""
        taken = self._taken(tuple(self.scales.values()))
        spare = (HIGH * self.length - sum(taken)) / len(taken)
        return {key: high + spare for key, high in zip(KEYS, taken, strict=True)}

    def _taken(self, scales: tuple[Scale, ...]) -> list[float]:
        """Give what the rows take at some scales, mm; one that shows nothing takes nothing."""
        spans = (0.0 if row.flat else row.span[1] - row.span[0] for row in self.plate.rows)
        return [span / scale.mu for span, scale in zip(spans, scales, strict=True)]

    @cached_property
    def scales(self) -> dict[str, Scale]:
        """The scales of the rows: the largest ones together at which both poles stand in the paper beside them."""
        steps = [list(self._steps(row)) for row in self.plate.rows]
        best = min(product(*steps), key=self._cost)
        return dict(zip(KEYS, best, strict=True))

    def _cost(self, scales: tuple[Scale, ...]) -> tuple[bool, int, float]:
        """Weigh scales: rows too high together, poles that stand badly, then how small the graphs become."""
        least, most = POLE[0] * self.plate.hand.letter, self.plate.farthest
        out = sum(not least <= one <= most for one in self._distances(scales))
        return sum(self._taken(scales)) > HIGH * self.length, out, scales[0].mu * scales[1].mu * scales[2].mu

    def _distances(self, scales: tuple[Scale, ...]) -> Iterator[float]:
        """Give the pole distances, mm: a scale over those of time and of the derivative."""
        for row, one, other in zip(self.plate.rows[1:], scales, scales[1:], strict=False):
            if not row.flat:
                yield one.mu / (self.time.mu * other.mu)

    def _steps(self, row: DiagramRow) -> Iterator[Scale]:
        """Give the largest scale of a row, and some smaller ones."""
        low, high = row.span
        scale = self._fitting(row, high - low, TALLEST * HIGH * self.length)
        yield scale
        for _ in range(0 if row.flat else COARSER):
            scale = self._fitting(row, scale.mu * LARGER, 1.0)
            yield scale

    def _fitting(self, row: DiagramRow, extent: float, room: float) -> Scale:
        extent = 0.0 if row.flat else extent
        return fitting(extent, room, f"{{{row.letter}}}", row.unit, self.plate.drafting.standard)

    def distance(self, row: DiagramRow) -> float | None:
        """Give the distance, mm, of the pole that a row is drawn from; None: there is none."""
        above = {other: one for one, other in pairwise(KEYS)}.get(row.key)
        if above is None or row.flat:
            return None
        return self.scales[above].mu / (self.time.mu * self.scales[row.key].mu)

    def axes(self, row: DiagramRow) -> Axes:
        """Stand a row in the middle of its field."""
        field, up, (low, high) = self.fields[row.key], self.scales[row.key], row.span
        if row.flat:
            low = high = 0.0
        spare = field.height - (high - low) / up.mu
        return Axes(complex(field.left, field.bottom + spare / 2 - low / up.mu), self.spot.scale, up)
