"""What a loading scheme shows, in true units; its forces as arrows that can be told apart (веер сил).

Forces of a machine differ by thousands of times: their lengths on a scheme grow with their logarithm. Arrows at one
point, or along a link, start there, end there, or stand off it on their line of action, wherever the fewest lines run.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from operator import itemgetter
from typing import NamedTuple

from drawings.forces.acting import CutLinks, SchemeForces, acting, cut_links
from drawings.forces.arms import Leverage, leverages
from drawings.layout.ink import Ink
from drawings.layout.picture import Place
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Stroke, stated
from drawings.symbols.couples import ForceArrow, coupling
from drawings.symbols.couples import spring as coil
from drawings.symbols.figure import LEAST
from drawings.symbols.symbols import HINGE, fixed_hinge
from geometry.board import at
from plans.forces.cut import INERTIA, WEIGHT, CutGroup, ForcePlan
from plans.model.machine import COUPLING, Spring
from plans.model.mechanism import FRAME
from plans.model.triad import Triad

FAR = 2.5  # sizes of a cut's links: of a longer spring only so much is drawn, else it would hide the links


class ShownSpring(NamedTuple):
    """A spring at a point of a cut: the force by its name, both ends m, the letter of the far one.

    One that is not drawn whole has no far end; `fixed` is one that is held by the frame.
    """

    name: str
    start: complex
    end: complex
    letter: str
    fixed: bool


def shown_springs(plan: ForcePlan, cut: CutGroup, links: CutLinks, column: int) -> Iterator[ShownSpring]:
    """Give the springs that act on a cut, each once."""
    places = {load.name: at(load.at.point, column) for load in cut.loads}
    for spring in plan.machine.springs:
        # The force at each moving end of a spring, with the other end
        moving = [k for k in (0, 1) if spring.links[k] != FRAME]
        for name, far in ((spring.name + ("′" if k != moving[0] else ""), 1 - k) for k in moving):
            if name in places:
                yield _shown(plan, spring, name, places[name], far, links)
                break


def _shown(plan: ForcePlan, spring: Spring, name: str, start: complex, far: int, links: CutLinks) -> ShownSpring:
    end = at(plan.positions.point(spring.points[far]).point, links.shown)
    most = FAR * links.size
    if abs(end - start) > most:
        return ShownSpring(name, start, start + (end - start) / abs(end - start) * most, "", False)
    return ShownSpring(name, start, end, spring.points[far], spring.links[far] == FRAME)


def friction_circles_of(plan: ForcePlan, cut: CutGroup) -> Iterator[tuple[str, float]]:
    """Give the friction circles of a cut's hinges: a letter, and the radius f*r, m."""
    for key, rubbing in plan.machine.friction.items():
        radius = rubbing.coefficient * rubbing.radius
        links = {int(link) for link in key.split("-")}
        if radius > 0 and links & set(cut.links):
            yield from ((name, radius) for name in _hinges(plan, links))


def _hinges(plan: ForcePlan, links: set[int]) -> list[str]:
    first, other = (plan.mechanism.links[link].points for link in links)
    return [name for name in first if name in other and name in plan.mechanism.hinges]


WHOLE = 2.0  # cranks: of a larger wheel only a part of the pitch circle is drawn


class DrivingWheel(NamedTuple):
    """The wheel that drives the crank: shaft, pitch radius m, directions rad, a word for the flank that bears."""

    centre: complex
    radius: float
    at: float
    action: complex
    whole: bool
    flank: str


