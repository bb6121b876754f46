"""Rates read off plans: the angular velocities and accelerations of a table, by what they are read off (угловые)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TypeAlias

from drawings.eye.alike import folded
from drawings.paper.strokes import Text
from geometry.span import Reading
from plans.model.order import ORDERS
from plans.study import Study

Rates: TypeAlias = Mapping[tuple[str, int | None], Reading]  # by the letter of a rate as it is seen, and its position
PLANS = ("kinematics",)  # kinds of sheets that the plans stand on


def rates_of(study: Study, kind: str, positions: Collection[int | None]) -> Rates:
    """Give what the rates of some positions are read off."""
    if kind not in PLANS:
        return {}
    plans = (
        (k, order, study["linkage"].drafts([k]).plan(order.number))
        for k in positions
        if k is not None
        for order in ORDERS[1:]
    )
    return {
        (folded(Text(0j, f"{order.link.symbol}_{{{link}}}").plain), k): reading
        for k, order, plan in plans
        for link, reading in plan.readings.items()
    }
