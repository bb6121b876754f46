"""Three balances that share no unknown, equilibrium of every link, and which balance sees what is wrong."""

from __future__ import annotations

from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.analytic.power import balancing_moment, borne, energy_balance
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.machine import FORCE, GEAR, Body, Machine, Transmission
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Complexes, Floats, Motion
from tests.parts import examples
from tests.plans import linkages
from tests.plans.chains import Chain, chains, numbers
from tests.plans.machines import SHAPER, Run, machine, pointed, steady

EPS = float(np.finfo(float).eps)
ROUNDINGS = 16.0
TURN = np.arange(12) * (pi / 6)

VECTORS = st.builds(complex, numbers(-1, 1), numbers(-1, 1))


GRAVITY = st.just(0j) | VECTORS.map(lambda share: 9.81 * share)


@st.composite
def runs(draw: st.DrawFn) -> Run:
    """Draw a mechanism with masses, loads and a drive, at its first position."""
    chain: Chain = draw(chains(most=3))
    mechanism = pointed(chain.mechanism)
    moving = [number for number in mechanism.links if number != FRAME]
    bodies = {
        link: Body(link, draw(numbers(0, 20)), draw(numbers(0, 3)), draw(VECTORS))
        for link in moving
        if draw(st.booleans())
    }
    drive = draw(st.sampled_from((Transmission(), Transmission(FORCE), Transmission(GEAR, 0.2, 2.5, 0.35))))
    forces = {(draw(st.sampled_from(moving)), draw(VECTORS)): 500 * draw(VECTORS) for _ in range(2)}
    loads = steady(1, forces, {draw(st.sampled_from(moving)): draw(numbers(-100, 100))})
    return Run(mechanism, machine(bodies, draw(GRAVITY), drive), np.array([radians(chain.phi)]), loads)


def whole(run: Run) -> Loading:
    masses = borne(run.mechanism, run.machine, run.motion)
    return Loading(run.loading.forces + masses.forces, run.loading.moments + masses.moments)


def largest(run: Run, found: Kinetostatics) -> Floats:
    """Give the largest force N of all, with moments brought to forces by the mechanism's size."""
    size, loads = run.road.constraints.size, whole(run)
    sizes = [np.abs(load.force) for load in loads.forces] + [np.abs(twist.moment) / size for twist in loads.moments]
    for reaction in found.reactions.values():
        sizes.append(np.abs(reaction.force))
        if reaction.moment is not None:
            sizes.append(np.abs(reaction.moment) / size)
    return np.max([*sizes, np.abs(found.balancing.moment) / size], axis=0)


def torque(r: Complexes, force: Complexes) -> Floats:
    return np.asarray((r.conj() * force).imag)


def left_over(run: Run, found: Kinetostatics) -> dict[int, tuple[Complexes, Floats]]:
    """Add up force and moment about the datum on every moving link: loads, inertia, reactions and the drive."""
    count = len(run.motion.phi)
    rest = {link: (np.zeros(count, complex), np.zeros(count)) for link in run.mechanism.links}

    def add(link: int, force: Complexes, moment: Floats) -> None:
        rest[link] = rest[link][0] + force, rest[link][1] + moment

    for load in whole(run).forces:
        point, own = next(iter(run.mechanism.links[load.link].points.items()))
        r = run.motion.points[point].r + (load.at - own) * np.exp(1j * run.motion.links[load.link].angle)
        add(load.link, load.force, torque(r, load.force))
    for twist in whole(run).moments:
        add(twist.link, np.zeros(count, complex), twist.moment)
    for reaction in found.reactions.values():
        moment = torque(reaction.r, reaction.force) + (0 if reaction.moment is None else reaction.moment)
        add(reaction.taker, reaction.force, moment)
        add(reaction.giver, -reaction.force, -moment)
    drive, crank = found.balancing, run.mechanism.drive.link
    if drive.force is None or drive.r is None:
        add(crank, np.zeros(count, complex), drive.moment)
    else:
        add(crank, drive.force, torque(drive.r, drive.force))
    return {link: sums for link, sums in rest.items() if link != FRAME}


