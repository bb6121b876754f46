"""Scales as students write them: mu or K, any power of ten, any unit, or the ratio of lengths (запись масштаба)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from drawings.eye.alike import folded
from drawings.grading.cells.written_number import NUMBER, levelled, plainly, value_of
from drawings.grading.seeing.units import in_system, in_unit
from drawings.paper.strokes import Text

LENGTHS = "l"  # what a scale of lengths is lettered
METRE = 1000.0  # mm
_STATED = re.compile(
    r"(?<![^\W\d_])(?P<kind>μ|mu|K|К)[_\s]?[{(]?(?P<letter>[^\s=:≈{}()]{1,6}?)[})]?\s*[=:≈]\s*"
    rf"{NUMBER}(?:\s*/\s*(?P<under>\d+(?:[.,]\d+)?))?(?=(?P<rest>[^;=,]*))"
)
_RATIO = re.compile(r"\(?(?:M|М|[Ss]cale|[Мм]асштаб)?\s*(\d+(?:[.,]\d+)?)\s*:\s*(\d+(?:[.,]\d+)?)\)?")


def stated_scales(texts: Iterable[Text], due: Mapping[str, str]) -> dict[str, float]:
    """Give the scales that texts state, true units a mm, by the letters that are due with their units; the first goes.

    >>> stated_scales([Text(0j, "μ_{v} = 10 (mm/s)/mm, K_M=2.5·10^{-4} mm/(N·m)")], {"v": "m/s", "M": "N*m"})
    {'v': 0.01, 'M': 4000.0}
    """
    found: dict[str, float] = {}
    for text in texts:
        own = ((letter, next(scales_of(text, letter, unit), None)) for letter, unit in due.items())
        found = {letter: mu for letter, mu in own if mu is not None} | found
    return found


def scales_of(text: Text, letter: str, unit: str) -> Iterator[float]:
    """Give the scales of one letter that a text states, true units a mm; one of lengths may be a ratio.

    >>> [*scales_of(Text(0j, "μl = 0.0025 m/mm (1:2.5)"), "l", "m")], [*scales_of(Text(0j, "M 1:2"), "l", "m")]
    ([0.0025], [0.002])
    """
    plain = plainly(levelled(text))
    for found in _STATED.finditer(plain):
        under = float((found["under"] or "1").replace(",", "."))
        if folded(found["letter"]) == folded(letter) and (value := value_of(found)[0]) and under:
            mu = value / under * _worth(found["rest"], unit, found["kind"] in "KК")
            yield 1 / mu if found["kind"] in "KК" else mu
    if letter == LENGTHS and (ratio := _RATIO.fullmatch(plain)):
        paper, true = (float(one.replace(",", ".")) for one in ratio.groups())
        if paper and true:
            yield true / paper / METRE


def _worth(rest: str, unit: str, inverse: bool) -> float:
    """Give by what a number is multiplied whose unit stands before other words; by nothing where it has none.

    A unit of another quantity is taken as it is: it is the number that tells a plan by its scale.
    """
    words = re.split(r"\(\d", rest)[0].split()
    for count in range(len(words), 0, -1):
        times = _times(" ".join(words[:count]), unit, inverse)
        if times is not None:
            return times
    return 1.0


def _times(own: str, unit: str, inverse: bool) -> float | None:
    """Give what a unit is worth in that which is due, or in that of the system where none is known.

    Where it has no mm in it, it is of what one mm shows.
    """
    if unit:
        told = in_unit(own, f"mm/({unit})" if inverse else f"({unit})/mm")
        return in_unit(own, unit) if told is None and not inverse else told
    worth = in_system(own)
    if worth is None or not re.search("mm|мм", own):
        return worth
    return worth * METRE if inverse else worth / METRE
