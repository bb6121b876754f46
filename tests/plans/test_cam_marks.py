"""Marks of a cam as `explain` takes them: quantities of the law, angle, radius, poles; examples that exist."""

from __future__ import annotations

import math

import pytest

from plans.cam.marks import marks
from plans.explanation import Explanation, NoMark
from plans.scene.scene import parse_scene
from plans.study import Study

HEAD = (
    '[[cam]]\nname = "{name}"\nspeed = "300 rpm"\n'
    '[cam.follower]\nmotion = "translating"\nend = "{end}"\nlift = "30 mm"\n'
)
SIZES = '[cam.sizes]\nbase = "50 mm"\noffset = "12 mm"\n'
PHASES = (
    '[[cam.phases]]\nkind = "rise"\n{by} = {rise}\nlaw = "sine"\n'
    '[[cam.phases]]\nkind = "return"\n{by} = {back}\nlaw = "sine"\n'
)
TURNING = PHASES.format(by="angle", rise=120, back=240)


def study_of(text: str) -> Study:
    return Study.of_all(parse_scene(text), whole=True)


def one(end: str = "roller", sizes: str = SIZES, phases: str = TURNING, name: str = "K1") -> str:
    return HEAD.format(name=name, end=end) + sizes + phases


ROLLER = study_of(one())


def explained(study: Study, position: int, name: str) -> Explanation:
    found = marks(study, position, name)
    assert isinstance(found, Explanation)
    return found


def test_quantities_of_the_law_are_those_of_the_position() -> None:
    """A quarter of the sine law: S = h(1/4 - 1/(2 pi)), S' = h/phi, S'' = 2 pi h/phi2."""
    turn = math.radians(120)
    due = {"S": 0.03 * (0.25 - 0.5 / math.pi), "S'": 0.03 / turn, "S''": math.tau * 0.03 / turn**2}
    for (name, value), unit in zip(due.items(), ("m", "m/rad", "m/rad2"), strict=True):
        found = explained(ROLLER, 2, name)
        (mark,) = found.steps
        assert complex(mark.point) == pytest.approx(1j * value)
        assert found.units[mark.subject] == unit


def test_angle_radius_and_poles_are_known() -> None:
    alpha, radius = explained(ROLLER, 2, "alpha"), explained(study_of(one(sizes="[cam.limits]\nrise = 30\n")), 0, "R_0")
    by = ROLLER.comparison("cam").analysis.cams[0].contour.pressure[2]
    assert f"α = {math.degrees(by):.8g}" in str(alpha.notes[0])
    assert alpha.steps[-1].name == "OD"
    assert f"{abs(complex(radius.steps[-1].point)):.9g}" in str(radius.notes[0])
    assert [explained(ROLLER, 0, name).steps[-1].name for name in ("P_1", "P_2")] == ["S':P", "S:P"]


def test_examples_exist_and_another_cam_is_asked_for_by_its_name() -> None:
    pointed = study_of(one("pointed"))
    none = marks(pointed, 0, "none")
    assert isinstance(none, NoMark)
    assert "Q" not in none.examples
    assert all(isinstance(marks(pointed, 0, name), Explanation) for name in none.examples)
    both = study_of(one() + one("pointed", name="K2"))
    none = marks(both, 0, "none")
    assert isinstance(none, NoMark)
    assert "K2:P" in str(none.listed)
    assert isinstance(marks(both, 0, "K2:Q"), NoMark)
    assert isinstance(marks(both, 0, "K1:Q"), Explanation)
