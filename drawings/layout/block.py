"""Lettering that stands among figures: equations, a table (надписи среди фигур)."""

from __future__ import annotations

from typing import NamedTuple


class TextBlock(NamedTuple):
    """Lettering that is kept together: the sizes that it may have, width and height in mm, the narrowest first."""

    name: str
    sizes: tuple[tuple[float, float], ...]

    def size(self, width: float) -> tuple[float, float]:
        """Give its size in a column of some width: the widest that fits, or else the narrowest.

        >>> TextBlock("equations", ((60.0, 30.0), (120.0, 10.0))).size(100.0)
        (60.0, 30.0)
        """
        return max((size for size in self.sizes if size[0] <= width), default=self.sizes[0])
