"""A pattern: the plans of a mechanism drawn at one position, to be followed at any others (образец)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from geometry.tracing import Tracing
from plans.angles import heading
from plans.motion import ORDERS, Complexes, Floats, LinkMotion, Motion, PointMotion
from plans.plan import Plan, Reading
from plans.turn import Turn


class Pattern:
    """Plans of the orders 0, 1, ... over each other, with the images of all named points on them."""

    def __init__(self, plans: Sequence[Plan]) -> None:
        self.plans = plans
        links = plans[0].mechanism.links
        letters = sorted({point for link in links.values() for point in link.points})
        images = {letter: [plan.point(letter) for plan in plans] for letter in letters}
        tracing = Tracing((mark for plan in plans for mark in plan.board), plans[0].board["φ"])
        self.tracing = tracing
        self._points = {letter: [tracing.place(mark) for mark in marks] for letter, marks in images.items()}
        self._still = {place: _at_rest(tracing.fixed(place)) for places in self._points.values() for place in places}
        arms = sorted(plans[0].images.items())
        self._arms = {link: (tracing.place(image.arm), image.span) for link, image in arms if image.arm}
        readings = [plan.readings for plan in plans[1:]]
        self._rates = {link: [self._rate(known.get(link)) for known in readings] for link in self._arms}

    def _rate(self, reading: Reading | None) -> tuple[int, str] | None:
        """Tell where a link's angular velocity or acceleration is read; None: it does not turn."""
        if reading is None:
            return None
        return self.tracing.rate(self.tracing.place(reading.turning), self.tracing.place(reading.arm))

    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def follow(self, turn: Turn) -> list[Any]:
        """Work out all numbers of the plans at other crank positions."""
        return self.tracing.follow(turn.directions)

    def drawn(self, numbers: list[Any]) -> list[Plan]:
        """Make the plans that have these numbers."""
        boards, made = self.tracing.boards(numbers)
        found: list[Plan] = []
        for plan in self.plans:
            found.append(plan.redrawn(boards[plan.board.subject], made, tuple(found)))
        return found

    def read(self, numbers: list[Any], phi: Floats) -> Motion:
        """Read all named points and moving links off the plans."""
        count, still = phi.shape, self._still
        points = {
            letter: PointMotion._make(
                [
                    numbers[at] if still[at] is None else np.ndarray(count, complex, still[at], strides=(0,))
                    for at in places
                ]
                + [None] * (len(ORDERS) - len(places))
            )
            for letter, places in self._points.items()
        }
        links = {
            link: LinkMotion(
                heading(numbers[arm], span), *(_column(numbers, place, count) for place in self._rates[link])
            )
            for link, (arm, span) in self._arms.items()
        }
        return Motion("construction", phi, points, links, ())


def _at_rest(value: complex | None) -> Complexes | None:
    """Give the one value of a point at rest, to be seen at any number of positions; None: the point moves."""
    if value is None:
        return None
    seen = np.array([value], dtype=np.complex128)
    seen.flags.writeable = False
    return seen


def _column(numbers: list[Any], place: tuple[int, str] | None, count: tuple[int, ...]) -> Floats:
    number = getattr(numbers[place[0]], place[1]) if place else 0.0
    return np.asarray(number) if np.shape(number) else np.full(count, float(number))
