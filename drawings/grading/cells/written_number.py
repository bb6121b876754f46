"""Numbers as students write them: comma or point, a power of ten, a unit with a prefix or none (запись числа)."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import NamedTuple

from drawings.eye.letters import UNREAD
from drawings.paper.strokes import Text

SURE = 3  # digits: a number of as many is rounded, and one of fewer is rough
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_SIGNS = str.maketrans({"−": "-", "–": "-", "—": "-", "‐": "-", "‑": "-", "µ": "μ", "∙": "·", "⋅": "·", "*": "·"})
_GAPS = re.compile(r"(?<=\d)[ \u00a0\u2009\u202f](?=\d{3}(?!\d))")
_WRITTEN = re.compile(
    r"[=≈~±]?\s*(?P<sign>[-+]?)\s*(?P<digits>\d+(?:[.,]\d*)?|[.,]\d+)"
    r"(?:\s*[·×xх]\s*10\s*\^?\s*(?P<power>[-+]?\d{1,2})|[eEеЕ](?P<exponent>[-+]?\d{1,2}))?\s*(?P<unit>\D*\S*)"
)
# What is put before a unit, of both languages, and what it is worth.
_PREFIXES = {
    "μ": 1e-6, "м": 1e-3, "m": 1e-3, "мк": 1e-6, "с": 1e-2, "c": 1e-2, "д": 0.1, "d": 0.1,
    "к": 1e3, "k": 1e3, "М": 1e6, "M": 1e6, "Г": 1e9, "G": 1e9,
}  # fmt: skip
_TURN = math.pi / 30
_RADIANS = {"rad": math.pi / 180, "рад": math.pi / 180}
_DEGREES = ("°", "deg", "град")
_A_MINUTE = ("rpm", "min-1", "1/min", "об/мин", "мин-1", "1/мин")


class Written(NamedTuple):
    """A number that is written in a cell: its value in the column's unit, and what half of its last digit is worth."""

    value: float
    rounding: float


def is_read(texts: Sequence[Text]) -> bool:
    """Tell whether all letters of a cell are read."""
    return not any(UNREAD in text.plain for text in texts)


def number(texts: Sequence[Text], unit: str = "") -> Written | None:
    """Read the number of a cell; None where there is none, or more than one.

    >>> number([Text(0j, "−1,52·10^{3} mm/s")], "m/s")
    Written(value=-1.52, rounding=0.005)
    >>> number([Text(0j, "1.5")]).rounding, number([Text(0j, "2 of 3")])
    (0.0, None)
    """
    plain = _GAPS.sub("", " ".join(map(_levelled, texts)).translate(_SIGNS).translate(_RAISED).strip())
    found = _WRITTEN.fullmatch(plain)
    if found is None:
        return None
    if re.search(r"\s[-+]?\d", found["unit"]):
        return None
    times = _times(*(_bare(one.translate(_RAISED)) for one in (found["unit"], unit)))
    digits = found["digits"].replace(",", ".")
    times *= math.pow(10.0, int(found["power"] or found["exponent"] or 0))
    value = float(f"{found['sign']}{digits}") * times
    if not math.isfinite(value):
        return None
    sure = len(digits.replace(".", "").lstrip("0")) >= SURE
    half = 0.5 * math.pow(10.0, -len(digits.partition(".")[2])) * times
    return Written(value, half if sure else 0.0)


def _levelled(text: Text) -> str:
    return "".join(f"^{run.text}" if run.level > 0 and "10" in text.plain else run.text for run in text.runs)


def _bare(unit: str) -> str:
    """Give a unit without all that is written in several ways."""
    return re.sub(r"[\s^{}()*·]", "", unit).rstrip(".,;")


def _times(own: str, due: str) -> float:
    """Give by what a number is multiplied that is written with a unit; an unknown one is taken as the due one."""
    if own in ("", due):
        return 1.0
    if due and own.endswith(due):
        return _PREFIXES.get(own.removesuffix(due), 1.0)
    if due in _RADIANS and own in _DEGREES:
        return _RADIANS[due]
    if due in _DEGREES and own in _RADIANS:
        return 1 / _RADIANS[own]
    if due in ("rad/s", "рад/с") and own in _A_MINUTE:
        return _TURN
    return _of_lengths(own, due)


def _of_lengths(own: str, due: str) -> float:
    """Give how many of one length the other is where units differ in that alone."""
    sizes = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "мм": 1e-3, "см": 1e-2, "м": 1.0}
    for name in sorted(sizes, key=len, reverse=True):
        for other in sorted(sizes, key=len, reverse=True):
            if own.startswith(name) and due.startswith(other) and own[len(name) :] == due[len(other) :]:
                return sizes[name] / sizes[other]
    return 1.0
