"""The region where the cam's centre may lie, and the place of it that makes the smallest cam (область выбора центра).

Lines are taken into account as they are found broken: the place is found for those few, a ruler is pushed against every
bound, and so on until nothing is broken. Each touch moves by the square of what it was off.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from itertools import combinations
from typing import NamedTuple, TypeAlias

from geometry.meet import EPS, cross, dot
from plans.cam.centre.bounds import Bound, Limit, limit

ROUNDS = 60  # of pushing a ruler; about six are needed
ROUNDED = 32 * EPS  # of the size of the diagram: a line that is broken by less is kept
PARALLEL = 1e-9  # sine of the angle of two lines that touch one curve at one place: they have no meeting of their own

# The lines so far, how far one may be broken -> the best place within them and the lines that it lies on.
Choice: TypeAlias = Callable[[Sequence[Limit], float], "Place | None"]


class Place(NamedTuple):
    """A place for the centre, and the limiting lines that it lies on: two, one, or none."""

    centre: complex
    limits: tuple[Limit, ...]


def place(bounds: Sequence[Bound], start: complex, choice: Choice, size: float) -> Place | None:
    """Find the best place within all bounds, beginning from one; None: there is none."""
    best = Place(start, ())
    known: list[Limit] = []
    for _ in range(ROUNDS):
        broken = [one for bound in bounds if (one := limit(bound, best.centre)).beyond(best.centre) > ROUNDED * size]
        if not broken:
            # What is held to a rounding is touched to the root of it only: the last touches are anew.
            return choice([limit(one.bound, best.centre) for one in best.limits], ROUNDED * size) or best
        known = [*best.limits, *broken]
        found = choice(known, ROUNDED * size)
        if found is None:
            return None
        best = found
    return None


def nearest(to: complex) -> Choice:
    """Choose the place nearest to a point: a corner of the region, or the foot of a perpendicular on its edge."""

    def choice(limits: Sequence[Limit], slack: float) -> Place | None:
        return _best([*_feet(to, limits), *_corners(limits)], limits, slack, lambda at: abs(at - to))

    return choice


def _best(
    places: Sequence[Place], limits: Sequence[Limit], slack: float, cost: Callable[[complex], float]
) -> Place | None:
    within = [one for one in places if all(line.beyond(one.centre) <= slack for line in limits)]
    return min(within, key=lambda one: cost(one.centre), default=None)


def _feet(to: complex, limits: Sequence[Limit]) -> Iterator[Place]:
    for one in limits:
        yield Place(to - one.beyond(to) * one.normal, (one,))


def _corners(limits: Sequence[Limit]) -> Iterator[Place]:
    for first, second in combinations(limits, 2):
        sine = float(cross(first.normal, second.normal))
        if abs(sine) > PARALLEL:
            yield Place(1j * (second.reach * first.normal - first.reach * second.normal) / sine, (first, second))


def on_line(through: complex, along: complex, ahead: complex) -> Choice:
    """Choose the place on a line nearest to a point of it, on the side `ahead`."""

    def choice(limits: Sequence[Limit], slack: float) -> Place | None:
        places = [Place(through, ())]
        for line in limits:
            rate = float(dot(line.normal, along))
            if abs(rate) > PARALLEL:
                places.append(Place(through - line.beyond(through) / rate * along, (line,)))
        ahead_of = [one for one in places if dot(one.centre - through, ahead) >= -slack]
        return _best(ahead_of, limits, slack, lambda at: abs(at - through))

    return choice


def on_circle(radius: float, cost: Callable[[complex], float], start: complex, ahead: complex) -> Choice:
    """Choose the cheapest place on a circle about the origin, on the side `ahead`."""

    def choice(limits: Sequence[Limit], slack: float) -> Place | None:
        places = [Place(start, ()), *(one for line in limits for one in _cuts(radius, line))]
        return _best([one for one in places if dot(one.centre, ahead) >= -slack], limits, slack, cost)

    return choice


def _cuts(radius: float, line: Limit) -> Iterator[Place]:
    """Give where a line cuts the circle."""
    if abs(line.reach) <= radius:
        half = math.acos(line.reach / radius)
        for turned in (half, -half):
            yield Place(radius * line.normal * cmath.exp(1j * turned), (line,))
