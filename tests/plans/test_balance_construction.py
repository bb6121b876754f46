"""A mechanism balanced by construction: three ways to the shaking force, kinds of groups, what needs nothing (8.2)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from plans.balance.study import BalanceStudy, substituted
from plans.model.balance.linkage import FULL, PARTIAL, SHARE, BalanceTask, Site
from plans.model.decomposition import decompose
from plans.model.kinetostatics import Kinetostatics
from plans.model.machine import Body, Transmission
from plans.scene.faults import SceneError
from tests.plans.balanced import ENGINE, FOUR_BAR, YOKE, asked, study
from tests.plans.linkages import tangent_mechanism

FAST = "[drive]\nacceleration = 37\n"


def inertia_alone(its: BalanceStudy) -> Kinetostatics:
    """Give the forces of a machine on which nothing acts but its inertia."""
    bare = replace(its.machine, gravity=0j, forces=(), moments=(), springs=(), transmission=Transmission())
    return its.statics.bearing(bare).forces


@pytest.mark.parametrize("text", [FOUR_BAR.replace("[drive]\n", FAST), ENGINE, YOKE])
def test_main_moment_holds_against_frame_and_drive(text: str) -> None:
    its = study(text, positions=24)
    forces = inertia_alone(its)
    held = forces.balancing.moment.copy()
    for key, one in forces.reactions.items():
        if key.startswith("0-"):
            held += (one.r.conj() * one.force).imag + (0 if one.moment is None else one.moment)
    most = np.abs(held).max()
    assert its.before.centre.moment == pytest.approx(-held, rel=1e-12, abs=1e-13 * most)


def test_block_and_pin_that_slide_leave_both_their_masses() -> None:
    """A slotted crank drives a pin along a fixed line: the block in the slot goes with the pin."""
    mechanism = tangent_mechanism(0.3)
    bodies = {2: Body(2, 1.5, 0.0, 0j), 3: Body(3, 4.0, 0.0, 0.02 + 0j)}
    found = substituted(mechanism, decompose(mechanism), bodies, asked(PARTIAL, Site(1, mass=2)))
    assert {point: term.value for point, term in found.left.items()} == {"A": 5.5}
    assert found.counterweights == {}


def test_mechanism_that_cannot_be_assembled_has_counterweights_but_no_costs() -> None:
    its = study(ENGINE.replace("through = [0, 0]", "through = [0, 5]"), asked(SHARE, Site(1, mass=9)))
    assert its.share == 0
    assert its.counterweights[0].moment == pytest.approx(-0.37)
    assert its.after is not None
    assert np.isnan([its.after.shaking, its.after.centre.path]).all()


@pytest.mark.parametrize(
    ("text", "task", "where", "said"),
    [
        (FOUR_BAR, asked(FULL, Site(1, mass=9)), "", "link 2 or 3"),
        (ENGINE, asked(FULL, Site(1, mass=9)), "", "on link 2"),
        (ENGINE, asked(PARTIAL, Site(1, at=0.1)), "counterweights[0].at", "3.7 kg"),
        (ENGINE, asked(PARTIAL, Site(1, mass=2), Site(3, mass=1)), "counterweights[1].on", "1 or 2"),
        (ENGINE, asked(PARTIAL, Site(2, radius=0.6)), "counterweights[0].on", "its mass"),
        (FOUR_BAR, asked(SHARE, Site(1, mass=9), Site(2, mass=6), share=0.5), "balance", "reciprocating"),
        (YOKE, asked(FULL, Site(1, mass=2)), "balance", "link 3 slides on the frame"),
        (YOKE, asked(PARTIAL, Site(1, at=-0.05)), "counterweights[0].at", "degrees"),
    ],
)
def test_balance_that_cannot_be_is_refused(text: str, task: BalanceTask, where: str, said: str) -> None:
    with pytest.raises(SceneError) as refused:
        _ = study(text, task).counterweights
    (fault,) = refused.value.faults
    assert where in str(refused.value)
    assert said in str(refused.value)
    assert fault.worded("ru") != fault.worded("en")


def test_mechanism_that_is_balanced_already_needs_nothing() -> None:
    first = study(FOUR_BAR, asked(FULL, Site(1, mass=9), Site(2, mass=6)))
    again = BalanceStudy(first.linkage, first.loaded_statics, first.task)
    assert [(one.mass, one.moment, one.needed) for one in again.counterweights] == [(0, 0, False)] * 2
    assert again.balance.still
    assert again.loaded == first.loaded
