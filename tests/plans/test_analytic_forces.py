"""Force analysis by the analytic road: the worked values of the method descriptions, and where there are no forces."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import replace
from math import pi, radians, sqrt

import numpy as np
import pytest

from plans.analytic.energy import energy_balance
from plans.analytic.inertia import borne, reduced_inertia
from plans.analytic.kinematics import Analysis
from plans.analytic.kinetostatics import kinetostatics
from plans.analytic.power import balancing_moment, reduced_moment, transfers
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.machine import FORCE, Body, Transmission
from plans.model.mechanism import FRAME, Drive, Slide, Way
from plans.model.motion import Floats, Gap
from tests.parts import first, several
from tests.plans import linkages
from tests.plans.machines import SHAPER, Run, machine, steady
from tests.plans.studies import driven, study_of

EPS = float(np.finfo(float).eps)
DIGITS = 5.1e-10  # values printed with ten digits: half a unit of the tenth of a value that begins with 1
AT_60 = np.radians([60.0])
CUTTING = {(5, 0j): 1500 + 0j}
TURN = np.arange(12) * (pi / 6)


def printed(*values: complex) -> object:
    return pytest.approx(values, rel=DIGITS, abs=1e-10)


def of(found: Kinetostatics, *names: str) -> list[complex]:
    """Read forces of one link on another at the first position: R_34 is that of 3 on 4, and R_43 its negative."""
    forces = []
    for name in names:
        one, other = sorted(name)
        force = complex(found.reactions[f"{one}-{other}"].force[0])
        forces.append(force if name == one + other else -force)
    return forces


def arm(found: Kinetostatics, key: str) -> float:
    arms = found.reactions[key].arm
    assert arms is not None
    return float(arms[0])


# The six-link shaper with its gear


def shaper(loads: Mapping[tuple[int, complex], complex] = CUTTING) -> Run:
    """The shaper with the ram's guide exactly amid the sagitta of B's arc."""
    mechanism = linkages.shaper()
    slot, guide = mechanism.slides
    exact = replace(guide, on_owner=Way(1j * sqrt(0.35**2 - 0.12**2), 1 + 0j))
    return Run(replace(mechanism, slides=(slot, exact)), SHAPER, AT_60, steady(1, loads))


def test_reactions_of_the_shaper():
    found = shaper().forces
    assert of(found, "34") == printed(-1638.521367 + 135.3722722j)
    assert of(found, "05", "54") == printed(134.079514j, 1623.657862 - 111.170486j)
    assert of(found, "12", "03") == printed(-2537.127867 + 335.3600848j, 861.3863359 - 78.97888146j)
    assert of(found, "01") == printed(-3828.043619 + 1477.427016j)
    sizes = [abs(force) for force in of(found, "34", "12", "03", "01")]
    assert sizes == printed(1644.103987, 2559.196006, 864.9994701, 4103.255846)


def test_the_massless_block_passes_its_force_on():
    found = shaper().forces
    slot = found.reactions["2-3"]
    assert slot.along is not None and slot.moment is not None
    assert of(found, "23") == pytest.approx(of(found, "12"), rel=1e-12)
    assert (slot.along[0], slot.r[0]) == printed(cmath.rect(1, radians(82.47023729)), 0.06 + 0.1039230485j)
    assert slot.moment[0] == pytest.approx(0, abs=1e-9)


def test_the_gear_drives_the_shaper():
    balancing = shaper().forces.balancing
    assert balancing.force is not None and balancing.r is not None
    assert balancing.force[0] == pytest.approx(1290.915752 - 1083.206931j, rel=DIGITS)
    assert abs(balancing.force[0]) == pytest.approx(1685.170833, rel=DIGITS)
    assert balancing.r[0] == pytest.approx(cmath.rect(0.18, radians(210)), rel=4 * EPS)
    assert balancing.moment[0] == pytest.approx(285.0376673, rel=DIGITS)


def test_power_of_all_other_forces():
    run = shaper()
    masses = borne(run.mechanism, run.machine, run.motion)
    loads = Loading(run.loading.forces + masses.forces, masses.moments)
    assert 10 * reduced_moment(run.road, run.motion, loads) == pytest.approx(-2850.376673, rel=DIGITS)
    assert balancing_moment(*run.case) == pytest.approx(285.0376673, rel=DIGITS)
    energy = energy_balance(*run.case)
    assert energy.moment == pytest.approx(285.0376673, rel=DIGITS) and energy.allowed < 285 * DIGITS * 100


def test_a_gear_changes_but_the_main_bearing():
    geared = shaper()
    plain = Run(geared.mechanism, machine(SHAPER.bodies), AT_60, geared.loading)
    for key, reaction in plain.forces.reactions.items():
        apart = 1290.915752 - 1083.206931j if key == "0-1" else 0.0
        assert reaction.force - geared.forces.reactions[key].force == pytest.approx(apart, abs=1e-6), key
    assert plain.forces.balancing.force is None
    assert plain.forces.balancing.moment == pytest.approx(geared.forces.balancing.moment, rel=1e-13)


def test_a_force_at_the_cranks_end_drives_square_to_it():
    pushed = Run(shaper().mechanism, replace(SHAPER, transmission=Transmission(FORCE)), AT_60, shaper().loading)
    balancing = pushed.forces.balancing
    assert balancing.force is not None and balancing.r is not None
    assert balancing.r[0] == pytest.approx(cmath.rect(0.12, pi / 3))
    assert balancing.force[0] == pytest.approx(cmath.rect(285.0376673 / 0.12, radians(150)), rel=DIGITS)
    assert balancing.moment[0] == pytest.approx(285.0376673, rel=DIGITS)


def test_a_gear_that_turns_clockwise_pushes_by_the_other_flank():
    run = shaper()
    back = Run(driven(run.mechanism, -10, 5), SHAPER, AT_60, run.loading).forces
    assert back.balancing.force is not None
    along = back.balancing.force[0] / abs(back.balancing.force[0])
    assert along in (pytest.approx(cmath.rect(1, radians(100))), pytest.approx(-cmath.rect(1, radians(100))))
    # Without the sense of rotation everything that inertia asks for is the same.
    assert back.balancing.moment[0] == pytest.approx(285.0376673, rel=DIGITS)


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


# The five two-lead groups, each hung on a crank whose end is at A, and on the frame

A, C = 0.10 + 0.05j, 0.45 - 0.02j
GUIDE_7, GUIDE_8 = Way(0.20 - 0.05j, cmath.rect(1, radians(15))), Way(0.30 + 0.10j, cmath.rect(1, radians(110)))
F2, F3, M2, M3 = 30 - 45j, -20 - 60j, 1.5, -0.8
CRANK = {"O": 0j, "A": abs(A)}


def group(links: Mapping[int, Mapping[str, complex]], slides: tuple[Slide, ...], sketch: linkages.Points) -> Run:
    """A group whose crank stands, before it is loaded."""
    links = {FRAME: {"O": 0j}, 1: CRANK, **links}
    mechanism = linkages.mechanism("group", links, slides, Drive(1, "O", "A", 0, 0), sketch, None)
    return Run(mechanism, machine(), np.array([cmath.phase(A)]))


def loaded(run: Run, S2: complex, S3: complex) -> Kinetostatics:
    loads = {(2, run.own(2, S2)): F2, (3, run.own(3, S3)): F3}
    return kinetostatics(run.road, run.machine, run.motion, steady(1, loads, {2: M2, 3: M3}), run.pairs)


def test_group_of_the_first_kind():
    frame = {FRAME: {"O": 0j, "C": C}}
    run = group({**frame, 2: {"A": 0j, "B": 0.30}, 3: {"C": 0j, "B": 0.28}}, (), {"B": 0.33 + 0.23j})
    B = 0.3356923697 + 0.2356047059j
    found = loaded(run, (A + B) / 2, (C + B) / 2)
    assert of(found, "12", "03") == printed(-5.753883824 + 36.1454255j, -4.246116176 + 68.8545745j)
    assert of(found, "32") == printed(-24.24611618 + 8.854574495j)


def test_group_of_the_second_kind():
    guide = Slide(3, FRAME, linkages.ALONG_X, GUIDE_7, "B", "")
    run = group({2: {"A": 0j, "B": 0.25}, 3: {"B": 0j}}, (guide,), {"B": 0.34 - 0.01j})
    B = 0.342217383 - 0.01189296708j
    found = loaded(run, (A + B) / 2, B + 0.01 + 0.02j)
    assert of(found, "12", "03") == printed(12.316786 + 21.71262077j, -22.316786 + 83.28737923j)
    assert of(found, "32") == printed(-42.316786 + 23.28737923j)
    assert arm(found, "0-3") == pytest.approx(0.01159750535, rel=1e-8)  # B is known to ten digits


def test_group_of_the_third_kind():
    slot = Slide(2, 3, linkages.ALONG_X, Way(-0.03j, 1 + 0j), "A", "CE")
    links = {FRAME: {"O": 0j, "C": C}, 2: {"A": 0j}, 3: {"C": 0j, "E": 0.5}}
    run = group(links, (slot,), {"E": C + cmath.rect(0.5, radians(173.5))})
    found = loaded(run, A + 0.005 + 0.01j, (A + C) / 2)
    assert of(found, "12", "03") == printed(-26.3858823 + 76.77717646j, 16.3858823 + 28.22282354j)
    assert of(found, "32") == printed(-3.614117701 - 31.77717646j)
    assert arm(found, "2-3") == pytest.approx(-0.03048586156, rel=DIGITS)


def test_group_of_the_fourth_kind():
    slides = (
        Slide(2, FRAME, Way(-0.02j, 1 + 0j), GUIDE_7, "B", ""),
        Slide(3, FRAME, Way(0.015j, 1 + 0j), GUIDE_8, "B", ""),
    )
    run = group({2: {"B": 0j}, 3: {"B": 0j}}, slides, {"B": 0.35 + 0.01j})
    B = 0.3485359592 + 0.01050561394j
    found = loaded(run, B + 0.02 + 0.01j, B - 0.01 + 0.03j)
    assert of(found, "02", "03") == printed(-26.52322858 + 98.98603662j, 16.52322858 + 6.013963375j)
    assert of(found, "32") == printed(-3.476771424 - 53.98603662j)
    arms = arm(found, "0-2"), arm(found, "0-3")
    assert arms == pytest.approx((-0.00292746086, 0.02274840214), rel=1e-8)  # B is known to ten digits


def test_group_of_the_fifth_kind():
    slides = (
        Slide(2, 3, linkages.ALONG_X, Way(0j, cmath.rect(1, radians(70))), "A", "NE"),
        Slide(3, FRAME, linkages.ALONG_X, GUIDE_7, "N", ""),
    )
    run = group({2: {"A": 0j}, 3: {"N": 0j, "E": 0.5}}, slides, {"N": 0.09 - 0.08j, "E": 0.57 + 0.05j})
    N = 0.08864058879 - 0.0798386643j
    found = loaded(run, A + 0.01, N + 0.03j)
    assert of(found, "12", "03") == printed(6.942988164 + 41.76790734j, -16.94298816 + 63.23209266j)
    assert of(found, "32") == printed(-36.94298816 + 3.232092661j)
    assert (arm(found, "2-3"), arm(found, "0-3")) == pytest.approx((-0.02831401803, 0.06084906616), rel=1e-8)


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


@pytest.mark.parametrize("omega", first([10.0, 0.0]))
def test_a_flat_parallelogram_is_statically_indeterminate(omega):
    run = Run(driven(linkages.parallelogram(0.1, 0.3), omega, 0), machine(TWO), np.radians([150, 180, 210]))
    assert gaps(run.forces) == {
        1: ("forces", "statically indeterminate"),
        2: ("positions", "beyond a change point"),
    }
    assert np.isnan(balancing_moment(*run.case)).tolist() == [False, True, True]
    assert np.isinf(energy_balance(*run.case).allowed).tolist() == [False, True, True]


@pytest.mark.parametrize(
    ("mechanism", "degrees", "gap"),
    several(
        [
            (linkages.slider_crank(0.1, 0.1), 90, ("forces", "statically indeterminate")),
            (linkages.slotted_link(0.2, 0.2, 0.5), 270, ("positions", "dead centre")),  # the slot has no one direction
        ],
        9,
    ),
)
def test_other_change_points(mechanism, degrees, gap):
    run = Run(mechanism, machine(TWO), np.radians([degrees - 30, degrees]))
    assert gaps(run.forces) == {1: gap}


# Coupler and rocker, 0.2 and 0.3 m, are in line at exactly 90 degrees: 0.3, 0.4 and 0.5 m make a right angle.
DOUBLE_ROCKER = linkages.four_bar(0.3, 0.2, 0.3, 0.4, sketch={"B": 0.15 + 0.2j})


@pytest.mark.parametrize("beside", first([0.0, 1e-15, 1e-13]))
def test_a_dead_centre_has_no_reactions(beside):
    run = Run(DOUBLE_ROCKER, machine(TWO), np.array([1.4, pi / 2 - beside]))
    assert gaps(run.forces) == {1: ("forces", "dead centre")}
    assert np.isnan(balancing_moment(*run.case)[1])


def test_reactions_grow_towards_a_dead_centre_as_the_sine_falls():
    standing = driven(DOUBLE_ROCKER, 0, 0)
    run = Run(standing, machine(), pi / 2 - np.array([1e-2, 1e-4, 1e-6, 1e-8]), steady(4, {(3, 0.3 + 0j): 100 + 0j}))
    forces = np.abs(run.forces.reactions["2-3"].force)
    assert run.forces.gaps == ()
    # Two links in line by a hair's breadth: the angle between them falls as the root of what the crank is short of.
    assert forces[1:] / forces[:-1] == pytest.approx(10, rel=0.1)


def test_forces_on_the_constructions_own_motion():
    drawn = study_of(DOUBLE_ROCKER, positions=[80, 90]).motion()
    road, loads = Analysis(DOUBLE_ROCKER), Loading((), ())
    by_analysis = Run(DOUBLE_ROCKER, machine(TWO), np.radians([80, 90]))
    found = kinetostatics(road, machine(TWO), drawn, loads, by_analysis.pairs)
    assert gaps(found) == {1: ("forces", "dead centre")}
    assert found.balancing.moment[0] == pytest.approx(by_analysis.forces.balancing.moment[0], rel=1e-11)


def test_positions_out_of_reach_stay_gaps():
    mechanism = linkages.four_bar(0.1, 0.3, 0.145, 0.35, sketch={"B": 0.3 + 0.14j})
    run = Run(mechanism, machine(TWO), TURN)
    assert gaps(run.forces) == {6: ("positions", "out of reach")}
    assert run.forces.gaps == run.motion.gaps


def test_a_gap_of_the_motion_has_no_forces_whatever_the_equations_say():
    run = Run(ROCKER, machine(), TURN, steady(12, {(3, 0j): 100 + 0j, (2, 0.2 + 0j): 50j}))
    told = Gap(4, float(TURN[4]), "velocities", "dead centre", "B", 0.0, "")
    run.motion = replace(run.motion, gaps=(told,))
    assert gaps(run.forces) == {4: ("velocities", "dead centre")}
    assert np.flatnonzero(np.isnan(balancing_moment(*run.case))).tolist() == [4]
    assert np.flatnonzero(np.isinf(energy_balance(*run.case).allowed)).tolist() == [4]


def test_too_near_a_dead_centre_the_energy_balance_does_not_judge():
    run = Run(DOUBLE_ROCKER, machine(TWO), pi / 2 - np.array([0.5, 0.1, 0.01, 0.001]))
    energy, moment = energy_balance(*run.case), run.forces.balancing.moment
    assert np.isfinite(moment).all()
    assert np.isfinite(energy.allowed).tolist() == [True, True, True, False] and np.isnan(energy.moment[3])
    assert (np.abs(energy.moment - moment) <= energy.allowed)[:3].all()
    assert (energy.allowed[:3] < 1e-2 * np.abs(moment[:3])).all()


def test_no_masses_and_no_loads_leave_nothing():
    found = Run(ROCKER, machine(gravity=0j), TURN).forces
    assert not found.gaps and not found.balancing.moment.any()
    assert not any(reaction.force.any() for reaction in found.reactions.values())
