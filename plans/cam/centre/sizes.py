"""The main sizes of a cam by tangents of its S-S' diagram (основные размеры кулачка, 5.9.4, figures 5.49-5.51).

The book takes a rocker's chord for the way of K, so that all limiting lines of a phase are parallel. Here each line
leans as the arc does at its position; the construction by the chord stands beside.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from geometry.board import Board, Mark
from plans.cam.centre.bounds import Bound, RulerTouch, SlopeDiagram, pressure_bounds
from plans.cam.centre.flat_sizes import flat_sizing, rocking_face_sizing
from plans.cam.centre.place import (
    SIZES,
    CentrePlace,
    Choice,
    Chord,
    Laid,
    SizeTangent,
    Sizing,
    axis,
    bound_by,
    met,
    nearest,
    on_circle,
    place,
    required,
    rocker_sizes,
    tangents,
    touched,
    under,
)
from plans.cam.course import FollowerCourse, positions
from plans.cam.profile.touch import closed_in
from plans.model.cam import Cam, Limits, limits_of
from plans.model.cam_motion import CamSizes, Points, no_triangle, still, too_far
from plans.model.motion import Floats
from plans.words.words import because


def sizing(course: FollowerCourse) -> Sizing:
    """Find the main sizes that a scene does not give, or draw the diagram for those that it gives.

    Raises CamError where there are none.
    """
    cam = course.cam
    if cam.translates:
        return Sizing(cam, cam.limits, CamSizes(0.0), Board(SIZES))  # it has none
    if cam.given.base is None and not any(cam.moving()):
        raise still(cam)
    if cam.flat:
        return rocking_face_sizing(course) if cam.rocks else flat_sizing(course)
    return _rocking(course) if cam.rocks else _translating(course)


def _translating(course: FollowerCourse) -> Sizing:
    """Draw the diagram on the follower's way, push the rulers, and find O (figures 5.49, 5.50)."""
    cam, board, diagram = course.cam, Board(SIZES), SlopeDiagram(course.cam)
    limits = limits_of(cam)
    start, way, _ = axis(board)
    tip, end = laid_end(board, diagram, start, course.at(positions(cam))[:2])
    bounds = tuple(pressure_bounds(diagram, limits))
    offset = cam.given.offset
    choice = nearest(0j) if offset is None else under(complex(-cam.sense * offset))
    found = required(cam, limits, CentrePlace(0j, ()) if cam.sized else place(bounds, 0j, choice, cam.lift))

    def laid(touch: RulerTouch, name: str) -> tuple[Mark, Mark]:
        """Lay off D where a ruler touches; the way of K is the same everywhere."""
        return laid_end(board, diagram, start, touch.motion, name)[1], way

    lines = tangents(board, diagram, touched(bounds, found), found.limits, laid)
    centre = _centre(board, cam, start, way, _found_by(board, diagram, found, 0j, lines, laid))
    at = complex(centre.point)
    offset = 0.0 - cam.sense * at.real if offset is None else offset
    sizes = CamSizes(abs(at) if cam.given.base is None else cam.given.base, offset)
    return Sizing(cam, limits, sizes, board, start, start, tip, end, centre, bound_by(cam, lines), bounds)


def _found_by(
    board: Board, diagram: SlopeDiagram, found: CentrePlace, start: complex, lines: Sequence[SizeTangent], laid: Laid
) -> Sequence[SizeTangent]:
    """Give the tangents that O is found by: at a given R0 by trial, of the least share of the limits."""
    cam, base = diagram.cam, diagram.cam.given.base or 0.0
    if not cam.eased or abs(found.centre - start) >= base:
        return lines[: len(found.limits)]

    def tried(share: float) -> CentrePlace | None:
        """Give the place of the least R0 for a share of the limits: the smaller, the larger that is."""
        bounds = tuple(pressure_bounds(diagram, limits_of(cam).shared(share)))
        return place(bounds, start, nearest(start), max(cam.way, base))

    def spare(shares: Floats) -> Floats:
        tries = (tried(share) for share in shares.tolist())
        return np.array([-1.0 if spot is None else base / abs(spot.centre - start) - 1 for spot in tries])

    share = closed_in(spare, np.zeros(1), whole := np.ones(1), -whole, spare(whole))
    return tangents(board, diagram, (), (tried(float(share[0])) or found).limits, laid, "'")


