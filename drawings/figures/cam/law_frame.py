"""The frame of a law's diagrams: rows one under another over one axis, their scales and pole distances (разметка)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise, product

from drawings.figures.cam.law_rows import LawRow, rows
from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.layout.picture import Margins, Picture, Spot
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale, fitting
from drawings.paper.formats import Field
from drawings.paper.hand import Hand
from drawings.report.cam_letters import ACCELERATION, TRAVEL, VELOCITY, letters
from plans.cam.diagrams import LawDiagrams
from plans.model.cam import Cam

NAME = "law"
KEYS = (ACCELERATION, VELOCITY, TRAVEL)  # of the rows, from the top
HIGH = 0.78  # height of all rows, in lengths of the axis
TALLEST = 0.42  # share of it that one row takes at most
LONG = 24.0  # sizes of a letter that the axis has at least: its positions are numbered
LEFT, RIGHT = 8.6, 1.8  # paper beside the graphs, likewise
POLE = (2.8, 6.2)  # least and greatest pole distance, likewise
LEVEL = 3.4  # sizes of a number from the lowest row to the dimensions of the phases
BELOW = 2.0  # and from these to the end
LARGER = 1 + 1e-9  # times an extent that fits: no two standard scales lie so near
COARSER = 4  # scales tried beyond the largest: they differ by ten times


def name_of(cam: Cam) -> str:
    """Give the name of the figure of a cam's law."""
    return f"{NAME}-{cam.name}"


@dataclass(frozen=True)
class LawPlate:
    """Diagrams of a law to be drafted: their rows and the paper about them."""

    shown: LawDiagrams
    drafting: Drafting

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.shown.strips.course.cam

    @property
    def hand(self) -> Hand:
        """The hand that draws."""
        return self.drafting.hand

    @cached_property
    def rows(self) -> tuple[LawRow, ...]:
        """The rows from the top."""
        return rows(self.shown)

    def named(self, key: str) -> str:
        """Name a part of the figure."""
        return f"{name_of(self.cam)}-{key}"

    @property
    def beside(self) -> float:
        """Half the paper beside the graphs, mm."""
        return (LEFT + RIGHT) * self.hand.letter / 2 + BEYOND / 2

    @property
    def over(self) -> float:
        """Paper over the lines of a row, mm: the end of an axis, its title, what is told under that."""
        return BEYOND + self.hand.title + 2 * self.hand.text + 0.4 * self.hand.letter

    @property
    def under(self) -> float:
        """Paper under the lines of a row, mm: numbers."""
        return 2 * self.hand.number

    @property
    def below(self) -> float:
        """Paper under the last row, mm: the dimensions of the phases."""
        return (LEVEL + BELOW) * self.hand.number

    def room(self, heading: float) -> Picture:
        """Give the room of the figure; its scale is that of the cam's turn."""
        size, turn = self.hand.letter, self.cam.turn
        margins = Margins(self.beside, self.below, len(self.rows) * (self.over + self.under))
        high = turn * HIGH
        unit = "m" if self.cam.translates else "rad"
        letter = letters(self.cam)[1]
        return Picture(
            name_of(self.cam),
            turn,
            high,
            complex(turn, high) / 2,
            letter,
            unit,
            margins,
            heading,
            LONG * size,
            open=False,
        )


@dataclass(frozen=True)
class LawFrame:
    """The diagrams at their scale: the fields of their rows, their axes."""

    plate: LawPlate
    spot: Spot

    @property
    def length(self) -> float:
        """The length of the axis of the cam's turn, mm."""
        return self.plate.cam.turn / self.spot.scale.mu

    @cached_property
    def fields(self) -> dict[str, Field]:
        """The fields of the rows' lines, as wide as the axis."""
        box, plate = self.spot.box, self.plate
        left, top, fields = box.left + LEFT * plate.hand.letter, box.top, {}
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
        spans = (0.0 if row.flat and not row.impulses else row.span[1] - row.span[0] for row in self.plate.rows)
        return [span / scale.mu for span, scale in zip(spans, scales, strict=True)]

    @cached_property
    def scales(self) -> dict[str, Scale]:
        """The scales of the rows: the largest ones together at which both poles stand in the paper beside them."""
        steps = [list(self._steps(row)) for row in self.plate.rows]
        best = min(product(*steps), key=self._cost)
        return dict(zip(KEYS, best, strict=True))

    def _cost(self, scales: tuple[Scale, ...]) -> tuple[bool, int, float]:
        """Weigh scales: rows too high together, poles that stand badly, then how small the graphs become."""
        size = self.plate.hand.letter
        least, most = (one * size for one in POLE)
        out = sum(not least <= one <= most for one in self._distances(scales))
        return sum(self._taken(scales)) > HIGH * self.length, out, scales[0].mu * scales[1].mu * scales[2].mu

    def _distances(self, scales: tuple[Scale, ...]) -> Iterator[float]:
        for row, one, other in zip(self.plate.rows, scales, scales[1:], strict=False):
            if not row.flat:
                yield other.mu / (one.mu * self.spot.scale.mu)

    def _steps(self, row: LawRow) -> Iterator[Scale]:
        """Give the largest scale of a row, and some smaller ones."""
        low, high = row.span
        scale = self._fitting(row, high - low, TALLEST * HIGH * self.length)
        yield scale
        for _ in range(0 if row.flat else COARSER):
            scale = self._fitting(row, scale.mu * LARGER, 1.0)
            yield scale

    def _fitting(self, row: LawRow, extent: float, room: float) -> Scale:
        return fitting(extent, room, f"{{{row.letter}}}", row.unit, self.plate.drafting.standard)

    def pole(self, row: LawRow) -> float | None:
        """Give the distance, mm, of the pole from which the row under this one is drawn; None: there is none."""
        below = dict(pairwise(KEYS)).get(row.key)
        if below is None or row.flat:
            return None
        return self.scales[below].mu / (self.scales[row.key].mu * self.spot.scale.mu)

    def distance(self, row: LawRow) -> float | None:
        """Give the distance, mm, of the pole that a row is drawn from."""
        above = dict(zip(KEYS[1:], self.plate.rows, strict=False)).get(row.key)
        return None if above is None else self.pole(above)

    def axes(self, row: LawRow) -> Axes:
        """Stand a row in the middle of its field."""
        field, up, (low, high) = self.fields[row.key], self.scales[row.key], row.span
        spare = field.height - (high - low) / up.mu
        return Axes(complex(field.left, field.bottom + spare / 2 - low / up.mu), self.spot.scale, up)
