"""Shifts chosen for an aim: no undercut, a centre distance, equal sliding at both feet (выбор смещений)."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from plans.involute.action import LineOfAction, closing, opened
from plans.model.involute import GearWheel, InvolutePair

NO_UNDERCUT, EQUAL_SLIDING = "no undercut", "equal sliding"
AIMS: Final = (NO_UNDERCUT, EQUAL_SLIDING)
SLIGHT = 0.006  # modules that a shift may lack: by the rule (17 - z)/17 no wheel up to 17 teeth lacks more
SEARCHED = 1.5  # modules: the range of shifts among which equal sliding is looked for
STEPS, HALVINGS = 60, 50  # parts of that range, and halvings of the one in which the slidings change places


class NoShift(ValueError):  # noqa: N818  (it is told as a fault of the scene)
    """That no shift brings what is aimed at: the kind of fault, and its numbers."""

    def __init__(self, kind: str, at: tuple[str, ...], **details: object) -> None:
        super().__init__(kind)
        self.kind, self.at, self.details = kind, at, details


def least_shift(wheel: GearWheel) -> float:
    """Give the least shift at which the rack does not undercut: its flank ends where it touches the base circle.

    >>> from plans.model.involute import Rack
    >>> round(least_shift(GearWheel(Rack(0.005, math.radians(20)), 1, 12, 0.0)), 4)
    0.2981
    """
    return wheel.rack.straight - wheel.teeth * math.sin(wheel.rack.angle) ** 2 / 2


def aimed(plain: InvolutePair, aim: str, centre: float | None) -> InvolutePair:
    """Give a pair with the shifts that bring what is aimed at, at a centre distance m or as near as without shift."""
    total = 0.0 if centre is None else total_at(plain, centre)
    plain = replace(plain, aims=(aim, *(("centre",) if centre else ())))
    if aim == EQUAL_SLIDING:
        return _equal(plain, total)
    least, other = (least_shift(wheel) for wheel in plain.wheels)
    if plain.internal or centre is None:
        first = max(least, 0.0)
        return replace(plain, shifts=(first, total + first if plain.internal else max(other, 0.0)))
    share = total * plain.teeth[1] / sum(plain.teeth)  # the smaller wheel needs more of it
    short = max((least + other - total) / 2, 0.0)  # of each wheel
    if short > SLIGHT:
        near = math.ceil(1e5 * LineOfAction(replace(plain, shifts=(least, other))).distance) / 100
        sums = {"total": round(total, 3) + 0.0, "sum": round(least + other, 3)}
        raise NoShift("centre_undercuts", ("centre",), least=near, **sums)
    first = max(min(share, total - other + short), least - short)
    return replace(plain, shifts=(first, total - first))


def total_at(plain: InvolutePair, centre: float) -> float:
    """Give the total shift that a centre distance m asks for, in modules."""
    least = plain.standard * math.cos(plain.rack.angle)
    if centre < least:
        numbers = {"centre": f"{1e3 * centre:.6g}", "least": f"{math.ceil(1e5 * least) / 100:.2f}"}
        raise NoShift("centre_too_near", ("centre",), **numbers)
    slope = math.sqrt((centre / least) ** 2 - 1)
    span = plain.teeth[1] + plain.sense * plain.teeth[0]
    return (opened(slope) - closing(plain)) * span / 2 / math.tan(plain.rack.angle)


def _equal(plain: InvolutePair, total: float) -> InvolutePair:
    """Find the shift of wheel 1 at which both feet slide alike, by halving the part in which they change places."""

    def pair(first: float) -> InvolutePair:
        return replace(plain, shifts=(first, total - plain.sense * first))

    def lead(first: float) -> float:
        action = LineOfAction(pair(first))
        if min(action.feet) <= 0:
            return math.nan
        one, other = action.sliding
        return one - other

    places = [SEARCHED * (2 * k / STEPS - 1) for k in range(STEPS + 1)]
    leads = [lead(place) for place in places]
    for k in range(STEPS):
        if leads[k] <= 0 < leads[k + 1]:
            low, high = places[k], places[k + 1]
            for _ in range(HALVINGS):
                middle = (low + high) / 2
                low, high = (middle, high) if lead(middle) <= 0 else (low, middle)
            return pair(low)
    raise NoShift("no_equal_sliding", ("centre", "aim"), total=f"{total:.4g}", most=f"{SEARCHED:g}")
