"""The record of the sheet of a gear train: velocities off the lines of links, angular ones (зубчатый механизм)."""

from __future__ import annotations

from drawings.grading.asked import Found, Letters, Record
from drawings.paper.strokes import Leaf
from geometry.board import Span
from plans.gears.kutzbach import AXIS, LINEAR, board_of
from plans.gears.study import GearsStudy
from plans.study import Study


def record_of_gears(study: Study, leaf: Leaf) -> Record:
    """Give the record of the velocities of points, at the scale of the heights over tau, and of angular velocities."""
    scales, found = dict(leaf.metadata["scales"]), dict[Letters, Found]()
    for plan in study.of(GearsStudy).plans:
        linear, origin, zero = board_of(LINEAR, plan.gear), plan.linear[AXIS], plan.angular["0"]
        if plan.linear.subject in scales:
            scales[linear] = scales[plan.linear.subject] / plan.tau
        for mark in plan.velocities.values():
            found[linear, None, "", mark.name] = Found(mark.name, Span(origin, mark))
        for mark in plan.level_speeds.values():
            found[plan.angular.subject, None, "", mark.name] = Found(mark.name, Span(zero, mark))
    return Record(found, {name: {None: mu} for name, mu in scales.items()})
