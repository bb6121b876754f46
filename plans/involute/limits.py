"""What a pair must keep: no undercut, no pointed teeth, no interference, teeth that follow each other (условия)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from plans.involute.action import LineOfAction, closing, half_at_base, opened, string
from plans.involute.shift import SLIGHT, least_shift
from plans.model.involute import GearWheel, InvolutePair

THIN = 0.25  # modules: a thinner tip breaks, however it is hardened
LEAST_RATIO, GOOD_RATIO = 1.0, 1.1
ROUNDED = 1e-9  # of a module, of a ratio: a limit that is kept exactly is no breach by a rounding


class PairLimit(NamedTuple):
    """A limit that is broken, or near: its kind, its numbers, the keys that would mend it, the first one best."""

    kind: str
    details: Mapping[str, object]
    at: tuple[str, ...] = ("shift", "centre", "aim", "teeth")
    broken: bool = True


def told(value: float) -> str:
    """Write a number of a limit."""
    return f"{value + 0.0:.4g}".replace("-", "\N{MINUS SIGN}")


def shifts_within(plain: InvolutePair) -> Iterator[PairLimit]:
    """See that the rack has a tip, and a ring more teeth than its pinion, whatever the shifts are."""
    if plain.rack.rounding <= 0:
        deep = math.pi / 4 / math.tan(plain.rack.angle)
        yield PairLimit("rack_pointed", {"deep": told(deep)}, ("head", "clearance", "angle"))
    first, second = plain.teeth
    if plain.internal and second <= first:
        yield PairLimit("ring_teeth", {"least": first + 1, "teeth": second}, ("teeth",))


def limits(pair: InvolutePair) -> Iterator[PairLimit]:
    """Give all limits that a pair breaks or nears; of one that cannot mesh at all nothing else is told."""
    if closing(pair) < 0:
        span = pair.teeth[1] + pair.sense * pair.teeth[0]
        least = -opened(math.tan(pair.rack.angle)) * span / 2 / math.tan(pair.rack.angle)
        yield PairLimit("no_mesh", {"total": told(pair.total), "least": told(least)})
        return
    action = LineOfAction(pair)
    undercut, bodies = [*_undercut(pair)], [*_bodies(action)]
    yield from (*undercut, *bodies)
    if not bodies:
        yield from _tips(action)
        yield from () if any(limit.broken for limit in undercut) else (*_interference(action), *_ratio(action))


def _undercut(pair: InvolutePair) -> Iterator[PairLimit]:
    for wheel in pair.wheels:
        least = least_shift(wheel)
        if not wheel.internal and wheel.shift < least - ROUNDED:
            free = 2 * (pair.rack.straight - SLIGHT) / math.sin(pair.rack.angle) ** 2
            broken = wheel.shift < least - SLIGHT
            yield PairLimit("undercut_teeth" if broken else "slight_undercut", {
                "wheel": wheel.number, "shift": told(wheel.shift), "least": f"{math.ceil(least * 1e3) / 1e3:.3f}",
                "teeth": wheel.teeth, "free": math.ceil(free - ROUNDED),
            }, broken=broken)  # fmt: skip


def _bodies(action: LineOfAction) -> Iterator[PairLimit]:
    """See that each wheel has teeth at all: a root above the centre, a tip beyond the root, on the involute."""
    for wheel, tip, root in zip(action.pair.wheels, action.tips, action.roots, strict=True):
        if root <= 0 or (tip - root) * wheel.inward <= 0 or (wheel.internal and tip <= wheel.base):
            sizes = {"tip": told(1e3 * tip), "root": told(1e3 * root), "base": told(1e3 * wheel.base)}
            few, height = wheel.internal and root > tip, 2 * (wheel.radius - tip) / wheel.rack.module
            sizes["least"] = f"{math.ceil(height / (1 - math.cos(wheel.rack.angle)))}"  # of a ring, by its height alone
            at = ("teeth",) if few else PairLimit._field_defaults["at"]
            yield PairLimit("ring_tip" if few else "no_teeth", {"wheel": wheel.number, **sizes}, at)
        elif wheel.internal and wheel.corner(root) < ROUNDED * wheel.rack.module:
            yield PairLimit("pointed_space", {"wheel": wheel.number, "shift": told(wheel.shift)})


def _tips(action: LineOfAction) -> Iterator[PairLimit]:
    """See that no tooth is pointed."""
    for wheel, tip in zip(action.pair.wheels, action.tips, strict=True):
        half = half_at_base(wheel) - opened(string(wheel, tip))
        thick = tip * (math.tau / wheel.teeth - 2 * half if wheel.internal else 2 * half) / wheel.rack.module
        if thick < THIN - ROUNDED:
            details = {"wheel": wheel.number, "thick": told(thick), "least": THIN, "shift": told(wheel.shift)}
            yield PairLimit("pointed_tip" if thick < 0 else "thin_tip", details, broken=thick < 0)


def lowest(wheel: GearWheel, root: float) -> float:
    """Give how long the string is where the involute ends at a wheel's foot, m."""
    if wheel.internal:
        corner = wheel.corner(root)
        return math.sqrt((root - corner) ** 2 - wheel.base**2) + corner
    depth = (wheel.rack.straight - wheel.shift) * wheel.rack.module
    return wheel.radius * math.sin(wheel.rack.angle) - depth / math.sin(wheel.rack.angle)


def _interference(action: LineOfAction) -> Iterator[PairLimit]:
    """See that no tip meets the other's fillet, and that tips of an internal pair pass each other."""
    for wheel, foot, root in zip(action.pair.wheels, action.feet, action.roots, strict=True):
        end = max(lowest(wheel, root), 0.0)
        if (foot - end) * wheel.inward < -ROUNDED * wheel.rack.module:
            ends = (f"{1e3 * abs(complex(wheel.base, max(long, 0.0))):.3f}" for long in (foot, end))
            radii = dict(zip(("foot", "end"), ends, strict=True))
            yield PairLimit("interference", {"wheel": wheel.number, "other": 3 - wheel.number, **radii})
    if action.pair.internal and (gap := _passing(action)) < -ROUNDED:
        first, second = action.pair.teeth
        yield PairLimit("tips_meet", {"gap": told(math.degrees(gap)), "teeth": second - first})


def _passing(action: LineOfAction) -> float:
    """Give the angle of the ring that is left between the tips where both tip circles cross."""
    (first, second), (tip, edge), far = action.pair.wheels, action.tips, action.distance
    share = (edge**2 - tip**2 - far**2) / (2 * far * tip)
    if not -1 < share < 1:
        return math.inf
    meeting = far + tip * cmath.exp(1j * math.acos(share))  # seen from the ring's centre, the pinion's to the right
    turned, other = math.acos(share), cmath.phase(meeting)
    away = opened(string(first, tip)), opened(string(second, edge))
    at_pole = opened(math.tan(action.angle))
    return (first.teeth * (turned + away[0] - at_pole)) / second.teeth - (other + away[1] - at_pole)


def _ratio(action: LineOfAction) -> Iterator[PairLimit]:
    ratio = action.length / action.pair.rack.base_pitch
    if ratio < GOOD_RATIO - ROUNDED:
        kind = "short_action" if ratio < LEAST_RATIO else "low_ratio"
        yield PairLimit(kind, {"ratio": told(ratio), "least": GOOD_RATIO}, broken=ratio < LEAST_RATIO)
