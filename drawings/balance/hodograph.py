"""The hodographs of the main vector of the inertia forces before and after, about one pole, at one scale (годограф)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.balance.graphs import told
from drawings.balance.scheme import AFTER, BEFORE
from drawings.kinds.graph import stretches
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.vector_letters import FORCE
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, LEAN, Circle, Group, LineStyle, Polyline, Stroke, Text
from drawings.symbols.figure import Subject, heading, point, vector
from drawings.symbols.symbols import pole
from plans.model.balance.linkage import State
from plans.model.motion import Complexes

NAME, SYMBOL, UNIT, POLE = "shaking", "F", "N", "o"
MARGINS = Margins(2.6, 2.0, 2.0)  # paper around it for its letters, in their sizes
LETTERS = 18.0  # it is drawn at least so many of its letters large: its positions are numbered
DOT = 0.7  # mm, radius of a position's point
LEAST = 0.05  # mm: a shorter vector is a point
NUMBERED = 4.0  # mm: the ends of a smaller curve fall together, and bear no numbers


class MainVector(NamedTuple):
    """The main vector N of one state: densely over the turn, and at the numbered positions; NaN is a gap."""

    state: str
    values: Complexes
    ends: Complexes

    @property
    def spread(self) -> float:
        """How far its curve reaches, N: the larger side of the box about it."""
        known = self.values[~np.isnan(self.values.real)]
        return max((float(np.ptp(row)) for row in (known.real, known.imag)), default=0.0) if known.size else 0.0


class ShakingHodograph(NamedTuple):
    """The main vectors of the states that do not vanish, before and after, and the position that is shown."""

    vectors: tuple[MainVector, ...]
    shown: int
    whole: bool = True  # whether the crank turns fully: else the vectors are known at the positions alone

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        rows = [row for one in self.vectors for row in (one.values, one.ends)]
        values = np.concatenate([np.zeros(1, np.complex128), *rows])
        return [complex(value) for value in values[~np.isnan(values.real)]]


def hodograph(states: Mapping[str, State], shown: int, nothing: float, whole: bool = True) -> ShakingHodograph:
    """Gather the main vectors of states by their names, over the turn and at the positions; none below `nothing` N."""
    seen = {name: one for name, one in states.items() if one.shaking > nothing}
    vectors = tuple(MainVector(name, one.around.force, _ends_of(one, shown)) for name, one in seen.items())
    return ShakingHodograph(vectors, shown, whole)


def _ends_of(state: State, shown: int) -> Complexes:
    """Give the main vectors at the positions that are told."""
    force = state.centre.force
    kept = np.isin(np.arange(len(force)), told(len(force), shown))
    return np.where(kept, force, np.nan + 0j)


@dataclass(frozen=True)
class ShakingFigure:
    """The hodographs placed on paper: their lines, and the letters still to be placed."""

    shown: ShakingHodograph
    place: Place
    lines: tuple[Stroke, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure: the pole, the shown vectors lettered, the positions numbered outward."""
        hand = self.drafting.hand
        found = [labels.beside(self.place.on(0j), POLE, hand.letter, 1.6, -math.pi / 4)]
        for one in self.shown.vectors:
            found += self._vector(one, labels)
        for one in self.shown.vectors:
            found += self._numbers(one, labels)
        return (Group((*self.lines, Group(tuple(found))), NAME),)

    def _vector(self, one: MainVector, labels: Labels) -> Iterator[Stroke]:
        end = complex(one.ends[self.shown.shown])
        if self.place.length(abs(end)) > LEAST:  # not of a gap either
            middle, letter = self.place.on(end / 2), letter_of(one.state)
            yield labels.beside(middle, letter, self.drafting.hand.letter, 1.2, cmath.phase(1j * end))

    def _numbers(self, one: MainVector, labels: Labels) -> Iterator[Stroke]:
        if self.place.length(one.spread) < NUMBERED:
            return
        heart = complex(np.nanmean(one.ends))
        for k, value in enumerate(one.ends.tolist()):
            if not math.isnan(value.real):
                side = cmath.phase(value - heart) if value != heart else math.pi / 4
                yield labels.beside(self.place.on(value), str(k), self.drafting.hand.number, 1.2, side)


def letter_of(state: str) -> str:
    """Letter the main vector of a state: after balancing it bears a prime."""
    return f"{FORCE}'" if state == AFTER else FORCE


def measure(shown: ShakingHodograph, drafting: Drafting) -> Picture:
    """Measure the room of the hodographs."""
    hand = drafting.hand
    side, below, above = (size * hand.letter for size in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    title = text_width(Text(0j, drafting.word("shaking hodograph"), hand.title)) + 2 * LEAN * hand.title
    return picture(NAME, shown.points, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)


def draw(shown: ShakingHodograph, room: Picture, spot: Spot, drafting: Drafting) -> ShakingFigure:
    """Draw the hodographs in their spot: thin before, in main lines after; title and scale above."""
    place, hand = room.place(*spot), drafting.hand
    scale = drafting.scale(spot.scale)
    both = len(shown.vectors) > 1
    under = ";  ".join([scale, *([drafting.word("thin before")] if both else [])])
    lines: list[Stroke] = [heading(spot.box, drafting.word("shaking hodograph"), under, hand)]
    for one in shown.vectors:
        style = hand.other if both and one.state == BEFORE else hand.result
        curve = Group(tuple(_curve(one.values, place, style) if shown.whole else ()), f"{NAME}-{one.state}")
        lines += [curve, *_ends(one, shown.shown, place, hand)]
    lines.append(point(_subject(None), POLE, 0j, place, pole(place.on(0j)), "pole"))
    return ShakingFigure(shown, place, tuple(lines), drafting)


def _subject(position: int | None) -> Subject:
    return Subject(NAME, SYMBOL, position)


def _curve(values: Complexes, place: Place, style: LineStyle) -> Iterator[Stroke]:
    """Draw the curve of the ends, broken at gaps; a whole turn comes back to its beginning by itself."""
    for run in stretches(values.real):
        yield Polyline(tuple(place.on(complex(values[k])) for k in run), False, style)


def _ends(one: MainVector, shown: int, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the shown vector, and mark the ends at the positions by state and number; all can be measured."""
    end = complex(one.ends[shown])
    if place.length(abs(end)) > LEAST:
        yield vector(_subject(shown), letter_of(one.state), (0j, end), place, hand.relative, hand.symbol)
    for k, value in enumerate(one.ends.tolist()):
        if not math.isnan(value.real):
            dot = Circle(place.on(value), DOT * hand.symbol, INK)
            data = _subject(k).data("point", f"{one.state} {k}", value, place.scale)
            yield Group((dot,), "", data, str(k)) if place.length(one.spread) >= NUMBERED else dot
