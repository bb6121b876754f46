"""What report and sheet say of loads: the working stroke in words, forces between two links at both their ends."""

from __future__ import annotations

import pytest

from plans.linkage.study import LinkageStudy
from plans.model.machine import ways
from plans.scene.scene import parse_scene
from tests.plans.test_loading import ENGINE, ROCKER


@pytest.mark.parametrize(
    ("text", "named"),
    [
        (ENGINE, ("left",)),
        (ENGINE.replace("[0, 0] }", "[0, 0], angle = 90 }").replace("B = [0.5, 0]", "B = [0, 0.5]"), ("down",)),
        (
            ENGINE.replace("[0, 0] }", "[0, 0], angle = 30 }").replace("B = [0.5, 0]", "B = [0.4, 0.3]"),
            ("left", "down"),
        ),
        (ENGINE.replace("[0, 0] }", "[0, 0], angle = 8 }"), ("left",)),
        (ROCKER, ("clockwise",)),
        (ROCKER + '[output]\npoint = "B"\n', ("clockwise", "right", "up")),
    ],
)
def test_the_way_of_a_stroke_in_words(text: str, named: tuple[str, ...]) -> None:
    """From the outer dead centre the slider goes in; the rocker's end above C from 0.3 to 0.5 from O, to the right."""
    study = LinkageStudy(parse_scene(text))
    low, high = (0.5, 0.3) if "AB" in text and "CB" not in text else (2.5, 1.5)
    assert ways(study.mechanism, study.output, low, high) == named
