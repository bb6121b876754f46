"""The account of a turn on given strips: exact, and as the middles of the strips give it (работы за цикл)."""

from __future__ import annotations

import numpy as np

from plans.analytic.dynamics.flywheel import Exact
from plans.analytic.extremes import EQUAL
from plans.model.dynamics import ANALYSIS, Cycle
from plans.model.motion import Floats


def exact_cycle(found: Exact, turned: Floats) -> Cycle:
    """Account for a turn on strips with edges `turned`, (n + 1,) rad, without any error but rounding."""
    return _cycle(found, turned, found.work(turned))


def sampled_cycle(found: Exact, turned: Floats) -> Cycle:
    """Account for it as the construction must: the work of a strip is its width by the ordinate at its middle."""
    strips = np.diff(turned) * found.moment(_middles(turned))
    return _cycle(found, turned, np.concatenate(([0.0], np.cumsum(strips))))


def _cycle(found: Exact, turned: Floats, work: Floats) -> Cycle:
    sides = _snapped(turned, found.breaks)
    moments = np.stack((found.moment(sides[:-1], 1), found.moment(sides[1:], -1)), axis=1)
    means = found.moment(_middles(turned))
    return Cycle(ANALYSIS, turned, found.breaks, moments, means, work, found.inertia(turned))


def _middles(turned: Floats) -> Floats:
    return np.asarray((turned[:-1] + turned[1:]) / 2.0)


def _snapped(turned: Floats, breaks: Floats) -> Floats:
    """Move edges that are meant for a break to the very break, so that each side of it is that of its strip."""
    snapped = np.array(turned)
    for at in breaks:
        snapped[np.abs(turned - at) <= EQUAL] = at
    return snapped
