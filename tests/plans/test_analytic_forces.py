"""Force analysis by the analytic road: gears, reduced moments, each link by itself, and where there are no forces."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from plans.analytic.energy import energy_balance
from plans.analytic.power import balancing_moment, reduced_moment
from plans.model.kinetostatics import Kinetostatics
from plans.model.machine import Body
from tests.parts import first
from tests.plans import linkages
from tests.plans.machines import Run, machine, steady
from tests.plans.studies import driven

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
