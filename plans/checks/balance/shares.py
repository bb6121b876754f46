"""The share of the reciprocating mass by both roads: the curve, and the best of it (сравнение выбора доли)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from plans.analytic.balance.balance import weighing
from plans.balance.study import COSTS
from plans.checks.balance.costs import Costs
from plans.checks.comparison import Finding
from plans.forces.cut import indices
from plans.model.balance.linkage import EPS, Choice, Shares
from plans.model.mechanism import FRAME
from plans.model.motion import Floats

HALVINGS = 60  # of an interval of shares, down to rounding


def share_findings(costs: Costs) -> Iterator[Finding]:
    """Compare the curves of the largest shaking force and the largest reaction of the shaft, and both best shares."""
    ours, theirs = costs.ours.shares, costs.theirs.shares
    if ours is None or theirs is None:
        return
    shaft = indices(FRAME, costs.course.mechanism.drive.link)
    allowed = [float(np.fmax.reduce(row)) for row in _allowed(costs, shaft)]
    weighed = weighing(costs.course, costs.weights.found)
    yield from _of(("force", "Φ"), weighed.force, allowed[0], ours, theirs)
    yield from _of(("reaction", f"R_{shaft}"), weighed.reaction, allowed[1], ours, theirs)


def _allowed(costs: Costs, shaft: str) -> list[Floats]:
    """Take for every share what is allowed before or after, whichever is more."""
    rows = [costs.allowed(after, shaft) for after in (False, True)]
    return [np.maximum(*both) for both in zip(*rows, strict=True)]


def _of(
    named: tuple[str, str], largest: Callable[[float], float], off: float, ours: Shares, theirs: Shares
) -> Iterator[Finding]:
    name, letters = named
    curve = (ours.curve, theirs.curve)
    yield _finding(f"{letters}(k)", "N", [[getattr(one, name) for one in row] for row in curve], off)
    best: Sequence[Choice] = [getattr(road, f"least_{name}") for road in (ours, theirs)]
    yield _finding(f"min {letters}(k)", "N", [[getattr(one, name)] for one in best], off)
    width = _width(largest, best[1].share, 2 * off)
    yield _finding(f"k {letters}", "1", [[one.share] for one in best], width)


def _width(largest: Callable[[float], float], share: float, off: float) -> float:
    """Give how far a share may be from the best one for what is largest to differ by no more than rounding."""
    level = largest(share) + off
    return max(_reach(largest, share, end, level) for end in (0.0, 1.0)) + 4 * EPS


def _reach(largest: Callable[[float], float], share: float, end: float, level: float) -> float:
    """Halve the way from the best share to an end down to where the largest rises above a level."""
    if largest(end) <= level:
        return abs(end - share)
    near, far = share, end
    for _ in range(HALVINGS):
        middle = (near + far) / 2
        near, far = (middle, far) if largest(middle) <= level else (near, middle)
    return abs(far - share)


def _finding(name: str, unit: str, rows: Sequence[Sequence[float]], allowed: float) -> Finding:
    ours, theirs = (np.array(row) for row in rows)
    largest = float(np.fmax.reduce(np.abs(ours)))
    return Finding(COSTS, name, unit, ours, theirs, np.abs(ours - theirs), np.full(len(ours), allowed), largest)
