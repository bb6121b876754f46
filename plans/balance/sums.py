"""Static moments on boards: arms, masses and the moments that they give, in the frames of links (статические моменты).

A mass may be complex: a link's static moment is shared between two of its points whatever way its centre lies off them.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.balance.linkage import EPS, ROUNDING
from plans.words.words import Message, because

ARMS, MASSES, MOMENTS = "arms", "point_masses", "static_moments"  # the boards: m, kg, kg*m
UNITS = {ARMS: "m", MASSES: "kg", MOMENTS: "kg*m"}


class SumTerm(NamedTuple):
    """A mass or a static moment, and the sum of the sizes of what it is made of: rounding is a share of that."""

    mark: Mark
    size: float

    @property
    def value(self) -> complex:
        """The mass kg or static moment kg*m."""
        return complex(self.mark.point)

    @property
    def vanishes(self) -> bool:
        """Whether it is nothing but rounding."""
        return abs(self.value) <= ROUNDING * EPS * self.size


class Sums:
    """The boards on which masses and static moments of a mechanism's links are laid off and summed."""

    def __init__(self) -> None:
        self.arms, self.masses, self.moments = Board(ARMS), Board(MASSES), Board(MOMENTS)
        self.kilogram = self.masses.given("1", 1 + 0j, because("mass_unit"))
        self.no_mass = SumTerm(self.masses.given("0", 0j, because("masses_start")), 0.0)
        self.no_moment = SumTerm(self.moments.given("0", 0j, because("static_start")), 0.0)

    def arm(self, name: str, start: complex, end: complex, link: int) -> Mark:
        """Lay down the vector between two points of a link in its own frame, once."""
        if name in self.arms and complex(self.arms[name].point) == end - start:
            return self.arms[name]
        return self.arms.given(name, end - start, because("link", link=link))

    def mass(self, name: str, mass: float, why: Message) -> SumTerm:
        """Lay down a known mass."""
        return SumTerm(self.masses.given(name, complex(mass), why), abs(mass))

    def moment(self, name: str, mass: SumTerm, arm: Mark, why: Message) -> SumTerm:
        """Take the static moment of a mass at the end of an arm: to the arm as the mass is to a kilogram."""
        mark = self.moments.similar(name, mass.mark, self.kilogram, arm, why=why)
        return SumTerm(mark, mass.size * abs(complex(arm.point)))

    def share(self, name: str, moment: SumTerm, arm: Mark, why: Message) -> SumTerm:
        """Find the mass that has a static moment at the end of an arm: замещающая масса."""
        mark = self.masses.similar(name, moment.mark, arm, self.kilogram, why=why)
        return SumTerm(mark, moment.size / abs(complex(arm.point)))

    def turned(self, name: str, moment: SumTerm, by: complex, why: Message) -> SumTerm:
        """Turn a static moment by a fixed angle between two links, or take a share of it."""
        return SumTerm(self.moments.turn(name, moment.mark, by, why), moment.size * abs(by))

    def total(self, name: str, terms: Iterable[SumTerm], none: SumTerm, why: Message) -> SumTerm:
        """Lay masses or static moments off end to end; the end of the last is their sum."""
        nonzero = [term for term in terms if term.value]
        if len(nonzero) < 2:
            return nonzero[0] if nonzero else none
        board = self.masses if none is self.no_mass else self.moments
        end = nonzero[0].mark
        for number, term in enumerate(nonzero[1:], 2):
            letters = name if number == len(nonzero) else f"{name}:{number}"
            end = board.lay_off(letters, end, term.mark, why)
        return SumTerm(end, sum(term.size for term in nonzero))

    def less(self, name: str, whole: SumTerm, part: SumTerm, why: Message) -> SumTerm:
        """Take a mass from another: what is left of it."""
        if not part.value:
            return whole
        away = self.masses.turn(f"-{part.mark.name}", part.mark, -1.0, because("opposite_of", force=part.mark.name))
        return SumTerm(self.masses.lay_off(name, whole.mark, away, why), whole.size + part.size)
