"""What is read off a record, and within what a hand's drawings of it are: sizes, rates, moments (читаемые величины)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeAlias

import numpy as np

from geometry.board import Mark, between
from geometry.hand_error import SlippingHand, Slopes, number_error, size_error, slopes
from geometry.steps import Reading, Span
from plans.model.motion import Floats

SLIP = 0.2  # mm to either side: a fair hand's
MOST_SIDES = 40  # of a polygon that is laid off side by side; of more a sheet draws the sum alone

Told: TypeAlias = Span | Reading | Mark  # a vector between two marks, a rate, a force or a moment

Slipping: TypeAlias = Callable[..., dict[Mark, Slopes]]  # of a hand and marks


def errors_by_hand(read: Mapping[str, Told], hand: SlippingHand, by: Slipping = slopes) -> dict[str, Floats]:
    """Give within what 95 of 100 drawings of a hand are of what is read off a record, by its letters.

    `by` finds how far each slip moves each mark: by the rules of the acts, or by trying them.
    """
    found = by(hand, *(mark for told in read.values() for mark in _marks(told)))
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
        return {name: _error(told, found) for name, told in read.items()}


def _marks(told: Told) -> tuple[Mark, ...]:
    return (told,) if isinstance(told, Mark) else tuple(told)


def _error(told: Told, found: Mapping[Mark, Slopes]) -> Floats:
    match told:
        case Span(start, end):
            return size_error(np.asarray(between(start, end)), found[end] - found[start])
        case Reading(arm, turning):
            over, ratio = np.asarray(arm.point), np.asarray(turning.point) / np.asarray(arm.point)
            return number_error(-1j * (found[turning] - ratio * found[arm]) / over)
        case _:
            force = np.asarray(told.point)
            return number_error(found[told]) if told.is_moment else size_error(force, found[told])
