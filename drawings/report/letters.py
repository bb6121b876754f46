r"""Letters among the words of a report, in math as its formulas have them (обозначения в тексте)."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import partial

from drawings.lettering.phrase import Phrase, template_of
from drawings.report.formula import SIGNS, letter

# A letter with an index, which a note has in braces and a name of a quantity bare: F_{us}, m_ID_I, R^t_12, J_0^*.
_SIGN = r"(?:(?![²³])\w)"
_ONE = (
    r"[A-Za-zΑ-Ωα-ω]'*(?:\^(?:\{[^{}]*\}|[^\W\d_]))?_"
    rf"(?:\{{[^{{}}]*\}}|[^\W_]+?(?=[A-Za-z]_)|[−-]?{_SIGN}(?:(?:{_SIGN}|[.,])*{_SIGN})?)'*(?:\^\*)?"
)
_LETTERS = re.compile(
    r"(?P<kept>\$\$.*?\$\$|\$.*?\$|`[^`]*`|\"[^\"]*\"|⟨[^⟩]*⟩)"
    rf"|\|(?P<size>{_ONE})\|max"
    rf"|(?<![\w\\^.])(?P<before>[A-Za-z]?)(?P<letters>(?:{_ONE})+)"
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
    return f"${found['before']}{''.join(letter(part, language) for part in re.findall(_ONE, found['letters']))}$"


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