@dataclass(frozen=True, eq=False)
class Scheme:
    """The loading scheme of a cut in one position."""

    plan: ForcePlan
    cut: CutGroup
    column: int
    links: CutLinks
    acting: SchemeForces
    arms: tuple[Leverage, ...]
    wheel: DrivingWheel | None
    springs: tuple[ShownSpring, ...] = ()
    circles: tuple[tuple[str, float], ...] = ()  # letters of hinges, radii m

    @property
    def coupled(self) -> bool:
        """Whether a coupling drives what is cut."""
        return self.cut.group is None and self.plan.machine.transmission.kind == COUPLING

    @property
    def dimensioned(self) -> list[Leverage]:
        """The arms that are drawn: one of each letter."""
        return list({arm.letter: arm for arm in reversed(self.arms) if arm.dimensioned}.values())[::-1]

    def faint(self, mu: float) -> list[str]:
        """Give the letters of the arms that are too short to be dimensioned at a scale, m/mm."""
        return [arm.letter for arm in self.dimensioned if arm.length < LEAST * mu]

    @cached_property
    def named(self) -> dict[str, complex]:
        """The points that bear letters: those of the links, and those at which other forces act."""
        others = {force.spot: force.at for force in self.acting.forces if force.spot}
        others |= {spring.letter: spring.end for spring in self.springs if spring.letter}
        if isinstance(self.cut.group, Triad):  # moments are taken about its special point too
            others |= {one.about.name: at(one.about.point, self.column) for one in self.cut.equations}
        return self.links.points | {name: place for name, place in others.items() if name not in self.links.points}

    @cached_property
    def centres(self) -> set[str]:
        """The letters of the mass centres that forces act at."""
        loads = (load for load in self.cut.loads if load.kind in (WEIGHT, INERTIA))
        return {self.links.name(load.at.name, at(load.at.point, self.column)) for load in loads}

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [*self.solid, *(spring.end for spring in self.springs)]

    @property
    def solid(self) -> list[complex]:
        """The true points of all but the springs, by which the links are seen."""
        away = {spring.letter for spring in self.springs} - self.links.points.keys()
        places = [*(place for name, place in self.named.items() if name not in away), *self.links.slots]
        places += [arm.foot for arm in self.dimensioned]
        places += [force.at for force in self.acting.forces]
        places += self.links.feet
        if self.wheel is not None:
            wheel = self.wheel
            turns = (1, 1j, -1, -1j) if wheel.whole else ()
            places += [wheel.centre + wheel.radius * turn for turn in turns]
        return places


def scheme(plan: ForcePlan, cut: CutGroup, column: int) -> Scheme:
    """Gather what the loading scheme of a cut shows in one position."""
    links = cut_links(plan, cut, column)
    wheel = _wheel(plan, links, column) if cut.group is None else None
    loads, arms = acting(plan, cut, links, column), leverages(plan, cut, column)
    hung = tuple(shown_springs(plan, cut, links, column))
    return Scheme(plan, cut, column, links, loads, arms, wheel, hung, tuple(friction_circles_of(plan, cut)))


def _wheel(plan: ForcePlan, links: CutLinks, column: int) -> DrivingWheel | None:
    how, drive = plan.machine.transmission, plan.mechanism.drive
    if plan.push is None:
        return None
    shaft = links.spot(drive.pivot, links.shown)
    crank = abs(links.spot(drive.end, links.shown) - shaft)
    along, moment = at(plan.push.point, column), at(plan.balancing.point, column).real
    flank = "coast flank" if moment * drive.omega < 0 else "drive flank"
    return DrivingWheel(shaft, how.radius, how.at, along / abs(along), how.radius <= WHOLE * crank, flank)


WIDER = 0.4  # mm that a friction circle must be wider than the hinge's own circle
ATTACHMENTS_OFF, REACH = 20.0, 8.0  # mm from the shaft to its coupling, and how far the coupled shafts reach
WAYS = (1, -1, 1j, -1j)


