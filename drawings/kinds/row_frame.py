"""Graphs one under another over one axis, each from the one above by a pole: room, fields, scales (диаграммы)."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise, product
from typing import Generic, NamedTuple, Protocol, TypeVar

from drawings.kinds.axes import BEYOND, Axes, Part, Plot, Pole, caption, wide
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.lettering.words import joined, telling
from drawings.page.page import Drafting, Scale, fitting
from drawings.paper.hand import Field, Hand
from drawings.paper.strokes import Group, Text

TALLEST = 0.42  # share of the height of all rows that one row takes at most
LONG = 24.0  # sizes of a letter that the axis has at least: its positions are numbered
UNDER = 1.6  # sizes of a text from a row's caption to the line under it
POLE_APART = 0.7  # sizes of a letter between the ends of two rays that are drawn
READ = 16.0  # mm: so high a row is read as well as a higher one
OFF = 1.2  # sizes of a letter from the highest ray to the dimension of the pole distance
LARGER = 1 + 1e-9  # times an extent that fits: no two standard scales lie so near


class Row(Protocol):
    """A graph of the figure, by its name."""

    @property
    def key(self) -> str:
        """Its name among the rows."""

    @property
    def letter(self) -> str:
        """The letter of its ordinates."""

    @property
    def unit(self) -> str:
        """Their unit."""

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest ordinate, zero among them; nothing of a row that shows nothing."""

    @property
    def flat(self) -> bool:
        """Whether it shows nothing that a scale could be told of."""

    @property
    def rays(self) -> Plot:
        """The values to which the rays of its pole go, where they belong."""


Shown = TypeVar("Shown", bound=Row)


class Proportions(NamedTuple):
    """How a figure of rows is laid out."""

    high: float  # height of all rows, in lengths of the axis
    left: float  # paper beside the graphs, sizes of a letter
    right: float
    pole: tuple[float, float]  # least and greatest pole distance, sizes of a letter
    coarser: int  # scales tried beyond the largest
    rises: bool  # whether each row is the integral of the one above it; else its derivative


class RowPlate(ABC, Generic[Shown]):
    """Graphs to be drafted one under another: their rows and the paper about them."""

    drafting: Drafting

    @property
    @abstractmethod
    def proportions(self) -> Proportions:
        """How the figure is laid out."""

    @property
    @abstractmethod
    def rows(self) -> tuple[Shown, ...]:
        """The rows from the top."""

    @property
    @abstractmethod
    def length(self) -> float:
        """How far the axis goes, true units."""

    @property
    @abstractmethod
    def widest(self) -> str:
        """What stands behind the scale of a row, as long as it may be."""

    @abstractmethod
    def named(self, key: str) -> str:
        """Name a part of the figure."""

    @abstractmethod
    def title(self, row: Shown) -> str:
        """Give the title of a row."""

    @abstractmethod
    def said(self, row: Shown) -> Iterator[str]:
        """Tell what stands under the title of a row."""

    @property
    def hand(self) -> Hand:
        """The hand that draws."""
        return self.drafting.hand

    @property
    def beside(self) -> float:
        """Half the paper beside the graphs, mm."""
        return (self.proportions.left + self.proportions.right) * self.hand.letter / 2 + BEYOND / 2

    @property
    def above(self) -> float:
        """Paper over the first row, mm."""
        return 0.0

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
        """Paper under the last row, mm."""
        return 0.0

    @cached_property
    def top(self) -> float:
        """Paper over the rows and between them, mm."""
        return self.above + len(self.rows) * (self.over + self.under)

    @property
    def heading(self) -> float:
        """The width that the captions of the rows need, mm, with scales as long as they may be."""
        return self.proportions.left * self.hand.letter + max(map(self._wide, self.rows))

    def _wide(self, row: Shown) -> float:
        scale = self.drafting.scale(Scale(0.0025, f"{{{row.letter}}}", row.unit))
        widths = (text_width(Text(0j, text, self.hand.text)) for text in self.said(row))
        return max(wide(self.title(row), f"{scale};  {self.widest}", self.hand), *widths, 0.0)

    def pole_letters(self, row: Shown) -> tuple[str, str]:
        """Give the letters of the pole by which a row is drawn from the one above it, and of its distance."""
        k = self.place(row)
        return f"P_{k}", f"H_{k}"

    def place(self, row: Shown) -> int:
        """Give the place of a row from the top."""
        return [shown.key for shown in self.rows].index(row.key)

    def room(self, name: str, axis: tuple[str, str], heading: float = 0.0) -> Picture:
        """Give the room of the figure; its scale is that of its axis."""
        high = self.length * self.proportions.high
        margins, least = Margins(self.beside, self.below, self.top), LONG * self.hand.letter
        middle, heading = complex(self.length, high) / 2, max(heading, self.heading)
        return Picture(name, self.length, high, middle, *axis, margins, heading, least)


