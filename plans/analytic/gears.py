"""Speeds of a gear train by one linear system of meshes, brakes, clutches and shafts that are one, in fractions."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from plans.model.gears import FRAME, BoxGear, Train, joint_name
from plans.model.motion import Gap
from plans.model.trains import Row, equations, matrix, reduced

ROUNDED = 2.0**-40  # of powers: far above what their sums lose, far below what circulates anywhere


def shares(train: Train, gear: BoxGear) -> Mapping[str, tuple[Fraction, ...]]:
    """Give the speed of each link as shares of those of the drives."""
    count, links = len(train.drives), train.links
    rows = [*matrix(train, gear, count), *_drives(train)]
    return {link: tuple(row[len(links) :]) for link, row in zip(links, reduced(rows, len(links)), strict=True)}


def _drives(train: Train) -> list[Row]:
    """Give the equation of each drive: its link has its own speed."""
    found = []
    for k, (link, _) in enumerate(train.drives):
        row = [Fraction(0)] * (len(train.links) + len(train.drives))
        row[train.links.index(link)] = row[len(train.links) + k] = Fraction(1)
        found.append(row)
    return found


def speeds(train: Train, gear: BoxGear) -> Mapping[str, Fraction]:
    """Give the speeds rad/s of all links, exact for the speeds that the drives are given."""
    given = [Fraction(speed) for _, speed in train.drives]
    return {
        link: sum((u * w for u, w in zip(row, given, strict=True)), Fraction(0))
        for link, row in shares(train, gear).items()
    }


def ratio_with(train: Train, first: str, other: str, carrier: str) -> Fraction:
    """Give the ratio of two links where a carrier is held and nothing else, brakes, clutches or joined shafts."""
    bare, place, last = replace(train, joined=()), train.links.index(first), len(train.links)
    rows = matrix(bare, BoxGear("", () if carrier == FRAME else (carrier,), ()), 1)
    drive = [Fraction(0)] * (last + 1)
    drive[train.links.index(other)] = drive[last] = Fraction(1)
    return next(row for row in reduced([*rows, drive], last) if row[place])[last]


def velocity(train: Train, speeds: Mapping[str, Fraction], link: str, height: Fraction) -> float:
    """Give the velocity m/s of a point of a link: omega r, of a planet's over that of its centre."""
    carrier = train.carrier_of.get(link)
    centre = speeds[carrier] * (train.heights[link] - train.heights[carrier]) if carrier else Fraction(0)
    return float(centre + speeds[link] * (height - train.heights[link]))


def moments(train: Train, gear: BoxGear, load: float) -> Mapping[str, float]:
    """Give the moments N*m on the driving link, on those that are held, through joints, by equilibrium of each link.

    Each equation of speeds has a multiplier: of a mesh half the module times its force, of what is held its moment.
    Nothing where more conditions hold than are independent: then the moments hang on how stiff the links are.
    """
    driving, rows = train.drives[0][0], [*equations(train, gear)]
    matrix = []
    for link in train.links:
        own = [Fraction(row.get(link, 0)) for row in rows]
        matrix.append([*own, Fraction(link == driving), -Fraction(load) * (link == train.output)])
    found = reduced(matrix, len(rows) + 1)
    if len(found) < len(rows) + 1:
        return {}
    moments = [float(row[-1]) for row in found]
    held, joints = moments[len(train.meshes) :], moments[len(rows) - len(train.joints) : -1]
    through = zip(map(joint_name, train.joints), joints, strict=True)
    return {driving: moments[-1], **dict(zip(gear.held, held, strict=False)), **dict(through)}


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
        train, shares = self.train, self.shares(gear)
        if not (train.inertia or train.masses) or not train.single or not shares[link][0]:
            return None
        turns = {name: (share[0] / shares[link][0]) for name, share in shares.items()}
        total = sum(train.count(one) * size * float(turns[one]) ** 2 for one, size in train.inertia.items())
        for one, mass in train.masses.items():
            carrier = train.carrier_of[one]
            arm = turns[carrier] * (train.heights[one] - train.heights[carrier])
            total += train.count(one) * mass * float(arm) ** 2
        return total

    def moments(self, gear: BoxGear) -> Mapping[str, float]:
        """Give the moments N*m on the driving and the held links that balance the load, which resists the motion."""
        speed = self.true(gear)[self.train.output]
        if self.train.load is None or not speed:
            return {}
        return moments(self.train, gear, -math.copysign(self.train.load, speed))

    def powers(self, gear: BoxGear) -> Mapping[str, float]:
        """Give the power W of the driving link and those through joints, from the second link to the first."""
        speeds, moments = self.true(gear), self.moments(gear)
        links = {joint_name(pair): pair[0] for pair in self.train.joints}
        links[self.train.drives[0][0]] = self.train.drives[0][0]
        return {name: moment * speeds[links[name]] for name, moment in moments.items() if name in links}

    def circulates(self, gear: BoxGear) -> bool:
        """Whether a row gives a joined shaft, or takes from it, more power than the drive brings (циркуляция)."""
        powers, drive = self.powers(gear), self.train.drives[0][0]
        given = dict.fromkeys(self.train.links, 0.0) | {drive: -powers[drive]}
        given[self.train.output] += powers[drive]
        for pair in self.train.joints:
            given[pair[0]] -= powers[joint_name(pair)]
            given[pair[1]] += powers[joint_name(pair)]
        engaged = {link for pair in gear.locked for link in pair}  # what a clutch gives its shafts is not found
        return any(abs(given[link]) > abs(powers[drive]) * (1 + ROUNDED) for link in given.keys() - engaged)

    def ratio(self, gear: BoxGear) -> Fraction | None:
        """Give the ratio U of the driving link to the driven one; nothing of a differential, or where that rests."""
        share = self.shares(gear)[self.train.output][0]
        return 1 / share if self.train.single and share else None
