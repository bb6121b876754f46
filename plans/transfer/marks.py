"""Marks of the turned velocity plan by the names that `explain` takes: b', a3', u_31 (точки повёрнутого плана)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry.board import behind
from plans.explanation import Explanation, NoMark, in_position
from plans.linkage.marks import position_of, title
from plans.model.motion import POSITIONS
from plans.transfer.functions import functions
from plans.transfer.study import TRANSFER, TransferStudy
from plans.words.words import message

if TYPE_CHECKING:
    from plans.study import Study

UNITS = {TRANSFER: "m", POSITIONS.plan: "m"}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind an image of the turned plan, or behind what a transfer function is read off."""
    found = study.of(TransferStudy)
    plan, linkage = found.turned, found.linkage
    read = {course.names[0]: course.shown(plan) for course in functions(linkage.mechanism)}
    named = {mark.name: (mark,) for mark in plan.board if mark.name.endswith("'")} | read
    if name not in named:
        return NoMark(tuple(named), message("mark.marks", marks=", ".join(read)), tuple(read)[:1])
    wanted = position_of(linkage, position)
    steps = in_position(behind(*named[name]), wanted, len(linkage.turn))
    return Explanation(title(linkage, name, wanted), steps, UNITS, (), POSITIONS.plan)
