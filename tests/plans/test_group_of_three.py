"""A group of three links: what is not a dyad is drawn by its own row of the table, and nothing else counts its links.

It is a dyad of class II with a plate welded to its second link, which no mechanism is broken into: a row for the test.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest

from geometry.board import Mark
from geometry.meet import Sizes
from plans.forces.equilibrium import LinkForce, balances
from plans.linkage.groups import lead, rrr
from plans.linkage.groups.kinds import KINDS, Kind
from plans.linkage.groups.vectors import Vector
from plans.linkage.letters import Letters
from plans.linkage.parts import Expected
from plans.linkage.plan import Plan
from plans.linkage.pressure import interval
from plans.linkage.study import LinkageStudy
from plans.model.dyad import Dyad, Pair, formula, mechanism_class, pairs
from plans.model.mechanism import FRAME, Link, Output, Slide
from plans.model.motion import Floats
from tests.plans.linkages import ALONG_X, four_bar
from tests.plans.studies import study_of

PLATE = {"B": 0.3 + 0j, "D": 0.25 + 0.1j}  # in the rocker's frame
GUIDE = Slide(6, FRAME, ALONG_X, ALONG_X, "E", "")
ROD = {5: {"D": 0j, "E": 0.6 + 0j}, 6: {"E": 0j}}
SKETCH = {"B": 0.2 + 0.28j, "D": 0.15 + 0.2j, "E": 0.9 + 0j}


class Three(NamedTuple):
    """A dyad RRR and the plate."""

    dyad: Dyad
    plate: int
    kind: str = "three"
    order: str = "III"

    @property
    def links(self) -> tuple[int, ...]:
        return (*self.dyad.links, self.plate)

    @property
    def label(self) -> str:
        return f"III({','.join(map(str, self.links))})"

    @property
    def outer_pairs(self) -> tuple[Pair, ...]:
        return self.dyad.outer_pairs

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        return (*self.dyad.inner_pairs, Pair(self.dyad.links[1], self.plate, self.dyad.pin))


def positions(plan: Plan, group: Three, side: Sizes) -> None:
    rrr.positions(plan, group.dyad, side)
    _weld(plan, group)


def velocities(plan: Plan, group: Three) -> None:
    rrr.velocities(plan, group.dyad)
    _weld(plan, group)


def accelerations(plan: Plan, group: Three) -> None:
    rrr.accelerations(plan, group.dyad)
    _weld(plan, group)


def meeting(plan: Plan, group: Three) -> Mark:
    return lead.meeting(plan, group.dyad)


def vectors(group: Three) -> Iterator[Vector]:
    return rrr.vectors(group.dyad)


def pressure(plan: Plan, group: Three) -> Floats:
    return rrr.pressure(plan, group.dyad)


def extremes(plan: Plan, group: Three, side: float) -> list[Mark]:
    return rrr.extremes(plan, group.dyad, side)


def _weld(plan: Plan, group: Three) -> None:
    plan.images[group.plate] = plan.images[group.dyad.links[1]]
    if plan.below:
        plan.readings[group.plate] = plan.readings[group.dyad.links[1]]


@pytest.fixture(autouse=True)
def row(monkeypatch: pytest.MonkeyPatch) -> None:
    kind = Kind(positions, velocities, accelerations, 2, meeting, vectors, pressure, extremes=extremes)
    monkeypatch.setitem(KINDS, "three", kind)


def studied(plate: bool) -> LinkageStudy:
    """Study a four-bar that moves a slider by its rocker's point D, or by the same point of a plate on the rocker."""
    bar = four_bar(0.1, 0.35, 0.3, 0.35, sketch=SKETCH)
    wing = {4: PLATE} if plate else {3: {**bar.links[3].points, "D": PLATE["D"]}}
    links = {**bar.links, **{number: Link(number, points) for number, points in {**wing, **ROD}.items()}}
    study = study_of(replace(bar, links=links, slides=(GUIDE,), output=Output(6, "E")), None, 24)
    four = Dyad("RRR", (2, 3), (1, FRAME), ("A", "C"), "B")
    last = Dyad("RRP", (5, 6), (4 if plate else 3, FRAME), ("D", GUIDE), "E")
    study.__dict__["groups"] = (Three(four, 4) if plate else four, last)
    return study


def test_it_is_drawn_as_the_same_links_without_the_plate_are() -> None:
    three, two = studied(True), studied(False)
    ours, theirs = three.motion(), two.motion()
    assert ours.points.keys() == theirs.points.keys() and not ours.gaps
    for name, point in theirs.points.items():
        assert all(np.array_equal(one, other) for one, other in zip(ours.points[name], point, strict=True)), name
    assert all(np.array_equal(one, other) for one, other in zip(ours.links[4], ours.links[3], strict=True))
    ends, same = three.extreme_positions, two.extreme_positions
    assert ends is not None and same is not None and ends.extremes == same.extremes


def test_its_pressure_angle_and_its_barriers_are_those_of_its_row() -> None:
    three, two = studied(True), studied(False)
    assert not three.barriers
    for group, other in zip(three.groups, two.groups, strict=True):
        assert interval(three.sweep, group) == interval(two.sweep, other)


def test_its_class_its_pairs_and_its_vectors_are_told() -> None:
    study = studied(True)
    assert formula(study.mechanism, study.groups) == "I(0,1) -> III(2,3,4) -> II2(5,6)"
    assert mechanism_class(study.groups) == "III"
    keys = [pair.key for pair in pairs(study.mechanism, study.groups)]
    assert keys == ["0-1", "1-2", "0-3", "2-3", "3-4", "4-5", "0-6", "5-6"]
    arrows = Expected(study.mechanism, study.motion(), 0, Letters(study.mechanism)).arrows(study.groups)
    assert ("velocities", "a", "b") in arrows and ("accelerations", "n_BA", "b") in arrows
    parts = [LinkForce(link, *5 * [np.zeros(24)]) for link in study.mechanism.links if link != FRAME]
    sums = balances(study.mechanism, study.groups, parts, np.zeros(24))
    assert any("2-3-4" in found.name for found in sums)
