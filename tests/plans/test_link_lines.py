"""Slots and rods that have a direction of their own in their link, so that no second point is needed to show it."""

from __future__ import annotations

import pytest

from plans.linkage.reading.linkage import mechanism_of
from plans.linkage.study import LinkageStudy
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from tests.plans.scenes import scene

HEAD = scene(
    'sheets = ["kinematics", "forces"]',
    drive='link = 1; speed = "60 rpm"; acceleration = 2; positions = 12; start = {start}',
    loads="gravity = 9.81", sketch="{sketch}", points="{points}",
)  # fmt: skip
# The yoke of the sine mechanism: B on the guide, the slot square to it.
YOKE = scene(
    frame="O = [0, 0]", links="OA A B", lengths='OA = "60 mm"',
    slides=["link = 2; along = {line}", 'link = 3; along = {{ through = [0, "-80 mm"], angle = 0 }}'],
    masses='2 = {{ mass = 0.3 }}; 3 = {{ mass = 4, centre = [0, "80 mm"] }}',
    forces=['on = 3; point = "B"; against = "motion"; value = 400; during = "working stroke"'],
)  # fmt: skip
# A coupler with a slot across it, through its point B, in which a stone runs that is hinged to a slider of the frame.
COUPLER = scene(
    frame='O = [0, 0]; C = ["300 mm", 0]', links="OA AB CB D D",
    lengths='OA = "80 mm"; AB = "300 mm"; CB = "200 mm"',
    slides=["link = 4; along = {line}", 'link = 5; along = {{ through = [0, "350 mm"], angle = 0 }}'],
    masses='2 = {{ mass = 1, inertia = 0.01, centre = "middle" }}; 5 = {{ mass = 2 }}',
)  # fmt: skip


def study_of(text: str, line: str, points: str = "", sketch: str = "", start: int = 20) -> LinkageStudy:
    sketch += "\nB = [0.32, 0.2]" if text is COUPLER else ""
    return LinkageStudy(parse_scene(HEAD.format(start=start, points=points, sketch=sketch) + text.format(line=line)))


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
