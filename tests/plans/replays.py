"""A study's record replayed in 50 digits from the exact crank angles: the true error of every mark."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np

from geometry.board import Mark, at, behind
from geometry.precision import errors
from geometry.replay import DIGITS, exact
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import Floats

MP = mpmath.mp.clone()
MP.dps = DIGITS


class Replay:
    """The marks of all three plans of a study, with their true values at some positions, and their bounds."""

    def __init__(self, study: LinkageStudy) -> None:
        drafts, links = study.drafts(), study.mechanism.links
        self.plans = [drafts.plan(order) for order in range(3)]
        letters = sorted({name for number, link in links.items() if number != FRAME for name in link.points})
        self.points = {(order, name): plan.point(name) for order, plan in enumerate(self.plans) for name in letters}
        self.rates = {
            (order, link): reading for order, plan in enumerate(self.plans) for link, reading in plan.readings.items()
        }
        wanted = [*self.points.values(), *(mark for reading in self.rates.values() for mark in reading)]
        self.marks = [mark for mark in behind(*wanted) if not isinstance(mark.value, tuple)]
        self.bounds = {mark: error.place for mark, error in errors(*self.marks).items()}

    def true(self, position: int, degrees: Fraction) -> dict[Mark, Any]:
        """Carry out the record in 50 digits, at a crank angle that is exact."""
        angle = MP.mpf(degrees.numerator) / degrees.denominator
        return exact(self.marks, position, {self.plans[0].board["φ"]: MP.expjpi(angle / 180)})

    def errors(self, position: int, degrees: Fraction) -> Iterator[tuple[Mark, float, float]]:
        """Give every mark's true error and its bound."""
        for mark, true in self.true(position, degrees).items():
            if mark in self.bounds and not isinstance(mark.value, tuple):
                bound = np.ravel(self.bounds[mark])
                yield mark, error(mark, position, true), float(bound[position if len(bound) > 1 else 0])


def error(mark: Mark, position: int, true: Any) -> float:
    return float(abs(MP.mpc(at(mark.point, position)) - true))


def largest(marks: Sequence[Mark]) -> float:
    """Give the largest size of some marks over the turn."""
    return max(float(np.nanmax(np.abs(np.asarray(mark.point)))) for mark in marks)


def rate_error(arm: Mark, turning: Mark, read: Floats, position: int, true: dict[Mark, Any]) -> float:
    """Give the true error of an angular velocity or acceleration read from two vectors."""
    exactly = (MP.conj(true[arm]) * true[turning]).imag / abs(true[arm]) ** 2
    return float(abs(MP.mpf(at(read, position).real) - exactly))
