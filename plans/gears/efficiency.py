"""Efficiency of a train by the rule of M. A. Kreines: friction changes the ratio of each mesh (КПД по Крейнесу).

A mesh passes on as much less as its ratio u, times its efficiency, were less: U'(u eta^x) is the ratio of moments, and
eta = U'/U. The power x is the sign of (u/U)(dU/du), which is that of the power that passes the mesh as its carrier sees
it. On the plan the mesh point is moved along the line of centres until it divides that line as u eta^x.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from plans.model.gears import BoxGear, Train
from plans.model.trains import Row, matrix, reduced


def lossy(train: Train, gear: BoxGear) -> Train:
    """Give the train whose speeds are to each other as moments are with friction, x by differentiating those of it."""
    speeds, slips = _speeds(train, gear, ()), list[Fraction]()
    for mesh, (one, other) in zip(train.meshes, train.pairs, strict=True):
        carrier = "" if other.link in train.crossing else train.carrier_between(one, other)
        slips.append((speeds[other.link][0] - speeds.get(carrier, [Fraction(0)])[0]) * train.rolling(mesh)[1])
    driven, *changes = _speeds(train, gear, slips)[train.output]
    powers = [(change * driven < 0) - (change * driven > 0) for change in changes]
    factors = {mesh: train.efficiency[mesh] ** power for mesh, power in zip(train.meshes, powers, strict=True)}
    return replace(train, gears=(gear,), factors=factors)


def _speeds(train: Train, gear: BoxGear, slips: Sequence[Fraction]) -> Mapping[str, Row]:
    """Give the speed of each link, and by how much it changes where the ratio of each mesh does."""
    count, more = len(train.links), 1 + len(slips)
    rows = matrix(train, gear, more)
    for k, slip in enumerate(slips):
        rows[k][count + 1 + k] = -slip
    for link, speed in train.drives:
        rows.append([Fraction(one == link) for one in train.links] + [Fraction(0)] * more)
        rows[-1][count] = Fraction(speed)
    return {link: row[count:] for link, row in zip(train.links, reduced(rows, count), strict=True)}
