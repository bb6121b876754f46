"""What holds of any machine's steady turn by analysis: energy, relations, orders, and cases that are no error."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest
from hypothesis import given

from plans.analytic.dynamics.cycle import exact_cycle, sampled_cycle
from plans.analytic.dynamics.exact import Exact, exact
from plans.analytic.dynamics.flywheel import flywheel, flywheel_of_points
from plans.analytic.dynamics.rim import wheel
from plans.analytic.dynamics.speeds import Stall, Swing, steady, with_flywheel, without_flywheel
from plans.analytic.dynamics.wave import wave
from plans.analytic.power import balancing_moment
from plans.model.dynamics import Cycle, Rim, Shaft, Task
from plans.model.machine import ALWAYS, IDLE, Body, Force, Machine, Moment, Track
from plans.model.motion import Floats
from tests.parts import examples
from tests.plans import linkages
from tests.plans.steady_machines import DELTA, OUTWARD, SPEED, Steady, edges, machine, steadies, worked

TASK = Task(SPEED, DELTA, 24)
ALL_DELTAS = (1.0, *(1 / n for n in (5, 20, 80, 500)))


@cache
def planer() -> Exact:
    return worked().exact


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
@examples(4, 200)
def test_flywheel_put_back_keeps_the_fluctuation(one: Steady) -> None:
    """The exact motion with the flywheel found has the delta asked for, and the mean speed, to 1e-9."""
    found = one.exact
    assert found.settled
    its = flywheel(found, TASK)
    swing = with_flywheel(found, TASK, its)
    if its.needed <= 0:
        assert isinstance(swing, Stall) or swing.speeds(edges(found)).delta <= DELTA * (1 + 1e-9)
        return
    assert isinstance(swing, Swing)
    scan = swing.speeds(edges(found, 180))
    assert scan.delta == pytest.approx(DELTA, rel=1e-9)
    assert scan.mean == pytest.approx(SPEED, rel=1e-12)
    assert scan.extremes[0] * (1 - 1e-12) <= scan.omega.min()
    assert scan.omega.max() <= scan.extremes[1] * (1 + 1e-12)


@given(steadies())
@examples(3, 60)
def test_account_closes_and_another_rule_gives_the_same_work(one: Steady) -> None:
    found = one.exact
    assert abs(found.surplus(np.array([2 * pi]))[0]) <= 1e-12 * measure(found)
    work, _ = by_gauss(one, found)
    assert found.work(np.array([2 * pi]))[0] == pytest.approx(work, abs=1e-12 * measure(found))


@given(steadies())
@examples(3, 60)
def test_slope_and_weights_are_those_of_the_balance_of_power(one: Steady) -> None:
    """At unit speed without acceleration the drive has M = J'/2 - M_red: by inertia forces, which know no J."""
    reduction = one.reduction
    motion = reduction.even(12)
    told = reduction.ordinates(motion)
    balancing = balancing_moment(reduction.road, one.machine, motion, reduction.loads(motion))
    size = float(told.gross.max() + np.abs(told.slope).max() + told.inertia.max())
    assert reduction.sense * balancing == pytest.approx(told.slope / 2 - told.moment, abs=1e-11 * size)


@given(steadies())
@examples(3, 60)
def test_beginning_elsewhere_changes_no_flywheel(one: Steady) -> None:
    its, other = (flywheel(each.exact, TASK) for each in (one, one._replace(start=one.start + 1.0)))
    assert other.needed + other.own == pytest.approx(other.whole, rel=1e-12)
    assert other.needed == pytest.approx(its.needed, abs=1e-9 * max(its.whole, its.own))


def scaled(one: Machine, loads: float, masses: float) -> Machine:
    """Multiply all loads, and all masses."""
    forces = tuple(
        force._replace(size=force.size * loads)
        if force.diagram is None
        else force._replace(diagram=force.diagram._replace(sizes=tuple(size * loads for size in force.diagram.sizes)))
        for force in one.forces
    )
    moments = tuple(moment._replace(size=moment.size * loads) for moment in one.moments)
    bodies = {
        k: body._replace(mass=body.mass * masses, inertia=body.inertia * masses) for k, body in one.bodies.items()
    }
    return replace(one, forces=forces, moments=moments, bodies=bodies)


