"""A counterweight by the static moment that it must have: place from mass, or mass from place (противовес; fig 8.8)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from plans.balance.refusals import NEGATIVE, OFF, Refused
from plans.balance.sums import Term
from plans.model.balance.linkage import EPS, ROUNDING, Counterweight, Place
from plans.model.dyad import Dyad
from plans.model.group import Group
from plans.model.mechanism import Mechanism


def begins(mechanism: Mechanism, groups: Sequence[Group]) -> Mapping[int, str]:
    """Give by link the point that its counterweight counts from: toward the frame, in its group the outer hinge.

    A link without one, guided as a slider is, turns nothing against its mass and carries none.
    """
    found = {mechanism.drive.link: mechanism.drive.pivot}
    for group in groups:
        assert isinstance(group, Dyad)  # the only groups that a mechanism is broken into
        found |= {link: joint for link, joint in zip(group.links, group.outer, strict=True) if isinstance(joint, str)}
    return found


def weight_of(mechanism: Mechanism, place: Place, begin: str, need: Term) -> Counterweight:
    """Give the counterweight of a static moment kg*m in its link's frame about the point that it counts from."""
    origin = mechanism.links[place.link].points[begin]
    mass = _mass(place, need, begin, line_of(mechanism, place.link, begin))
    return Counterweight(place, begin, origin, need.value + 0, mass)  # of a zero no -0


def line_of(mechanism: Mechanism, link: int, begin: str) -> complex:
    """Give the unit direction of a link's line in its own frame: from where it begins to the first of its other points.

    A link of one point, such as a block, has its own +x axis.
    """
    points = mechanism.links[link].points
    ways = (place - points[begin] for point, place in points.items() if place != points[begin])
    way = next(ways, 1 + 0j)
    return way / abs(way)


def _mass(place: Place, need: Term, begin: str, along: complex) -> float:
    """Find the mass: the given one, or that of a radius, of a place on the link's line, or of a sector."""
    if place.mass is not None:
        return place.mass
    if place.radius is not None:
        return abs(need.value) / place.radius
    return _sector(place, abs(need.value)) if place.at is None else _on_line(place, place.at, need, begin, along)


def _on_line(place: Place, at: float, need: Term, begin: str, along: complex) -> float:
    """Find the mass at a place on the link's line, on which the static moment must lie."""
    across, way = (need.value / along).imag, (need.value / along).real
    if abs(across) > ROUNDING * EPS * need.size:
        angle = math.degrees(math.atan2(across, way))
        raise Refused(OFF, place.link, "at", angle=f"{angle:.4g}", radius=f"{abs(at):.6g}")
    if way / at < 0:
        mass, other = f"{abs(way / at):.6g}", f"{-at:.6g}"
        raise Refused(NEGATIVE, place.link, "at", mass=mass, point=begin, other=other)
    return way / at


def _sector(place: Place, moment: float) -> float:
    """Find the mass of a sector with its apex where the link begins: m*r = 2/3 density thickness sin(half angle) R3."""
    solid = place.density * place.thickness
    outer = math.cbrt(1.5 * moment / (solid * math.sin(place.half_angle)))
    return solid * place.half_angle * outer**2
