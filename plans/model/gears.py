"""Gear trains (зубчатые механизмы): wheels, links, carriers, what is held and engaged, where the axes lie.

Numbers of teeth, modules and heights are exact: a ratio is a quotient of whole numbers. The teeth of a ring (колесо с
внутренними зубьями) count negative, so that one equation is of all meshes: (w_a - w_H) z_a + (w_b - w_H) z_b = 0.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import combinations, product
from typing import Any, NamedTuple

import numpy as np

FRAME = "0"
ACROSS = ("up", "down")  # sides of an apex where a bevel wheel stands whose axis is not level


def link_of(wheel: str) -> str:
    """Name the link of a wheel: wheels of one block differ by primes.

    >>> link_of("2''")
    '2'
    """
    return wheel.rstrip("'′")


class ToothedWheel(NamedTuple):
    """A wheel: its name, the number of its teeth, negative of a ring, its module m; a bevel wheel's side of its apex.

    Its axis is level left and right of the apex (вершина конусов), and across, square to that, up and down.
    """

    name: str
    teeth: int
    module: Fraction
    side: str = ""

    @property
    def link(self) -> str:
        """Its link."""
        return link_of(self.name)

    @property
    def radius(self) -> Fraction:
        """The radius m of its pitch circle."""
        return self.module * abs(self.teeth) / 2

    @property
    def internal(self) -> bool:
        """Whether it is a ring."""
        return self.teeth < 0


class BevelMesh(NamedTuple):
    """A bevel wheel of a level axis and one of an axis across; the sense of that, +1 or -1, makes its arm positive."""

    level: ToothedWheel
    cross: ToothedWheel
    sense: int

    @property
    def up(self) -> int:
        """Give 1 of a mesh point over the level axis, -1 of one under it."""
        return 1 if self.cross.side == "up" else -1

    @property
    def place(self) -> tuple[Fraction, Fraction]:
        """The mesh point from the apex, m across and up: on the common edge of the cones."""
        return self.cross.radius * (-1 if self.level.side == "left" else 1), self.level.radius * self.up

    @property
    def arm(self) -> Fraction:
        """The velocity m/s of the mesh point at a speed of 1 rad/s about the axis across."""
        return self.cross.radius * self.sense

    @property
    def tip(self) -> float:
        """The half angle, degrees, of the tip cone of the wheel across, its addendum a module."""
        teeth = self.cross.teeth, self.level.teeth
        return math.degrees(math.atan2(*teeth) + math.atan(2 / math.hypot(*teeth)))

    def moved(self, factor: Fraction) -> BevelMesh:
        """Give the mesh with its point moved across, so that the ratio is so many times greater."""
        return self._replace(cross=self.cross._replace(module=self.cross.module * factor))

    @property
    def signed(self) -> Mapping[str, int]:
        """The teeth so signed that (w_l - w_H) z_l + w_c z_c = 0, w_c over the carrier H."""
        return {self.level.name: self.level.teeth * self.up, self.cross.name: -self.cross.teeth * self.sense}


def bevel_mesh(one: ToothedWheel, other: ToothedWheel, planet: bool) -> BevelMesh:
    """Put two bevel wheels in order; the sense of a fixed axis across is chosen so that no ratio is negative."""
    level, cross = (other, one) if one.side in ACROSS else (one, other)
    found = BevelMesh(level, cross, 1 if level.side == "left" else -1)
    return found if planet else found._replace(sense=found.up)


def centre_of(meshes: Sequence[BevelMesh]) -> Fraction:
    """Give the height m over the apex where the line of its mesh points crosses the axis of a planet."""
    (x, y), (x2, y2) = meshes[0].place, meshes[-1].place
    return y if len(meshes) == 1 else (y * x2 - y2 * x) / (x2 - x)


class BoxGear(NamedTuple):
    """A gear of a box (передача, ступень): its name, the links that are held, the pairs of links that turn as one."""

    name: str
    held: tuple[str, ...]
    locked: tuple[tuple[str, str], ...]


def freed(gear: BoxGear, link: str, held: Iterable[str]) -> BoxGear:
    """Give a gear in which one link is free and others are held, under a name of its own."""
    return BoxGear(f"{gear.name}({link})", tuple(held), gear.locked)


def joint_name(pair: tuple[str, str]) -> str:
    """Name the joint of two shafts.

    >>> joint_name(("H", "4"))
    'H–4'
    """
    return "\N{EN DASH}".join(pair)


class Willis(NamedTuple):
    """Two wheels of fixed axes joined by planets of a carrier: the wheels driven and driving on the way, and the ratio.

    `ratio` is U_ab^H: of the first to the other with the carrier stopped; without a carrier it is that of the links.
    """

    first: ToothedWheel
    other: ToothedWheel
    carrier: str
    driven: tuple[ToothedWheel, ...]
    driving: tuple[ToothedWheel, ...]
    ratio: Fraction


@dataclass(frozen=True)
class Train:
    """A gear train; by the names of wheels and links. Heights m are of the axes and mesh points over the main axis."""

    wheels: Mapping[str, ToothedWheel]
    meshes: tuple[tuple[str, str], ...]
    carriers: Mapping[str, tuple[str, ...]]  # each with the links that turn on it
    joined: tuple[tuple[str, ...], ...]  # shafts that are one
    gears: tuple[BoxGear, ...]
    drives: tuple[tuple[str, float], ...]  # links and their speeds rad/s
    output: str
    axes: Mapping[str, Fraction]  # heights of the axes of links, of those across of their apexes
    brakes: Mapping[str, str]
    clutches: Mapping[str, tuple[str, str]]
    planets: int | None = None  # of each carrier, if it is given
    load: float | None = None  # N*m, that resists the driven link
    inertia: Mapping[str, float] = field(default_factory=dict)  # kg*m2 of links about their own axes, of one planet
    masses: Mapping[str, float] = field(default_factory=dict)  # kg of one planet
    efficiency: Mapping[tuple[str, str], Fraction] = field(default_factory=dict)  # of meshes, their carrier stopped
    factors: Mapping[tuple[str, str], Fraction] = field(default_factory=dict)  # of the ratios of meshes, by friction
    racks: Mapping[str, str] = field(default_factory=dict)  # each with the wheel that moves it, of a fixed axis
    driven: str = ""  # the rack that the driven link moves, if that is what is driven

    @property
    def single(self) -> bool:
        """Whether one link drives, so that there is a ratio."""
        return len(self.drives) == 1

    @cached_property
    def links(self) -> tuple[str, ...]:
        """The links in the order of their wheels, then the carriers."""
        return tuple(dict.fromkeys((*(wheel.link for wheel in self.wheels.values()), *self.carriers)))

    @cached_property
    def carrier_of(self) -> Mapping[str, str]:
        """The carriers of the links that turn on one: the planets (сателлиты)."""
        return {link: carrier for carrier, links in self.carriers.items() for link in links}

    @cached_property
    def body_of(self) -> Mapping[str, str]:
        """The first link of the shafts that are one, of each link."""
        return bodies(self.links, self.joined)

    @property
    def joints(self) -> tuple[tuple[str, str], ...]:
        """The pairs of links whose shafts are one."""
        return tuple((group[0], other) for group in self.joined for other in group[1:])

    @property
    def pairs(self) -> Iterator[tuple[ToothedWheel, ToothedWheel]]:
        """The wheels that mesh."""
        return ((self.wheels[one], self.wheels[other]) for one, other in self.meshes)

    @cached_property
    def bevels(self) -> Mapping[tuple[str, str], BevelMesh]:
        """The meshes of bevel wheels (конические колёса), with friction their points moved across."""
        rows = zip(self.meshes, self.pairs, strict=True)
        found = {mesh: bevel_mesh(*pair, self.carrier_between(*pair) != FRAME) for mesh, pair in rows if pair[0].side}
        powers = {mesh: 1 if row.cross.name == mesh[1] else -1 for mesh, row in found.items()}
        return {mesh: row.moved(self.factors.get(mesh, Fraction(1)) ** powers[mesh]) for mesh, row in found.items()}

    @cached_property
    def crossing(self) -> Mapping[str, tuple[BevelMesh, ...]]:
        """The links whose axes lie across, with their meshes."""
        links = dict.fromkeys(one.cross.link for one in self.bevels.values())
        return {link: tuple(one for one in self.bevels.values() if one.cross.link == link) for link in links}

    @cached_property
    def heights(self) -> Mapping[str, Fraction]:
        """The height of the axis of each link; of one across of its centre, which friction moves with its meshes."""
        centres = {link: self.axes[rows[0].level.link] + centre_of(rows) for link, rows in self.crossing.items()}
        return {**self.axes, **centres}

    def rolling(self, mesh: tuple[str, str]) -> tuple[Fraction, Fraction]:
        """Give the signed teeth of two wheels that mesh, of the second times what friction makes of their ratio."""
        one, other = self.signed(*(self.wheels[name] for name in mesh))
        return Fraction(one.teeth), other.teeth * self.factors.get(mesh, Fraction(1))

    @property
    def slides(self) -> float:
        """The efficiency of the mesh of the driven rack, if a rack is driven and that is given."""
        return math.prod(float(part) for mesh, part in self.efficiency.items() if self.driven in mesh)

    def contact(self, mesh: tuple[str, str]) -> Fraction:
        """Give the height m of the mesh point of two wheels: it divides the line of centres as their teeth."""
        if mesh in self.bevels:
            return self.heights[self.bevels[mesh].level.link] + self.bevels[mesh].place[1]
        y_one, y_other = (self.heights[self.wheels[name].link] for name in mesh)
        one, other = self.rolling(mesh)
        return (y_one * other + y_other * one) / (one + other)

    def rack_side(self, rack: str) -> int:
        """Give 1 of a rack over its wheel, -1 of one under it, where another wheel or rack is over it already."""
        wheel, first = self.racks[rack], next(one for one, wheel in self.racks.items() if wheel == self.racks[rack])
        y, r = self.heights[self.wheels[wheel].link], self.wheels[wheel].radius
        return -1 if rack != first or any(wheel in mesh and self.contact(mesh) == y + r for mesh in self.meshes) else 1

    def rack_height(self, rack: str) -> Fraction:
        """Give the height m where a rack meshes."""
        wheel = self.wheels[self.racks[rack]]
        return self.heights[wheel.link] + self.rack_side(rack) * wheel.radius

    def count(self, link: str) -> int:
        """Give how many of a link there are: of a planet as many as each carrier has."""
        return self.planets or 1 if link in self.carrier_of else 1

    def meshes_of(self, link: str) -> Iterator[tuple[ToothedWheel, ToothedWheel]]:
        """Give the meshes of a link's wheels, its own wheel first."""
        for one, other in self.pairs:
            if one.link == link:
                yield one, other
            elif other.link == link:
                yield other, one

    def carrier_between(self, one: ToothedWheel, other: ToothedWheel) -> str:
        """Give the carrier of the planet of a mesh; the frame where both axes are fixed."""
        return self.carrier_of.get(one.link) or self.carrier_of.get(other.link) or FRAME

    def signed(self, one: ToothedWheel, other: ToothedWheel) -> tuple[ToothedWheel, ToothedWheel]:
        """Give two wheels that mesh with the signs of their teeth there: w_one/w_other = -z_other/z_one."""
        found = self.bevels.get((one.name, other.name)) or self.bevels.get((other.name, one.name))
        teeth = found.signed if found else {}
        first, second = (wheel._replace(teeth=teeth.get(wheel.name, wheel.teeth)) for wheel in (one, other))
        return first, second

    @cached_property
    def willis(self) -> tuple[Willis, ...]:
        """The formulas of Willis: of the wheels of fixed axes about each planet, then of those that mesh themselves."""
        found: dict[frozenset[str], Willis] = {}
        for link, carrier in self.carrier_of.items():
            first, *others = sorted(self._ways(link, frozenset()), key=len)
            for way in others if len(first) == 1 else ():
                one = self._willis(first[0][1], first[0][0], way, carrier)
                found.setdefault(frozenset((one.first.name, one.other.name)), one)
        fixed = ((a, b) for a, b in self.pairs if self.carrier_between(a, b) == FRAME)
        return *found.values(), *(Willis(a, b, "", (b,), (a,), self._ratio(a, b)) for a, b in fixed)

    def _ratio(self, one: ToothedWheel, other: ToothedWheel) -> Fraction:
        """Give the ratio of two wheels that mesh, with the carrier stopped."""
        a, b = self.signed(one, other)
        return Fraction(-b.teeth, a.teeth)

    def _willis(
        self, first: ToothedWheel, own: ToothedWheel, way: Sequence[tuple[ToothedWheel, ToothedWheel]], carrier: str
    ) -> Willis:
        driving, driven = (first, *(one for one, _ in way)), (own, *(other for _, other in way))
        ratio = math.prod((self._ratio(a, b) for a, b in zip(driving, driven, strict=True)), start=Fraction(1))
        return Willis(first, way[-1][1], carrier, driven, driving, ratio)

    def _ways(self, link: str, seen: frozenset[str]) -> Iterator[tuple[tuple[ToothedWheel, ToothedWheel], ...]]:
        """Give the meshes on the ways from a planet to the wheels of fixed axes, by itself or through other planets."""
        for own, other in self.meshes_of(link):
            if other.link not in self.carrier_of:
                yield ((own, other),)
            elif other.link not in seen:
                yield from (((own, other), *rest) for rest in self._ways(other.link, seen | {link}))


