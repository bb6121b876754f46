"""The lever's equation of moments in letters and in numbers, its arms in millimetres as drawn (уравнение рычага)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.forces.force_equations import DIGITS
from drawings.figures.forces.force_letters import letter_of
from drawings.figures.forces.lever_layout import UNIT
from drawings.figures.forces.lever_terms import POLE, LeverTerm, statements
from drawings.layout.block import TextBlock
from drawings.layout.equation import Passage, WrittenEquation, moments, plain
from drawings.layout.picture import Spot
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.strokes import Group
from plans.forces.primary import BALANCING, DRIVING

NAME = "equations-lever"
ARM = 4  # digits of an arm
NARROWEST = 20.0  # sizes of the letters: in a narrower column every term has a line of its own
WIDEST = "0,08888"  # of an arm before it is known how large the lever is drawn


class LeverEquation(NamedTuple):
    """What is written beside a lever: its terms, and the balancing moment N*m, where a moment drives."""

    told: tuple[LeverTerm, ...]
    moment: float | None
    drafting: Drafting

    def block(self) -> TextBlock:
        """Measure it with the widest numbers, for the scale of the lever is not known yet."""
        name, sizes = self._passage(None).block()
        broad = [one for one in sizes if one[0] >= NARROWEST * self.drafting.hand.text]
        return TextBlock(name, tuple(broad) or sizes[-1:])

    def write(self, box: Field, spot: Spot | None = None) -> Group:
        """Write it with the arms in mm at the lever's scale; without a lever on its sheet, in true units."""
        return self._passage(1.0 if spot is None else spot.scale.mu, "mm" if spot is not None else UNIT).write(
            box, self.drafting.hand
        )

    def _passage(self, mu: float | None, unit: str = "mm") -> Passage:
        arms = {letter: self._arm(length, mu) for letter, length in statements(self.told)}
        lines = (self._arms(arms, unit), moments(POLE, [one.written for one in self.told]), self._numbers(arms))
        return Passage(NAME, (*lines, *self._found()), self.drafting.hand.text)

    def _arm(self, length: float, mu: float | None) -> str:
        return WIDEST if mu is None else self.drafting.number(length / mu, ARM)

    def _arms(self, arms: dict[str, str], unit: str) -> WrittenEquation:
        """Tell all arms once."""
        parts = [f"{letter} = {arm}" for letter, arm in arms.items()]
        return plain(*(f"{one}," for one in parts[:-1]), f"{parts[-1]} {self.drafting.word(unit)}")

    def _numbers(self, arms: dict[str, str]) -> WrittenEquation:
        """Write the equation with its numbers: newtons by arms."""
        products = [(one.written[0], f"{self.drafting.number(one.size, DIGITS)}·{arms[one.arm]}") for one in self.told]
        return moments(POLE, products)

    def _found(self) -> Iterator[WrittenEquation]:
        """Tell the force that balances the lever, and its moment about the shaft, where a moment drives."""
        drafting, driving = self.drafting, [one for one in self.told if one.force == DRIVING]
        parts = [f"{one.letter} = {drafting.number(one.size, DIGITS)} {drafting.word('N')}" for one in driving]
        if self.moment is not None:
            size = drafting.number(self.moment, DIGITS)
            parts.append(f"{letter_of(BALANCING, drafting)} = {size} {drafting.word('N*m')}")
        yield plain(*(f"{one}," for one in parts[:-1]), *parts[-1:])
