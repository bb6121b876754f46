"""The sheet of a cyclogram: its pins and bars, and its report by both roads."""

from __future__ import annotations

import re

import pytest

from drawings.cyclogram import report
from drawings.cyclogram.sheet import leaves
from drawings.paper.strokes import Leaf
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.held import faults_on, measured
from tests.plans.cyclograms import scene_text
from tests.plans.test_cyclogram import CAM

TOLD = "overrun = 0.1\nbreaks = [0.6, 0.75]\n"


def drawn(name: str, told: str = TOLD, language: str = "en") -> tuple[Study, tuple[Leaf, ...]]:
    """Lay out the sheets of a gallery's linkage with a cyclogram."""
    text = re.sub(r"^\[sheet\]", f'[sheet]\nlanguage = "{language}"', scene_text(name, told), flags=re.MULTILINE)
    text = re.sub(r'^language = "(\w+)"\n(?=(?:.*\n)*?language)', "", text, flags=re.MULTILINE)
    study = Study(parse_scene(text))
    return study, leaves(study)


@pytest.fixture(scope="module")
def shaper() -> tuple[Study, Leaf]:
    study, (leaf,) = drawn("shaper", TOLD + CAM)
    return study, leaf


def test_every_angle_is_measured_back(shaper: tuple[Study, Leaf]) -> None:
    """Eight crank pins beside the one in full lines, and a line for every span, two for the one that is cut."""
    study, leaf = shaper
    assert faults_on(study, "cyclogram", [leaf]) == []
    marks = measured(leaf)
    pins = {one.name for one in marks.points if one.plan == "characteristic"}
    assert pins == {f"A_{k}" for k in range(9) if k != 1}
    bars = {one.name for one in marks.vectors if one.plan == "bars"}
    assert bars == {"1.1", "1.2", *(f"2.{k}" for k in range(1, 6)), *(f"3.{k}" for k in range(1, 6)), "set.1"}


def test_a_report_tells_the_positions_by_both_roads(shaper: tuple[Study, Leaf]) -> None:
    study, leaf = shaper
    told = "\n".join(report.chapters(study, {"cyclogram": (leaf,)}).values)
    assert "## Cyclogram" in told
    assert (
        "position 8, overrun begins, at 0.1 of the stroke: φ = 306.8819915° by plan, 306.8819915° by analysis" in told
    )
    assert "φ_rise = 360° − (φ_2 − φ_1) = 74.57704742°" in report.headline(study)
    assert report.remarks(study) == []
