"""Positions without a result, and why: what ended the march decides (разрывы)."""

from __future__ import annotations

import numpy as np

from plans.analytic.ends import CHANGE_POINT, DEAD_CENTRE, NOT_REACHABLE, PARALLEL, End
from plans.model.kinetostatics import FORCES, INDETERMINATE
from plans.model.motion import Gap

OUT_OF_REACH, BEYOND = "out of reach", "beyond a change point"

ADVICE = {
    OUT_OF_REACH: "Lengthen the links that are too short here, or keep the crank within its dead centres.",
    DEAD_CENTRE: "Keep the crank clear of this dead centre, or drive another link.",
    PARALLEL: "Leave this crank angle out: two guides are parallel there, and their lines do not meet.",
    CHANGE_POINT: "Leave this crank angle out, or change a length so that the links never fall into one line.",
    BEYOND: "Start the crank on this side of the change point, so that the sketch tells which assembly is meant.",
    NOT_REACHABLE: "Sketch the assembly meant at this position and start there: the first position does not lead here.",
    INDETERMINATE: "Leave this crank angle out: the links can be strained against each other there, by any amount.",
}
WHAT = {
    DEAD_CENTRE: "the Jacobian loses rank",
    CHANGE_POINT: "the Jacobian loses rank",
    PARALLEL: "guides become parallel and their links run to infinity",
    NOT_REACHABLE: "the way round ends",
}
UNASSEMBLED = "no assembly fits the sketch at any crank angle tried"
FAINT = "the Jacobian all but loses rank"
UNBALANCED = "the equations of equilibrium lose rank"


def gap(position: int, phi: float, plan: str, reason: str, end: End | None) -> Gap:
    """Word the gap of one position, phi in rad."""
    where = UNASSEMBLED if reason == OUT_OF_REACH else FAINT
    if end:
        angle = round(np.degrees(end.singular), 4) % 360.0
        where = f"{WHAT[end.reason]} near phi = {angle:g} deg"
    return Gap(position, phi, plan, reason, where, 0.0, ADVICE[reason])


def unbalanced(position: int, phi: float, reason: str) -> Gap:
    """Word the gap of a position whose reactions grow beyond all bounds, or are not told by equilibrium; phi in rad."""
    return Gap(position, phi, FORCES, reason, UNBALANCED, 0.0, ADVICE[reason])
