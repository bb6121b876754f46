"""A mechanism balanced by analysis: counterweights, the machine before and after, the share (уравновешивание)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plans.analytic.balance.counterweights import Found, counterweights, shared
from plans.analytic.balance.shares import Weighing, shifted
from plans.analytic.balance.sought import sought
from plans.analytic.balance.states import Course, state
from plans.model.balance.linkage import ANALYSIS, FORCE, NONE, SHARE, Balance, Shares, Task
from plans.model.group import Group


def balance(course: Course, task: Task, groups: Sequence[Group], share: float | None = None) -> Balance:
    """Balance a mechanism; a `share` that is given is taken for one that the task seeks."""
    mechanism = course.mechanism
    before = state(course)
    if task.aim == NONE:
        return Balance(ANALYSIS, task, (), {}, before, None, None, course.motion.gaps)
    found = counterweights(mechanism, course.machine, sought(mechanism, groups, task))
    found, chosen = _chosen(course, task, found, share)
    after = replace(state(course, found.counterweights), beside=before.forces.largest)
    return Balance(ANALYSIS, task, found.counterweights, found.left, before, after, chosen, course.motion.gaps)


def weighing(course: Course, found: Found) -> Weighing:
    """Weigh shares of the reciprocating mass, from the counterweights that leave all of it."""
    return Weighing(course, found.counterweights, shared(course.mechanism, found.left))


def _chosen(course: Course, task: Task, found: Found, share: float | None) -> tuple[Found, Shares | None]:
    """Take the share of the reciprocating mass that is asked for, off the crank's counterweight."""
    if task.aim != SHARE:
        return found, None
    told = weighing(course, found).shares
    best = told.least_force if task.least == FORCE else told.least_reaction
    taken = next(one for one in (share, task.share, best.share) if one is not None)
    step = shared(course.mechanism, found.left)
    return replace(found, counterweights=shifted(course, found.counterweights, step, taken)), told
