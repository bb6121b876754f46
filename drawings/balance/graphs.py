"""Graphs of a balanced machine: hodographs before and after, rocking moment, forces over the share (графики)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from drawings.balance.scheme import AFTER, BEFORE
from drawings.kinds.axes import Letter, Part
from drawings.kinds.curve_graph import TURN, GraphCurve, bounded, swing
from drawings.kinds.graph import BESIDE, LEAST, Graph, GraphForm, standing, stretches
from drawings.kinds.graph import DOT as END
from drawings.kinds.hodograph import arrow, letter_beside, outward, pole_letter, pole_of, room_of
from drawings.layout.picture import Margins, Picture, Place, Spot
from drawings.lettering.words import FORCE, MOMENT, Phrase, Slot, joined
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import Hand
from drawings.paper.limits import MANY
from drawings.paper.strokes import INK, Circle, Group, Kind, Line, LineStyle, Polyline, Statement, Stroke
from drawings.symbols.figure import Subject, explained, heading, heading_width
from drawings.symbols.symbols import TICK, fit
from plans.model.balance.linkage import Choice, Shares, State
from plans.model.motion import Complexes, Floats

ROOMY = 3 * MANY  # positions that all have room


def numbered(count: int, shown: int) -> tuple[int, ...]:
    """Choose the positions that are told.

    >>> numbered(12, 2) == tuple(range(12)), numbered(72, 1)[:4]
    (True, (0, 1, 6, 12))
    """
    every = 1 if count <= ROOMY else math.ceil(count / MANY)
    return tuple(k for k in range(count) if k % every == 0 or k == shown)


SHAKING, SYMBOL, UNIT = "shaking", "F", "N"
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

    def lettered(self, place: Place) -> bool:
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

    def measure(self, drafting: Drafting) -> Picture:
        """Measure the room of the hodographs."""
        hand, title = drafting.hand, drafting.word("shaking hodograph")
        room = room_of(SHAKING, self.points, (SYMBOL, UNIT), title, LETTERS, hand)
        return explained(room._replace(heading=heading_width(title, hand)), self._further(drafting), hand)

    def _further(self, drafting: Drafting) -> list[str]:
        return [drafting.word("thin before")] if len(self.vectors) > 1 else []

    def draw(self, room: Picture, spot: Spot, drafting: Drafting) -> Part:
        """Draw the hodographs in their spot: thin before, in main lines after; title and scale above."""
        place, hand = room.place(*spot), drafting.hand
        both, subject = len(self.vectors) > 1, Subject(SHAKING, SYMBOL, self.shown)
        title, said = drafting.word("shaking hodograph"), (drafting.scale(spot.scale), *self._further(drafting))
        lines: list[Stroke] = [heading(spot.box, title, said[0], hand, *said[1:])]
        named, numbers = list[Letter](), list[Letter]()
        for vector in self.vectors:
            end = complex(vector.ends[self.shown])
            style = hand.other if both and vector.state == BEFORE else hand.result
            curve = _ends_curve(vector.values, place, style) if self.whole else ()
            lines.append(Group(tuple(curve), f"{SHAKING}-{vector.state}"))
            lines += arrow(subject, vector_letter(vector.state), end, place, hand)
            lines += _ends(vector, subject, place, hand)
            if place.length(abs(end)) > LEAST:  # not of a gap either
                named.append(letter_beside(vector_letter(vector.state), end, place, hand))
            if vector.lettered(place):
                numbers += outward(vector.ends, np.flatnonzero(~np.isnan(vector.ends.real)).tolist(), place, hand)
        lines.append(pole_of(subject, place))
        return Part(SHAKING, tuple(lines), (pole_letter(place, hand), *named, *numbers))


def hodograph(states: Mapping[str, State], shown: int, nothing: float, whole: bool = True) -> ShakingHodograph:
    """Gather the main vectors of states by their names, over the turn and at the positions; none below `nothing` N."""
    drawn = {name: state for name, state in states.items() if state.shaking > nothing}
    vectors = tuple(MainVector(name, state.around.force, _ends_of(state, shown)) for name, state in drawn.items())
    return ShakingHodograph(vectors, shown, whole)


def _ends_of(state: State, shown: int) -> Complexes:
    force = state.centre.force
    kept = np.isin(np.arange(len(force)), numbered(len(force), shown))
    return np.where(kept, force, np.nan + 0j)


def vector_letter(state: str) -> str:
    """Letter the main vector of a state: after balancing it bears a prime."""
    return f"{FORCE}'" if state == AFTER else FORCE


def _ends_curve(values: Complexes, place: Place, style: LineStyle) -> Iterator[Stroke]:
    """Draw the curve of the ends, broken at gaps; a whole turn comes back to its beginning by itself."""
    for run in stretches(values.real):
        yield Polyline(tuple(place.on(complex(values[k])) for k in run), False, style)


def _ends(vector: MainVector, subject: Subject, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Mark the ends at the positions by state and number; where these are told they can be measured."""
    for k, value in enumerate(vector.ends.tolist()):
        if not math.isnan(value.real):
            dot = Circle(place.on(value), END * hand.symbol, INK)
            data = subject._replace(position=k).data("point", f"{vector.state} {k}", value, place.scale)
            yield Group((dot,), "", data, str(k)) if vector.lettered(place) else dot


