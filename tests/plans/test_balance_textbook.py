"""Balances of the textbook by construction and by analysis, and what holds of any balanced mechanism (M7.4-M7.7)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from plans.analytic.balance.bank import harmonics
from plans.analytic.balance.mass_centre import bodies as solids
from plans.analytic.balance.mass_centre import mass_centre
from plans.analytic.kinematics import Analysis
from plans.balance.study import BalanceStudy
from plans.model.balance.linkage import EPS, FULL, PARTIAL, ROUNDING, SECTOR, SHARE, BalanceTask, Site
from plans.model.machine import GEAR as GEARED
from plans.model.machine import Transmission
from tests import parts
from tests.plans import linkages
from tests.plans.balance_cases import bodies, engine
from tests.plans.balanced import ENGINE, FOUR_BAR, SHAPER, SIX_LINK, asked, study

DIGITS = 5e-10  # of values that are printed with ten digits
VARIANT_A = asked(FULL, Site(1, mass=9), Site(2, mass=6))
VARIANT_B = asked(FULL, Site(1, mass=5), Site(3, mass=8))
ENGINE_FULL = asked(FULL, Site(1, mass=28), Site(2, mass=16))
SHAPER_FULL = asked(FULL, Site(1, mass=6), Site(3, mass=160), Site(4, mass=30))


def moments(its: BalanceStudy) -> dict[int, complex]:
    """Give by link the static moment kg*m of link and counterweight about the point that it counts from."""
    bodies, links = its.loaded.bodies, its.linkage.mechanism.links
    found = {}
    for one in its.counterweights:
        body = bodies[one.link]
        found[one.link] = body.mass * (body.centre - links[one.link].points[one.begin])
    return found


def test_main_points_of_the_four_bar() -> None:
    its = study(FOUR_BAR)
    assert [its.points().vectors[link].real for link in (1, 2, 3)] == pytest.approx(
        [0.08909090909, 0.2472727273, 0.05454545455], rel=DIGITS
    )
    centre = its.before.centre
    assert centre.r[0] == pytest.approx(0.2474528462 + 0.1533593396j, rel=DIGITS)
    assert centre.a[0] == pytest.approx(-6.266385528 - 2.252402396j, rel=DIGITS)
    assert centre.force[0] == pytest.approx(68.9302408 + 24.77642635j, rel=DIGITS)


def test_main_points_of_the_six_link() -> None:
    its = study(SIX_LINK)
    vectors = its.points().vectors
    told = [0.09368421053, 0.3115789474, 0.1157894737, 0.1263157895, 0.006315789474]
    assert [vectors[link].real for link in range(1, 6)] == pytest.approx(told, rel=DIGITS)
    assert its.before.centre.r[0] == pytest.approx(0.4288752518 + 0.130838553j, rel=DIGITS)


def test_four_bar_with_counterweights_on_crank_and_coupler() -> None:
    its = study(FOUR_BAR, VARIANT_A)
    found = {one.link: one for one in its.counterweights}
    assert moments(its) == pytest.approx({1: -1.3, 2: -1.2}, rel=DIGITS)
    assert found[2].centre == pytest.approx(-0.32, rel=DIGITS)
    assert found[1].centre == pytest.approx(-0.1533333333, rel=DIGITS)
    assert its.loaded.bodies[2].centre == pytest.approx(-0.12, rel=DIGITS)
    assert its.after is not None
    assert its.after.centre.r == pytest.approx(0.02692307692, rel=DIGITS)


def test_four_bar_with_counterweights_on_crank_and_rocker() -> None:
    its = study(FOUR_BAR, VARIANT_B)
    found = {one.link: one for one in its.counterweights}
    assert found[3].begin == "C"
    assert found[3].centre == pytest.approx(0.48, rel=DIGITS)
    assert its.loaded.bodies[3].mass * its.loaded.bodies[3].centre == pytest.approx(4.44, rel=DIGITS)
    assert moments(its)[1] == pytest.approx(-0.22, rel=DIGITS)
    assert found[1].centre == pytest.approx(-0.06, rel=DIGITS)
    assert its.after is not None
    assert its.after.centre.r == pytest.approx(0.2158333333, rel=DIGITS)


def test_slider_crank_balanced_in_part() -> None:
    its = study(ENGINE, asked(PARTIAL, Site(1, mass=2)))
    (one,) = its.counterweights
    assert moments(its) == pytest.approx({1: -0.25}, rel=DIGITS)
    assert one.centre == pytest.approx(-0.185, rel=DIGITS)
    assert its.after is not None
    b = its.linkage.motion(0).points["B"].r
    assert its.after.centre.r == pytest.approx(0.5588235294 * b, rel=DIGITS, abs=1e-16)
    assert its.left == pytest.approx({"B": 0.5588235294 * 17}, rel=DIGITS)
    assert its.after.shaking == pytest.approx(475, rel=DIGITS)


def test_slider_crank_balanced_in_part_by_the_rod() -> None:
    """The one counterweight of (8.9) may stand on AB as well: h1/OA = h2/AB with its mass behind the pin."""
    its = study(ENGINE, asked(PARTIAL, Site(2, mass=10)))
    kappa = (3 * 0.04 / 0.1 + 4 + 10 + 8) / 25  # h1/OA, where the counterweight's place does not enter
    assert moments(its) == pytest.approx({2: kappa * 25 * 0.4 - 8 * 0.4}, rel=DIGITS)
    assert its.after is not None
    assert its.after.centre.r == pytest.approx(kappa * its.linkage.motion(0).points["B"].r, rel=DIGITS, abs=1e-16)
    assert its.left == pytest.approx({"B": kappa * 25}, rel=DIGITS)


def test_slider_crank_balanced_in_full() -> None:
    its = study(ENGINE, ENGINE_FULL)
    assert [one.centre for one in its.counterweights] == pytest.approx([-0.1042857143, -0.2375], rel=DIGITS)
    assert its.left == {}


def test_slotted_link_balanced_in_parts_and_in_full() -> None:
    alone = SHAPER.partition("4 = {{ mass")[0]  # link 3 without what it drives
    its = study(alone, asked(FULL, Site(1, mass=6), Site(3, mass=160)))
    assert [one.centre for one in its.counterweights] == pytest.approx([-0.06333333333, -0.0225], rel=DIGITS)
    whole = study(SHAPER, SHAPER_FULL)
    told = [-0.06333333333, -0.254375, -0.1433333333]
    assert [one.centre for one in whole.counterweights] == pytest.approx(told, rel=DIGITS)
    assert whole.after is not None
    assert whole.after.centre.r == pytest.approx(-0.3329809725j, rel=DIGITS)


@pytest.mark.parametrize(
    ("text", "task", "longest"),
    [(FOUR_BAR, VARIANT_A, 0.4), (FOUR_BAR, VARIANT_B, 0.4), (ENGINE, ENGINE_FULL, 0.4), (SHAPER, SHAPER_FULL, 0.7)],
)
def test_balanced_mass_centre_rests(text: str, task: BalanceTask, longest: float) -> None:
    its = study(text, task, positions=3600)
    assert its.after is not None
    r = its.after.centre.r
    assert float(np.abs(r - r[0]).max()) < 1e-14 * longest


def printed(value: float, text: str) -> bool:
    """Tell whether a value, rounded to the digits of a text, is that text."""
    return f"{value:z.{len(text.partition('.')[2])}f}" == text


def test_an_offset_guide_is_balanced_as_one_through_the_shaft() -> None:
    moments = []
    for offset in (0.0, 0.07):
        case, task = engine(offset), BalanceTask(FULL, (Site(1, mass=28), Site(2, mass=16)))
        found = case.balance(task)
        moments.append([one.moment for one in found.counterweights])
        assert found.after.around.path <= 1e-14 * 0.4
    assert np.allclose(*moments, rtol=1e-15)


@pytest.mark.parametrize("place", [Site(1, radius=0.15), Site(1, at=-0.15), Site(1, shape=SECTOR)])
def test_masses_follow_from_static_moments(place) -> None:
    """The mass of the rod's counterweight weighs on the crank: either of them follows from its static moment."""
    found = engine(0.03).balance(BalanceTask(FULL, (place, place._replace(link=2))))
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


