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


class InvoluteNotes(NamedTuple):
    """The notes on a pair as it is drawn."""

    study: InvoluteStudy
    drafting: Drafting

    @property
    def all(self) -> tuple[str, ...]:
        """What is given, how the wheels mesh, what is measured."""
        return *self.given(), *self.mesh(), *self.measured()

    def given(self) -> Iterator[str]:
        """Say what is given."""
        yield self._said("involute rack", "α", "h*", "c*", "ρ*", "p")
        pair = self.study.pair
        yield from (self.drafting.word(f"involute aim {aim}") for aim in pair.aims)
        if pair.aims == (NO_UNDERCUT, "centre") and not pair.internal:
            yield self._said("involute shared", "x_Σ")

    def mesh(self) -> Iterator[str]:
        """Say how far the axes are apart, and how many pairs of teeth are in mesh."""
        yield self._said("involute turns", "u_12")
        yield self._said("involute apart", "a", "a_w", "y", "Δy")
        if self.study.pair.internal:
            yield self._said("involute relief", "k")
        yield self._said("involute ratio", "g_α", "p_b", "ε_α", "α_w")
        yield self._said("involute tips", "s_a1/m", "s_a2/m")
        least, word = self.drafting.number(THIN), self.drafting.word
        thin = (one.tip_thickness < (THIN - ROUNDED) * self.study.pair.rack.module for one in self.study.sizes.wheels)
        yield from (word("involute thin", number=n, least=least) for n, narrow in enumerate(thin, 1) if narrow)

    def measured(self) -> Iterator[str]:
        """Say over how many teeth and pins is measured, and what the numbers at the base circles are."""
        yield self.drafting.word("involute span ring" if self.study.pair.internal else "involute span")
        yield self.drafting.word("involute lines")

    def _said(self, key: str, *names: str) -> Phrase:
        known = noted(self.study.pair, self.study.sizes)
        return self.drafting.phrase(key, **{name: Slot(name, known[name], DIGITS) for name in names})