def drawn_springs(shown: Scheme, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw each spring from its point on the links; one that the frame holds has its stand."""
    points = shown.links.points
    for spring in shown.springs:
        start, end = place.on(spring.start), place.on(spring.end)
        data = {"kind": "spring", "name": spring.name, "direction": stated((end - start) / abs(end - start))}
        strokes: tuple[Stroke, ...] = (coil(start, end, hand),)
        if spring.fixed and spring.letter not in points:
            strokes += fixed_hinge(end, hand, HINGE * hand.symbol)
        yield Group(strokes, "", data)


def drawn_circles(shown: Scheme, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the friction circles that are to be seen at the scheme's scale, each about its hinge."""
    for point, true in dict.fromkeys(shown.circles):  # a point that joins three links has one for each two of them
        radius = place.length(true)
        if radius > HINGE * hand.symbol + WIDER and point in shown.named:
            circle = Circle(place.on(shown.named[point]), radius, hand.drafted)
            yield Group((circle,), "", {"kind": "friction", "name": point})


def coupled(shown: Scheme, place: Place, hand: Hand, ink: Ink) -> Iterator[Group]:
    """Draw the coupling beside the shaft, where it crosses the fewest lines."""
    if not shown.coupled:
        return
    shaft = place.on(shown.links.spot(shown.links.mechanism.drive.pivot, shown.links.shown))
    choices = [coupling(shaft + way * ATTACHMENTS_OFF * hand.symbol, way, hand, REACH) for way in WAYS]
    best = min(choices, key=ink.crossed_by)
    yield Group(tuple(best), "", {"kind": "coupling", "name": str(shown.links.mechanism.drive.link)})


SHORT, LONG, UNSIZED = 13.0, 26.0, 16.0  # mm: the least and the largest known force, and every unknown one
RUNG, BESIDE = 2.5, 1.8  # mm between the rungs that feel along an arrow, and how far they reach to its sides
CLEAR = 1.5  # mm from the end of an arrow at its point that are not felt: symbols are there; off it, felt before it
STEP, STEPS = 4.0, 25  # mm by which an arrow may stand off its point on its line of action, and how often
# What ending at the point costs, standing off it, and each mm of that; a crossed thin line costs 1.
ENDING, OFF, FURTHER = 3.0, 4.0, 0.3
# A force whose line of action runs in a link stands beside it, so many mm, on a thin line square to it, or aslant where
# that would run along others: what it costs, and what more by the slant of the thin line.
SIDE, PARALLEL, SLANTS = 8.0, 9.0, (0.0, 0.5, -0.5)
PASSED, NEAR = 40.0, 3.0  # what a known force costs whose line to its point passes another point, so many mm near
OUTSIDE = 10.0  # what each mm outside the figure's box costs
ROUNDS = 2  # times that every arrow looks for its place among all others
ARROW_LINES = 6.0  # thin lines that an arrow counts as for the others


class _Room(NamedTuple):
    """Where an arrow looks for its place: the lines and points around, and the box."""

    ink: Ink
    spots: Sequence[complex]
    box: Field | None


def lengths(sizes: Sequence[float]) -> list[float]:
    """Give arrows' lengths, mm: in the order of the forces and within bounds, by their logarithms.

    >>> [round(length, 1) for length in lengths([1.0, 100.0, 10000.0])]
    [13.0, 19.5, 26.0]
    >>> lengths([5.0])
    [19.5]
    """
    if not sizes:
        return []
    low, high = math.log(min(sizes)), math.log(max(sizes))
    shares = [(math.log(size) - low) / (high - low) if high > low else 0.5 for size in sizes]
    return [SHORT + (LONG - SHORT) * share for share in shares]


def fan(
    arrows: Sequence[ForceArrow],
    reaches: Sequence[tuple[float, Sequence[int]]],
    around: Iterable[tuple[Stroke, float]],
    spots: Sequence[complex],
    box: Field | None,
    hand: Hand,
) -> list[ForceArrow]:
    """Place arrows among the lines around, each with its weight, among the points, and among each other.

    Each arrow is given at its point, as if alone: symbols reach some mm from there, and it may stand to some sides.
    """
    lines = list(around)
    standing = [_standing(one, reach, one.ending, 0.0, 0) for one, (reach, _) in zip(arrows, reaches, strict=True)]
    for _ in range(ROUNDS):
        for k, (arrow, (reach, sides)) in enumerate(zip(arrows, reaches, strict=True)):
            ink = Ink()
            for stroke, weight in lines:
                ink.draw([stroke], weight)
            others = (*standing[:k], *standing[k + 1 :])
            ink.draw((other.shaft for other in others), ARROW_LINES)
            ink.draw((Line(other.lead or 0j, other.at) for other in others if other.beside), ARROW_LINES)
            standing[k] = _best(arrow, reach, sides, _Room(ink, spots, box), hand)
    return standing


def _best(arrow: ForceArrow, reach: float, sides: Sequence[int], room: _Room, hand: Hand) -> ForceArrow:
    best, cheapest = None, math.inf
    for least, ending, off, way in sorted(_places(arrow.ending, sides), key=itemgetter(0)):
        if least >= cheapest:
            break
        trial = _standing(arrow, reach, ending, off * hand.symbol, way)
        cost = least + _cost(trial, room, hand) + (0.0 if arrow.unknown else PASSED * _passed(arrow, trial, room))
        if cost < cheapest:
            best, cheapest = trial, cost
    assert best is not None  # the first place costs less than infinitely much
    return best


def _places(pressing: bool, sides: Sequence[int]) -> Iterator[tuple[float, bool, float, complex]]:
    """Give what each place costs at least: starting or ending at the point, mm off it, on its line or which way."""
    for ending in (False, True):
        turned = ENDING * (ending != pressing)
        yield turned, ending, 0.0, 0
        yield from ((turned + OFF + FURTHER * STEP * k, ending, STEP * k, 0) for k in range(1, STEPS + 1))
        for side, slant in product(sides, SLANTS):
            yield turned + PARALLEL + abs(slant), ending, SIDE, (side * 1j + slant) / abs(1 + slant * 1j)


def _standing(arrow: ForceArrow, reach: float, ending: bool, off: float, beside: complex) -> ForceArrow:
    """Stand an arrow at a place: starting or ending at its point's symbol, or off it on a thin line."""
    back = -arrow.direction if ending else arrow.direction
    way = beside * arrow.direction or back
    lead = arrow.at + way * reach if off else None
    return arrow._replace(at=arrow.at + way * (reach + off), ending=ending, lead=lead)


def _cost(arrow: ForceArrow, room: _Room, hand: Hand) -> float:
    """Weigh a place: the lines that an arrow crosses or runs beside, and what of it is outside the box."""
    far = -arrow.direction if arrow.ending else arrow.direction
    start, end = arrow.at + far * CLEAR * hand.symbol * (1 if arrow.lead is None else -1), arrow.free
    felt = _ladder(start, end, 1 if arrow.lead is None else 0, hand)
    if arrow.lead is not None and arrow.beside:
        felt += _ladder((arrow.lead + arrow.at) / 2, arrow.at, 0, hand)
    return room.ink.crossed_by(felt) + (0.0 if room.box is None else OUTSIDE * _beyond(end, room.box))


def _ladder(start: complex, end: complex, first: int, hand: Hand) -> list[Stroke]:
    """Give a line and the rungs by which it feels what runs along it."""
    across = 1j * (end - start) / abs(end - start) * BESIDE * hand.symbol
    count = max(int(abs(end - start) / (RUNG * hand.symbol)), 1)
    spots = (start + (end - start) * k / count for k in range(first, count + 1))
    return [Line(start, end), *(Line(spot - across, spot + across) for spot in spots)]


def _passed(arrow: ForceArrow, trial: ForceArrow, room: _Room) -> bool:
    if trial.lead is None:
        return False
    run = trial.at - arrow.at
    off = [(spot - arrow.at) / run for spot in room.spots if abs(spot - arrow.at) > NEAR]
    return any(0 < place.real <= 1 and abs(place.imag) * abs(run) < NEAR for place in off)


def _beyond(spot: complex, box: Field) -> float:
    across = max(box.left - spot.real, spot.real - box.right, 0.0)
    return across + max(box.bottom - spot.imag, spot.imag - box.top, 0.0)
