"""The line under a heading that states a scale: its letter, its number, its unit, its ratio (строка масштаба)."""

from __future__ import annotations

from drawings.checks.forces.headings import scale_text
from drawings.lettering.words import number
from drawings.page.drafting import Drafting

METRE = 1000.0  # mm


def scale_line(mu: float, letter: str, unit: str, drafting: Drafting) -> str:
    """Write the scale of a figure, true units a mm, as it must be read; of lengths with its ratio.

    >>> from drawings.paper.hand import GOST_LARGE
    >>> scale_line(0.0025, "l", "m", Drafting(GOST_LARGE)), scale_line(0.02, "v", "m/s", Drafting(GOST_LARGE, "ru"))
    ('μl = 0.0025 m/mm (1:2.5)', 'μv = 0,02 (м/с)/мм')
    """
    told = scale_text(mu, letter, unit, (drafting.language, drafting.notation))
    return f"{told} ({_ratio(mu, drafting.language)})" if letter == "l" and drafting.notation != "K" else told


def _ratio(mu: float, language: str) -> str:
    """Write the ratio of a scale of lengths, m/mm: what is 1 on paper, or 1 in truth."""
    reduced = METRE * mu
    return f"1:{number(reduced, language)}" if reduced >= 1 else f"{number(1 / reduced, language)}:1"
