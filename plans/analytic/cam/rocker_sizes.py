"""The centre of a cam with a rocker by Newton's method on the envelopes of its limiting lines (M2.9).

In mirrored coordinates: the cam turns counter-clockwise, O1 is the origin, the rocker points to the right where it
turns with the cam on the rise, to the left where against it. θ is its lean from the level, f its sense. With
z = f l - l ψ' - O exp(-iθ) a limit asks for a = ±cos α Re z + sin α Im z >= 0. At the place where a line of a limit
touches O, a = 0 and da/dφ = 0.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.analytic.cam.stretches import LawPart, eased, stretches
from plans.model.cam import FORCE, LEAST_BASE, RETURN, RISE, Cam, limits_of
from plans.model.cam_motion import CamSizes, FollowerTravel, Points, no_region, no_triangle, vanishing
from plans.model.motion import Floats

ROUNDS = 200  # each takes one more line into account, of some hundreds
SLACK = 1e-12  # of the size of the lines: seeds of Newton's method need no more


def _beyond(at: complex | Points, normals: Points, bounds: Floats) -> Floats:
    return np.asarray((normals.conj() * at).real - bounds)


def nearest(to: complex, normals: Points, bounds: Floats) -> tuple[complex, list[int]] | None:
    """Give the place nearest to a point within half-planes, and the lines that it lies on; None: there is no room."""
    slack, known, lying, at = SLACK * float(np.abs(bounds).max() + abs(to)), list[int](), list[int](), to
    for _ in range(ROUNDS):
        beyond = _beyond(at, normals, bounds)
        worst = int(np.argmax(beyond))
        if beyond[worst] <= slack:
            return at, lying
        places = _with(to, worst, known, normals, bounds)
        known.append(worst)
        within = [spot for spot in places if (_beyond(spot[0], normals[known], bounds[known]) <= slack).all()]
        if not within:
            return None
        at, lying = min(within, key=lambda place: abs(place[0] - to))
    return None


def _with(
    to: complex, line: int, others: Sequence[int], normals: Points, bounds: Floats
) -> list[tuple[complex, list[int]]]:
    """Give the places on one line: the foot from a point, the meetings with others."""
    n, b = complex(normals[line]), float(bounds[line])
    foot = to - ((n.conjugate() * to).real - b) * n / abs(n) ** 2
    found = [(foot, [line])]
    for other in others:
        m, c = complex(normals[other]), float(bounds[other])
        turn = (n.conjugate() * m).imag
        if turn:
            found.append((1j * (c * n - b * m) / turn, [line, other]))
    return found


def on_circle(radius: float, normals: Points, bounds: Floats) -> tuple[Points, list[int]]:
    """Give the ends of the arcs of a circle that half-planes leave, and the line that each lies on."""
    size = np.abs(normals)
    cut = np.flatnonzero(np.abs(bounds) <= radius * size)
    half = np.arccos(bounds[cut] / (radius * size[cut]))
    turned: Points = np.exp(1j * np.concatenate([half, -half]))
    places = np.asarray(radius * np.tile(normals[cut] / size[cut], 2) * turned, dtype=np.complex128)
    beyond = _beyond(places[:, None], normals, bounds)
    kept = np.flatnonzero((beyond <= SLACK * radius * size).all(axis=1))
    return places[kept], np.tile(cut, 2)[kept].tolist()


STEPS = 12  # of Newton's method, which takes about four
Condition: TypeAlias = Callable[[complex, Sequence[float]], float]  # on O and the shares of the touches, m: 0
EXACT = 1e-13  # of a length: what is farther beyond a line than its rounding
STEP = 1e-6  # of a difference, in shares of a phase and of the rocker: it makes the Jacobian alone, no result


class Family(NamedTuple):
    """The limiting lines of one limit over one stretch."""

    cam: Cam
    stretch: LawPart
    weight: complex  # ±cos α + i sin α

    @property
    def sense(self) -> int:
        """f: +1 where the rocker turns with the cam on the rise."""
        return self.cam.follower.sense

    @property
    def length(self) -> float:
        """l, m."""
        return self.cam.follower.length or 0.0

    def _lean(self, at: FollowerTravel) -> Points:
        return np.asarray(np.exp(1j * self.sense * (at.s - self.cam.lift / 2)))

    def lines(self, share: Floats) -> tuple[Points, Floats]:
        """Give normals and bounds of the half-planes in which O lies: Re(conj(n) O) <= b."""
        at = self.stretch.at(share)
        return self.weight * self._lean(at), np.asarray(self.weight.real * self.length * (self.sense - at.slope))

    def touching(self, share: Floats, centre: complex) -> tuple[float, float]:
        """Give a and da/dφ at one share: both vanish where the line is touched."""
        at = self.stretch.at(share)
        away = complex((centre / self._lean(at))[0])
        z = self.length * (self.sense - float(at.slope[0])) - away
        drift = -self.length * float(at.bend[0]) + 1j * self.sense * float(at.slope[0]) * away
        return (self.weight.conjugate() * z).real, (self.weight.conjugate() * drift).real


class Seed(NamedTuple):
    """A line that O lies on, near where it is touched; a corner stays where it is."""

    family: Family
    share: float
    corner: bool

    def normal(self, share: float) -> complex:
        """Give the normal of the line of its family at a share."""
        return complex(self.family.lines(np.array([share]))[0][0])


def rocker_sizes(cam: Cam) -> CamSizes:
    """Give R0, L and the rocker's angle at the start."""
    given, length, f = cam.given, cam.follower.length or 0.0, cam.follower.sense
    start = f * length * cmath.exp(-0.5j * f * cam.lift)
    if given.base is not None and given.centre is not None:
        if not abs(length - given.base) < given.centre < length + given.base:
            raise no_triangle(cam, length, given.base, given.centre)
        initial = math.acos((length**2 + given.centre**2 - given.base**2) / (2 * length * given.centre))
        return _sizes(cam, start, given.centre * start / length * cmath.exp(-1j * f * initial))
    if cam.eased:
        return _sizes(cam, start, start + eased(cam, lambda one: _nearest(one, start) - start))
    place = _nearest(cam, start) if given.centre is None else _on_circle(cam, start, given.centre)
    if given.base is None and abs(place - start) < LEAST_BASE * cam.way:
        raise vanishing(cam, limits_of(cam))
    return _sizes(cam, start, place)


