"""What is read off a record, and within what a hand's drawings of it are: sizes, rates, moments (читаемые величины)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from typing import TypeAlias

import numpy as np

from geometry.board import Mark, between
from geometry.hand_error import SlippingHand, Slopes, number_error, size_error, slopes
from geometry.steps import Reading, Span
from plans.model.motion import Floats
from plans.quantity import Quantity, Shown

SLIP = 0.2  # mm to either side: a fair hand's
MOST_SIDES = 40  # of a polygon that is laid off side by side; of more a sheet draws the sum alone

Slipping: TypeAlias = Callable[..., dict[Mark, Slopes]]  # of a hand and marks


def by_hand(
    findings: Iterable[Quantity], scales: Mapping[str, float], position: int = 0, by: Slipping = slopes
) -> dict[tuple[str, int], float]:
    """Give within what 95 of 100 drawings are of what is read off boards in a position, by the names of the findings.

    `scales` are those of the boards, true units a mm: what is read off another board is not drawn, and has no error.
    """
    read = {found.name: found.shown for found in findings if found.shown is not None and _board(found.shown) in scales}
    found = errors_by_hand(read, SlippingHand(SLIP, {board: np.array([mu]) for board, mu in scales.items()}), by)
    return {(name, position): float(error[position if len(error) > 1 else 0]) for name, error in found.items()}


def _board(shown: Shown) -> str:
    """Give the board that something is read off, before it is turned or divided by a number."""
    mark = shown if isinstance(shown, Mark) else shown[-1]
    while mark.step.op == "turn":
        mark = mark.step.inputs[0]
    return mark.subject


def errors_by_hand(read: Mapping[str, Shown], hand: SlippingHand, by: Slipping = slopes) -> dict[str, Floats]:
    """Give within what 95 of 100 drawings of a hand are of what is read off a record, by its letters.

    `by` finds how far each slip moves each mark: by the rules of the acts, or by trying them.
    """
    scales = tuple((board, tuple(np.asarray(row).tolist())) for board, row in hand.scales.items())
    return dict(zip(read, _errors(tuple(read.values()), hand.slip, scales, by), strict=True))


@lru_cache(maxsize=16)  # a sheet is told them, and held to them
def _errors(
    read: tuple[Shown, ...], slip: float, scales: tuple[tuple[str, tuple[float, ...]], ...], by: Slipping
) -> list[Floats]:
    hand = SlippingHand(slip, {board: np.array(row) for board, row in scales})
    found = by(hand, *(mark for shown in read for mark in _marks(shown)))
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
        return [_error(shown, found) for shown in read]


def _marks(shown: Shown) -> tuple[Mark, ...]:
    return (shown,) if isinstance(shown, Mark) else tuple(shown)


def _error(shown: Shown, found: Mapping[Mark, Slopes]) -> Floats:
    match shown:
        case Span(start, end):
            return size_error(np.asarray(between(start, end)), found[end] - found[start])
        case Reading(arm, turning):
            over, ratio = np.asarray(arm.point), np.asarray(turning.point) / np.asarray(arm.point)
            return number_error(-1j * (found[turning] - ratio * found[arm]) / over)
        case _:
            force = np.asarray(shown.point)
            return number_error(found[shown]) if shown.is_moment else size_error(force, found[shown])
