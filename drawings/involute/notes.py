"""A pair in words: what is given, the angle of action, the contact ratio by its segment, measuring (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.involute.due import DIGITS, noted
from drawings.lettering.words import Phrase, Slot
from drawings.page.page import Drafting
from plans.involute.limits import ROUNDED, THIN
from plans.involute.shift import NO_UNDERCUT
from plans.involute.study import InvoluteStudy
from plans.model.involute import InvolutePair, PairSizes


class InvoluteNotes(NamedTuple):
    """The notes on a pair, by the sizes that one road found."""

    pair: InvolutePair
    sizes: PairSizes
    drafting: Drafting

    @classmethod
    def of(cls, study: InvoluteStudy, drafting: Drafting) -> InvoluteNotes:
        """Give the notes on a pair as it is drawn."""
        return cls(study.pair, study.sizes, drafting)

    @property
    def all(self) -> tuple[str, ...]:
        """What is given, how the wheels mesh, what is measured."""
        return *self.given(), *self.mesh(), *self.measured()

    def given(self) -> Iterator[str]:
        """Say what is given."""
        yield self._said("involute rack", "α", "h*", "c*", "ρ*", "p")
        yield from (self.drafting.word(f"involute aim {aim}") for aim in self.pair.aims)
        if self.pair.aims == (NO_UNDERCUT, "centre") and not self.pair.internal:
            yield self._said("involute shared", "x_Σ")

    def mesh(self) -> Iterator[str]:
        """Say how far the axes are apart, and how many pairs of teeth are in mesh."""
        yield self._said("involute turns", "u_12")
        yield self._said("involute apart", "a", "a_w", "y", "Δy")
        if self.pair.internal:
            yield self._said("involute relief", "k")
        yield self._said("involute ratio", "g_α", "p_b", "ε_α", "α_w")
        yield self._said("involute tips", "s_a1/m", "s_a2/m")
        least, word = self.drafting.number(THIN), self.drafting.word
        thin = (one.tip_thickness < (THIN - ROUNDED) * self.pair.rack.module for one in self.sizes.wheels)
        yield from (word("involute thin", number=n, least=least) for n, narrow in enumerate(thin, 1) if narrow)

    def measured(self) -> Iterator[str]:
        """Say over how many teeth and pins is measured, and what the numbers at the base circles are."""
        yield self.drafting.word("involute span ring" if self.pair.internal else "involute span")
        yield self.drafting.word("involute lines")

    def _said(self, key: str, *names: str) -> Phrase:
        known = noted(self.pair, self.sizes)
        return self.drafting.phrase(key, **{name: Slot(name, known[name], DIGITS) for name in names})
