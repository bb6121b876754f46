"""Balancing by analysis: what must hold of any balanced mechanism (M7.4-M7.7)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from plans.analytic.balance.bank import harmonics
from plans.analytic.balance.mass_centre import bodies as solids
from plans.analytic.balance.mass_centre import mass_centre
from plans.analytic.kinematics import Analysis
from plans.model.balance.linkage import (
    EPS,
    FULL,
    PARTIAL,
    ROUNDING,
    SECTOR,
    SHARE,
    Place,
    Task,
)
from plans.model.machine import GEAR as GEARED
from plans.model.machine import Transmission
from tests import parts
from tests.plans import linkages
from tests.plans.balance_cases import bodies, engine


def printed(value: float, text: str) -> bool:
    """Tell whether a value, rounded to the digits of a text, is that text."""
    return f"{value:z.{len(text.partition('.')[2])}f}" == text


def test_an_offset_guide_is_balanced_as_one_through_the_shaft() -> None:
    moments = []
    for offset in (0.0, 0.07):
        case, task = engine(offset), Task(FULL, (Place(1, mass=28), Place(2, mass=16)))
        found = case.balance(task)
        moments.append([one.moment for one in found.counterweights])
        assert found.after.around.path <= 1e-14 * 0.4
    assert np.allclose(*moments, rtol=1e-15)


@pytest.mark.parametrize("place", [Place(1, radius=0.15), Place(1, at=-0.15), Place(1, shape=SECTOR)])
def test_masses_follow_from_static_moments(place) -> None:
    """The mass of the rod's counterweight weighs on the crank: either of them follows from its static moment."""
    found = engine(0.03).balance(Task(FULL, (place, place._replace(link=2))))
    first, second = found.counterweights
    assert np.isclose(second.moment, -(4 * 0.15 + 8 * 0.4), rtol=1e-15)
    assert np.isclose(first.moment, -(3 * 0.04 + (4 + 8 + second.mass) * 0.1), rtol=1e-15)
    for one in (first, second):
        if place.shape == SECTOR:
            sine, volume = np.sin(place.half_angle), place.half_angle * one.outer**2 * place.thickness
            assert np.isclose(one.mass, place.density * volume)
            assert np.isclose(one.distance, 2 * one.outer * sine / (3 * place.half_angle))
        else:
            assert np.isclose(one.distance, 0.15)
    assert found.after.around.path <= 1e-14 * 0.4


GEAR = Transmission(GEARED, 0.18, 3.6, 0.35)


PLACES = Place(1, mass=20), Place(1, radius=0.05), Place(1, shape=SECTOR)
DRIVES = (Transmission(), 0.0), (GEAR, 0.0), (GEAR, 300.0)


@pytest.mark.part
@pytest.mark.parametrize("place", PLACES if parts.whole else PLACES[1:2])
@pytest.mark.parametrize(("drive", "epsilon"), DRIVES if parts.whole else DRIVES[::2])
def test_the_best_share_is_least_of_all(place, drive, epsilon) -> None:
    """By trying a thousand shares, whose reaction is that of a full force analysis: none is better."""
    case = engine(0.02)
    links = replace(case.mechanism, drive=case.mechanism.drive._replace(epsilon=epsilon))
    case = case._replace(mechanism=links, machine=replace(case.machine, gravity=-9.81j, transmission=drive))
    found = case.balance(Task(SHARE, (place,)))
    for best, of in ((found.shares.least_force, "shaking"), (found.shares.least_reaction, "reaction")):
        shares = (max(best.share - 1e-4, 0.0), best.share, best.share + 1e-4)
        tried = [case.balance(Task(SHARE, (place,), share)) for share in shares]
        sizes = [one.after.shaking if of == "shaking" else one.after.reactions["0-1"] for one in tried]
        assert sizes[1] <= min(sizes) * (1 + ROUNDING * EPS)
        told = best.force if of == "shaking" else best.reaction
        assert np.isclose(told, sizes[1], rtol=1e-13)
        least = min(one.force if of == "shaking" else one.reaction for one in found.shares.curve)
        assert told <= least * (1 + ROUNDING * EPS)


def test_half_the_reciprocating_mass_is_best_of_a_very_long_rod() -> None:
    """With F = m r w^2 (1 - k) along the guide and k m r w^2 across it the largest is least where both are equal."""
    links = linkages.slider_crank(0.1, 1e5, omega=20.0, epsilon=0.0)
    case = engine()._replace(mechanism=links, machine=bodies((1, 3, 0), (3, 8, 0)))
    best = case.balance(Task(SHARE, (Place(1, mass=2),))).shares.least_force
    assert np.isclose(best.share, 0.5, atol=1e-5) and np.isclose(best.force, 8 * 0.1 * 400 / 2, rtol=1e-5)


def test_harmonics_of_the_engine() -> None:
    """Methods M7.8, all printed digits: the first and the second harmonic of the slider, against its closed series."""
    case, task = engine(), Task(PARTIAL, (Place(1, mass=2),))
    weights = case.balance(task).counterweights
    road = Analysis(case.mechanism)
    road.motion(np.zeros(1))
    solid = solids(case.machine, weights)
    found = harmonics(lambda phi: mass_centre(case.mechanism, solid, road.around(phi)).force, (1, 2, 4, 6))
    assert np.isclose(found[1].size, 9.5 * 0.1 * 400, rtol=1e-14)
    assert printed(found[2].size / (9.5 * 400 * 4), "0.006350626058")
    assert np.isclose(found[1].ahead, found[1].back, rtol=1e-13)
    assert found[1].slack <= 1e-14 * 500
    angles = np.linspace(0, 7, 5)
    assert np.allclose(
        sum(one.at(angles) for one in found.values()), -9.5 * road.around(angles).points["B"].a, rtol=1e-4
    )
