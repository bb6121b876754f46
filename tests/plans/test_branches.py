"""The assembly is chosen once and kept; where the mechanism may go on in two ways, or in none, it is told."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, sqrt

import numpy as np
import pytest

from geometry.meet import EPS
from plans.analytic.kinematics import solve
from plans.linkage.sketch import SketchError
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Link, Mechanism, Way
from plans.scene.scene import parse_scene
from tests.plans import linkages
from tests.plans.scenes import scene
from tests.plans.studies import study_of

CHANGE, BEYOND, OUT = "change point", "beyond a change point", "out of reach"
KITE = linkages.four_bar(0.2, 0.3, 0.3, 0.2, sketch={"B": 0.3 + 0.2j})
RHOMBUS = linkages.four_bar(0.2, 0.2, 0.2, 0.2, sketch={"B": 0.3 + 0.2j})
PARALLELOGRAM = linkages.parallelogram(0.1, 0.3)
FOLDING = linkages.slider_crank(0.1, 0.1)  # r = l, e = 0: the slider may stay at O while the crank turns


@pytest.mark.parametrize("miss", [1e-2, 1e-4, 1e-6, 1e-10])
@pytest.mark.parametrize("side", [1, -1])
def test_past_a_near_change_point_the_assembly_stays(miss, side):
    mechanism = linkages.four_bar(0.1, 0.3 + 0.1 * miss, 0.2, 0.4, sketch={"B": complex(0.35, side * 0.15)})
    motion = study_of(mechanism, 6, 12).motion(0)
    r, a = motion.points["B"].r, motion.points["A"].r
    assert not motion.gaps and (side * ((r - a) * (0.4 - a).conj()).imag > 0).all()


def gaps(mechanism: Mechanism, first: int = 0) -> dict[int, tuple[str, str]]:
    """Tell the gaps of a turn, the same by both roads; what has no value must be told, and what is told has none."""
    drawn = study_of(mechanism, first).motion()
    assert all(gap.advice for gap in drawn.gaps)
    told = []
    for motion in (drawn, solve(mechanism, drawn.phi)):
        found = {gap.position: (gap.plan, gap.reason) for gap in motion.gaps}
        assert len(found) == len(motion.gaps)
        lost = [k for k, (plan, _) in found.items() if plan == "positions"]
        for name, point in motion.points.items():
            assert np.flatnonzero(np.isnan(point.r)).tolist() == lost, name
            assert np.flatnonzero(np.isnan(point.v)).tolist() == list(found), name
            assert np.flatnonzero(np.isnan(point.a)).tolist() == list(found), name
        told.append(found)
    alone = study_of(mechanism, first).motion(0)
    assert [gap.position for gap in alone.gaps] == lost
    assert told[0] == told[1]
    return told[0]


AT_CHANGE, PAST = ("velocities", CHANGE), ("positions", BEYOND)
NOWHERE, AWAY = ("positions", "dead centre"), ("positions", "not reachable")
PARALLEL = ("positions", "parallel guides")


SHORT = linkages.four_bar(0.1, 0.3, 0.145, 0.35, sketch={"B": 0.3 + 0.14j})


@pytest.mark.parametrize(
    ("mechanism", "first", "out", "away"),
    [
        (SHORT, 0, (6,), ()),
        (SHORT, 180, (0,), ()),
        (linkages.four_bar(0.1, 0.1, 0.1, 1.0, sketch={"B": 0.5 + 0.1j}), 0, range(12), ()),
        # Assembled for 0.2 < |AC| < 0.6: an arc that no motion leads to.
        (linkages.four_bar(0.3, 0.4, 0.2, 0.4, sketch={"B": 0.5 + 0.2j}), 60, (2, 3, 4, 5, 6, 10), (7, 8, 9)),
    ],
    ids=["at a position", "at the first", "everywhere", "two arcs"],
)
def test_what_is_out_of_reach_is_told_and_what_no_motion_leads_to(mechanism, first, out, away):
    assert gaps(mechanism, first) == {**dict.fromkeys(out, ("positions", OUT)), **dict.fromkeys(away, AWAY)}


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


def askew(mechanism: Mechanism, turn: complex) -> Mechanism:
    """Turn the frame, so that what happens on it falls between the angles that a sweep looks at first."""
    frame = Link(FRAME, {name: place * turn for name, place in mechanism.links[FRAME].points.items()})
    slides = tuple(
        slide._replace(on_owner=Way(slide.on_owner.through * turn, slide.on_owner.direction * turn))
        for slide in mechanism.slides
    )
    sketch = {name: place * turn for name, place in mechanism.sketch.items()}
    return replace(mechanism, links={**mechanism.links, FRAME: frame}, slides=slides, sketch=sketch)


@pytest.mark.parametrize(
    "mechanism", [linkages.parallelogram(1.0, 5.0), FOLDING], ids=["parallelogram", "r = l, e = 0"]
)
def test_a_change_point_between_two_looks_is_found(mechanism):
    """The same frames turned by 53.13 degrees, which 3, 4 and 5 make exact."""
    straight = [(barrier.start + barrier.end) / 2 for barrier in study_of(mechanism, 30).barriers]
    study = study_of(askew(mechanism, 0.6 + 0.8j), 83)
    turned = [(barrier.start + barrier.end) / 2 for barrier in study.barriers]
    expected = sorted((angle + atan2(0.8, 0.6)) % (2 * np.pi) for angle in straight)
    assert sorted(angle % (2 * np.pi) for angle in turned) == pytest.approx(expected, abs=10 * sqrt(EPS))
    assert {barrier.kind for barrier in study.barriers} == {CHANGE}
    assert {gap.reason for gap in study.motion(0).gaps} == {BEYOND}


def test_pins_that_fall_into_one_leave_no_place():
    """The kite and the rhombus with A on C: AB may point anywhere. The crank comes there, but no further."""
    assert gaps(KITE, 30) == {11: NOWHERE}
    assert gaps(RHOMBUS, 30) == {5: AT_CHANGE, **dict.fromkeys(range(6, 11), PAST), 11: NOWHERE}


def test_a_slot_through_its_own_pivot():
    assert gaps(linkages.slotted_link(0.2, 0.2, 0.5)) == {9: NOWHERE}


def test_guides_that_fall_parallel():
    """The tangent mechanism at 90 degrees: its pin runs to infinity, and comes back from the other end."""
    assert gaps(linkages.tangent_mechanism(0.15)) == {3: PARALLEL, 9: PARALLEL, **dict.fromkeys(range(4, 9), AWAY)}


@pytest.mark.parametrize(
    ("mechanism", "first"),
    [(PARALLELOGRAM, 0), (PARALLELOGRAM, 180), (KITE, 0), (RHOMBUS, 0), (RHOMBUS, 180), (FOLDING, 0), (FOLDING, 90)],
)
def test_a_start_at_a_change_point_is_an_error_that_tells_what_to_do(mechanism, first):
    with pytest.raises(SketchError, match="start from another crank angle"):
        study_of(mechanism, first).motion()


NARROW = scene(
    frame="O = [0, 0]; C = [0.6, 0]",
    links="OA AB CB",
    lengths="OA = 0.1; AB = 0.4; CB = {rocker}",
    sketch="B = [0.5, 0.25]",
    drive="link = 1; speed = 10; positions = 12; start = 90",
)


@pytest.mark.parametrize("degrees", [0.4, 0.1, 0.01])
def test_a_gap_narrower_than_the_looks_is_found(degrees: float) -> None:
    """Stretched at 180 degrees but for a hair: the crank cannot pass a fraction of a degree of its turn."""
    half = np.radians(degrees / 2)
    reach = abs(0.6 - 0.1 * np.exp(1j * (np.pi - half)))
    study = LinkageStudy(parse_scene(NARROW.format(rocker=float(reach - 0.4)), "narrow.toml"))
    (barrier,) = study.barriers
    assert np.degrees([barrier.start, barrier.end]) == pytest.approx([180 - degrees / 2, 180 + degrees / 2], abs=1e-5)
    assert [gap.reason for gap in study.motion(0).gaps] == ["out of reach"]  # 180 itself; the rest is reached round it


def test_a_short_rod_stays_on_its_own_side() -> None:
    """Rod half as long as the crank: dead centres at 30, 150, 210, 330 degrees; the far ones are not limits of ours."""
    mechanism = linkages.slider_crank(1.0, 0.5)
    found = gaps(mechanism, 0)
    assert found[1] == ("velocities", "dead centre")
    assert found[5][0] == found[7][0] == "positions"
