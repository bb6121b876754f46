"""A smooth curve through points: in each part a cubic whose slopes are those of parabolas (плавная кривая)."""

from __future__ import annotations

import numpy as np

from plans.model.motion import Floats


def smooth(x: Floats, y: Floats, at: Floats) -> Floats:
    """Follow a smooth curve through points with rising abscissas, (N,), N at least 2; give its ordinates at places.

    At a point the slope is that of the parabola through it and both its neighbours, at an end through the three there.

    >>> smooth(np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 9.0]), np.array([0.5, 2.0])).tolist()
    [0.25, 4.0]
    """
    wide, steep = np.diff(x), np.diff(y) / np.diff(x)
    slopes = _slopes(wide, steep)
    k = np.clip(np.searchsorted(x, at, "right") - 1, 0, len(wide) - 1)
    s = (at - x[k]) / wide[k]
    left, right = wide[k] * (slopes[k] - steep[k]), wide[k] * (steep[k] - slopes[k + 1])
    return np.asarray(y[k] + wide[k] * steep[k] * s + s * (1 - s) * (left * (1 - s) + right * s))


def _slopes(wide: Floats, steep: Floats) -> Floats:
    """Give the slopes at the points, (N,), from the widths and the slopes of the parts."""
    if len(wide) == 1:
        return np.repeat(steep, 2)
    inner = (wide[1:] * steep[:-1] + wide[:-1] * steep[1:]) / (wide[1:] + wide[:-1])
    ends = (2 * steep[0] - inner[0], 2 * steep[-1] - inner[-1])
    return np.concatenate([ends[:1], inner, ends[1:]])
