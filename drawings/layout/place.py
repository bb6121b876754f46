"""The place of a figure on paper: where its true values lie, at which scale (место фигуры)."""

from __future__ import annotations

from typing import NamedTuple

from drawings.page.scale import Scale


class Place(NamedTuple):
    """Where a plan's true values lie on paper: `zero` in true units lies at `origin`, mm."""

    origin: complex
    zero: complex
    scale: Scale

    def on(self, value: complex) -> complex:
        """Give the place on paper of a true value."""
        return self.origin + (value - self.zero) / self.scale.mu

    def length(self, size: float) -> float:
        """Give a true length in mm."""
        return size / self.scale.mu
