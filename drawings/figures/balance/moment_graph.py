"""The main moment of the inertia forces about the shaft over the turn, before and after (график главного момента)."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from drawings.figures.graphs.curve_graph import TURN, GraphCurve, bounded, swing
from drawings.lettering.balance_letters import MOMENT
from drawings.page.drafting import Drafting
from drawings.paper.limits import MANY
from plans.model.balance.linkage import State
from plans.model.motion import Floats

ROOMY = 3 * MANY  # positions that all have room


def told(count: int, shown: int) -> tuple[int, ...]:
    """Choose the positions that are told.

    >>> told(12, 2) == tuple(range(12)), told(72, 1)[:4]
    (True, (0, 1, 6, 12))
    """
    every = 1 if count <= ROOMY else math.ceil(count / MANY)
    return tuple(k for k in range(count) if k % every == 0 or k == shown)


NAME = "rocking"


def curve(
    states: Mapping[str, State], sense: int, shown: int, least: float, drafting: Drafting, point: str
) -> GraphCurve | None:
    """Give the main moments about a point, at the positions the last one; None where all are below `least` N*m.

    Of a crank that cannot turn fully there are the ordinates at its positions alone.
    """
    first, own = next(iter(states.values())), list(states.values())[-1]
    if max(first.rocking, own.rocking) <= least or len(own.centre.phi) < 2:
        return None
    numbers = told(len(own.centre.phi), shown)
    stations = np.degrees(sense * (own.centre.phi - own.centre.phi[0]))[list(numbers)] % TURN
    ordinates, title = _seen(own.centre.moment, least)[list(numbers)], drafting.word("rocking graph", point=point)
    bare = GraphCurve(MOMENT, "N*m", np.array([0.0, TURN]), np.full(2, np.nan), stations, ordinates, title)
    bare = bare._replace(numbers=numbers)
    if not own.whole:
        swung = swing(bare)
        return swung._replace(values=np.full(len(swung.values), np.nan))
    angles = np.degrees(sense * (own.around.phi - own.around.phi[0]))
    gaps = any(np.isnan(one.around.moment).any() for one in (first, own))  # beside one a curve is cut off
    whole = bare._replace(angles=angles, values=_course(own, least), states="" if gaps else "last")
    return whole if own is first else whole._replace(before=_course(first, least))


def _course(state: State, least: float) -> Floats:
    return np.asarray(bounded(_seen(state.around.moment, least), _seen(state.centre.moment, least)))


def _seen(moments: Floats, least: float) -> Floats:
    return np.where(np.abs(moments) <= least, 0.0, moments)
