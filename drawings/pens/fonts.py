"""Lettering in the fonts of a viewer (шрифты): which are asked for, and how long a text is in the widest of them."""

from __future__ import annotations

import cmath
import json
import math
import unicodedata
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

from drawings.lettering.lettering import index_size, text_width
from drawings.paper.strokes import LOWERED, RAISED, Run, Text

# Drawing fonts first, then the one whose advances are known: librsvg sets it as long as it must be.
FONTS = "'GOST type B','osifont','DejaVu Sans',sans-serif"
EM = 1.4  # a font's size over the height of its capitals: 1.37 to 1.43 in the usual ones
WIDEST = Path(__file__).parent / "advances.json"  # of DejaVu Sans, one of the widest
_RISES = {-1: -LOWERED, 1: RAISED}  # of levels, in sizes
THOUSAND = 1000  # parts of a font's size in which its advances are counted


def pieces(text: Text) -> Iterator[Text]:
    """Take a text apart by its levels, each piece from where our own alphabet would write it, without spaces around it.

    librsvg is mistaken about how long a narrowed text is: where its middle lies, and where it goes on after a level.

    >>> from drawings.paper.strokes import Text
    >>> [(one.plain, one.size) for one in pieces(Text(0j, "v_{BA} = 2", 5.0))]
    [('v', 5.0), ('BA', 3.5), ('= 2', 5.0)]
    """
    turn = cmath.rect(1, math.radians(text.rotation))
    start = text.at - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.anchor] * text_width(text) * turn
    for k, (plain, level) in enumerate(text.runs):
        if not plain.strip():
            continue
        size, rise = (index_size(text.size), _RISES[level] * text.size) if level else (text.size, 0.0)
        own = text._replace(content=(Run(plain.strip()),), size=size, anchor="start")
        through = text._replace(content=(*text.runs[:k], Run(plain.rstrip(), level)))
        yield own._replace(at=start + complex(text_width(through) - text_width(own), rise) * turn)


def longest(text: Text) -> float:
    """Give the length of a text without levels in the widest font that a viewer may take, mm.

    >>> from drawings.paper.strokes import Text
    >>> longest(Text(0j, "ИН", 10.0)) > longest(Text(0j, "ii", 10.0)) > 0
    True
    """
    return EM * text.size * _advance(text.plain)


def _advance(plain: str) -> float:
    """Give the length of a text in font sizes; accents stand over their letters, a foreign sign is a square."""
    signs = (sign for sign in unicodedata.normalize("NFD", plain) if not unicodedata.combining(sign))
    return sum(_advances().get(sign, THOUSAND) for sign in signs) / THOUSAND


@cache
def _advances() -> Mapping[str, int]:
    table = json.loads(WIDEST.read_text("utf-8"))
    return {sign: int(advance) for advance, signs in table.items() for sign in signs}
