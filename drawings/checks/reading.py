"""Reading a laid-out sheet back: its marked groups, its lettering, its tables and written scales (чтение листа)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping

from drawings.lettering.words import number
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups, texts
from plans.checks.comparison import Finding
from plans.words.words import Message, message

_NUMBER = re.compile(r"[-−]?\d+(?:[.,]\d+)?")
_SCALE = re.compile(r"(μ|K)\S+ = (\d+(?:[.,]\d+)?) ")  # of a plan, after its letter: mu_v, K_v


def plain(name: str) -> str:
    """Write a letter without the marks of its levels, as lettering is read.

    >>> plain("R^t_34")
    'Rt34'
    """
    return name.replace("_", "").replace("^", "")


def tables(leaf: Leaf, named: Mapping[str, Finding]) -> Iterator[Message]:
    """Read all tables of values of a sheet back."""
    for group in leaf.groups:
        if group.name.startswith("values"):
            yield from table(group, named, tuple(int(k) for k in group.data["positions"].split()))


def table(group: Group, named: Mapping[str, Finding], positions: tuple[int, ...]) -> Iterator[Message]:
    """Read the numbers of a table of positions back."""
    for text, name, position in wrong_values(group, named, positions):
        yield message("wrong.value", text=text, name=name, position=position)


def wrong_values(
    group: Group, named: Mapping[str, Finding], positions: tuple[int, ...]
) -> Iterator[tuple[str, str, int]]:
    """Give each text of a table that is not the analysis's value to the half of its last digit: whose it is, and where.

    `named` are the findings by what the first cell of their row says before its unit.
    """
    for row in rows(group):
        finding, j = None, 0
        for text in row:
            begins = named.get(text.plain.rsplit(", ", 1)[0])
            if begins is not None:  # a table of several blocks has several names in a line
                finding, j = begins, 0
                continue
            if finding is not None and j < 3 * len(positions):
                true, slack = finding.analysis[positions[j // 3]], float(finding.allowed[positions[j // 3]])
                if j % 3 < 2 and not reads(text.plain, abs(true) if isinstance(true, complex) else float(true), slack):
                    yield text.plain, finding.name, positions[j // 3]
                j += 1


def rows(group: Group) -> Iterator[list[Text]]:
    """Give the rows of a table, each from left to right."""
    found: dict[float, list[Text]] = {}
    for text in texts((group,)):
        found.setdefault(round(text.at.imag, 3), []).append(text)
    for row in found.values():
        yield sorted(row, key=lambda text: text.at.real)


def reads(text: str, true: float, slack: float, digits: int = 0) -> bool:
    """Tell whether a text is a value to the half of its last digit, beside what the two roads may differ by.

    Of a number written with so many `digits` its end may be left off that is zero.

    >>> reads("0.096", 0.0961, 0.0), reads("0.096", 0.0961, 0.0, 5), reads("123460", 123456.0, 0.0, 5)
    (True, False, True)
    """
    if text == "—":
        return math.isnan(true)
    found = value(text)
    if found is None:
        return False
    last: float = -len(re.split("[.,]", text)[-1]) if re.search("[.,]", text) else 0
    if digits:
        last = math.floor(math.log10(abs(true))) + 1 - digits if true else -math.inf
    return abs(found - true) <= 0.5000001 * math.pow(10.0, last) + 1e-9 * abs(true) + slack


def value(text: str) -> float | None:
    """Read a number; None of what is none.

    >>> value("−0,5"), value("—")
    (-0.5, None)
    """
    return float(text.replace("−", "-").replace(",", ".")) if _NUMBER.fullmatch(text) else None


def marked_scales(leaf: Leaf) -> Iterator[Message]:
    """Read the written scale of each figure that has marks."""
    for figure in leaf.groups:
        marked = (one.data for one in groups((figure,)) if one.data.get("kind") in ("vector", "point"))
        yield from scales(figure, {float(data["scale"]) for data in marked})


def scales(group: Group, stated: Iterable[float]) -> Iterator[Message]:
    """Read a figure's written scale: mu is the one that its vectors are drawn to, and K is 1/mu to its own digits."""
    for text in (text.plain for text in texts((group,))):
        found = _SCALE.match(text)
        if found is None and not text.startswith("μ"):
            continue
        symbol, read = (found[1], found[2].replace(",", ".")) if found else ("", "")
        if not all(read == number(1 / mu if symbol == "K" else mu) for mu in stated):
            yield message("wrong.scale", text=text)
