"""Teeth in their places: outlines of a few teeth of each wheel in mesh, circles as far as they are shown (зубья)."""

from __future__ import annotations

import cmath
import math
from itertools import pairwise, zip_longest
from typing import NamedTuple

import numpy as np

from plans.model.involute import GearWheel, InvolutePair, PairSizes, Rack, WheelSizes
from plans.model.motion import Complexes

SHOWN = 1.5  # pitches to either side of the line of centres: three teeth of each wheel
PAST = 0.25  # pitches that circles go on beyond them
ARC = 9  # points of an arc at a tip
FAR = 16.0  # modules: a centre farther from P is not shown
FACETS = 48  # of a circle's part


class PlacedWheel(NamedTuple):
    """A wheel in its place: its centre m, the way from there to P, the angle of its middle tooth or space."""

    wheel: GearWheel
    sizes: WheelSizes
    centre: complex
    up: complex
    turned: float  # of that axis from the way to P, rad

    @property
    def step(self) -> float:
        """The angle of a pitch, rad."""
        return math.tau / self.wheel.teeth

    @property
    def shown(self) -> bool:
        """Whether its centre is near enough to be shown."""
        return self.sizes.operating <= FAR * self.wheel.rack.module

    @property
    def unrolled(self) -> bool:
        """Whether the strings of its flank are shown: those of a ring or of a large wheel begin far from its teeth."""
        return self.shown and not self.wheel.internal

    def circles(self, last: float) -> dict[str, Complexes]:
        """Give its circles as far as they are shown; the base circle to where its involute is unrolled from."""
        sizes, n, reach = self.sizes, self.wheel.number, (SHOWN + PAST) * self.step
        radii = {"d_a": sizes.tip, "d_w": sizes.operating, "d": self.wheel.radius, "d_f": sizes.root}
        if abs(sizes.operating / self.wheel.radius - 1) <= 1e-9:
            del radii["d_w"]
        found = {f"{name}{n}": self.arc(radius, -reach, reach) for name, radius in radii.items()}
        return found | {f"d_b{n}": self.arc(self.wheel.base, -reach, max(reach, last))}

    def arc(self, radius: float, low: float, high: float) -> Complexes:
        """Give a part of a circle about the centre."""
        return np.asarray(self.centre + radius * self.up * np.exp(1j * np.linspace(low, high, FACETS + 1)))

    def teeth(self, side: Complexes) -> Complexes:
        """Give the outline of three teeth, of a ring of three spaces, from the right side of a space, m."""
        inner = self.wheel.internal
        axes = [self.turned + (k if inner else k + 0.5) * self.step for k in range(-1 if inner else -2, 2)]
        parts = spaces(side, axes)
        if inner:
            ends = (self.turned + sign * SHOWN * self.step for sign in (-1, 1))
            first, last = (np.array([self.sizes.tip * cmath.exp(1j * end)]) for end in ends)
            return np.asarray(self.centre + self.up * bridged([first, *parts, last]))
        half = len(parts[0]) // 2
        return np.asarray(self.centre + self.up * bridged([parts[0][half:], *parts[1:-1], parts[-1][: half + 1]]))

    def tooth(self, side: Complexes) -> Complexes:
        """Give the outline of one tooth, its middle upright above P, from the middle of a space to that of the next."""
        first, last = spaces(side, [-self.step / 2, self.step / 2])
        half = len(first) // 2
        return np.asarray(1j * bridged([first[half:], last[: half + 1]]) - 1j * self.wheel.radius)


def spaces(side: Complexes, axes: list[float]) -> list[Complexes]:
    """Give whole spaces from tip to tip, each about an axis, from the right side of one."""
    space = np.concatenate([side[:0:-1], [1j * abs(side[0])], -side[1:].conj()]) / 1j
    return [space * np.exp(1j * axis) for axis in axes]


def bridged(parts: list[Complexes]) -> Complexes:
    """Join parts by arcs at the tip."""
    arcs = (
        part[-1] * np.exp(1j * np.angle(after[0] / part[-1]) * np.arange(1, ARC) / ARC)
        for part, after in pairwise(parts)
    )
    return np.concatenate([piece for both in zip_longest(parts, arcs, fillvalue=parts[0][:0]) for piece in both])


def placed(pair: InvolutePair, sizes: PairSizes) -> tuple[PlacedWheel, PlacedWheel]:
    """Place both wheels: a tooth of wheel 1 touches in P, with its flank on the right."""
    (first, second), ups = pair.wheels, (1j, -1j * pair.sense)
    return _placed(first, sizes.wheels[0], ups[0]), _placed(second, sizes.wheels[1], ups[1])


def _placed(wheel: GearWheel, sizes: WheelSizes, up: complex) -> PlacedWheel:
    """Turn a wheel by half of the arc of the tooth at P, of a ring of its space."""
    arc = sizes.operating_thickness
    arc = math.tau * sizes.operating / wheel.teeth - arc if wheel.internal else arc
    return PlacedWheel(wheel, sizes, -up * sizes.operating, up, arc / 2 / sizes.operating)


RACK = 8  # positions of a rack to a pitch
TOUCHING = 5  # of them on either side in which it touches a tooth


def racked(rack: Rack, shift: float, radius: float) -> dict[str, Complexes]:
    """Give both flanks of the rack about a tooth in each position as the wheel sees them, m about P_0 in the middle."""
    flanks = dict(zip(("", "'"), _rack(rack, shift), strict=True))
    steps = {k: k * rack.pitch / RACK for k in range(-TOUCHING, TOUCHING + 1)}
    return {
        f"{k}{prime}": (flank + s + 1j * radius) * cmath.exp(1j * s / radius) - 1j * radius
        for k, s in steps.items()
        for prime, flank in flanks.items()
    }


def _rack(rack: Rack, shift: float) -> tuple[Complexes, Complexes]:
    """Give the flanks on both sides of a space of the rack, from the middle of a tooth's tip up to its root, m."""
    m, lean = rack.module, np.linspace(math.pi / 2, rack.angle, ARC)
    corner = complex(rack.land, shift - rack.straight + rack.rounding * math.sin(rack.angle)) * m
    root = complex(math.pi / 4 + rack.head * math.tan(rack.angle), shift + rack.head) * m
    rounded = corner + rack.rounding * m * np.exp(-1j * lean)
    left = np.concatenate([[1j * (corner.imag - rack.rounding * m)], rounded, [root]]) - rack.pitch / 2
    return np.asarray(left, dtype=np.complex128), np.asarray(-left.conj(), dtype=np.complex128)
