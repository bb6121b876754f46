"""Extremes of a cam's profile by roots of derivatives: pressure angle, curvature, face, forces (экстремумы)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import Final, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from plans.analytic.cam.contour import ContactForces, ContourValues
from plans.analytic.cam.laws import shocks
from plans.model.cam import RETURN, RISE, SHAPE, TABLE, Cam, Law, interval_of
from plans.model.cam_motion import BEND, HARD, SLOPE, SOFT, CamSizes, Extreme, Pressing
from plans.model.motion import Floats

TERMS: Final = (48, 96, 192, 384)  # of a series, twice as many until the last eighth is rounding
SMALL: Final = 1e-13  # of the largest term: what rounding leaves of the last ones
HALVINGS: Final = 60  # of a bracket: more than a double has digits
EIGHTHS: Final = {"trapezoid": (1, 3, 4, 5, 7), "modified trapezoid": (1, 3, 4, 5, 7), "modified sine": (1, 4, 7)}
Value = Callable[[ContourValues], Floats]


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
    return tuple(eighth / 8 for eighth in EIGHTHS.get(law.name, ()))


class SidedTurn(NamedTuple):
    """A turn of the cam, rad, and the side on which a value is taken there."""

    turned: float
    before: bool = False


class CosineSeries(NamedTuple):
    """A value on one piece of the turn, from `start` to `end` rad, by Chebyshev's polynomials."""

    start: float
    end: float
    terms: Floats
    nothing: float  # what is rounding of it

    def slope(self) -> CosineSeries:
        """Give its derivative, in some scale; a rounding of a term grows as many times as there are terms."""
        terms = np.asarray(chebyshev.chebder(self.terms), dtype=float)
        return self._replace(terms=terms, nothing=self.nothing * len(self.terms))

    def roots(self) -> list[float]:
        """Give where it changes its sign within the piece, rad."""
        looks, waves = _looks(len(self.terms))
        found = waves @ self.terms
        at = np.flatnonzero(found[:-1] * found[1:] < 0)
        at = at[np.maximum(np.abs(found[at]), np.abs(found[at + 1])) > self.nothing]
        if not len(at):
            return []
        share = self._halved(looks[at], looks[at + 1], found[at])
        return [float(turn) for turn in self.start + (self.end - self.start) * share]

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
class WholeTurn:
    """A whole turn of a cam by its smooth pieces."""

    cam: Cam
    sizes: CamSizes
    kinds: tuple[str, ...] = ()  # of the phases that are looked at; none: all

    @cached_property
    def pieces(self) -> Floats:
        """The starts and ends of the pieces, rad, (2, pieces)."""
        rows = [
            (phase.start + phase.angle * low, phase.start + phase.angle * high if high < 1 else phase.end)
            for phase in self.cam.phases
            if (not self.kinds or phase.kind in self.kinds) and phase.angle > 0
            for low, high in zip((0.0, *seams(phase.law)), (*seams(phase.law), 1.0), strict=True)
        ]
        return np.array(rows).T

    def at(self, turned: Floats, before: bool = False) -> ContourValues:
        """Give the profile at turns of the cam."""
        return ContourValues(self.cam, self.sizes, turned, before)

    def series(self, value: Value) -> tuple[CosineSeries, ...]:
        """Give a value as a series on every piece."""
        found: dict[int, CosineSeries] = {}
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

    def _of(self, piece: int, row: Floats) -> CosineSeries:
        start, end = self.pieces[:, piece].tolist()
        return CosineSeries(start, end, row, SMALL * float(np.abs(row).sum()))

    def _terms(self, value: Value, pieces: np.ndarray, count: int) -> Floats:
        """Give the terms of the series on some pieces, from its values at Chebyshev's nodes."""
        angles = np.pi * (np.arange(count) + 0.5) / count
        start, end = self.pieces[:, pieces]
        turned = start[:, None] + (end - start)[:, None] * (np.cos(angles) + 1) / 2
        values = value(self.at(turned.ravel())).reshape(turned.shape)
        waves = np.cos(np.outer(angles, np.arange(count))) * 2 / count
        waves[:, 0] /= 2
        return np.asarray(np.nan_to_num(values) @ waves)

    def roots(self, value: Value) -> list[float]:
        """Give all turns at which a value changes its sign within a piece, rising."""
        return sorted(root for series in self.series(value) for root in series.roots())

    def places(self, value: Value) -> tuple[SidedTurn, ...]:
        """Give where a value can be greatest or least: ends of pieces, and roots of its derivative."""
        starts = [SidedTurn(turned) for turned in self.pieces[0].tolist()]
        ends = [SidedTurn(turned, before=True) for turned in self.pieces[1].tolist()]
        inner = [SidedTurn(root) for series in self.series(value) for root in series.slope().roots()]
        return (*starts, *inner, *ends)

    def read(self, value: Value, places: Sequence[SidedTurn]) -> Floats:
        """Give a value at places."""
        turned = np.array([place.turned for place in places])
        before = np.array([place.before for place in places], dtype=bool)
        found = value(self.at(turned))
        found[before] = value(self.at(turned[before], before=True))
        return found

    def most(self, value: Value, places: Sequence[SidedTurn] | None = None) -> Extreme | None:
        """Give the greatest of a value, and where it is."""
        places = self.places(value) if places is None else places
        found = self.read(value, places) if places else np.full(1, np.nan)
        if np.isnan(found).all():
            return None
        best = int(np.nanargmax(found))
        return Extreme(float(found[best]), places[best].turned)


