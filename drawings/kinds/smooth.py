"""Smooth curves through points: cubics between two points by the slopes there (плавные кривые)."""

from __future__ import annotations

import numpy as np

from plans.model.motion import Floats


def cubic(s: Floats, first: Floats, rise: Floats, start: Floats, end: Floats) -> Floats:
    """Follow a piece at shares of its length: from a value by a rise, with what its slopes at both ends make of it."""
    return np.asarray(first + rise * s + s * (1 - s) * ((start - rise) * (1 - s) + (rise - end) * s))


def cubics(x: Floats, ends: tuple[Floats, Floats], slopes: tuple[Floats, Floats]) -> Floats:
    """Follow strips, each at places of its own (n, m), through its ends with the slopes (n,) that it has there."""
    wide = (x[:, -1] - x[:, 0])[:, None]
    rise = (ends[1] - ends[0])[:, None]
    return cubic((x - x[:, :1]) / wide, ends[0][:, None], rise, slopes[0][:, None] * wide, slopes[1][:, None] * wide)


def smooth(x: Floats, y: Floats, at: Floats) -> Floats:
    """Follow a smooth curve through points with rising abscissas, (N,), N at least 2; give its ordinates at places.

    At a point the slope is that of the parabola through it and both its neighbours, at an end through the three there.

    >>> smooth(np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 9.0]), np.array([0.5, 2.0])).tolist()
    [0.25, 4.0]
    """
    wide, rise = np.diff(x), np.diff(y)
    slopes = _slopes(wide, rise / wide)
    k = np.clip(np.searchsorted(x, at, "right") - 1, 0, len(wide) - 1)
    return cubic((at - x[k]) / wide[k], y[k], rise[k], wide[k] * slopes[k], wide[k] * slopes[k + 1])


def _slopes(wide: Floats, steep: Floats) -> Floats:
    """Give the slopes at the points, (N,), from the widths and the slopes of the parts."""
    if len(wide) == 1:
        return np.repeat(steep, 2)
    inner = inner_slopes(wide, steep)
    return np.concatenate([2 * steep[:1] - inner[:1], inner, 2 * steep[-1:] - inner[-1:]])


def inner_slopes(wide: Floats, steep: Floats) -> Floats:
    """Give the slopes at the points between parts, each from the two parts beside it."""
    return np.asarray((wide[1:] * steep[:-1] + wide[:-1] * steep[1:]) / (wide[1:] + wide[:-1]))
