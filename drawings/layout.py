"""Layout of paper: what is already inked, and labels that find a free place near what they name."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from itertools import pairwise

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
        for start, end in pairwise(points):
            count = max(int(abs(end - start) / CELL), 1)
            along = start + (end - start) * np.linspace(0.0, 1.0, count + 1)
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
        best: tuple[float, Text] | None = None
        for reach in REACHES:
            for turn in range(DIRECTIONS):
                off = (turn + 1) // 2 * (1 if turn % 2 else -1)
                text = self._at(point, content, size, gap + reach, prefer + off * 2 * math.pi / DIRECTIONS)
                cost = self._ink.under(_padded(bounds(text))) + 0.12 * abs(off) + 0.8 * reach
                if best is None or cost < best[0]:
                    best = (cost, text)
        assert best is not None  # there is always a first candidate
        self._ink.draw([best[1]])
        return best[1]

    def _at(self, point: complex, content: str, size: float, gap: float, angle: float) -> Text:
        """Put the centre of a label so that its box touches the circle of radius `gap` about the point."""
        trial = Text(0j, content, size, "start", self._slanted)
        left, bottom, right, top = bounds(trial)
        half = complex(right - left, top - bottom) / 2
        direction = cmath.rect(1.0, angle)
        reach = gap + abs(half.real * direction.real) + abs(half.imag * direction.imag)
        corner = point + direction * reach - half
        return Text(corner - complex(left, bottom), content, size, "start", self._slanted)


def _padded(box: Box, by: float = 0.4) -> Box:
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by
