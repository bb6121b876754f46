"""The plans of one sheet and position, drawn by a hand that slips: as they are graded, and each vector by itself."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.grading.allowance import Allowances
from drawings.grading.asked import PlanAsked, VectorAsked
from drawings.grading.drawn_plan import Arrow, DrawnPlan, drawn_places, lacking_places, places_of, scales_beside
from drawings.grading.judgement import Judge
from drawings.grading.verdict import Verdict
from drawings.paper.limits import QUANTUM
from geometry.board import Mark
from geometry.hand_error import SlippingHand, slopes
from tests.draughtsman import Draughtsman, copies
from tests.hands.shares import Slips, slips_of

Key: TypeAlias = tuple[str, tuple[str, str]]  # a plan and the letters of a vector
Ends: TypeAlias = npt.NDArray[np.complex128]  # where an arrow starts and ends, true units, (2, drawings)


class PlansByHand(NamedTuple):
    """The plans that stand beside one another on a sheet, drawn as they should be."""

    true: tuple[DrawnPlan, ...]

    @property
    def asked(self) -> dict[Key, VectorAsked]:
        """The vectors that are asked for."""
        return {(plan.asked.plan, one.letters): one for plan in self.true for one in plan.asked.vectors}

    def scales(self, plan: DrawnPlan) -> Mapping[str, float]:
        """Give the scales of the plans that one rests on, true units a mm."""
        return {**plan.asked.scales, **scales_beside(plan, self.true)}

    def allowed(self) -> dict[Key, float]:
        """Give what each vector may be out, true units; NaN of what is not graded."""
        return {(plan.asked.plan, letters): may for plan in self.true for letters, may in self._may(plan).items()}

    def _may(self, plan: DrawnPlan) -> dict[tuple[str, str], float]:
        return Allowances().of(plan.asked, scales_beside(plan, self.true), QUANTUM)

    def slips(self, slip: float) -> dict[Key, Slips]:
        """Give what slips of so many mm move each vector by; none of one that they bend too much."""
        found = dict[Key, Slips]()
        for plan in self.true:
            hand = SlippingHand(slip, {name: np.array([mu]) for name, mu in self.scales(plan).items()})
            moved = slopes(hand, *(mark for one in plan.asked.vectors if one.found for mark in one.found.span))
            for one in plan.asked.vectors:
                own = [] if one.found is None else np.ravel(moved[one.found.span.end] - moved[one.found.span.start])
                if np.all(np.isfinite(own)):
                    found[plan.asked.plan, one.letters] = slips_of(own, slip * plan.scale)
        return found

    def arrows(self, slip: float, drawings: int, chance: np.random.Generator) -> dict[Key, Ends]:
        """Draw all arrows: each a little out at both of its ends, beside what it is drawn from."""
        merged = {name: np.array([mu]) for plan in self.true for name, mu in self.scales(plan).items()}
        marks = [mark for one in self.asked.values() for mark in _marks(one)]
        copied = copies(Draughtsman(slip, merged, drawings, chance), *marks)
        spots = {mark: np.broadcast_to(copied[mark], (drawings, 1))[:, 0] for mark in marks}
        found = dict[Key, Ends]()
        for plan in self.true:
            for one in plan.asked.vectors:
                x, y = chance.uniform(-slip, slip, (2, 2, drawings)) * plan.scale
                found[plan.asked.plan, one.letters] = _laid(one, spots, drawings) + x + 1j * y
        return found

    def drawn(self, arrows: Mapping[Key, Ends], number: int) -> tuple[DrawnPlan, ...]:
        """Give one of the drawings."""
        found = []
        for plan in self.true:
            own = {letters: arrows[plan.asked.plan, letters][:, number] / plan.scale for letters in plan.arrows}
            found.append(_plan(plan.asked, {letters: Arrow(*map(complex, ends)) for letters, ends in own.items()}))
        return tuple(found)

    def verdicts(self, drawn: Sequence[DrawnPlan]) -> Iterator[Verdict]:
        """Grade a drawing."""
        for plan in drawn:
            yield from Judge(plan, self._may(plan), drawn_places(drawn), lacking_places(drawn)).verdicts()


def beside_one_another(plans: Sequence[PlanAsked]) -> list[PlansByHand]:
    """Give the plans that a scene asks for by their sheets and positions."""
    places = dict.fromkeys((plan.sheet, plan.position) for plan in plans)
    return [PlansByHand(tuple(_true(one) for one in plans if (one.sheet, one.position) == place)) for place in places]


def _true(asked: PlanAsked) -> DrawnPlan:
    scale = asked.scales[asked.plan]
    return _plan(asked, {one.letters: Arrow(0j, one.true / scale) for one in asked.vectors})


def _plan(asked: PlanAsked, arrows: Mapping[tuple[str, str], Arrow]) -> DrawnPlan:
    hung = {one.letters: arrows[one.letters] for one in asked.vectors if not one.letter}
    return DrawnPlan(asked, arrows, asked.scales[asked.plan], places_of(hung))


def _marks(one: VectorAsked) -> tuple[Mark, ...]:
    """Give the marks that an arrow is drawn by, those that it lies between last: a free one begins in its polygon."""
    return () if one.found is None else (*one.found.span, *(one.found.side or one.found.span))


def _laid(one: VectorAsked, spots: Mapping[Mark, Ends], drawings: int) -> Ends:
    """Give where an arrow starts and ends that goes by its marks; one without any is known."""
    if one.found is None:
        return np.broadcast_to(np.array([[0j], [one.true]]), (2, drawings))
    start, end, begins, _ = (spots[mark] for mark in _marks(one))
    return np.array([begins, begins + end - start])
