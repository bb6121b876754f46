"""Kinematic diagrams of the output: chords against closed forms, gaps, outputs that turn, what is left out and why."""

from __future__ import annotations

import re

import numpy as np
import pytest

from plans.diagrams.marks import marks
from plans.explanation import Explanation
from plans.model.diagrams import Diagrams
from plans.scene.notes import notes_of
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.gallery import GALLERY
from tests.plans.scenes import scene
from tests.plans.test_scene_techniques import LINKAGE

RADIUS, SPEED = 0.060, 10.0
SINC = np.sin(np.pi / 12) / (np.pi / 12)  # of half a step of twelve: the chord of a sine over the sine at its middle
# A sine mechanism (Scotch yoke) of radius r: S = r (1 - cos φ) from where its yoke is on the right.
YOKE = scene(
    frame="O = [0, 0]", links="OA A BC", lengths="OA = 0.060; BC = 0.160",
    slides=['link = 2; along = "BC"', "link = 3; along = { through = [0, -0.080], angle = 0 }; angle = 90"],
    sketch="B = [0.06, -0.08]", drive="link = 1",
)  # fmt: skip
ROCKER = LINKAGE.replace('"10 rad/s"', "10")
# A parallelogram that a second one carries through its change points.
PARALLEL = (
    ROCKER.replace("OA = 0.100", "OA = 0.200").replace("CB = 0.300", "CB = 0.200").replace("AB = 0.400", "AB = 0.350")
    .replace("[0.39, 0.30]", "[0.45, 0.15]")
    .replace("[mechanism.frame]", "[mechanism]\nthrough = 'parallel'\n[mechanism.frame]")
)  # fmt: skip


def study_of(text: str) -> Study:
    return Study(parse_scene('sheets = ["kinematics"]\n' + text))


def both(text: str) -> tuple[Diagrams, Diagrams]:
    comparison = study_of(text).comparison("diagrams")
    assert comparison.agrees
    return comparison.construction, comparison.analysis


@pytest.mark.parametrize("drive", ["speed = 10", "speed = -10", "speed = 10\nacceleration = 7"])
def test_chords_of_a_sine_mechanism_are_those_of_the_closed_form(drive: str) -> None:
    """The chord of a sine over a step is the sine at its middle, times sin(step/2)/(step/2); two chords its square."""
    for found in both(f"{YOKE}{drive}\npositions = 12"):
        step, turned = np.pi / 6, found.axis.turned
        share = np.sin(step / 2) / (step / 2)
        assert turned == pytest.approx(np.arange(13) * step)
        assert found.at.s == pytest.approx(RADIUS * (1 - np.cos(turned)), abs=1e-15)
        assert found.at.v == pytest.approx(RADIUS * SPEED * np.sin(turned), abs=1e-14)
        assert found.speeds == pytest.approx(RADIUS * SPEED * share * np.sin(turned[:-1] + step / 2))
        assert found.growths == pytest.approx(RADIUS * SPEED**2 * share**2 * np.cos(turned), abs=1e-12)
        assert found.true_growths == pytest.approx(RADIUS * SPEED**2 * np.cos(turned), abs=1e-12)
        assert found.even == pytest.approx(found.true_growths, abs=1e-12)
        own = 7 / SPEED * found.at.v if "acceleration" in drive else 0.0
        assert found.at.a == pytest.approx(found.true_growths + own, abs=1e-12)


@pytest.mark.parametrize("along", [90, 30, -60])
def test_a_point_without_a_guide_is_the_output_along_a_direction(along: float) -> None:
    """Peaucellier's point goes on a straight line: y = (CB² − AB²)/2OA tan(φ/2)."""
    text = re.sub("along = .*", f"along = {along}", (GALLERY / "inversor.toml").read_text(encoding="utf-8"))
    half, share = np.radians([-30, -15, 0, 15, 30]) / 2, 0.3375 * np.sin(np.radians(along))
    for found in both(text.replace('sheets = ["kinematics"]', "")):
        assert found.at.s == pytest.approx(share * np.tan(half) - (share * np.tan(half)).min(), abs=1e-12)
        assert found.at.v == pytest.approx(share / 2 / np.cos(half) ** 2)
        assert found.at.a == pytest.approx(share / 2 * np.tan(half) / np.cos(half) ** 2, abs=1e-12)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (f"{YOKE}speed = 10\npositions = 3", None),  # of a whole turn the first position stands again at the end
        (f"{YOKE}speed = 10\npositions = [0, 30, 60]", "fewer than 4 positions follow one another"),
        (f"{YOKE}speed = 10\npositions = 361", "there are more than 360 positions"),
        (f"{YOKE}speed = 0\npositions = 12", "the crank is at rest"),
        (f"{PARALLEL}positions = [20, 40, 60, 80]\n[output]\nlink = 2", "link 2 does not move"),
        (f"{PARALLEL}positions = 12\nstart = 50\n[output]\nlink = 3", "link 3 rotates as the crank does"),
    ],
)
def test_what_is_left_out_is_told(text: str, said: str | None) -> None:
    own = study_of(text)["diagrams"]
    assert (str(own.left_out) if own.left_out else None) == said
    assert (own.diagrams is None) is (said is not None)


def test_a_scene_that_wants_none_makes_none() -> None:
    study = study_of(f"{YOKE}speed = 10\n[sheet]\ndiagrams = false")
    assert study["diagrams"].diagrams is None
    assert study.comparison("diagrams").findings == ()
    assert study.numbers("diagrams", "construction").plain() == {}


@pytest.mark.parametrize(
    ("mark", "value"), [("dS/dt", RADIUS * SPEED * SINC * np.sin(np.pi / 12)), ("dv/dt", RADIUS * SPEED**2 * SINC**2)]
)
def test_explain_tells_the_chords_behind_a_value(mark: str, value: float) -> None:
    told = marks(study_of(f"{YOKE}speed = 10\npositions = 12"), 0, mark)
    assert isinstance(told, Explanation)
    assert all(step.step.why for step in told.steps)
    assert f"{mark} = {value:.10g} m/s" in str(told.notes[0])
    steps = {step.name for step in told.steps}
    assert {"v:P", "v:0-1"} <= steps
    assert ("a:P" in steps) is (mark == "dv/dt")


def test_a_key_that_no_sheet_uses_is_told_with_the_sheet_that_does() -> None:
    scene = parse_scene('sheets = ["positions"]\n' + f"{YOKE}speed = 10\n[sheet]\ndiagrams = false")
    assert ['"kinematics"' in str(note) for note in notes_of(scene)] == [True]
    assert notes_of(study_of(f"{YOKE}speed = 10\n[sheet]\ndiagrams = false").scene) == []
