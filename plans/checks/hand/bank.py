"""What the polygons of a bank drawn by hand may be out in, order by order (многоугольники блока от руки)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from geometry.board import Board
from geometry.hand_error import SlippingHand, slopes
from plans.bank.letters import FORCE, MOMENT, STATIC, letters
from plans.bank.polygons import Total
from plans.bank.study import BankStudy
from plans.checks.hand.quantity import MOST_SIDES, SLIP, Slipping, Told, errors_by_hand
from plans.rotor.polygon import polygon

FIGURES = {FORCE: "order_forces", MOMENT: "order_moments"}  # on which each polygon stands, before its order
BACK = "back"  # after the order of what turns against the crank


def bank_by_hand(bank: BankStudy, scales: Mapping[str, float], by: Slipping = slopes) -> dict[tuple[str, int], float]:
    """Give what a hand may be out in the polygons that a sheet shows, by the names of the findings.

    `scales` are those of the figures, N or N*m a mm: "order_forces-2-back". The vector of one mechanism is known, and
    so is how it is turned; the members' vectors are laid off end to end. A mass of a compensator is read off what
    closes its polygon, over the square of its angular speed; what turns against the crank and has no figure, off the
    one whose mirror image its polygon is.
    """
    told, rows = dict[str, Told](), dict[str, np.ndarray]()
    for name, figures, total, times in _polygons(bank):
        figure = next((one for one in figures if one in scales), None)
        if figure is not None and len(total.polygon.sides) <= MOST_SIDES:
            board = Board(name)
            laid = [board.given(f"{name}:{k}", side.vector.value) for k, side in enumerate(total.polygon.sides)]
            closed = polygon(board, board.given("0", 0j), f"-{name}", laid)
            told[name] = board.turn(name, closed.closing, times)
            rows[name] = np.array([scales[figure]])
    found = errors_by_hand(told, SlippingHand(SLIP, rows), by)
    return {(name, 0): float(error[0]) for name, error in found.items()}


def _polygons(bank: BankStudy) -> Iterator[tuple[str, tuple[str, ...], Total, float]]:
    """Give what is read off each polygon: letters, figures, the polygon, and how many times what closes it that is."""
    drawing, speed = bank.drawing, bank.task.speed
    for kind, totals in ((FORCE, drawing.forces), (MOMENT, drawing.moments)):
        for signed, total in totals.items():
            yield letters(kind, signed), _figures(kind, signed), total, -1.0
    for one in bank.task.asked:
        for signed in (one.order, -one.order):
            times = 1 / (signed * speed) ** 2
            yield letters(STATIC, signed), _figures(FORCE, signed), drawing.forces[signed], times


def _figures(kind: str, signed: int) -> tuple[str, ...]:
    """Name the figure of a polygon, and that of its mirror image.

    >>> _figures(MOMENT, -2), _figures(FORCE, 2)
    (('order_moments-2-back', 'order_moments-2'), ('order_forces-2',))
    """
    name = f"{FIGURES[kind]}-{abs(signed)}"
    return (name,) if signed > 0 else (f"{name}-{BACK}", name)
