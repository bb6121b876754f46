"""The five kinds of two-lead groups in general position, on links that move: worked values of M3.7, all ten digits."""

from __future__ import annotations

import cmath
from math import radians

import numpy as np
import pytest

from geometry.meet import dot
from geometry.steps import Reading
from plans.linkage.dyads import KINDS
from plans.linkage.margin import rate
from plans.linkage.plan import Image, Plan
from plans.model.dyad import Dyad
from plans.model.mechanism import Drive, Slide, Way
from tests.plans import linkages
from tests.plans.digits import printed
from tests.plans.studies import shown, value

# Hinges A and C belong to links 5 and 6, which do nothing else; guides 7 and 8 are the x axes of links 7 and 8.
HINGES = {  # place m, velocity m/s, acceleration m/s2
    "A": (0.10 + 0.05j, -0.4 + 0.7j, -3 - 5j),
    "C": (0.45 - 0.02j, 0.2 - 0.1j, 1 + 2j),
}
GUIDES = {  # K: place m, velocity m/s, acceleration m/s2; then the angle deg, omega rad/s, epsilon rad/s2
    7: (0.20 - 0.05j, 0.1 + 0.2j, -0.5 + 0.4j, 15, 2.0, -3.0),
    8: (0.30 + 0.10j, -0.2 + 0.3j, 0.6 - 0.8j, 110, -1.5, 4.0),
}


def direction(guide: int, more: float = 0) -> complex:
    return cmath.exp(1j * radians(GUIDES[guide][3] + more))


def hosts(links: dict[int, dict[str, complex]], slides: tuple[Slide, ...]) -> list[Plan]:
    """Begin the three plans of a position: hinges and guides of known motion, as any mechanism may give them."""
    owners = {5: {"A": 0j}, 6: {"C": 0j}, 7: {}, 8: {}}
    mechanism = linkages.mechanism("dyad", {0: {}, **links, **owners}, slides, Drive(5, "A", "A", 1, 0), {}, None)
    plans: list[Plan] = []
    for order, subject in enumerate(("positions", "velocities", "accelerations")):
        plan = Plan(subject, mechanism, tuple(plans))
        for point, values in HINGES.items():
            plan.name(point, plan.board.given(plan.letter(point), values[order]))
        for guide in GUIDES:
            _guide(plan, order, guide)
        plans.append(plan)
    return plans


def _guide(plan: Plan, order: int, guide: int) -> None:
    omega, epsilon = GUIDES[guide][4:]
    spin = (1, 1j * omega, 1j * epsilon - omega**2)[order]
    image = plan.board.given(f"K{guide}", GUIDES[guide][order])
    plan.images[guide] = Image(image, plan.board.given(f"way {guide}", spin * direction(guide)), 0j, 1 + 0j)
    if order:
        turning = plan.board.given(f"turning {guide}", 1j * (omega, epsilon)[order - 1] * direction(guide))
        plan.readings[guide] = Reading(plan.positions.board[f"way {guide}"], turning)


def drawn(dyad: Dyad, links: dict[int, dict[str, complex]], side: float = 1.0) -> list[Plan]:
    """Draw the three plans of a dyad of links 2 and 3."""
    slides = tuple(joint for joint in (*dyad.outer, dyad.inner) if isinstance(joint, Slide))
    plans, kind = hosts(links, slides), KINDS[dyad.kind]
    with np.errstate(invalid="ignore", divide="ignore"):
        kind.positions(plans[0], dyad, side)
        kind.velocities(plans[1], dyad)
        kind.accelerations(plans[2], dyad)
    return plans


def pair(slider: int, on_slider: Way, owner: int, on_owner: Way, swapped: bool) -> Slide:
    """Give a sliding pair, either link of which may count as the one that slides."""
    if swapped:
        slider, on_slider, owner, on_owner = owner, on_owner, slider, on_slider
    return Slide(slider, owner, on_slider, on_owner, "", "")


def rates(plan: Plan, *links: int) -> tuple[complex, ...]:
    return printed(*(value(rate(plan, link)).real for link in links))


def along(plan: Plan, first: str, second: str, way: complex) -> float:
    return float(dot(way, shown(plan, second) - shown(plan, first)))


AXIS = Way(0j, 1 + 0j)
SWAPPED = pytest.mark.parametrize("swapped", [False, True], ids=["as named", "the other way round"])


def test_kind_1_two_links():
    links = {2: {"A": 0j, "B": 0.30 + 0j}, 3: {"C": 0j, "B": 0.28 + 0j}}
    r, v, a = drawn(Dyad("RRR", (2, 3), (5, 6), ("A", "C"), "B"), links)
    assert printed(shown(r, "B"), shown(v, "b"), shown(a, "b")) == (
        0.3356923697 + 0.2356047059j,
        0.2221789736 - 0.09008145837j,
        -9.206945013 - 2.566903324j,
    )
    assert rates(v, 2, 3) == (-3.352172407, -0.08677059972)
    assert rates(a, 2, 3) == (19.17222805, 39.93590656)


