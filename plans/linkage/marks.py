"""The marks of a linkage's plans by their names: points, letters of plans, rates read off vectors (точки планов)."""

from __future__ import annotations

import numpy as np

from geometry.board import Mark, Reading, at, behind
from geometry.meet import cross
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.linkage.drafts import Drafts
from plans.linkage.plan import Masses, Plan, unnamed
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Drive
from plans.model.motion import ORDERS, POSITIONS
from plans.study import Study
from plans.words.words import Message, message

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
    linkage = study.of(LinkageStudy)
    wanted = position_of(linkage, position)
    targets = find(linkage, linkage.drafts((wanted,)), name)
    if not targets:
        points = sorted(letters(linkage))
        known = [*points, *(f"v_{point}" for point in points), *(f"a_{point}" for point in points)]
        return NoMark(tuple(known), message("mark.points", points=", ".join(points)), ("v_B", "a_B", "omega_3"))
    notes = (_rate(name, *targets),) if isinstance(targets, Reading) else ()
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


def find(study: LinkageStudy, drafts: Drafts, name: str) -> Reading | tuple[Mark, ...]:
    """Find a mark: B, v_B, a_B for points; omega_3, epsilon_3 for links; letters of a plan: a3, n_BA, p a3."""
    image = _image(study, drafts, name)
    if image is not None:
        return (image,)
    head, _, tail = name.partition("_")
    if head in ("omega", "epsilon", "ω", "ε") and tail.isdigit() and int(tail) in study.mechanism.links:
        link = int(tail)
        plan = drafts.velocities if head in ("omega", "ω") else drafts.accelerations
        if link == FRAME or link not in plan.readings:
            raise UnknownMark(message("mark.still", link=link, mark=name))
        return plan.readings[link]
    return _ends(study, drafts, name)


def _image(study: LinkageStudy, drafts: Drafts, name: str) -> Mark | None:
    points, centres = letters(study), unnamed(study.scene, study.mechanism.links)
    for order, symbol in enumerate(("", "v_", "a_")):
        letter = name.removeprefix(symbol) if name.startswith(symbol) else ""
        if letter in points:
            return drafts.plan(order).point(letter)
        if letter in centres:
            return _centre(drafts.plan(order), letter, *centres[letter])
    return None


def _centre(plan: Plan, letter: str, link: int, place: complex) -> Mark:
    return plan.place(link, place, plan.letter(letter))


def _ends(study: LinkageStudy, drafts: Drafts, name: str) -> tuple[Mark, ...]:
    """Find the letter of a plan, or both letters at the ends of a vector, on the first plan that has them."""
    centres = unnamed(study.scene, study.mechanism.links)
    for plan in (drafts.positions, drafts.velocities, drafts.accelerations):
        found = [_lettered(plan, centres, letter) or _placed(study, plan, letter) for letter in name.split(" ")]
        ends = tuple(mark for mark in found if mark is not None)
        if len(ends) == len(found):
            return ends
    return ()


def _placed(study: LinkageStudy, plan: Plan, name: str) -> Mark | None:
    """Find the end of a point's vector by its letter, which a plate of three leads has by its shape alone."""
    point = next((one for one in letters(study) if plan.letter(one) == name), None)
    return None if point is None else plan.point(point)


def _lettered(plan: Plan, centres: Masses, name: str) -> Mark | None:
    centre = next((letter for letter in centres if plan.letter(letter) == name), None)
    if centre is not None:
        return _centre(plan, centre, *centres[centre])
    written = (letter for letter in (name, name.replace("_", "")) if letter in plan.board)  # a3 is written a_3
    return next((plan.board[letter] for letter in written), None)


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
