r"""Formulas of a note in Markdown's math, as GitHub and pandoc read it (формулы записки).

What Markdown would take for its own stands in none of them: no asterisk, bar or tilde, no backslash before a
punctuation mark, and every underscore after a letter or a digit.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from drawings.lettering.words import LEVEL, Phrase, template_of
from drawings.lettering.words import letter as lettered
from drawings.page.page import Drafting
from drawings.paper.strokes import Leaf
from drawings.reading.items import STILL, SheetFigures
from plans.words.words import word


class Chapters(NamedTuple):
    """What one technique tells in the report, in the places that the report gives to all techniques."""

    subject: Iterable[str] = ()  # what is studied
    values: Iterable[str] = ()  # what is found: equations, tables of all positions
    conditions: Iterable[str] = ()  # how sharply it is determined, after the comparison of the two roads
    left_out: Iterable[str] = ()  # what the sheets leave out


DIGITS = 5  # of a number of the report
BAR = "\N{COMBINING MACRON}"  # over the letter of a vector in a note
DIRECTION, FULL = 1, 2  # lines under a vector: its direction alone is known, or all of it
SIGNS = {
    "ω": r"\omega", "ε": r"\varepsilon", "φ": r"\varphi", "μ": r"\mu", "Φ": r"\Phi", "τ": r"\tau", "η": r"\eta",
    "θ": r"\theta", "ψ": r"\psi", "π": r"\pi", "δ": r"\delta", "Σ": r"\sum", "α": r"\alpha", "ρ": r"\rho",
    "γ": r"\gamma", "Δ": r"\Delta",
}  # fmt: skip
_POWER = re.compile("·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
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
            found = re.fullmatch(r"(\D+?)(\d+)('*)", image)  # the letter of an image: a3 as a_{3}
            text += apart + self.letter(f"{found[1]}_{{{found[2]}}}{found[3]}" if found and "_" not in image else image)
        return text

    def line(self, points: str) -> str:
        """Write a point, or a line by its two points: CB, B1C as B_{1}C."""
        return _index(points)

    def number(self, value: float) -> str:
        """Write a number with its decimal mark, which in math needs braces."""
        text = self.drafting.number(value, DIGITS).replace("−", "-").replace(",", "{,}")
        return _POWER.sub(lambda found: rf" \cdot 10^{{{found[1].translate(LEVEL)}}}", text)

    def factor(self, value: float) -> str:
        """Write a number that stands in a product: a negative one in brackets."""
        text = self.number(value)
        return f"({text})" if text.startswith("-") or "cdot" in text else text

    def quantity(self, value: float, unit: str) -> str:
        """Write a number with its unit."""
        return f"{self.number(value)}{self.unit(self.drafting.word(unit))}"

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


# A letter with an index, which a note has in braces and a name of a quantity bare: F_{us}, m_ID_I, R^t_12, J_0^*.
_SIGN = r"(?:(?![²³])\w)"
_ONE = (
    rf"[A-Za-zΑ-Ωα-ω]{BAR}?'*(?:\^(?:\{{[^{{}}]*\}}|[^\W\d_]))?_"
    rf"(?:\{{[^{{}}]*\}}|[^\W_]+?(?=[A-Za-z]_)|[−-]?{_SIGN}(?:(?:{_SIGN}|[.,])*{_SIGN})?)'*(?:\^\*)?"
)
_LETTERS = re.compile(
    r"(?P<kept>\$\$.*?\$\$|\$.*?\$|`[^`]*`|\"[^\"]*\"|⟨[^⟩]*⟩)"
    rf"|\|(?P<size>{_ONE})\|max"
    rf"|(?<![\w\\^.])(?P<before>\d*[A-Za-z]?)(?P<letters>(?:{_ONE})+)"
    r"|(?<![\w\\^.])(?P<raised>[A-Z]'*\^[^\W\d_]'*)(?!\w)"
    r"|(?P<base>\d+)\^(?:\{(?P<braced>[^{}]*)\}|(?P<bare>\d))"
)


def mathed(line: str, language: str) -> str:
    r"""Write the letters of a line in math; what is math already, a key or a quotation stays as it is.

    >>> print(mathed("F_us of $a_b$: m_ID_I, 10^{−11}, `l_OA`", "ru"))
    $F_{\text{п.с}}$ of $a_b$: $m_{I}D_{I}$, $10^{-11}$, `l_OA`
    """
    write = partial(_LETTERS.sub, partial(_written, language=language))
    return Phrase(write(line), write(template_of(line))) if isinstance(line, Phrase) else write(line)


def _written(found: re.Match[str], language: str) -> str:
    if found["kept"]:
        return found[0]
    if found["base"]:
        power = (found["braced"] or found["bare"]).replace("−", "-")
        return f"${found['base']}^{{{power}}}$"
    if found["size"]:
        return rf"$\lvert {letter(found['size'], language)}\rvert_{{\text{{max}}}}$"
    if found["raised"]:
        return f"${letter(found['raised'], language)}$"
    parts = re.findall(_ONE, found["letters"])
    written = (r"\bar " * (BAR in part) + letter(part.replace(BAR, ""), language) for part in parts)
    return f"${found['before']}{''.join(written)}$"


GREEK = {sign: letter for letter, sign in SIGNS.items()}
_COMMAND = re.compile(r"\\(?:underline|overline|bar|text|quad)(?![a-z]) ?|[{}]")


def unmathed(formula: str) -> str:
    r"""Write a formula as a screen has it.

    >>> unmathed(r"\underline{\bar v_{B}} = \bar v_{A} + \bar a_{BA}^{\tau} \cdot 2,\quad \omega_{1} = 0")
    'v_B = v_A + a_BA^τ · 2, ω_1 = 0'
    """
    signs = {**GREEK, r"\cdot": "·"}
    text = re.sub(r"\\[a-z]+", lambda found: signs.get(found[0], found[0]), formula, flags=re.IGNORECASE)
    return " ".join(_COMMAND.sub(lambda found: " " if "quad" in found[0] else "", text).split())


def plain(note: str) -> str:
    """Write a note without the braces of its indices, as a screen has it.

    >>> plain("r_{C1} = 12  mm^2")
    'r_C1 = 12 mm²'
    """
    return raised(note).replace("{", "").replace("}", "")


def raised(note: str) -> str:
    """Write a note in single spaces, squares raised."""
    return " ".join(note.replace("^2", "²").split())


def listed(title: str, notes: Iterable[str]) -> list[str]:
    """Write a chapter as a list; one without notes is left out."""
    entries = [*map(entry, notes)]
    return [title, *entries] if entries else []


def entry(note: str) -> Phrase:
    """Give a note as a line of a list, its numbers still those of their quantities."""
    return Phrase(f"- {raised(note)}", f"- {raised(template_of(note))}")


def drawn(leaves: Mapping[str, Sequence[Leaf]], language: str) -> Iterator[str]:
    """List the figures of every sheet."""
    for kind, leaf in ((kind, leaf) for kind, group in leaves.items() for leaf in group):
        figures = ", ".join(_headings(leaf, ("",), language))
        yield word(language, "report.sheet", number=_number(leaf), kind=kind, figures=figures)


def see(leaves: Mapping[str, Sequence[Leaf]], language: str, *starts: str) -> Iterator[str]:
    """Refer to the figures whose names begin so, sheet by sheet; to none where there are none."""
    told = ((leaf, _headings(leaf, starts, language)) for group in leaves.values() for leaf in group)
    lines = [word(language, "report.on_sheet", number=_number(leaf), figures=", ".join(on)) for leaf, on in told if on]
    if lines:
        yield f"\n{word(language, 'report.see', sheets='; '.join(lines))}"


def _number(leaf: Leaf) -> int:
    """Give the number of a sheet in its document; of one that is bound to none, among those of its kind."""
    metadata = leaf.metadata
    return int(metadata["document"]["sheet"] if "document" in metadata else metadata["number"])


def _headings(leaf: Leaf, starts: Sequence[str], language: str) -> list[str]:
    """Give the headings of the figures and tables of a sheet whose names begin so, in that order, each once."""
    figures = SheetFigures(leaf)
    names = (name for start in starts for name in figures.named if name not in STILL and name.startswith(start))
    called = (heading for heading in map(figures.called, names) if heading.key == "exhibit.headed")
    return [*dict.fromkeys(heading.worded(language) for heading in called)]


_MARKS = re.compile(r"[\\`*_\[\]#|$~]")  # that begin a mark of Markdown or TeX


def literal(text: str) -> str:
    r"""Write a text of the scene so that Markdown, and what is made of it, has it as it stands and nothing more.

    The signs of HTML are named by its own means, which all converters know.

    >>> print(literal(r"<b> $x$ \input{a}"))
    &lt;b&gt; \$x\$ \\input{a}
    """
    marked = _MARKS.sub(r"\\\g<0>", " ".join(text.split()))
    return marked.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
