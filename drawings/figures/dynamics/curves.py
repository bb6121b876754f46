"""Smooth curves through the points of a turn: each strip by a parabola or a cubic of its own (плавные кривые)."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from plans.model.dynamics import Cycle
from plans.model.motion import Floats

STEPS = 360  # of a turn at least: a degree, of which no curve on paper shows the corners


class Dense(NamedTuple):
    """A turn followed densely: angles rad from 0 on, moment N*m, work J, varying inertia kg*m2; jumps are upright."""

    turned: Floats
    moment: Floats
    work: Floats
    varying: Floats


def dense(cycle: Cycle) -> Dense:
    """Join the points of a cycle smoothly, each strip on its own: loads may jump or bend at its edges."""
    shares = np.linspace(0.0, 1.0, 1 + math.ceil(STEPS / len(cycle.means)))
    slopes = _slopes(cycle.turned, cycle.varying)
    ends = np.column_stack([slopes[:-1], slopes[1:]])
    turned = cycle.turned[:-1, None] + shares * np.diff(cycle.turned)[:, None]
    rows = (
        turned,
        _parabolas(cycle.moments, cycle.means, shares),
        _cubics(cycle.turned, cycle.work, cycle.moments, shares),
        _cubics(cycle.turned, cycle.varying, ends, shares),
    )
    return Dense(*(row.ravel() for row in rows))


def _parabolas(ends: Floats, means: Floats, shares: Floats) -> Floats:
    """Follow each strip through its ordinates at both ends and in the middle, (n, shares)."""
    first, last, s = ends[:, :1], ends[:, 1:], shares
    bend = 4 * (means[:, None] - (first + last) / 2)
    return np.asarray(first + (last - first) * s + bend * s * (1 - s))


def _cubics(x: Floats, y: Floats, slopes: Floats, shares: Floats) -> Floats:
    """Follow each strip through its ends with the slopes (n, 2) that it has there, (n, shares)."""
    wide, s = np.diff(x)[:, None], shares
    first, rise = y[:-1, None], np.diff(y)[:, None]
    left, right = slopes[:, :1] * wide - rise, rise - slopes[:, 1:] * wide
    return np.asarray(first + rise * s + s * (1 - s) * (left * (1 - s) + right * s))


def _slopes(x: Floats, y: Floats) -> Floats:
    """Give the slopes of a smooth periodic curve at its points, each from the two strips beside it."""
    wide, rise = np.diff(x), np.diff(y)
    chords = rise / wide
    before, after = np.roll(wide, 1), wide
    own = (np.roll(chords, 1) * after + chords * before) / (before + after)
    return np.append(own, own[0])