def test_loads_and_the_square_of_speed_go_together() -> None:
    """Four times the load at twice the speed asks for the same flywheel; nine times all masses, for nine times it."""
    one = worked()
    its = flywheel(one.exact, TASK)
    faster = flywheel(one._replace(machine=scaled(one.machine, 4.0, 1.0)).exact, TASK._replace(speed=2 * SPEED))
    assert faster.whole == pytest.approx(its.whole, rel=1e-12)
    heavier = flywheel(one._replace(machine=scaled(one.machine, 9.0, 9.0)).exact, TASK)
    assert (heavier.whole, heavier.energy) == pytest.approx((9 * its.whole, 9 * its.energy), rel=1e-12)


def test_mirrored_machine_has_the_same_flywheel() -> None:
    mirrored = worked(start=-0.7, omega=-SPEED).exact
    its, other = flywheel(worked(start=0.7).exact, TASK), flywheel(mirrored, TASK)
    assert (other.whole, other.energy) == pytest.approx((its.whole, its.energy), rel=1e-12)
    assert [one.turned for one in other.touches] == pytest.approx([one.turned for one in its.touches], rel=1e-12)


@pytest.mark.parametrize("delta", ALL_DELTAS)
def test_any_fluctuation(delta: float) -> None:
    task = TASK._replace(delta=delta)
    its = flywheel(planer(), task)
    swing = with_flywheel(planer(), task, its)
    assert isinstance(swing, Swing)
    assert swing.speeds(edges(planer())).delta == pytest.approx(delta, rel=1e-10)


def test_work_against_a_constant_force_is_force_times_way() -> None:
    """A scotch yoke without masses, against a constant force: the work is -F times the way."""
    yoke = Steady(
        linkages.scotch_yoke(0.1, omega=1.0, epsilon=0.0), machine(Force("F", 3, "D", 0j, 500.0, None), bodies={})
    )
    found = yoke.exact
    turned = edges(found)
    assert found.breaks == pytest.approx([pi / 2, 3 * pi / 2], rel=1e-14)
    way = np.where(
        turned <= pi / 2, np.sin(turned), np.where(turned <= 3 * pi / 2, 2 - np.sin(turned), 4 + np.sin(turned))
    )
    assert exact_cycle(found, turned).work == pytest.approx(-500 * 0.1 * way, abs=1e-12 * 200)


def test_middles_of_strips_err_by_the_square_of_their_width() -> None:
    """Work and flywheel by the middles converge to the exact ones with order 2, jumps on edges."""
    exactly = flywheel(planer(), TASK).whole
    errors = []
    for n in (48, 96, 192, 384):
        told = sampled_cycle(planer(), edges(planer(), n))
        errors.append(abs(flywheel_of_points(told, TASK).whole - exactly))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders == pytest.approx(2.0, abs=0.1)


def test_thirty_six_positions_are_enough_of_a_smooth_load() -> None:
    """The trapezoid rule of a slider-crank's smooth load misses at most 1e-14 of its largest moment."""
    one = worked(Force("F", 3, "B", 0j, 700.0, 1 + 0j), Moment("T", 1, -30.0), Moment("T", 2, 25.0))
    reduction = one.reduction
    told = reduction.ordinates(reduction.even(36))
    coarse = wave(told.moment, float(told.gross.max()))
    assert abs(coarse.mean - one.exact.load.since(np.array([2 * pi]))[0] / (2 * pi)) <= 1e-14 * told.gross.max()
    every = np.linspace(0, 2 * pi, 101)
    assert coarse.at(every) == pytest.approx(one.exact.moment(every), abs=1e-13 * told.gross.max())


def test_no_load_at_all_leaves_the_varying_inertia_to_even_out() -> None:
    found = worked(Force("F", 3, "B", 0j, 0.0, 1 + 0j)).exact
    assert found.settled
    assert found.driving == 0
    assert np.abs(found.surplus(np.linspace(0, 6, 9))).max() == 0
    its = flywheel(found, TASK)
    low, high = its.touches
    assert low.varying - high.varying == pytest.approx(
        max(found.varying(np.linspace(0, 2 * pi, 20001))) - min(found.varying(np.linspace(0, 2 * pi, 20001))), rel=1e-6
    )
    swing = with_flywheel(found, TASK, its)
    assert isinstance(swing, Swing)
    assert swing.speeds(edges(found)).delta == pytest.approx(DELTA, rel=1e-10)


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


