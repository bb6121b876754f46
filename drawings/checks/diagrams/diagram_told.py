"""What a sheet tells of the output's course, read back: the table of S, v, a, and the notes on the diagrams."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator

import numpy as np

from drawings.checks import reading
from drawings.checks.diagrams.expected_rows import KEYS, ExpectedRow
from drawings.checks.documents_old import ruled
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.precise import precise, rounded, tells
from drawings.checks.reading import NOTES, reads
from drawings.checks.wrong import Wrong, within
from drawings.figures.diagrams.output_table import ABSENT, NAME
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import groups, texts
from plans.checks.diagrams_comparison import DiagramsComparison
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import TURN
from plans.model.motion import Floats
from plans.words.words import Message, said

FASTER = KEYS[1]  # whose chords span a step each
DIGITS, NOTE_DIGITS = 4, (2,)  # of the table; of the notes
ANGLE = 2  # decimals of φ
EVEN = 1e-3, 1e4  # a column whose largest value lies between is told with the same decimals throughout
ZERO = 1e-9  # of the largest value of a column: less is told as 0
MOST = 36  # positions that are told at most where all are not


def table(leaf: Leaf, comparison: DiagramsComparison, omega: float, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table of the output's course back; the one that a lone sheet bears is whole."""
    due, heads = columns(comparison, omega), headings(comparison, drafting)
    axis, seen = comparison.analysis.axis, set[int]()
    own = output_tables(leaf)
    for group in own:
        yield from ruled.faults(group, NAME, [read(drafting.word("position head")), *heads])
    decimals = [ANGLE, *(_decimals(*column) for column in due[1:])]
    for row in (row for group in own for row in reading.rows(group)):
        cells = [text.plain for text in row]
        if not cells[0].isdigit():
            if cells[1:] != heads:
                yield within("row", NAME, name=" ".join(cells))
            continue
        k = axis.numbers.index(int(cells[0])) if int(cells[0]) in axis.numbers else -1
        if k < 0 or len(cells) != 1 + len(due):
            yield within("row", NAME, name=cells[0])
            continue
        seen.add(k)
        for text, (values, slack), places in zip(cells[1:], due, decimals, strict=True):
            if not _holds(text, float(values[k]), slack, places):
                yield within("cell", NAME, name=cells[0], text=text)
    if leaf.metadata["of"] == 1:
        yield from too_few(seen, comparison)


def output_tables(leaf: Leaf) -> list[Group]:
    """Give the tables of the output's course on a sheet."""
    return [one for one in leaf.groups if one.name.startswith(f"{NAME}-")]


def too_few(seen: Collection[int], comparison: DiagramsComparison) -> Iterator[Wrong]:
    """See that so many positions are told of as there are, or of very many a good part."""
    axis = comparison.analysis.axis
    if len(seen) < min(len(axis.numbers) - axis.closed, MOST // 2):
        yield within("missing_from", NAME, name=str(len(seen)))


def headings(comparison: DiagramsComparison, drafting: Drafting) -> list[str]:
    """Give the headings of the columns: the crank angle, the output's own letters and units."""
    own = (f"{one.name}, {drafting.word(one.unit)}" for one in comparison.findings[:3])
    return [read(head) for head in ("φ, °", *own)]


def columns(comparison: DiagramsComparison, omega: float) -> list[tuple[Floats, float]]:
    """Give what the columns must say at the positions, and how far each may be off."""
    found, turns = comparison.analysis, comparison.analysis.count.turns
    s, v, a = found.at
    whole = s + turns * found.axis.turned, v + turns * omega, a
    slacks = [float(np.nanmax(one.allowed, initial=0.0)) for one in comparison.findings[:3]]
    sizes = [float(np.nanmax(np.abs(row), initial=0.0)) for row in whole]
    sizes = [max(omega**power * size for power, size in enumerate(sizes[k::-1])) for k in range(len(sizes))]
    own = [(row, slack + ZERO * size) for row, slack, size in zip(whole, slacks, sizes, strict=True)]
    return [(found.axis.turned * 360 / TURN, ZERO), *own]


def _decimals(values: Floats, slack: float) -> int | None:
    """Give the decimals that all numbers of a column must have, of its largest value; None: each has its own digits."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    if not (EVEN[0] <= largest - slack and largest + slack < EVEN[1]):
        return None
    ends = {DIGITS - 1 - math.floor(math.log10(one)) for one in (largest - slack, largest + slack)}
    return ends.pop() if len(ends) == 1 else None


def _holds(text: str, true: float, slack: float, places: int | None) -> bool:
    if math.isnan(true) or text == ABSENT:
        return math.isnan(true) and text == ABSENT
    if places is not None and len(text.replace(",", ".").partition(".")[2]) != places:
        return False
    return reads(text, true, slack) or reads(text, true, slack, DIGITS)


def notes(leaf: Leaf, own: DiagramsStudy, rows: tuple[ExpectedRow, ...], drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes on the diagrams back, from the description of the sheet and from where they are written."""
    due = sentences(own, rows, drafting)
    written = [one for one in groups(leaf.groups) if one.name == NOTES]
    for words in (
        read(leaf.description.replace("\n", " ")).split(),
        [word for one in written for text in texts((one,)) for word in text.plain.split()],
    ):
        if words or leaf.metadata["of"] == 1:
            for one in due:
                if not _among(words, one):
                    yield within("missing_from", NOTES, name=rounded(" ".join(one)))


def sentences(own: DiagramsStudy, rows: tuple[ExpectedRow, ...], drafting: Drafting) -> list[list[str]]:
    """Give the words of each note on the diagrams that is due, their numbers with all digits."""
    due = _drawn(own, rows, drafting) if rows else _left_out(own.left_out, drafting)
    return [read(one).split() for one in due]


def _among(words: list[str], due: list[str]) -> bool:
    """Tell whether a note is among words, each of its numbers rounded."""
    true, length = " ".join(due), len(due)
    starts = (k for k, word in enumerate(words) if word == due[0])
    return any(tells(" ".join(words[k : k + length]), true, NOTE_DIGITS, ZERO) for k in starts)


def _left_out(why: Message | None, drafting: Drafting) -> Iterator[str]:
    if why is not None:
        yield drafting.word("diagrams left out", why=said(why, drafting.language))


def _drawn(own: DiagramsStudy, rows: tuple[ExpectedRow, ...], drafting: Drafting) -> Iterator[str]:
    """Give the notes that the diagrams must have, with all digits of their numbers."""
    letters = dict(zip("sva", (row.letter for row in rows), strict=True))
    yield drafting.word("diagrams by chords", **letters)
    yield drafting.word(f"diagrams {own.counted}", **letters)
    if own.linkage.mechanism.drive.epsilon:
        yield drafting.word("diagrams even", **letters)
    told = [_error(row, precise(drafting)) for row in rows if row.off is not None and not row.flat]
    if told:
        yield drafting.word("diagrams off", told=",  ".join(told))


def _error(row: ExpectedRow, drafting: Drafting) -> str:
    assert row.off is not None  # asked only where chords are judged
    numbers, k = row.axis.numbers, row.off.at
    place = f"{numbers[k]}–{numbers[k + 1]}" if row.key == FASTER else str(numbers[k])
    return drafting.word("diagram off", letter=row.letter, off=drafting.number(100 * row.off.share), place=place)
