"""The forces on the bench: their truth, the errors of both roads and of the checks, and what a hand makes of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from geometry.draughtsman import Draughtsman
from geometry.errors import DraftError
from geometry.meet import EPS
from plans.bench import roads as forces
from plans.bench.error import sizes, toll
from plans.bench.roads import (
    ForceGround,
    Ground,
    ground,
    prepared,
)
from plans.bench.truth import FORCE_KINDS, Truth, replay
from plans.linkage.quantities import notches
from plans.scene.scene import Scene, parse_scene
from tests.parts import some
from tests.plans.force_cases import WORKED
from tests.plans.scenes import scene

ROOT = Path(__file__).parent.parent.parent
SHAPER = ROOT / "tests/cases/forces/shaper.toml"
GOAL = 8.0  # eps kappa: as of the motion, whose accelerations are the inertia forces
ANALYSIS_GOAL = 64.0  # eps: of Newton's motion, and as much again of a linear system for the multipliers
LEVERS = 64.0  # eps of a hand's plain formulas, a chain of some sixty acts
SPRUNG = scene(
    springs=['between = ["O", { on = 4, point = "D" }]; stiffness = 900; free = 0.15'],
    forces=[
        'on = 3; point = "B"; against = "motion"; '
        "diagram = { travel = [0, 0.3, 1], force = [100, 400, 250] }; overrun = 0.05",
    ],
)


def scene(text: str = "") -> Scene:
    return parse_scene(SHAPER.read_text("utf-8").replace("[friction]", f"{text}[friction]"))


def stood(count: int, text: str = "") -> Ground:
    asked = scene(text)
    return ground(asked, count, 12, sizes(prepared(asked, 360)))


def force_ground(found: Ground) -> ForceGround:
    assert found.statics is not None
    return ForceGround(found.study, found.statics, found.truth, found.largest)


@pytest.mark.parametrize("text", ["", SPRUNG], ids=["resistance", "spring and diagram"])
@pytest.mark.parametrize("count", some([360, 12, 10_000], 3))
def test_all_forces_are_constructed_to_a_few_roundings(count: int, text: str) -> None:
    found = stood(count, text)
    kappa = float(notches(prepared(scene(), 360)).max())
    told = force_ground(found)
    error = told.judge(told.constructed())
    assert set(error.kinds) == set(FORCE_KINDS)
    assert 0 < error.largest <= GOAL * EPS * kappa
    if count == 360:
        assert told.judge(told.analysed()).largest <= ANALYSIS_GOAL * EPS * kappa


def test_the_truth_is_the_worked_example() -> None:
    """The book's six-link machine at 60 degrees, ten digits."""
    study = prepared(scene(), 6)
    truth = replay(study, [0], forces.statics_of(study)).truth()
    for key, (x, y) in ((key, WORKED["shaper"][key]) for key in ("0-3", "3-4", "4-5")):
        assert complex(truth.values["R", key].near[0]) == pytest.approx(complex(x, y), rel=1e-9)
    assert truth.values["M", "bal"].near[0] == pytest.approx(WORKED["shaper"]["moment"], rel=1e-9)


def test_a_planted_error_of_a_reaction_is_counted_and_named() -> None:
    told = force_ground(stood(12))
    found = told.constructed()
    spoilt = found.reactions["3-4"]._replace(force=found.reactions["3-4"].force + 1e-6 * told.largest["R"])
    error = told.judge(replace(found, reactions={**found.reactions, "3-4": spoilt}))
    assert error.worst == "R_3-4"
    assert error.largest == pytest.approx(1e-6)
    assert error.kinds["M"] < GOAL * EPS


def test_a_long_energy_balance_is_left_out_and_says_why() -> None:
    told = force_ground(stood(forces.ENERGY_MOST + 1))
    with pytest.raises(DraftError, match="energy balance"):
        told.energy()


def by_hand(slip: float, drawings: int = 400) -> tuple[Any, Truth, dict[str, float]]:
    study = prepared(scene(), 12)
    wanted = replay(study, [0, 4, 8], forces.statics_of(study))
    largest = sizes(prepared(scene(), 360))
    scales = {"positions": np.full(3, 0.002), "forces": np.full(3, largest["R"] / 150)}
    scales |= {"velocities": np.full(3, largest["v"] / 150), "accelerations": np.full(3, largest["a"] / 150)}
    truth = wanted.truth()
    return toll(wanted.only_forces, Draughtsman(slip, scales, drawings), truth, largest), truth, largest


def test_a_hand_that_does_not_slip_draws_the_forces() -> None:
    found, _, _ = by_hand(0.0, 1)
    assert set(found.kinds) == set(FORCE_KINDS)
    assert found.worst.max() <= LEVERS * EPS