Motion: TypeAlias = "tuple[Floats | float, Floats | float]"  # S and S'


def laid_end(board: Board, diagram: SlopeDiagram, track: Mark, motion: Motion, name: str = "") -> tuple[Mark, Mark]:
    """Give K and D of some positions: S laid off along the track, from A or on a rocker's circle, and S' from K."""
    return (_laid_on_arc if diagram.cam.rocks else _laid_upright)(board, diagram, track, motion, name)


def _laid_upright(board: Board, diagram: SlopeDiagram, start: Mark, motion: Motion, name: str) -> tuple[Mark, Mark]:
    """Lay S off from A, and S' turned with the cam from there."""
    low = f"_{name}" if name else ""
    s = board.given(f"S{low}", 1j * motion[0], because("cam_travel"))
    tip = board.lay_off(f"K{low}", start, s, because("cam_laid"))
    slope = board.given(f"S'{low}", 1j * motion[1], because("cam_slope"))
    turned = board.turn(f"KD{low}", slope, 1j * diagram.cam.sense, because("cam_turned"))
    return tip, board.lay_off(f"T{low}" if name else "D", tip, turned, because("cam_slope_end"))


def _laid_on_arc(board: Board, diagram: SlopeDiagram, circle: Mark, motion: Motion, name: str) -> tuple[Mark, Mark]:
    """Divide the arc by the law, and lay KD along the rocker: towards O1 where it turns with the cam on the rise."""
    low, cam = f"_{name}" if name else "", diagram.cam
    s, slope = (np.asarray(value) for value in motion)
    arms = board.given(f"ψ{low}", _settled(cam.rising * diagram.leaning(s)), because("cam_arms"))
    tip = board.divide(f"K{low}", circle, arms, because("cam_divided"))
    arm = board.join(f"r{low}", circle.step.inputs[0], tip)
    turned = board.turn(f"KD{low}", arm, _settled(-cam.follower.sense * slope + 0j), because("cam_turned"))
    return tip, board.lay_off(f"T{low}" if name else "D", tip, turned, because("cam_slope_end"))


def _settled(value: Points) -> Points | complex:
    return value if value.ndim else complex(value)


def _centre(board: Board, cam: Cam, start: Mark, way: Mark, lines: Sequence[SizeTangent]) -> Mark:
    """Find O on the board, by the limiting lines and by what is given."""
    base = cam.given.base
    offset = 0.0 if cam.given.offset is None and base is not None and not lines else cam.given.offset
    if offset is not None:
        return _beside(board, cam, start, way, offset, lines)
    corner = met(board, "O" if base is None else "O'", lines, start, "cam_centre")
    if base is None:
        return corner
    return _on_ray(board, "AO'", start, corner, base)


def _beside(board: Board, cam: Cam, start: Mark, way: Mark, offset: float, lines: Sequence[SizeTangent]) -> Mark:
    """Find O on the line of a given offset: R0 from A where it is given, else on the limiting line."""
    across = board.given("e", complex(-cam.sense * offset), because("cam_offset"))
    beside = board.parallel("EO", board.lay_off("E", start, across, because("cam_offset")), way, because("cam_offset"))
    if cam.given.base is None:
        return board.meet("O", beside, lines[0].line, why=because("cam_on_line"))
    if abs(offset) >= cam.given.base:
        raise too_far(cam, offset, cam.given.base)
    arc = board.arc("R_0", start, cam.given.base, because("cam_base"))
    return board.meet("O", beside, arc, side=-1, why=because("cam_given_centre"))


def _on_ray(board: Board, name: str, start: Mark, corner: Mark, base: float) -> Mark:
    """Give O at R0 from the start, towards where two limiting lines meet."""
    ray = board.join(name, start, corner)
    ray = board.turn("R_0", ray, base / abs(complex(ray.point)), because("cam_base"))
    return board.lay_off("O", start, ray, because("cam_on_ray"))


