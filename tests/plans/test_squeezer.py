"""Andrews' squeezer of the gallery in the states that the Test Set for IVP Solvers publishes, by both roads."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from plans.forces.quantities import ForceComparison
from plans.model.motion import Motion
from tests.parts import some
from tests.plans.force_cases import ROADS, compared, of_road

TESTS = Path(__file__).parents[1]
SCENE = (TESTS.parent / "drawings" / "gallery" / "squeezer.toml").read_text(encoding="utf-8")
DATA = json.loads((TESTS / "cases" / "andrews_squeezer.json").read_text(encoding="utf-8"))
# Of a link of the scene the angles of the test set that its own angle is the sum of, and by how much it is turned more.
ANGLES = {1: ("b", 0.0), 2: ("bT", np.pi), 3: ("g", -np.pi / 2), 4: ("Pd", np.pi / 2), 5: ("d", 0.0), 6: ("Oe", np.pi),
          7: ("e", -np.pi / 2)}  # fmt: skip
NAMES = "bTgPdOe"  # beta, Theta, gamma, Phi, delta, Omega, epsilon
NEAR = 5e-14  # of each value, what the roundings of a construction of three groups may add up to
STATES = ("start", "later")


def text_of(state: dict[str, Any]) -> str:
    """Give the gallery's scene at one crank angle alone, with the crank's rates of a state."""
    omega, epsilon = (state.get(order, [1])[0] for order in ("velocities", "accelerations"))
    changes = (
        ('start = "extreme"         # crank and rod in one line, E nearest to O\n', f"acceleration = {epsilon}\n"),
        ('speed = "1140 rad/s"', f"speed = {omega}"),
        ("positions = 12", f"positions = [{state['degrees']}]"),
        ("plans = [2, 8]", "plans = [0]"),
    )
    text = SCENE
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    return text


@cache
def state_of(name: str) -> ForceComparison:
    return compared(text_of(DATA[name]))


def motion_of(name: str, road: str) -> Motion:
    motion = state_of(name).motion
    return (motion.construction, motion.analysis)[ROADS.index(road)]


def wanted(name: str, order: str) -> Iterator[tuple[int, float]]:
    """Give of every link what the state says of it: an angle, or a rate."""
    for link, (names, turned) in ANGLES.items():
        value = sum(DATA[name][order][NAMES.index(one)] for one in names)
        yield link, value + (turned if order == "angles" else 0.0)


@pytest.mark.parametrize("road", some(ROADS, 3))
@pytest.mark.parametrize("name", [*STATES, "published"])
def test_the_links_lie_at_the_published_angles(name: str, road: str) -> None:
    links = motion_of(name, road).links
    for link, angle in wanted(name, "angles"):
        # Fifteen turns of two angles taken together are themselves rounded by 2e-15.
        assert abs(np.exp(1j * links[link].angle[0]) - np.exp(1j * angle)) <= 4e-15, link


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", STATES)
def test_the_links_have_the_rates_of_the_state(name: str, road: str) -> None:
    links = motion_of(name, road).links
    for link, omega in wanted(name, "velocities"):
        assert abs(links[link].omega[0] - omega) <= NEAR * abs(omega), link
    least = NEAR * abs(DATA[name]["accelerations"][0])  # the links that rest at the start gain no rate
    for link, epsilon in wanted(name, "accelerations"):
        assert abs(links[link].epsilon[0] - epsilon) <= max(NEAR * abs(epsilon), least * (epsilon == 0)), link


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", STATES)
def test_the_multipliers_are_what_the_pin_does_to_its_three_links(name: str, road: str) -> None:
    reactions = of_road(state_of(name), road).reactions
    four, six = reactions["3-4"].force[0], reactions["3-6"].force[0]
    three = reactions["2-3"].force[0] - four - six  # the other two hang on the rocker's end of the pin
    x, y = np.reshape(DATA[name]["multipliers"], (3, 2)).T
    largest = np.abs(x + 1j * y).max()
    assert np.abs(np.array([three, four, six]) - (x + 1j * y)).max() <= NEAR * largest


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", STATES)
def test_the_balancing_moment_is_the_motors(name: str, road: str) -> None:
    assert of_road(state_of(name), road).balancing.moment[0] == pytest.approx(DATA["torque"], rel=NEAR)


def test_the_gallery_begins_where_the_test_set_does() -> None:
    found = compared(SCENE).motion
    for motion in (found.construction, found.analysis):
        for link, angle in wanted("start", "angles"):
            # An extreme of a rocker is found to a few roundings, and the rod turns five times as fast as they.
            assert abs(np.exp(1j * motion.links[link].angle[0]) - np.exp(1j * angle)) <= 4e-15, link
