"""The main sizes of a cam with a rocker, by the limiting line of each position (коромысло, figure 5.51).

The book takes the arc's chord for the way of K, so that all limiting lines of a phase are parallel. Here each line
leans as the arc does at its position; the construction by the chord stands beside.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from functools import partial

import numpy as np

from geometry.board import Board, Mark
from plans.cam.centre.bounds import Bound, Touch, pressure_bounds
from plans.cam.centre.slope_diagram import SlopeDiagram
from plans.cam.centre.tangents import (
    Choice,
    Laid,
    Place,
    bound_by,
    met,
    nearest,
    on_circle,
    place,
    required,
    tangents,
    touched,
)
from plans.cam.course import Course, positions
from plans.cam.sizing import SIZES, Chord, Sizing, Tangent
from plans.model.cam import Cam, Limits, limits_of
from plans.model.cam_faults import no_triangle
from plans.model.cam_motion import Points, Sizes
from plans.model.motion import Floats
from plans.words.words import because


def rocker_sizing(course: Course) -> Sizing:
    """Draw the diagram on the rocker's arc, push the rulers, and find O."""
    cam, board, diagram = course.cam, Board(SIZES), SlopeDiagram(course.cam)
    limits, turned = limits_of(cam), positions(course.cam)
    pivot = board.given("O_1", 0j, because("cam_pivot"))
    circle = board.arc("l", pivot, diagram.length, because("cam_arm"))
    tip, end = laid_end(board, diagram, circle, course.at(turned)[:2], "")
    start, _ = laid_end(board, diagram, circle, (0.0, 0.0), "0")
    first = complex(start.point)
    bounds = tuple(pressure_bounds(diagram, limits))
    sought = Place(first, ()) if cam.sized else place(bounds, *_choice(cam, first), diagram.length)
    found, laid = required(cam, limits, sought, first), partial(_touching, board, diagram, circle)
    lines = tangents(board, diagram, touched(bounds, found), found.limits, laid)
    centre = _centre(board, cam, (pivot, start), lines[: len(found.limits)], found.centre)
    chord = _chord(board, diagram, limits, (pivot, start), centre, laid) if found.limits else None
    sizes = rocker_sizes(cam, complex(centre.point), first)
    return Sizing(
        cam, limits, sizes, board, turned, pivot, start, tip, end, centre, bound_by(cam, lines), bounds, chord
    )


def laid_end(
    board: Board, diagram: SlopeDiagram, circle: Mark, motion: tuple[Floats | float, Floats | float], name: str
) -> tuple[Mark, Mark]:
    """Divide the arc by the law, and lay KD along the rocker: towards O1 where it turns with the cam on the rise."""
    low, cam = f"_{name}" if name else "", diagram.cam
    s, slope = (np.asarray(one) for one in motion)
    arms = board.given(f"ψ{low}", _settled(cam.rising * diagram.leaning(s)), because("cam_arms"))
    tip = board.divide(f"K{low}", circle, arms, because("cam_divided"))
    arm = board.join(f"r{low}", circle.step.inputs[0], tip)
    turned = board.turn(f"KD{low}", arm, _settled(-cam.follower.sense * slope + 0j), because("cam_turned"))
    return tip, board.lay_off(f"T{low}" if name else "D", tip, turned, because("cam_slope_end"))


def _touching(board: Board, diagram: SlopeDiagram, circle: Mark, one: Touch, name: str) -> tuple[Mark, Mark]:
    """Lay off D where a ruler touches, and the way of K there: square to the rocker."""
    at = one.instant
    _, far = laid_end(board, diagram, circle, (at.s[0], at.slope[0]), name)
    return far, board.turn(f"u_{name}", board[f"ψ_{name}"], 1j * diagram.cam.rising, because("cam_way"))


def _settled(value: Points) -> Points | complex:
    return value if value.ndim else complex(value)


def _choice(cam: Cam, first: complex) -> tuple[complex, Choice]:
    """Choose among the places for O: nearest to K0, with L given on its arc below the rocker."""
    centre = cam.given.centre
    if centre is None:
        return first, nearest(first)
    start = centre * first / abs(first)
    return start, on_circle(centre, lambda at: abs(at - first), start, -1j * cam.rising * first)


def _centre(board: Board, cam: Cam, ends: tuple[Mark, Mark], lines: Sequence[Tangent], near: complex) -> Mark:
    """Find O on the board, by the limiting lines and by what is given; `near` tells which meeting is meant."""
    pivot, start = ends
    base, centre = cam.given.base, cam.given.centre
    if centre is not None:
        arc = board.arc("L", pivot, centre, because("cam_distance"))
        if base is not None:
            return _notched(board, cam, ends, arc, base, centre)
        side = 1 if (near / complex(lines[0].direction.point)).real > 0 else -1
        return board.meet("O", lines[0].line, arc, side=side, why=because("cam_on_arc"))
    corner = met(board, "O" if base is None else "O*", lines, start, "cam_centre")
    if base is None:
        return corner
    ray = board.join("K_0O*", start, corner)
    ray = board.turn("R_0", ray, base / abs(complex(ray.point)), because("cam_base"))
    return board.lay_off("O", start, ray, because("cam_on_ray"))


def _notched(board: Board, cam: Cam, ends: tuple[Mark, Mark], arc: Mark, base: float, centre: float) -> Mark:
    """Find O by two notches, L from O1 and R0 from K0, on the side from which the cam lifts the rocker."""
    length = abs(complex(ends[1].point))
    if not abs(length - base) < centre < length + base:
        raise no_triangle(cam, length, base, centre)
    other = board.arc("R_0", ends[1], base, because("cam_base"))
    return board.meet("O", arc, other, side=-cam.rising, why=because("cam_given_centre"))


def _chord(
    board: Board, diagram: SlopeDiagram, limits: Limits, ends: tuple[Mark, Mark], centre: Mark, laid: Laid
) -> Chord | None:
    """Draw the book's construction: the arc straightened to its chord, and tangents at the limits to that."""
    cam, start = diagram.cam, ends[1]
    if cam.given.base is not None or cam.given.centre is not None:
        return None
    bounds: tuple[Bound, ...] = tuple(pressure_bounds(diagram, limits, level=True))
    found = place(bounds, complex(start.point), nearest(complex(start.point)), diagram.length)
    if found is None or not found.limits:
        return None
    last = board.divide(
        "K_m", board["l"], board.given("ψ_m", complex(cam.rising * _leaning(diagram)), because("cam_arms"))
    )
    way = board.join("K_0K_m", start, last, because("cam_chord"))
    lines = tangents(board, diagram, (), found.limits, lambda one, name: (laid(one, name)[0], way), "'")
    by_chord = met(board, "O'", lines, start, "cam_chord_centre")
    return Chord(lines, by_chord, board.join("OO'", centre, by_chord, because("cam_error")))


def _leaning(diagram: SlopeDiagram) -> complex:
    return complex(diagram.leaning(np.array([diagram.cam.lift]))[0])


def rocker_sizes(cam: Cam, centre: complex, first: complex, base: float | None = None) -> Sizes:
    """Give the sizes of a centre seen from O1, with K0 or the direction of the arm; those given as they were given."""
    given = cam.given
    initial = cam.rising * cmath.phase(first / centre)
    own = base if base is not None else abs(first - centre)
    return Sizes(
        own if given.base is None else given.base,
        0.0,
        abs(centre) if given.centre is None else given.centre,
        -centre,
        initial,
    )