def _sizes(cam: Cam, start: complex, place: complex) -> CamSizes:
    base, centre = cam.given.base, cam.given.centre
    pivot = -place if cam.sense > 0 else place.conjugate()
    initial = cam.follower.sense * cmath.phase(start / place)
    return CamSizes(
        abs(start - place) if base is None else base, 0.0, abs(place) if centre is None else centre, pivot, initial
    )


def _families(cam: Cam) -> Iterator[Family]:
    limits = limits_of(cam)
    assert limits.rise is not None  # the book's at least
    weights = [(RISE, cmath.exp(1j * limits.rise))]
    weights += [(RETURN, -cmath.exp(-1j * limits.back))] if limits.back is not None else []
    weights += [(RISE, -cmath.exp(-1j * limits.rise))] if cam.closure == FORCE else []
    for kind, weight in weights:
        yield from (Family(cam, stretch, weight) for stretch in stretches(cam, (kind,)))


def _lines(families: Sequence[Family]) -> tuple[Points, Floats, list[tuple[Family, float]]]:
    """Give the lines of all families at the places of their grids, and which each is."""
    rows = [(family, family.stretch.grid) for family in families]
    lines = [family.lines(grid) for family, grid in rows]
    which = [(family, float(share)) for family, grid in rows for share in grid]
    return np.concatenate([normals for normals, _ in lines]), np.concatenate([bounds for _, bounds in lines]), which


def _pressed(number: int, which: Sequence[tuple[Family, float]], centre: complex) -> Seed:
    """Give the seed of a line: where a law breaks it is a corner if the stretches on both sides are pressed there."""
    family, share = which[number]
    line = family.weight, family.stretch.phase, share
    seeds = [
        _seed(other, at, centre)
        for other, at in (which[number], *which[max(number - 1, 0) : number + 2])
        if (other.weight, other.stretch.phase, at) == line
    ]
    return next((seed for seed in seeds if not seed.corner), seeds[0])


def _seed(family: Family, share: float, centre: complex) -> Seed:
    """Give a seed; an end of a stretch is a corner where the line is pressed against it from within."""
    stretch, slope = family.stretch, family.touching(np.array([share]), centre)[1]
    pressed = (share == stretch.start and slope >= 0) or (share == stretch.end and slope <= 0)
    return Seed(family, share, pressed)


