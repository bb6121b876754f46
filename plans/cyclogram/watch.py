"""Positions of extreme pressure angle by construction: the pin farthest to one side (угол давления; M1.3).

Of two rods the distance of their outer hinges is extreme where the moving one lies in line with the fixed ones; a rod
leans most to its guide where its hinge is farthest from the guide.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from geometry.board import Mark
from geometry.meet import dot
from plans.cyclogram.tool import Notch, circle, go_back, keep, notch_of, way_back
from plans.linkage.groups import guide
from plans.linkage.plan import Plan
from plans.model.cyclogram import Watched
from plans.model.dyad import Dyad
from plans.model.group import Group
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.words.words import because


class Watch(NamedTuple):
    """A group whose pressure angle is watched: how it hangs on a link with a fixed pivot, and the way from there."""

    notch: Notch
    way: tuple[Notch, ...]

    @property
    def dyad(self) -> Dyad:
        """The group."""
        return self.notch.dyad

    @property
    def watched(self) -> Watched:
        """What of it is watched: the link on the host first."""
        dyad, end = self.dyad, self.notch.end
        links = dyad.links[end], dyad.links[1 - end]
        joint = dyad.outer[1 - end]
        if isinstance(joint, Slide):
            return Watched(links, dyad.pin, (self.notch.pin, ""), joint.way(FRAME))
        return Watched(links, dyad.pin, (self.notch.pin, joint))


def watch_of(mechanism: Mechanism, groups: Sequence[Group]) -> Watch | None:
    """Give the first group of a rod with a rocker or a slider on the frame that can be notched; or none."""
    for group in groups:
        links = group.links if isinstance(group, Dyad) and isinstance(group.inner, str) else ()
        notch = next((one for link in links if (one := notch_of(mechanism, group, link))), None)
        way = way_back(mechanism, groups, notch.host) if notch else None
        if notch is not None and way is not None:
            return Watch(notch, way)
    return None


def construct(plan: Plan, watch: Watch, there: Plan) -> Mark:
    """Put the pin where the pressure angle is extreme, then notch back; the crank's vector from pivot to end."""
    notch, board = watch.notch, plan.board
    line = _line(plan, watch)
    centre, end = (np.asarray(there.point(name).point) for name in (notch.pivot, notch.pin))
    assert isinstance(line.value, tuple)
    along = line.step.inputs[1].point * (1j if line.step.op == "square" else 1.0)
    arc = circle(plan, notch.host, notch.pivot, notch.pin)
    side = np.sign(dot(along, end - centre))
    found = board.meet(notch.pin, line, arc, side, because("watch_pin", point=notch.pin))
    keep(plan, notch.host, notch.pivot, plan.name(notch.pin, found))
    return go_back(plan, watch.way, there)


def _line(plan: Plan, watch: Watch) -> Mark:
    """Draw through the host's pivot the line on which the pin stands in its farthest places."""
    notch, joint = watch.notch, watch.dyad.outer[1 - watch.notch.end]
    pivot = plan.point(notch.pivot)
    if isinstance(joint, Slide):
        way = guide.direction(plan, joint, FRAME)
        return plan.board.square(f"⊥ {notch.pivot}", pivot, way, because("watch_square"))
    fixed = plan.board.join(f"{notch.pivot}{joint}", pivot, plan.point(joint), because("watch_fixed"))
    return plan.board.parallel(f"{notch.pivot}{joint}", pivot, fixed, because("watch_line"))
