"""The assembly is chosen once and kept; where the mechanism may go on in two ways, or in none, it is told."""

from __future__ import annotations

from math import acos, hypot, sin, sqrt

import numpy as np
import pytest

from geometry.meet import EPS, TANGENCY
from plans.mechanism import Mechanism
from plans.motion import Gap
from plans.sketch import SketchError
from tests.plans import linkages
from tests.plans.studies import study_of, value

LINKAGES, TURN, DENSE = 1000, 12, 3600
CHANGE, BEYOND, OUT = "change point", "beyond a change point", "out of reach"
KITE = linkages.four_bar(0.2, 0.3, 0.3, 0.2, sketch={"B": 0.3 + 0.2j})
RHOMBUS = linkages.four_bar(0.2, 0.2, 0.2, 0.2, sketch={"B": 0.3 + 0.2j})
PARALLELOGRAM = linkages.parallelogram(0.1, 0.3)
FOLDING = linkages.slider_crank(0.1, 0.1)  # r = l, e = 0: the slider may stay at O while the crank turns


def crank_rockers(count: int) -> np.ndarray:
    """Draw lengths OA, AB, CB, OC of which the crank is the shortest, and which Grashof lets turn."""
    rng, found = np.random.default_rng(1883), []
    while len(found) < count:
        a, b, c, d = sizes = rng.uniform(0.05, 1.0, 4)
        if a == sizes.min() and a + sizes.max() < sizes.sum() - a - sizes.max():
            found.append((a, b, c, d))
    return np.array(found)


def ways(phi: float, lengths: np.ndarray) -> np.ndarray:
    """Give both places of B for many four-bars, (2, count), by the cosine rule."""
    a, b, c, d = lengths.T
    crank = a * np.exp(1j * phi)
    base = np.abs(d - crank)
    along = (base**2 + b**2 - c**2) / (2 * base)
    up = np.sqrt(b**2 - along**2)
    return crank + (d - crank) / base * np.array([along + 1j * up, along - 1j * up])


