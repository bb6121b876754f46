"""The draughtsman of the bench: what a hand that slips makes of a construction, by what is known of chance."""

from __future__ import annotations

import cmath
from math import radians, sqrt

import numpy as np
import pytest

from geometry import draughtsman, precision
from geometry.draughtsman import Draughtsman
from geometry.hand_error import EDGE
from geometry.meet import EPS
from plans.bench.error import Toll, drawn, sizes, toll
from plans.bench.truth import replay
from plans.model.mechanism import Mechanism
from tests.parts import some
from tests.plans import linkages
from tests.plans.studies import study_of

COUPLER = {"E": cmath.rect(0.22, radians(25))}
BAR = linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler=COUPLER)
ALL = {
    "RRR": BAR,
    "RRP": linkages.slider_crank(0.06, 0.20, 0.02, rod={"S": 0.07}),
    "RPR, RRP": linkages.shaper(),
    "RPR": linkages.slotted_link(0.1, 0.35, 0.5),
    "PRP": linkages.tangent_mechanism(0.15),
    "RPP": linkages.scotch_yoke(0.1),
}
POSITIONS = (1, 4, 8)
MU = 0.002  # m a mm
NO_SLIP = 64.0  # eps: formulas of the trade without care, a chain of some thirty acts


def taken(mechanism: Mechanism, slip: float, zoom: float = 1.0, drawings: int = 400) -> Toll:
    """Draw three positions by hand, scales filling 150 mm; `zoom` makes all figures larger."""
    wanted = replay(study_of(mechanism), POSITIONS)
    largest = sizes(study_of(mechanism, 0, 360))
    ones = np.ones(len(POSITIONS)) / zoom
    scales = {
        "positions": MU * ones,
        "velocities": largest["v"] / 150 * ones,
        "accelerations": largest["a"] / 150 * ones,
    }
    return toll(wanted, Draughtsman(slip, scales, drawings), wanted.truth(), largest)


@pytest.mark.parametrize("name", ALL)
def test_a_hand_that_does_not_slip_draws_the_construction(name: str) -> None:
    assert taken(ALL[name], 0.0, drawings=1).worst.max() <= NO_SLIP * EPS


@pytest.mark.parametrize("name", some(ALL, 3))
def test_twice_the_slip_is_about_twice_the_error(name: str) -> None:
    one, two = taken(ALL[name], 0.1), taken(ALL[name], 0.2)
    assert np.median(two.worst) / np.median(one.worst) == pytest.approx(2.0, rel=0.05)
    assert np.quantile(two.worst, 0.95) / np.quantile(one.worst, 0.95) == pytest.approx(2.0, rel=0.15)


def test_the_crank_pin_is_out_by_the_compass_and_by_the_prick() -> None:
    """Evenly within the slip along the crank, in x and in y: a third of its square each, together a whole one."""
    wanted = replay(study_of(BAR), POSITIONS)
    scales = {plan: np.full(3, MU) for plan in ("positions", "velocities", "accelerations")}
    pin = drawn(wanted, Draughtsman(0.2, scales, 4000))["r", "A"]
    off = np.abs(pin - wanted.truth().values["r", "A"].near) / MU
    assert off.max() <= 0.2 * (1 + sqrt(2))
    assert sqrt(np.mean(off**2)) == pytest.approx(0.2, rel=0.02)


def test_a_notch_that_misses_is_an_infinite_error_not_a_lost_drawing() -> None:
    """Just out of a dead centre's reach: some hands' arcs miss each other, and those drawings count as the worst."""
    near = linkages.four_bar(0.1, 0.3, 0.1505, 0.35, sketch={"B": 0.3 + 0.14j})
    study = study_of(near, positions=[179])
    wanted = replay(study, [0])
    scales = {plan: np.full(1, MU) for plan in ("positions", "velocities", "accelerations")}
    found = toll(wanted, Draughtsman(0.5, scales), wanted.truth(), sizes(study_of(near, 0, 360)))
    missed = np.isinf(found.worst)
    assert 0 < missed.sum() < len(missed)


def test_a_vector_longer_than_the_set_square_is_carried_worse() -> None:
    hand = Draughtsman(0.2, {"positions": np.full(2, MU)}, 2000)
    off = np.abs(hand.carried("positions", np.array([0.5 * EDGE, 3j * EDGE]) * MU)) / MU
    assert off[:, 0].max() == pytest.approx(0.2 * sqrt(2), rel=0.05)
    assert off[:, 1].max() == pytest.approx(3 * 0.2 * sqrt(2), rel=0.05)


def test_the_hand_knows_every_verb_that_precision_knows() -> None:
    assert set(draughtsman._RULES) | {"given"} == set(precision._RULES)
