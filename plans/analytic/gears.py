"""Speeds of a gear train by one linear system of meshes, brakes, clutches and shafts that are one, in fractions."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import NamedTuple

from plans.model.gears import FRAME, BoxGear, Train, joint_name
from plans.model.motion import Gap
from plans.model.trains import equations, inertia, reduced, shares, table

Mesh = tuple[str, str]
ROUNDED = 2.0**-40  # of powers: far above what their sums lose, far below what circulates anywhere


def speeds(train: Train, gear: BoxGear) -> Mapping[str, Fraction]:
    """Give the speeds rad/s of all links, exact for the speeds that the drives are given."""
    given = [Fraction(speed) for _, speed in train.drives]
    rows = shares(train, gear).items()
    return {link: sum((u * w for u, w in zip(row, given, strict=True)), Fraction(0)) for link, row in rows}


def ratio_with(train: Train, first: str, other: str, carrier: str) -> Fraction:
    """Give the ratio of two links where a carrier is held and nothing else, brakes, clutches or joined shafts."""
    held = BoxGear("", () if carrier == FRAME else (carrier,), ())
    rows = *equations(replace(train, joined=()), held), {other: Fraction(1), "": Fraction(1)}
    found, place = reduced(table(rows, (*train.links, "")), len(train.links)), train.links.index(first)
    return next(row[-1] for row in found if row[place])


def velocity(train: Train, speeds: Mapping[str, Fraction], link: str, height: Fraction) -> float:
    """Give the velocity m/s of a point of a link: omega r, of a planet's over that of its centre."""
    carrier = train.carrier_of.get(link)
    centre = speeds[carrier] * (train.heights[link] - train.heights[carrier]) if carrier else Fraction(0)
    return float(centre + speeds[link] * (height - train.heights[link]))


class LoadBalance(NamedTuple):
    """Forces of meshes, times half their modules, and moments N*m: on drives, on what is held, through joints."""

    forces: tuple[Fraction, ...]
    moments: Mapping[str, float]


def balance(train: Train, gear: BoxGear, load: float) -> LoadBalance | None:
    """Give what balances a load by equilibrium of each link.

    Each equation of speeds has a multiplier: of a mesh half the module times its force, of what is held its moment.
    Nothing where more conditions hold than are independent: then the moments hang on how stiff the links are.
    """
    drives, rows = [link for link, _ in train.drives], [*equations(train, gear)]
    matrix = []
    for link in train.links:
        own = [Fraction(row.get(link, 0)) for row in rows] + [Fraction(link == drive) for drive in drives]
        matrix.append([*own, -Fraction(load) * (link == train.output)])
    found = [row[-1] for row in reduced(matrix, len(rows) + len(drives))]
    if len(found) < len(rows) + len(drives):
        return None
    forces, free = len(train.meshes), len(rows) - len(train.joints)
    names = {**dict(zip(drives, found[len(rows) :], strict=True)), **dict(zip(gear.held, found[forces:], strict=False))}
    names |= zip(map(joint_name, train.joints), found[free : len(rows)], strict=True)
    return LoadBalance(tuple(found[:forces]), {name: float(moment) for name, moment in names.items()})


def passed(train: Train, speeds: Mapping[str, Fraction], forces: Sequence[Fraction]) -> Mapping[Mesh, Fraction]:
    """Give what share of its moment each mesh passes on from its first wheel: less where that drives, else more.

    A wheel drives that gives power to the mesh as its carrier sees it; where it gives none nothing is lost.
    """
    found = {}
    for mesh, (one, other), force in zip(train.meshes, train.pairs, forces, strict=True):
        carrier = "" if one.link in train.crossing else train.carrier_between(one, other)
        power = force * train.rolling(mesh)[0] * (speeds[one.link] - speeds.get(carrier, Fraction(0)))  # it gets that
        found[mesh] = train.efficiency[mesh] ** ((power < 0) - (power > 0))
    return found


class TrainFriction(NamedTuple):
    """A load that is balanced with friction: what meshes pass on, moments, efficiency; whether the train locks itself.

    Then (самоторможение) no forces agree with their powers, and the efficiency is that by powers without friction.
    """

    train: Train
    moments: Mapping[str, float]
    efficiency: float
    locks: bool


