"""The main sizes of a cam with a rocker, by the limiting line of each position (коромысло, figure 5.51).

The book takes the arc's chord for the way of K, so that all limiting lines of a phase are parallel. Here each line
leans as the arc does at its position; the construction by the chord stands beside.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import combinations
from typing import NamedTuple, TypeAlias

import numpy as np

from geometry.board import Board, Mark
from geometry.meet import EPS, cross, dot
from plans.cam.centre.bounds import Bound, Limit, PressureBound, SlopeDiagram, Touch, limit, pressure_bounds, side_of
from plans.cam.course import Course, positions
from plans.cam.sizing import SIZES, Chord, Sizing, Tangent
from plans.model.cam import LEAST_BASE, Cam, Limits, limits_of
from plans.model.cam_motion import Points, Sizes, no_region, no_triangle, vanishing
from plans.model.motion import Floats
from plans.words.words import because

ROUNDS = 60  # of pushing a ruler; about six are needed
ROUNDED = 32 * EPS  # of the size of the diagram: a line that is broken by less is kept
PARALLEL = 1e-9  # sine of the angle of two lines that touch one curve at one place: they have no meeting of their own

# The lines so far, how far one may be broken -> the best place within them and the lines that it lies on.
Choice: TypeAlias = Callable[[Sequence[Limit], float], "Place | None"]


class Place(NamedTuple):
    """A place for the centre, and the limiting lines that it lies on: two, one, or none."""

    centre: complex
    limits: tuple[Limit, ...]


def place(bounds: Sequence[Bound], start: complex, choice: Choice, size: float) -> Place | None:
    """Find the best place within all bounds, beginning from one; None: there is none."""
    best = Place(start, ())
    known: list[Limit] = []
    for _ in range(ROUNDS):
        broken = [one for bound in bounds if (one := limit(bound, best.centre)).beyond(best.centre) > ROUNDED * size]
        if not broken:
            # What is held to a rounding is touched to the root of it only: the last touches are anew.
            return choice([limit(one.bound, best.centre) for one in best.limits], ROUNDED * size) or best
        known = [*best.limits, *broken]
        found = choice(known, ROUNDED * size)
        if found is None:
            return None
        best = found
    return None


def nearest(to: complex) -> Choice:
    """Choose the place nearest to a point: a corner of the region, or the foot of a perpendicular on its edge."""

    def choice(limits: Sequence[Limit], slack: float) -> Place | None:
        return _best([*_feet(to, limits), *_corners(limits)], limits, slack, lambda at: abs(at - to))

    return choice


def _best(
    places: Sequence[Place], limits: Sequence[Limit], slack: float, cost: Callable[[complex], float]
) -> Place | None:
    within = [one for one in places if all(line.beyond(one.centre) <= slack for line in limits)]
    return min(within, key=lambda one: cost(one.centre), default=None)


def _feet(to: complex, limits: Sequence[Limit]) -> Iterator[Place]:
    for one in limits:
        yield Place(to - one.beyond(to) * one.normal, (one,))


def _corners(limits: Sequence[Limit]) -> Iterator[Place]:
    for first, second in combinations(limits, 2):
        sine = float(cross(first.normal, second.normal))
        if abs(sine) > PARALLEL:
            yield Place(1j * (second.reach * first.normal - first.reach * second.normal) / sine, (first, second))


def on_line(through: complex, along: complex, ahead: complex) -> Choice:
    """Choose the place on a line nearest to a point of it, on the side `ahead`."""

    def choice(limits: Sequence[Limit], slack: float) -> Place | None:
        places = [Place(through, ())]
        for line in limits:
            rate = float(dot(line.normal, along))
            if abs(rate) > PARALLEL:
                places.append(Place(through - line.beyond(through) / rate * along, (line,)))
        ahead_of = [one for one in places if dot(one.centre - through, ahead) >= -slack]
        return _best(ahead_of, limits, slack, lambda at: abs(at - through))

    return choice


def on_circle(radius: float, cost: Callable[[complex], float], start: complex, ahead: complex) -> Choice:
    """Choose the cheapest place on a circle about the origin, on the side `ahead`."""

    def choice(limits: Sequence[Limit], slack: float) -> Place | None:
        places = [Place(start, ()), *(one for line in limits for one in _cuts(radius, line))]
        return _best([one for one in places if dot(one.centre, ahead) >= -slack], limits, slack, cost)

    return choice


def _cuts(radius: float, line: Limit) -> Iterator[Place]:
    """Give where a line cuts the circle."""
    if abs(line.reach) <= radius:
        half = math.acos(line.reach / radius)
        for turned in (half, -half):
            yield Place(radius * line.normal * cmath.exp(1j * turned), (line,))


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
