"""The main moment of the inertia forces about the shaft over the turn, before and after (график главного момента)."""

from __future__ import annotations

import numpy as np

from drawings.figures.graphs.curve_graph import TURN, GraphCurve, bounded, swing
from drawings.lettering.balance_letters import MOMENT
from drawings.page.drafting import Drafting
from plans.model.balance.linkage import State
from plans.model.motion import Floats

NAME = "rocking"


def curve(before: State, after: State | None, sense: int, least: float, drafting: Drafting) -> GraphCurve | None:
    """Give the main moments of both states; None where there is none above `least` N*m.

    Of a crank that cannot turn fully there are the ordinates at its positions alone.
    """
    own = after or before
    if max(before.rocking, own.rocking) <= least or len(own.centre.phi) < 2:
        return None
    stations = np.degrees(sense * (own.centre.phi - own.centre.phi[0])) % TURN
    title = drafting.word("rocking graph")
    ordinates = _seen(own.centre.moment, least)
    if own.whole:
        angles = np.degrees(sense * (own.around.phi - own.around.phi[0]))
        shown = GraphCurve(MOMENT, "N*m", angles, _course(own, least), stations, ordinates, title)
        return shown if after is None else shown._replace(before=_course(before, least))
    nothing = np.full(2, np.nan)
    shown = swing(GraphCurve(MOMENT, "N*m", np.array([0.0, TURN]), nothing, stations, ordinates, title))
    return shown._replace(values=np.full(len(shown.values), np.nan))


def _course(state: State, least: float) -> Floats:
    return np.asarray(bounded(_seen(state.around.moment, least), _seen(state.centre.moment, least)))


def _seen(moments: Floats, least: float) -> Floats:
    return np.where(np.abs(moments) <= least, 0.0, moments)
