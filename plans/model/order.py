"""The three orders of a motion: positions, velocities, accelerations, and what their plans tell (порядки движения)."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple


class Quantity(NamedTuple):
    """A quantity of a point or of a link: its key among the numbers, its symbol on a sheet, its unit."""

    key: str
    symbol: str
    unit: str


class Order(NamedTuple):
    """An order of a motion: how often it is a derivative, the name of its plan, and what that tells of each."""

    number: int
    plan: str
    point: Quantity
    link: Quantity


POSITIONS = Order(0, "positions", Quantity("r", "r", "m"), Quantity("angle", "φ", "rad"))
VELOCITIES = Order(1, "velocities", Quantity("v", "v", "m/s"), Quantity("omega", "ω", "rad/s"))
ACCELERATIONS = Order(2, "accelerations", Quantity("a", "a", "m/s2"), Quantity("epsilon", "ε", "rad/s2"))
ORDERS = (POSITIONS, VELOCITIES, ACCELERATIONS)
PLANS = tuple(order.plan for order in ORDERS)
# The orders by the keys of what their plans tell of a point, and of a link.
POINT_ORDERS = {order.point.key: order for order in ORDERS}
LINK_ORDERS = {order.link.key: order for order in ORDERS}


def numbers_of(plans: Collection[str]) -> list[int]:
    """Give the numbers of the orders whose plans are among some.

    >>> numbers_of(("extremes", "positions", "velocities"))
    [0, 1]
    """
    return [order.number for order in ORDERS if order.plan in plans]
