"""Forces by both roads: equilibrium, gears, reduced moments, and where there are none."""

from __future__ import annotations

from decimal import Decimal
from math import pi

import numpy as np
import pytest

from geometry.board import Mark, at, behind
from geometry.meet import EPS
from geometry.precision import condition, errors
from geometry.replay import exact
from plans.analytic.power import balancing_moment, energy_balance, reduced_moment
from plans.forces.statics import Statics
from plans.model.kinetostatics import Kinetostatics
from plans.model.machine import Body
from tests.parts import first
from tests.plans import linkages
from tests.plans.force_cases import DYADS, ROADS, WORKED, of_road, statics_of, text_of, worked
from tests.plans.machines import Run, machine, steady
from tests.plans.studies import driven

SHAPER = WORKED["shaper"]
NAMES = (*DYADS, "shaper")


def printed(value: float, wanted: float) -> bool:
    """Tell whether a value is the printed one to the half of its last digit, of ten that are not zero."""
    number = Decimal(repr(wanted))
    last = max(number.adjusted() - 9, number.as_tuple().exponent) if wanted else -9
    return abs(value - wanted) <= 0.5000001 * 10.0**last


def near(value: complex, wanted: list[float]) -> bool:
    """Tell whether both parts of a vector are as printed."""
    return printed(value.real, wanted[0]) and printed(value.imag, wanted[1])


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", NAMES)
def test_reactions_and_arms_are_those_of_the_worked_example(name: str, road: str) -> None:
    case, (_, comparison) = WORKED[name], worked(name)
    reactions = of_road(comparison, road).reactions
    keys = [key for key in reactions if key in case]
    assert len(keys) >= 3
    for key in keys:
        assert near(complex(reactions[key].force[0]), case[key]), key
    for key, size in case.get("size", {}).items():
        assert printed(float(abs(reactions[key].force[0])), size), key
    for key, arm in case.get("arms", {}).items():
        found = reactions[key].arm
        assert found is not None
        # The arm runs along the slide as the scene names it; the example measured some the other way.
        assert printed(abs(float(found[0])), abs(arm)), key


@pytest.mark.parametrize("name", ["kind-1", "shaper"])
def test_the_parts_found_by_moments_are_those_of_the_worked_example(name: str) -> None:
    statics, _ = worked(name)
    board = statics.drafts().plans.plan.board
    for mark, value in WORKED[name]["parts"].items():
        assert near(at(board[mark].point, 0), value), mark


def test_the_inertia_couples_of_the_six_links_are_those_of_the_worked_example() -> None:
    board = worked("shaper")[0].drafts().plans.plan.board
    for mark, value in SHAPER["couples"].items():
        assert printed(at(board[mark].point, 0).real, value), mark


@pytest.mark.parametrize("road", ROADS)
def test_the_gear_force_and_the_balancing_moment_are_those_of_the_worked_example(road: str) -> None:
    told = of_road(worked("shaper")[1], road).balancing
    assert told.force is not None
    assert near(complex(told.force[0]), SHAPER["force"])
    assert printed(float(told.moment[0]), SHAPER["moment"])


def test_the_power_of_all_forces_but_the_drive_is_that_of_the_worked_example() -> None:
    statics, _ = worked("shaper")
    lever = statics.drafts().plans.lever
    assert lever is not None
    hung = sum(at(moment.point, 0).real for _, moment in lever.moments)
    assert printed(hung, SHAPER["power"])


# The construction in fifty digits


@pytest.mark.parametrize("name", ["kind-4", "kind-5"])
def test_the_moment_of_a_slide_stands_in_an_equation_with_those_it_holds(name: str) -> None:
    cuts = worked(name)[0].drafts().plans.plan.cuts
    found = [(cut, one.moment) for cut in cuts for one in cut.reactions if one.moment is not None]
    for cut, moment in found:
        loads, couples, about = next((e.loads, e.couples, e.about) for e in cut.equations if e.found is moment)
        arms = [complex(at(load.at.point, 0) - at(about.point, 0)) for load in loads]
        forces = [complex(at(load.force.point, 0)) for load in loads]
        terms = [(arm.conjugate() * force).imag for arm, force in zip(arms, forces, strict=True)]
        assert sum(terms) + sum(at(couple.moment.point, 0).real for couple in couples) + at(moment.point, 0).real == (
            pytest.approx(0.0, abs=1e-12 * sum(map(abs, terms)))
        )
    assert found


def marks_of(statics: Statics) -> list[Mark]:
    """Give all reactions, moments and what the drive gives."""
    plans = statics.drafts().plans
    found = [mark for cut in plans.plan.cuts for one in cut.reactions for mark in (one.force, one.moment)]
    lever = [] if plans.lever is None else [plans.lever.force, plans.lever.moment]
    return [mark for mark in (*found, plans.plan.drive, plans.plan.balancing, *lever) if mark is not None]


@pytest.mark.parametrize("name", [*NAMES, "turn"])
def test_every_force_is_as_exact_as_its_meetings_allow(name: str) -> None:
    """Eight eps times kappa of the largest force, of a moment times the longest arm; and within the bound carried."""
    whole = text_of("shaper", ("positions = [60]", 'start = "extreme"\npositions = 12'))
    statics = statics_of(whole) if name == "turn" else worked(name)[0]
    marks, count = marks_of(statics), len(statics.study.turn)
    bounds = errors(*marks)
    for position in range(0, count, 5):
        truth = exact(marks, position)
        force = max(abs(at(mark.point, position)) for mark in marks if not mark.is_moment)
        arm = max(abs(complex(point.r[position])) for point in statics.study.motion(0).points.values())
        for mark in marks:
            off = float(abs(at(mark.point, position) - truth[mark]))
            assert off <= 8 * EPS * worst(mark, position) * force * (arm if mark.is_moment else 1.0), mark.name
            assert off <= np.broadcast_to(bounds[mark].place, count)[position], mark.name


def worst(mark: Mark, position: int) -> float:
    """Give the product of the conditions of the meetings on the forces' own board, times that of the motion."""
    kappas = {"forces": 1.0, "motion": 1.0}
    for one in behind(mark):
        if one.sharpness is not None:
            kappa = float(np.broadcast_to(condition(one), max(np.size(condition(one)), position + 1))[position])
            board = "forces" if one.subject == "forces" else "motion"
            kappas[board] = max(kappas[board], kappa)
    return kappas["forces"] * kappas["motion"]


DIGITS = 5.1e-10  # values printed with ten digits: half a unit of the tenth of a value that begins with 1
AT_60 = np.radians([60.0])
# The six-link shaper with its gear


# The slider-crank of the reduced moments


ENGINE = linkages.slider_crank(0.1, 0.4)


@pytest.mark.parametrize("omega", [10.0, -10.0, 0.0])
def test_reduced_moment_of_the_slider_crank(omega):
    mechanism = driven(ENGINE, omega, 0.0)
    loads = steady(1, {(3, 0j): 1200, (2, 0.15): 4 * -9.81j})
    run = Run(mechanism, machine(), AT_60, loads)
    assert reduced_moment(run.road, run.motion, loads) == pytest.approx(-118.4552813, rel=DIGITS)
    for balance in (run.forces.balancing.moment, balancing_moment(*run.case), energy_balance(*run.case).moment):
        assert balance == pytest.approx(118.4552813, rel=DIGITS)


# Link by link: nine equations for the engine and for the crank-rocker

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
