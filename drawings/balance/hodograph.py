"""The hodographs of the main vector of the inertia forces before and after, about one pole, at one scale (годограф)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from drawings.balance.graphs import told
from drawings.balance.scheme import AFTER, BEFORE
from drawings.kinds.axes import Letter, Part
from drawings.kinds.graph import DOT, LEAST, stretches
from drawings.kinds.hodograph import arrow, letter_beside, outward, pole_letter, pole_of, room_of
from drawings.layout.picture import Picture, Place, Spot
from drawings.lettering.vector_letters import FORCE
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, LineStyle, Polyline, Stroke
from drawings.symbols.figure import Subject, heading, heading_width
from plans.model.balance.linkage import State
from plans.model.motion import Complexes

NAME, SYMBOL, UNIT = "shaking", "F", "N"
LETTERS = 18.0  # it is drawn at least so many of its letters large: its positions are numbered
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

    def told(self, place: Place) -> bool:
        """Whether its positions bear numbers: their ends lie apart."""
        return place.length(self.spread) >= NUMBERED


class ShakingHodograph(NamedTuple):
    """The main vectors of the states that do not vanish, before and after, and the position that is shown."""

    vectors: tuple[MainVector, ...]
    shown: int
    whole: bool = True  # whether the crank turns fully: else the vectors are known at the positions alone

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        rows = [row for vector in self.vectors for row in (vector.values, vector.ends)]
        values = np.concatenate([np.zeros(1, np.complex128), *rows])
        return [complex(value) for value in values[~np.isnan(values.real)]]


def hodograph(states: Mapping[str, State], shown: int, nothing: float, whole: bool = True) -> ShakingHodograph:
    """Gather the main vectors of states by their names, over the turn and at the positions; none below `nothing` N."""
    seen = {name: state for name, state in states.items() if state.shaking > nothing}
    vectors = tuple(MainVector(name, state.around.force, _ends_of(state, shown)) for name, state in seen.items())
    return ShakingHodograph(vectors, shown, whole)


def _ends_of(state: State, shown: int) -> Complexes:
    """Give the main vectors at the positions that are told."""
    force = state.centre.force
    kept = np.isin(np.arange(len(force)), told(len(force), shown))
    return np.where(kept, force, np.nan + 0j)


def letter_of(state: str) -> str:
    """Letter the main vector of a state: after balancing it bears a prime."""
    return f"{FORCE}'" if state == AFTER else FORCE


def measure(shown: ShakingHodograph, drafting: Drafting) -> Picture:
    """Measure the room of the hodographs."""
    hand, title = drafting.hand, drafting.word("shaking hodograph")
    room = room_of(NAME, shown.points, (SYMBOL, UNIT), title, LETTERS, hand)
    return room._replace(heading=heading_width(title, hand))


def draw(shown: ShakingHodograph, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw the hodographs in their spot: thin before, in main lines after; title and scale above."""
    place, hand = room.place(*spot), drafting.hand
    both, subject = len(shown.vectors) > 1, Subject(NAME, SYMBOL, shown.shown)
    under = ";  ".join([drafting.scale(spot.scale), *([drafting.word("thin before")] if both else [])])
    lines: list[Stroke] = [heading(spot.box, drafting.word("shaking hodograph"), under, hand)]
    named, numbers = list[Letter](), list[Letter]()
    for vector in shown.vectors:
        end = complex(vector.ends[shown.shown])
        style = hand.other if both and vector.state == BEFORE else hand.result
        lines.append(Group(tuple(_curve(vector.values, place, style) if shown.whole else ()), f"{NAME}-{vector.state}"))
        lines += arrow(subject, letter_of(vector.state), end, place, hand)
        lines += _ends(vector, subject, place, hand)
        if place.length(abs(end)) > LEAST:  # not of a gap either
            named.append(letter_beside(letter_of(vector.state), end, place, hand))
        if vector.told(place):
            numbers += outward(vector.ends, np.flatnonzero(~np.isnan(vector.ends.real)).tolist(), place, hand)
    lines.append(pole_of(subject, place))
    return Part(NAME, tuple(lines), (pole_letter(place, hand), *named, *numbers))


def _curve(values: Complexes, place: Place, style: LineStyle) -> Iterator[Stroke]:
    """Draw the curve of the ends, broken at gaps; a whole turn comes back to its beginning by itself."""
    for run in stretches(values.real):
        yield Polyline(tuple(place.on(complex(values[k])) for k in run), False, style)


def _ends(vector: MainVector, subject: Subject, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Mark the ends at the positions by state and number; where these are told they can be measured."""
    for k, value in enumerate(vector.ends.tolist()):
        if not math.isnan(value.real):
            dot = Circle(place.on(value), DOT * hand.symbol, INK)
            data = subject._replace(position=k).data("point", f"{vector.state} {k}", value, place.scale)
            yield Group((dot,), "", data, str(k)) if vector.told(place) else dot
