"""The lever's equation of moments in letters and in numbers, its arms in millimetres as drawn (уравнение рычага)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.forces.force_equations import DIGITS
from drawings.figures.forces.force_letters import letter_of
from drawings.figures.forces.lever_layout import UNIT
from drawings.figures.forces.lever_terms import POLE, LeverTerm, statements
from drawings.layout.block import TextBlock
from drawings.layout.equation import Passage, WrittenEquation, listed, moments
from drawings.layout.picture import Spot
from drawings.lettering.phrase import Phrase, Slot, joined
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.statement import Kind, Statement
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
    column: int = 0

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
        arms = {letter: self._arm(letter, length, mu) for letter, length in statements(self.told)}
        figure = f"{NAME}-{self.column}"
        said = [Statement(Kind.LETTER, figure, one.letter) for one in self.told]
        letters = moments(POLE, [one.written for one in self.told], states=said)
        lines = (self._arms(arms, unit), letters, self._numbers(arms), *self._found())
        return Passage(NAME, lines, self.drafting.hand.text, figure=figure)

    def _arm(self, letter: str, length: float, mu: float | None) -> str:
        return WIDEST if mu is None else self.drafting.slot(Slot(letter, length / mu, ARM))

    def _arms(self, arms: dict[str, str], unit: str) -> WrittenEquation:
        """Tell all arms once."""
        *parts, last = (joined(" = ", pair) for pair in arms.items())
        return listed(*parts, joined(" ", (last, self.drafting.word(unit))))

    def _numbers(self, arms: dict[str, str]) -> WrittenEquation:
        """Write the equation with its numbers: newtons by arms."""
        sizes = [self.drafting.slot(Slot(one.letter, one.size, DIGITS)) for one in self.told]
        products = (joined("·", (size, arms[one.arm])) for one, size in zip(self.told, sizes, strict=True))
        return moments(POLE, [(one.written[0], product) for one, product in zip(self.told, products, strict=True)])

    def _found(self) -> Iterator[WrittenEquation]:
        """Tell the force that balances the lever, and its moment about the shaft, where a moment drives."""
        drafting, driving = self.drafting, [one for one in self.told if one.force == DRIVING]
        parts = [self._statement(one.letter, one.size, "N") for one in driving]
        if self.moment is not None:
            parts.append(self._statement(letter_of(BALANCING, drafting), self.moment, "N*m"))
        yield listed(*parts)

    def _statement(self, letter: str, value: float, unit: str) -> Phrase:
        number = self.drafting.slot(Slot(letter, value, DIGITS))
        return joined("", (f"{letter} = ", number, f" {self.drafting.word(unit)}"))
