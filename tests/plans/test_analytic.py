"""The analytic road: worked mechanisms, derivatives by differences, rounding, and angles of any number of turns."""

from __future__ import annotations

import cmath
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from math import asin, pi, radians, sqrt
from pathlib import Path

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis, solve
from plans.linkage.primary import even, listed
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import Mechanism, Output
from plans.scene.scene import parse_scene
from plans.scene.units import within
from tests.plans import linkages
from tests.plans.studies import study_of
from tests.rows import over

EPS = float(np.finfo(float).eps)


def crank_rocker(**kinds: float) -> Mechanism:
    coupler = {"S": cmath.rect(0.22, radians(25))}
    return linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler=coupler, **kinds)


# Extreme positions


def test_extremes_are_exact():
    a, b, e = 0.06, 0.20, 0.02
    found = Analysis(linkages.slider_crank(a, b, e)).extremes(Output(3, "B"))
    assert found is not None
    assert found.phi[0] == pytest.approx(asin(e / (a + b)), abs=8 * EPS)
    assert found.phi[1] == pytest.approx(pi + asin(e / (b - a)), abs=8 * EPS)
    assert found.stroke == pytest.approx(sqrt((b + a) ** 2 - e**2) - sqrt((b - a) ** 2 - e**2), abs=4 * EPS)


# Derivatives and rounding

ALL = {
    "four-bar": crank_rocker(),
    "slider-crank": linkages.slider_crank(0.06, 0.20, 0.02),
    "slotted link": linkages.slotted_link(0.12, 0.35, 0.70),
    "Whitworth": linkages.slotted_link(0.30, 0.10, 0.50),
    "yoke": linkages.scotch_yoke(0.1),
    "shaper": linkages.shaper(),
    "triad": linkages.triad(),
}


WORKED = {**ALL, "tangent": linkages.tangent_mechanism(0.15)}
WORKED["crossed"] = replace(crank_rocker(), sketch={"B": 0.2 - 0.3j})


@pytest.mark.parametrize("name", WORKED)
def test_the_worked_mechanisms_move_as_they_are_constructed(name):
    """What the construction finds of them is held to the last printed digit in test_construction."""
    drawn = study_of(WORKED[name], positions=[20, 60]).motion()
    motion = solve(WORKED[name], drawn.phi)
    for ours, theirs in ((motion.points, drawn.points), (motion.links, drawn.links)):
        assert ours.keys() == theirs.keys()
        for key, found in ours.items():
            for row, expected in zip(found, theirs[key], strict=True):
                assert row == pytest.approx(expected, rel=1e-13, abs=1e-12), key


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
