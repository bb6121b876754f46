"""How far a curve is out that a hand draws chord by chord: its slips add up from strip to strip (хорды от руки)."""

from __future__ import annotations

import numpy as np

from drawings.grading.curves.asked_figure import PRICKED, Sizes
from geometry.board import Board
from geometry.calculus import integral
from geometry.hand_error import SlippingHand, slopes

CHORDS = "chords"


def chords_by_hand(wide: Sizes, high: Sizes, pole: float) -> Sizes:
    """Give how far each ordinate of an integral curve is out, mm (standard deviation), if the hand slips by a mm.

    The strips are so wide and their mean ordinates so high, mm, and the pole is so far away, mm.

    >>> chords_by_hand(np.array([10.0, 10.0]), np.array([5.0, 5.0]), 20.0).round(2).tolist()
    [0.82, 1.25, 1.63]
    """
    edges = np.concatenate(([0.0], np.cumsum(wide)))
    found = integral(Board(CHORDS), "y", edges, high, pole)
    moved = slopes(SlippingHand(1.0, {CHORDS: np.ones(1)}), *found.points)
    return np.array([np.hypot(PRICKED, np.sqrt((moved[one].imag ** 2).sum())) for one in found.points])
