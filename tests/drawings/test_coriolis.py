"""The small figure of the Coriolis rule: the slip turned a quarter with the guide, held against the analysis."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from drawings.linkage.coriolis import QuarterTurn, quarter_turn
from plans.analytic.kinematics import solve
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene

SHAPER = Path(__file__).parents[2] / "drawings/gallery/shaper.toml"


def shaper(speed: str) -> LinkageStudy:
    text = SHAPER.read_text("utf-8")
    (given,) = (line for line in text.splitlines() if line.startswith("speed"))
    return LinkageStudy(parse_scene(text.replace(given, f'speed = "{speed}"')))


def rules(study: LinkageStudy, k: int) -> list[QuarterTurn]:
    marks = study.drafts().accelerations.board
    return [found for mark in marks if (found := quarter_turn(mark, k)) is not None]


@pytest.mark.parametrize("speed", ["10 rad/s", "-10 rad/s"])
def test_the_rule_shows_the_slip_and_the_acceleration_that_the_analysis_gives(speed: str) -> None:
    """Both senses of the crank, the slotted link going and coming: all four sign cases of omega and of the slip."""
    study = shaper(speed)
    motion = solve(study.mechanism, study.turn.phi, first=False)
    pin, pivot, omega = motion.points["A"], motion.points["C"], motion.links[3].omega
    assert pin.v is not None and pivot.v is not None and omega is not None
    under = pivot.v + 1j * omega * (pin.r - pivot.r)  # the velocity of the point of link 3 under the pin
    cases = set()
    for k in range(len(study.turn)):
        slip = under[k] - pin.v[k]
        along = (np.conj(pin.r[k] - pivot.r[k]) * slip).real
        for shown in rules(study, k):
            if shown.size < 1e-9:  # m/s2: the slot stands still, and the sheet shows nothing
                continue
            assert abs(shown.slip - slip / abs(slip)) < 1e-9
            acceleration = 2j * omega[k] * slip
            assert abs(shown.result - acceleration / abs(acceleration)) < 1e-9
            cases.add((omega[k] > 0, along > 0))
    assert len(cases) == 4