@SWAPPED
@pytest.mark.parametrize("left", [0, 0.04])
def test_kind_2_rod_and_slider(left, swapped):
    """The slider may hold its pin beside the guide: then the guide is drawn as far to the other side."""
    links = {2: {"A": 0j, "B": 0.25 + 0j}, 3: {"B": 0j}}
    guide = pair(3, Way(-left * 1j, 1 + 0j), 7, Way(-left * 1j, 1 + 0j), swapped)
    r, v, a = drawn(Dyad("RRP", (2, 3), (5, 7), ("A", guide), "B"), links)
    u = direction(7)
    assert printed(shown(r, "B"), shown(v, "b")) == (0.342217383 - 0.01189296708j, -0.4902797506 + 0.3466912809j)
    assert printed(along(v, "b7", "b", u)) == (-0.5321999585,)
    assert printed(shown(a, "a^k_B"), shown(a, "b")) == (0.5509739403 - 2.056262739j, -3.021824022 - 2.936900867j)
    assert printed(along(a, "k_B", "b", u)) == (-2.710611372,)
    assert rates(v, 2, 3) == (-1.458643119, 2)
    assert rates(a, 2, 3) == (7.973883512, -3)


@SWAPPED
def test_kind_3_stone_and_slotted_link(swapped):
    """The slot passes its pivot C at 0.03 m: C lies to the left of the slot, which leads from its foot T to A."""
    links = {2: {"A": 0j}, 3: {"C": 0j}}
    slot = pair(2, AXIS, 3, Way(-0.03j, 1 + 0j), swapped)
    r, v, a = drawn(Dyad("RPR", (2, 3), (5, 6), ("A", "C"), slot), links)
    foot = value(r.place(3, -0.03j, "T").point)
    u = value(r.units[slot.slider, slot.owner].point)
    assert printed(foot, np.degrees(cmath.phase(u))) == (0.4533901382 + 0.009807833918j, 173.5114528)
    assert printed(shown(v, "a3"), along(v, "a", "a3", u)) == (0.3430970495 + 0.6154852476j, -0.747887671)
    assert printed(shown(a, "a^k_A"), shown(a, "a3")) == (-0.3455374774 - 3.038142723j, 0.4276747662 - 8.467281957j)
    assert printed(along(a, "k_A", "a3", u)) == (-3.797537507,)
    assert rates(v, 2, 3) == (-2.044243565, -2.044243565)
    assert rates(a, 2, 3) == (29.07073353, 29.07073353)


@SWAPPED
def test_kind_3_named_from_the_slotted_link(swapped):
    """The same group with its slotted link first: the pivot then lies ahead of the pin or behind it."""
    links = {2: {"C": 0j}, 3: {"A": 0j}}
    slot = pair(3, AXIS, 2, Way(-0.03j, 1 + 0j), swapped)
    r, v, a = drawn(Dyad("RPR", (2, 3), (6, 5), ("C", "A"), slot), links, side=-1.0)
    assert printed(value(r.place(2, -0.03j, "T").point)) == (0.4533901382 + 0.009807833918j,)
    assert rates(v, 2, 3) == (-2.044243565, -2.044243565)
    assert rates(a, 2, 3) == (29.07073353, 29.07073353)


@SWAPPED
def test_kind_4_two_sliders(swapped):
    links = {2: {"B": 0j}, 3: {"B": 0j}}
    first = pair(2, Way(-0.02j, 1 + 0j), 7, AXIS, swapped)
    second = pair(3, Way(0.015j, 1 + 0j), 8, AXIS, swapped)
    r, v, a = drawn(Dyad("PRP", (2, 3), (7, 8), (first, second), "B"), links)
    assert printed(shown(r, "B"), shown(v, "b"), shown(a, "b")) == (
        0.3485359592 + 0.01050561394j,
        -0.3959064981 + 0.3966190336j,
        1.710961244 - 1.191888142j,
    )
    assert printed(along(v, "b7", "b", direction(7)), along(v, "b8", "b", direction(8))) == (
        -0.3881201434,
        0.1802961615,
    )
    slips = [
        dot(direction(guide), shown(a, "b") - value(line.step.inputs[0].point))
        for guide, line in zip((7, 8), _lines(a), strict=True)
    ]
    assert printed(*slips) == (2.300152495, -1.034794871)
    assert rates(v, 2, 3) == (2, -1.5) and rates(a, 2, 3) == (-3, 4)


@SWAPPED
@pytest.mark.parametrize("left", [0, 0.025])
def test_kind_5_stone_and_sliding_link(left, swapped):
    """The stone may hold its pin beside the slot: then the slot is cut as far to the other side."""
    links = {2: {"A": 0j}, 3: {"N": 0j}}
    cut = cmath.exp(1j * radians(70))
    slot = pair(2, Way(-left * 1j, 1 + 0j), 3, Way(-left * 1j * cut, cut), swapped)
    guide = pair(3, AXIS, 7, AXIS, swapped)
    r, v, a = drawn(Dyad("RPP", (2, 3), (5, 7), ("A", guide), slot), links)
    assert printed(value(r.point("N").point)) == (0.08864058879 - 0.0798386643j,)
    w, u = direction(7, 70), direction(7)
    assert printed(shown(v, "a3"), along(v, "a", "a3", w), along(v, "a7", "a3", u)) == (
        -0.4699137743 - 0.0991180971j,
        -0.8021705984,
        -0.3829629194,
    )
    ends = [value(line.step.inputs[0].point) for line in _lines(a)]
    slips = [dot(way, shown(a, "a3") - end) for way, end in zip((w, u), ends, strict=True)]
    assert printed(shown(a, "a3"), *slips) == (0.5541845761 - 1.190986082j, 4.104287066, -0.04377956479)
    assert rates(v, 2, 3) == (2, 2) and rates(a, 2, 3) == (-3, -3)


def _lines(plan: Plan) -> list:
    """Give the two lines of directions known that a plan meets, in the order drawn."""
    return [mark for mark in plan.board if mark.step.op == "parallel"]
