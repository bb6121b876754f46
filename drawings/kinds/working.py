"""A working: how a value follows from what is measured, beside its figure; of segments by their scale (вычисления)."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.layout.contents import Panel
from drawings.layout.equation import EquationBlock, plain
from drawings.layout.picture import Spot
from drawings.page.page import Drafting, Field, Scale
from drawings.paper.strokes import Group

READING, LENGTHS, MASSES = "reading", "lengths", "masses"  # what workings tell: before the name of their figure
SEGMENTS, SCALES, TANGENTS = "segments", "scales", "tangents"
DIGITS = 4
WIDEST = "0.08888"  # of a number before it is known at what scale the figure is drawn


class ScaleFactor(NamedTuple):
    """A scale as it stands in a product: true size over paper, or paper over true size."""

    scale: Scale | None  # None: not known yet
    letter: str
    drafting: Drafting

    def true(self, segment: str) -> str:
        """Write in letters how a true size is read off a segment."""
        return f"{segment}/K_{{{self.letter}}}" if self._k else f"{segment}·μ_{{{self.letter}}}"

    def drawn(self, letter: str) -> str:
        """Write in letters how a true size is laid off."""
        return f"{letter}·K_{{{self.letter}}}" if self._k else f"{letter}/μ_{{{self.letter}}}"

    def of_drawn(self, size: float) -> str:
        """Write in numbers how a true size is read off a segment that shows it."""
        return f"{self.length(size)}{'/' if self._k else '·'}{self._number}"

    def of_true(self, size: float) -> str:
        """Write in numbers how a true size is laid off."""
        return f"{self.drafting.number(size, DIGITS)}{'·' if self._k else '/'}{self._number}"

    def length(self, size: float) -> str:
        """Write the length of a segment, mm, that shows a true size."""
        return WIDEST if self.scale is None else self.drafting.number(size / self.scale.mu, DIGITS)

    @property
    def _k(self) -> bool:
        return self.drafting.notation == "K"

    @property
    def _number(self) -> str:
        if self.scale is None:
            return WIDEST
        return self.drafting.number(1 / self.scale.mu if self._k else self.scale.mu)


Lines = Callable[[Spot | None], Sequence[tuple[str, ...]]]  # where a figure stands; None: not known yet


class Workings(NamedTuple):
    """The lines of a kind beside a figure, by its name; they are written by where the figure stands."""

    kind: str
    of: str
    lines: Lines
    drafting: Drafting

    @property
    def panel(self) -> Panel:
        """Measure it with the widest numbers."""
        return Panel(self._passage(None).block())

    def write(self, box: Field, spot: Spot) -> Group:
        """Write it in its box."""
        return self._passage(spot).write(box, self.drafting.hand)

    def _passage(self, spot: Spot | None) -> EquationBlock:
        lines = tuple(plain(first, *(f"= {part}" for part in more)) for first, *more in self.lines(spot))
        return EquationBlock(f"{self.kind}-{self.of}", lines, self.drafting.hand.text, 0.0)


def amount(value: float, drafting: Drafting) -> str:
    """Write a number; NaN, which is not known yet, as the widest."""
    return WIDEST if math.isnan(value) else drafting.number(value, DIGITS)


def at_scale(lines: Callable[[Scale | None], Sequence[tuple[str, ...]]]) -> Lines:
    """Let lines be written by the scale of their figure alone."""
    return lambda spot: lines(None if spot is None else spot.scale)


def segment_working(
    sizes: Mapping[str, float], symbol: str, name: str, drafting: Drafting, shortest: float = 0.0
) -> Workings:
    """Write beside a polygon how long its vectors are drawn, but those shorter than the `shortest`, mm."""
    lines = at_scale(lambda scale: list(_rows(_shown(sizes, scale, shortest), ScaleFactor(scale, symbol, drafting))))
    return Workings(SEGMENTS, name, lines, drafting)


def reading(
    sizes: Mapping[str, float], symbol: str, unit: str, name: str, drafting: Drafting, shortest: float
) -> Workings:
    """Write beside a polygon how large the vectors are that it gives; those that are not to be seen are passed over."""
    lines = at_scale(
        lambda scale: list(_read(_shown(sizes, scale, shortest), unit, ScaleFactor(scale, symbol, drafting)))
    )
    return Workings(READING, name, lines, drafting)


def _shown(sizes: Mapping[str, float], scale: Scale | None, shortest: float) -> dict[str, float]:
    """Give the vectors that are long enough on paper; all before their scale is known."""
    return {letter: size for letter, size in sizes.items() if scale is None or size >= shortest * scale.mu}


def _rows(sizes: Mapping[str, float], factor: ScaleFactor) -> Iterator[tuple[str, ...]]:
    mm = factor.drafting.word("mm")
    for letter, size in sizes.items():
        yield f"[{letter}] = {factor.drawn(letter)}", factor.of_true(size), f"{factor.length(size)} {mm}"


def _read(sizes: Mapping[str, float], unit: str, factor: ScaleFactor) -> Iterator[tuple[str, ...]]:
    drafting = factor.drafting
    for letter, size in sizes.items():
        amount = f"{drafting.number(size, DIGITS)} {drafting.word(unit)}"
        yield f"{letter} = {factor.true(f'[{letter}]')}", factor.of_drawn(size), amount
