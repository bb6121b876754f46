"""Numbers and scales as students write them, in a cell or over a figure (запись чисел и масштабов)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.grading.units import in_system, in_unit
from drawings.paper.strokes import Text
from drawings.reading.alphabet import UNREAD, folded

SURE = 3  # digits: a number of as many is rounded, and one of fewer is rough
_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺"
_LEVEL = str.maketrans(_RAISED, "0123456789-+")
_POWERS = re.compile(f"[{_RAISED}]+")
_SIGNS = str.maketrans({"−": "-", "–": "-", "—": "-", "‐": "-", "‑": "-", "µ": "μ", "∙": "·", "⋅": "·", "*": "·"})
_GAPS = re.compile(r"(?<![\d.,])\d{1,3}(?:[ \u00a0\u2009\u202f]\d{3})+(?!\d)")  # thousands, and no two numbers
_POWER = r"\s*\(?(?P<{}>[-+]?\d{{1,2}})\)?"
NUMBER = (
    r"(?P<sign>[-+]?)\s*(?P<digits>\d+(?:[.,]\d*)?|[.,]\d+)"
    rf"(?:\s*[·×xх]\s*10\s*\^?{_POWER.format('power')}"
    rf"|\s+10\s*\^{_POWER.format('apart')}"
    r"|[eEеЕ](?P<exponent>[-+]?\d{1,2}))?"
)


_WRITTEN = re.compile(rf"[=≈~±]?\s*{NUMBER}\s*(?P<unit>.*)")
# What follows a number is no unit if it begins as another number does, or holds one.
_ANOTHER = re.compile(r"(?!1/[^\W\d])[-+\d.,/×:^·]|.*\s[-+]?\d")
_ANGLE = re.compile(r"(?P<sign>-?)\s*(?P<degrees>\d+)\s*°\s*(?P<minutes>\d{1,2}(?:[.,]\d+)?)\s*['′’]")
MINUTE = 1 / 60  # of a degree


class WrittenNumber(NamedTuple):
    """A number that is written in a cell: its value in the column's unit, and what half of its last digit is worth.

    The value is NaN where the unit that is written is not understood.
    """

    value: float
    rounding: float

    @property
    def understood(self) -> bool:
        """Whether its unit is."""
        return not math.isnan(self.value)


def is_read(texts: Sequence[Text]) -> bool:
    """Tell whether all letters of a cell are read."""
    return not any(UNREAD in text.plain for text in texts)


def number(texts: Sequence[Text], unit: str = "") -> WrittenNumber | None:
    """Read the number of a cell; None where there is none, or more than one.

    >>> number([Text(0j, "−1,52·10^{3} mm/s")], "m/s")
    WrittenNumber(value=-1.52, rounding=0.005)
    >>> number([Text(0j, "1.5")]).rounding, number([Text(0j, "2 of 3")]), number([Text(0j, "5 ells")], "m").understood
    (0.0, None, False)
    >>> number([Text(0j, "30°15'")], "°"), number([Text(0j, "0.0000 9.99")])
    (WrittenNumber(value=30.25, rounding=0.008333333333333333), None)
    """
    plain = plainly(" ".join(map(levelled, texts)))
    if (angle := _ANGLE.fullmatch(plain)) is not None:
        return _angle(angle, unit)
    found = _WRITTEN.fullmatch(plain)
    if found is None or _ANOTHER.match(found["unit"]):
        return None
    times = in_unit(found["unit"], unit)
    value, half = value_of(found)
    if not math.isfinite(value):
        return None
    if times is None:
        return WrittenNumber(math.nan, 0.0)
    return WrittenNumber(value * times, half * times)


def plainly(text: str) -> str:
    """Write a text with one sign for each that is written in several ways, and powers after a ^."""
    signed = _POWERS.sub(lambda found: f"^{found[0].translate(_LEVEL)}", text.translate(_SIGNS))
    return _GAPS.sub(lambda found: re.sub(r"\s", "", found[0]), signed).strip()


def value_of(found: re.Match[str]) -> tuple[float, float]:
    """Give the value of a number that was found, and what half of its last digit is worth if it is rounded."""
    digits = found["digits"].replace(",", ".")
    times = math.pow(10.0, int(found["power"] or found["apart"] or found["exponent"] or 0))
    sure = len(digits.replace(".", "").lstrip("0")) >= SURE
    half = 0.5 * math.pow(10.0, -len(digits.partition(".")[2])) * times
    return float(f"{found['sign']}{digits}") * times, half if sure else 0.0


def _angle(found: re.Match[str], unit: str) -> WrittenNumber:
    minutes = found["minutes"].replace(",", ".")
    value = float(found["degrees"]) + MINUTE * float(minutes)
    half = 0.5 * math.pow(10.0, -len(minutes.partition(".")[2])) * MINUTE
    times = in_unit("°", unit)
    times = math.nan if times is None else times
    return WrittenNumber((-value if found["sign"] else value) * times, half * times)


def levelled(text: Text) -> str:
    """Write a text with a ^ before what is raised over a ten."""
    return "".join(f"^{run.text}" if run.level > 0 and "10" in text.plain else run.text for run in text.runs)


LENGTHS = "l"  # what a scale of lengths is lettered
METRE = 1000.0  # mm
_STATED = re.compile(
    r"(?<![^\W\d_])(?P<kind>μ|mu|K|К)[_\s]?[{(]?(?P<letter>[^\s=:≈{}()]{1,6}?)[})]?\s*[=:≈]\s*"
    rf"{NUMBER}(?:\s*/\s*(?P<under>\d+(?:[.,]\d+)?))?(?=(?P<rest>[^;=,]*))"
)


_RATIO = re.compile(r"\(?(?:M|М|[Ss]cale|[Мм]асштаб)?\s*(\d+(?:[.,]\d+)?)\s*:\s*(\d+(?:[.,]\d+)?)\)?")


def stated_scales(texts: Iterable[Text], expected: Mapping[str, str]) -> dict[str, float]:
    """Give the scales that texts state, true units a mm, by the letters that are due with their units; the first goes.

    >>> stated_scales([Text(0j, "μ_{v} = 10 (mm/s)/mm, K_M=2.5·10^{-4} mm/(N·m)")], {"v": "m/s", "M": "N*m"})
    {'v': 0.01, 'M': 4000.0}
    """
    found: dict[str, float] = {}
    for text in texts:
        read = ((letter, next(scales_of(text, letter, unit), None)) for letter, unit in expected.items())
        found = {letter: mu for letter, mu in read if mu is not None} | found
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
        paper, true = (float(group.replace(",", ".")) for group in ratio.groups())
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


def _times(written: str, unit: str, inverse: bool) -> float | None:
    """Give what a unit is worth in that which is due, or in that of the system where none is known.

    Where it has no mm in it, it is of what one mm shows.
    """
    if unit:
        size = in_unit(written, f"mm/({unit})" if inverse else f"({unit})/mm")
        return in_unit(written, unit) if size is None and not inverse else size
    worth = in_system(written)
    if worth is None or not re.search("mm|мм", written):
        return worth
    return worth * METRE if inverse else worth / METRE
