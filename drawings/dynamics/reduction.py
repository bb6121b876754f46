"""The reduction alone, where there is no steady turn: its graphs over the turn or the swing, its table (приведение)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.dynamics.graphs import INERTIA, MOMENTS
from drawings.kinds.curve_graph import FORM, GraphCurve, bounded, swing
from drawings.page.page import Drafting
from plans.dynamics.reduction import Reduction
from plans.model.dynamics import TURN
from plans.model.motion import Floats

STEPS = 720  # of a turn: half a degree, less than the width of a line on any sheet
LOW = FORM._replace(ratio=2.4, taller=2.4)  # both stand one over the other above the table on an A4
GRAPHED = (  # figure, what of the reduction it shows, letter, unit, title
    (MOMENTS, "moment", "M_{red}", "N*m", "reduced moment"),
    (INERTIA, "inertia", "J_{red}", "kg*m2", "reduced inertia"),
)


def turned(reduction: Reduction) -> Floats:
    """Give the angles of the positions of the scene from position 0 on in the sense of rotation, degrees."""
    return np.asarray(np.degrees(reduction.study.sense * (reduction.study.turn.phi - reduction.start)) % 360)


def curves(reduction: Reduction, drafting: Drafting) -> Iterator[GraphCurve]:
    """Give the graphs of the reduced moment and the reduced inertia with the positions of the scene."""
    angles = TURN * np.arange(STEPS + 1) / STEPS
    dense, found = reduction.at(angles), reduction.reduced
    for name, part, letter, unit, title in GRAPHED:
        ordinates = getattr(found, part)
        rows = np.degrees(angles), bounded(getattr(dense, part), ordinates), turned(reduction), ordinates
        lettered = drafting.letter(letter)
        yield swing(GraphCurve(lettered, unit, *rows, drafting.word(title), name=name, states=letter, form=LOW))
