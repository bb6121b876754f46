"""Steady turns by analysis: extreme cases, and what must hold of any machine (catalogue I)."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest
from hypothesis import given

from plans.analytic.dynamics.flywheel import Exact, exact_cycle, flywheel
from plans.analytic.dynamics.speeds import Stall, Swing, steady, with_flywheel, without_flywheel
from plans.model.dynamics import Task
from plans.model.machine import Body, Force, Moment
from plans.model.motion import Floats
from tests.parts import examples
from tests.plans import linkages
from tests.plans.steady_machines import DELTA, OUTWARD, SPEED, Steady, edges, machine, steadies, worked

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


def measure(found: Exact) -> float:
    """Give the largest energy J that counts, for what is less than its rounding."""
    every = np.linspace(0, 2 * pi, 97)
    return float(np.abs(found.work(every)).max() + np.abs(found.moment(every)).max())


def by_gauss(one: Steady, found: Exact) -> tuple[float, Floats]:
    """Integrate the moment between breaks by another rule: work of a turn, and the moments at its nodes."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    knots = np.unique([0.0, *found.breaks, *np.linspace(0, 2 * pi, 7)])
    low, high = knots[:-1, None], knots[1:, None]
    at = ((low + high) / 2 + (high - low) / 2 * nodes).ravel()
    moments = one.reduction.ordinates(one.reduction.motion(at)).moment
    assert found.moment(at) == pytest.approx(moments, abs=1e-11 * measure(found))
    return float((moments.reshape(len(low), -1) @ weights * np.diff(knots) / 2).sum()), moments


@given(steadies())
@examples(2, 60)
def test_account_closes_and_another_rule_gives_the_same_work(one: Steady) -> None:
    found = one.exact
    assert abs(found.surplus(np.array([2 * pi]))[0]) <= 1e-12 * measure(found)
    work, _ = by_gauss(one, found)
    assert found.work(np.array([2 * pi]))[0] == pytest.approx(work, abs=1e-12 * measure(found))


def test_mirrored_machine_has_the_same_flywheel() -> None:
    mirrored = worked(start=-0.7, omega=-SPEED).exact
    its, other = flywheel(worked(start=0.7).exact, TASK), flywheel(mirrored, TASK)
    assert (other.whole, other.energy) == pytest.approx((its.whole, its.energy), rel=1e-12)
    assert [one.turned for one in other.touches] == pytest.approx([one.turned for one in its.touches], rel=1e-12)


def test_work_against_a_constant_force_is_force_times_way() -> None:
    """A scotch yoke without masses, against a constant force: the work is -F times the way."""
    force = Force("F", 3, "D", 0j, 500.0, None)
    found = Steady(linkages.scotch_yoke(0.1, omega=1.0, epsilon=0.0), machine(force, bodies={})).exact
    turned = edges(found)
    assert found.breaks == pytest.approx([pi / 2, 3 * pi / 2], rel=1e-14)
    up = np.sin(turned)
    way = np.where(turned <= pi / 2, up, np.where(turned <= 3 * pi / 2, 2 - up, 4 + up))
    assert exact_cycle(found, turned).work == pytest.approx(-500 * 0.1 * way, abs=1e-12 * 200)


def test_a_machine_without_any_inertia_has_no_motion() -> None:
    stall = without_flywheel(worked_with({}, OUTWARD), TASK)
    assert isinstance(stall, Stall)
    assert np.isnan(stall.mean)