@examples(3, 50)
@given(run=runs())
def test_every_link_is_in_equilibrium_and_slides_push_square_to_their_line(run):
    found = run.forces
    allowed = ROUNDINGS * EPS * largest(run, found) * len(run.mechanism.links)
    reach = run.road.constraints.size + np.max([np.abs(point.r) for point in run.motion.points.values()], axis=0)
    for link, (force, moment) in left_over(run, found).items():
        assert (np.abs(force) <= allowed).all(), link
        assert (np.abs(moment) <= allowed * reach).all(), link
    for key, reaction in run.forces.reactions.items():
        if reaction.along is not None:
            along = (reaction.along.conj() * reaction.force).real
            assert np.abs(along) <= 4 * EPS * np.abs(reaction.force), key


@examples(3, 50)
@given(run=runs())
def test_three_balances_agree(run):
    found, kappa = run.forces, run.road.conditions(run.motion)
    far = 1 + np.abs(run.road.poses(run.motion)).max()  # no arm is longer, in units of the mechanism's size
    spins = [abs(row[0]) for motion in run.motion.links.values() if (row := motion.omega) is not None]
    share = run.road.constraints.size * far * max(spins) / abs(run.mechanism.drive.omega)
    solved, by_power = found.balancing.moment, balancing_moment(*run.case)
    allowed = ROUNDINGS * EPS * kappa**2 * largest(run, found) * share
    assert np.abs(solved - by_power) <= allowed
    energy = energy_balance(*run.case)
    # The energy balance knows no accelerations; theirs are known to kappa cubed.
    lively = [np.abs(load.force).max() for load in borne(run.mechanism, run.machine, run.motion).forces]
    inertial = ROUNDINGS * EPS * kappa**3 * sum(lively) * share
    assert np.isfinite(energy.allowed) and np.abs(solved - energy.moment) <= energy.allowed + allowed + inertial


# Faults planted in inertia, loads and levers: which balance sees them


def shaper(forces: dict[tuple[int, complex], complex] | None = None, of: Machine = SHAPER) -> Run:
    loads = steady(12, {(5, 0j): 1500 + 0j} if forces is None else forces, {3: 20.0})
    return Run(linkages.shaper(), of, TURN + 0.2, loads)


def seen(run: Run) -> tuple[bool, bool]:
    """Tell whether the balances of power and of energy see that something is wrong with the moment solved for."""
    moment, energy = run.forces.balancing.moment, energy_balance(*run.case)
    by_power = np.abs(moment - balancing_moment(*run.case)) > 1e-9 * np.abs(moment).max()
    return bool(by_power.any()), bool((np.abs(moment - energy.moment) > energy.allowed).any())


def test_nothing_wrong_is_seen_where_nothing_is():
    assert seen(shaper()) == (False, False)
    assert (energy_balance(*shaper().case).allowed < 1e-5 * 285).all()


def _about_the_hinge(mechanism: Mechanism, its: Machine, motion: Motion) -> Loading:
    """Take the moments of inertia about the links' origins, with the mass counted twice."""
    bodies = {n: b._replace(inertia=b.inertia + b.mass * abs(b.centre) ** 2) for n, b in its.bodies.items()}
    return borne(mechanism, replace(its, bodies=bodies), motion)


def _upside_down(mechanism: Mechanism, its: Machine, motion: Motion) -> Loading:
    return borne(mechanism, replace(its, gravity=-its.gravity), motion)


def _at_the_origin(mechanism: Mechanism, its: Machine, motion: Motion) -> Loading:
    bodies = {n: b._replace(centre=0j) for n, b in its.bodies.items()}
    return borne(mechanism, replace(its, bodies=bodies), motion)


def _turned_the_wrong_way(mechanism: Mechanism, its: Machine, motion: Motion) -> Loading:
    right = borne(mechanism, its, motion)
    return Loading(right.forces, tuple(twist._replace(moment=-twist.moment) for twist in right.moments))


@pytest.mark.parametrize("fault", [_about_the_hinge, _upside_down, _at_the_origin, _turned_the_wrong_way])
def test_the_energy_balance_alone_sees_wrong_inertia(monkeypatch, fault):
    for module in ("kinetostatics", "power"):
        monkeypatch.setattr(f"plans.analytic.{module}.borne", fault)
    assert seen(shaper()) == (False, True)
