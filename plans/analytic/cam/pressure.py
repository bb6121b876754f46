"""Pressure angles of a cam over the stretches of its law, by extremes of functions (углы давления)."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.analytic.cam.laws import LAWS, breaks, travel
from plans.model.cam import Cam, Law, Phase
from plans.model.cam_motion import CamSizes, Extreme, FollowerTravel
from plans.model.motion import Floats

GRID = 65  # places of a stretch that are looked at before a root is closed in on
GOLDEN, SECTIONS = (5**0.5 - 1) / 2, 78  # of two parts, to the last digit
HALVINGS = 60  # of a part of it: to the last digit


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


class PressurePeak(NamedTuple):
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


def peak(along: Collection[LawPart], value: Value, slope: Value) -> PressurePeak:
    """Give where a value is greatest: at a root of its slope, or at an end of a stretch."""
    return max((peak for stretch in along for peak in _candidates(stretch, value, slope)), key=lambda peak: peak.value)


def _candidates(stretch: LawPart, value: Value, slope: Value) -> Iterator[PressurePeak]:
    shares = np.array([stretch.start, *roots(lambda k: slope(stretch.at(k)), stretch.grid), stretch.end])
    for share, height in zip(
        shares.tolist(), np.broadcast_to(value(stretch.at(shares)), shares.shape).tolist(), strict=True
    ):
        yield PressurePeak(height, stretch, share)


def golden(along: Collection[LawPart], value: Value) -> PressurePeak:
    """Give where a value without a slope is greatest, by the golden section of the parts beside the best places.

    The place of a smooth peak is known to half of the digits, its value to all of them; that of a kink to all.
    """
    return max((_sectioned(stretch, value) for stretch in along), key=lambda peak: peak.value)


def _sectioned(stretch: LawPart, value: Value) -> PressurePeak:
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
    return PressurePeak(float(values[top]), stretch, float(places[top]))


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


class TangentRatio(NamedTuple):
    """tan α as a ratio, (N,) each, with the derivatives of both by the cam's turn; below, it is above 0."""

    above: Floats
    below: Floats
    above_slope: Floats
    below_slope: Floats


def pressure(cam: Cam, sizes: CamSizes, turned: Floats, before: bool = False) -> Floats:
    """Give the pressure angle at turns of the cam, (N,) rad, above 0 where it is so on a plain rise."""
    ratio = ratio_of(cam, sizes, travel(cam, turned, before))
    return np.arctan2(ratio.above, ratio.below)


def greatest(cam: Cam, sizes: CamSizes) -> dict[str, Extreme]:
    """Give the pressure angle that is largest by its size on each kind of phase, signed, rad."""
    return {kind: _greatest(cam, sizes, kind) for kind in dict.fromkeys(phase.kind for phase in cam.phases)}


def _greatest(cam: Cam, sizes: CamSizes, kind: str) -> Extreme:
    found = [extreme(cam, sizes, kind, sign) for sign in (1, -1)]
    return max(found, key=lambda extreme: abs(extreme.value))


def extreme(cam: Cam, sizes: CamSizes, kind: str, sign: int) -> Extreme:
    """Give the greatest (sign +1) or the least (-1) pressure angle on a kind of phase, rad."""

    def angle(at: FollowerTravel) -> Floats:
        ratio = ratio_of(cam, sizes, at)
        return np.asarray(sign * np.arctan2(ratio.above, ratio.below))

    def slope(at: FollowerTravel) -> Floats:
        ratio = ratio_of(cam, sizes, at)
        return np.asarray(ratio.above_slope * ratio.below - ratio.above * ratio.below_slope)

    found = peak(stretches(cam, (kind,)), angle, slope)
    return Extreme(sign * found.value, found.stretch.turned(found.share))


def ratio_of(cam: Cam, sizes: CamSizes, at: FollowerTravel) -> TangentRatio:
    """Give tan α by the kind of cam and follower."""
    if cam.flat:
        return _face(cam, sizes, at) if cam.rocks and not cam.translates else _square(at)
    if cam.translates:
        return _rail_rocker(cam, at) if cam.rocks else _ratio(at.slope, 1.0, at.bend, 0.0)
    return _rocker(cam, sizes, at) if cam.rocks else _guided(sizes, at)


def _ratio(above: Floats, below: Floats | float, above_slope: Floats, below_slope: Floats | float) -> TangentRatio:
    ones = np.ones_like(above)
    return TangentRatio(above, below * ones, above_slope, below_slope * ones)


def _square(at: FollowerTravel) -> TangentRatio:
    """Give that of a face square to its way: none."""
    zero = np.zeros_like(at.s)
    return _ratio(zero, 1.0, zero, 0.0)


def _guided(sizes: CamSizes, at: FollowerTravel) -> TangentRatio:
    """Give (S' - e)/(S + S0) (5.28)."""
    level = math.sqrt(sizes.base**2 - sizes.offset**2)
    return _ratio(at.slope - sizes.offset, at.s + level, at.bend, at.slope)


def _rocker(cam: Cam, sizes: CamSizes, at: FollowerTravel) -> TangentRatio:
    """Give (L cos ψ - l(1 - ψ'))/(L sin ψ) with ψ from the line of centres; against the cam -, and 1 + ψ'."""
    f, length, apart = cam.follower.sense, cam.follower.length or 0.0, sizes.centre
    psi = sizes.initial + at.s
    across, along = apart * np.sin(psi), apart * np.cos(psi)
    above = f * (along - length * (1 - f * at.slope))
    return _ratio(above, across, -f * across * at.slope + length * at.bend, along * at.slope)


def _rail_rocker(cam: Cam, at: FollowerTravel) -> TangentRatio:
    """Give that of a rocker on a cam that translates: (lψ' - sin x)/cos x, x from mid-swing."""
    f, length, x = cam.follower.sense, cam.follower.length or 0.0, at.s - cam.lift / 2
    above = length * at.slope - f * np.sin(x)
    return _ratio(above, np.cos(x), length * at.bend - f * np.cos(x) * at.slope, -np.sin(x) * at.slope)


def _face(cam: Cam, sizes: CamSizes, at: FollowerTravel) -> TangentRatio:
    """Give that of a rocker's face: -h/t, with t = L cos ψ/(1 - ψ') from the pivot to the contact along the face."""
    f, face, psi = cam.follower.sense, cam.follower.face, sizes.initial + at.s
    along, across = sizes.centre * np.cos(psi), sizes.centre * np.sin(psi)
    return _ratio(-f * face * (1 - f * at.slope), along, face * at.bend, -across * at.slope)
