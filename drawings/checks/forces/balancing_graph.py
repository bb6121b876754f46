"""The self-check of the graph of the balancing moment: each number on it has its ordinate (проверка графика)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import on
from drawings.measure.measure import Measured
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import texts
from plans.model.motion import Floats
from plans.words.words import Message

PLAN = "balancing"


def ordinates(measured: Measured, leaf: Leaf, moments: Floats, slack: float) -> Iterator[Message]:
    """Hold that each numbered position has its ordinate, and the position that the sheet is of both of them.

    `moments` N*m are those by analysis over the positions; one below `slack` N*m may have no ordinate.
    """
    group = next((one for one in leaf.groups if one.name == PLAN), None)
    if group is None:
        return
    told = {text.plain for text in texts((group,)) if text.plain.isdigit()}
    seen = {one.name: one for one in measured.vectors if one.plan == PLAN}
    scale = max((one.scale for one in seen.values()), default=_written(group))
    for k, moment in enumerate(moments):
        due = str(k) in told or k == leaf.metadata["position"]
        if due and abs(moment) > slack + SEEN * scale and str(k) not in seen:
            yield on("missing_at", PLAN, name=str(k), position=k)


def _written(group: Group) -> float:
    """Give the scale of the ordinates that the heading states, for where no ordinate is long enough to be measured."""
    return max((mu for letter, mu in written_scales(group).items() if letter != "φ"), default=0.0)
