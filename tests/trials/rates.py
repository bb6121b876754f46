"""A number with its first two derivatives by time, as coefficients of a power series (величина с производными)."""

from __future__ import annotations

from typing import Any, NamedTuple


class Series(NamedTuple):
    """z + z' t + z''/2 t^2, of numbers of any kind: of 60 digits, of 16, or arrays of these."""

    z: Any
    first: Any = 0
    half: Any = 0  # of the second derivative

    def plus(self, other: Series) -> Series:
        """Add another."""
        return Series(*(a + b for a, b in zip(self, other, strict=True)))

    def less(self, other: Series) -> Series:
        """Take away another."""
        return Series(*(a - b for a, b in zip(self, other, strict=True)))

    def by(self, number: Any) -> Series:
        """Multiply by a number at rest."""
        return Series(*(a * number for a in self))

    def times(self, other: Series) -> Series:
        """Multiply with another."""
        (a, a1, a2), (b, b1, b2) = self, other
        return Series(a * b, a * b1 + a1 * b, a * b2 + a1 * b1 + a2 * b)

    @property
    def conjugate(self) -> Series:
        """Mirror it in the real axis."""
        return Series(*((a + 0j).conjugate() for a in self))


AT_REST = Series(1 + 0j)
