"""A pair in words: what is given, the angle of action, the contact ratio by its segment, measuring (пояснения)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.lettering.words import Phrase, Slot
from drawings.page.page import Drafting
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

    def numbers(self) -> dict[str, float]:
        """Give the numbers of all notes by the names of their quantities: mm, degrees, modules."""
        pair, rack, sizes = self.pair, self.pair.rack, self.sizes
        moved = (sizes.distance - pair.standard) / rack.module
        found = {"α": math.degrees(rack.angle), "h*": rack.head, "c*": rack.clearance}
        found |= {"ρ*": rack.rounding, "a": 1e3 * pair.standard, "a_w": 1e3 * sizes.distance, "y": moved}
        found |= {"Δy": pair.total - moved, "α_w": math.degrees(sizes.angle), "ε_α": sizes.ratio, "k": pair.tip_relief}
        found |= {"g_α": 1e3 * sizes.active, "p_b": 1e3 * rack.base_pitch, "p": 1e3 * rack.pitch}
        for n, one in enumerate(sizes.wheels, 1):
            found[f"s_a{n}/m"] = one.tip_thickness / rack.module
        return found

    def given(self) -> Iterator[str]:
        """Say what is given."""
        yield self._said("involute rack", "α", "h*", "c*", "ρ*", "p")

    def mesh(self) -> Iterator[str]:
        """Say how far the axes are apart, and how many pairs of teeth are in mesh."""
        yield self._said("involute apart", "a", "a_w", "y", "Δy")
        if self.pair.internal:
            yield self._said("involute relief", "k")
        yield self._said("involute ratio", "g_α", "p_b", "ε_α", "α_w")
        yield self._said("involute tips", "s_a1/m", "s_a2/m")

    def measured(self) -> Iterator[str]:
        """Say over how many teeth and pins is measured, and what the numbers at the base circles are."""
        yield self.drafting.word("involute span ring" if self.pair.internal else "involute span")
        yield self.drafting.word("involute lines")

    def _said(self, key: str, *names: str) -> Phrase:
        known = self.numbers()
        return self.drafting.phrase(key, **{_part(name): Slot(name, known[name], 5) for name in names})


def _part(name: str) -> str:
    """Name the part of a sentence that holds a quantity: letters alone.

    >>> _part("s_a1/m"), _part("Δy"), _part("h*")
    ('sa1m', 'Dy', 'h')
    """
    plain = name.replace("α", "alpha").replace("ε", "eps").replace("ρ", "rho").replace("Δ", "D")
    return "".join(sign for sign in plain if sign.isalnum())
