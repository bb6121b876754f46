"""The truth of the bench against closed forms, and the error that is counted from it."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest

from geometry.meet import EPS
from plans.bench.error import Errors, errors, sizes
from plans.bench.truth import Exact, NotInstalled, replay, values
from plans.linkage.study import LinkageStudy
from tests.plans import linkages
from tests.plans.studies import study_of

MP = mpmath.mp.clone()
MP.dps = 40
A, OMEGA, EPSILON = 0.1, 7.0, -3.0


def whole(exact: Exact, column: int) -> Any:
    """Put a true value together again from what float64 holds and the rest."""
    return MP.mpc(complex(exact.near[column])) + MP.mpc(complex(exact.rest[column]))


def crank(study: LinkageStudy) -> tuple[Any, ...]:
    """Give place, velocity and acceleration of the crank's end at position 1 of 12, from position 0 at 0 degrees."""
    end = MP.mpf(A) * MP.expjpi(MP.mpf(study.sense) / 6)
    return end, 1j * OMEGA * end, (1j * EPSILON - MP.mpf(OMEGA) ** 2) * end


def test_the_truth_is_the_closed_form_of_the_crank_to_thirty_digits() -> None:
    study = study_of(linkages.slider_crank(A, 0.4, omega=OMEGA, epsilon=EPSILON))
    truth = replay(study, [1]).truth()
    for kind, true in zip("rva", crank(study), strict=True):
        assert abs(whole(truth.values[kind, "A"], 0) - true) < 1e-30 * abs(true)


def test_the_truth_of_a_slider_is_its_closed_form() -> None:
    """x = a cos + sqrt(b2 - a2 sin2) for a central slider-crank, at 30 degrees."""
    truth = replay(study_of(linkages.slider_crank(A, 0.4)), [1]).truth()
    a, b, angle = MP.mpf(A), MP.mpf(0.4), MP.pi / 6
    assert (
        abs(whole(truth.values["r", "B"], 0) - (a * MP.cos(angle) + MP.sqrt(b**2 - (a * MP.sin(angle)) ** 2))) < 1e-30
    )


def bar(count: int = 12) -> LinkageStudy:
    return study_of(linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}), 0, count)


def judged(spoil: Any) -> Errors:
    """Judge the construction after something was done to its motion."""
    study = bar()
    truth, largest = replay(study, range(12)).truth(), sizes(bar(360))
    motion = study.motion(2)
    spoil(motion)
    return errors(values(motion, truth), truth, largest)


def test_a_planted_error_is_counted_in_shares_of_the_plans_largest_and_named() -> None:
    largest = sizes(bar(360))

    def spoil(motion: Any) -> None:
        motion.points["B"].v[5] += 1e-6j * largest["v"]

    found = judged(spoil)
    assert found.largest == pytest.approx(1e-6)
    assert found.worst == "v_B"
    assert found.kinds["v"] == found.largest
    assert found.kinds["a"] < 8 * EPS


def test_without_mpmath_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "mpmath", None)
    with pytest.raises(NotInstalled, match=r"Fix: python -m pip install '\.\[bench\]'"):
        replay(bar(), [0]).truth()
