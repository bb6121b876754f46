"""The bench of a cam's profile: its orders and rows. No test asks how long anything takes."""

from __future__ import annotations

import math

import pytest

from plans.bench.cams import ENVELOPE, INVERSION, OFFSET, Judged
from plans.cam.course import Course
from tests.plans.textbook_cams import cam, offset_sizes

ROLLER = 0.013


def error(way: str, count: int, sense: int = 1) -> float:
    roads = Judged(Course(cam(end="roller", sense=sense)), offset_sizes(), ROLLER, count).roads()
    return next(road.judged[way](road.run()).kinds["Q"] for road in roads if way in road.judged)


@pytest.mark.parametrize("way", [INVERSION, OFFSET])
def test_chords_are_of_the_second_order(way):
    """Shapely's offset is of the polygon that it is given: no better than its chords."""
    errors = [error(way, count) for count in (90, 720)]
    assert math.log(errors[0] / errors[1], 8) == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize("sense", [1, -1])
def test_the_envelope_is_exact(sense):
    assert error(ENVELOPE, 72, sense) < 2e-15
    assert error(OFFSET, 720, sense) < 1e-4
