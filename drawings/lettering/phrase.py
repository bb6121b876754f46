"""Phrases (фразы): sentences whose numbers are quantities, so that each number can be read back by its quantity's name.

The template of a phrase is its text with ⟨name⟩ where the number of a quantity stands.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from drawings.lettering.words import number, word
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Stroke, Text
from drawings.paper.walk import stating, texts

SLOT = re.compile("⟨(.*?)⟩")
NUMBER = r"([−-]?\d+(?:[.,]\d+)?|—)"


class Slot(NamedTuple):
    """A number of a phrase: the quantity that it is, its value, and how many significant digits are written."""

    quantity: str
    value: float
    digits: int = 4


class Phrase(str):
    """A sentence with its template; without any number of a quantity the template is the sentence."""

    __slots__ = ("template",)
    template: str

    def __new__(cls, text: str, template: str) -> Phrase:
        """Write a sentence."""
        made = super().__new__(cls, text)
        made.template = template
        return made


def phrase(language: str, key: str, **parts: object) -> Phrase:
    """Say a sentence of a sheet in a language; its parts are slots, other phrases, or words as they are.

    >>> said = phrase("en", "permissible in one", grade="G6.3", letters="e", permissible=Slot("U_per", 12.5))
    >>> said.template == str(said).replace("12.5", "⟨U_per⟩")
    True
    """
    text = {name: _text(part, language) for name, part in parts.items()}
    template = {name: _template(part) for name, part in parts.items()}
    return Phrase(word(language, key, **text), word(language, key, **template))


def numbered(language: str, slot: Slot) -> Phrase:
    """Write the number of a quantity alone.

    >>> numbered("ru", Slot("h_1", 2.5)).template
    '⟨h_1⟩'
    """
    return Phrase(str(_text(slot, language)), str(_template(slot)))


def slotted(before: str, quantity: str, number: str, after: str = "") -> Phrase:
    """Write the number of a quantity that is rounded in its own way.

    >>> slotted("K = ", "K", "1.500").template
    'K = ⟨K⟩'
    """
    return Phrase(f"{before}{number}{after}", f"{before}⟨{quantity}⟩{after}")


def joined(between: str, parts: Iterable[str]) -> Phrase:
    """Join phrases and words to one phrase."""
    pieces = [*parts]
    return Phrase(between.join(pieces), between.join(map(template_of, pieces)))


def template_of(text: str) -> str:
    """Give the template of a phrase; of plain words they are it themselves."""
    return text.template if isinstance(text, Phrase) else text


def telling(figure: str, stroke: Stroke, content: str = "") -> Stroke:
    """Give lettering of a figure as what it states, where its content is a phrase with slots."""
    contents = (content,) if content else (text.content for text in texts((stroke,)))
    template = " ".join(template_of(part) for part in contents if isinstance(part, str))
    return stating(Statement(Kind.PHRASE, figure, template), stroke) if SLOT.search(template) else stroke


def _text(part: object, language: str) -> object:
    return number(part.value, language, part.digits) if isinstance(part, Slot) else part


def _template(part: object) -> object:
    if isinstance(part, Slot):
        return f"⟨{part.quantity}⟩"
    return template_of(part) if isinstance(part, str) else part


def read_back(template: str, text: str, markup: bool = True) -> list[tuple[str, str]]:
    """Read the numbers of a phrase off a text that is written by its template; none where it says something else.

    The template of a phrase on a sheet is marked up as lettering; that of one in a report is as the text.

    >>> read_back("m_{II} = ⟨m_II⟩ kg,  D = ⟨D⟩ mm", "mII = 0.25 kg, D = 40 mm")
    [('m_II', '0.25'), ('D', '40')]
    """
    names, pieces = SLOT.findall(template), SLOT.split(template)[::2]
    pieces = [Text(0j, piece).plain for piece in pieces] if markup else pieces
    pattern = NUMBER.join(r"\s+".join(map(re.escape, re.split(r"\s+", piece))) for piece in pieces)
    found = re.search(pattern, text)
    return [] if found is None else [*zip(names, found.groups(), strict=True)]
