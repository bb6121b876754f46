"""Cases of a machine's motion by analysis that are no error: no load, stall, jumps at dead centres, reversals."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest

from plans.analytic.dynamics.flywheel import Exact, flywheel, flywheel_of_points
from plans.analytic.dynamics.speeds import Stall, Swing, steady, with_flywheel, without_flywheel
from plans.model.dynamics import Cycle, Task
from plans.model.machine import BACKWARD, FORWARD, IDLE, WORKING, Body, Force, Moment
from plans.model.motion import Floats
from tests.plans import linkages
from tests.plans.steady_machines import DELTA, OUTWARD, SPEED, Steady, edges, machine, worked

TASK = Task(SPEED, DELTA, 24)


@cache
def planer() -> Exact:
    return worked().exact


def test_constant_inertia_and_no_load_ask_for_nothing() -> None:
    wheels = {1: Body(1, 3.0, 0.5, 0j)}
    found = worked_with(wheels, Force("F", 3, "B", 0j, 0.0, 1 + 0j))
    its = flywheel(found, TASK)
    assert (its.whole, its.needed, its.inertia) == (pytest.approx(0, abs=1e-15), pytest.approx(-0.5), 0)
    swing = with_flywheel(found, TASK, its)
    assert isinstance(swing, Swing)
    assert swing.speeds(edges(found)).omega == pytest.approx(SPEED, rel=1e-14)


def worked_with(bodies, *loads: Force | Moment) -> Exact:
    one = worked(*loads)
    return one._replace(machine=replace(one.machine, bodies=bodies)).exact


def test_constant_inertia_needs_the_range_of_energy_alone() -> None:
    """J0 = (T_max - T_min)/(omega^2 delta): the textbooks' first formula, and Mertsalov's without an error."""
    found = worked_with({1: Body(1, 3.0, 0.5, 0j)}, OUTWARD)
    its = flywheel(found, TASK)
    height = its.touches[1].surplus - its.touches[0].surplus
    assert height > 0
    assert its.whole == pytest.approx(height / (SPEED**2 * DELTA), rel=1e-12)


def test_a_machine_that_would_stop_is_told_where() -> None:
    """Without a flywheel the cut uses up all there is, at its end."""
    stall = without_flywheel(planer(), TASK)
    assert isinstance(stall, Stall)
    assert np.degrees(stall.turned) == pytest.approx(150.3837539, abs=5e-8)
    assert stall.mean > SPEED
    barely = steady(planer(), planer().own, stall.mean * 1.01)
    assert isinstance(barely, Swing)
    low, high = barely.extremes()[1]
    assert low < 0.02 * high
    assert isinstance(steady(planer(), planer().own, stall.mean * 0.99), Stall)


@pytest.mark.parametrize(("way", "stroke"), [(FORWARD, WORKING), (BACKWARD, IDLE)])
def test_a_load_by_its_way_is_that_of_a_stroke_that_turns_back_only_at_its_ends(way: str, stroke: str) -> None:
    ours, theirs = (worked(OUTWARD._replace(during=when)).exact for when in (way, stroke))
    assert ours.breaks == pytest.approx(theirs.breaks, abs=1e-12)
    every = np.linspace(0, 2 * pi, 50)
    assert ours.settled
    assert ours.moment(every) == pytest.approx(theirs.moment(every), abs=1e-10)


def test_extremes_equal_at_two_places() -> None:
    """A scotch yoke stands alike in both halves of its turn: the first of two equal touches counts."""
    yoke = Steady(
        linkages.scotch_yoke(0.1, omega=1.0, epsilon=0.0),
        machine(Force("F", 3, "D", 0j, 500.0, None), bodies={3: Body(3, 2.0, 0.0, 0j)}),
    )
    found = yoke.exact
    low, high = flywheel(found, TASK).touches
    assert max(low.turned, high.turned) < pi
    told = flywheel_of_points(Cycle("hand", *hand((0.0, 2.0, -1.0, 2.0, 0.0))), TASK).touches
    assert told[1].turned == pytest.approx(pi / 2)


def hand(surplus: tuple[float, ...]) -> tuple[Floats, ...]:
    """Give the account of a turn in four strips at whose edges the energy has these values, J; the inertia is 1."""
    turned = np.linspace(0, 2 * pi, 5)
    means = np.diff(surplus) / (pi / 2)
    return turned, np.zeros(0), np.stack((means, means), axis=1), means, np.array(surplus), np.ones(5)
