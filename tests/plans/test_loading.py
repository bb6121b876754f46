"""Loads over the positions: strokes, overruns, diagrams, against the motion, springs; by both roads' own motions."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.forces.loading import OutputStroke, loading, strokes
from plans.forces.reading.inventory import machine_of
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import extremes
from plans.model.kinetostatics import Loading
from plans.model.machine import Machine, Track
from plans.model.mechanism import Output
from plans.model.motion import Complexes, Extremes, Motion
from plans.scene.scene import parse_scene
from tests.plans.scenes import scene

SHAPER = scene(
    frame="O = [0, 0]; C = [0, -0.350]", links="OA A CB BD D", lengths="OA = 0.120; CB = 0.700; BD = 0.200",
    slides=['link = 2; along = "CB"', "link = 5; along = { through = [0, 0.3287856445], angle = 0 }"],
    sketch="B = [0.20, 0.32]; D = [0.40, 0.33]",
    drive='link = 1; speed = 10; acceleration = 5; start = "extreme"',
)  # fmt: skip
# The slider starts from x = 0.5 and is back there after a turn: H = 0.2, and at 60 degrees x = 0.05 + sqrt(0.1525).
ENGINE = scene(
    frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.1; AB = 0.4",
    slides=["link = 3; along = { through = [0, 0] }"], sketch="B = [0.5, 0]",
    drive="link = 1; speed = 10; positions = [0, 60, 90, 180, 270, 300]",
)  # fmt: skip
AT_60 = (0.5 - 0.05 - math.sqrt(0.1525)) / 0.2
AT_90 = (0.5 - math.sqrt(0.15)) / 0.2
# A crank-rocker; its rocker swings between directions that the law of cosines gives.
ROCKER = scene(
    frame="O = [0, 0]; C = [0.350, 0]", links="OA AB CB", lengths="OA = 0.1; AB = 0.4; CB = 0.3",
    sketch="B = [0.39, 0.30]", drive='link = 1; speed = 10; start = "extreme"',
)  # fmt: skip
ON_B, ON_D = '[[loads.forces]]\non = 3\npoint = "B"\n', '[[loads.forces]]\non = 5\npoint = "D"\n'
AGAINST = 'against = "motion"\n'


class Loaded(NamedTuple):
    machine: Machine
    motion: Motion
    strokes: dict[Track, OutputStroke]
    loading: Loading

    def force(self, k: int = 0) -> Complexes:
        return self.loading.forces[k].force


def loaded(text: str, by: str = "construction") -> Loaded:
    study = LinkageStudy(parse_scene(text))
    machine = machine_of(study.scene, study.mechanism)
    road = Analysis(study.mechanism, first=study.form.drive.first is not None)
    motion = study.motion() if by == "construction" else road.motion(study.turn.phi)

    def drawn(shown: Output) -> Extremes | None:
        found = extremes(study.sweep, shown)
        return found.extremes if found else None

    reached = strokes(machine, study.mechanism, study.output, drawn if by == "construction" else road.extremes)
    return Loaded(machine, motion, reached, loading(machine, motion, reached))


def test_an_extreme_is_the_same_position_to_the_rounding_of_its_angle() -> None:
    stroke = OutputStroke(1.0, 4.5, 1, (0.0, 0.2), 3)
    rounding = 16 * np.pi * np.finfo(float).eps
    beginning = np.array([1 - rounding, 1 + rounding, 1 + 2 * np.pi - rounding, 4.5 - 1e-6, 4.5 + rounding])
    assert stroke.working(beginning).tolist() == [True, True, True, True, False]
    back = OutputStroke(1.0, 4.5, -1, (0.0, 0.2), 3)
    assert back.working(np.array([1 + rounding, 0.9, 4.6, 4.5, 1.1])).tolist() == [True, True, True, False, False]


def test_a_crank_at_rest_is_about_to_move_with_its_acceleration() -> None:
    rest = ENGINE.replace("speed = 10", "speed = 0\nacceleration = 5") + ON_B + "value = 8\n" + AGAINST
    found = loaded(rest).force()
    assert [*found[1:3], *found[4:]] == pytest.approx([8, 8, -8, -8])
    assert loaded(rest.replace("acceleration = 5", "acceleration = 0")).force().tolist() == [0] * 6
