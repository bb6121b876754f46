"""The links that may carry counterweights: those that are said to do do, and none of them can be spared."""

from __future__ import annotations

from dataclasses import replace

import pytest

from plans.balance.reading import carriers, reciprocating
from plans.balance.study import counterweights, substituted
from plans.balance.weights import Refused
from plans.linkage.reading.linkage import mechanism_of
from plans.model.balance.linkage import FULL, PARTIAL, Place, Task
from plans.model.dyad import decompose
from plans.model.machine import Body
from plans.scene.scene import parse_scene, read_scene
from tests.gallery import GALLERY
from tests.plans.banks import ENGINE, FOUR_BAR


@pytest.mark.parametrize("aim", [FULL, PARTIAL])
@pytest.mark.parametrize("name", ["shaper", "conveyor", "jaw-crusher", "oscillating-cylinder", "slider-crank"])
def test_the_links_that_would_do_do(name: str, aim: str) -> None:
    mechanism = mechanism_of(read_scene(GALLERY / f"{name}.toml"))
    groups, links = decompose(mechanism), carriers(mechanism, aim)
    bodies = {link: Body(link, 1.0 + link, 0.0, 0.01 + 0.02j) for link in mechanism.links if link}
    for left in links:  # not one of them can be spared
        with pytest.raises(Refused):
            substituted(mechanism, groups, bodies, _allowing(aim, [link for link in links if link != left]))
    found = counterweights(substituted(mechanism, groups, bodies, _allowing(aim, links)), groups)
    assert all(one.needed for one in found)


def test_a_slider_on_a_moving_link_is_balanced_in_full_whatever_the_aim() -> None:
    text = FOUR_BAR.replace('3 = "BC"\n', '3 = "BC"\n4 = "AD"\n5 = "D"\n').replace(
        "BC = 0.3\n", "BC = 0.3\nAD = 0.35\n"
    )
    slide = '[[mechanism.slides]]\nlink = 5\nalong = "BC"\n[mechanism.sketch]\nD = [0.37, 0.15]\n'
    mechanism = mechanism_of(parse_scene(text.replace("[mechanism.sketch]\n", slide)))
    assert [group.label for group in decompose(mechanism)] == ["II1(2,3)", "II2(4,5)"]
    assert carriers(mechanism, PARTIAL) == [1, 3, 4]


def _allowing(aim: str, links: list[int]) -> Task:
    return Task(aim, tuple(Place(link, mass=1.0) for link in links))


def test_links_that_form_no_groups_are_told_by_what_studies_them_alone() -> None:
    mechanism = mechanism_of(parse_scene(ENGINE))
    loose = replace(mechanism, slides=())
    assert loose.mobility == 3
    assert (reciprocating(loose), carriers(loose, FULL)) == (True, [1])
