"""The numbers and designations in the title blocks of the sheets of a set (нумерация листов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.checks.wrong import Wrong
from drawings.page.page import BLOCK
from drawings.page.title_cell import NUMBERS
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups, texts
from plans.scene.sheet import SheetTable
from plans.words.words import message


def faults(leaves: Mapping[str, Sequence[Leaf]], sheet: SheetTable) -> Iterator[Wrong]:
    """Give the sheets of a set, by their kinds, that are not numbered through their documents."""
    documents: dict[str, list[tuple[str, Leaf]]] = {}
    for kind, own in leaves.items():
        documents.setdefault(sheet.designated(kind), []).extend((kind, leaf) for leaf in own)
    for name, document in documents.items():
        yield from _misnumbered(name, document, sheet.standard)


def _misnumbered(name: str, document: Sequence[tuple[str, Leaf]], standard: str) -> Iterator[Wrong]:
    """Give the sheets of a document whose title block says another number, count or designation."""
    count = len(document)
    for number, (kind, leaf) in enumerate(document, 1):
        gost = [f"{number}"] * (count > 1) + [f"{count}"] * (number == 1)
        block = [group for group in groups(leaf.groups) if group.name in (BLOCK, NUMBERS)]
        told = [text.plain for group in block if group.name == NUMBERS for text in texts(group.strokes)]
        if told != (gost if standard == "GOST" else [f"{number}/{count}"]):
            yield message("wrong.sheet_number", number=number, count=count, kind=kind)
        if name.replace(" ", "") not in "".join(text.plain for text in texts(block)).replace(" ", ""):
            yield message("wrong.designation", name=name, kind=kind)