def _rocking(course: FollowerCourse) -> Sizing:
    """Draw the diagram on the rocker's arc, push the rulers, and find O (figure 5.51)."""
    cam, board, diagram = course.cam, Board(SIZES), SlopeDiagram(course.cam)
    limits = limits_of(cam)
    pivot = board.given("O_1", 0j, because("cam_pivot"))
    circle = board.arc("l", pivot, diagram.length, because("cam_arm"))
    tip, end = laid_end(board, diagram, circle, course.at(positions(cam))[:2])
    start, _ = laid_end(board, diagram, circle, (0.0, 0.0), "0")
    first = complex(start.point)
    bounds = tuple(pressure_bounds(diagram, limits))
    sought = CentrePlace(first, ()) if cam.sized else place(bounds, *_choice(cam, first), diagram.length)
    found = required(cam, limits, sought, first)

    def laid(touch: RulerTouch, name: str) -> tuple[Mark, Mark]:
        """Lay off D where a ruler touches, and the way of K there: square to the rocker."""
        far = laid_end(board, diagram, circle, touch.motion, name)[1]
        return far, board.turn(f"u_{name}", board[f"ψ_{name}"], 1j * cam.rising, because("cam_way"))

    lines = tangents(board, diagram, touched(bounds, found), found.limits, laid)
    by = _found_by(board, diagram, found, first, lines, laid)
    centre = _rocker_centre(board, cam, (pivot, start), by, found.centre)
    chord = _chord(board, diagram, limits, (pivot, start), centre, laid) if found.limits else None
    sizes = rocker_sizes(cam, complex(centre.point), first)
    return Sizing(cam, limits, sizes, board, pivot, start, tip, end, centre, bound_by(cam, lines), bounds, chord)


def _choice(cam: Cam, first: complex) -> tuple[complex, Choice]:
    """Choose among the places for O: nearest to K0, with L given on its arc below the rocker."""
    centre = cam.given.centre
    if centre is None:
        return first, nearest(first)
    start = centre * first / abs(first)
    return start, on_circle(centre, lambda at: abs(at - first), start, -1j * cam.rising * first)


def _rocker_centre(
    board: Board, cam: Cam, ends: tuple[Mark, Mark], lines: Sequence[SizeTangent], near: complex
) -> Mark:
    """Find O on the board, by the limiting lines and by what is given; `near` tells which meeting is meant."""
    pivot, start = ends
    base, centre = cam.given.base, cam.given.centre
    if centre is not None:
        arc = board.arc("L", pivot, centre, because("cam_distance"))
        if base is not None:
            length = abs(complex(ends[1].point))
            if not abs(length - base) < centre < length + base:
                raise no_triangle(cam, length, base, centre)
            other = board.arc("R_0", ends[1], base, because("cam_base"))
            return board.meet("O", arc, other, side=-cam.rising, why=because("cam_given_centre"))
        side = 1 if (near / complex(lines[0].direction.point)).real > 0 else -1
        return board.meet("O", lines[0].line, arc, side=side, why=because("cam_on_arc"))
    corner = met(board, "O" if base is None else "O*", lines, start, "cam_centre")
    if base is None:
        return corner
    return _on_ray(board, "K_0O*", start, corner, base)


def _chord(
    board: Board, diagram: SlopeDiagram, limits: Limits, ends: tuple[Mark, Mark], centre: Mark, locus: Laid
) -> Chord | None:
    """Draw the book's construction: the arc straightened to its chord, and tangents at the limits to that."""
    cam, start = diagram.cam, ends[1]
    if cam.given.base is not None or cam.given.centre is not None:
        return None
    bounds: tuple[Bound, ...] = tuple(pressure_bounds(diagram, limits, level=True))
    found = place(bounds, complex(start.point), nearest(complex(start.point)), diagram.length)
    if found is None or not found.limits:
        return None
    top = complex(diagram.leaning(np.array([cam.lift]))[0])
    last = board.divide("K_m", board["l"], board.given("ψ_m", cam.rising * top, because("cam_arms")))
    way = board.join("K_0K_m", start, last, because("cam_chord"))
    lines = tangents(board, diagram, (), found.limits, lambda touch, name: (locus(touch, name)[0], way), "'")
    by_chord = met(board, "O'", lines, start, "cam_chord_centre")
    board.join("OO'", centre, by_chord, because("cam_error"))
    return Chord(lines, by_chord)