def test_a_heavy_machine_needs_no_flywheel() -> None:
    """Its rotor is flywheel enough: the motion is that without one, and steadier than was asked."""
    task = TASK._replace(shafts=(Shaft("rotor", 0.5, 10.0),))
    its = flywheel(planer(), task)
    assert its.present == 50
    assert its.needed < 0 == its.inertia
    assert wheel(its.inertia, Rim(1.0, 0.5)) is None
    swing = with_flywheel(planer(), task, its)
    assert isinstance(swing, Swing)
    assert swing.inertia == pytest.approx(planer().own + 50, rel=1e-15)
    assert swing.speeds(edges(planer())).mean == pytest.approx(SPEED, rel=1e-13)
    assert swing.speeds(edges(planer())).delta < DELTA


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


def test_a_machine_without_any_inertia_has_no_motion() -> None:
    stall = without_flywheel(worked_with({}, OUTWARD), TASK)
    assert isinstance(stall, Stall)
    assert np.isnan(stall.mean)


def test_a_load_that_drives_is_braked() -> None:
    """An engine: the load gives work, and the moment that keeps the motion steady is negative."""
    found = worked(OUTWARD._replace(size=-2000.0)).exact
    assert found.driving == pytest.approx(-360 / (2 * pi), rel=1e-12)
    swing = with_flywheel(found, TASK, flywheel(found, TASK))
    assert isinstance(swing, Swing)
    assert swing.speeds(edges(found)).delta == pytest.approx(DELTA, rel=1e-10)


def test_a_moment_that_jumps_at_a_dead_centre() -> None:
    """A moment on the crank that acts on the idle stroke alone jumps right at both dead centres."""
    found = worked(Moment("T", 1, -30.0, during=IDLE, stroke=Track("B"))).exact
    assert found.breaks == pytest.approx([0, pi], abs=1e-12)
    sides = [found.moment(np.array([pi]), side)[0] for side in (-1, 1)]
    assert sides == [pytest.approx(0, abs=1e-12), pytest.approx(-30, rel=1e-13)]
    assert found.work(np.array([2 * pi]))[0] == pytest.approx(-30 * pi, rel=1e-13)
    cycle = exact_cycle(found, edges(found))
    assert (cycle.moments[0, 0], cycle.moments[-1, 1]) == (pytest.approx(0, abs=1e-12), pytest.approx(-30, rel=1e-13))


def test_a_load_over_one_stroke_breaks_on_it_alone() -> None:
    """On the idle stroke, on which it rests, a load over the working stroke has no overruns."""
    assert len(planer().breaks) == 4
    always = worked(OUTWARD._replace(during=ALWAYS)).exact
    assert len(always.breaks) == 6


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


def test_hand_made_account_by_its_corners() -> None:
    """Range 3 J at 4 pi rad/s: J0 = 3/(omega^2 delta)."""
    its = flywheel_of_points(Cycle("hand", *hand((0.0, 2.0, -1.0, 1.0, 0.0))), TASK)
    assert its.whole == pytest.approx(3 / (SPEED**2 * DELTA), rel=1e-12)
    assert [one.surplus for one in its.touches] == [-1, 2]


def test_what_does_not_settle_is_told() -> None:
    """A crank that cannot turn fully has no numbers, and a jump that is nobody's break is not taken for smooth."""
    short = Steady(linkages.slider_crank(0.1, 0.099), machine(Force("F", 3, "B", 0j, 10.0, 1 + 0j)))
    assert not short.exact.settled
    one = worked(Moment("T", 1, -30.0))
    reduction = one.reduction
    plain = reduction.loads
    reduction.loads = lambda motion: replaced(plain(motion), motion.phi)
    found = exact(reduction, {})
    assert not found.settled
    assert found.error > 1e-9


def replaced(loading, phi: Floats):
    """Let the moment act in a third of the turn only, which no stroke tells."""
    (twist,) = loading.moments
    return loading._replace(moments=(twist._replace(moment=np.where(np.mod(phi, 2 * pi) < 2.0, twist.moment, 0.0)),))
