"""The lines of a report as its self-check reads them: chapters, cells, notes without braces (строки отчёта)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

CHAPTER, ANY = "## ", "#"  # how the next head begins: of a chapter, or of any part


def part(text: str, head: str, ends: str = CHAPTER) -> list[str]:
    """Give the lines of a chapter by its head, up to the next head; none where there is no such chapter."""
    return next(parts(text, head, ends), [])


def parts(text: str, head: str, ends: str = ANY) -> Iterator[list[str]]:
    """Give the lines under each head that is written so, empty ones left out.

    >>> list(parts("# A\\n\\n1\\n# B\\n2\\n# A\\n3", "# A"))
    [['1'], ['3']]
    """
    own, lines = head.strip().partition("\n")[0], text.splitlines()
    for start in (k + 1 for k, line in enumerate(lines) if line == own):
        end = next((k for k in range(start, len(lines)) if lines[k].startswith(ends)), len(lines))
        yield [line for line in lines[start:end] if line.strip()]


def cells(line: str) -> list[str]:
    """Give the cells of a row of a table.

    >>> cells("| 0 |  | 1.5 |")
    ['0', '', '1.5']
    """
    return [cell.strip() for cell in line.strip()[1:-1].split("|")]


def tables(text: str) -> Iterator[list[list[str]]]:
    """Give the tables of a report, row by row, the rule under the heads among them.

    >>> list(tables("| a | b |\\n|---|---|\\n| 1 | 2 |\\n\\n| c |"))
    [[['a', 'b'], ['---', '---'], ['1', '2']], [['c']]]
    """
    for tabled, lines in groupby(text.splitlines(), lambda line: line.startswith("|")):
        if tabled:
            yield [cells(line) for line in lines]


def in_report(note: str) -> str:
    """Write a note as a report has it: without the braces of its indices, in plain single spaces.

    >>> in_report("M_{bal} =  4")
    'M_bal = 4'
    """
    return " ".join(note.replace("{", "").replace("}", "").split())