def bodies(links: Collection[str], joined: Collection[tuple[str, ...]]) -> Mapping[str, str]:
    """Give of each link the one that it is one with, as its joint names it first; the frame where that is among them.

    >>> bodies(["1", "2", "3", "4"], [("2", "4"), ("3", "2")])["4"]
    '3'
    """
    found = {link: link for link in (*links, FRAME)}
    for group in joined:
        same = [link for link in found if found[link] in {found[one] for one in group}]
        found |= dict.fromkeys(same, FRAME if FRAME in same else found[group[0]])
    return found


def share_of(one: tuple[Any, Any], other: tuple[Any, Any], count: int) -> tuple[Any, Any]:
    """Give what must divide into whole that blocks alike fit between two central wheels, each z and that of the planet.

    A planet that rolls by 1/k about either wheel must stand as the first one does, or turned by whole teeth of both its
    wheels, which are parts of their common divisor: (z_1 z_2' - z_3 z_2)/(k gcd(z_2, z_2')); of one row (z_1 + z_3)/k.

    >>> [Fraction(*map(int, share_of(*row))) for row in (((20, 50), (-95, 25), 3), ((24, 18), (-60, 18), 5))]
    [Fraction(70, 1), Fraction(84, 5)]
    """
    (z1, p1), (z3, p3) = one, other
    return z1 * p3 - z3 * p1, count * np.gcd(p1, p3)


