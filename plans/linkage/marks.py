"""The marks of a linkage's plans by their names: points, letters of plans, rates read off vectors (точки планов)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from geometry.board import Mark, at
from geometry.meet import cross
from geometry.steps import behind
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.linkage.drafts import Drafts
from plans.linkage.plan import Plan
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Drive
from plans.model.motion import ORDERS, POSITIONS
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.study import Study

PLACES = 4  # decimals of degrees, and of millimetres


def told_at(key: str, drive: Drive, phi: float, /, **parts: object) -> Message:
    """Say something at a coordinate of the drive: by a key with its angle in degrees, or `key_way` with millimetres.

    >>> told_at("explain.title", Drive(1, "O", "A", 1.0, 0.0), 0.5, mark="B", position=1).worded("en")
    'B in position 1 (φ = 28.6479°)'
    """
    if not drive.pushed:
        return message(key, angle=f"{np.degrees(phi):.{PLACES}f}", **parts)
    return message(f"{key}_way", way=f"{1000 * drive.unit * phi:.{PLACES}f}", **parts)


HOME = POSITIONS.plan
UNITS = {order.plan: order.point.unit for order in ORDERS}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark of the motion in one position."""
    linkage = study["linkage"]
    wanted = position_of(linkage, position)
    targets = find(linkage, linkage.drafts((wanted,)), name)
    if not targets:
        return _no_mark(linkage)
    notes = (_rate(name, *targets),) if len(targets) > 1 else ()
    return Explanation(title(linkage, name, wanted), tuple(behind(*targets)), UNITS, notes, HOME)


def title(study: LinkageStudy, name: str, position: int) -> Message:
    """Head an explanation with the name of the mark and its position."""
    drive, phi = study.mechanism.drive, float(study.turn.phi[position])
    return told_at("explain.title", drive, phi, mark=name, position=position)


def position_of(study: LinkageStudy, wanted: int) -> int:
    """Give a position that is asked for, if it is there and can be assembled."""
    if not 0 <= wanted < len(study.turn):
        raise UnknownMark(message("mark.position", position=wanted, last=len(study.turn) - 1))
    if study.lost[wanted]:
        gap = next(gap for gap in study.motion(0).gaps if gap.position == wanted)
        parts = {"reason": gap.reason, "where": gap.where, "advice": gap.advice}
        raise UnknownMark(message("mark.gap", position=wanted, **parts))
    return wanted


def letters(study: LinkageStudy) -> set[str]:
    """Give the names of all points."""
    return {point for link in study.mechanism.links.values() for point in link.points}


def find(study: LinkageStudy, drafts: Drafts, name: str) -> list[Mark]:
    """Find a mark: B, v_B, a_B for points; omega_3, epsilon_3 for links; any letter of a plan such as a3 or n_BA."""
    head, _, tail = name.partition("_")
    points = letters(study)
    if name in points:
        return [drafts.positions.point(name)]
    if head in ("v", "a") and tail in points:
        return [_plan(drafts, head).point(tail)]
    if head in ("omega", "epsilon", "ω", "ε") and tail.isdigit() and int(tail) in study.mechanism.links:
        return _turning(drafts, head, int(tail), name)
    return list(_lettered(drafts, name))[:1]


def _turning(drafts: Drafts, symbol: str, link: int, name: str) -> list[Mark]:
    plan = drafts.velocities if symbol in ("omega", "ω") else drafts.accelerations
    if link == FRAME or link not in plan.readings:
        raise UnknownMark(message("mark.still", link=link, mark=name))
    return [*plan.readings[link]]


def _lettered(drafts: Drafts, name: str) -> Iterator[Mark]:
    for plan in (drafts.positions, drafts.velocities, drafts.accelerations):
        for letter in (name, name.replace("_", "")):  # a3 is written with its index lowered: a_3
            if letter in plan.board:
                yield plan.board[letter]


def _no_mark(study: LinkageStudy) -> NoMark:
    points = sorted(letters(study))
    known = [*points, *(f"v_{point}" for point in points), *(f"a_{point}" for point in points)]
    return NoMark(tuple(known), message("mark.points", points=", ".join(points)), ("v_B", "a_B", "omega_3"))


def _plan(drafts: Drafts, symbol: str) -> Plan:
    return drafts.velocities if symbol == "v" else drafts.accelerations


def _rate(name: str, arm: Mark, turning: Mark) -> Message:
    """Say how an angular velocity or acceleration is read off: the size of the turning part over the arm."""
    along, across = at(arm.point, 0), at(turning.point, 0)
    moment = float(cross(along, across))
    unit, rate = next((order.point.unit, order.link.unit) for order in ORDERS if order.plan == turning.subject)
    sense = "at rest" if moment == 0 else "counter-clockwise" if moment > 0 else "clockwise"
    value = moment / abs(along) ** 2
    sizes = {"across": abs(across), "along": abs(along), "value": value}
    parts = {"turning": turning.name, "arm": arm.name, "unit": unit, "rate": rate, "sense": sense}
    return message("explain.rate", mark=name, **parts, **{key: f"{size:.10g}" for key, size in sizes.items()})
