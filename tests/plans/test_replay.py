"""The construction against its own record in 50 digits: errors counted in eps, and the bounds that are printed."""

from __future__ import annotations

import cmath
from fractions import Fraction
from functools import cache
from math import radians

import numpy as np
import pytest
from hypothesis import given

from geometry.meet import EPS
from geometry.precision import condition
from plans.linkage.plan import rate
from tests.parts import examples, some
from tests.plans import linkages
from tests.plans.chains import chains, studied
from tests.plans.replays import Replay, error, largest, rate_error
from tests.plans.studies import study_of

GOAL = 4.0  # eps of the largest in a row of results
ORDINARY = 10.0  # kappa: nearer to a dead centre the condition, not the arithmetic, decides
LOOSE = 1e3  # a bound that is so many times the error is of no use
COUPLER = {"S": cmath.rect(0.22, radians(25))}
ALL = {
    "four-bar": linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler=COUPLER),
    "slider-crank": linkages.slider_crank(0.06, 0.20, 0.02, rod={"S": 0.07}),
    "shaper": linkages.shaper(),
}
COUNTS = some((1000, 12, 36, 360, 100_000), 5)
SAMPLE = 24


def picked(count: int) -> list[int]:
    """Pick positions all over a turn, at random where there are many."""
    rng = np.random.default_rng(count)
    return sorted(rng.choice(count, SAMPLE, replace=False).tolist()) if count > SAMPLE else list(range(count))


@cache
def replayed(name: str, count: int) -> Replay:
    return Replay(study_of(ALL[name], 0, count))


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("name", ALL)
def test_every_row_is_exact_to_four_eps_however_many_positions(name, count):
    """Places, velocities and accelerations of the pins, each against the largest of its own row over the turn."""
    replay = replayed(name, count)
    kappas = [condition(mark) for mark in replay.marks if mark.sharpness is not None]
    assert max(float(np.max(kappa)) for kappa in kappas) <= ORDINARY
    pins = {key: mark for key, mark in replay.points.items() if not key[1].startswith("S")}
    for position in picked(count):
        true = replay.true(position, Fraction(360 * position, count))
        for key, mark in pins.items():
            assert error(mark, position, true[mark]) <= GOAL * EPS * largest([mark]), (key, position)


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("name", ALL)
def test_every_result_is_exact_to_four_eps_of_its_plan(name, count):
    """All points and all rates, against the largest vector of their plan; a rate counts by the vector it is read of."""
    replay = replayed(name, count)
    sizes = [largest([mark for key, mark in replay.points.items() if key[0] == order]) for order in range(3)]
    for position in picked(count):
        true = replay.true(position, Fraction(360 * position, count))
        for (order, letter), mark in replay.points.items():
            assert error(mark, position, true[mark]) <= GOAL * EPS * sizes[order], (order, letter, position)
        for (order, link), (arm, turning) in replay.rates.items():
            off = rate_error(arm, turning, rate(replay.plans[order], link), position, true)
            assert off * largest([arm]) <= GOAL * EPS * sizes[order], (order, link, position)


LIMIT = 78.58484226  # degrees: the double rocker's coupler and rocker in one line, cut after its last digit
NEAR_DEAD_CENTRES = {
    "double rocker": (linkages.four_bar(0.3, 0.2, 0.25, 0.4, sketch={"B": 0.45 + 0.25j}), LIMIT),
    "crank-rocker": (linkages.four_bar(0.1, 0.3, 0.15 + 1e-12, 0.35, sketch={"B": 0.3 + 0.14j}), 180),
    "slider-crank": (linkages.slider_crank(0.06, 0.20, 0.14 - 1e-10), 270),
    "parallelogram": (linkages.parallelogram(0.1, 0.3), 180),
    "slotted link": (linkages.slotted_link(0.2, 0.2, 0.5), 270),
    "tangent": (linkages.tangent_mechanism(0.15), 90),
}


@pytest.mark.parametrize("name", NEAR_DEAD_CENTRES)
def test_bounds_hold_beside_a_dead_centre(name):
    mechanism, centre = NEAR_DEAD_CENTRES[name]
    beside = [Fraction(str(centre)) - Fraction(1, 10**k) for k in range(2, 11)]
    study = study_of(mechanism, positions=[60, *(str(float(angle)) for angle in beside)])
    angles = [Fraction(str(angle)) for angle in study.form.drive.positions]
    replay = Replay(study)
    worst, shares = 0.0, []
    for position, angle in enumerate(angles):
        for mark, off, bound in replay.errors(position, angle):
            if mark.name != "φ" and not np.isnan(off):
                assert off <= bound or np.isnan(bound), (mark.subject, mark.name, float(angle))
                shares += [bound / off] if off else []
        worst = max(worst, *(float(np.ravel(condition(m))[-1]) for m in replay.marks if m.sharpness is not None))
    assert np.median(shares) < LOOSE
    assert worst > 1e4 or name == "slotted link"  # its direction is given by A alone, however near to C


@examples(4)
@given(chains())
def test_bounds_hold_for_every_mark_of_any_chain(chain):
    replay = Replay(studied(chain))
    for mark, off, bound in replay.errors(0, Fraction(chain.phi)):
        assert off <= bound or mark.name == "φ", (mark.subject, mark.name)
