"""A primary link that slides: against the mechanism driven by its crank, exact values, gaps, what is refused."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from plans.forces import drive as cylinder
from plans.linkage.ram import Triangle
from plans.model.motion import NOT_REACHABLE, OUT_OF_REACH, law_ends
from plans.scene.faults import SceneError, dotted
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.scenes import scene

# A slider-crank with its masses and a brake on the crank; driven by its crank, or backwards by its slider.
SLIDER_CRANK = scene(
    'sheets = ["forces"]', frame="O = [0.1, 0.2]", links='{crank} = "OA"; 2 = "AB"; {slider} = "B"',
    lengths="OA = 0.2; AB = 0.5", slides=["link = {slider}; along = {{ through = [0.1, 0.25], angle = 0 }}"],
    sketch="A = [0.2, 0.37]; B = [0.65, 0.25]",
    masses='{crank} = {{ mass = 3, inertia = 0.05, centre = "middle" }}; '
    '2 = {{ mass = 4, inertia = 0.2, centre = "middle" }}; {slider} = {{ mass = 6 }}',
    loads="gravity = 9.81", moments=['on = {crank}; name = "M_T"; value = 40'], drive="{drive}",
)  # fmt: skip
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


def test_both_roads_agree_over_a_stroke_and_the_energy_balance_with_them() -> None:
    for part in ("linkage", "forces"):
        comparison = by_slider().comparison(part)
        assert comparison.agrees
    told = {one.name for one in by_slider().comparison("forces").findings}
    assert {"P_bal", "P_bal lever", "P_bal power", "P_bal energy", "M_01"} <= told


def test_places_that_the_slider_does_not_reach_are_gaps_by_both_roads() -> None:
    drive = STROKE.format(steps=4, begin=0.6, end=0.9, v=0.3, a=0)  # B is 0.698 m away from O's line at most
    study = Study(parse_scene(SLIDER_CRANK.format(crank=3, slider=1, drive=drive)))
    gaps = study["linkage"].motion(1).gaps
    assert [gap.position for gap in gaps] == [2, 3, 4]
    assert {gap.reason for gap in gaps} <= {OUT_OF_REACH, NOT_REACHABLE}
    assert study.comparison("linkage").agrees


FAIR = STROKE.format(steps=4, begin=0.5, end=0.6, v=1, a=0)
REFUSED = {
    "no speed": ("link = 1", "drive.link"),
    "a speed along": ('link = 1\nspeed = "0.2 m/s"', "drive.link"),
    "a cylinder beside": (FAIR + '\nbetween = "AB"', "drive.stroke.between"),
    "half a cylinder": (FAIR + '\nbetween = "B"', "drive.stroke.between"),
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
    assert [dotted(fault.path) for fault in refused.value.faults] == [where]  # one slip, one message


def test_what_is_told_over_a_turn_is_refused_over_a_stroke() -> None:
    text = SLIDER_CRANK.format(crank=3, slider=1, drive=FAIR).replace('"forces"', '"dynamics"')
    with pytest.raises(SceneError, match="told over its turn"):
        _ = Study(parse_scene(text + "[dynamics]\nfluctuation = 0.02"))["linkage"].mechanism


# A boom OF that a cylinder EF turns; with EF = 500 mm the triangle OEF has a right angle at O, and F is above it.
BOOM = scene(
    'sheets = ["forces"]', frame="O = [0, 0]; E = [0.3, 0]", links="OF FG E", lengths="OF = 0.4; FG = 0.3",
    slides=['link = 3; along = "FG"'], sketch="F = [0, 0.4]; G = [0.15, 0.2]",
    masses='1 = {{ mass = 20, inertia = 0.5, centre = "middle" }}; '
    '2 = {{ mass = 4, inertia = 0.1, centre = "middle" }}',
    loads="gravity = 9.81", forces=['on = 1; point = "F"; direction = -20; value = 900'], drive="link = 1; {drive}",
)  # fmt: skip
CYLINDER = scene(
    "positions = 2", drive_stroke='between = "EF"; from = 0.45; to = 0.55; speed = 0.06; acceleration = 0.2'
)


@cache
def by_cylinder() -> Study:
    return Study(parse_scene(BOOM.format(drive=CYLINDER)))


def test_both_roads_agree_on_a_cylinder_and_hold_its_law(monkeypatch: pytest.MonkeyPatch) -> None:
    for part in ("linkage", "forces"):
        assert by_cylinder().comparison(part).agrees
    told = {one.name for one in by_cylinder().comparison("linkage").findings}
    assert {"s_EF", "v_EF", "a_EF"} <= told
    true = Triangle.pace
    monkeypatch.setattr(Triangle, "pace", lambda drive, phi: true(drive, phi)._replace(epsilon=0.0 * phi))
    assert not Study(parse_scene(BOOM.format(drive=CYLINDER))).comparison("linkage").agrees


def test_a_cylinder_that_leaves_the_crank_a_moment_is_seen_though_both_roads_have_its_force(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    true = cylinder.push
    monkeypatch.setattr(cylinder, "push", lambda *given: 1.01 * true(*given))
    assert not Study(parse_scene(BOOM.format(drive=CYLINDER))).comparison("forces").agrees


CYLINDERS = {
    "no fixed point": (CYLINDER.replace('"EF"', '"GF"'), "drive.stroke.between"),
    "the crank's hinge": (CYLINDER.replace('"EF"', '"EO"'), "drive.stroke.between"),
    "too long": (CYLINDER.replace("0.55", "0.75"), "drive.stroke.to"),
    "too short": (CYLINDER.replace("0.45", "0.09"), "drive.stroke.from"),
    "at rest": (CYLINDER.replace("0.06", "0"), "drive.stroke.speed"),
}


@pytest.mark.parametrize("name", CYLINDERS)
def test_a_cylinder_that_cannot_drive_is_refused_at_its_key(name: str) -> None:
    drive, where = CYLINDERS[name]
    with pytest.raises(SceneError) as refused:
        _ = Study(parse_scene(BOOM.format(drive=drive)))["linkage"].mechanism
    assert where in {".".join(map(str, fault.path)) for fault in refused.value.faults}


LAW = scene(
    "positions = 4",
    drive_stroke="{between}from = {begin}; to = {end}; speeds = [0.1, 0.3, 0.3, 0.1]; "
    "places = [{begin}, {second}, {third}, {end}]",
)


LAWS = {
    "too few speeds": ("speeds = [1]", "drive.stroke.speeds"),
    "no speeds": ("speeds = []", "drive.stroke.speeds"),
    "rest on the way": ("speeds = [1, 0, 1]", "drive.stroke.speeds[1]"),
    "rest alone": ("speeds = [0, 0]", "drive.stroke.speeds[1]"),
    "a speed back": ("speeds = [1, -1]", "drive.stroke.speeds[1]"),
    "two laws": ("speeds = [1, 2]\nspeed = 1", "drive.stroke.speed"),
    "other ends": ("speeds = [1, 2]\nplaces = [0.5, 0.7]", "drive.stroke.places"),
    "back and forth": ("speeds = [1, 2, 1]\nplaces = [0.5, 0.7, 0.6]", "drive.stroke.places"),
}


@pytest.mark.parametrize("name", LAWS)
def test_a_law_that_does_not_fit_its_stroke_is_refused_at_its_key(name: str) -> None:
    law, where = LAWS[name]
    drive = f"link = 1\n[drive.stroke]\nfrom = 0.5\nto = 0.6\n{law}"
    with pytest.raises(SceneError) as refused:
        _ = Study(parse_scene(SLIDER_CRANK.format(crank=3, slider=1, drive=drive)))["linkage"].mechanism
    assert where in {dotted(fault.path) for fault in refused.value.faults}


RESTS = LAW.replace("[0.1, 0.3, 0.3, 0.1]", "[0, 0.3, 0.3, 0]").replace("positions = 4", "positions = 8")


def test_a_cylinder_from_rest_to_rest_has_its_force_where_it_rests() -> None:
    drive = RESTS.format(between='between = "EF"\n', begin=0.45, second=0.475, third=0.525, end=0.55)
    study = Study(parse_scene(BOOM.format(drive=drive)))
    assert all(study.comparison(part).agrees for part in ("linkage", "forces"))
    assert study["linkage"].motion(1).links[1].omega[[0, -1]].tolist() == [0, 0]
    (force,) = (one for one in study.comparison("forces").of("forces") if one.name == "P_bal")
    assert np.isfinite(force.construction).all()
    assert study["linkage"].mechanism.drive.omega > 0  # its sense is told though it begins at rest


def test_a_law_tells_its_greatest_acceleration_wherever_the_positions_lie() -> None:
    along = law_ends([(0.0, 0.05), (0.1, 0.2), (0.4, 0.2), (0.5, 0.05)]).epsilon  # v dv/ds = 0.2 * 0.15 / 0.1
    assert (np.min(along), np.max(along)) == pytest.approx((-0.3, 0.3))
    rest = law_ends([(0.45, 0.0), (0.5, 0.08), (0.7, 0.08)]).epsilon  # v^2 / 2s = 0.08^2 / 0.1
    assert (np.min(rest), np.max(rest)) == pytest.approx((0, 0.064))
