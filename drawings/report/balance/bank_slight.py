"""What of a bank is too slight to be drawn: orders, forces and moments beside the largest order (малые гармоники)."""

from __future__ import annotations

import numpy as np

from plans.model.balance.bank import BankBalance
from plans.model.motion import Complexes

# Of the largest order of one mechanism: where that is drawn 100 mm long, what is less is shorter than 0.1 mm, and no
# line is so thin. A figure of it at a scale of its own would look like those that matter.
SLIGHT = 1e-3


def largest(balance: BankBalance) -> float:
    """Give the largest force of an order of one mechanism, N."""
    return max(one.size for one in balance.single.values())


def slight_order(balance: BankBalance, order: int) -> bool:
    """Tell whether an order that is there is too slight to be drawn; one that is to be compensated is not."""
    size = max(balance.single[order].size, balance.forces[order].size)
    asked = any(one.asked.order == order for one in balance.compensators)
    return not asked and 0.0 < size < SLIGHT * largest(balance)


def slight_force(balance: BankBalance) -> bool:
    """Tell whether the force of a bank without compensators is more than rounding, but too slight to be drawn."""
    most = _most(balance.force)
    return not _answered(balance) and balance.force_slack < most < SLIGHT * largest(balance)


def slight_left(balance: BankBalance) -> bool:
    """Tell whether the compensators leave more than rounding, but too little to be drawn."""
    most = _most(balance.left)
    return _answered(balance) and balance.left_slack < most < SLIGHT * largest(balance)


def slight_moment(balance: BankBalance) -> bool:
    """Tell whether the moment is more than rounding, but slight beside one mechanism's at the farthest place."""
    arm = max(abs(float(one.place)) for one in balance.task.members)
    return balance.moment_slack < _most(balance.moment) < SLIGHT * largest(balance) * arm


def _answered(balance: BankBalance) -> bool:
    return any(angle is not None for one in balance.compensators for angle in (one.with_angle, one.against_angle))


def _most(values: Complexes) -> float:
    return float(np.abs(values).max())
