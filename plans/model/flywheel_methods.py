"""The same flywheel by other classical methods, to be told beside Wittenbauer's loop (методы Мерцалова и Гутьяра)."""

from __future__ import annotations

from typing import NamedTuple

from plans.model.dynamics import Touch


class Methods(NamedTuple):
    """The inertia J0 kg*m2 at position 0 by each method, and the range of energy J that Mertsalov's evens out.

    `book` is by tangents at slopes 1 -+ delta; `touches` are the least and the greatest of Mertsalov's curve.
    """

    book: float
    mertsalov: float
    gutyar: float
    height: float
    touches: tuple[Touch, Touch]
