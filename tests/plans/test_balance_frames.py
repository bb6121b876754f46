"""Links told in frames of their own, begun anywhere and turned any way, are balanced as links on their own axes."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from plans.balance.quantities import compare_balance
from plans.balance.study import BalanceStudy
from plans.forces.statics import Statics
from plans.linkage.quantities import compare
from plans.model.balance.linkage import DISC, FULL, PARTIAL, REACTION, SECTOR, SHARE, BalanceTask, Counterweight, Site
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism, Way
from plans.model.motion import ACCELERATIONS
from tests.plans import linkages
from tests.plans.machines import GEARED, machine, pointed
from tests.plans.studies import study_of

SHIFT = 0.07 - 0.11j  # of link 1; each link has a frame of its own, turned and shifted more than that before


def turn(link: int) -> complex:
    """Give the direction that the axis of a link has in its other frame."""
    return cmath.rect(1, 2.3 * link)


def own(place: complex, link: int) -> complex:
    """Tell a place of a link in its other frame."""
    return place * turn(link) + SHIFT * link


def turned(mechanism: Mechanism) -> Mechanism:
    """Tell all links in their other frames."""

    def way(told: Way, link: int) -> Way:
        return told if link == FRAME else Way(own(told.through, link), told.direction * turn(link))

    links = {
        n: one._replace(points={p: own(z, n) for p, z in one.points.items()}) for n, one in mechanism.links.items()
    }
    slides = tuple(
        s._replace(on_slider=way(s.on_slider, s.slider), on_owner=way(s.on_owner, s.owner)) for s in mechanism.slides
    )
    return replace(mechanism, links=links | {FRAME: mechanism.links[FRAME]}, slides=slides)


def study(mechanism: Mechanism, its: Machine, task: BalanceTask) -> BalanceStudy:
    """Study the balance of a mechanism with its masses, told on its links' own axes or in other frames."""
    linkage = study_of(pointed(mechanism))
    statics = Statics(linkage)
    vars(statics)["machine"] = its
    return BalanceStudy(linkage, statics, task)


def bodies(rows: Mapping[int, tuple[float, complex]]) -> dict[int, Body]:
    return {link: Body(link, mass, 0.01 * mass, centre) for link, (mass, centre) in rows.items()}


# A drive by a gear, weights and an acceleration: what a share costs the shaft follows from all of them.
ENGINE = linkages.slider_crank(0.1, 0.4, 0.03, epsilon=40.0)
GEARS, SLANT = GEARED._replace(radius=0.06), cmath.rect(9.81, -2.1)  # a machine that stands on a slope
ENGINE_BODIES = bodies({1: (3, 0.04), 2: (4, 0.15), 3: (8, 0)})
CROOKED = bodies({1: (3, 0.04 + 0.02j), 2: (4, 0.15 - 0.03j), 3: (8, 0.02 + 0.01j)})
SHAPER = bodies({1: (4, 0.05 + 0.03j), 2: (1.5, 0.02j), 3: (12, 0.3 - 0.06j), 4: (3, 0.1 + 0.01j), 5: (20, 0.02)})
CASES = {
    "share": (ENGINE, machine(CROOKED, SLANT, GEARS), BalanceTask(SHARE, (Site(1, shape=SECTOR),), None, REACTION)),
    "full": (ENGINE, machine(ENGINE_BODIES), BalanceTask(FULL, (Site(1, at=-0.15), Site(2, at=-0.25)))),
    "partial": (ENGINE, machine(CROOKED), BalanceTask(PARTIAL, (Site(1, radius=0.07),))),
    "shaper": (
        linkages.shaper(),
        machine(SHAPER),
        BalanceTask(FULL, (Site(1, mass=6), Site(3, radius=0.3, shape=SECTOR), Site(4, mass=30))),
    ),
}


@cache
def studies(case: str) -> tuple[BalanceStudy, BalanceStudy]:
    """Study a case on the axes of its links, and in the other frames."""
    mechanism, its, task = CASES[case]
    other = {link: body._replace(centre=own(body.centre, link)) for link, body in its.bodies.items()}
    return study(mechanism, its, task), study(turned(mechanism), replace(its, bodies=other), task)


@pytest.mark.parametrize("case", CASES)
def test_both_roads_agree_in_other_frames(case: str) -> None:
    _, its = studies(case)
    found = compare_balance(its, compare(its.linkage, ACCELERATIONS.number))
    assert [one.name for one in found.findings if one.excess.max() > 1] == []
    assert found.agrees


GRID = 500  # of the rectangles that a shape is cut into, each way
THICK, DENSE = 0.02, 7000.0


@pytest.mark.parametrize(("shape", "half_angle"), [(DISC, np.pi), (SECTOR, 0.6), (SECTOR, 1.9)])
def test_sizes_of_a_counterweight(shape: str, half_angle: float) -> None:
    """Mass, mass centre and inertia of a disc or sector are those of its plate cut into small pieces."""
    place = Site(1, mass=5.0, shape=shape, density=DENSE, thickness=THICK)  # a disc has no half angle
    place = place if shape == DISC else place._replace(half_angle=half_angle)
    outer = Counterweight(place, "O", 0j, 0j, 5.0).outer
    cells = (np.arange(GRID) + 0.5) / GRID
    r, angle = outer * cells[:, None], half_angle * (2 * cells - 1)
    piece = THICK * DENSE * r * np.exp(0j * angle) * (outer / GRID) * (2 * half_angle / GRID)
    spots = r * np.exp(1j * angle)
    mass, moment = np.sum(piece).real, complex(np.sum(piece * spots))
    inertia = float(np.sum(piece * np.abs(spots - moment / mass) ** 2).real)
    one = Counterweight(place, "O", 0j, moment, 5.0)
    assert mass == pytest.approx(5.0, rel=1e-6)
    assert one.inertia == pytest.approx(inertia, rel=1e-4)
