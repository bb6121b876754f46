"""What the sheets of a set bear together: each figure once, all rows of a table, the notes once (состав комплекта)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from drawings.checks import reading
from drawings.checks.reading import NOTES
from drawings.checks.wrong import Wrong, within
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups
from plans.words.words import message


def figures(leaves: Sequence[Leaf], due: Collection[str]) -> Iterator[Wrong]:
    """See that each figure that is due is drawn on one of the sheets, and that their data name what they bear."""
    for name in due:
        if sum(_bears(leaf, name) for leaf in leaves) != 1:
            yield message("wrong.figure_missing", name=name)
    for leaf in leaves:
        named = set(leaf.metadata["figures"])
        yield from (message("wrong.figure", name=name) for name in sorted(named - {*due}))
        borne = {name for name in due if _bears(leaf, name)}
        yield from (message("wrong.figure_missing", name=name) for name in sorted(borne ^ named.intersection(due)))


def table(leaves: Sequence[Leaf], name: str, rows: Collection[str]) -> Iterator[Wrong]:
    """See that each row of a table, by its first cell, stands on one of the sheets."""
    parts = (one for leaf in leaves for one in groups(leaf.groups) if _part_of(one.name, name))
    seen = [row[0].plain for part in parts for row in reading.rows(part)]
    yield from (within("missing_from", name, name=row) for row in rows if row not in seen)
    yield from (within("stranger_in", name, text=row) for row in rows if seen.count(row) > 1)


def parted(leaves: Sequence[Leaf], due: Collection[str]) -> Iterator[Wrong]:
    """See that each table that is due stands on one of the sheets, in one part or several (its rows are held there)."""
    for name in due:
        count = sum(any(_part_of(one.name, name) for one in leaf.groups) for leaf in leaves)
        if count != 1:
            yield message("wrong.differs" if count else "wrong.missing", name=name)


def notes(leaves: Sequence[Leaf]) -> Iterator[Wrong]:
    """See that one of the sheets bears the notes."""
    count = sum(any(one.name == NOTES for one in leaf.groups) for leaf in leaves)
    if count != 1:
        yield message("wrong.notes_on", count=count)


def _part_of(group: str, table: str) -> bool:
    return group.removeprefix(f"{table}-").isdigit()


def _bears(leaf: Leaf, name: str) -> bool:
    """Tell whether a sheet bears a figure, or the first part of one that is drawn in parts."""
    return any(one.name == name or one.name.startswith(f"{name}-bounds") for one in leaf.groups)
