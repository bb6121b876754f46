"""A cylinder between two links: a scissor lift by the cosine rule, a four-bar by both roads, what is refused."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from geometry.errors import DraftError
from plans.forces import drive as cylinder
from plans.linkage import ram
from plans.linkage.primary import CrankPositions
from plans.linkage.sweep import at_angles
from plans.model.motion import Rates
from plans.scene.faults import SceneError, dotted
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import some
from tests.plans.scenes import changed

CASES = Path(__file__).parents[1] / "cases"
# The arms cross in their middles, E and F are 0.5 m from it, so that EF = 2 * 0.5 sin(phi); D is at 1.6 sin(phi).
SCISSOR = (CASES / "strokes" / "scissor.toml").read_text(encoding="utf-8")
FOUR_BAR = (CASES / "alarms" / "cylinder-between-two-links.toml").read_text(encoding="utf-8")
LAW = """speeds = [0, "80 mm/s", "80 mm/s", 0]
places = ["450 mm", "500 mm", "700 mm", "750 mm"]
"""
STEADY = 'speed = "80 mm/s"\nacceleration = 0.1\n'
LENGTHS = np.linspace(0.45, 0.75, 9)


@cache
def scissor(law: str = LAW) -> Study:
    assert LAW in SCISSOR
    return Study(parse_scene(SCISSOR.replace(LAW, law)))


@cache
def four_bar(*changes: tuple[str, str]) -> Study:
    return Study(parse_scene(changed(FOUR_BAR, *changes)))


def test_a_scissor_lift_stands_where_the_cosine_rule_has_it() -> None:
    motion = scissor(STEADY)["linkage"].motion(2)
    arm, tilt = motion.links[1], np.sqrt(1 - LENGTHS**2)
    assert arm.angle == pytest.approx(np.arcsin(LENGTHS), abs=1e-14)
    assert arm.omega == pytest.approx(0.08 / tilt, rel=1e-12)
    assert arm.epsilon == pytest.approx((0.1 + LENGTHS * (0.08 / tilt) ** 2) / tilt, rel=1e-11)
    assert motion.points["D"].v == pytest.approx(np.full(9, 1.6j * 0.08), rel=1e-12)


@pytest.mark.parametrize("study", some([four_bar, scissor], 2, ["four-bar", "scissor"]))
def test_both_roads_agree_on_motion_forces_and_energy(study: Callable[[], Study]) -> None:
    for part in ("linkage", "forces"):
        assert study().comparison(part).agrees
    told = {one.name for part in ("linkage", "forces") for one in study().comparison(part).findings}
    assert {"P_bal", "M_bal energy", "M_bal power"} <= told
    assert len([name for name in told if name[:2] in ("s_", "v_", "a_") and name[2:] in ("EF", "AD")]) == 3


def test_rates_are_the_slopes_of_places_over_time() -> None:
    linkage = four_bar(("positions = 6", "positions = 2000"), ("acceleration = 0.2", "acceleration = 0"))["linkage"]
    point, step = linkage.motion(2).points["B"], 0.15 / 2000 / 0.06
    # A chord over two steps is off by a sixth of the step squared times the third derivative.
    jerk, more = np.abs(np.diff(point.a)).max() / step, np.abs(np.diff(point.a, 2)).max() / step**2
    for order, third in ((1, jerk), (2, more)):
        slopes = np.gradient(point[order - 1], step)[1:-1]
        assert np.abs(slopes - point[order][1:-1]).max() < 1.01 * step**2 / 6 * third


FAULTS = {
    "another angle": (ram.Between, "positions", lambda true: lambda *given: _moved(true(*given))),
    "another pace": (ram.Between, "pace", lambda true: lambda *given: _quickened(true(*given))),
    "a force on one link alone": (cylinder, "_ends", lambda true: lambda *given: iter([*true(*given)][:1] * 2)),
    "another force": (cylinder, "push", lambda true: lambda *given: 1.01 * true(*given)),
}


def _moved(turn: CrankPositions) -> CrankPositions:
    return at_angles(turn.phi + 1e-9)


def _quickened(rates: Rates) -> Rates:
    return rates._replace(epsilon=(1 + 1e-9) * rates.epsilon)


@pytest.mark.parametrize("name", some(FAULTS, 2))
def test_a_wrong_law_or_force_of_the_cylinder_is_seen(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    owner, attribute, wrong = FAULTS[name]
    monkeypatch.setattr(owner, attribute, wrong(getattr(owner, attribute)))
    study = Study(parse_scene(FOUR_BAR))
    assert not all(study.comparison(part).agrees for part in ("linkage", "forces"))


REFUSED = {
    "one link": ('between = "AD"', 'between = "AB"', "drive.stroke.between"),
    "the frame alone": ('between = "AD"', 'between = "OC"', "drive.stroke.between"),
    "one point": ('between = "AD"', 'between = "AA"', "drive.stroke.between"),
    "beyond where it turns back": ("to = 0.65", "to = 0.9", "drive.stroke.to"),
    "shorter than it gets": ("from = 0.5\n", "from = 0.2\n", "drive.stroke.from"),
    "at rest": ("speed = 0.06", "speed = 0", "drive.stroke.speed"),
    "links that never meet": ("AB = 0.7", "AB = 2.7", "drive.stroke.between"),
}


@pytest.mark.parametrize("name", some(REFUSED, 3))
def test_a_cylinder_that_cannot_drive_is_refused_at_its_key(name: str) -> None:
    old, new, where = REFUSED[name]
    assert old in FOUR_BAR
    with pytest.raises(SceneError) as refused:
        _ = Study(parse_scene(FOUR_BAR.replace(old, new)))["linkage"].mechanism
    assert [dotted(fault.path) for fault in refused.value.faults] == [where]


def test_a_refusal_tells_the_lengths_between_which_it_can_go() -> None:
    """EF of the scissor lift is shortest with the arms flat, 0, and longest with them upright, 1000 mm."""
    with pytest.raises(SceneError) as refused:
        _ = Study(parse_scene(SCISSOR.replace("750 mm", "1001 mm")))["linkage"].mechanism
    assert "between 8.7" in str(refused.value) and "999.96" in str(refused.value)


def test_a_sketch_that_tells_no_assembly_is_told_as_of_any_linkage() -> None:
    study = four_bar(("B = [0.75, 0.48]\n", ""), ("D = [0.68, 0.24]\n", ""))
    with pytest.raises(DraftError, match=r"mechanism\.sketch"):
        _ = study["linkage"].turn
