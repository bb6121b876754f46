"""The place of a cam's centre within its bounds, and what the construction of the main sizes leaves (выбор центра)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple, TypeAlias

from geometry.board import Board, Mark
from geometry.meet import EPS, cross, dot
from plans.cam.centre.bounds import Bound, Limit, PressureBound, RulerTouch, SlopeDiagram, limit, side_of
from plans.model.cam import LEAST_BASE, Cam, Limits
from plans.model.cam_motion import CamSizes, no_region, vanishing
from plans.words.words import because

PARALLEL = 1e-9  # sine of the angle of two lines that touch one curve at one place: they have no meeting of their own
ROUNDS = 60  # of pushing a ruler; about six are needed
ROUNDED = 32 * EPS  # of the size of the diagram: a line that is broken by less is kept
# The lines so far, how far one may be broken -> the best place within them and the lines that it lies on.
Choice: TypeAlias = Callable[[Sequence[Limit], float], "CentrePlace | None"]


class CentrePlace(NamedTuple):
    """A place for the centre, and the limiting lines that it lies on: two, one, or none."""

    centre: complex
    limits: tuple[Limit, ...]


def place(bounds: Sequence[Bound], start: complex, choice: Choice, size: float) -> CentrePlace | None:
    """Find the best place within all bounds, beginning from one; None: there is none."""
    best = CentrePlace(start, ())
    known: list[Limit] = []
    for _ in range(ROUNDS):
        broken = [line for bound in bounds if (line := limit(bound, best.centre)).beyond(best.centre) > ROUNDED * size]
        if not broken:
            # What is held to a rounding is touched to the root of it only: the last touches are anew.
            return choice([limit(line.bound, best.centre) for line in best.limits], ROUNDED * size) or best
        known = [*best.limits, *broken]
        found = choice(known, ROUNDED * size)
        if found is None:
            return None
        best = found
    return None


def nearest(to: complex) -> Choice:
    """Choose the place nearest to a point: a corner of the region, or the foot of a perpendicular on its edge."""

    def choice(limits: Sequence[Limit], slack: float) -> CentrePlace | None:
        feet = [CentrePlace(to - line.beyond(to) * line.normal, (line,)) for line in limits]
        return _best([*feet, *_corners(limits)], limits, slack, lambda at: abs(at - to))

    return choice


def _best(
    places: Sequence[CentrePlace], limits: Sequence[Limit], slack: float, cost: Callable[[complex], float]
) -> CentrePlace | None:
    within = [spot for spot in places if all(line.beyond(spot.centre) <= slack for line in limits)]
    return min(within, key=lambda spot: cost(spot.centre), default=None)


def _corners(limits: Sequence[Limit]) -> Iterator[CentrePlace]:
    for first, second in combinations(limits, 2):
        sine = float(cross(first.normal, second.normal))
        if abs(sine) > PARALLEL:
            yield CentrePlace(1j * (second.reach * first.normal - first.reach * second.normal) / sine, (first, second))


def under(top: complex) -> Choice:
    """Choose the place nearest to a point of those below it."""

    def choice(limits: Sequence[Limit], slack: float) -> CentrePlace | None:
        level = [line for line in limits if abs(line.normal.imag) > PARALLEL]
        cuts = (CentrePlace(top - 1j * line.beyond(top) / line.normal.imag, (line,)) for line in level)
        below = [spot for spot in (CentrePlace(top, ()), *cuts) if spot.centre.imag <= top.imag + slack]
        return _best(below, limits, slack, lambda at: abs(at - top))

    return choice


def on_circle(radius: float, cost: Callable[[complex], float], start: complex, ahead: complex) -> Choice:
    """Choose the cheapest place on a circle about the origin, on the side `ahead`."""

    def choice(limits: Sequence[Limit], slack: float) -> CentrePlace | None:
        places = [CentrePlace(start, ()), *(cut for line in limits for cut in _cuts(radius, line))]
        return _best([spot for spot in places if dot(spot.centre, ahead) >= -slack], limits, slack, cost)

    return choice


def _cuts(radius: float, line: Limit) -> Iterator[CentrePlace]:
    if abs(line.reach) <= radius:
        half = math.acos(line.reach / radius)
        for turned in (half, -half):
            yield CentrePlace(radius * line.normal * cmath.exp(1j * turned), (line,))


SIZES = "sizes"  # the board: m


class SizeTangent(NamedTuple):
    """A ruler's touch on the board: the point that it touches, its direction, its line; whether O lies on it."""

    bound: Bound
    touch: RulerTouch
    point: Mark
    direction: Mark
    line: Mark
    binding: bool

    @property
    def angle(self) -> float | None:
        """The limit of the pressure angle that it is drawn at, signed, rad; None of a line of convexity."""
        return self.bound.side * self.bound.angle if isinstance(self.bound, PressureBound) else None


