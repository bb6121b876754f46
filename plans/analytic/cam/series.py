"""Smooth pieces of a cam's turn, and Chebyshev series on them that give all roots and extremes (ряды Чебышёва).

Between two seams of the laws all that is told of a profile is analytic: a series of it falls to rounding with few
terms, its derivative is that of the series, and its roots are bracketed by a dense look at it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Final, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from plans.analytic.cam.contour import Curve
from plans.model.cam import SHAPE, TABLE, Cam, Law
from plans.model.cam_motion import Extreme, Sizes
from plans.model.motion import Floats

TERMS: Final = (48, 96, 192, 384)  # of a series, twice as many until the last eighth is rounding
SMALL: Final = 1e-13  # of the largest term: what rounding leaves of the last ones
HALVINGS: Final = 60  # of a bracket: more than a double has digits
EIGHTHS: Final = {"trapezoid": (1, 3, 4, 5, 7), "modified trapezoid": (1, 3, 4, 5, 7), "modified sine": (1, 4, 7)}
Value = Callable[[Curve], Floats]


def seams(law: Law | None) -> tuple[float, ...]:
    """Give the shares of a phase where the closed form of its law changes.

    >>> seams(Law("modified sine"))
    (0.125, 0.5, 0.875)
    """
    if law is None:
        return ()
    if law.name == "constant acceleration":
        return (law.first,)
    if law.name in (TABLE, SHAPE):
        return tuple(sorted({share for share, _ in law.points if 0 < share < 1}))
    return tuple(one / 8 for one in EIGHTHS.get(law.name, ()))


class Place(NamedTuple):
    """A turn of the cam, rad, and the side on which a value is taken there."""

    turned: float
    before: bool = False


class Series(NamedTuple):
    """A value on one piece of the turn, from `start` to `end` rad, by Chebyshev's polynomials."""

    start: float
    end: float
    terms: Floats
    nothing: float  # what is rounding of it

    def slope(self) -> Series:
        """Give its derivative, in some scale; a rounding of a term grows as many times as there are terms."""
        return self._replace(
            terms=np.asarray(chebyshev.chebder(self.terms), dtype=float), nothing=self.nothing * len(self.terms)
        )

    def roots(self) -> list[float]:
        """Give where it changes its sign within the piece, rad."""
        looks, waves = _looks(len(self.terms))
        found = waves @ self.terms
        at = np.flatnonzero(found[:-1] * found[1:] < 0)
        at = at[np.maximum(np.abs(found[at]), np.abs(found[at + 1])) > self.nothing]
        if not len(at):
            return []
        share = self._halved(looks[at], looks[at + 1], found[at])
        return [float(one) for one in self.start + (self.end - self.start) * share]

    def _halved(self, low: Floats, high: Floats, first: Floats) -> Floats:
        """Close in on roots, by how far along the half circle of the nodes they are; give the share of the piece."""
        orders = np.arange(len(self.terms))
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            same = (np.cos(np.outer(middle, orders)) @ self.terms) * first > 0
            low, high = np.where(same, middle, low), np.where(same, high, middle)
        return np.asarray((np.cos((low + high) / 2) + 1) / 2)


@lru_cache(maxsize=16)
def _looks(terms: int) -> tuple[Floats, Floats]:
    """Give places along the half circle of the nodes, from the start of a piece, and the polynomials there."""
    looks = np.linspace(np.pi, 0, 4 * terms + 1)
    return looks, np.cos(np.outer(looks, np.arange(terms)))


@dataclass(frozen=True)
class Turn:
    """A whole turn of a cam by its smooth pieces."""

    cam: Cam
    sizes: Sizes
    kinds: tuple[str, ...] = ()  # of the phases that are looked at; none: all

    @cached_property
    def pieces(self) -> Floats:
        """The starts and ends of the pieces, rad, (2, pieces)."""
        rows = [
            (one.start + one.angle * low, one.start + one.angle * high if high < 1 else one.end)
            for one in self.cam.phases
            if (not self.kinds or one.kind in self.kinds) and one.angle > 0
            for low, high in zip((0.0, *seams(one.law)), (*seams(one.law), 1.0), strict=True)
        ]
        return np.array(rows).T

    def at(self, turned: Floats, before: bool = False) -> Curve:
        """Give the profile at turns of the cam."""
        return Curve(self.cam, self.sizes, turned, before)

    def series(self, value: Value) -> tuple[Series, ...]:
        """Give a value as a series on every piece."""
        found: dict[int, Series] = {}
        left = np.arange(self.pieces.shape[1])
        for count in TERMS:
            rows = self._terms(value, left, count)
            done = np.abs(rows[:, -count // 8 :]).max(axis=1) <= SMALL * np.abs(rows).max(axis=1)
            done |= count == TERMS[-1]
            found |= {int(k): self._of(k, row) for k, row in zip(left[done], rows[done], strict=True)}
            left = left[~done]
            if not len(left):
                break
        return tuple(found[k] for k in sorted(found))

    def _of(self, own: int, row: Floats) -> Series:
        start, end = self.pieces[:, own].tolist()
        return Series(start, end, row, SMALL * float(np.abs(row).sum()))

    def _terms(self, value: Value, own: np.ndarray, count: int) -> Floats:
        """Give the terms of the series on some pieces, from its values at Chebyshev's nodes."""
        angles = np.pi * (np.arange(count) + 0.5) / count
        start, end = self.pieces[:, own]
        turned = start[:, None] + (end - start)[:, None] * (np.cos(angles) + 1) / 2
        values = value(self.at(turned.ravel())).reshape(turned.shape)
        waves = np.cos(np.outer(angles, np.arange(count))) * 2 / count
        waves[:, 0] /= 2
        return np.asarray(np.nan_to_num(values) @ waves)

    def roots(self, value: Value) -> list[float]:
        """Give all turns at which a value changes its sign within a piece, rising."""
        return sorted(root for one in self.series(value) for root in one.roots())

    def places(self, value: Value) -> tuple[Place, ...]:
        """Give where a value can be greatest or least: ends of pieces, and roots of its derivative."""
        starts = [Place(turned) for turned in self.pieces[0].tolist()]
        ends = [Place(turned, before=True) for turned in self.pieces[1].tolist()]
        inner = [Place(root) for one in self.series(value) for root in one.slope().roots()]
        return (*starts, *inner, *ends)

    def read(self, value: Value, places: Sequence[Place]) -> Floats:
        """Give a value at places."""
        turned, before = np.array([one.turned for one in places]), np.array([one.before for one in places], dtype=bool)
        found = value(self.at(turned))
        found[before] = value(self.at(turned[before], before=True))
        return found

    def most(self, value: Value, places: Sequence[Place] | None = None) -> Extreme | None:
        """Give the greatest of a value, and where it is."""
        places = self.places(value) if places is None else places
        found = self.read(value, places) if places else np.full(1, np.nan)
        if np.isnan(found).all():
            return None
        best = int(np.nanargmax(found))
        return Extreme(float(found[best]), places[best].turned)
