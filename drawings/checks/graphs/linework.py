"""The lines, heads, dots and words of a figure: each that is due is there, and there is no other (линии и надписи)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.checks.graphs.figure_strokes import FLUSH, FigureStrokes, read
from drawings.checks.wrong import Wrong, on
from drawings.paper.strokes import Arc, Group, Line, Text
from drawings.paper.walk import groups
from drawings.symbols.symbols import ARROW_LENGTH
from plans.words.words import message

FAR = 500.0  # mm: no line of a figure goes farther beyond what it must reach
OUTER = 2.0  # lengths of an arrowhead that the line of an outer arrow goes beyond a dimension
PAST = 1.5  # mm that an extension line goes past its dimension
LEAN = 1e-3  # by which a head may lean from its line: its corners are rounded


class Way(NamedTuple):
    """A straight line by the analysis: its ends on paper, mm, how far it may go on, how much of it may be hidden, mm.

    One that is not `due` may be missing.
    """

    name: str
    start: complex
    end: complex
    beyond: float = 0.0
    due: bool = True
    hidden: float = FLUSH


class Dimensioned(NamedTuple):
    """A distance that must be dimensioned: its letters, its ends on paper, mm, the direction to its line or against."""

    letter: str
    start: complex
    end: complex
    off: complex


@dataclass(frozen=True)
class Linework:
    """All that one figure draws straight or writes, under the name by which it is told of."""

    plan: str
    strokes: FigureStrokes
    symbol: float  # factor of the hand's symbols

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """The straight lines but leaders of letters."""
        leaders = {id(one.strokes[0]) for one in groups((self.strokes.group,)) if _leads(one)}
        return tuple(one for one in self.strokes.lines if id(one) not in leaders)

    def ways(self, due: Sequence[Way]) -> Iterator[Wrong]:
        """See that each line that is due is drawn along its whole length, and that no line lies elsewhere."""
        starts, ends = (np.array([getattr(one, end) for one in self.lines], dtype=complex) for end in ("start", "end"))
        known = np.zeros(len(self.lines), dtype=bool)
        for one in due:
            run = one.end - one.start
            length = abs(run)
            along = run / length if length else 1.0 + 0j
            first, last = ((spots - one.start) * np.conj(along) for spots in (starts, ends))
            level = np.maximum(np.abs(first.imag), np.abs(last.imag)) <= FLUSH
            low, high = np.minimum(first.real, last.real), np.maximum(first.real, last.real)
            within = level & (low >= -one.beyond - FLUSH) & (high <= length + one.beyond + FLUSH)
            known |= within
            if one.due and length - _covered(low[level], high[level], length) > one.hidden:
                yield on("line_named", self.plan, name=one.name)
        if not known.all():
            yield on("line", self.plan)

    def dimensions(self, due: Iterable[Dimensioned]) -> Iterator[Way | Wrong]:
        """Give the lines of dimensions, and tell of those that are missing or lack arrows or letters."""
        for one in due:
            found = next(iter(self._level(one)), None)
            if found is None or not self.strokes.lettered(one.letter, [(found[0] + found[1]) / 2]):
                yield on("size", self.plan, name=one.letter)
                continue
            yield Way(one.letter, *found, OUTER * ARROW_LENGTH * self.symbol)
            yield from (
                Way(one.letter, start, end, PAST) for start, end in zip((one.start, one.end), found, strict=True)
            )
            if not all(self._arrowed(*ends) for ends in (found, found[::-1])):
                yield on("size", self.plan, name=one.letter)

    def _level(self, one: Dimensioned) -> Iterator[tuple[complex, complex]]:
        """Give the lines beside a distance, as long as it is."""
        for line in self.lines:
            for ends in ((line.start, line.end), (line.end, line.start)):
                off = [(end - own) * one.off.conjugate() for end, own in zip(ends, (one.start, one.end), strict=True)]
                flat = max(abs(each.imag) for each in off) <= FLUSH * abs(one.off)
                if flat and abs(off[0] - off[1]) <= FLUSH * abs(one.off) and abs(off[0]) > FLUSH:
                    yield ends

    def _arrowed(self, start: complex, tip: complex) -> bool:
        """Tell whether a dimension's line has its arrow at an end, within where there is room for two."""
        length = abs(tip - start)
        own = [back for end, back in self.tips if abs(end - tip) <= FLUSH]
        if length <= 3 * ARROW_LENGTH * self.symbol + FLUSH:
            return any(abs(((back - tip) / (tip - start)).imag) <= LEAN for back in own)
        return any(abs((back - tip) / (start - tip) * length - abs(back - tip)) <= LEAN for back in own)

    @cached_property
    def tips(self) -> tuple[tuple[complex, complex], ...]:
        """The tips of straight arrowheads, and the middles of their backs."""
        triangles = (one for one in self.strokes.heads if len(one.points) == 3)
        return tuple((one.points[0], (one.points[1] + one.points[2]) / 2) for one in triangles)

    def headed(self, tip: complex) -> bool:
        """Tell whether an arrowhead stands at a place, along a line that is drawn."""
        return any(abs(own - tip) <= FLUSH and self._lies(own, back) for own, back in self.tips)

    def _lies(self, tip: complex, back: complex) -> bool:
        return bool(self.strokes.through(back, tip - back, LEAN))

    def heads(self) -> Iterator[Wrong]:
        """See that each head lies along a line or an arc, and points to where that ends."""
        bent = [one for one in self.strokes.plain if isinstance(one, Arc)]
        for tip, back in self.tips:
            curved = any(abs(abs(back - one.centre) - one.radius) <= FLUSH and _ends(one, back) for one in bent)
            if not curved and not self._pointing(tip, back):
                yield on("head", self.plan, name=f"({tip.real:.0f}, {tip.imag:.0f})")

    def _pointing(self, tip: complex, back: complex) -> bool:
        lines = self.strokes.lines  # an outer arrow of a dimension lies along a line of its own
        ended = any(min(abs(tip - one.start), abs(tip - one.end)) <= FLUSH for one in lines)
        return ended and self._lies(tip, back)

    def words(self, due: Collection[str], others: Collection[str] = ()) -> Iterator[Wrong]:
        """See that each text that is due is written, as often as it is due, and none that is neither due nor known."""
        left = [read(one) for one in due]
        known = {*left, *map(read, others)}
        for text in self.strokes.texts:
            parts = [text] if text in known else text.split(", ")
            for part in parts:
                if part in left:
                    left.remove(part)
                elif part not in known:
                    yield message("wrong.told", text=text)
        yield from (message("wrong.missing", name=one) for one in left)

    def dots(self, name: str, spots: Iterable[complex]) -> Iterator[Wrong]:
        """See that every whole circle is about one of some places."""
        known = np.array([*spots], dtype=complex)
        for one in self.strokes.circles:
            if not known.size or np.abs(known - one.centre).min() > FLUSH:
                yield on("stranger_on", self.plan, name=name)


def _leads(one: Group) -> bool:
    return len(one.strokes) == 2 and isinstance(one.strokes[0], Line) and isinstance(one.strokes[1], Text)


def _ends(arc: Arc, spot: complex) -> bool:
    return min(abs(arc.at(share) - spot) for share in (0.0, 1.0)) <= FLUSH


def _covered(low: np.ndarray, high: np.ndarray, length: float) -> float:
    """Give how much of a line is drawn, mm, by pieces that may overlap."""
    reached = covered = 0.0
    for start, end in sorted(zip(low.tolist(), high.tolist(), strict=True)):
        first, last = max(start, reached), min(end, length)
        if last > first:
            covered += last - first
        reached = max(reached, min(end, length))
    return covered