class Assembled(NamedTuple):
    """Two central wheels, the wheel of a planet that each meshes with, and what must be whole that k can be put in."""

    first: ToothedWheel
    inner: ToothedWheel
    other: ToothedWheel
    outer: ToothedWheel
    share: Fraction

    @property
    def blocks(self) -> bool:
        """Whether both are in mesh with different wheels of one block."""
        return self.inner.name != self.outer.name and self.inner.link == self.outer.link

    def parts(self, count: int) -> dict[str, object]:
        """Give the names and numbers of the condition for k planets, the greater term first where one is taken off."""
        divisor = math.gcd(self.inner.teeth, self.outer.teeth) if self.blocks else 1
        same = self.inner.link == self.outer.link
        turned = same and self.inner.internal != self.outer.internal  # as a bevel wheel between two others
        less = (self.first.internal == self.other.internal) == (same and not turned)
        ends = (self.first.name, self.inner.name), (self.other.name, self.outer.name)
        (first, inner), (second, outer) = reversed(ends) if less and (self.share < 0) != self.first.internal else ends
        numbers = {"count": count, "divisor": divisor, "sum": abs(self.share) * count * divisor}
        names = {"first": first, "inner": inner, "second": second, "outer": outer}
        return {**names, **numbers, "sign": "−" if less else "+"}


def assembly(train: Train, link: str) -> Iterator[Assembled]:
    """Give what must be whole of each two central wheels about a planet, or about it and one that it meshes with.

    Of two planets that mesh it is (z_3 - z_1)/k where either meshes by one wheel: they turn against each other.
    """
    count = train.planets or 1
    for (p1, one), (p3, other) in combinations(_central(train, link), 2):
        share = Fraction(*map(int, share_of((one.teeth, p1.teeth), (other.teeth, p3.teeth), count)))
        yield Assembled(one, p1, other, p3, share)
    for a, b in train.pairs:
        if a.link == link and b.link in train.carrier_of:
            for (p1, one), (p3, other) in product(_central(train, a.link), _central(train, b.link)):
                if (p1, p3) == (a, b):
                    yield Assembled(one, a, other, b, Fraction(one.teeth + other.teeth, count))


def _central(train: Train, link: str) -> list[tuple[ToothedWheel, ToothedWheel]]:
    rows = (train.signed(own, other) for own, other in train.meshes_of(link))
    return [(own, other) for own, other in rows if other.link not in train.carrier_of]
