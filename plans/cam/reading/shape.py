"""The shape of an acceleration by points, straight between them: its areas and its lift, exact (форма ускорения)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

Plotted = tuple[tuple[Fraction, Fraction], ...]
NEARLY = Fraction(1, 10**6)  # of either area: written shares are rounded, and areas so near each other are meant alike


class Shape(NamedTuple):
    """Shares of a phase from 0 to 1 with the acceleration in any scale; two points at one share are a jump."""

    points: Plotted

    @property
    def above(self) -> Fraction:
        """The area above 0.

        >>> str(Shape(((Fraction(0), Fraction(1)), (Fraction(1), Fraction(-1)))).above)
        '1/4'
        """
        return sum(self._areas(1), Fraction(0))

    @property
    def below(self) -> Fraction:
        """The area below 0, as a size."""
        return sum(self._areas(-1), Fraction(0))

    def _areas(self, sense: int) -> Iterator[Fraction]:
        for (x0, y0), (x1, y1) in pairwise(self.points):
            a, b = sense * y0, sense * y1
            if a > 0 and b > 0:
                yield (x1 - x0) * (a + b) / 2
            elif max(a, b) > 0:
                yield (x1 - x0) * max(a, b) ** 2 / abs(b - a) / 2

    @property
    def cancels(self) -> bool:
        """Whether the areas above and below are alike, but for the rounding of what is written."""
        return self.above > 0 and abs(self.above - self.below) <= NEARLY * self.above

    @property
    def factor(self) -> Fraction:
        """How many times as large the ordinates below 0 should be; 0 where nothing would do.

        The whole area is a sum over the ordinates, each with half of what lies to both sides of it.
        """
        parts = [(y, (after - before) / 2) for (_, y), (before, after) in zip(self.points, self._sides(), strict=True)]
        up = sum((y * width for y, width in parts if y > 0), Fraction(0))
        down = -sum((y * width for y, width in parts if y < 0), Fraction(0))
        return up / down if up and down else Fraction(0)

    def _sides(self) -> Iterator[tuple[Fraction, Fraction]]:
        """Give the shares before and after each point."""
        shares = [self.points[0][0], *(x for x, _ in self.points), self.points[-1][0]]
        return zip(shares, shares[2:], strict=False)

    @property
    def lift(self) -> Fraction:
        """What two integrations of it from rest give."""
        level = slope = Fraction(0)
        for (x0, y0), (x1, y1) in pairwise(self.points):
            level += slope * (x1 - x0) + (x1 - x0) ** 2 * (2 * y0 + y1) / 6
            slope += (x1 - x0) * (y0 + y1) / 2
        return level


def cancelled(shape: Shape) -> Shape:
    """Give a shape whose areas cancel exactly: what is below 0 takes what is over."""
    factor = shape.factor
    return Shape(tuple((x, y * factor if y < 0 else y) for x, y in shape.points))
