"""Textbook examples by both roads: the exact answers beside what the books measured on their own drawings."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from math import pi, sin
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
import pytest

from geometry.meet import dot
from plans.analytic.kinematics import solve
from plans.linkage.plan import Plan, rate
from plans.model.mechanism import Drive, Mechanism, Output, Slide, Way
from plans.model.motion import Motion
from tests.plans import linkages
from tests.plans.studies import plans_at, shown, study_of, value

DATA = json.loads((Path(__file__).parents[1] / "cases" / "textbook.json").read_text(encoding="utf-8"))
CASES = {case["id"]: case for case in DATA["cases"]}
RETURNS = {case["id"]: case for case in DATA["quick_returns"]}
HAND = 0.08  # the worst a book measured on its drawing: Bevan 3.8, 7.4 %
TYPICAL = 0.01  # half of the values that books measured are nearer than this
Case = Mapping[str, Any]


def rotary_engine(crank: float, rod: float, drive: Drive) -> Mechanism:
    """The crank OC stands, the cylinder 1 turns about O, the rod 2 about C, and the piston 3 slides in the cylinder."""
    links = {0: {"O": 0, "C": crank}, 1: {"O": 0, "E": rod}, 2: {"C": 0, "B": rod}, 3: {"B": 0}}
    cylinder = Slide(3, 1, linkages.ALONG_X, linkages.ALONG_X, "B", "OE")
    return linkages.mechanism("rotary engine", links, (cylinder,), drive, {"B": (0.15 + 0.2j)}, Output(3, None))


def whitworth(crank: float, below: float) -> Mechanism:
    """Whitworth's quick return: the slotted link turns fully and drives a ram level with its pivot by a rod."""
    links = {
        0: {"O": 0, "C": -1j * below},
        1: {"O": 0, "A": crank},
        2: {"A": 0},
        3: {"C": 0, "B": crank},
        4: {"B": 0, "D": 4 * crank},
        5: {"D": 0},
    }
    slot = Slide(2, 3, linkages.ALONG_X, linkages.ALONG_X, "A", "CB")
    level = Slide(5, 0, linkages.ALONG_X, Way(-1j * below, 1 + 0j), "D", "")
    sketch = {"B": 0.7 * crank * (1 + 1j), "D": complex(4.5 * crank, -below)}
    return linkages.mechanism("Whitworth", links, (slot, level), Drive(1, "O", "A", 1, 0), sketch, Output(5, "D"))


def mechanism_of(case: Case) -> Mechanism:
    unit = case.get("unit", 1.0)
    sizes = [unit * length for length in case["lengths"]]
    rod = {name: unit * place for name, place in case.get("points", {}).items()}
    omega, epsilon = case.get("omega", case.get("rpm", 0) * pi / 30), case.get("epsilon", 0)
    match case["kind"]:
        case "four-bar":
            sketch = {"B": complex(sizes[3], sizes[2])}
            return linkages.four_bar(*sizes, sketch=sketch, omega=omega, epsilon=epsilon)
        case "slider-crank":
            return linkages.slider_crank(*sizes, rod=rod, omega=omega, epsilon=epsilon)
        case "slotted link":
            return linkages.slotted_link(*sizes, omega=omega, epsilon=epsilon)
        case "rotary engine":
            return rotary_engine(*sizes, Drive(1, "O", "E", omega, epsilon))
    return whitworth(*sizes)


def quantity(name: str, plans: tuple[Plan, Plan, Plan]) -> float:
    """Measure on the plans what a book calls by this name: v_BA, omega_2, at_3 (the tangential part), slip, ..."""
    positions, velocities, accelerations = plans
    if name in SPECIAL:
        return SPECIAL[name](positions, velocities, accelerations)
    kind, which = name.split("_")
    match kind:
        case "omega":
            return abs(value(rate(velocities, int(which))))
        case "eps":
            return abs(value(rate(accelerations, int(which))))
        case "at":
            return abs(value(accelerations.readings[int(which)].turning.point))
    plan = velocities if kind == "v" else accelerations
    ends = [value(plan.point(letter).point) for letter in which]
    return abs(ends[0] - ends[1]) if len(ends) > 1 else abs(ends[0])


