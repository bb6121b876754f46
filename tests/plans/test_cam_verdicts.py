"""What is said of a cam is compared too: what one road alone says otherwise is told by its name (выводы двух путей)."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from plans.analytic.cam.findings import cam_found
from plans.analytic.cam.sizes import sizes
from plans.cam.quantities import ComparedCam, settled
from plans.cam.study import LAWS, PROFILE
from plans.model.cam_motion import CamFound
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.parts import several
from tests.plans.scenes import scene

# Shocks of both kinds, an angle beyond its limit, a spring that does not hold.
SCENE = scene(
    cam=['speed = "400 rpm"'], cam_follower='motion = "translating"; end = "pointed"; lift = "20 mm"',
    cam_limits="rise = 25; return = 35", cam_sizes='base = "20 mm"; offset = "2 mm"',
    cam_load='mass = "2 kg"; force = "20 N"; preload = "5 N"; stiffness = "1 N/mm"',
    cam_phases=[
        'kind = "rise"; angle = 100; law = "constant acceleration"',
        'kind = "dwell"; angle = 60',
        'kind = "return"; angle = 100; law = "constant velocity"',
        'kind = "dwell"; angle = "rest"',
    ],
)  # fmt: skip


@cache
def compared() -> ComparedCam:
    (drawing,) = Study(parse_scene(SCENE))["cam"].drawings.values()
    theirs = cam_found(drawing.cam, sizes(drawing.cam), drawing.turned)
    return ComparedCam(drawing, settled(theirs, drawing.found))


def apart(theirs: CamFound) -> list[str]:
    findings = replace(compared(), theirs=theirs).findings(frozenset({LAWS, PROFILE}))
    return [one.name for one in findings if one.excess.max() > 1]


def shocks(hard: int, **other: float) -> dict[str, Any]:
    own = compared().theirs.shocks
    place = next(k for k, one in enumerate(own) if one.order == hard)
    return {"shocks": (*own[:place], own[place]._replace(**other), *own[place + 1 :])}


def pressing(name: str) -> dict[str, Any]:
    own = compared().theirs.pressing
    assert own is not None
    value = getattr(own, name)
    more = value * 1.0001 if name == "preload" else value._replace(value=value.value * 1.0001)
    return {"pressing": own._replace(**{name: more})}


def advised(**other: float) -> dict[str, Any]:
    own = compared().theirs.advised
    assert own is not None
    return {"advised": own._replace(**other)}


def test_both_roads_say_the_same():
    found = compared().ours
    assert {one.order for one in found.shocks} == {1, 2}
    assert {one.kind for one in found.flaws} >= {"pressure", "lift-off"}
    assert found.mending is not None and found.advised is not None
    assert apart(compared().theirs) == []


@pytest.mark.parametrize(
    ("other", "told"),
    several(
        [
            (lambda: shocks(2, jump=0.03), ["ΔS''"]),
            (lambda: shocks(1, jump=0.03), ["ΔS'"]),
            (lambda: shocks(1, turned=1.0), ["φ shocks"]),
            (lambda: shocks(1, order=2), ["φ shocks"]),
            (lambda: {"shocks": compared().theirs.shocks[1:]}, ["φ shocks"]),
            (lambda: pressing("least"), ["N_min"]),
            (lambda: pressing("most"), ["N_max"]),
            (lambda: pressing("wear"), ["N·v_sl"]),
            (lambda: pressing("preload"), ["preload"]),
            (lambda: {"pressing": None}, ["N_min"]),
            (lambda: {"flaws": compared().theirs.flaws[1:]}, ["flaws"]),
            (lambda: {"mending": None}, ["R_0 mending"]),
            (lambda: {"mending": 0.06}, ["R_0 mending"]),
            (lambda: {"advised": None}, ["R_0 advised"]),
            (lambda: advised(base=0.06), ["R_0 advised"]),
            (lambda: advised(offset=0.0), ["e advised"]),
        ],
        2,
    ),
)
def test_what_one_road_says_otherwise_is_told(other, told):
    assert apart(replace(compared().theirs, **other())) == told
