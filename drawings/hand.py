"""The hand that a sheet is drawn in: line widths, kinds of lines, letter sizes (линии, GOST 2.303-68)."""

from __future__ import annotations

from typing import NamedTuple

from drawings.strokes import LineStyle


class Hand(NamedTuple):
    """Widths of a sheet's lines and sizes of its letters, mm, and the factor of its symbols' sizes."""

    main: float  # s, the main line
    thin: float
    construction: float
    heading: float = 7.0  # the title of the largest figure
    title: float = 5.0  # titles of the other figures
    letter: float = 5.0  # letters of points
    number: float = 3.5  # numbers of positions
    text: float = 3.5  # tables, notes, scales
    symbol: float = 1.0  # of kinematic symbols and arrowheads

    @property
    def result(self) -> LineStyle:
        """Solid main line."""
        return LineStyle(self.main)

    @property
    def relative(self) -> LineStyle:
        """Solid line between main and thin: relative vectors."""
        return LineStyle((self.main + self.thin) / 2)

    @property
    def other(self) -> LineStyle:
        """Solid thin line: other positions, dimensions, leaders."""
        return LineStyle(self.thin)

    @property
    def drafted(self) -> LineStyle:
        """Construction line."""
        return LineStyle(self.construction)

    @property
    def axis(self) -> LineStyle:
        """Thin dash-dot line: axes of guides."""
        return LineStyle(self.construction, (15, 1.5, 0.5, 1.5))

    @property
    def path(self) -> LineStyle:
        """Dashed thin line: trajectories."""
        return LineStyle(self.thin, (4, 1.5))

    @property
    def extreme(self) -> LineStyle:
        """Thin dash-two-dots line: the other extreme position."""
        return LineStyle(self.thin, (15, 1.5, 0.5, 1.5, 0.5, 1.5))

    @property
    def body(self) -> LineStyle:
        """Main line of a symbol, filled with paper."""
        return LineStyle(self.main, fill="#ffffff")
