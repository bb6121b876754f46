"""Sheets held as a draw holds them: written, read back, what they state compared with the analysis."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from pathlib import Path

from drawings.checks import verify
from drawings.checks.wrong import Wrong
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.sheets.documents import bind
from drawings.sheets.table import SHEETS
from plans.study import Study
from plans.techniques import named


def wrongs(study: Study, kind: str, leaves: Sequence[Leaf], folder: Path) -> list[Wrong]:
    """Tell what is wrong with the sheets of a kind."""
    seen, bound = [], bind({kind: leaves}, study.scene)[kind]
    for number, leaf in enumerate(bound):
        path = folder / f"sheet-{number}.svg"
        path.write_bytes(svg(lettered(leaf)))
        seen.append(verify.written(path, leaf))
    due = {row.key: row for row in named(SHEETS[kind].due)(study, bound)}
    return [*chain(*verify.wrongs(seen, due, study.scene.sheet))]
