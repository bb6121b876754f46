"""A force as figures show it, before it is put on paper: in a polygon, on a scheme, on the lever (сила на фигуре)."""

from __future__ import annotations

from typing import NamedTuple

from plans.forces.cut import CLOSING, KNOWN, PART

__all__ = ["BALANCE", "CLOSING", "KNOWN", "LOAD", "PAIR", "PART", "PRESSING", "UNKNOWN", "WHOLE", "ShownForce"]

# Of a polygon, beside the kinds of its sides: both parts of a reaction, or a group's inner reaction, as a diagonal.
WHOLE = "whole"
# Of a scheme: a load is KNOWN; a reaction is not, nor is that of a guide, which presses on its slider.
UNKNOWN, PRESSING = "unknown", "pressing"
# Of a lever: a load, half of a couple, what the drive gives.
LOAD, PAIR, BALANCE = "load", "pair", "balance"


class ShownForce(NamedTuple):
    """A force N at a place in the figure's own true units: m of a scheme, N of a polygon, m/s of a lever."""

    name: str
    kind: str
    at: complex
    value: complex
    spot: str = ""  # the letter of the point there, if it is one

    @property
    def end(self) -> complex:
        """The place of its end in a polygon, N."""
        return self.at + self.value

    @property
    def direction(self) -> complex:
        """Its unit direction; a force that is zero has none."""
        return self.value / abs(self.value)

    @property
    def moment(self) -> float:
        """Its moment about the figure's zero: N*m, or W on a lever."""
        return (self.at.conjugate() * self.value).imag
