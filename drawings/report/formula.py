r"""Formulas of a note in Markdown's math, as GitHub and pandoc read it (формулы записки).

What Markdown would take for its own stands in none of them: no asterisk, bar or tilde, no backslash before a
punctuation mark, and every underscore after a letter or a digit.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from drawings.lettering.words import letter as lettered
from drawings.lettering.words import word
from drawings.page.scale import Drafting


class Chapters(NamedTuple):
    """What one technique tells in the report, in the places that the report gives to all techniques."""

    subject: Iterable[str] = ()  # what is studied
    values: Iterable[str] = ()  # what is found: equations, tables of all positions
    conditions: Iterable[str] = ()  # how sharply it is determined, after the comparison of the two roads
    left_out: Iterable[str] = ()  # what the sheets leave out


DIGITS = 5  # of a number of the report
DIRECTION, FULL = 1, 2  # lines under a vector: its direction alone is known, or all of it
SIGNS = {
    "ω": r"\omega", "ε": r"\varepsilon", "φ": r"\varphi", "μ": r"\mu", "Φ": r"\Phi", "τ": r"\tau", "η": r"\eta",
    "θ": r"\theta", "ψ": r"\psi", "π": r"\pi", "δ": r"\delta", "Σ": r"\sum", "α": r"\alpha", "ρ": r"\rho",
    "Δ": r"\Delta",
}  # fmt: skip
_LETTER = re.compile(r"(?P<head>[^_^]+?)(?P<primes>'*)(?:\^(?P<up>\{.*?\}|.))?(?:_(?P<low>\{.*\}'*|[^_]+))?")


class Formula:
    """Writes letters, numbers and units of one language in math."""

    def __init__(self, drafting: Drafting) -> None:
        self.drafting = drafting

    def letter(self, markup: str) -> str:
        """Write a letter with its indices in the language of the report."""
        return letter(markup, self.drafting.language)

    def vector(self, markup: str, known: int = 0) -> str:
        """Write a vector with its bar, and as many lines under it as tell what is known of it."""
        bare = self.letter(markup)
        text = rf"\overline{{{bare}}}" if bare.startswith(r"\text") else rf"\bar {bare}"
        for _ in range(known):
            text = rf"\underline{{{text}}}"
        return text

    def segment(self, *images: str) -> str:
        r"""Write a distance between images on a plan by their letters: p and a3 as pa_{3}."""
        text = ""
        for image in images:
            apart = " " if re.search(r"\\[a-z]+$", text) else ""
            text += apart + self.letter(_lowered(image))
        return text

    def line(self, points: str) -> str:
        """Write a point, or a line by its two points: CB, B1C as B_{1}C."""
        return _index(points)

    def number(self, value: float) -> str:
        """Write a number with its decimal mark, which in math needs braces."""
        return self.drafting.number(value, DIGITS).replace("−", "-").replace(",", "{,}")

    def factor(self, value: float) -> str:
        """Write a number that stands in a product: a negative one in brackets."""
        text = self.number(value)
        return f"({text})" if text.startswith("-") else text

    def quantity(self, value: float, unit: str) -> str:
        """Write a number with its unit."""
        return f"{self.number(value)}{self.unit(word(self.drafting.language, unit))}"

    def unit(self, unit: str) -> str:
        """Write a unit upright after its number, its powers raised."""
        return _text(f" {unit}").replace("²", r"}^{2}\text{").removesuffix(r"\text{}")


def letter(markup: str, language: str) -> str:
    r"""Write a letter with its indices.

    >>> print(letter("R^t_{34}", "ru"), letter("m_{II}", "en"), letter("J_0^*", "en"), letter("R_A'", "en"))
    R_{34}^{\tau} m_{II} J_{0}^{\ast} R_{A}'
    """
    bare, star = re.fullmatch(r"(.*?)(\^\*)?", markup, re.DOTALL).groups()  # type: ignore[union-attr]
    bare, primes = bare.rstrip("'"), "'" * (len(bare) - len(bare.rstrip("'")))
    found = _LETTER.fullmatch(lettered(language, bare))
    if found is None:
        return _text(markup)
    head, up, low = found["head"], found["up"], found["low"]
    if head not in SIGNS and not (head.isascii() and len(head) == 1):
        return _text(markup.replace("_", "").replace("{", "").replace("}", ""))
    text = SIGNS.get(head, head)
    text += f"_{{{_index(low)}}}" if low else ""
    up = r"{\ast}" if star else f"{{{_index(up)}}}" if up else ""
    return text + found["primes"] + primes + (f"^{up}" if up else "")


def inline(*equals: str) -> str:
    """Write sides that equal each other within a line."""
    return f"${' = '.join(equals)}$"


def display(equation: str) -> list[str]:
    """Write an equation on a line of its own."""
    return [f"$${equation}$$", ""]


def total(terms: Sequence[str]) -> str:
    """Add terms up, each with its own sign.

    >>> total(["a", "-b", "c"])
    'a - b + c'
    """
    first, *rest = terms
    return first + "".join(f" - {term[1:]}" if term.startswith("-") else f" + {term}" for term in rest)


def _text(text: str) -> str:
    return rf"\text{{{text}}}"


def _index(index: str) -> str:
    """Write an index: letters of points as they are, words upright."""
    bare = re.fullmatch(r"\{(.*)\}('*)", index)
    text = bare[1] + bare[2] if bare else index
    if text in SIGNS:
        return SIGNS[text]
    text = text.replace("−", "-")
    if not text.isascii() or (text.upper() != text and len(text) > 1):
        return _text(text)
    return re.sub(r"([A-Z])(\d+)", r"\1_{\2}", text)


def _lowered(image: str) -> str:
    """Lower the number of an image's letter: a3 as a_{3}."""
    found = re.fullmatch(r"(\D+?)(\d+)('*)", image)
    return f"{found[1]}_{{{found[2]}}}{found[3]}" if found and "_" not in image else image
