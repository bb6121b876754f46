"""Figures of the sheets as a report refers to them: by the sheet's number and their headings (ссылки на чертежи)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.sheet_diff.edit import STILL, SheetFigures
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def drawn(leaves: Mapping[str, Sequence[Leaf]], language: str) -> Iterator[str]:
    """List the figures of every sheet."""
    for kind, leaf in ((kind, leaf) for kind, group in leaves.items() for leaf in group):
        figures = ", ".join(_headings(leaf, ("",), language))
        yield word(language, "report.sheet", number=_number(leaf), kind=kind, figures=figures)


def see(leaves: Mapping[str, Sequence[Leaf]], language: str, *starts: str) -> Iterator[str]:
    """Refer to the figures whose names begin so, sheet by sheet; to none where there are none."""
    lines = [
        word(language, "report.on_sheet", number=_number(leaf), figures=", ".join(figures))
        for group in leaves.values()
        for leaf in group
        if (figures := _headings(leaf, starts, language))
    ]
    if lines:
        yield f"\n{word(language, 'report.see', sheets='; '.join(lines))}"


def _number(leaf: Leaf) -> int:
    """Give the number of a sheet in its document; of one that is bound to none, among those of its kind."""
    metadata = leaf.metadata
    return int(metadata["document"]["sheet"] if "document" in metadata else metadata["number"])


def _headings(leaf: Leaf, starts: Sequence[str], language: str) -> list[str]:
    """Give the headings of the figures and tables of a sheet whose names begin so, in that order, each once."""
    figures = SheetFigures(leaf)
    names = (name for start in starts for name in figures.named if name not in STILL and name.startswith(start))
    called = (heading for heading in map(figures.called, names) if heading.key == "exhibit.headed")
    return [*dict.fromkeys(heading.worded(language) for heading in called)]
