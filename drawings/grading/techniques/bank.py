"""The record of a bank's sheet: the polygons of forces and of moments by order, the star, by analysis (блок машин)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from drawings.due.shaken_bank import Bank, Polygon
from drawings.figures.bank.bank_polygon import plan_of
from drawings.figures.bank.bank_view import fanned
from drawings.grading import verdict
from drawings.grading.marking import Found, Letters, Record, Slip
from drawings.paper.strokes import Leaf
from geometry.board import Board, Mark
from geometry.span import Span
from plans.bank.letters import FORCE, MOMENT, letters
from plans.model.balance.bank import Harmonic, Member
from plans.rotor.heading import heading
from plans.study import Study


def record_of(study: Study, leaf: Leaf) -> Record:
    """Give the record of the polygons of a bank's sheet."""
    expected = Bank(study["bank"].task, study.comparison("bank"))
    found: dict[Letters, Found] = {}
    plans: dict[str, Mapping[int | None, float]] = {}
    scales, forces = leaf.metadata["scales"], dict[str, Mark]()
    for polygon in expected.polygons():
        plan = plan_of(polygon.kind, polygon.signed)
        own = list(_polygon(expected, polygon, plan, forces))
        if plan in scales:
            found |= {(plan, None, "", one.name): one for one in own}
            plans[plan] = {None: scales[plan]}
    return Record(found, plans)


def _polygon(expected: Bank, polygon: Polygon, plan: str, forces: dict[str, Mark]) -> Iterator[Found]:
    """Give the vectors of the mechanisms laid end to end, and their sum; a moment is a force by its place."""
    board = Board(plan)
    pole = end = board.given("0", 0j)
    members = {letters(polygon.kind, polygon.signed, one.name): one for one in expected.members}
    for name, value in fanned(list(polygon.sides.items())):
        vector = _vector(board, polygon, members[name], forces)
        start, end = end, board.lay_off(f"{plan}:{name}", end, vector)
        slips = tuple(_slips(expected, polygon, members[name]))
        yield Found(name, value, Span(pole, vector), Span(start, end), slips=slips)
    yield Found(polygon.name, polygon.whole, Span(pole, end), Span(pole, end), diagonal=True)


def _vector(board: Board, polygon: Polygon, member: Member, forces: dict[str, Mark]) -> Mark:
    """Lay down the force of a mechanism, or its moment: the force multiplied by its place."""
    name = letters(polygon.kind, polygon.signed, member.name)
    force = forces.get(letters(FORCE, polygon.signed, member.name))
    if polygon.kind == MOMENT and force is not None:
        return board.turn(name, force, float(member.place))
    vector = board.given(name, polygon.sides[name])
    if polygon.kind == FORCE:
        forces[name] = vector
    return vector


def _slips(expected: Bank, polygon: Polygon, member: Member) -> Iterator[Slip]:
    """Give what the vector of a mechanism is by another order, or by another mechanism's place."""
    for order, single in expected.analysis.single.items():
        if order != abs(polygon.signed):
            yield from (Slip(verdict.ORDER, value, f"n = {order}") for value in _by(expected, polygon, member, single))
    if polygon.kind == MOMENT:
        name, place = letters(polygon.kind, polygon.signed, member.name), float(member.place)
        for other in expected.members:
            times = float(other.place) / place
            kind = verdict.BEYOND if math.isclose(times, -1.0) else verdict.PRODUCT
            if other is not member:
                yield Slip(kind, polygon.sides[name] * times, "" if kind == verdict.BEYOND else f"z_{other.name}")


def _by(expected: Bank, polygon: Polygon, member: Member, other: Harmonic) -> Iterator[complex]:
    """Give a vector turned by the angle of another order, of its size, or both."""
    own, sign = expected.analysis.single[abs(polygon.signed)], 1 if polygon.signed > 0 else -1
    sizes = (own.ahead, other.ahead) if sign > 0 else (own.back, other.back)
    turns = [heading(sign * order * member.phase + member.axis) for order in (own.order, other.order)]
    arm = expected.arm(polygon.kind, member) * expected.turn
    for size, turn in ((sizes[0], turns[1]), (sizes[1], turns[0]), (sizes[1], turns[1])):
        yield size * turn * arm
