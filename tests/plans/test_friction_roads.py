"""Friction by both roads: of any machine they tell the same powers, efficiency, wear and jams, to rounding."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.forces import friction
from plans.forces.friction_quantities import FRICTION
from plans.forces.quantities import compare_forces
from plans.forces.statics import Statics
from plans.linkage.quantities import MotionComparison, compare
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Friction
from plans.model.machine import Rubbing
from plans.quantity import Quantity
from plans.scene.scene import read_scene
from tests.gallery import LINKAGES
from tests.parts import some
from tests.plans.chains import numbers
from tests.plans.loaded import Loaded, loaded, push

SHAPER = next(path for path in LINKAGES if path.stem == "shaper-loaded")


def rubbed(one: Loaded, f: float, radius: float, length: float) -> Loaded:
    """Give all pairs of a machine friction: `radius` and `length` are shares of the longest arm."""
    hinge, slide = Rubbing(f, radius * one.size), Rubbing(f, 0.0, length * one.size)
    told = one.statics.pairs
    friction = {pair.key: hinge if isinstance(pair.joint, str) else slide for pair in told}
    return replace(one, machine=replace(one.machine, friction=friction))


def of_friction(one: Loaded) -> list[Quantity]:
    return [found for found in compare_forces(one.statics, compare(one.study)).findings if found.plan == FRICTION]


@push
@given(loaded(), numbers(0.01, 1.5), numbers(0.01, 0.3), st.just(0.0) | numbers(0.05, 1))
def test_both_roads_agree_in_the_friction_of_any_machine(one, f, radius, length):
    found = of_friction(rubbed(one, f, radius, length))
    assert {finding.name for finding in found} >= {f"N_0{one.mechanism.drive.link}", "N_us", "η"}
    for finding in found:
        assert finding.excess.max() <= 1, finding


@pytest.fixture(scope="module")
def shaper() -> tuple[LinkageStudy, MotionComparison]:
    study = LinkageStudy(read_scene(SHAPER))
    return study, compare(study)


class Wrong(NamedTuple):
    """A number of one road spoilt, and the findings that must see it."""

    field: str
    seen: str

    def spoilt(self, found: Friction) -> Friction:
        value = getattr(found, self.field)
        if isinstance(value, dict):
            key = next(iter(value))
            return replace(found, **{self.field: {**value, key: value[key] * 1.0001}})
        return replace(found, **{self.field: () if isinstance(value, tuple) else value * 1.0001})


WRONG = [
    *(Wrong(field, seen) for field, seen in (("powers", "N_01"), ("useful", "N_us"), ("efficiency", "η"))),
    *(Wrong(field, seen) for field, seen in (("cycle", "η cycle"), ("wear", "wear 23"), ("locking", "locking 03"))),
    Wrong("driving", "driving 03"),
]


@pytest.mark.parametrize("wrong", some(WRONG, 4), ids=lambda wrong: wrong.seen)
def test_a_number_of_one_road_that_is_a_hundredth_of_a_per_cent_off_is_seen(
    shaper: tuple[LinkageStudy, MotionComparison], wrong: Wrong, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = friction.friction
    monkeypatch.setattr(friction, "friction", lambda *given: wrong.spoilt(right(*given)))
    compared = compare_forces(Statics(shaper[0]), shaper[1])
    assert wrong.seen in {finding.name for finding in compared.of(FRICTION) if finding.excess.max() > 1}


def test_a_jam_that_one_road_alone_tells_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = read_scene(SHAPER)
    statics = Statics(LinkageStudy(scene))
    machine = statics.machine
    statics.__dict__["machine"] = replace(machine, friction={key: Rubbing(9.0, 0.05) for key in machine.friction})
    comparison = compare_forces(statics, compare(statics.study))
    assert comparison.agrees
    assert comparison.friction is not None
    assert comparison.friction[0].jams
    right = friction.friction
    monkeypatch.setattr(friction, "friction", lambda *given: Wrong("jams", "").spoilt(right(*given)))
    del statics.__dict__["losses"]
    compared = compare_forces(statics, compare(statics.study))
    assert {finding.name[:3] for finding in compared.findings if finding.excess.max() > 1} == {"jam"}


def test_the_worked_shaper_agrees_in_every_pair(shaper: tuple[LinkageStudy, MotionComparison]) -> None:
    found = compare_forces(Statics(shaper[0]), shaper[1])
    names = [finding.name for finding in found.of(FRICTION)]
    assert [name for name in names if name.startswith("N_")] == [
        *("N_01", "N_03", "N_05", "N_12", "N_23", "N_34", "N_45", "N_us")
    ]
    assert {"η", "η cycle", "jam 03", "jam 05", "locking 05", "driving 05", "wear 23"} <= {*names}
    assert max(float(np.max(finding.excess)) for finding in found.of(FRICTION)) <= 1