def _nearest(cam: Cam, start: complex) -> complex:
    normals, bounds, which = _lines(tuple(_families(cam)))
    found = nearest(start, normals, bounds)
    if found is None:
        raise no_region(cam, limits_of(cam))
    at, lying = found
    if not lying:
        raise vanishing(cam, limits_of(cam))
    seeds = _apart(tuple(_pressed(line, which, at) for line in lying))
    place, shares = _touched(seeds, at, cam, start)
    if len(seeds) == 2:
        parts = zip(seeds, _pressures(seeds, shares, start - place), strict=True)
        pressed = [seed for seed, part in parts if part >= 0]
        return place if len(pressed) == 2 else _touched(pressed, place, cam, start)[0]
    beyond = ((normals.conj() * place).real - bounds) / np.abs(normals)
    worst = int(np.argmax(beyond))  # closing in on one touch may go over another line
    broken = worst if beyond[worst] > EXACT * abs(place) else None
    if broken is None or len(both := _apart((*seeds, _pressed(broken, which, place)))) == 1:
        return place
    return _touched(both, place, cam, start)[0]


def _touched(seeds: Sequence[Seed], at: complex, cam: Cam, start: complex) -> tuple[complex, list[float]]:
    """Give the place on one limiting line nearest to the start, or that on two, with the shares of the touches."""

    def foot(centre: complex, shares: Sequence[float]) -> float:
        """Of one line alone: O lies square to it from the start."""
        return ((start - centre) / seeds[0].normal(shares[0])).imag

    return _polished(seeds, at, cam, [] if len(seeds) == 2 else [foot])


def _pressures(seeds: Sequence[Seed], shares: Sequence[float], off: complex) -> Floats:
    """Give by how much each of two lines holds O off the start: below 0 O would leave it towards the start."""
    normals = np.array([seed.normal(share) for seed, share in zip(seeds, shares, strict=True)])
    return np.asarray(np.linalg.solve([normals.real, normals.imag], [off.real, off.imag]))


def _apart(seeds: tuple[Seed, ...]) -> tuple[Seed, ...]:
    """Leave one of two seeds that stand beside each other on one grid: between them one line of the family touches."""
    first, last = seeds[0], seeds[-1]
    between = np.diff(np.searchsorted(first.family.stretch.grid, [first.share, last.share]))
    return seeds[:1] if first.family is last.family and abs(int(between[0])) <= 1 else seeds


def _on_circle(cam: Cam, start: complex, radius: float) -> complex:
    normals, bounds, which = _lines(tuple(_families(cam)))
    places, numbers = on_circle(radius, normals, bounds)
    below = [k for k, spot in enumerate(places.tolist()) if (spot * start.conjugate()).imag * cam.follower.sense < 0]
    if not below:
        raise no_region(cam, limits_of(cam))
    best = min(below, key=lambda k: abs(places[k] - start))
    at = complex(places[best])
    size = cam.follower.length or 0.0
    seeds = (_pressed(numbers[best], which, at),)
    return _polished(seeds, at, cam, [lambda centre, _: (abs(centre) ** 2 - radius**2) / size])[0]


def _polished(seeds: Sequence[Seed], at: complex, cam: Cam, others: Sequence[Condition]) -> tuple[complex, list[float]]:
    """Solve for O and the shares of the touches by Newton's method with a Jacobian of differences."""
    scale = cam.follower.length or 0.0
    free = [seed.family.stretch for seed in seeds if not seed.corner]
    low = np.array([-np.inf, -np.inf, *(stretch.start for stretch in free)])
    high = np.array([np.inf, np.inf, *(stretch.end for stretch in free)])
    unknowns = np.array([at.real / scale, at.imag / scale, *(seed.share for seed in seeds if not seed.corner)])

    def residual(values: Floats) -> Floats:
        return _residual(seeds, scale * complex(values[0], values[1]), values[2:].tolist(), others) / scale

    for _ in range(STEPS):
        near = np.eye(len(unknowns)) * STEP
        slopes = [(residual(unknowns + off) - residual(unknowns - off)) / (2 * STEP) for off in near]
        step = np.linalg.solve(np.array(slopes).T, residual(unknowns))
        unknowns = np.clip(unknowns - step, low, high)
        if np.abs(step[:2]).max() <= 2 * np.finfo(float).eps:
            break
    places = iter(unknowns[2:].tolist())
    return scale * complex(unknowns[0], unknowns[1]), [seed.share if seed.corner else next(places) for seed in seeds]


def _residual(seeds: Sequence[Seed], centre: complex, free: Sequence[float], others: Sequence[Condition]) -> Floats:
    """Give a of all touches, da/dφ of those that are no corners, and what else is asked of O."""
    places = iter(free)
    shares = [seed.share if seed.corner else next(places) for seed in seeds]
    touching = [seed.family.touching(np.array([share]), centre) for seed, share in zip(seeds, shares, strict=True)]
    slopes = [touch[1] for seed, touch in zip(seeds, touching, strict=True) if not seed.corner]
    return np.array([*(touch[0] for touch in touching), *slopes, *(condition(centre, shares) for condition in others)])