def continued(lengths: np.ndarray) -> np.ndarray:
    """Follow the left assembly through a turn by small steps: each place is the one that the last two lead to."""
    places = [ways(0.0, lengths)[0]]
    places.append(_nearest(ways(2 * np.pi / DENSE, lengths), places[0]))
    for k in range(2, DENSE):
        places.append(_nearest(ways(2 * np.pi * k / DENSE, lengths), 2 * places[-1] - places[-2]))
    return np.array(places[:: DENSE // TURN])


def _nearest(both: np.ndarray, expected: np.ndarray) -> np.ndarray:
    return np.where(np.abs(both[0] - expected) <= np.abs(both[1] - expected), both[0], both[1])


def test_no_crank_rocker_changes_its_assembly():
    """Promise M13: of 1,000 crank-rockers at 12 positions, the nearest-point rule loses 7 %; a side loses none."""
    lengths = crank_rockers(LINKAGES)
    truth = continued(lengths)
    for sizes, places in zip(lengths, truth.T, strict=True):
        study = study_of(linkages.four_bar(*sizes, sketch={"B": complex(places[0])}), 0, TURN)
        drawn = study.drafts().positions.point("B").point
        assert np.abs(drawn - places).max() <= 1e-6 * sizes.max(), sizes


@pytest.mark.parametrize("miss", [1e-2, 1e-4, 1e-6, 1e-10])
@pytest.mark.parametrize("side", [1, -1])
def test_past_a_near_change_point_the_assembly_stays(miss, side):
    mechanism = linkages.four_bar(0.1, 0.3 + 0.1 * miss, 0.2, 0.4, sketch={"B": complex(0.35, side * 0.15)})
    motion = study_of(mechanism, 6, 12).motion(0)
    r, a = motion.points["B"].r, motion.points["A"].r
    assert not motion.gaps and (side * ((r - a) * (0.4 - a).conj()).imag > 0).all()


def gaps(mechanism: Mechanism, first: int = 0) -> dict[int, tuple[str, str]]:
    """Tell the gaps of a turn; what has no value must be told, and all that is told is left out."""
    motion = study_of(mechanism, first).motion()
    found = {gap.position: (gap.plan, gap.reason) for gap in motion.gaps}
    assert len(found) == len(motion.gaps) and all(gap.advice for gap in motion.gaps)
    lost = [k for k, (plan, _) in found.items() if plan == "positions"]
    for name, point in motion.points.items():
        assert point.v is not None and point.a is not None
        assert np.flatnonzero(np.isnan(point.r)).tolist() == lost, name
        assert np.flatnonzero(np.isnan(point.v)).tolist() == list(found), name
        assert np.flatnonzero(np.isnan(point.a)).tolist() == list(found), name
    alone = study_of(mechanism, first).motion(0)
    assert [gap.position for gap in alone.gaps] == lost
    return found


AT_CHANGE, PAST = ("velocities", CHANGE), ("positions", BEYOND)
NOWHERE, AWAY = ("positions", "dead centre"), ("positions", "not reachable")


@pytest.mark.parametrize(
    ("mechanism", "first", "at", "past"),
    [
        (PARALLELOGRAM, 30, (5, 11), range(6, 11)),
        (linkages.four_bar(0.1, 0.3, 0.1, 0.3, sketch={"B": 0.25 - 0.1j}), 30, (5, 11), range(6, 11)),
        (linkages.four_bar(0.2, 0.2, 0.3, 0.3, sketch={"B": 0.3 + 0.2j}), 30, (5, 11), range(6, 11)),
        (FOLDING, 30, (2, 8), range(3, 8)),
        (linkages.slider_crank(0.06, 0.20, 0.14), 0, (9,), ()),  # e = l - r: it may fold, and goes round either way
    ],
    ids=["parallelogram", "antiparallelogram", "kite", "r = l, e = 0", "e = l - r"],
)
def test_a_change_point_is_told_and_not_guessed(mechanism, first, at, past):
    assert gaps(mechanism, first) == {**dict.fromkeys(at, AT_CHANGE), **dict.fromkeys(past, PAST)}
    study = study_of(mechanism, first)
    assert {barrier.kind for barrier in study.barriers} == {CHANGE}
    for barrier in study.barriers:  # known to the root of a rounding, as every double root
        assert barrier.end - barrier.start < 100 * sqrt(EPS)


def test_pins_that_fall_into_one_leave_no_place():
    """The kite and the rhombus with A on C: AB may point anywhere. The crank comes there, but no further."""
    assert gaps(KITE, 30) == {11: NOWHERE}
    assert gaps(RHOMBUS, 30) == {5: AT_CHANGE, **dict.fromkeys(range(6, 11), PAST), 11: NOWHERE}


def test_a_slot_through_its_own_pivot():
    assert gaps(linkages.slotted_link(0.2, 0.2, 0.5)) == {9: NOWHERE}


def test_guides_that_fall_parallel():
    """The tangent mechanism at 90 degrees: its pin runs to infinity, and comes back from the other end."""
    assert gaps(linkages.tangent_mechanism(0.15)) == {3: NOWHERE, 9: NOWHERE, **dict.fromkeys(range(4, 9), AWAY)}


@pytest.mark.parametrize("count", [12, 359, 360, 1000])
def test_a_parallelogram_stays_one_as_far_as_it_is_drawn(count):
    study = study_of(PARALLELOGRAM, 30, count)
    motion = study.motion(0)
    a, b, reached = motion.points["A"].r, motion.points["B"].r, ~study.lost
    far = np.abs(np.sin(motion.phi)) > 1e-3
    kappa = 1 / np.abs(np.sin(motion.phi[reached & far]))
    assert (np.abs(b - a - 0.3)[reached & far] <= 8 * EPS * kappa).all()
    assert count / 2 - 1 <= reached.sum() <= count / 2 + 1


@pytest.mark.parametrize(
    ("mechanism", "first"),
    [(PARALLELOGRAM, 0), (PARALLELOGRAM, 180), (KITE, 0), (RHOMBUS, 0), (RHOMBUS, 180), (FOLDING, 0), (FOLDING, 90)],
)
def test_a_start_at_a_change_point_is_an_error_that_tells_what_to_do(mechanism, first):
    with pytest.raises(SketchError, match="start from another crank angle"):
        study_of(mechanism, first).motion()


def of(mechanism: Mechanism, first: int = 0) -> dict[int, Gap]:
    return {gap.position: gap for gap in study_of(mechanism, first).motion().gaps}


def test_limits_of_a_double_rocker():
    mechanism = linkages.four_bar(0.3, 0.2, 0.25, 0.4, sketch={"B": 0.45 + 0.25j})
    limit = acos((0.3**2 + 0.4**2 - 0.45**2) / (2 * 0.3 * 0.4))  # coupler and rocker in one line
    (barrier,) = study_of(mechanism).barriers
    blind = 2 * TANGENCY * EPS * (0.45 + 0.45) / (0.3 * 0.4 * sin(limit) / 0.45)  # arcs that touch, over d|AC|/dφ
    assert (barrier.start, barrier.end) == pytest.approx((limit, 2 * np.pi - limit), abs=blind)
    assert barrier.miss == pytest.approx(0.7 - 0.45)
    found = of(mechanism)
    assert list(found) == list(range(3, 10))
    for k, gap in found.items():
        apart = abs(0.4 - 0.3 * np.exp(1j * np.radians(30 * k)))
        assert (gap.plan, gap.reason, gap.where) == ("positions", OUT, "B")
        assert gap.miss == pytest.approx(apart - 0.45)
        assert f"{apart:.6g} m apart" in gap.advice and "0.45 m: lengthen one of them" in gap.advice


def test_a_dead_centre_between_two_drawn_positions():
    """The links are too short round 180 degrees only: one position of twelve is lost, and the assembly is kept."""
    mechanism = linkages.four_bar(0.1, 0.3, 0.145, 0.35, sketch={"B": 0.3 + 0.14j})
    found = of(mechanism)
    assert list(found) == [6] and found[6].miss == pytest.approx(0.45 - 0.445)
    (barrier,) = study_of(mechanism).barriers
    limit = acos((0.1**2 + 0.35**2 - 0.445**2) / (2 * 0.1 * 0.35))
    blind = 2 * TANGENCY * EPS * (0.445 + 0.445) / (0.1 * 0.35 * sin(limit) / 0.445)
    assert (barrier.start, barrier.end) == pytest.approx((limit, 2 * np.pi - limit), abs=blind)
    motion = study_of(mechanism).motion(0)
    side = ((motion.points["B"].r - motion.points["A"].r) * (0.35 - motion.points["A"].r).conj()).imag
    assert (np.delete(side, 6) > 0).all()


def test_a_first_position_out_of_reach():
    mechanism = linkages.four_bar(0.1, 0.3, 0.145, 0.35, sketch={"B": 0.3 + 0.14j})
    assert [(k, gap.reason) for k, gap in of(mechanism, 180).items()] == [(0, OUT)]


def test_a_link_too_short_everywhere():
    found = of(linkages.four_bar(0.1, 0.1, 0.1, 1.0, sketch={"B": 0.5 + 0.1j}))
    assert list(found) == list(range(12)) and {gap.reason for gap in found.values()} == {OUT}
    assert found[0].miss == pytest.approx(0.9 - 0.2)


def test_an_arc_that_no_motion_leads_to():
    found = of(linkages.four_bar(0.3, 0.4, 0.2, 0.4, sketch={"B": 0.5 + 0.2j}), 60)  # assembled for 0.2 < |AC| < 0.6
    assert {k: gap.reason for k, gap in found.items()} == {
        **dict.fromkeys((2, 3, 4, 5, 6, 10), OUT),
        **dict.fromkeys((7, 8, 9), "not reachable"),
    }


@pytest.mark.parametrize("margin", [1e-2, 1e-4, 1e-6, 1e-10])
def test_a_notch_beside_a_dead_centre_carries_its_condition(margin):
    """Coupler and rocker nearly in one line: kappa is 1/sin of their angle, by the cosine rule from the exact miss."""
    mechanism = linkages.four_bar(0.1, 0.3, 0.15 + margin, 0.35, sketch={"B": 0.3 + 0.14j})
    sharpness = value(study_of(mechanism, 180, 1).drafts().positions.point("B").sharpness).real
    b, c, base = 0.3, 0.15 + margin, 0.45
    perimeter = (b + c + base) * margin * (base + b - c) * (base + c - b)
    assert sharpness == pytest.approx(sqrt(perimeter) / (2 * b * c), rel=1e-5)
    assert hypot(sharpness, (b**2 + c**2 - base**2) / (2 * b * c)) == pytest.approx(1)
