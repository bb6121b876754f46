"""Efficiency of a train by the rule of M. A. Kreines: friction changes the ratio of each mesh (КПД по Крейнесу).

A mesh passes on as much less as its ratio u, times its efficiency, were less: U'(u eta^x) is the ratio of moments, and
eta = U'/U. The power x is the sign of (u/U)(dU/du), which is that of the power that passes the mesh as its carrier sees
it. On the plan the mesh point is moved along the line of centres until it divides that line as u eta^x.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from plans.model.gears import BoxGear, Train
from plans.model.trains import equations, solved


def lossy(train: Train, gear: BoxGear) -> Train:
    """Give the train whose speeds are to each other as moments are with friction, x by differentiating those of it."""
    driving = *equations(train, gear), *({link: Fraction(1), "": Fraction(speed)} for link, speed in train.drives)
    speeds, rows = solved(train, driving, [""]), [*map(dict, driving)]
    changes = [f"d {one}-{other}" for one, other in train.meshes]
    for row, change, (one, other), mesh in zip(rows, changes, train.pairs, train.meshes, strict=False):
        carrier = "" if other.link in train.crossing else train.carrier_between(one, other)
        slip = speeds[other.link][0] - speeds.get(carrier, (Fraction(0),))[0]
        row[change] = -slip * train.rolling(mesh)[1]
    driven, *changed = solved(train, rows, ["", *changes])[train.output]
    powers = [(change * driven < 0) - (change * driven > 0) for change in changed]
    factors = {mesh: train.efficiency[mesh] ** power for mesh, power in zip(train.meshes, powers, strict=True)}
    return replace(train, gears=(gear,), factors=factors)
