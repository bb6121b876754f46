"""Plans that are followed from their pattern: the record and the numbers of plans that are drawn act by act."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
import pytest

from geometry.board import Mark
from geometry.meet import EPS
from geometry.precision import errors
from plans.linkage import study as studies
from plans.linkage.margin import CLOSE, RUN, heading
from plans.linkage.motion_plans import accelerations, velocities
from plans.linkage.plan import Plan
from plans.linkage.primary import CrankPositions, even, listed
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import Mechanism
from tests.plans import linkages
from tests.plans.studies import driven, study_of

MECHANISMS = {
    "four-bar": linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler={"S": 0.2 + 0.09j}),
    "slider-crank": linkages.slider_crank(0.06, 0.20, 0.02),
    "slotted link": linkages.slotted_link(0.12, 0.35, 0.70),
    "Scotch yoke": linkages.scotch_yoke(0.1),
    "shaper": linkages.shaper(),
}


def drawn(study: LinkageStudy, turn: CrankPositions) -> list[Plan]:
    """Draw the plans act by act, and on them all named points."""
    plans = [study.sweep.positions(turn)]
    plans.append(velocities(plans[0], study.groups))
    plans.append(accelerations(plans[1], study.groups))
    for point in sorted({point for link in study.mechanism.links.values() for point in link.points}):
        for plan in plans:
            plan.point(point)
    return plans


def words(mark: Mark) -> tuple[object, ...]:
    step = mark.step
    return mark.number, mark.name, step.op, [source.name for source in step.inputs], step.why, mark.role


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=MECHANISMS)
def test_a_followed_plan_has_every_word_and_number_of_a_drawn_one(mechanism: Mechanism) -> None:
    study = study_of(driven(mechanism, -3.0, 2.0), 10, 7)
    motion, drafts = study.motion(), study.drafts()
    for order, plan in enumerate(drawn(study, study.turn)):
        followed = drafts.plan(order)
        assert [words(mark) for mark in followed.board] == [words(mark) for mark in plan.board]
        assert {letter: mark.name for letter, mark in followed.letters.items()} == {
            letter: mark.name for letter, mark in plan.letters.items()
        }
        for one, other in zip(followed.board, plan.board, strict=True):
            if not isinstance(other.value, tuple):
                bound = 2 * np.broadcast_to(errors(other)[other].place, 7) + np.finfo(float).tiny
                assert (np.abs(np.broadcast_to(one.point - other.point, 7)) <= bound).all(), one.name
        for letter in motion.points:
            np.testing.assert_array_equal(
                motion.points[letter][order], np.broadcast_to(followed.point(letter).point, 7)
            )


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=MECHANISMS)
def test_many_positions_are_what_each_of_them_is(mechanism: Mechanism, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = study_of(mechanism, 0, 50).motion()
    monkeypatch.setattr(studies, "BLOCK", 16)
    for one, other in zip(whole.rows(), study_of(mechanism, 0, 50).motion().rows(), strict=True):
        assert other == pytest.approx(one, rel=0, abs=64 * EPS * float(np.abs(one).max()))


def test_a_point_at_rest_takes_no_room_and_cannot_be_moved() -> None:
    motion = study_of(MECHANISMS["four-bar"], 0, 12).motion()
    fixed = motion.points["C"].r
    assert list(fixed) == [0.35 + 0j] * 12
    with pytest.raises(ValueError, match="read-only"):
        fixed[0] = 1j
    assert motion.own().points["C"].r.flags.writeable


# Angles of positions close to each other


def turned(size: float, phi: Sequence[float] | np.ndarray) -> np.ndarray:
    return size * np.exp(1j * np.asarray(phi))


def error(phi: np.ndarray) -> float:
    """Give the largest error of the headings of vectors at some angles, against a double arctangent of each."""
    vectors = turned(0.3, phi)
    return float(np.abs(heading(vectors) - np.arctan2(vectors.imag, vectors.real)).max())


def test_headings_of_close_positions_are_those_of_each_one() -> None:
    count = 1000 * RUN
    assert error(np.linspace(-1.0, 2.0, count)) <= 2 * EPS
    assert error(CLOSE / RUN * np.arange(count)) <= 2 * EPS
    once_round = np.linspace(-3.0, 3.0 + np.pi, count)
    found = heading(turned(0.3, once_round))
    assert (found > -np.pi).all()
    assert (found <= np.pi).all()
    assert np.abs(np.exp(1j * found) - np.exp(1j * once_round)).max() <= 8 * EPS


def test_the_crank_is_told_by_its_own_angles() -> None:
    turn = listed([Fraction(k) for k in (0, 90, 180, 270, 450)])
    assert list(np.degrees(turn.headings)) == [0, 90, 180, -90, 90]
    assert list(turn.part([3, 1]).headings) == list(turn.headings[[3, 1]])
    assert list(np.degrees(even(Fraction(0), 4, -1).headings)) == [0, -90, 180, 90]


def test_headings_of_positions_in_any_order_are_measured_one_by_one() -> None:
    count = 400 * RUN
    anyhow = np.random.default_rng(5).uniform(-3, 3, count)
    assert error(anyhow) == 0
    anyhow[:RUN] = 1.0
    assert error(anyhow) == 0
    opposite = np.where(np.arange(count) % 2, 1.0, 1.0 - np.pi)
    assert error(opposite) == 0
