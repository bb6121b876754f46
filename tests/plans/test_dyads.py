"""The five kinds of two-lead groups in general position, on links that move: worked values of M3.7, all ten digits."""

from __future__ import annotations

import cmath
from math import radians

import numpy as np
import pytest

from geometry.board import Reading
from plans.linkage.dyads import KINDS
from plans.linkage.plan import Image, Plan, rate
from plans.model.dyad import Dyad
from plans.model.mechanism import Drive, Slide, Way
from tests.plans import linkages
from tests.plans.digits import printed
from tests.plans.studies import value

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
            guided(plan, order, guide)
        plans.append(plan)
    return plans


def guided(plan: Plan, order: int, guide: int) -> None:
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


AXIS = Way(0j, 1 + 0j)
SWAPPED = pytest.mark.parametrize("swapped", [False, True], ids=["as named", "the other way round"])


@SWAPPED
def test_kind_3_named_from_the_slotted_link(swapped):
    """The same group with its slotted link first: the pivot then lies ahead of the pin or behind it."""
    links = {2: {"C": 0j}, 3: {"A": 0j}}
    slot = pair(3, AXIS, 2, Way(-0.03j, 1 + 0j), swapped)
    r, v, a = drawn(Dyad("RPR", (2, 3), (6, 5), ("C", "A"), slot), links, side=-1.0)
    assert printed(value(r.place(2, -0.03j, "T").point)) == (0.4533901382 + 0.009807833918j,)
    assert rates(v, 2, 3) == (-2.044243565, -2.044243565)
    assert rates(a, 2, 3) == (29.07073353, 29.07073353)
