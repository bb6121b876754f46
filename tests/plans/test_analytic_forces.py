"""Force analysis by the analytic road: gears, reduced moments, each link by itself, and where there are no forces."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import replace
from math import pi, radians, sqrt

import numpy as np
import pytest

from plans.analytic.energy import energy_balance
from plans.analytic.power import balancing_moment, reduced_inertia, reduced_moment, transfers
from plans.model.kinetostatics import Kinetostatics
from plans.model.machine import Body
from plans.model.mechanism import Way
from plans.model.motion import Floats
from tests.parts import first
from tests.plans import linkages
from tests.plans.machines import SHAPER, Run, machine, steady
from tests.plans.studies import driven

CUTTING = {(5, 0j): 1500 + 0j}


DIGITS = 5.1e-10  # values printed with ten digits: half a unit of the tenth of a value that begins with 1
AT_60 = np.radians([60.0])
TURN = np.arange(12) * (pi / 6)


# The six-link shaper with its gear


# The slider-crank of the reduced moments


ENGINE = linkages.slider_crank(0.1, 0.4)
ENGINE_MASSES = {1: Body(1, 3, 0.01, 0.04), 2: Body(2, 4, 0.06, 0.15), 3: Body(3, 8, 0, 0j)}


def test_reduced_inertia_of_the_slider_crank():
    run = Run(ENGINE, machine(ENGINE_MASSES), AT_60)
    poses = run.road.poses(run.motion)
    first = transfers(run.road.constraints, poses)
    assert reduced_inertia(run.road.constraints, run.machine, poses, first) == pytest.approx(0.1289878783, rel=DIGITS)


def test_the_energy_balance_differentiates_the_reduced_inertia():
    run = Run(driven(ENGINE, 10, 0), machine(ENGINE_MASSES, gravity=0j), AT_60)
    assert energy_balance(*run.case).moment == pytest.approx(0.07465262898 * 10**2 / 2, rel=DIGITS)
    assert run.forces.balancing.moment == pytest.approx(0.07465262898 * 10**2 / 2, rel=DIGITS)


@pytest.mark.parametrize("omega", [10.0, -10.0, 0.0])
def test_reduced_moment_of_the_slider_crank(omega):
    mechanism = driven(ENGINE, omega, 0.0)
    loads = steady(1, {(3, 0j): 1200, (2, 0.15): 4 * -9.81j})
    run = Run(mechanism, machine(), AT_60, loads)
    assert reduced_moment(run.road, run.motion, loads) == pytest.approx(-118.4552813, rel=DIGITS)
    for balance in (run.forces.balancing.moment, balancing_moment(*run.case), energy_balance(*run.case).moment):
        assert balance == pytest.approx(118.4552813, rel=DIGITS)


# Link by link: nine equations for the engine and for the crank-rocker

LOADS = {(2, 0.07 + 0j): 40 - 30j, (3, 0j): -900 + 20j}
ROD = linkages.slider_crank(0.06, 0.20, 0.02, rod={"S": 0.07})
ROD_MASSES = {1: Body(1, 2, 0.003, 0.01 + 0.005j), 2: Body(2, 1.5, 0.008, 0.07), 3: Body(3, 4, 0.002, 0.01 - 0.02j)}
ROCKER = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j})
ROCKER_MASSES = {1: Body(1, 3, 0.02, 0.02j), 2: Body(2, 5, 0.09, 0.2 + 0.05j), 3: Body(3, 4, 0.05, 0.12 - 0.01j)}


def newton_euler(run: Run, k: int) -> Floats:
    """Solve R01, R12, R23, R03 and the driving moment of a four-link mechanism from F = m a, M = J eps of each link.

    The four-bar has R03 at C; the engine's slider has a force across its guide along x, and a moment.
    """
    motion, rows, right = run.motion, np.zeros((9, 9)), np.zeros(9)
    pins = {letter: complex(motion.points[letter].r[k]) for letter in "OABC" if letter in motion.points}
    joints = [("O", 0, 1), ("A", 1, 2), ("B", 2, 3)] + ([("C", 0, 3)] if "C" in pins else [])
    for link, body in run.machine.bodies.items():
        first = next(iter(run.mechanism.links[link].points))
        turn, omega, epsilon = (float(row[k]) for row in motion.links[link] if row is not None)
        arm = body.centre * cmath.rect(1, turn)
        S, own = motion.points[first].r[k] + arm, 3 * (link - 1)
        start = motion.points[first].a
        assert start is not None
        force = body.mass * (start[k] + (1j * epsilon - omega**2) * arm - run.machine.gravity)
        moment = body.inertia * epsilon
        for load in run.loading.forces:
            if load.link == link:
                force -= load.force[k]
                lever = (load.at - body.centre) * cmath.rect(1, turn)
                moment -= (lever.conjugate() * load.force[k]).imag
        right[own : own + 3] = force.real, force.imag, moment
        for column, (letter, giver, taker) in enumerate(joints):
            if link in (giver, taker):
                sign, lever = (1 if link == taker else -1), pins[letter] - S
                rows[own, 2 * column] = rows[own + 1, 2 * column + 1] = sign
                rows[own + 2, 2 * column : 2 * column + 2] = -sign * lever.imag, sign * lever.real
        if link == 3 and "C" not in pins:
            rows[own + 1, 6], rows[own + 2, 6:8] = 1, ((pins["B"] - S).real, 1)
    rows[2, 8] = 1
    return np.linalg.solve(rows, right)


@pytest.mark.parametrize("omega", [10.0, -25.0, 0.0])
@pytest.mark.parametrize(("mechanism", "masses"), [(ROD, ROD_MASSES), (ROCKER, ROCKER_MASSES)])
def test_link_by_link(mechanism, masses, omega):
    run = Run(driven(mechanism, omega, 5.0), machine(masses), TURN + 0.1, steady(12, LOADS))
    found = run.forces
    for k in range(12):
        expected = newton_euler(run, k)
        told = [found.reactions[key].force[k] for key in ("0-1", "1-2", "2-3")]
        guide = found.reactions["0-3"]
        told.append(guide.force[k] if guide.moment is None else complex(guide.force[k].imag, guide.moment[k]))
        values = [part for force in told for part in (force.real, force.imag)]
        size = np.abs(expected).max()
        assert [*values, found.balancing.moment[k]] == pytest.approx(expected, abs=1e-13 * size)


# Where there are no forces

TWO = {2: Body(2, 1, 0.01, 0.1), 3: Body(3, 1, 0.01, 0.1)}


def gaps(found: Kinetostatics) -> dict[int, tuple[str, str]]:
    named = {gap.position: (gap.plan, gap.reason) for gap in found.gaps}
    assert len(named) == len(found.gaps)
    for values in (found.balancing.moment, *(reaction.force for reaction in found.reactions.values())):
        assert np.array_equal(np.flatnonzero(np.isnan(np.abs(values))), sorted(named))
    return named


# Coupler and rocker, 0.2 and 0.3 m, are in line at exactly 90 degrees: 0.3, 0.4 and 0.5 m make a right angle.
DOUBLE_ROCKER = linkages.four_bar(0.3, 0.2, 0.3, 0.4, sketch={"B": 0.15 + 0.2j})


@pytest.mark.parametrize("beside", first([0.0, 1e-15, 1e-13]))
def test_a_dead_centre_has_no_reactions(beside):
    run = Run(DOUBLE_ROCKER, machine(TWO), np.array([1.4, pi / 2 - beside]))
    assert gaps(run.forces) == {1: ("forces", "dead centre")}
    assert np.isnan(balancing_moment(*run.case)[1])


def test_too_near_a_dead_centre_the_energy_balance_does_not_judge():
    run = Run(DOUBLE_ROCKER, machine(TWO), pi / 2 - np.array([0.5, 0.1, 0.01, 0.001]))
    energy, moment = energy_balance(*run.case), run.forces.balancing.moment
    assert np.isfinite(moment).all()
    assert np.isfinite(energy.allowed).tolist() == [True, True, True, False] and np.isnan(energy.moment[3])
    assert (np.abs(energy.moment - moment) <= energy.allowed)[:3].all()
    assert (energy.allowed[:3] < 1e-2 * np.abs(moment[:3])).all()


def shaper(loads: Mapping[tuple[int, complex], complex] = CUTTING) -> Run:
    """The shaper with the ram's guide exactly amid the sagitta of B's arc."""
    mechanism = linkages.shaper()
    slot, guide = mechanism.slides
    exact = guide._replace(on_owner=Way(1j * sqrt(0.35**2 - 0.12**2), 1 + 0j))
    return Run(replace(mechanism, slides=(slot, exact)), SHAPER, AT_60, steady(1, loads))


def test_a_gear_that_turns_clockwise_pushes_by_the_other_flank():
    run = shaper()
    back = Run(driven(run.mechanism, -10, 5), SHAPER, AT_60, run.loading).forces
    assert back.balancing.force is not None
    along = back.balancing.force[0] / abs(back.balancing.force[0])
    assert along in (pytest.approx(cmath.rect(1, radians(100))), pytest.approx(-cmath.rect(1, radians(100))))
    # Without the sense of rotation everything that inertia asks for is the same.
    assert back.balancing.moment[0] == pytest.approx(285.0376673, rel=DIGITS)
