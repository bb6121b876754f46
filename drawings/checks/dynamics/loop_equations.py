"""What must be worked out beside Wittenbauer's loop by the analysis: angles, segments, origin, flywheel (расчёт)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.checks.precise import ALL_DIGITS
from drawings.lettering.words import number
from drawings.page.drafting import Drafting
from plans.model.dynamics import Flywheel


def equations(wheel: Flywheel, scales: tuple[float, float], drafting: Drafting) -> Iterator[str]:
    """Give the lines with all digits of their numbers; the scales are of inertia and of energy, a mm."""
    inertia, energy = scales
    units = {name: drafting.word(name) for name in ("mm", "J", "kg*m2")}
    (least, most), (low, high) = wheel.slopes, wheel.cuts
    angles = [math.degrees(math.atan2(slope * inertia, energy)) for slope in (most, least)]
    whole = (high - low) / (most - least)
    start, there = whole * most - high, wheel.own + wheel.present

    def told(value: float) -> str:
        return number(value, drafting.language, ALL_DIGITS)

    yield f"ψ_{{max}} = {told(angles[0])}°;  ψ_{{min}} = {told(angles[1])}°"
    yield f"o_1k = {told(high / energy)} {units['mm']};  o_1l = {told(low / energy)} {units['mm']}"
    yield (
        f"x_O = (o_1l − o_1k)/(tg ψ_{{max}} − tg ψ_{{min}}) = {told(-whole / inertia)} {units['mm']};  "
        f"y_O = o_1k + x_O·tg ψ_{{max}} = {told(-start / energy)} {units['mm']}"
    )
    by = "/K" if drafting.notation == "K" else "·μ"
    yield f"J_0 = −x_O{by}_J = {told(whole)} {units['kg*m2']};  T_0 = −y_O{by}_T = {told(start)} {units['J']}"
    if whole <= there:
        yield drafting.word("needs no flywheel", there=told(there), whole=told(whole))
        return
    own = drafting.letter("J_{fly}")
    yield f"{own} = J_0 − J_0^* = {told(whole)} − {told(there)} = {told(whole - there)} {units['kg*m2']}"
