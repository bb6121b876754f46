"""Slots and rods that have a direction of their own in their link, so that no second point is needed to show it."""

from __future__ import annotations

from math import radians

import numpy as np
import pytest

from plans.forces.statics import Statics
from plans.linkage.quantities import compare
from plans.linkage.reading.linkage import mechanism_of
from plans.linkage.study import LinkageStudy
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from tests.plans.scenes import scene

HEAD = scene(
    'sheets = ["kinematics", "forces"]',
    drive='link = 1; speed = "60 rpm"; acceleration = 2; positions = 12; start = {start}',
    loads="gravity = 9.81",
    sketch="{sketch}",
    points="{points}",
)
# The yoke of the sine mechanism: B on the guide, the slot square to it.
YOKE = scene(
    frame="O = [0, 0]",
    links="OA A B",
    lengths='OA = "60 mm"',
    slides=["link = 2; along = {line}", 'link = 3; along = {{ through = [0, "-80 mm"], angle = 0 }}'],
    masses='2 = {{ mass = 0.3 }}; 3 = {{ mass = 4, centre = [0, "80 mm"] }}',
    forces=['on = 3; point = "B"; against = "motion"; value = 400; during = "working stroke"'],
)
# A lever about C whose slot leans by 25 degrees from the lever's own +x and passes beside C, and its mass off both.
LEVER = scene(
    frame='O = [0, 0]; C = [0, "-200 mm"]',
    links="OA A C",
    lengths='OA = "70 mm"',
    slides=["link = 2; along = {line}"],
    masses='2 = {{ mass = 0.4, inertia = 0.001 }}; 3 = {{ mass = 3, inertia = 0.02, centre = ["150 mm", "40 mm"] }}',
    moments=['on = 3; against = "motion"; value = 15'],
)
# A piston rod on the crank's pin, with no piston named; the cylinder swings about C.
ROD = scene(
    frame='O = [0, 0]; C = ["-300 mm", "-100 mm"]',
    links="OA A C",
    lengths='OA = "80 mm"',
    slides=["link = 3; along = {line}"],
    masses='2 = {{ mass = 1, inertia = 0.01, centre = [0, "-90 mm"] }}; 3 = {{ mass = 2, inertia = 0.02 }}',
)
# A coupler with a slot across it, through its point B, in which a stone runs that is hinged to a slider of the frame.
COUPLER = scene(
    frame='O = [0, 0]; C = ["300 mm", 0]',
    links="OA AB CB D D",
    lengths='OA = "80 mm"; AB = "300 mm"; CB = "200 mm"',
    slides=["link = 4; along = {line}", 'link = 5; along = {{ through = [0, "350 mm"], angle = 0 }}'],
    masses='2 = {{ mass = 1, inertia = 0.01, centre = "middle" }}; 5 = {{ mass = 2 }}',
)
# A scene, a line of it by its angle, the same line by two letters, what places the second point and what shows it.
WRITTEN = {
    "yoke": (YOKE, "{ link = 3, angle = 90 }", '"BC"', 'C = { on = 3, at = [0, "160 mm"] }', ""),
    "lever": (
        LEVER,
        '{ link = 3, through = ["20 mm", "30 mm"], angle = 25 }',
        '"DE"',
        'D = { on = 3, at = ["20 mm", "30 mm"] }\nE = { on = 3, at = [0.2012615574073300, 0.1145236523481399] }',
        "E = [0.08, 0.02]",
    ),
    "rod": (ROD, "{ link = 2, angle = -90 }", '"AB"', 'B = { on = 2, at = [0, "-450 mm"] }', "B = [-0.35, -0.12]"),
    "coupler": (
        COUPLER,
        '{ link = 2, through = "B", angle = 70 }',
        '"BE"',
        "E = { on = 2, at = [0.4026060429977007, 0.2819077862357725] }",
        "",
    ),
}
SAME = (
    1e-12  # of the largest: the second point is written with sixteen digits, and no meeting is sharper than kappa 100
)


def study_of(text: str, line: str, points: str = "", sketch: str = "", start: int = 20) -> LinkageStudy:
    sketch += "\nB = [0.32, 0.2]" if text is COUPLER else ""
    return LinkageStudy(parse_scene(HEAD.format(start=start, points=points, sketch=sketch) + text.format(line=line)))


def same(first: object, second: object) -> bool:
    one, other = np.asarray(first), np.asarray(second)
    return bool(np.abs(one - other).max() <= SAME * max(np.abs(other).max(), 1.0))


@pytest.mark.parametrize("name", WRITTEN)
def test_a_second_point_that_only_shows_the_direction_changes_nothing(name: str) -> None:
    text, by_angle, by_letters, points, sketch = WRITTEN[name]
    alone, twin = study_of(text, by_angle), study_of(text, by_letters, points, sketch)
    assert compare(alone).agrees and compare(twin).agrees
    for point, moved in alone.motion().points.items():
        assert all(same(*rows) for rows in zip(moved, twin.motion().points[point], strict=True)), point
    for link, (turned, *rates) in alone.motion().links.items():
        other, *its_rates = twin.motion().links[link]
        assert same(np.exp(1j * turned), np.exp(1j * other)) and all(map(same, rates, its_rates)), link
    forces, others = (Statics(study).forces for study in (alone, twin))
    assert same(forces.balancing.moment, others.balancing.moment)
    for pair, reaction in forces.reactions.items():
        assert same(reaction.force, others.reactions[pair].force), pair


@pytest.mark.parametrize(("angle", "start"), [(0, 20), (0, 250), (90, 20), (180, 250), (-30, 130)])
def test_a_slot_runs_from_its_link_s_point_through_the_stone(angle: int, start: int) -> None:
    """No sketch can tell a lever of one point from the same turned end for end: its angle does."""
    comparison = compare(study_of(LEVER, f"{{ link = 3, angle = {angle} }}", start=start))
    for found in (comparison.construction, comparison.analysis):
        reach = found.points["A"].r + 0.2j
        assert same(np.exp(1j * (found.links[3].angle + radians(angle))), reach / abs(reach))


FAULTS = {  # of the line, and what is told of it
    '{ through = "B", angle = 90 }': ("along.through", "add link = 3"),
    "{ link = 7, angle = 90 }": ("along.link", "there is no link 7"),
    "{ link = 2, angle = 90 }": ("along.link", "a line of another link"),
    '{ link = 3, through = "O", angle = 90 }': ("along.through", "a point of link 3: B; O is none"),
    "{ angle = 90 }": ("along.through", "point of the line"),
    "{ link = 1, angle = 90 }": ("links.2", "A and the line of link 1"),
}


@pytest.mark.parametrize("line", FAULTS)
def test_a_mistake_is_told_once_at_its_place(line: str) -> None:
    with pytest.raises(SceneError) as told:
        mechanism_of(study_of(YOKE, line).scene)
    (fault,) = told.value.faults
    place, words = FAULTS[line]
    assert place in str(fault) and words in str(fault)
