"""The pressure angle by its closed forms, and its greatest values by roots (угол давления, (5.28))."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from plans.analytic.cam.laws import travel
from plans.analytic.cam.stretches import peak, stretches
from plans.model.cam import Cam
from plans.model.cam_motion import Extreme, Sizes, Travel
from plans.model.motion import Floats


class Ratio(NamedTuple):
    """tan α as a ratio, (N,) each, with the derivatives of both by the cam's turn; below, it is above 0."""

    above: Floats
    below: Floats
    above_slope: Floats
    below_slope: Floats


def pressure(cam: Cam, sizes: Sizes, turned: Floats, before: bool = False) -> Floats:
    """Give the pressure angle at turns of the cam, (N,) rad, above 0 where it is so on a plain rise."""
    ratio = ratio_of(cam, sizes, travel(cam, turned, before))
    return np.arctan2(ratio.above, ratio.below)


def greatest(cam: Cam, sizes: Sizes) -> dict[str, Extreme]:
    """Give the pressure angle that is largest by its size on each kind of phase, signed, rad."""
    return {kind: _greatest(cam, sizes, kind) for kind in dict.fromkeys(one.kind for one in cam.phases)}


def _greatest(cam: Cam, sizes: Sizes, kind: str) -> Extreme:
    found = [extreme(cam, sizes, kind, sign) for sign in (1, -1)]
    return max(found, key=lambda one: abs(one.value))


def extreme(cam: Cam, sizes: Sizes, kind: str, sign: int) -> Extreme:
    """Give the greatest (sign +1) or the least (-1) pressure angle on a kind of phase, rad."""

    def angle(at: Travel) -> Floats:
        ratio = ratio_of(cam, sizes, at)
        return np.asarray(sign * np.arctan2(ratio.above, ratio.below))

    def slope(at: Travel) -> Floats:
        ratio = ratio_of(cam, sizes, at)
        return np.asarray(ratio.above_slope * ratio.below - ratio.above * ratio.below_slope)

    found = peak(stretches(cam, (kind,)), angle, slope)
    return Extreme(sign * found.value, found.stretch.turned(found.share))


def ratio_of(cam: Cam, sizes: Sizes, at: Travel) -> Ratio:
    """Give tan α by the kind of cam and follower."""
    if cam.flat:
        return _face(cam, sizes, at) if cam.rocks and not cam.translates else _square(at)
    if cam.translates:
        return _rail_rocker(cam, at) if cam.rocks else _ratio(at.slope, 1.0, at.bend, 0.0)
    return _rocker(cam, sizes, at) if cam.rocks else _guided(sizes, at)


def _ratio(above: Floats, below: Floats | float, above_slope: Floats, below_slope: Floats | float) -> Ratio:
    ones = np.ones_like(above)
    return Ratio(above, below * ones, above_slope, below_slope * ones)


def _square(at: Travel) -> Ratio:
    """Give that of a face square to its way: none."""
    zero = np.zeros_like(at.s)
    return _ratio(zero, 1.0, zero, 0.0)


def _guided(sizes: Sizes, at: Travel) -> Ratio:
    """Give (S' - e)/(S + S0) (5.28)."""
    level = math.sqrt(sizes.base**2 - sizes.offset**2)
    return _ratio(at.slope - sizes.offset, at.s + level, at.bend, at.slope)


def _rocker(cam: Cam, sizes: Sizes, at: Travel) -> Ratio:
    """Give (L cos ψ - l(1 - ψ'))/(L sin ψ) with ψ from the line of centres; against the cam -, and 1 + ψ'."""
    f, length, apart = cam.follower.sense, cam.follower.length or 0.0, sizes.centre
    psi = sizes.initial + at.s
    across, along = apart * np.sin(psi), apart * np.cos(psi)
    above = f * (along - length * (1 - f * at.slope))
    return _ratio(above, across, -f * across * at.slope + length * at.bend, along * at.slope)


def _rail_rocker(cam: Cam, at: Travel) -> Ratio:
    """Give that of a rocker on a cam that translates: (lψ' - sin x)/cos x, x from mid-swing."""
    f, length, x = cam.follower.sense, cam.follower.length or 0.0, at.s - cam.lift / 2
    above = length * at.slope - f * np.sin(x)
    return _ratio(above, np.cos(x), length * at.bend - f * np.cos(x) * at.slope, -np.sin(x) * at.slope)


def _face(cam: Cam, sizes: Sizes, at: Travel) -> Ratio:
    """Give that of a rocker's face: -h/t, with t = L cos ψ/(1 - ψ') from the pivot to the contact along the face."""
    f, face, psi = cam.follower.sense, cam.follower.face, sizes.initial + at.s
    along, across = sizes.centre * np.cos(psi), sizes.centre * np.sin(psi)
    return _ratio(-f * face * (1 - f * at.slope), along, face * at.bend, -across * at.slope)
