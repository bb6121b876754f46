"""The main sizes of a cam by tangents of its S-S' diagram (основные размеры кулачка, 5.9.4, figures 5.49-5.51)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from geometry.board import Board, Mark
from plans.cam.centre.bounds import SlopeDiagram, Touch, pressure_bounds, stretches, touch
from plans.cam.centre.flat_sizes import flat_sizing, rocking_face_sizing
from plans.cam.centre.rocker_sizes import (
    Choice,
    Place,
    axis,
    bound_by,
    met,
    nearest,
    on_line,
    place,
    required,
    rocker_sizing,
    tangents,
    touched,
)
from plans.cam.course import Course, positions
from plans.cam.sizing import SIZES, Sizing, Tangent
from plans.model.cam import Cam, limits_of
from plans.model.cam_motion import Sizes, still, too_far
from plans.model.motion import Floats
from plans.words.words import because


def sizing(course: Course) -> Sizing:
    """Find the main sizes that a scene does not give, or draw the diagram for those that it gives.

    Raises CamError where there are none.
    """
    cam = course.cam
    if cam.translates:
        return _unsized(course)
    if cam.given.base is None and not any(cam.moving()):
        raise still(cam)
    if cam.flat:
        return rocking_face_sizing(course) if cam.rocks else flat_sizing(course)
    return rocker_sizing(course) if cam.rocks else _translating(course)


def _unsized(course: Course) -> Sizing:
    """Give what a cam that translates has instead of sizes: how much longer it would have to be (tan α = S')."""
    cam, longer = course.cam, 1.0
    for one in cam.moving():
        most = limits_of(cam).of(one.kind)
        if most is not None and not cam.rocks:
            steepest = touch(stretches(cam, (one.kind,)), lambda at: (np.abs(at.slope), np.sign(at.slope) * at.bend))
            longer = max(longer, steepest.beyond / float(np.tan(most)))
    return Sizing(cam, cam.limits, Sizes(0.0), Board(SIZES), positions(cam), longer=longer)


def _translating(course: Course) -> Sizing:
    """Draw the diagram on the follower's way, push the rulers, and find O (figures 5.49, 5.50)."""
    cam, board, diagram = course.cam, Board(SIZES), SlopeDiagram(course.cam)
    limits, turned = limits_of(cam), positions(cam)
    start, way, _ = axis(board)
    tip, end = laid_end(board, diagram, start, course.at(turned)[:2], "")
    bounds = tuple(pressure_bounds(diagram, limits))
    found = required(cam, limits, Place(0j, ()) if cam.sized else place(bounds, 0j, _choice(cam), cam.lift))
    laid = partial(_touching, board, diagram, (start, way))
    lines = tangents(board, diagram, touched(bounds, found), found.limits, laid)
    centre = _centre(board, cam, start, way, lines[: len(found.limits)])
    sizes = _sizes(cam, complex(centre.point))
    return Sizing(cam, limits, sizes, board, turned, start, start, tip, end, centre, bound_by(cam, lines), bounds)


def laid_end(
    board: Board, diagram: SlopeDiagram, start: Mark, motion: tuple[Floats, Floats], name: str
) -> tuple[Mark, Mark]:
    """Lay S off from A, and S' turned with the cam from there: K and D of some positions."""
    low = f"_{name}" if name else ""
    s = board.given(f"S{low}", 1j * motion[0], because("cam_travel"))
    tip = board.lay_off(f"K{low}", start, s, because("cam_laid"))
    slope = board.given(f"S'{low}", 1j * motion[1], because("cam_slope"))
    turned = board.turn(f"KD{low}", slope, 1j * diagram.cam.sense, because("cam_turned"))
    return tip, board.lay_off(f"T{low}" if name else "D", tip, turned, because("cam_slope_end"))


def _touching(board: Board, diagram: SlopeDiagram, ends: tuple[Mark, Mark], one: Touch, name: str) -> tuple[Mark, Mark]:
    """Lay off D where a ruler touches; the way of K is the same everywhere."""
    start, way = ends
    at = one.instant
    return laid_end(board, diagram, start, (at.s[0], at.slope[0]), name)[1], way


def _choice(cam: Cam) -> Choice:
    """Choose among the places for O: with e given those of one line."""
    offset = cam.given.offset
    return nearest(0j) if offset is None else on_line(complex(-cam.sense * offset), 1j, -1j)


def _centre(board: Board, cam: Cam, start: Mark, way: Mark, lines: Sequence[Tangent]) -> Mark:
    """Find O on the board, by the limiting lines and by what is given."""
    base = cam.given.base
    offset = 0.0 if cam.given.offset is None and base is not None and not lines else cam.given.offset
    if offset is not None:
        return _beside(board, cam, start, way, offset, lines)
    corner = met(board, "O" if base is None else "O'", lines, start, "cam_centre")
    if base is None:
        return corner
    ray = board.turn("R_0", board.join("AO'", start, corner), base / abs(complex(corner.point)), because("cam_base"))
    return board.lay_off("O", start, ray, because("cam_on_ray"))


def _beside(board: Board, cam: Cam, start: Mark, way: Mark, offset: float, lines: Sequence[Tangent]) -> Mark:
    """Find O on the line of a given offset: R0 from A where it is given, else on the limiting line."""
    across = board.given("e", complex(-cam.sense * offset), because("cam_offset"))
    beside = board.parallel("EO", board.lay_off("E", start, across, because("cam_offset")), way, because("cam_offset"))
    if cam.given.base is None:
        return board.meet("O", beside, lines[0].line, why=because("cam_on_line"))
    if abs(offset) >= cam.given.base:
        raise too_far(cam, offset, cam.given.base)
    arc = board.arc("R_0", start, cam.given.base, because("cam_base"))
    return board.meet("O", beside, arc, side=-1, why=because("cam_given_centre"))


def _sizes(cam: Cam, centre: complex) -> Sizes:
    """Give the sizes of a centre; those that are given are as they were given."""
    given = cam.given
    offset = 0.0 - cam.sense * centre.real if given.offset is None else given.offset
    return Sizes(abs(centre) if given.base is None else given.base, offset)
