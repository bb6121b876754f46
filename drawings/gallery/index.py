"""The index of the gallery in Markdown: every mechanism with its structure, what is special, sheets, scene, report."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from drawings.gallery.catalogue import Entry
from drawings.gallery.engines import engines
from drawings.report.table import Subject, report_of
from plans.study import Study
from plans.words.words import word

PAGE = "README.md"

OPENING = """\
# Gallery

Mechanisms of the courses, each a scene to start from, drawn and compared with the analysis. A picture opens its sheet;
the report beside it holds every position's values by both roads.

```console
plandraft new shaper              # puts shaper.toml into this folder, to be changed; without a name: the list
plandraft draw shaper.toml -o out/
python -m drawings.gallery        # draws all of it anew, and tells what changes; --because REASON keeps that
```

| mechanism | scene | structure | output | sheet |
|---|---|---|---|---|
"""

CLOSING = """
The [alphabet](alphabet.svg) in which the sheets are lettered is drawn by the same command.
"""


class GalleryScene(NamedTuple):
    """A scene of the gallery with its study, and the files that were written for it."""

    entry: Entry
    study: Study
    paths: tuple[Path, ...]


def index(exhibits: Sequence[GalleryScene]) -> str:
    """Write the index page."""
    rows = "".join(map(row, exhibits))
    return OPENING + rows + "".join(map(section, exhibits)) + engines() + CLOSING


def row(exhibit: GalleryScene) -> str:
    """Write a mechanism's row of the table."""
    entry, study = exhibit.entry, exhibit.study
    link = f"[{entry.title}](#{anchor(entry.title)})"
    subject = subject_of(study)
    return f"| {link} | `{entry.name}` | {subject.structure} | {subject.output} | {_sheet(study)} |\n"


def section(exhibit: GalleryScene) -> str:
    """Write a mechanism's section: its words, structure, sheets, and where to go on."""
    entry, subject = exhibit.entry, subject_of(exhibit.study)
    sheets = [path.name for path in exhibit.paths if path.suffix == ".svg"]
    pictures = "\n\n".join(f"[![{entry.title}: {name}]({name})]({name})" for name in sheets)
    others = [f"[{path.name}]({path.name})" for path in exhibit.paths if path.suffix != ".svg"]
    links = " · ".join([f"[{entry.name}.toml]({entry.name}.toml)", *others, f"`plandraft new {entry.name}`"])
    return f"\n## {entry.title}\n\n{entry.about}\n\n{subject.sentence}\n\n{pictures}\n\n{links}\n"


def subject_of(study: Study) -> Subject:
    """Tell what is studied: the first technique of a scene says it."""
    return report_of(study.techniques[0]).subject(study)


def _sheet(study: Study) -> str:
    table = study.scene.sheet
    return f"{table.format}, {table.standard}, {word(table.language, 'language.name')}"


def anchor(title: str) -> str:
    """Give the anchor that readers of Markdown make of a heading: small letters, hyphens, no other signs."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")
