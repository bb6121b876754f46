"""What holds of the balance of any machine of dyads: three ways to one force, nothing left over, likeness of likes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from plans.balance.study import BalanceStudy, substituted
from plans.balance.weights import Unmade, begins
from plans.linkage.drafts import Drafts
from plans.model.balance.linkage import FULL, NONE, PARTIAL, BalanceTask, Site
from plans.model.machine import Transmission
from tests.plans.loaded import Loaded, loaded, push

HEAVY = 30.0  # kg, of every counterweight: as heavy as the heaviest links


def bare(one: Loaded) -> Loaded:
    """Let nothing but inertia act on a machine."""
    quiet = replace(one.machine, gravity=0j, forces=(), moments=(), springs=(), transmission=Transmission())
    return replace(one, machine=quiet)


def balance(one: Loaded, aim: str = NONE) -> BalanceStudy:
    """Study the balance of a machine with a counterweight on every link that may carry one."""
    assume(any(body.mass for body in one.machine.bodies.values()))
    return BalanceStudy(one.study, one.statics, task(one, aim))


def task(one: Loaded, aim: str) -> BalanceTask:
    places = () if aim == NONE else tuple(Site(link, mass=HEAVY) for link in begins(one.mechanism, one.study.groups))
    return BalanceTask(aim, places)


def bearable(one: Loaded, aim: str) -> Loaded:
    """Let nothing but inertia act, and take the masses off groups that no counterweight could bring to rest."""
    one, groups = bare(one), one.study.groups
    assume(all(group.order == "II" for group in groups))  # a triad is not balanced by counterweights
    while True:
        try:
            substituted(one.mechanism, groups, one.machine.bodies, task(one, aim))
            return one
        except Unmade as refused:
            at = next(k for k, group in enumerate(groups) if refused.details["link"] in group.links)
            light = {link for group in groups[at:] for link in group.links}
            bodies = {link: body for link, body in one.machine.bodies.items() if link not in light}
            one = replace(one, machine=replace(one.machine, bodies=bodies))


def shaking(its: BalanceStudy, after: bool = False) -> tuple[complex, float]:
    """Give the sum of the inertia forces of the links one by one, and the sum of their sizes."""
    sides = its.drawing(after).shaking.sides
    forces = [complex(np.asarray(side.vector.point).flat[0]) for side in sides]
    return sum(forces, 0j), sum(map(abs, forces))


@push
@given(loaded(), st.sampled_from((FULL, PARTIAL)))
def test_what_is_left_at_sliders_is_all_that_shakes_a_balanced_machine(one, aim):
    one = bearable(one, aim)
    its = balance(one, aim)
    force, sizes = shaking(its, after=True)
    points = Drafts(its.linkage, its.linkage.turn).motion(2).points
    left = -sum(mass * complex(points[point].a[0]) for point, mass in its.left.items())
    moved = sum(abs(mass * points[point].a[0]) for point, mass in its.left.items())
    assert abs(force - left) <= one.margin * (sizes + moved)