def friction(train: Train, gear: BoxGear, load: float) -> TrainFriction | None:
    """Balance a load with friction: by its powers without, then by those that it has with it, until they agree."""
    turns, plain, tried = speeds(train, gear), balance(train, gear, load), list[Train]()
    if plain is None:
        return None
    found, with_it = plain, train
    while with_it not in tried:
        tried.append(with_it)
        found = balance(with_it, gear, load) or found
        with_it = replace(train, factors=passed(train, turns, found.forces))
    locks = with_it != tried[-1]
    with_it = tried[1] if locks else with_it
    lossy = balance(with_it, gear, load)
    powers = [lossy.moments[link] * float(turns[link]) for link, _ in train.drives] if lossy else []
    brought = sum(powers) if train.single else sum(power for power in powers if power > 0)
    if lossy is None or not brought:
        return TrainFriction(with_it, {}, 0.0, True)
    return TrainFriction(with_it, lossy.moments, 1 - (sum(powers) + load * float(turns[train.output])) / brought, locks)


@dataclass(frozen=True)
class TrainSpeeds:
    """The speeds of a train by the analysis; a train that is read has no gaps."""

    train: Train
    by: str = "analysis"
    unanswered: tuple[Gap, ...] = ()

    def shares(self, gear: BoxGear) -> Mapping[str, tuple[Fraction, ...]]:
        """Give the speed of each link as shares of those of the drives."""
        return shares(self.train, gear)

    def true(self, gear: BoxGear) -> Mapping[str, float]:
        """Give the speeds rad/s of all links, each rounded once."""
        return {link: float(speed) for link, speed in speeds(self.train, gear).items()}

    def rack(self, gear: BoxGear, rack: str) -> float:
        """Give the velocity m/s of a rack: that of its wheel's pitch circle."""
        wheel = self.train.wheels[self.train.racks[rack]]
        return float(speeds(self.train, gear)[wheel.link] * self.train.rack_side(rack) * wheel.radius)

    def travel(self, gear: BoxGear, rack: str) -> float | None:
        """Give how far a rack goes, mm, in a turn of the driving link: pi m z over the ratio of its wheel."""
        wheel = self.train.wheels[self.train.racks[rack]]
        share = self.shares(gear)[wheel.link][0] * self.train.rack_side(rack)
        return float(share) * math.pi * float(2000 * wheel.radius) if self.train.single else None

    def inertia(self, gear: BoxGear, link: str) -> float | None:
        """Give the moment of inertia kg*m2 of all links, reduced to one; nothing where it rests or none is given."""
        return inertia(self.train, gear, link)

    def moments(self, gear: BoxGear) -> Mapping[str, float]:
        """Give the moments N*m on the driving and the held links that balance the load, which resists the motion."""
        speed = self.true(gear)[self.train.output]
        if self.train.load is None or not speed:
            return {}
        found = balance(self.train, gear, -math.copysign(self.train.load, speed))
        return found.moments if found else {}

    def friction(self, gear: BoxGear) -> TrainFriction | None:
        """Give what balances the load with friction in the meshes, if that is given; without a load 1 N*m is one."""
        speed = self.true(gear)[self.train.output]
        if not self.train.efficiency or not speed:
            return None
        found = friction(self.train, gear, -math.copysign((self.train.load or 1.0) / self.train.slides, speed))
        return found._replace(efficiency=found.efficiency * self.train.slides) if found else None

    def powers(self, gear: BoxGear) -> Mapping[str, float]:
        """Give the power W of the driving links and those through joints, from the second link to the first."""
        speeds, moments = self.true(gear), self.moments(gear)
        links = {link: link for link, _ in self.train.drives}
        links |= {joint_name(pair): pair[0] for pair in self.train.joints}
        return {name: moment * speeds[links[name]] for name, moment in moments.items() if name in links}

    def circulates(self, gear: BoxGear) -> bool:
        """Whether a row gives a joined shaft, or takes from it, more power than the drive brings (циркуляция)."""
        powers = self.powers(gear)
        drives = {link: powers[link] for link, _ in self.train.drives}
        brought = sum(power for power in drives.values() if power > 0)
        given = dict.fromkeys(self.train.links, 0.0) | {link: -power for link, power in drives.items()}
        given[self.train.output] += sum(drives.values())
        for pair in self.train.joints:
            given[pair[0]] -= powers[joint_name(pair)]
            given[pair[1]] += powers[joint_name(pair)]
        engaged = {link for pair in gear.locked for link in pair}  # what a clutch gives its shafts is not found
        return any(abs(given[link]) > brought * (1 + ROUNDED) for link in given.keys() - engaged)

    def ratio(self, gear: BoxGear) -> Fraction | None:
        """Give the ratio U of the driving link to the driven one; nothing of a differential, or where that rests."""
        share = self.shares(gear)[self.train.output][0]
        return 1 / share if self.train.single and share else None
