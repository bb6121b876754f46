"""Positions without a result, and why: what ended the march decides (разрывы)."""

from __future__ import annotations

import numpy as np

from plans.analytic.ends import End
from plans.model.kinetostatics import FORCES, INDETERMINATE
from plans.model.mechanism import Drive
from plans.model.motion import (
    BEYOND_CHANGE_POINT,
    CHANGE_POINT,
    DEAD_CENTRE,
    NOT_REACHABLE,
    OUT_OF_REACH,
    PARALLEL_GUIDES,
    Gap,
)
from plans.words.words import message

ADVICE = {
    reason: message(f"analysis.{key}")
    for reason, key in (
        (OUT_OF_REACH, "out_of_reach"),
        (DEAD_CENTRE, "dead_centre"),
        (PARALLEL_GUIDES, "parallel"),
        (CHANGE_POINT, "change_point"),
        (BEYOND_CHANGE_POINT, "beyond"),
        (NOT_REACHABLE, "not_reachable"),
        (INDETERMINATE, "indeterminate"),
    )
}
# What the end of the march is, by why it ended.
WHAT = {DEAD_CENTRE: "rank", CHANGE_POINT: "rank", PARALLEL_GUIDES: "infinity", NOT_REACHABLE: "way"}
UNASSEMBLED, FAINT, UNBALANCED = (message(f"analysis.{key}") for key in ("unassembled", "faint", "unbalanced"))


def gap(position: int, phi: float, plan: str, reason: str, end: End | None, drive: Drive) -> Gap:
    """Word the gap of one position of a drive, phi in rad or in units of its slide."""
    where = UNASSEMBLED if reason == OUT_OF_REACH else FAINT
    if end and drive.pushed:
        way = round(1000 * drive.unit * end.singular, 4)
        where = message(f"analysis.{WHAT[end.reason]}_way", way=f"{way:g}")
    elif end:
        angle = round(np.degrees(end.singular), 4) % 360.0
        where = message(f"analysis.{WHAT[end.reason]}", angle=f"{angle:g}")
    return Gap(position, phi, plan, reason, where, 0.0, ADVICE[reason])


def unbalanced(position: int, phi: float, reason: str) -> Gap:
    """Word the gap of a position whose reactions grow beyond all bounds, or are not told by equilibrium; phi in rad."""
    return Gap(position, phi, FORCES, reason, UNBALANCED, 0.0, ADVICE[reason])
