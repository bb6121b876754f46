"""Angles of the turned plan that are those of the scheme, and its right angles (равные углы; theme 5)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from geometry.board import Mark, at
from plans.transfer.turned import TurnedPlan, loci

NEAR = 1e-6  # of a right angle: rounding, which is seen on no sheet
Ways = tuple[complex, complex]  # unit directions of the sides of an angle


class EqualAngle(NamedTuple):
    """An angle at an image and the same at its point of the scheme: vertices in true units, sides of either."""

    image: complex
    point: complex
    on_plan: Ways
    on_scheme: Ways


class Sides(NamedTuple):
    """The two lines in which an image was found, and the ways to where they begin."""

    image: complex
    lines: tuple[Mark, Mark]
    ways: Ways


def equal_angles(plan: TurnedPlan, points: dict[str, complex], column: int, least: float) -> Iterator[EqualAngle]:
    """Give for each named point that two lines find their angle and its own; none on sides below the `least`."""
    for name, image in plan.images.items():
        sides = _sides(image, column, least)
        if sides is None or name not in points or _square(*sides.ways):
            continue
        squares = [line.step.op == "square" for line in sides.lines]
        first, second = (way * (1j if all(squares) else 1) for way in sides.ways)
        along = at(sides.lines[squares.index(False) if False in squares else 0].step.inputs[1].point, column)
        link = first if not squares[0] or all(squares) else second
        sense = -1 if (link * along.conjugate()).real > 0 else 1
        yield EqualAngle(sides.image, points[name], sides.ways, (sense * first, sense * second))


def right_angles(marks: list[Mark], column: int, least: float) -> Iterator[tuple[complex, Ways]]:
    """Give vertex and sides of the right angles at images, and of lines square to a link where they begin."""
    for mark in marks:
        sides = _sides(mark, column, least)
        if sides is None:
            continue
        if _square(*sides.ways):
            yield sides.image, sides.ways
        for line, way in zip(sides.lines, sides.ways, strict=True):
            start, along = at(line.step.inputs[0].point, column), at(line.step.inputs[1].point, column)
            if line.step.op == "square" and start:
                yield start, (-way, -along / abs(along))


def _sides(image: Mark, column: int, least: float) -> Sides | None:
    lines = loci(image)
    if lines is None:
        return None
    vertex = at(image.point, column)
    rays = [at(line.step.inputs[0].point, column) - vertex for line in lines]
    if min(map(abs, rays)) < least:
        return None
    return Sides(vertex, lines, (rays[0] / abs(rays[0]), rays[1] / abs(rays[1])))


def _square(first: complex, second: complex) -> bool:
    return abs((first * second.conjugate()).real) < NEAR
