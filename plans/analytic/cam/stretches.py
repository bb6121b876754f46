"""The stretches of a cam's law, and extremes of functions along them (участки закона)."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.analytic.cam.laws import LAWS, breaks
from plans.model.cam import Cam, Law, Phase, limits_of
from plans.model.cam_motion import CamError, FollowerTravel
from plans.model.motion import Floats

GRID = 65  # places of a stretch that are looked at before a root is closed in on
GOLDEN, SECTIONS = (5**0.5 - 1) / 2, 78  # of two parts, to the last digit
HALVINGS = 60  # of a part of it: to the last digit
SETTLED = 1e-13  # of a share: the next step of a false position would be a rounding


class LawPart(NamedTuple):
    """A stretch of a phase on which its law is smooth, from one share of the phase to another."""

    phase: Phase
    start: float
    end: float

    def at(self, share: Floats) -> FollowerTravel:
        """Give S, S', S'' at shares of the phase; at the end of the stretch those before the break."""
        k, phase = np.clip(share, self.start, self.end), self.phase
        if phase.law is None:
            return FollowerTravel(np.full_like(k, phase.level), np.zeros_like(k), np.zeros_like(k))
        s, *rates = self._closed(phase.law, k)
        ways = (rate * (phase.change / phase.angle**order) for order, rate in enumerate(rates, 1))
        return FollowerTravel(phase.level + s * phase.change, *ways)

    def _closed(self, law: Law, k: Floats) -> Sequence[Floats]:
        """Give the law and its derivatives in shares of phase and lift."""
        found, last = LAWS[law.name](law, k, False), k >= self.end
        if not last.any():
            return found
        return [np.where(last, *pair) for pair in zip(LAWS[law.name](law, k, True), found, strict=True)]

    def turned(self, share: float) -> float:
        """Give the cam's turn at a share of the phase."""
        return self.phase.start + self.phase.angle * share

    @property
    def grid(self) -> Floats:
        """Places from end to end."""
        return np.linspace(self.start, self.end, GRID)


Value: TypeAlias = Callable[[FollowerTravel], Floats]


class LawPeak(NamedTuple):
    """A place where something is greatest."""

    value: float
    stretch: LawPart
    share: float


def stretches(cam: Cam, kinds: Collection[str]) -> tuple[LawPart, ...]:
    """Give the stretches of all phases of some kinds."""
    return tuple(
        LawPart(phase, *ends)
        for phase in cam.phases
        if phase.kind in kinds
        for ends in pairwise((0.0, *(breaks(phase.law) if phase.law else ()), 1.0))
    )


def peak(along: Collection[LawPart], value: Value, slope: Value) -> LawPeak:
    """Give where a value is greatest: at a root of its slope, or at an end of a stretch."""
    return max((peak for stretch in along for peak in _candidates(stretch, value, slope)), key=lambda peak: peak.value)


def _candidates(stretch: LawPart, value: Value, slope: Value) -> Iterator[LawPeak]:
    shares = np.array([stretch.start, *roots(lambda k: slope(stretch.at(k)), stretch.grid), stretch.end])
    for share, height in zip(
        shares.tolist(), np.broadcast_to(value(stretch.at(shares)), shares.shape).tolist(), strict=True
    ):
        yield LawPeak(height, stretch, share)


def golden(along: Collection[LawPart], value: Value) -> LawPeak:
    """Give where a value without a slope is greatest, by the golden section of the parts beside the best places.

    The place of a smooth peak is known to half of the digits, its value to all of them; that of a kink to all.
    """
    return max((_sectioned(stretch, value) for stretch in along), key=lambda peak: peak.value)


def _sectioned(stretch: LawPart, value: Value) -> LawPeak:
    grid = stretch.grid
    best = int(np.argmax(value(stretch.at(grid))))
    low, high = float(grid[max(best - 1, 0)]), float(grid[min(best + 1, GRID - 1)])
    for _ in range(SECTIONS):
        ends = np.array([high - GOLDEN * (high - low), low + GOLDEN * (high - low)])
        first, second = value(stretch.at(ends)).tolist()
        low, high = (low, float(ends[1])) if first >= second else (float(ends[0]), high)
    places = np.array([low, (low + high) / 2, high, stretch.start, stretch.end])
    values = value(stretch.at(places))
    top = int(np.argmax(values))
    return LawPeak(float(values[top]), stretch, float(places[top]))


def roots(of: Callable[[Floats], Floats], grid: Floats) -> Floats:
    """Halve every part of a grid at whose ends a function has different signs.

    >>> roots(lambda x: x**2 - 2, np.linspace(-2.0, 2.0, 8)).round(12).tolist()
    [-1.414213562373, 1.414213562373]
    """
    signs = np.sign(of(grid))
    turns = np.flatnonzero(signs[:-1] * signs[1:] < 0)
    low, high, sign = grid[turns], grid[turns + 1], signs[turns]
    for _ in range(HALVINGS if turns.size else 0):
        middle = (low + high) / 2
        below = np.sign(of(middle)) == sign
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return np.concatenate([(low + high) / 2, grid[signs == 0]])


def eased(cam: Cam, least: Callable[[Cam], complex]) -> complex:
    """Give O from the start, R0 off it as given, where all pressure angles keep to the least share of their limits.

    That O makes the least R0 for this share; R0 over it is 0 for none, and rises with the share: the Illinois rule.
    """
    base, limits = cam.given.base or 0.0, limits_of(cam)

    def off(share: float) -> complex:
        try:
            return least(replace(cam, limits=limits.shared(share)))
        except CamError:  # no place at all: the cam were infinitely large
            return complex(math.inf)

    full = least(cam)
    (low, below), (high, above), found = (0.0, -1.0), (1.0, base / abs(full) - 1), full
    for _ in range(HALVINGS if above > 0 else 0):
        share = high - above * (high - low) / (above - below)
        found, last = off(share), above
        low, below = (high, last) if (above := base / abs(found) - 1) * last < 0 else (low, below / 2)
        if abs(share - high) <= SETTLED * share:
            break
        high = share
    found = found if abs(found) < math.inf else full
    return found * base / abs(found)
