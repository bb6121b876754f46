"""Synthesis of a planetary train: all teeth that give a wanted ratio and can be made (подбор зубьев).

The distance of axes is gone through, and of each the teeth of the planets: those of the central wheels follow from
coaxiality. Conditions are held in whole numbers. A link that moves as wheel i does has w_i = w_H - s_i (w_2 - w_H) with
s_i = z_p/z_i, negative of a ring, and s_H = 0; so that U = (s_held - s_driving)/(s_held - s_driven).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from plans.gears.axes import RawTrain
from plans.model.gears import link_of, share_of

TIP = 2  # modules by which tips stand beyond the pitch circle, both sides
CLEAR = 8  # teeth that a ring has more than the wheel within it, lest their tips meet (интерференция)
SAFE = 2**62  # products below it are whole numbers of the processor

Teeth: TypeAlias = npt.NDArray[Any]  # of a wheel, in each of many trains; negative of a ring


class Wanted(NamedTuple):
    """What is wanted of a train of one carrier with one block of planets."""

    raw: RawTrain
    rows: tuple[tuple[str, str], ...]  # a central wheel and the wheel of the block that it meshes with
    ends: tuple[str, ...]  # the links held, driving, driven
    ratio: Fraction
    tolerance: Fraction
    planets: tuple[int, ...]  # numbers that are tried, the least first
    least: int
    ring: int
    greatest: int

    @property
    def bounds(self) -> tuple[Fraction, Fraction]:
        """Between what the ratio may be."""
        off = abs(self.ratio) * self.tolerance
        return self.ratio - off, self.ratio + off

    @property
    def sign(self) -> int:
        """The sign that the ratio has whatever the teeth; 0 where it hangs on them: that of slips s_i is known."""
        slips = {link_of(central): -1 if central in self.raw.rings else 1 for central, _ in self.rows}
        held, driving, driven = (slips.get(link, 0) for link in self.ends)
        return (held - driving) * (held - driven)

    def allowed(self, wheel: str) -> tuple[int, int]:
        """Give the least and the greatest teeth of a wheel: those that it is given."""
        given = self.raw.teeth[wheel]
        if given is not None:
            return abs(given), abs(given)
        return self.ring if wheel in self.raw.rings else self.least, self.greatest


class Solution(NamedTuple):
    """Teeth that meet all conditions: by the names of wheels, negative of rings; the most planets, ratio, size m."""

    teeth: Mapping[str, int]
    planets: int
    ratio: Fraction
    across: Fraction  # the diameter of the whole: 2a + m z of the largest planet, that of the ring where there is one


class Searched(NamedTuple):
    """What a search found: how many trains each condition leaves, those with the ratio by size, the nearest one."""

    wanted: Wanted
    coaxial: int
    clear: int
    whole: int
    solutions: tuple[Solution, ...]
    nearest: Solution | None


def search(wanted: Wanted) -> Searched:
    """Find all trains that are coaxial, not undercut, whose planets stand clear, can be put in and give the ratio."""
    counts, near, found = [0, 0, 0], list[Solution](), list[Solution]()
    for row in (_Distance(wanted, far) for far in _distances(wanted)):
        kept = len(row.coaxial), int(row.clear.sum()), int(np.count_nonzero(row.most))
        counts = [one + more for one, more in zip(counts, kept, strict=True)]
        near += row.solutions(row.nearest)
        found += row.solutions(np.flatnonzero(row.within))

    def size(one: Solution) -> tuple[object, ...]:
        return one.across, abs(one.ratio - wanted.ratio), *map(abs, one.teeth.values())

    nearest = min(near, key=lambda one: (abs(one.ratio - wanted.ratio), *size(one)), default=None)
    return Searched(wanted, counts[0], counts[1], counts[2], tuple(sorted(found, key=size)), nearest)


def listed(found: Searched) -> list[dict[str, object]]:
    """List all solutions, the smallest first: teeth, planets, ratio as a fraction, diameter m."""
    return [
        {"teeth": {name: abs(teeth) for name, teeth in one.teeth.items()}, "planets": one.planets}
        | {"ratio": str(one.ratio), "diameter": float(one.across)}
        for one in found.solutions
    ]


def shares(wanted: Wanted) -> tuple[Fraction, Mapping[str, int]]:
    """Give the unit m of all modules, and each as a multiple of it."""
    modules = wanted.raw.modules
    below = math.lcm(*(module.denominator for module in modules.values()))
    unit = Fraction(math.gcd(*(int(module * below) for module in modules.values())), below)
    return unit, {name: int(module / unit) for name, module in modules.items()}


def _distances(wanted: Wanted) -> range:
    """Give the distances 2a that both teeth and modules allow, in units of modules."""
    _, parts = shares(wanted)
    step = math.lcm(*parts.values())
    starts, ends = [step], list[int]()
    for central, planet in wanted.rows:
        (low, high), (least, most), ring = wanted.allowed(central), wanted.allowed(planet), central in wanted.raw.rings
        starts.append(parts[central] * (max(low - most, CLEAR) if ring else low + least))
        ends.append(parts[central] * (high - least if ring else high + most))
    return range(-(-max(starts) // step) * step, min(ends) + 1, step)


def clear_of(count: int, across: Fraction) -> int:
    """Give the most teeth of a planet among so many: z + 2 < 2a/m sin(pi/k), 2a/m being given.

    The sine is 1 or 1/2 of two or six planets; else it is irrational, and rounds to no quotient of teeth.

    >>> clear_of(3, Fraction(50)), clear_of(6, Fraction(50))
    (41, 22)
    """
    sine = {1: Fraction(10**9), 2: Fraction(1), 6: Fraction(1, 2)}.get(count) or Fraction(math.sin(math.pi / count))
    return math.ceil(across * sine) - TIP - 1


class _Distance:
    """All trains with one distance of axes."""

    def __init__(self, wanted: Wanted, far: int) -> None:
        self.wanted, self.far = wanted, far
        self.unit, self.parts = shares(wanted)
        self.blocks = tuple(dict.fromkeys(planet for _, planet in wanted.rows))

    def _row(self, planet: str) -> Mapping[str, Teeth]:
        """Give the teeth of a wheel of the block, with those of the central wheels that mesh with it."""
        across, (low, high) = self.far // self.parts[planet], self.wanted.allowed(planet)
        own = np.arange(low, high + 1)
        found, good = {planet: own}, np.full(own.shape, True)
        for central in (one for one, other in self.wanted.rows if other == planet):
            ring = central in self.wanted.raw.rings
            least, most = self.wanted.allowed(central)
            teeth = across + own if ring else across - own
            good &= (least <= teeth) & (teeth <= most)
            found[central] = -teeth if ring else teeth
        return {name: teeth[good] for name, teeth in found.items()}

    @cached_property
    def teeth(self) -> Mapping[str, Teeth]:
        """The teeth of all wheels: each choice of one row with each of the others."""
        rows = [self._row(planet) for planet in self.blocks]
        places = np.meshgrid(*(np.arange(len(row[p])) for row, p in zip(rows, self.blocks, strict=True)), indexing="ij")
        pairs = zip(rows, places, strict=True)
        return {name: teeth[place.ravel()] for row, place in pairs for name, teeth in row.items()}

    @property
    def coaxial(self) -> Teeth:
        """One wheel's teeth of each train."""
        return self.teeth[self.blocks[0]]

    def _stand_clear(self, count: int) -> Teeth:
        found = np.full(self.coaxial.shape, True)
        for planet in self.blocks:
            found &= self.teeth[planet] <= clear_of(count, Fraction(self.far, self.parts[planet]))
        return found

    @property
    def clear(self) -> Teeth:
        """Whether the fewest planets stand clear of each other."""
        return self._stand_clear(self.wanted.planets[0])

    @cached_property
    def most(self) -> Teeth:
        """The most planets that stand clear and can be put in; 0 where none."""
        found = np.zeros(self.coaxial.shape, dtype=int)
        for count in self.wanted.planets:
            good = self._stand_clear(count)
            for one, other in combinations([(self.teeth[c], self.teeth[p]) for c, p in self.wanted.rows], 2):
                whole, parts = share_of(one, other, count)
                good &= whole % parts == 0
            found[good] = count
        return found

    @cached_property
    def ratio(self) -> tuple[Teeth, Teeth]:
        """The numerator and the denominator, positive, of the ratio; 1/0 of trains whose driven link rests."""
        one = np.ones_like(self.coaxial)
        slips = {link_of(central): (self.teeth[planet], self.teeth[central]) for central, planet in self.wanted.rows}
        (nf, df), (nd, dd), (no, do) = (slips.get(link, (0 * one, one)) for link in self.wanted.ends)
        top, low = (nf * dd - nd * df) * do, (nf * do - no * df) * dd
        return np.where(low, top * np.sign(low), 1), abs(low)

    @cached_property
    def within(self) -> Teeth:
        """Whether a train meets all conditions and has the ratio within its tolerance."""
        (top, low), bounds = self.ratio, self.wanted.bounds
        size = max((int(abs(one).max(initial=0)) for one in (top, low)), default=0)
        if 2 * size * max(abs(part) for one in bounds for part in one.as_integer_ratio()) >= SAFE:
            top, low = top.astype(object), low.astype(object)
        least, greatest = bounds
        above = top * least.denominator >= low * least.numerator
        below = top * greatest.denominator <= low * greatest.numerator
        return np.asarray(above & below & (low > 0) & (self.most > 0), dtype=bool)

    @property
    def nearest(self) -> Teeth:
        """The place of the train that meets all other conditions and comes nearest to the ratio, if there is one."""
        top, low = self.ratio
        good = np.flatnonzero((self.most > 0) & (low > 0) & (top != 0))
        off = abs(top[good] / low[good] - float(self.wanted.ratio))
        return good[off == off.min()][:1] if len(good) else good

    def solutions(self, places: Teeth) -> Iterator[Solution]:
        """Give the trains at some places."""
        top, low = self.ratio
        for k in map(int, places):
            teeth = {name: int(self.teeth[name][k]) for name in self.wanted.raw.teeth}
            widest = max(self.parts[planet] * teeth[planet] for planet in self.blocks)
            ratio = Fraction(int(top[k]), int(low[k]))
            yield Solution(teeth, int(self.most[k]), ratio, self.unit * (self.far + widest))
