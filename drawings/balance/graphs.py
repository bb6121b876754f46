"""Graphs of a balanced machine: the rocking moment over the turn, forces over the share (графики уравновешивания)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from drawings.forces.letters import letter_of
from drawings.kinds.axes import Axes, Letter, Part
from drawings.kinds.curve_graph import TURN, GraphCurve, bounded, swing
from drawings.kinds.graph import BESIDE, Graph, GraphForm, standing
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.phrase import Phrase, Slot, joined
from drawings.lettering.vector_letters import FORCE, MOMENT
from drawings.page.scale import Drafting, Scale
from drawings.paper.hand import Hand
from drawings.paper.limits import MANY
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Group, Line, Polyline, Stroke
from drawings.symbols.dashes import fit
from drawings.symbols.figure import heading, heading_width
from drawings.symbols.symbols import TICK
from plans.model.balance.linkage import Choice, Shares, State
from plans.model.motion import Floats

ROOMY = 3 * MANY  # positions that all have room


def told(count: int, shown: int) -> tuple[int, ...]:
    """Choose the positions that are told.

    >>> told(12, 2) == tuple(range(12)), told(72, 1)[:4]
    (True, (0, 1, 6, 12))
    """
    every = 1 if count <= ROOMY else math.ceil(count / MANY)
    return tuple(k for k in range(count) if k % every == 0 or k == shown)


ROCKING = "rocking"


def curve(
    states: Mapping[str, State], sense: int, shown: int, least: float, drafting: Drafting, point: str
) -> GraphCurve | None:
    """Give the main moments about a point, at the positions the last one; None where all are below `least` N*m.

    Of a crank that cannot turn fully there are the ordinates at its positions alone.
    """
    first, own = next(iter(states.values())), list(states.values())[-1]
    if max(first.rocking, own.rocking) <= least or len(own.centre.phi) < 2:
        return None
    numbers = told(len(own.centre.phi), shown)
    stations = np.degrees(sense * (own.centre.phi - own.centre.phi[0]))[list(numbers)] % TURN
    ordinates, title = _seen(own.centre.moment, least)[list(numbers)], drafting.word("rocking graph", point=point)
    bare = GraphCurve(MOMENT, "N*m", np.array([0.0, TURN]), np.full(2, np.nan), stations, ordinates, title)
    bare = bare._replace(numbers=numbers, name=ROCKING)
    if not own.whole:
        swung = swing(bare)
        return swung._replace(values=np.full(len(swung.values), np.nan))
    angles = np.degrees(sense * (own.around.phi - own.around.phi[0]))
    gaps = any(np.isnan(state.around.moment).any() for state in (first, own))  # beside one a curve is cut off
    whole = bare._replace(angles=angles, values=_course(own, least), states="" if gaps else "last")
    return whole if own is first else whole._replace(before=_course(first, least))


def _course(state: State, least: float) -> Floats:
    return np.asarray(bounded(_seen(state.around.moment, least), _seen(state.centre.moment, least)))


def _seen(moments: Floats, least: float) -> Floats:
    return np.where(np.abs(moments) <= least, 0.0, moments)


NAME, SYMBOL, UNIT = "shares", "F", "N"
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
        found, choices = {}, (*self.shares.curve, self.shares.least_force, self.shares.least_reaction)
        for name in (FORCES, REACTIONS):
            found[name] = sorted({(choice.share, value_of(choice, name)) for choice in choices})
        return found

    @property
    def best(self) -> dict[str, Choice]:
        """Where each is least."""
        return {FORCES: self.shares.least_force, REACTIONS: self.shares.least_reaction}

    @property
    def high(self) -> float:
        """The largest value, N."""
        return max(self.bare, *(value for row in self.rows.values() for _, value in row))


def value_of(choice: Choice, name: str) -> float:
    """Give what is largest with a share, N: by the name of a curve."""
    return choice.force if name == FORCES else choice.reaction


def measure(shown: ShareGraph, drafting: Drafting) -> Picture:
    """Measure the room of the graph: its scale is that of the share."""
    hand, title = drafting.hand, drafting.word("share graph")
    return FORM.room(NAME, 1.0, (SHARE, ONE), title, hand)._replace(heading=heading_width(title, hand))


def draw(shown: ShareGraph, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw the graph in its spot: axes, both curves, their least places, the share that was taken dashed."""
    hand, high = drafting.hand, shown.high
    axes = standing(room, spot, (0.0, high), (SYMBOL, UNIT), drafting)
    graph = Graph(NAME, axes, hand)
    lines = (
        heading(spot.box, drafting.word("share graph"), drafting.scale(spot.scale, axes.up), hand),
        *axes.lines((0.0, 1.0), (0.0, high), hand, NAME),
        *(graph.tick(k / DIVISIONS, hand.other) for k in range(1, DIVISIONS + 1)),
        *(Line(axes.on(0.0, force) - TICK, axes.on(0.0, force) + TICK, hand.other) for force in levels(high, axes.up)),
        _taken(shown, axes, hand),
        Group((Line(axes.on(0.0, shown.bare), axes.on(1.0, shown.bare), hand.other),), f"{NAME}-{BARE}"),
        *(part for name in (FORCES, REACTIONS) for part in _curve(shown, name, graph, drafting)),
    )
    ends = graph.ends((1.0, SHARE), (high, drafting.word(UNIT)))
    return Part(NAME, lines, (*ends, *_letters(shown, graph, drafting)))


def _taken(shown: ShareGraph, axes: Axes, hand: Hand) -> Group:
    start, end = axes.on(shown.taken), axes.on(shown.taken, shown.high)
    return Group((Line(start, end, fit(hand.path, abs(end - start))),), f"{NAME}-{TAKEN}")


def _curve(shown: ShareGraph, name: str, graph: Graph, drafting: Drafting) -> Iterator[Stroke]:
    """Draw a curve and the ordinate of its least place, which can be measured."""
    hand, best = drafting.hand, shown.best[name]
    spots = tuple(graph.axes.on(*row) for row in shown.rows[name])
    course = Polyline(spots, False, hand.result if name == FORCES else hand.relative)
    yield Group((course,), f"{NAME}-{name}", states=Statement(Kind.CURVE, NAME, name))
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
    for name, letter in curve_letters(shown.reaction).items():
        yield Letter(axes.on(*shown.rows[name][-1]), letter, hand.letter, 0.0)
        best = shown.best[name]
        text = least_text(best, name, letter, drafting)
        yield Letter(axes.on(best.share, value_of(best, name)), text, hand.number, math.pi / 2, 1.6)


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


def reaction_letter(crank: int, drafting: Drafting) -> str:
    """Letter the reaction of the frame on the crank."""
    return letter_of(f"R_0{crank}", drafting)