class RowFrame(ABC, Generic[Shown]):
    """The graphs at their scale: the fields of their rows, their axes, their pole distances."""

    plate: RowPlate[Shown]
    spot: Spot

    @abstractmethod
    def drawn(self, row: Shown) -> Part:
        """Draw a row on its axes."""

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """All rows with their titles, then their poles."""
        return *map(self._headed, self.plate.rows), *self._poles()

    def _headed(self, row: Shown) -> Part:
        """Draw a row with its title and its scales over it, and what is told under these."""
        part, field, hand = self.drawn(row), self.fields[row.key], self.plate.hand
        over = field._replace(top=field.top + self.plate.over)
        head = caption(self.plate.title(row), joined(";  ", self.scales_of(row)), over, hand)
        low = complex(over.centre.real, over.top - hand.title - UNDER * hand.text)
        texts = (Text(low, text, hand.text, "middle", True) for text in self.plate.said(row))
        above, below = (tuple(telling(part.name, stroke) for stroke in strokes) for strokes in (head.strokes, texts))
        return part._replace(lines=(Group((Group(above), *below)), *part.lines))

    def scales_of(self, row: Shown) -> Iterator[str]:
        """Write the scale of a row, with the pole distance that it comes from."""
        if not row.flat:
            yield self.plate.drafting.scale(self.scales[row.key])
        distance = self.distance(row)
        if distance is not None:
            mm = self.plate.drafting.word("mm")
            yield joined("", (f"{self.plate.pole_letters(row)[1]} = ", self.pole_size(distance), f" {mm}"))

    def pole_size(self, distance: float) -> str:
        """Write a pole distance, mm."""
        return self.plate.drafting.number(distance)

    def _poles(self) -> Iterator[Part]:
        """Draw each pole beside the derivative of its two rows, and rays to the values that lie apart."""
        hand = self.plate.hand
        for above, row in pairwise(self.plate.rows):
            distance, shown = self.distance(row), above if self.plate.proportions.rises else row
            if distance is not None:
                axes, (x, y) = self.axes(shown), shown.rays
                off = 1j * (
                    OFF * hand.letter + shown.span[1] / axes.up.mu
                )  # above the highest ray, where the axis goes on
                pole = Pole(self.plate.pole_letters(row), distance, x, y, POLE_APART * hand.letter, off)
                yield pole.part(self.plate.named(f"{shown.key}-pole"), axes, hand)

    @property
    def argument(self) -> Scale:
        """The scale of what the rows are derivatives by, along the axis."""
        return self.spot.scale

    @property
    def length(self) -> float:
        """The length of the axis, mm."""
        return self.plate.length / self.spot.scale.mu

    @property
    def _high(self) -> float:
        """The height of all rows, mm: what their box leaves."""
        return self.spot.box.height - self.plate.top - self.plate.below

    @cached_property
    def fields(self) -> dict[str, Field]:
        """The fields of the rows' lines, as wide as the axis."""
        box, plate = self.spot.box, self.plate
        left = box.left + plate.proportions.left * plate.hand.letter
        return stacked(self.heights, left, box.top - plate.above, self.length, plate.over, plate.under)

    @cached_property
    def heights(self) -> dict[str, float]:
        """The heights of the rows, mm: what their graphs take at their scales, and a part of what is left."""
        taken = self._taken(tuple(self.scales.values()))
        spare = (self._high - sum(taken)) / len(taken)
        return {row.key: high + spare for row, high in zip(self.plate.rows, taken, strict=True)}

    def _taken(self, scales: Sequence[Scale]) -> list[float]:
        """Give what the rows take at some scales, mm."""
        spans = (row.span for row in self.plate.rows)
        return [(high - low) / scale.mu for (low, high), scale in zip(spans, scales, strict=True)]

    @cached_property
    def scales(self) -> dict[str, Scale]:
        """The largest scales together at which poles stand in the paper beside the rows and no row is too low."""
        steps = [list(self._steps(row)) for row in self.plate.rows]
        every = sorted(product(*steps), key=lambda scales: scales[0].mu * scales[1].mu * scales[2].mu)
        within = [scales for scales in every if sum(self._taken(scales)) <= self._high] or every
        best = min(within, key=lambda scales: (self._astray(scales), -self._lowest(scales)))
        return {row.key: scale for row, scale in zip(self.plate.rows, best, strict=True)}

    def _lowest(self, scales: Sequence[Scale]) -> float:
        """Give the height of the lowest row that has a course, mm, or what is high enough for any."""
        rows = zip(self.plate.rows, self._taken(scales), strict=True)
        return min(READ, *(high for row, high in rows if not row.flat))

    def _astray(self, scales: tuple[Scale, ...]) -> int:
        """Count the poles that would stand badly."""
        least, most = (bound * self.plate.hand.letter for bound in self.plate.proportions.pole)
        poles = (self._pole(k, scales) for k in range(1, len(scales)))
        return sum(not least <= pole <= most for pole in poles if pole is not None)

    def _pole(self, k: int, scales: Sequence[Scale]) -> float | None:
        """Give the distance, mm, of the pole between a row and the one above it: integral over derivative and step."""
        derivative, integral = (k - 1, k) if self.plate.proportions.rises else (k, k - 1)
        if self.plate.rows[derivative].flat:
            return None
        return scales[integral].mu / (scales[derivative].mu * self.argument.mu)

    def _steps(self, row: Shown) -> Iterator[Scale]:
        """Give the largest scale of a row, and some smaller ones."""
        low, high = row.span
        letter, standard = f"{{{row.letter}}}", self.plate.drafting.standard
        first = fitting(high - low, TALLEST * self._high, letter, row.unit, standard)
        return coarser(first, 0 if row.flat else self.plate.proportions.coarser, standard)

    def distance(self, row: Shown) -> float | None:
        """Give the distance, mm, of the pole by which a row is drawn from the one above it; None: there is none."""
        k = self.plate.place(row)
        return self._pole(k, tuple(self.scales.values())) if k else None

    def axes(self, row: Shown) -> Axes:
        """Stand a row in the middle of its field."""
        return level(self.fields[row.key], row.span, self.spot.scale, self.scales[row.key])


def stacked(
    heights: Mapping[str, float], left: float, top: float, wide: float, over: float, under: float
) -> dict[str, Field]:
    """Give the fields of rows one under another by their names, mm, with paper over and under each."""
    fields = {}
    for name, high in heights.items():
        top -= over
        fields[name] = Field(left, top - high, left + wide, top)
        top -= high + under
    return fields


def level(field: Field, span: tuple[float, float], across: Scale, up: Scale) -> Axes:
    """Stand axes at the left of a field, what they go over in the middle of its height."""
    low, high = span
    spare = field.height - (high - low) / up.mu
    return Axes(complex(field.left, field.bottom + spare / 2 - low / up.mu), across, up)


def coarser(scale: Scale, count: int, standard: str) -> Iterator[Scale]:
    """Give a standard scale, and so many smaller ones after it."""
    yield scale
    for _ in range(count):
        scale = fitting(scale.mu * LARGER, 1.0, scale.letter, scale.unit, standard)
        yield scale