ROCKING = "rocking"


def curve(
    states: Mapping[str, State], sense: int, shown: int, least: float, drafting: Drafting, point: str
) -> GraphCurve | None:
    """Give the main moments about a point, of a swing at its positions alone; None where all are below `least` N*m."""
    first, last = next(iter(states.values())), list(states.values())[-1]
    if max(first.rocking, last.rocking) <= least or len(last.centre.phi) < 2:
        return None
    numbers = numbered(len(last.centre.phi), shown)
    stations = np.degrees(sense * (last.centre.phi - last.centre.phi[0]))[list(numbers)] % TURN
    ordinates, title = _visible(last.centre.moment, least)[list(numbers)], drafting.word("rocking graph", point=point)
    bare = GraphCurve(MOMENT, "N*m", np.array([0.0, TURN]), np.full(2, np.nan), stations, ordinates, title)
    bare = bare._replace(numbers=numbers, name=ROCKING)
    if not last.whole:
        swung = swing(bare)
        return swung._replace(values=np.full(len(swung.values), np.nan))
    angles = np.degrees(sense * (last.around.phi - last.around.phi[0]))
    gaps = any(np.isnan(state.around.moment).any() for state in (first, last))  # beside one a curve is cut off
    whole = bare._replace(angles=angles, values=_course(last, least), states="" if gaps else "last")
    return whole if last is first else whole._replace(before=_course(first, least))


def _course(state: State, least: float) -> Floats:
    return np.asarray(bounded(_visible(state.around.moment, least), _visible(state.centre.moment, least)))


def _visible(moments: Floats, least: float) -> Floats:
    return np.where(np.abs(moments) <= least, 0.0, moments)


SHARES = "shares"
SHARE, ONE = "k", "1"  # the letter and the unit of the share
FORCES, REACTIONS, TAKEN, BARE = "force", "reaction", "taken", "bare"  # curves, the share taken, no counterweights
FORM = GraphForm(1.5, 1.5, Margins(3.6, 2.6, 0.8), 20.0)
DIVISIONS = 4  # of the whole share, with numbers
LEVEL = 20.0  # mm from one numbered force to the next: a whole number of newtons at standard scales from 0.05 on
DOT = 1.0  # mm, radius of the points of the least values


