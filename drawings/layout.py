"""Layout of paper: what is already inked, and labels that find a free place near what they name."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable

import numpy as np

from drawings.strokes import Arc, Box, Circle, Fill, Group, Line, Polyline, Stroke, Text, bounds

CELL = 0.5  # mm, the grain of the ink map: finer than a thin line's least distance
TEXT_INK = 40  # a letter under another is as bad as this many crossed cells of line
DIRECTIONS = 16
REACHES = (0.0, 1.5, 3.5, 6.0, 9.0)  # mm a label may stand further off than its nearest place


class Ink:
    """A map of what is drawn on a sheet, in cells; counts of lines and of letters under a box."""

    def __init__(self, width: float, height: float) -> None:
        self._map = np.zeros((int(height / CELL) + 2, int(width / CELL) + 2), dtype=np.int32)

    def bar(self, field: Box) -> None:
        """Keep labels inside a field: what lies outside counts as lettered over."""
        inside = np.zeros_like(self._map, dtype=bool)
        rows, columns = self._cells(field)
        inside[rows, columns] = True
        self._map[~inside] += TEXT_INK

    def draw(self, strokes: Iterable[Stroke]) -> None:
        """Ink strokes in."""
        for stroke in strokes:
            match stroke:
                case Group():
                    self.draw(stroke.strokes)
                case Text():
                    self._stamp(bounds(stroke), TEXT_INK)
                case Line():
                    self._track([stroke.start, stroke.end])
                case Polyline() | Fill():
                    points = list(stroke.points)
                    closed = isinstance(stroke, Fill) or stroke.closed
                    self._track(points + points[:1] if closed else points)
                case Circle():
                    self._track(_round(stroke.centre, stroke.radius, 0.0, 2 * math.pi))
                case Arc():
                    self._track(_round(stroke.centre, stroke.radius, stroke.start_angle, stroke.sweep))

    def under(self, box: Box) -> int:
        """Count what a box would cover."""
        rows, columns = self._cells(box)
        return int(self._map[rows, columns].sum())

    def _cells(self, box: Box) -> tuple[slice, slice]:
        left, bottom, right, top = (max(int(side / CELL), 0) for side in box)
        return slice(bottom, top + 1), slice(left, right + 1)

    def _stamp(self, box: Box, weight: int) -> None:
        rows, columns = self._cells(box)
        self._map[rows, columns] += weight

    def _track(self, points: list[complex]) -> None:
        """Mark the cells along a chain of points, each segment sampled at the map's grain."""
        chain = np.asarray(points)
        steps = np.diff(chain)
        counts = np.maximum((np.abs(steps) / CELL).astype(int), 1)
        which = np.repeat(np.arange(len(steps)), counts)
        share = (np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)) / counts[which]
        along = chain[which] + steps[which] * share
        rows = np.clip((along.imag / CELL).astype(int), 0, self._map.shape[0] - 1)
        columns = np.clip((along.real / CELL).astype(int), 0, self._map.shape[1] - 1)
        self._map[rows, columns] += 1


def _round(centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    count = max(int(abs(sweep) * radius / CELL), 8)
    return [centre + cmath.rect(radius, start + sweep * k / count) for k in range(count + 1)]


class Labels:
    """Labels of one sheet: each takes the freest place around its point and is inked in at once."""

    def __init__(self, ink: Ink, slanted: bool = True) -> None:
        self._ink, self._slanted = ink, slanted

    def beside(self, point: complex, content: str, size: float, gap: float, prefer: float = math.pi / 4) -> Text:
        """Place a label `gap` mm beside a point, as near as it can to the preferred direction, rad."""
        box = bounds(Text(0j, content, size, "start", self._slanted))
        best, cheapest = point, math.inf
        for reach in REACHES:
            if cheapest <= 0.8 * reach:
                break  # no place further off can be better
            for turn in range(DIRECTIONS):
                off = (turn + 1) // 2 * (1 if turn % 2 else -1)
                corner = _touching(point, box, gap + reach, prefer + off * 2 * math.pi / DIRECTIONS)
                cost = self._ink.under(_padded(box, corner)) + 0.12 * abs(off) + 0.8 * reach
                if cost < cheapest:
                    best, cheapest = corner, cost
        text = Text(best, content, size, "start", self._slanted)
        self._ink.draw([text])
        return text


def _touching(point: complex, box: Box, gap: float, angle: float) -> complex:
    """Shift a box so that it touches from outside the circle of radius `gap` about a point, in some direction."""
    left, bottom, right, top = box
    half = complex(right - left, top - bottom) / 2
    direction = cmath.rect(1.0, angle)
    reach = gap + abs(half.real * direction.real) + abs(half.imag * direction.imag)
    return point + direction * reach - half - complex(left, bottom)


def _padded(box: Box, shift: complex, by: float = 0.4) -> Box:
    x, y = shift.real, shift.imag
    return box[0] + x - by, box[1] + y - by, box[2] + x + by, box[3] + y + by
