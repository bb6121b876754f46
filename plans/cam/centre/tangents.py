"""Tangents of the S-S' diagram at the limits of the pressure angle, drawn on the board (касательные к диаграмме)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import TypeAlias

from geometry.board import Board, Mark
from plans.cam.centre.bounds import Bound, Limit, PressureBound, limit
from plans.cam.centre.region import Place
from plans.cam.centre.slope_diagram import SlopeDiagram, side_of
from plans.cam.centre.support import Touch
from plans.cam.sizing import Tangent
from plans.model.cam import LEAST_BASE, Cam, Limits
from plans.model.cam_faults import no_region, vanishing
from plans.words.words import because

# A touch and its number -> on the board D there, and the way of K there.
Laid: TypeAlias = Callable[[Touch, str], tuple[Mark, Mark]]


def tangents(
    board: Board, diagram: SlopeDiagram, limits: Sequence[Limit], binding: Sequence[Limit], laid: Laid, prime: str = ""
) -> tuple[Tangent, ...]:
    """Draw the limiting lines through the points that rulers touch, numbered; those that O lies on come first."""
    bounds = [one.bound for one in binding]
    ordered = [*sorted(binding, key=_rise_first), *(one for one in limits if one.bound not in bounds)]
    return tuple(_tangents(board, diagram, ordered, len(binding), laid, prime))


def _rise_first(one: Limit) -> int:
    return -side_of(one.touch.stretch.phase.kind)


def axis(board: Board) -> tuple[Mark, Mark, Mark]:
    """Draw the way of a follower that translates: its start A, the way's direction, the axis of S through A."""
    start = board.given("A", 0j, because("cam_start"))
    way = board.given("S", 1j, because("cam_way"))
    return start, way, board.parallel("AS", start, way, because("cam_way"))


def required(cam: Cam, limits: Limits, found: Place | None, start: complex = 0j) -> Place:
    """Give the place that was found for O; raises CamError where the limits leave none, or one at the start of K."""
    if found is None:
        raise no_region(cam, limits)
    free = not found.limits and (cam.rocks or cam.given.base is None) and not cam.sized
    if free or (cam.given.base is None and abs(found.centre - start) < LEAST_BASE * cam.way):
        raise vanishing(cam, limits)
    return found


def touched(bounds: Sequence[Bound], found: Place) -> list[Limit]:
    """Push a ruler against every bound; none where nothing moves."""
    return [limit(bound, found.centre) for bound in bounds if bound.along]


def bound_by(cam: Cam, lines: Sequence[Tangent]) -> tuple[Tangent, ...]:
    """Give tangents as they bind O: with R0 given none does."""
    return tuple(one._replace(binding=one.binding and cam.given.base is None) for one in lines)


def _tangents(
    board: Board, diagram: SlopeDiagram, limits: Sequence[Limit], binding: int, laid: Laid, prime: str
) -> Iterator[Tangent]:
    for number, one in enumerate(limits):
        bound, name = one.bound, f"{number + 1}{prime}"
        assert isinstance(bound, PressureBound)
        point, way = laid(one.touch, name)
        angle = f"{math.degrees(bound.side * bound.angle):.4g}"
        by = diagram.limit(bound.side, bound.angle) / 1j
        direction = board.turn(f"t_{name}", way, by, because("cam_limit_angle", angle=angle))
        line = board.parallel(f"τ_{name}", point, direction, because("cam_ruler"))
        yield Tangent(bound, one.touch, point, direction, line, number < binding)


def met(board: Board, name: str, lines: Sequence[Tangent], start: Mark, why: str) -> Mark:
    """Give where two limiting lines meet; of one alone the foot of the perpendicular from the start."""
    if len(lines) == 2:
        return board.meet(name, lines[0].line, lines[1].line, why=because(why))
    square = board.square("n", start, lines[0].direction, because("cam_square"))
    return board.meet(name, square, lines[0].line, why=because("cam_foot"))