ALIKE = 1e-9  # of the largest: sizes that were found by a limit touch it twice, alike but for rounding


@dataclass(frozen=True)
class CurveExtremes:
    """The extremes of one profile."""

    cam: Cam
    sizes: CamSizes

    @cached_property
    def turn(self) -> WholeTurn:
        """The whole turn."""
        return WholeTurn(self.cam, self.sizes)

    @cached_property
    def outrun(self) -> Extreme | None:
        """The largest θ' of a rocker's face that is 1 or more: the cam no longer turns under it."""
        if not (self.cam.flat and self.cam.rocks):
            return None
        most = self.turn.most(lambda curve: curve.rates[0])
        return most if most and most.value >= 1 else None

    @cached_property
    def peaks(self) -> dict[str, Extreme]:
        """The largest S' and S'' by their size, signed; at a hard shock S'' has none."""
        found = {SLOPE: _largest(self.turn, lambda curve: curve.travel.slope)}
        if all(shock.order == SOFT for shock in shocks(self.cam)):
            found[BEND] = _largest(self.turn, lambda curve: curve.travel.bend)
        return found

    @cached_property
    def pressure(self) -> dict[str, Extreme]:
        """The largest pressure angle by its size on every kind of phase that there is, rad, signed."""
        kinds = () if self.outrun else dict.fromkeys(phase.kind for phase in self.cam.moving())
        return {on: _largest(WholeTurn(self.cam, self.sizes, (on,)), lambda curve: curve.pressure) for on in kinds}

    @cached_property
    def bends(self) -> tuple[SidedTurn, ...]:
        """Where the curve can be sharpest."""
        if self.cam.flat:
            return self.turn.places(lambda curve: curve.radius)
        return self.turn.places(lambda curve: curve.curvature)

    @cached_property
    def sharpest(self) -> Extreme | None:
        """The least convex radius; under a flat face the least, signed."""
        if self.outrun:
            return None
        if self.cam.flat:
            least = self.turn.most(lambda curve: -curve.radius, self.bends)
            return Extreme(-least.value, least.turned).cusp(self.sizes.base) if least else None
        most = self.turn.most(lambda curve: curve.curvature, self.bends)
        return Extreme(1 / most.value, most.turned) if most and most.value > 0 else None

    @cached_property
    def hollow(self) -> Extreme | None:
        """The smallest hollow radius, below 0."""
        most = None if self.cam.flat else self.turn.most(lambda curve: -curve.curvature, self.bends)
        return Extreme(-1 / most.value, most.turned) if most and most.value > 0 else None

    @cached_property
    def face(self) -> tuple[float, float]:
        """The least and the greatest place of contact on a flat face, m."""
        if not self.cam.flat or self.outrun:
            return 0.0, 0.0
        found = self.turn.read(lambda curve: curve.place, self.turn.places(lambda curve: curve.place))
        return float(found.min()), float(found.max())

    @property
    def mending(self) -> float | None:
        """R0, m, that mends: keeps the angle to its limits at the offset as it is; of a flat face the radius."""
        cam, offset = self.cam, self.sizes.offset
        if cam.flat:  # R0 = ρ_min - min(S + S''); none of a rocker, and where S' falls at once
            falls = cam.rocks or any(shock.order == HARD and shock.jump < 0 for shock in shocks(cam))
            most = None if falls else self.turn.most(lambda curve: -curve.travel.s - curve.travel.bend)
            return most and cam.limits.curvature + most.value
        intervals = {kind: interval for kind in (RISE, RETURN) if (interval := interval_of(cam, kind))}
        if cam.rocks or cam.translates or not intervals:
            return None
        heights = [
            WholeTurn(cam, self.sizes, (kind,)).most(partial(_height, offset, limit))
            for kind, interval in intervals.items()
            for limit in interval
        ]
        least = max(0.0, *(height.value for height in heights if height))
        return float((least * least + offset * offset) ** 0.5)

    def pressing(self, forces: ContactForces) -> Pressing:
        """Give the extremes of the contact's force and wear, and the preload that holds."""
        turn, nothing = self.turn, Extreme(np.nan, 0.0)
        places = turn.places(forces.normal)
        low, high = turn.most(lambda curve: -forces.normal(curve), places), turn.most(forces.normal, places)
        signed = turn.places(lambda curve: forces.normal(curve) * curve.slip(forces.roller))
        lack = turn.most(lambda curve: -forces.along(curve))
        return Pressing(
            least=Extreme(-low.value, low.turned) if low else nothing,
            most=high or nothing,
            wear=turn.most(forces.wear, signed) or nothing,
            preload=forces.load.preload + max(0.0, lack.value if lack else 0.0),
        )


def _largest(turn: WholeTurn, value: Value) -> Extreme:
    """Give the largest of a value by its size, signed: of two alike the one above 0, and the earlier."""
    places = turn.places(value)
    pairs = [*zip(turn.read(value, places).tolist(), (place.turned for place in places), strict=True)]
    most = max(abs(size) for size, _ in pairs)
    alike = [(size, turned) for size, turned in pairs if abs(size) >= most * (1 - ALIKE)]
    return Extreme(*min(alike, key=lambda pair: (pair[0] < 0, pair[1])))


def _height(offset: float, limit: float, curve: ContourValues) -> Floats:
    """Give S0 with which (5.28) is just the limit, signed."""
    return np.asarray((curve.travel.slope - offset) / np.tan(limit) - curve.travel.s)