def _slip_rate(positions: Plan, _: Plan, accelerations: Plan) -> float:
    way = shown(accelerations, "b") - shown(accelerations, "k_B")
    return abs(dot(way, shown(positions, "u1")))


SPECIAL: dict[str, Callable[[Plan, Plan, Plan], float]] = {
    "CA": lambda r, v, a: abs(shown(r, "CA")),
    "slip": lambda r, v, a: abs(value(v.slips[3, 1].point)),
    "slip_rate": _slip_rate,
    "coriolis": lambda r, v, a: abs(shown(a, "a^k_B")),
}


def scale(name: str, case: Case) -> float:
    return 1.0 if name.startswith(("omega", "eps")) else case.get("result_unit", 1.0)


def last_digit(number: float) -> float:
    """Half a unit of the last digit that a number was printed with, and a little for the rounding of that half."""
    decimals = len(repr(number).partition(".")[2])
    return 0.51 * 10.0**-decimals


def analysed(name: str, case: Case, motion: Motion) -> float:
    """Give the same by analysis."""
    kind, which = name.split("_")
    if kind in ("omega", "eps", "at"):
        link = motion.links[int(which)]
        length = case.get("unit", 1.0) * case["lengths"][int(which) - 1] if kind == "at" else 1.0
        return abs((link.omega if kind == "omega" else link.epsilon)[0]) * length
    ends = [(motion.points[point].v if kind == "v" else motion.points[point].a)[0] for point in (*which, "O")[:2]]
    return abs(ends[0] - ends[1])


def measured(case: Case, names: Mapping[str, float]) -> dict[str, float]:
    plans = plans_at(mechanism_of(case), str(case["phi"]))
    return {name: quantity(name, plans) / scale(name, case) for name in names}


@pytest.mark.parametrize("name", CASES)
def test_analysis_gives_the_exact_answer(name):
    case = CASES[name]
    motion = solve(mechanism_of(case), np.radians([case["phi"]]))
    for key in case["independent"].keys() - SPECIAL.keys():
        expected = case["independent"][key]
        found = analysed(key, case, motion) / scale(key, case)
        assert found == pytest.approx(expected, abs=last_digit(expected)), key


@pytest.mark.parametrize("name", CASES)
def test_the_construction_gives_the_exact_answer(name):
    case = CASES[name]
    for key, found in measured(case, case["independent"]).items():
        expected = case["independent"][key]
        assert found == pytest.approx(expected, abs=last_digit(expected)), key


@pytest.mark.parametrize("name", CASES)
def test_the_book_measured_it_on_its_drawing(name):
    case = CASES[name]
    for key, found in measured(case, case["published"]).items():
        assert case["published"][key] == pytest.approx(found, rel=HAND), key


def test_how_far_drawings_by_hand_are_off():
    off = []
    for case in CASES.values():
        found = measured(case, case["published"])
        off += [abs(case["published"][key] / exact - 1) for key, exact in found.items()]
    assert median(off) < TYPICAL < max(off) < HAND


def test_khurmi_15_3_greatest_velocity_is_where_the_acceleration_vanishes():
    case = CASES["khurmi_15_3"]
    plans = plans_at(mechanism_of(case), str(case["phi"]))
    digit = 5e-5 * pi / 180  # of the crank angle as it is printed
    assert quantity("a_B", plans) < digit * case["lengths"][0] * (case["rpm"] * pi / 30) ** 2 * 2


@pytest.mark.parametrize("name", RETURNS)
def test_quick_return(name):
    case = RETURNS[name]
    study = study_of(mechanism_of(case), None)
    assert study.extreme_positions is not None
    extremes = study.extreme_positions.extremes
    expected = case["independent"]
    assert extremes.ratio == pytest.approx(expected["ratio"], abs=max(last_digit(expected["ratio"]), 1e-6) / 10)
    assert case["published"]["ratio"] == pytest.approx(extremes.ratio, rel=HAND)
    if "chord" in expected:
        assert 2 * case["lengths"][2] * sin(extremes.stroke / 2) == pytest.approx(expected["chord"], abs=1e-8)
