"""Slots and rods that have a direction of their own in their link, so that no second point is needed to show it."""

from __future__ import annotations

from functools import cache
from math import radians

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis
from plans.forces.statics import Statics
from plans.linkage.reading.linkage import mechanism_of
from plans.linkage.study import LinkageStudy
from plans.model.motion import Motion
from plans.scene.faults import SceneError
from plans.scene.scene import parse_scene
from tests.parts import some
from tests.plans.link_lines import LEVER, WRITTEN, YOKE

# Of the largest of its kind: the twin's second point is written with sixteen digits, and no meeting here is sharper
# than kappa 100.
SAME = 1e-12
ROADS = "construction", "analysis"


@cache
def study_of(text: str) -> LinkageStudy:
    return LinkageStudy(parse_scene(text))


@cache
def motion(text: str, road: str) -> Motion:
    study = study_of(text)
    if road == ROADS[0]:
        return study.motion()
    return Analysis(study.mechanism).motion(study.turn.phi)


def same(first: object, second: object) -> bool:
    one, other = np.asarray(first), np.asarray(second)
    return bool(np.abs(one - other).max() <= SAME * max(np.abs(other).max(), 1.0))


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", some(WRITTEN, 4))
def test_a_second_point_that_only_shows_the_direction_changes_nothing(name: str, road: str) -> None:
    alone, twin = (motion(text, road) for text in (WRITTEN[name].alone, WRITTEN[name].twin))
    for point, moved in alone.points.items():
        assert all(same(one, other) for one, other in zip(moved, twin.points[point], strict=True)), point
    for link, turned in alone.links.items():
        assert same(turned.omega, twin.links[link].omega) and same(turned.epsilon, twin.links[link].epsilon), link
        assert same(np.exp(1j * turned.angle), np.exp(1j * twin.links[link].angle)), link


@pytest.mark.parametrize("name", WRITTEN)
def test_nor_does_it_change_a_force(name: str) -> None:
    alone, twin = (Statics(study_of(text)).forces for text in (WRITTEN[name].alone, WRITTEN[name].twin))
    assert same(alone.balancing.moment, twin.balancing.moment)
    for pair, reaction in alone.reactions.items():
        assert same(reaction.force, twin.reactions[pair].force), pair


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize(("angle", "start"), [(0, 20), (0, 250), (90, 20), (180, 250), (-30, 130)])
def test_a_slot_runs_from_its_link_s_point_through_the_stone(angle: int, start: int, road: str) -> None:
    """No sketch can tell a lever of one point from the same turned end for end: its angle does."""
    line = f"{{ link = 3, angle = {angle} }}"
    found = motion(LEVER._replace(by_angle=line, start=start).alone, road)
    slot = found.links[3].angle + radians(angle)
    assert same(np.exp(1j * slot), (found.points["A"].r + 0.2j) / abs(found.points["A"].r + 0.2j))


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
        mechanism_of(parse_scene(YOKE._replace(by_angle=line).alone))
    (fault,) = told.value.faults
    place, words = FAULTS[line]
    assert place in str(fault) and words in str(fault)
