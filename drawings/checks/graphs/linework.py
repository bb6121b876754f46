"""The lines, heads, dots and words of a figure: each that is due is there, and there is no other (линии и надписи)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from drawings.checks.graphs.figure_strokes import FLUSH, FigureStrokes, read
from drawings.checks.letters import along, leaders
from drawings.checks.wrong import Wrong, on
from drawings.paper.strokes import Arc, Line
from drawings.symbols.symbols import ARROW_LENGTH
from plans.model.motion import Complexes, Floats
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
        led = {id(line) for line, _ in leaders((self.strokes.group,))}
        return tuple(one for one in self.strokes.lines if id(one) not in led)

    def ways(self, due: Sequence[Way], but: Collection[int] = ()) -> Iterator[Wrong]:
        """See that each line that is due is drawn along its whole length, and that no line lies elsewhere.

        `but` are the identities of lines that are held by themselves.
        """
        yield from self.missing(due)
        lines = [one for one in self.lines if id(one) not in but]
        known = np.zeros(len(lines), dtype=bool)
        places = _places(lines)
        for one in due:
            known |= _along(one, places).within(one)
        if not known.all():
            yield on("line", self.plan)

    def missing(self, due: Sequence[Way]) -> Iterator[Wrong]:
        """See that each line that is due is drawn, whatever else there is."""
        places = _places(self.lines)
        for one in (one for one in due if one.due):
            if abs(one.end - one.start) - _along(one, places).covered(one) > one.hidden:
                yield on("line_named", self.plan, name=one.name)

    def dimensions(self, due: Iterable[Dimensioned]) -> Iterator[Way | Wrong]:
        """Give the lines of dimensions, and tell of those that are missing or lack arrows or letters."""
        for one in due:
            lettered = (ends for ends in self._level(one) if self._lettered(one.letter, ends))
            found = next(lettered, None)
            if found is None:
                yield on("size", self.plan, name=one.letter)
                continue
            yield Way(one.letter, *found, OUTER * ARROW_LENGTH * self.symbol)
            yield from (
                Way(one.letter, start, end, PAST) for start, end in zip((one.start, one.end), found, strict=True)
            )
            if not all(self._arrowed(*ends) for ends in (found, found[::-1])):
                yield on("size", self.plan, name=one.letter)

    def _lettered(self, letter: str, ends: tuple[complex, complex]) -> bool:
        return self.strokes.lettered(letter, along(*ends))

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
        if not length:
            return False
        own = [back for end, back in self.tips if abs(end - tip) <= FLUSH]
        if length <= 3 * ARROW_LENGTH * self.symbol + FLUSH:
            return any(abs(((back - tip) / (tip - start)).imag) <= LEAN for back in own)
        return any(abs((back - tip) / (start - tip) * length - abs(back - tip)) <= LEAN for back in own)

    @cached_property
    def tips(self) -> tuple[tuple[complex, complex], ...]:
        """The tips of straight arrowheads, and the middles of their backs."""
        triangles = (one for one in self.strokes.heads if len(one.points) == 3)
        found = ((one.points[0], (one.points[1] + one.points[2]) / 2) for one in triangles)
        return tuple((tip, back) for tip, back in found if tip != back)

    def headed(self, tip: complex) -> bool:
        """Tell whether an arrowhead stands at a place, along a line that is drawn."""
        return any(abs(own - tip) <= FLUSH and self._lies(own, back) for own, back in self.tips)

    def _lies(self, tip: complex, back: complex) -> bool:
        return bool(self.strokes.through(back, tip - back, LEAN))

    def heads(self, but: Collection[complex] = ()) -> Iterator[Wrong]:
        """See that each head lies along a line or an arc, and points to where that ends, `but` those at some places."""
        bent = [one for one in self.strokes.plain if isinstance(one, Arc)]
        for tip, back in self.tips:
            curved = any(abs(abs(back - one.centre) - one.radius) <= FLUSH and _ends(one, back) for one in bent)
            if not (curved or self._pointing(tip, back) or any(abs(tip - one) <= FLUSH for one in but)):
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


def _ends(arc: Arc, spot: complex) -> bool:
    return min(abs(arc.at(share) - spot) for share in (0.0, 1.0)) <= FLUSH


class _Along(NamedTuple):
    """Drawn lines by where they lie along a way: whether on it, from where and to where, mm, (n,) each."""

    level: npt.NDArray[np.bool_]
    low: Floats
    high: Floats

    def within(self, way: Way) -> npt.NDArray[np.bool_]:
        """Tell which lines lie on the way and go no farther than it may."""
        length = abs(way.end - way.start)
        held = (self.low >= -way.beyond - FLUSH) & (self.high <= length + way.beyond + FLUSH)
        return np.asarray(self.level & held)

    def covered(self, way: Way) -> float:
        """Give how much of the way is drawn, mm, by pieces that may overlap."""
        length, reached, whole = abs(way.end - way.start), 0.0, 0.0
        for start, end in sorted(zip(self.low[self.level].tolist(), self.high[self.level].tolist(), strict=True)):
            whole += max(min(end, length) - max(start, reached), 0.0)
            reached = max(reached, min(end, length))
        return whole


def _places(lines: Sequence[Line]) -> tuple[Complexes, Complexes]:
    """Give where lines begin and end, mm, (n,) each."""
    starts, ends = (np.array([getattr(one, end) for one in lines], dtype=complex) for end in ("start", "end"))
    return starts, ends


def _along(way: Way, places: tuple[Complexes, Complexes]) -> _Along:
    starts, ends = places
    run = way.end - way.start
    back = np.conj(run / abs(run)) if run else 1.0
    first, last = (starts - way.start) * back, (ends - way.start) * back
    level = np.maximum(np.abs(first.imag), np.abs(last.imag)) <= FLUSH
    return _Along(level, np.minimum(first.real, last.real), np.maximum(first.real, last.real))
