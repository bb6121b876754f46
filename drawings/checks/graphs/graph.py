"""A graph on a sheet: its ordinates that can be measured, where a value of it lies, what is told of it (график)."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from drawings.checks.graphs.figure_strokes import NEAR, FigureStrokes, read
from drawings.checks.precise import KNOWN, tells
from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from plans.words.words import message

PER_CENT = 2  # digits of how far chords are off


class Graph(ABC):
    """A graph as it is laid out, by its strokes and by what was measured."""

    strokes: FigureStrokes
    measured: Measured
    along: float  # scale of the abscissas, true units a mm
    drafting: Drafting

    @property
    @abstractmethod
    def name(self) -> str:
        """The name of the part of the figure."""

    @property
    @abstractmethod
    def mu(self) -> float:
        """The scale of the ordinates, true units a mm."""

    @cached_property
    def marks(self) -> Mapping[int, MeasuredVector]:
        """The ordinates by their positions."""
        own = (one for one in self.measured.vectors if one.plan == self.name and one.position is not None)
        return {one.position: one for one in own if one.position is not None}

    @cached_property
    def zero(self) -> complex:
        """The beginning of the axis of abscissas on paper, mm."""
        axis = (one for one in self.strokes.pointings if abs((one.tip - one.start).imag) <= NEAR)
        return next((one.start for one in axis), complex("nan"))

    def axes(self) -> Iterator[Wrong]:
        """See that the axis of abscissas and the upright one through its beginning have their arrowheads."""
        upright = (one for one in self.strokes.pointings if abs((one.tip - one.start).real) <= NEAR)
        if not any(one.tip.imag > one.start.imag and abs((one.start - self.zero).real) <= NEAR for one in upright):
            yield on("line", self.name)
        level = (one for one in self.strokes.pointings if abs((one.tip - one.start).imag) <= NEAR)
        if not any(one.tip.real > one.start.real for one in level):
            yield on("line", self.name)

    def on(self, turned: float, value: float = 0.0) -> complex:
        """Give the place on paper of a value, mm."""
        return complex(self.zero + turned / self.along + 1j * value / self.mu)

    def told(self, seen: Sequence[str], due: Sequence[str]) -> Iterator[Wrong]:
        """Hold texts to those that are due, their numbers to the digits of shares in per cent."""
        if len(seen) != len(due) or not all(
            tells(one, read(true), (PER_CENT,), KNOWN) for one, true in zip(seen, due, strict=True)
        ):
            yield message("wrong.told", text="; ".join(seen) or due[0])
