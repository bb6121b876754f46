"""A primary link that slides: against the mechanism driven by its crank, exact values, gaps, what is refused."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from plans.model.motion import NOT_REACHABLE, OUT_OF_REACH
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from plans.study import Study

# A slider-crank with its masses and a brake on the crank; driven by its crank, or backwards by its slider.
SLIDER_CRANK = """
sheets = ["forces"]
[mechanism.frame]
O = [0.1, 0.2]
[mechanism.links]
{crank} = "OA"
2 = "AB"
{slider} = "B"
[mechanism.lengths]
OA = 0.2
AB = 0.5
[[mechanism.slides]]
link = {slider}
along = {{ through = [0.1, 0.25], angle = 0 }}
[mechanism.sketch]
A = [0.2, 0.37]
B = [0.65, 0.25]
[masses]
{crank} = {{ mass = 3, inertia = 0.05, centre = "middle" }}
2 = {{ mass = 4, inertia = 0.2, centre = "middle" }}
{slider} = {{ mass = 6 }}
[loads]
gravity = 9.81
[[loads.moments]]
on = {crank}
name = "M_T"
value = 40
[drive]
{drive}
"""
STROKE = (
    "link = 1\npositions = {steps}\n[drive.stroke]\nfrom = {begin!r}\nto = {end!r}\nspeed = {v!r}\nacceleration = {a!r}"
)


@cache
def by_crank() -> Study:
    """One position of the crank, 60 degrees, at 12 rad/s and 30 rad/s2."""
    drive = "link = 1\nspeed = 12\nacceleration = 30\npositions = [60]"
    return Study(parse_scene(SLIDER_CRANK.format(crank=1, slider=3, drive=drive)))


@cache
def by_slider() -> Study:
    """The same position, in the middle of a stroke, at the rates that the crank gives the slider."""
    slider = by_crank()["linkage"].motion(2).points["B"]
    way, v, a = (float(row[0].real) for row in slider)
    assert v < 0
    drive = STROKE.format(steps=2, begin=way + 0.03, end=way - 0.03, v=-v, a=-a)
    return Study(parse_scene(SLIDER_CRANK.format(crank=3, slider=1, drive=drive)))


def test_a_slider_that_drives_moves_the_mechanism_as_the_crank_does() -> None:
    crank, slider = by_crank()["linkage"].motion(2), by_slider()["linkage"].motion(2)
    assert slider.links[3].omega[1] == pytest.approx(12, rel=1e-12)
    assert slider.links[3].epsilon[1] == pytest.approx(30, rel=1e-11)
    for point in "AB":
        places = slider.points[point].r[1] + 0.25j, crank.points[point].r[0] + 0.2j  # each from its own datum
        rates = zip(slider.points[point][1:], crank.points[point][1:], strict=True)
        for own, other in (places, *((own[1], other[0]) for own, other in rates)):
            assert own == pytest.approx(complex(other), rel=1e-11, abs=1e-12)


def test_the_force_that_pushes_the_slider_has_the_power_of_the_moment_that_turns_the_crank() -> None:
    moment = by_crank()["forces"].forces.balancing.moment[0]
    pushed, motion = by_slider()["forces"].forces.balancing, by_slider()["linkage"].motion(1)
    assert pushed.force is not None
    power = float((np.conj(pushed.force[1]) * motion.points["B"].v[1]).real)
    assert power == pytest.approx(12 * moment, rel=1e-11)
    assert pushed.force[1].imag == 0  # along the guide


def test_both_roads_agree_over_a_stroke_and_the_energy_balance_with_them() -> None:
    for part in ("linkage", "forces"):
        comparison = by_slider().comparison(part)
        assert comparison.agrees
    told = {one.name for one in by_slider().comparison("forces").findings}
    assert {"P_bal", "P_bal lever", "P_bal power", "P_bal energy", "M_01"} <= told


def test_velocities_and_accelerations_are_the_slopes_of_places_and_velocities_over_a_steady_stroke() -> None:
    drive = STROKE.format(steps=2000, begin=0.5, end=0.6, v=0.3, a=0)
    linkage = Study(parse_scene(SLIDER_CRANK.format(crank=3, slider=1, drive=drive)))["linkage"]
    motion, step = linkage.motion(2), 0.1 / 2000 / 0.3
    for order in (1, 2):
        slopes = np.gradient(motion.points["A"][order - 1], step)[1:-1]
        assert np.abs(slopes - motion.points["A"][order][1:-1]).max() < 1e-6


def test_the_stroke_has_one_position_more_than_steps_from_its_beginning_to_its_end() -> None:
    drive = STROKE.format(steps=4, begin=0.6, end=0.5, v=0.3, a=0)
    motion = Study(parse_scene(SLIDER_CRANK.format(crank=3, slider=1, drive=drive)))["linkage"].motion(1)
    assert np.asarray(motion.points["B"].r).real.tolist() == pytest.approx([0.6, 0.575, 0.55, 0.525, 0.5])
    assert np.asarray(motion.points["B"].v).tolist() == pytest.approx([-0.3 + 0j] * 5)


def test_places_that_the_slider_does_not_reach_are_gaps_by_both_roads() -> None:
    drive = STROKE.format(steps=4, begin=0.6, end=0.9, v=0.3, a=0)  # B is 0.698 m away from O's line at most
    study = Study(parse_scene(SLIDER_CRANK.format(crank=3, slider=1, drive=drive)))
    gaps = study["linkage"].motion(1).gaps
    assert [gap.position for gap in gaps] == [2, 3, 4]
    assert {gap.reason for gap in gaps} <= {OUT_OF_REACH, NOT_REACHABLE}
    assert study.comparison("linkage").agrees


FAIR = STROKE.format(steps=4, begin=0.5, end=0.6, v=1, a=0)
REFUSED = {
    "no speed": ("link = 1", "drive.speed"),
    "no stroke": ("link = 1\nspeed = 3", "drive.link"),
    "a stroke and a speed": (FAIR.replace("link = 1", "link = 1\nspeed = 3"), "drive.speed"),
    "no length": (FAIR.replace("0.6", "0.5"), "drive.stroke.to"),
    "another link": (FAIR.replace("link = 1", "link = 3"), "drive.link"),
    "a list": (FAIR.replace("positions = 4", "positions = [0, 1]"), "drive.positions"),
    "a coupling": (FAIR.replace("link = 1", 'link = 1\nbalancing = "coupling"'), "drive.balancing"),
    "a negative speed": (FAIR.replace("speed = 1", "speed = -1"), "drive.stroke.speed"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_does_not_fit_a_stroke_is_refused_at_its_key(name: str) -> None:
    drive, where = REFUSED[name]
    with pytest.raises(SceneError) as refused:
        _ = Study(parse_scene(SLIDER_CRANK.format(crank=3, slider=1, drive=drive)))["linkage"].mechanism
    assert where in {".".join(map(str, fault.path)) for fault in refused.value.faults}


def test_what_is_told_over_a_turn_is_refused_over_a_stroke() -> None:
    text = SLIDER_CRANK.format(crank=3, slider=1, drive=FAIR).replace('"forces"', '"dynamics"')
    with pytest.raises(SceneError, match="told over its turn"):
        _ = Study(parse_scene(text + "[dynamics]\nfluctuation = 0.02"))["linkage"].mechanism