PLACES = Site(1, mass=20), Site(1, radius=0.05), Site(1, shape=SECTOR)
DRIVES = (Transmission(), 0.0), (GEAR, 0.0), (GEAR, 300.0)


@pytest.mark.part
@pytest.mark.parametrize("place", PLACES if parts.whole else PLACES[1:2])
@pytest.mark.parametrize(("drive", "epsilon"), DRIVES if parts.whole else DRIVES[::2])
def test_the_best_share_is_least_of_all(place, drive, epsilon) -> None:
    """By trying a thousand shares, whose reaction is that of a full force analysis: none is better."""
    case = engine(0.02)
    links = replace(case.mechanism, drive=case.mechanism.drive._replace(epsilon=epsilon))
    case = case._replace(mechanism=links, machine=replace(case.machine, gravity=-9.81j, transmission=drive))
    found = case.balance(BalanceTask(SHARE, (place,)))
    for best, of in ((found.shares.least_force, "shaking"), (found.shares.least_reaction, "reaction")):
        shares = (max(best.share - 1e-4, 0.0), best.share, best.share + 1e-4)
        tried = [case.balance(BalanceTask(SHARE, (place,), share)) for share in shares]
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
    best = case.balance(BalanceTask(SHARE, (Site(1, mass=2),))).shares.least_force
    assert np.isclose(best.share, 0.5, atol=1e-5) and np.isclose(best.force, 8 * 0.1 * 400 / 2, rtol=1e-5)


def test_harmonics_of_the_engine() -> None:
    """Methods M7.8, all printed digits: the first and the second harmonic of the slider, against its closed series."""
    case, task = engine(), BalanceTask(PARTIAL, (Site(1, mass=2),))
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
