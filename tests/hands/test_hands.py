"""Grading: a fair hand is accepted, a poor one refused, and between them as many vectors as the tolerance says."""

from __future__ import annotations

import pytest

from drawings.grading import allowance
from tests.gallery import SCENES
from tests.hands.trial import of_scene
from tests.parts import first
from tests.rows import over

SMALL = "four-masses"
FEW = [SMALL, "four-bar-balance", "four-cylinder-bank", "press", "shaper-loaded"]


@pytest.mark.rest
@over("scene", FEW)
def test_a_scene_is_graded_as_the_tolerance_says(scene: str) -> None:
    assert [fault for one in of_scene(scene) for fault in one.faults] == []


@pytest.mark.deep
@pytest.mark.parametrize("scene", [path.stem for path in SCENES])
def test_every_scene_is_graded_as_the_tolerance_says(scene: str) -> None:
    assert [fault for one in of_scene(scene) for fault in one.faults] == []


@pytest.mark.parametrize(
    "other", first([(0.5, "a fair hand is refused"), (1.3, "are out, foretold"), (9.0, "a poor hand is accepted")])
)
def test_another_tolerance_is_seen(monkeypatch: pytest.MonkeyPatch, other: tuple[float, str]) -> None:
    times, told = other
    monkeypatch.setattr(allowance, "DEVIATIONS", times * allowance.DEVIATIONS)
    assert any(told in fault for one in of_scene(SMALL) for fault in one.faults)
