"""The least radius under a flat face, by convexity (плоский, тарельчатый толкатель: условие выпуклости)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark
from geometry.meet import dot
from plans.cam.centre.bounds import (
    Bound,
    CurvatureBound,
    Instant,
    Lines,
    SlopeDiagram,
    SmoothStretch,
    limit,
    stretches,
    touch,
)
from plans.cam.centre.place import SIZES, SizeTangent, Sizing, axis, on_circle, place, rocker_sizes
from plans.cam.course import FollowerCourse, positions
from plans.model.cam import Cam
from plans.model.cam_motion import HARD, CamSizes, fast_face, hard_face, no_distance, no_level, no_radius, no_region
from plans.model.motion import Floats
from plans.words.words import because

DOWN = 1 - 1j  # along the lines S + S'' = const


class FallBound(NamedTuple):
    """The lines S + S'' = const of all positions: O lies below each by the least radius of curvature."""

    along: tuple[SmoothStretch, ...]

    def lines(self, motion: Instant) -> Lines:
        """Give the lines in the plane of S'' across and S upwards."""
        return Lines(np.full_like(motion.s, 1 + 1j, dtype=complex), motion.s + motion.bend)

    def moving(self, motion: Instant) -> Lines:
        """Give how they shift."""
        return Lines(np.zeros_like(motion.s, dtype=complex), motion.slope + motion.jerk)


def _smooth(course: FollowerCourse) -> None:
    """Refuse a law whose S' falls at once: the profile would have to lie on both sides of its own tangent."""
    for shock in course.shocks:
        if shock.order == HARD and shock.jump < 0:
            raise hard_face(course.cam, shock.turned)


def flat_sizing(course: FollowerCourse) -> Sizing:
    """Push a ruler at 45 degrees against the curve of S over S'': R0 is from its cut with the axis, and ρ_min more."""
    cam, board = course.cam, Board(SIZES)
    if cam.given.base is None:
        _smooth(course)
    start, _, along = axis(board)
    travel = course.at(positions(cam))
    tip, end = _line(board, start, (travel.s, travel.bend), "")
    tangent = _fallen(board, cam, start)
    base = cam.given.base
    cut = board.meet("B", along, tangent.line, why=because("cam_cut"))
    below = board.given("ρ", -1j * cam.limits.curvature, because("cam_least_radius"))
    least = board.lay_off("O" if base is None else "O'", cut, below, because("cam_face_centre"))
    centre = least if base is None else board.given("O", -1j * base, because("cam_given_centre"))
    sizes = CamSizes(-complex(centre.point).imag if cam.given.base is None else cam.given.base, cam.given.offset or 0.0)
    if sizes.base <= 0:
        raise no_radius(cam)
    bounds = (tangent.bound,)
    return Sizing(cam, cam.limits, sizes, board, start, start, tip, end, centre, (tangent,), bounds)


def _fallen(board: Board, cam: Cam, start: Mark) -> SizeTangent:
    """Draw the ruler where it touches the curve of S over S''."""
    bound: Bound = FallBound(stretches(cam, {phase.kind for phase in cam.phases}))
    found = limit(bound, 0j).touch
    at = found.instant
    point = _line(board, start, (at.s[0], at.bend[0]), "1")[1]
    direction = board.given("t_1", DOWN, because("cam_convex"))
    line = board.parallel("τ_1", point, direction, because("cam_ruler"))
    return SizeTangent(bound, found, point, direction, line, cam.given.base is None)


def _line(board: Board, start: Mark, motion: tuple[Floats, Floats], name: str) -> tuple[Mark, Mark]:
    low = f"_{name}" if name else ""
    s = board.given(f"S{low}", 1j * motion[0], because("cam_travel"))
    tip = board.lay_off(f"K{low}", start, s, because("cam_laid"))
    bend = board.given(f"S''{low}", motion[1] + 0j, because("cam_bend"))
    return tip, board.lay_off(f"T{low}" if name else "D", tip, bend, because("cam_bend_end"))


def rocking_face_sizing(course: FollowerCourse) -> Sizing:
    """Find the place of O on the arc of L where the profile is just convex enough, and the face stands lowest."""
    cam, board, diagram = course.cam, Board(SIZES), SlopeDiagram(course.cam)
    if cam.given.centre is None:
        raise no_distance(cam)
    pivot = board.given("O_1", 0j, because("cam_pivot"))
    arc = board.arc("L", pivot, cam.given.centre, because("cam_distance"))
    bound = CurvatureBound(diagram, cam.limits.curvature)
    up, arm = bound.upright
    lines: tuple[SizeTangent, ...] = ()
    if cam.given.base is not None:
        centre = _level(board, cam, (pivot, arc), up, arm)
    else:
        lines, centre = _lowest(course, board, bound, arc)
    base = cam.follower.face - float(dot(complex(centre.point), up))
    if base <= 0:
        raise no_radius(cam)
    sizes, bounds = rocker_sizes(cam, complex(centre.point), arm, base), (bound,)
    return Sizing(cam, cam.limits, sizes, board, pivot, pivot, None, None, centre, lines, bounds)


def _lowest(
    course: FollowerCourse, board: Board, bound: CurvatureBound, arc: Mark
) -> tuple[tuple[SizeTangent, ...], Mark]:
    """Find O where the line of least curvature cuts the arc of L."""
    _smooth(course)
    moving = stretches(course.cam, {phase.kind for phase in course.cam.moving()})
    sense = course.cam.follower.sense
    fastest = touch(moving, lambda at: (sense * at.slope, sense * at.bend))
    if fastest.beyond >= 1:  # its face would stand still on the cam, and then go back
        raise fast_face(course.cam, fastest.turned)
    line, near = _convex(board, course.cam, bound, *bound.upright)
    side = 1 if (near / complex(line.direction.point)).real > 0 else -1
    return (line,), board.meet("O", line.line, arc, side=side, why=because("cam_on_arc"))


def _level(board: Board, cam: Cam, arc: tuple[Mark, Mark], up: complex, arm: complex) -> Mark:
    """Find O at a given distance from the face, on the arc of L."""
    base, centre = cam.given.base, cam.given.centre
    assert base is not None and centre is not None  # asked before
    height = cam.follower.face - base
    if abs(height) >= centre:
        raise no_level(cam, base, centre)
    foot = board.lay_off("B", arc[0], board.given("h", height * up, because("cam_face")), because("cam_face"))
    level = board.parallel("BO", foot, board.given("u", arm, because("cam_arms")), because("cam_face"))
    return board.meet("O", level, arc[1], side=1, why=because("cam_given_centre"))


def _convex(board: Board, cam: Cam, bound: Bound, up: complex, arm: complex) -> tuple[SizeTangent, complex]:
    """Push the line of least curvature until it touches, and draw it; O is near the place that is given beside."""
    radius, face = cam.given.centre or 0.0, cam.follower.face
    start = radius * up
    found = place((bound,), start, on_circle(radius, lambda at: face - float(dot(at, up)), start, arm), radius)
    if found is None or not found.limits:
        raise no_region(cam, cam.limits)
    line = limit(bound, found.centre)
    point = board.given("T_1", line.reach * line.normal, because("cam_convex_point"))
    direction = board.given("t_1", 1j * line.normal, because("cam_convex_way"))
    drawn = board.parallel("τ_1", point, direction, because("cam_limit_line"))
    return SizeTangent(bound, line.touch, point, direction, drawn, True), found.centre
