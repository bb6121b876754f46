"""The line under a heading that states a scale, as it must be and as it stands there (строка масштаба)."""

from __future__ import annotations

import re

from drawings.checks.graphs.figure_strokes import read
from drawings.lettering.words import number, word
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group
from drawings.paper.walk import texts

METRE = 1000.0  # mm
_SCALE = re.compile(r"(μ|K)(\S+) = (\d+(?:[.,]\d+)?)\s")


def scale_line(mu: float, letter: str, unit: str, drafting: Drafting) -> str:
    """Write the scale of a figure, true units a mm, as it must be read; of lengths with its ratio.

    >>> from drawings.paper.hand import GOST_LARGE
    >>> scale_line(0.0025, "l", "m", Drafting(GOST_LARGE)), scale_line(0.02, "v", "m/s", Drafting(GOST_LARGE, "ru"))
    ('μl = 0.0025 m/mm (1:2.5)', 'μv = 0,02 (м/с)/мм')
    """
    told = scale_text(mu, letter, unit, (drafting.language, drafting.notation))
    return f"{told} ({ratio(mu, drafting.language)})" if letter == "l" and drafting.notation != "K" else told


def scale_text(mu: float, letter: str, unit: str, how: tuple[str, str]) -> str:
    """Write a scale as it must begin, in a language and a notation.

    >>> scale_text(0.02, "v", "m/s", ("en", "mu")), scale_text(0.0025, "l", "m", ("ru", "K"))
    ('μv = 0.02 (m/s)/mm', 'Kl = 400 мм/м')
    """
    language, notation = how
    true, mm = word(language, unit), word(language, "mm")
    true = f"({true})" if "/" in true else true
    if notation == "K":
        return read(f"K_{letter} = {number(1 / mu, language)} {mm}/{true}")
    return read(f"μ_{letter} = {number(mu, language)} {true}/{mm}")


def ratio(mu: float, language: str) -> str:
    """Write the ratio of a scale of lengths, m/mm: what is 1 on paper, or 1 in truth."""
    reduced = METRE * mu
    return f"1:{number(reduced, language)}" if reduced >= 1 else f"{number(1 / reduced, language)}:1"


def written_scales(group: Group) -> dict[str, float]:
    """Read the scales that a figure states by their letters, true units a mm; a K is the inverse of mu, 0 is none.

    >>> from drawings.paper.strokes import Text
    >>> written_scales(Group((Text(0j, "μ_{φ} = 0,02 рад/мм;  K_M = 4 mm/(N·m);  K_A = 0 mm/J"),)))
    {'φ': 0.02, 'M': 0.25}
    """
    found = (match for text in texts((group,)) for match in _SCALE.finditer(text.plain))
    pairs = ((match[1], match[2], float(match[3].replace(",", "."))) for match in found)
    return {letter: 1 / value if kind == "K" else value for kind, letter, value in pairs if value}
