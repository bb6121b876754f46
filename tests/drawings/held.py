"""Sheets held to the analysis in memory, as `plandraft draw` holds what it has written (сверка листов)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from drawings.checks import verify
from drawings.checks.expected import Wrong
from drawings.checks.verify import WrittenSheet
from drawings.lettering.lettering import lettered
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.reading.measure import Measured
from drawings.reading.sheet import see
from drawings.sheets.documents import bind
from drawings.sheets.kind import sheet_kind
from plans.study import Study


def faults_on(study: Study, kind: str, leaves: Sequence[Leaf]) -> list[str]:
    """Tell what is wrong with leaves of one kind that no set has bound."""
    return [*map(str, wrongs(study, kind, bind({kind: leaves}, study.scene)[kind]))]


def wrongs(study: Study, kind: str, leaves: Sequence[Leaf]) -> list[Wrong]:
    """List what is wrong with the bound leaves of one kind."""
    sheet, written = study.scene.sheet, [seen(leaf) for leaf in leaves]
    due = {row.key: row for row in sheet_kind(kind).expected(study, leaves)}
    scales = (verify.scale_wrongs(one, sheet_kind(kind).scales, sheet) for one in written)
    return [*chain(*verify.wrongs(written, due, sheet), *scales)]


def seen(leaf: Leaf, mode: str = "text") -> WrittenSheet:
    """See a leaf as it stands in its file."""
    try:
        return WrittenSheet(leaf, see(svg(lettered(leaf, mode))))
    except SheetRefused as refused:
        return WrittenSheet(leaf, refused)


def measured(leaf: Leaf) -> Measured:
    """Measure a leaf as it stands in its file."""
    found = seen(leaf).seen
    assert not isinstance(found, SheetRefused)
    return found.measured
