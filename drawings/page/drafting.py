"""How the figures of a sheet are drawn and lettered: hand, language, standard, notation (оформление)."""

from __future__ import annotations

from typing import NamedTuple

from drawings.lettering.phrase import Phrase, Slot, numbered, phrase
from drawings.lettering.words import letter, number, word
from drawings.page.page import page_of
from drawings.page.scale import Scale
from drawings.paper.hand import Hand
from plans.scene.scene import Scene


class Drafting(NamedTuple):
    """The hand that draws, and how it letters: language, standard, notation of scales, letter of reactions."""

    hand: Hand
    language: str = "en"
    standard: str = "GOST"
    notation: str = "mu"
    reactions: str = "R"

    def word(self, key: str, **values: object) -> str:
        """Give a phrase in the sheet's language."""
        return word(self.language, key, **values)

    def phrase(self, key: str, **parts: object) -> Phrase:
        """Say a sentence in the sheet's language whose numbers are slots of quantities."""
        return phrase(self.language, key, **parts)

    def slot(self, slot: Slot) -> Phrase:
        """Write the number of a quantity."""
        return numbered(self.language, slot)

    def number(self, value: float, digits: int = 4) -> str:
        """Write a number with some significant digits."""
        return number(value, self.language, digits)

    def letter(self, markup: str) -> str:
        """Write a letter as courses of the sheet's language do; a phrase stays one."""
        own = letter(self.language, markup)
        return Phrase(own, letter(self.language, markup.template)) if isinstance(markup, Phrase) else own

    def scale(self, scale: Scale) -> str:
        """Write a scale as the sheet does."""
        return scale.written(self.language, self.notation)

    def true(self, segment: str, letter: str) -> str:
        """Write in letters how a true size is read off a segment at the scale of a letter."""
        return f"{segment}/K_{letter}" if self.notation == "K" else f"{segment}·μ_{letter}"


def drafting_of(scene: Scene) -> Drafting:
    """Give what a scene asks for."""
    sheet = scene.sheet
    return Drafting(page_of(scene).hand, sheet.language, sheet.standard, sheet.notation)
