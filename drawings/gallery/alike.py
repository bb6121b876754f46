"""What tells a drawn file from the kept one: all but the last digits, which processors round otherwise (сличение)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from decimal import Decimal
from itertools import zip_longest
from pathlib import Path
from xml.etree import ElementTree as ET

WITHIN = 0.002  # mm: far under what is seen, and over the last digit of a stroke
STATED = 1e-9  # of the largest: a value that a mark states has 12 digits
LAST = 2  # places of the last digit, of a number of a report
NUMBER = re.compile(r"-?(?:\d+(?:[.,]\d+)?|\.\d+)(?:e[+-]\d+)?")
GEOMETRY = frozenset({"d", "cx", "cy", "r", "stroke-dasharray", "data-deviation"})
WORDS = frozenset({"data-text", "data-name", "id", "class"})
# Of a report, what measures rounding itself, and the analysis beside where the last of ten digits differs.
ROUNDINGS = re.compile(r"^## (?:Comparison|Сравнение).*?(?=^## )|^- .*DOP853.*?$|<br>[^|]*", re.MULTILINE | re.DOTALL)


def differences(fresh: Path, kept: Path) -> Iterator[str]:
    """Tell what differs: of a sheet its elements in their order, of a report or a table its words and numbers."""
    if not kept.exists():
        yield f"{kept.name}: came"
        return
    told = _of_sheets if kept.suffix == ".svg" else _of_words
    yield from (f"{kept.name}: {one}" for one in told(fresh.read_text("utf-8"), kept.read_text("utf-8")))


def _of_sheets(fresh: str, kept: str) -> Iterator[str]:
    elements = (ET.fromstring(text.encode()).iter() for text in (fresh, kept))
    for place, (new, old) in enumerate(zip_longest(*elements)):
        if new is None or old is None or new.tag != old.tag or new.keys() != old.keys():
            yield f"element {place} is another one"
            return
        if new.get("id") != "seal" and (new.text, new.tail) != (old.text, old.tail):
            yield f"words of element {place}: {old.text!r} -> {new.text!r}"
        for key, value in old.items():
            if not _agree(key, new.attrib[key], value):
                yield f"{key} of element {place}: {value} -> {new.attrib[key]}"


def _agree(key: str, new: str, old: str) -> bool:
    if new == old:
        return True
    if key in WORDS or NUMBER.sub("#", new) != NUMBER.sub("#", old):
        return False
    ours, theirs = ([float(one.replace(",", ".")) for one in NUMBER.findall(text)] for text in (new, old))
    within = WITHIN if key in GEOMETRY else STATED * max(map(abs, theirs))
    return all(abs(a - b) <= within for a, b in zip(ours, theirs, strict=True))


def _of_words(fresh: str, kept: str) -> Iterator[str]:
    ours, theirs = (ROUNDINGS.sub("", text).splitlines() for text in (fresh, kept))
    for new, old in zip_longest(ours, theirs, fillvalue=""):
        if new != old and not (NUMBER.sub("#", new) == NUMBER.sub("#", old) and _near(new, old)):
            yield f"{old} -> {new}"


def _near(new: str, old: str) -> bool:
    pairs = zip(NUMBER.findall(new), NUMBER.findall(old), strict=True)
    return all(_off(one, other) <= LAST for one, other in pairs)


def _off(one: str, other: str) -> Decimal:
    """Tell how many places of the last digit two numbers are apart."""
    a, b = (Decimal(number.replace(",", ".")) for number in (one, other))
    return abs(a - b).scaleb(-min(int(a.as_tuple().exponent), int(b.as_tuple().exponent)))
