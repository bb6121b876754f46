"""Relations and balances that the forces of any machine obey, by no second solver; differences of the largest force."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping
from dataclasses import replace
from math import cos, radians, sin

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from geometry.board import at
from plans.forces.friction import rate
from plans.forces.quantities import compare_forces
from plans.linkage.drafts import Drafts
from plans.linkage.quantities import compare
from plans.linkage.sweep import at_angles
from plans.model.kinetostatics import Kinetostatics
from plans.model.machine import FORCE, GEAR, MOMENT
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats, Motion
from plans.quantity import EQUILIBRIUM
from tests.plans import machine_alterations as altered
from tests.plans.chains import numbers
from tests.plans.derivatives import REACH, derivative
from tests.plans.loaded import Loaded, Told, loaded, push


def alike(
    old: Told, new: Told, force: Callable[[complex], complex] = lambda f: f, moment: float = 1.0, times: float = 1.0
) -> None:
    """See that forces are those of before, mapped, and moments `moment` times those; both may grow `times`."""
    assert old.forces.keys() == new.forces.keys()
    slack, turning = 2 * times * old.slack, 2 * abs(moment) * old.turning
    for joint, told in old.forces.items():
        assert abs(new.forces[joint] - force(told)) <= slack, joint
    for joint, twist in old.moments.items():
        assert abs(new.moments[joint] - moment * twist) <= turning, joint
    assert abs(new.driving - force(old.driving)) <= slack
    assert abs(new.balancing - moment * old.balancing) <= turning


@push
@given(loaded(), numbers(-180, 180))
def test_everything_turned_turns_the_forces_and_leaves_the_moments(one, angle):
    turn = cmath.exp(1j * radians(angle))
    alike(one.told, altered.turned(one, radians(angle)).told, lambda force: force * turn)


@push
@given(loaded())
def test_everything_mirrored_mirrors_the_forces_and_reverses_the_moments(one):
    alike(one.told, altered.mirrored(one).told, complex.conjugate, -1.0)


@push
@given(loaded(), st.sampled_from((2.0**-20, 0.37, 2.0**20)))
def test_a_machine_enlarged_bears_more_inertia_and_the_square_of_it_in_moments(one, times):
    alike(one.told, altered.enlarged(one, times, times, times**2).told, lambda f: times * f, times**2, times)


@push
@given(loaded(), st.sampled_from((0.01, 3.0)))
def test_a_crank_driven_faster_with_its_loads_multiplies_all_forces_by_the_square(one, times):
    alike(one.told, altered.quickened(one, times).told, lambda f: times**2 * f, times**2, times**2)


@push
@given(loaded(kinds=(GEAR,)))
def test_teeth_push_and_press_the_shafts_apart_whichever_way_the_moment_is(one):
    """By the base circle's arm, and into the tooth: towards the wheel's centre, of either flank and on both roads."""
    how, both = one.machine.transmission, compare_forces(one.statics, compare(one.study))
    for found in (both.construction, both.analysis):
        moment, (force,) = found.balancing.moment[0], found.balancing.force
        inward = -(force * cmath.rect(1.0, -how.at)).real
        assert abs(inward - abs(force) * sin(how.pressure)) <= one.told.slack
        assert abs(abs(moment) - abs(force) * how.radius * cos(how.pressure)) <= one.told.turning


@push
@given(loaded(kinds=(MOMENT, FORCE)))
def test_the_forces_of_two_load_cases_add_up(one):
    """Masses with one force, and all else alone: inertia counts once. Of a gear two cases may bear on two flanks."""
    some = replace(one.machine, forces=one.machine.forces[:1], moments=(), springs=())
    rest = replace(altered.massless(one.machine), forces=one.machine.forces[1:])
    parts = [replace(one, machine=its).told for its in (some, rest)]
    summed = Told(
        *({joint: sum(told[joint] for told in tables) for joint in tables[0]} for tables in _tables(parts)),
        sum(part.driving for part in parts),
        sum(part.balancing for part in parts),
        max(part.slack for part in parts),
        max(part.turning for part in parts),
    )
    alike(summed, one.told)


def _tables(parts: list[Told]) -> tuple[list[Mapping], ...]:
    return [part.forces for part in parts], [part.moments for part in parts]


@push
@given(loaded(kinds=(MOMENT, FORCE)))
def test_a_steady_crank_reversed_reverses_only_what_is_against_the_motion(one):
    """Inertia goes by the square of the speed; a load against the motion turns about with it."""
    one = replace(one, mechanism=altered.driven(one.mechanism, one.mechanism.drive.omega, 0.0))
    back = replace(one, mechanism=altered.driven(one.mechanism, -one.mechanism.drive.omega, 0.0))
    its = one.machine
    fixed = replace(
        its,
        forces=tuple(f for f in its.forces if f.direction is not None),
        moments=tuple(m for m in its.moments if not m.against),
    )
    alike(replace(one, machine=fixed).told, replace(back, machine=fixed).told)
    against = replace(
        altered.massless(its),
        forces=tuple(f._replace(direction=None) for f in its.forces),
        moments=tuple(m._replace(against=True) for m in its.moments),
        springs=(),
    )
    alike(replace(one, machine=against).told, replace(back, machine=against).told, lambda f: -f, -1.0)


@push
@given(loaded())
def test_links_groups_and_the_whole_are_in_balance_without_power_and_the_energy_changes_by_the_work(one):
    found = compare_forces(one.statics, compare(one.study)).findings
    sums = [single for single in found if single.plan == EQUILIBRIUM and single.name != "power"]
    assert len(sums) == 2 * (len(one.mechanism.links) - 1 + len(one.study.groups) + 1)
    power, energy = (next(single for single in found if single.name == name) for name in ("power", "M_bal energy"))
    for single in (*sums, power, energy):
        assert single.excess[0] <= 1, single.name


@push
@given(loaded())
def test_zhukovskys_lever_asks_of_the_drive_what_the_primary_link_does(one):
    lever = one.statics.drafts().plans.lever
    hung = 0.0 if lever is None else at(lever.moment.point, 0).real
    assert abs(hung - one.told.balancing) <= one.told.turning


@push
@given(loaded())
def test_a_slide_presses_square_to_its_line(one):
    """And its line of action passes the arm away: there it has the moment that is told about the point."""
    found, told = one.statics.forces, one.told
    for key, reaction in found.reactions.items():
        if reaction.along is None:
            continue
        assert abs((reaction.along.conj() * reaction.force).real[0]) <= told.slack, key
        arm, moment = reaction.arm[0], reaction.moment[0]
        if np.isfinite(arm):
            assert abs(cross(arm * reaction.along[0], reaction.force[0]) - moment) <= told.turning, key


# The whole machine: what acts on it from outside is the rate of its momentum


@push
@given(loaded())
def test_outer_forces_and_moments_are_the_rate_of_momentum_of_the_whole(one):
    """Sum F = d/dt sum m v_S, and about the shaft sum M = d/dt sum (r x m v_S + J omega), by differences."""
    drive = one.mechanism.drive
    motion = Drafts(one.study, at_angles(radians(one.phi) + REACH)).motion(1)
    momentum, spin = _momentum(one, motion)
    if not np.isfinite(momentum).all():
        return  # a dead centre is as near as the step
    force, moment = _outer(one)
    fastest = max(float(np.abs(point.v).max()) for point in motion.points.values())
    weight = sum((body.mass for body in one.machine.bodies.values()), 0.0)
    told = one.told
    for rows, sum_, slack, size in (
        (momentum, force, told.slack, weight * fastest),
        (spin, moment, told.turning, weight * fastest * one.size),
    ):
        slope, error = derivative(rows, one.margin * size)
        slope = drive.omega * slope + drive.epsilon / drive.omega * rows[len(REACH) // 2]
        assert abs(sum_ - slope) <= len(told.forces) * slack + abs(drive.omega) * error


def _momentum(one: Loaded, motion: Motion) -> tuple[Complexes, Floats]:
    """Give the momentum N*s, and its moment about the shaft, from places and velocities alone."""
    momentum, spin = np.zeros(len(motion.phi), dtype=complex), np.zeros(len(motion.phi))
    for body in one.machine.bodies.values():
        link = motion.links[body.link]
        place, v = _centre(one, motion, body.link, body.centre)
        momentum = momentum + body.mass * v
        spin = spin + body.mass * cross(place, v) + body.inertia * link.omega
    return momentum, spin


def _centre(one: Loaded, motion: Motion, link: int, own: complex) -> tuple[Complexes, Complexes]:
    """Give place and velocity of a point of a link."""
    name, first = next(iter(one.mechanism.links[link].points.items()))
    point, turned = motion.points[name], motion.links[link]
    arm = (own - first) * np.exp(1j * turned.angle)
    return point.r + arm, point.v + 1j * turned.omega * arm


def _outer(one: Loaded) -> tuple[complex, float]:
    """Sum up what acts from outside: reactions of the frame, loads, weights, what drives; moments about the shaft."""
    found, motion, loading = one.statics.forces, one.motion, one.loading
    outer = [
        (r.r[0], r.force[0], 0.0 if r.moment is None else r.moment[0])
        for r in found.reactions.values()
        if r.giver == FRAME
    ]
    outer += [(motion.points[load.point].r[0], load.force[0], 0.0) for load in loading.forces]
    outer += [(0j, 0j, twist.moment[0]) for twist in loading.moments]
    for body in one.machine.bodies.values():
        place, _ = _centre(one, motion, body.link, body.centre)
        outer.append((place[0], body.mass * one.machine.gravity, 0.0))
    outer.append(_driven(found))
    return sum(f for _, f, _ in outer), sum(float(cross(r, f)) + m for r, f, m in outer)


def _driven(found: Kinetostatics) -> tuple[complex, complex, float]:
    told = found.balancing
    if told.force is None or told.r is None:
        return 0j, 0j, told.moment[0]
    return told.r[0], told.force[0], 0.0


def cross(arm: Complexes, force: Complexes) -> Floats:
    return np.asarray((np.conj(arm) * force).imag)


@push
@given(loaded())
def test_the_slip_of_a_slide_is_how_fast_its_point_goes_along_the_line(one):
    """The line turns with its owner: what is told is the place along it, differentiated."""
    places = Drafts(one.study, at_angles(radians(one.phi) + REACH)).motion(0)
    if not np.isfinite([point.r for point in places.points.values()]).all():
        return  # a dead centre is as near as the step
    for slide in one.mechanism.slides:
        (reaction,) = (
            found
            for found in one.statics.forces.reactions.values()
            if {found.giver, found.taker} == {slide.slider, slide.owner} and found.along is not None
        )
        name = next(iter(one.mechanism.links[slide.owner].points))
        turn = 1.0 if slide.owner == FRAME else np.exp(1j * places.links[slide.owner].angle)
        along = np.conj(turn * slide.way(slide.owner).direction)
        travel = (along * (places.points[slide.point].r - places.points[name].r)).real
        slope, error = derivative(travel, one.margin * one.size)
        sense = 1.0 if reaction.taker == slide.slider else -1.0
        told = rate(one.mechanism, one.motion, reaction)[0]
        rounding = one.margin * max(abs(point.v[0]) for point in one.motion.points.values())
        assert abs(told - sense * one.mechanism.drive.omega * slope.real) <= (
            rounding + abs(one.mechanism.drive.omega) * error
        )
