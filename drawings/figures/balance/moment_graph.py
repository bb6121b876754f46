"""The main moment of the inertia forces about the shaft over the turn, before and after (график главного момента)."""

from __future__ import annotations

import numpy as np

from drawings.figures.graphs.curve_graph import GraphCurve, bounded, swing
from drawings.lettering.balance_letters import MOMENT
from drawings.page.drafting import Drafting
from plans.model.balance.linkage import State
from plans.model.motion import Floats

NAME = "rocking"


def curve(before: State, after: State | None, sense: int, least: float, drafting: Drafting) -> GraphCurve | None:
    """Give the main moments of both states; None where there is none above `least` N*m."""
    own = after or before
    angles = np.degrees(sense * (own.around.phi - own.around.phi[0]))
    stations = np.degrees(sense * (own.centre.phi - own.centre.phi[0])) % 360
    dense, ordinates, was = (
        np.where(np.abs(row) <= least, 0.0, row) for row in (own.around.moment, own.centre.moment, before.around.moment)
    )
    if max(before.rocking, own.rocking) <= least or len(angles) < 2:
        return None
    title = drafting.word("rocking graph")
    shown = GraphCurve(MOMENT, "N*m", angles, bounded(dense, ordinates), stations, ordinates, title)
    return swing(shown if after is None else shown._replace(before=bounded(was, _own(before))))


def _own(state: State) -> Floats:
    return state.centre.moment
