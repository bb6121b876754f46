"""Where the drawn course of an output is greatest or least between two positions."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from drawings.diagrams.rows import GREATEST, peaks, rows_of
from plans.scene.scene import parse_scene
from plans.study import Study

SHAPER = Path(__file__).parents[2] / "drawings/gallery/shaper.toml"


def test_the_end_of_the_stroke_is_marked_where_the_slotted_link_is_square_to_the_crank() -> None:
    """OA = 120, OC = 350 mm: the working stroke takes half a turn and the swing, 2 asin OA/OC."""
    diagrams = Study(parse_scene(SHAPER.read_text(encoding="utf-8")))["diagrams"]
    travel, *rates = rows_of(diagrams)
    (peak,) = peaks(travel, diagrams.axis)
    assert peak.name == GREATEST
    assert math.degrees(peak.turned) == pytest.approx(180 + 2 * math.degrees(math.asin(120 / 350)), abs=0.05)
    for row in rates:
        for found in peaks(row, diagrams.axis):
            curve = row.results[0]
            assert found.value in (curve.y.max(), curve.y.min())
            assert abs(curve.x - found.turned).min() < math.radians(1.0)