class Chord(NamedTuple):
    """The book's construction on the chord of a rocker's arc: its two tangents, its centre."""

    tangents: tuple[SizeTangent, ...]
    centre: Mark


@dataclass(frozen=True)
class Sizing:
    """The main sizes of a cam with the construction that gave them.

    The diagram has its own origin: the start A of a follower that translates, the pivot O1 of one that rocks. `centre`
    is O in it. K and D are of the numbered positions, (N,) each; None where the diagram is another or has no points.
    """

    cam: Cam
    limits: Limits
    sizes: CamSizes
    board: Board
    origin: Mark | None = None
    start: Mark | None = None  # K0
    tip: Mark | None = None  # K
    end: Mark | None = None  # D; of a flat face S'' across from S
    centre: Mark | None = None
    tangents: tuple[SizeTangent, ...] = ()
    bounds: tuple[Bound, ...] = ()
    chord: Chord | None = None

    @property
    def binding(self) -> Iterator[SizeTangent]:
        """The tangents that O lies on."""
        return (tangent for tangent in self.tangents if tangent.binding)


# A touch and its number -> on the board D there, and the way of K there.
Laid: TypeAlias = Callable[[RulerTouch, str], tuple[Mark, Mark]]


def tangents(
    board: Board, diagram: SlopeDiagram, limits: Sequence[Limit], binding: Sequence[Limit], locus: Laid, prime: str = ""
) -> tuple[SizeTangent, ...]:
    """Draw the limiting lines through the points that rulers touch, numbered; those that O lies on come first."""
    bounds = [line.bound for line in binding]
    rise_first = sorted(binding, key=lambda line: -side_of(line.touch.stretch.phase.kind))
    ordered = [*rise_first, *(line for line in limits if line.bound not in bounds)]
    found = []
    for number, edge in enumerate(ordered):
        bound, name = edge.bound, f"{number + 1}{prime}"
        assert isinstance(bound, PressureBound)
        point, way = locus(edge.touch, name)
        angle = f"{math.degrees(bound.side * bound.angle):.4g}"
        by = diagram.limit(bound.side, bound.angle) / 1j
        direction = board.turn(f"t_{name}", way, by, because("cam_limit_angle", angle=angle))
        line = board.parallel(f"τ_{name}", point, direction, because("cam_ruler"))
        found.append(SizeTangent(bound, edge.touch, point, direction, line, number < len(binding)))
    return tuple(found)


def axis(board: Board) -> tuple[Mark, Mark, Mark]:
    """Draw the way of a follower that translates: its start A, the way's direction, the axis of S through A."""
    start = board.given("A", 0j, because("cam_start"))
    way = board.given("S", 1j, because("cam_way"))
    return start, way, board.parallel("AS", start, way, because("cam_way"))


def required(cam: Cam, limits: Limits, found: CentrePlace | None, start: complex = 0j) -> CentrePlace:
    """Give the place that was found for O; raises CamError where the limits leave none, or one at the start of K."""
    if found is None:
        raise no_region(cam, limits)
    free = not found.limits and (cam.rocks or cam.given.base is None) and not cam.sized
    if free or (cam.given.base is None and abs(found.centre - start) < LEAST_BASE * cam.way):
        raise vanishing(cam, limits)
    return found


def touched(bounds: Sequence[Bound], found: CentrePlace) -> list[Limit]:
    """Push a ruler against every bound; none where nothing moves."""
    return [limit(bound, found.centre) for bound in bounds if bound.along]


def bound_by(cam: Cam, lines: Sequence[SizeTangent]) -> tuple[SizeTangent, ...]:
    """Give tangents as they bind O: with R0 given none does."""
    return tuple(line._replace(binding=line.binding and cam.given.base is None) for line in lines)


def met(board: Board, name: str, lines: Sequence[SizeTangent], start: Mark, why: str) -> Mark:
    """Give where two limiting lines meet; of one alone the foot of the perpendicular from the start."""
    if len(lines) == 2:
        return board.meet(name, lines[0].line, lines[1].line, why=because(why))
    square = board.square("n", start, lines[0].direction, because("cam_square"))
    return board.meet(name, square, lines[0].line, why=because("cam_foot"))


def rocker_sizes(cam: Cam, centre: complex, first: complex, base: float | None = None) -> CamSizes:
    """Give the sizes of a centre seen from O1, with K0 or the direction of the arm; those given as they were given."""
    given = cam.given
    initial = cam.rising * cmath.phase(first / centre)
    least = base if base is not None else abs(first - centre)
    apart = abs(centre) if given.centre is None else given.centre
    return CamSizes(least if given.base is None else given.base, 0.0, apart, -centre, initial)
