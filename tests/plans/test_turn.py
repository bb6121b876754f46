"""The crank's turn: whole turns are taken off exactly, so that any angle of a scene is as sharp as a small one."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from plans.linkage.crank_positions import even, listed
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from plans.scene.units import within
from tests.rows import over

CRANK_ROCKER = (Path(__file__).parent.parent / "catalogue" / "plain.toml").read_text("utf-8")


@over("turns", [1, -2, 277, 2_777_777])
@over("angle", ["0", "280", "-30", "0.1"])
def test_whole_turns_change_nothing(turns: int, angle: str) -> None:
    small = Fraction(Decimal(angle))
    large = small + 360 * turns
    assert even(large, 12, 1).phi.tolist() == even(within(large), 12, 1).phi.tolist()
    assert np.exp(1j * even(large, 12, 1).phi) == pytest.approx(even(small, 12, 1).directions, abs=4e-15)
    assert listed([large]).directions.tolist() == listed([small]).directions.tolist()


def test_listed_angles_stay_as_far_apart_as_they_are() -> None:
    assert np.degrees(listed([Fraction(350), Fraction(370)]).phi) == pytest.approx([350, 370], abs=1e-12)
    assert np.degrees(listed([Fraction(-7210), Fraction(-7190)]).phi) == pytest.approx([-370, -350], abs=1e-12)


def test_a_list_that_spans_several_turns_is_taken_within_one() -> None:
    assert np.degrees(listed([Fraction(0), Fraction(100_000)]).phi) == pytest.approx([0, 280], abs=1e-12)


@pytest.mark.parametrize("drive", ["start = 1e5", "start = -123456789.5", "positions = [1e8, 30]"])
def test_both_roads_agree_however_many_turns_the_start_has(drive: str) -> None:
    comparison = compare(LinkageStudy(parse_scene(CRANK_ROCKER.replace("start = 0", drive))))
    assert comparison.agrees
    assert (
        comparison.worst < 0.2
    )  # as of a small angle: a rounding of the whole turns would take several of the allowed