class ShareGraph(NamedTuple):
    """The curves of the choice, the share that was taken, and the letter of the shaft's reaction."""

    shares: Shares
    taken: float
    reaction: str  # marked up: "R_{01}"
    bare: float = 0.0  # the largest reaction N of the shaft without counterweights

    @property
    def rows(self) -> dict[str, list[tuple[float, float]]]:
        """Both curves with their least places among their points."""
        choices = (*self.shares.curve, *self.best.values())
        return {name: sorted({(one.share, value_of(one, name)) for one in choices}) for name in (FORCES, REACTIONS)}

    @property
    def best(self) -> dict[str, Choice]:
        """Where each is least."""
        return {FORCES: self.shares.least_force, REACTIONS: self.shares.least_reaction}

    @property
    def high(self) -> float:
        """The largest value, N."""
        return max(self.bare, *(value for row in self.rows.values() for _, value in row))

    def measure(self, drafting: Drafting) -> Picture:
        """Measure the room of the graph: its scale is that of the share."""
        hand, title = drafting.hand, drafting.word("share graph")
        return FORM.room(SHARES, 1.0, (SHARE, ONE), title, hand)._replace(heading=heading_width(title, hand))

    def draw(self, room: Picture, spot: Spot, drafting: Drafting) -> Part:
        """Draw the graph in its spot: axes, both curves, their least places, the share that was taken dashed."""
        hand, high = drafting.hand, self.high
        axes = standing(room, spot, (0.0, high), (SYMBOL, UNIT), drafting)
        graph = Graph(SHARES, axes, hand)
        start, end = axes.on(self.taken), axes.on(self.taken, self.high)
        levelled = (axes.on(0.0, force) for force in levels(high, axes.up))
        lines = (
            heading(spot.box, drafting.word("share graph"), drafting.scale(spot.scale, axes.up), hand),
            *axes.lines((0.0, 1.0), (0.0, high), hand, SHARES),
            *(graph.tick(k / DIVISIONS, hand.other) for k in range(1, DIVISIONS + 1)),
            *(Line(at - TICK, at + TICK, hand.other) for at in levelled),
            Group((Line(start, end, fit(hand.path, abs(end - start))),), f"{SHARES}-{TAKEN}"),
            Group((Line(axes.on(0.0, self.bare), axes.on(1.0, self.bare), hand.other),), f"{SHARES}-{BARE}"),
            *(part for name in (FORCES, REACTIONS) for part in _curve(self, name, graph, drafting)),
        )
        ends = graph.ends((1.0, SHARE), (high, drafting.word(UNIT)))
        return Part(SHARES, lines, (*ends, *_letters(self, graph, drafting)))


def value_of(choice: Choice, name: str) -> float:
    """Give what is largest with a share, N: by the name of a curve."""
    return choice.force if name == FORCES else choice.reaction


def _curve(shown: ShareGraph, name: str, graph: Graph, drafting: Drafting) -> Iterator[Stroke]:
    """Draw a curve and the ordinate of its least place, which can be measured."""
    hand, best = drafting.hand, shown.best[name]
    spots = tuple(graph.axes.on(*row) for row in shown.rows[name])
    course = Polyline(spots, False, hand.result if name == FORCES else hand.relative)
    yield Group((course,), f"{SHARES}-{name}", states=Statement(Kind.CURVE, SHARES, name))
    text, least = least_text(best, name, curve_letters(shown.reaction)[name], drafting), value_of(best, name)
    yield from graph.ordinate(best.share, least, name, None, hand.other, text, TICK)
    yield graph.dot(best.share, least, DOT, hand.body)


def _letters(shown: ShareGraph, graph: Graph, drafting: Drafting) -> Iterator[Letter]:
    """Letter the curves at their right ends, the least places and the share that was taken."""
    axes, hand, number = graph.axes, drafting.hand, drafting.number
    for force in levels(shown.high, axes.up):
        yield Letter(axes.on(0.0, force), number(force), hand.number, math.pi, TICK + BESIDE)
    yield from (graph.number(k / DIVISIONS, number(k / DIVISIONS)) for k in range(DIVISIONS + 1))
    level = drafting.word("bare level", letter=curve_letters(shown.reaction)[REACTIONS])
    yield Letter(axes.on(0.5, shown.bare), level, hand.number, math.pi / 2, 0.8)
    least = {name: value_of(best, name) for name, best in shown.best.items()}
    for name, letter in curve_letters(shown.reaction).items():
        yield Letter(axes.on(*shown.rows[name][-1]), letter, hand.letter, 0.0)
        best, side = shown.best[name], math.pi / 2 if least[name] == max(least.values()) else -math.pi / 2
        yield Letter(axes.on(best.share, least[name]), least_text(best, name, letter, drafting), hand.number, side, 1.6)


def levels(high: float, up: Scale) -> list[float]:
    """Give the forces N that are numbered on the axis, up to the largest one.

    >>> levels(1255.9, Scale(25.0, "F", "N"))
    [500.0, 1000.0]
    """
    step = LEVEL * up.mu
    return [k * step for k in range(1, int(high / step) + 1)]


def least_text(best: Choice, name: str, letter: str, drafting: Drafting) -> Phrase:
    """Write a least value by its letter, and the share that it is had with."""
    value = drafting.slot(Slot(f"least {name}", value_of(best, name)))
    share = drafting.slot(Slot(f"share {name}", best.share))
    return joined("", (f"{letter} = ", value, f" {drafting.word(UNIT)};  {SHARE} = ", share))


def curve_letters(reaction: str) -> dict[str, str]:
    """Letter both curves."""
    return {FORCES: f"{FORCE}_{{max}}", REACTIONS: f"{reaction} _{{max}}"}
