"""Trimming: lines end where they meet the outline of a symbol; none runs inside it (обрезка линий)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from drawings.lettering.lettering import bounds
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import TURN, Arc, Circle, Line, Polyline, Stroke

Mask = Circle | Polyline  # a circle, or a closed convex outline


def trim(strokes: Iterable[Stroke], masks: Sequence[Mask]) -> Iterator[Stroke]:
    """Cut lines, chains and arcs at the outlines of masks and drop what is inside; other strokes pass.

    >>> [line.start for line in trim([Line(-5 + 0j, 5 + 0j)], [Circle(0j, 2)])]
    [(-5+0j), (2+0j)]
    """
    for stroke in strokes:
        match stroke:
            case Line(start, end):
                near = [mask for mask in masks if _touches(mask, (start + end) / 2, abs(end - start) / 2)]
                yield from _line(stroke, near) if near else (stroke,)
            case Polyline(points, closed):
                yield from _chain(stroke, [*points, points[0]] if closed else list(points), masks)
            case Arc(centre, radius):
                near = [mask for mask in masks if _touches(mask, centre, radius)]
                yield from _arc(stroke, near) if near else (stroke,)
            case _:
                yield stroke


def holds(mask: Mask, spot: complex) -> bool:
    """Tell whether a spot lies inside a mask."""
    if isinstance(mask, Circle):
        return abs(spot - mask.centre) < mask.radius
    sides = [((end - start).conjugate() * (spot - start)).imag for start, end in _sides(mask)]
    return all(side > 0 for side in sides) or all(side < 0 for side in sides)


def around(head: Stroke, clear: float) -> Polyline:
    """Give the box around a caption, so far clear of it, mm: a mask of the lines that run past."""
    left, bottom, right, top = bounds(head)
    low, high = complex(left, bottom) - clear * (1 + 1j), complex(right, top) + clear * (1 + 1j)
    return Polyline((low, complex(high.real, low.imag), high, complex(low.real, high.imag)), True)


def distinct(strokes: Iterable[Stroke]) -> Iterator[Stroke]:
    """Drop each line that another one is on paper already, whichever way it runs; other strokes pass.

    >>> [line.start for line in distinct([Line(0j, 5 + 0j), Line(5 + 0j, 0j), Line(0j, 6 + 0j)])]
    [0j, 0j]
    """
    kept: list[Line] = []
    for stroke in strokes:
        if isinstance(stroke, Line):
            if any(_alike(stroke, other.start, other.end) or _alike(stroke, other.end, other.start) for other in kept):
                continue
            kept.append(stroke)
        yield stroke


def _alike(line: Line, start: complex, end: complex) -> bool:
    return max(abs(line.start - start), abs(line.end - end)) <= QUANTUM


def _sides(outline: Polyline) -> Iterator[tuple[complex, complex]]:
    return pairwise((*outline.points, outline.points[0]))


def _round(mask: Mask) -> tuple[complex, float]:
    """Give a circle about a mask."""
    if isinstance(mask, Circle):
        return mask.centre, mask.radius
    middle = sum(mask.points) / len(mask.points)
    return middle, max(abs(point - middle) for point in mask.points)


def _touches(mask: Mask, centre: complex, reach: float) -> bool:
    middle, radius = _round(mask)
    return abs(middle - centre) < radius + reach


def _line(line: Line, masks: Sequence[Mask]) -> Iterator[Line]:
    run = line.end - line.start
    cuts = (share for mask in masks for share in _line_cuts(line.start, run, mask))
    for low, high in _kept(cuts, masks, lambda share: line.start + share * run):
        yield line._replace(start=line.start + low * run, end=line.start + high * run)


def _arc(arc: Arc, masks: Sequence[Mask]) -> Iterator[Arc]:
    cuts = (share for mask in masks for share in _arc_cuts(arc, mask))
    for low, high in _kept(cuts, masks, arc.at):
        yield arc._replace(start_angle=arc.start_angle + low * arc.sweep, end_angle=arc.start_angle + high * arc.sweep)


def _kept(
    cuts: Iterable[float], masks: Sequence[Mask], at: Callable[[float], complex]
) -> Iterator[tuple[float, float]]:
    """Give the shares between which a line lies outside all masks."""
    shares = sorted({0.0, 1.0, *(share for share in cuts if 0 < share < 1)})
    runs: list[tuple[float, float]] = []
    for low, high in pairwise(shares):
        if any(holds(mask, at((low + high) / 2)) for mask in masks):
            continue
        if runs and runs[-1][1] == low:
            runs[-1] = (runs[-1][0], high)
        else:
            runs.append((low, high))
    return iter(runs)


def _line_cuts(start: complex, run: complex, mask: Mask) -> list[float]:
    """Give the shares of a line at which it meets a mask's outline."""
    length = abs(run)
    if length == 0:
        return []
    if isinstance(mask, Circle):
        towards = (mask.centre - start) * run.conjugate() / length
        half = mask.radius**2 - towards.imag**2
        return [] if half <= 0 else [(towards.real + sign * math.sqrt(half)) / length for sign in (-1, 1)]
    shares = []
    for corner, following in _sides(mask):
        side = following - corner
        crossed = (run.conjugate() * side).imag
        share = ((corner - start).conjugate() * side).imag / crossed if crossed else -1.0
        off = ((corner - start).conjugate() * run).imag / crossed if crossed else -1.0
        shares += [share] if 0 <= off <= 1 else []
    return shares


def _arc_cuts(arc: Arc, mask: Mask) -> list[float]:
    """Give the shares of an arc at which it meets a mask's outline."""
    if arc.sweep == 0:
        return []
    spots: list[complex] = []
    if isinstance(mask, Circle):
        apart = abs(mask.centre - arc.centre)
        if abs(arc.radius - mask.radius) < apart < arc.radius + mask.radius:
            # Where they barely touch, rounding may lift the cosine over 1: the two meetings are one.
            cosine = (apart**2 + arc.radius**2 - mask.radius**2) / (2 * apart * arc.radius)
            half = math.acos(max(-1.0, min(1.0, cosine)))
            spots = [(mask.centre - arc.centre) * cmath.rect(1.0, turn) for turn in (-half, half)]
    else:
        circle = Circle(arc.centre, arc.radius)
        for start, end in _sides(mask):
            shares = (share for share in _line_cuts(start, end - start, circle) if 0 <= share <= 1)
            spots += [start + share * (end - start) - arc.centre for share in shares]
    return [((cmath.phase(spot) - arc.start_angle) % TURN) / arc.sweep for spot in spots]


def _chain(chain: Polyline, points: list[complex], masks: Sequence[Mask]) -> Iterator[Stroke]:
    """Cut a chain piece by piece, and join again what follows on."""
    spots = np.array(points)
    longest = float(np.abs(np.diff(spots)).max())
    near = [mask for mask in masks if (np.abs(spots - _round(mask)[0]) < _round(mask)[1] + longest).any()]
    if not near:
        yield chain
        return
    runs: list[list[complex]] = []
    for start, end in pairwise(points):
        for piece in _line(Line(start, end), near):
            if runs and runs[-1][-1] == piece.start:
                runs[-1].append(piece.end)
            else:
                runs.append([piece.start, piece.end])
    if len(runs) > 1 and chain.closed and runs[0][0] == runs[-1][-1]:
        runs[0] = [*runs.pop(), *runs[0][1:]]
    for run in runs:
        yield Polyline(tuple(run), False, chain.style)
