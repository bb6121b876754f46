"""Structure: groups by Assur, their formula, a plate of three links, and parts of the plans."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import permutations
from typing import NamedTuple

import numpy as np
import pytest

from geometry.board import Mark
from geometry.meet import Sizes
from plans.forces.equilibrium import LinkForce, balances
from plans.linkage.dyads import KINDS
from plans.linkage.leads import GroupKind
from plans.linkage.parts import AnalysedVectors, findings
from plans.linkage.plan import Plan, PlanLetters, Vector
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import interval
from plans.model.decomposition import decompose
from plans.model.dyad import Dyad, Pair, formula, mechanism_class, pairs
from plans.model.mechanism import FRAME, Drive, Link, Output, Slide, StructureError
from plans.model.motion import Floats
from plans.scene.scene import parse_scene, read_scene
from plans.structure.study import StructureStudy, sketched
from plans.study import Study
from tests.gallery import GALLERY
from tests.parts import some
from tests.plans import linkages
from tests.plans.linkages import ALONG_X, four_bar
from tests.plans.studies import study_of

TABLES = {
    "frame": "[mechanism.frame]\nO = [0, 0]\nC = [0, -0.350]\n",
    "links": '[mechanism.links]\n1 = "OA"\n2 = "A"\n3 = "CB"\n4 = "BD"\n5 = "D"\n',
    "lengths": "[mechanism.lengths]\nOA = 0.110\nCB = 0.620\nBD = 0.200\n",
    "sketch": "[mechanism.sketch]\nB = [0.2, 0.24]\nD = [0.4, 0.25]\n",
    "drive": '[drive]\nlink = 1\nspeed = "60 rpm"\nstart = 20\n',
}
SLOT = '[[mechanism.slides]]\nlink = 2\nalong = "CB"\n'
GUIDE = "[[mechanism.slides]]\nlink = 5\nalong = { through = [0, 0.250], angle = 0 }\n"
SHAPER = "I(0,1) -> II3(2,3) -> II2(4,5)"


@pytest.mark.parametrize("order", [*permutations(TABLES)][::17], ids="-".join)
@pytest.mark.parametrize("slides", [SLOT + GUIDE, GUIDE + SLOT], ids=["slot first", "guide first"])
def test_formula_of_the_shaper_for_any_order_of_tables(order, slides):
    lines = "".join(TABLES[name] for name in order) + slides
    study = LinkageStudy(parse_scene(lines))
    assert formula(study.mechanism, study.groups) == SHAPER
    assert mechanism_class(study.groups) == "II"


def test_a_sketch_gives_the_other_points_of_a_link_by_its_shape():
    lines = "".join(TABLES.values()) + SLOT + GUIDE + "[mechanism.points]\nK = { on = 4, at = [0.1, 0.05] }\n"
    lines += '[[structure.contacts]]\nlinks = [4, 1]\nbetween = "KO"\n'
    found = sketched(scene := parse_scene(lines), LinkageStudy(scene).mechanism).points
    assert StructureStudy(Study(scene)).structure.joints[-1].letter == "M"  # there is a point K
    assert (found["K"] - found["B"]) / (rod := found["D"] - found["B"]) == pytest.approx((0.1 + 0.05j) / abs(rod))


def test_a_roller_is_held_by_its_pin_and_its_contact():
    """W = 3·3 - 2·3 - 1 = 2, one of them local; W_s = 6·3 - 5·3 - 2 = 1: one constraint is redundant."""
    lines = "[mechanism]\nframe = { O = [0, 0] }\nlinks = { 1 = 'OA', 2 = 'B', 3 = 'BD' }\n"
    lines += "lengths = { OA = 0.03, BD = 0.12 }\nsketch = { A = [0.02, 0.02], B = [0, 0.09], D = [0, 0.2] }\n"
    lines += GUIDE.replace("5", "3") + "[drive]\nlink = 1\nspeed = 6\n"
    lines = lines.replace("angle = 0", "angle = 90") + "[[structure.contacts]]\nlinks = [1, 2]\nbetween = 'AB'\n"
    freedom = StructureStudy(Study(parse_scene(lines))).freedom
    assert (freedom.mobility, freedom.local, freedom.redundant) == (2, (2,), 1)


RRR = KINDS["RRR"]
# Each dyad, links 2 and 3: where its outer leads hang on the crank 1 and on the frame, or on the moving link 4.


def test_a_group_of_class_four_is_refused_by_name():
    """Links 2, 3, 4, 5 form a movable ring PRSQ; 2 hangs on the crank, 4 on the frame."""
    ring = {2: {"A": 0, "P": 1j, "Q": 1}, 3: {"P": 0, "R": 1}, 4: {"C": 0, "R": 1j, "S": 1}, 5: {"Q": 0, "S": 1}}
    links = {FRAME: {"O": 0, "C": 3}, 1: {"O": 0, "A": 1}, **ring}
    with pytest.raises(StructureError, match=r"class IV or higher.* driven by link 4 .* class III") as caught:
        decompose(linkages.mechanism("ring", links, (), Drive(1, "O", "A", 1, 0), {}, None))
    assert caught.value.links == (2, 3, 4, 5)


def test_a_triad_is_told_by_its_basis_link():
    (group,) = decompose(linkages.triad())
    assert (group.label, group.order, group.links) == ("III(2,3,4,5)", "III", (2, 4, 5, 3))


PLATE = {"B": 0.3 + 0j, "D": 0.25 + 0.1j}  # in the rocker's frame
PLATE_GUIDE = Slide(6, FRAME, ALONG_X, ALONG_X, "E", "")
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


class ThreeLinks(GroupKind[Three]):
    """A dyad RRR, with a plate on its second link."""

    def positions(self, plan: Plan, group: Three, side: Sizes) -> None:
        RRR.positions(plan, group.dyad, side)
        _weld(plan, group)

    def velocities(self, plan: Plan, group: Three) -> None:
        RRR.velocities(plan, group.dyad)
        _weld(plan, group)

    def accelerations(self, plan: Plan, group: Three) -> None:
        RRR.accelerations(plan, group.dyad)
        _weld(plan, group)

    def meeting(self, plan: Plan, group: Three) -> Mark:
        return RRR.meeting(plan, group.dyad)

    def vectors(self, group: Three) -> Iterable[Vector]:
        return RRR.vectors(group.dyad)

    def pressure(self, plan: Plan, group: Three) -> Floats:
        return RRR.pressure(plan, group.dyad)

    def extremes(self, plan: Plan, group: Three, side: float) -> list[Mark]:
        return RRR.extremes(plan, group.dyad, side)


def _weld(plan: Plan, group: Three) -> None:
    plan.images[group.plate] = plan.images[group.dyad.links[1]]
    if plan.below:
        plan.readings[group.plate] = plan.readings[group.dyad.links[1]]


@pytest.fixture(autouse=True)
def row(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(KINDS, "three", ThreeLinks())


def studied(plate: bool) -> LinkageStudy:
    """Study a four-bar that moves a slider by its rocker's point D, or by the same point of a plate on the rocker."""
    bar = four_bar(0.1, 0.35, 0.3, 0.35, sketch=SKETCH)
    wing = {4: PLATE} if plate else {3: {**bar.links[3].points, "D": PLATE["D"]}}
    links = {**bar.links, **{number: Link(number, points) for number, points in {**wing, **ROD}.items()}}
    study = study_of(replace(bar, links=links, slides=(PLATE_GUIDE,), output=Output(6, "E")), None, 24)
    four = Dyad("RRR", (2, 3), (1, FRAME), ("A", "C"), "B")
    last = Dyad("RRP", (5, 6), (4 if plate else 3, FRAME), ("D", PLATE_GUIDE), "E")
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
    arrows = AnalysedVectors(study.mechanism, study.motion(), 0, PlanLetters(study.mechanism)).arrows(study.groups)
    assert ("velocities", "a", "b") in arrows and ("accelerations", "n_BA", "b") in arrows
    parts = [LinkForce(link, *5 * [np.zeros(24)]) for link in study.mechanism.links if link != FRAME]
    sums = balances(study.mechanism, study.groups, parts, np.zeros(24))
    assert any("2-3-4" in found.name for found in sums)


SCENES = ("shaper", "oscillating-cylinder", "squeezer", "walking-leg", "planer", "v-engine", "tangent")


@pytest.mark.parametrize("name", some(SCENES, 3))
def test_every_part_is_what_its_formula_says(name: str) -> None:
    study = LinkageStudy(read_scene(GALLERY / f"{name}.toml"))
    told = findings(study, compare(study), {"S": (2, 0.03 + 0.02j)})
    assert {one.name.partition("_")[0] for one in told} >= {"v", "a", "a^n", "a^t"}
    for one in told:
        assert np.nanmax(one.excess) <= 1, one.name
