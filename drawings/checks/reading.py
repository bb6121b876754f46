"""Reading a laid-out sheet back: its marked groups, its lettering, its tables and written scales (чтение листа)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from drawings.lettering.words import number
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups, texts
from plans.checks.comparison import Finding
from plans.words.words import Message, message

NOTES = "notes"  # the name of their group
_NUMBER = re.compile(r"[-−]?\d+(?:[.,]\d+)?")
_SCALE = re.compile(r"(μ|K)\S+ = (\d+(?:[.,]\d+)?) ")  # of a plan, after its letter: mu_v, K_v


def plain(name: str) -> str:
    """Write a letter without the marks of its levels, as lettering is read.

    >>> plain("R^t_34")
    'Rt34'
    """
    return name.replace("_", "").replace("^", "")


def value_tables(leaf: Leaf) -> Iterator[Group]:
    """Give the tables of values of a sheet, and their parts."""
    return (group for group in leaf.groups if group.name.startswith("values"))


def notes(leaf: Leaf) -> str:
    """Read the notes of a sheet, their lines as one."""
    lines = [text.plain for group in leaf.groups if group.name == NOTES for text in texts((group,))]
    return " ".join(lines).replace("\N{NO-BREAK SPACE}", " ")


def positions_of(group: Group) -> tuple[int, ...]:
    """Give the positions that a table tells of."""
    return tuple(int(k) for k in group.data["positions"].split())


def tables(leaf: Leaf, named: Mapping[str, Finding]) -> Iterator[Message]:
    """Read all tables of values of a sheet back."""
    for group in value_tables(leaf):
        yield from table(group, named, positions_of(group))


def table(group: Group, named: Mapping[str, Finding], positions: tuple[int, ...]) -> Iterator[Message]:
    """Read the numbers of a table of positions back."""
    for text, name, position in wrong_values(group, named, positions):
        yield message("wrong.value", text=text, name=name, position=position)


class Cells(NamedTuple):
    """What a table says of a finding in one position: by plan, by analysis, and the third cell beside them."""

    finding: Finding
    position: int
    plan: str
    analysis: str
    third: str


def cells(group: Group, named: Mapping[str, Finding], positions: tuple[int, ...]) -> Iterator[Cells]:
    """Give the cells of a table, three by three.

    `named` are the findings by what the first cell of their row says before its unit.
    """
    for row in rows(group):
        starts = [j for j, text in enumerate(row) if text.plain.rsplit(", ", 1)[0] in named]
        for j in starts:  # a table of several blocks has several names in a line
            finding = named[row[j].plain.rsplit(", ", 1)[0]]
            own = [text.plain for text in row[j + 1 : j + 1 + 3 * len(positions)]]
            for k, position in enumerate(positions):
                yield Cells(finding, position, *[*own[3 * k : 3 * k + 3], "", "", ""][:3])


def wrong_values(
    group: Group, named: Mapping[str, Finding], positions: tuple[int, ...]
) -> Iterator[tuple[str, str, int]]:
    """Give each text of a table that is not the analysis's value to the half of its last digit: whose, and where."""
    for row in cells(group, named, positions):
        true, slack = row.finding.analysis[row.position], float(row.finding.allowed[row.position])
        value = abs(true) if isinstance(true, complex) else float(true)
        for text in (row.plan, row.analysis):
            if not reads(text, value, slack):
                yield text, row.finding.name, row.position


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


def last_place(text: str) -> float:
    """Give what one in the last place of a number is worth.

    >>> last_place("0,25"), last_place("−14")
    (0.01, 1.0)
    """
    return math.pow(10.0, -len(re.split("[.,]", text)[-1])) if re.search("[.,]", text) else 1.0


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
