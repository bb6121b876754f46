"""The index of the gallery in Markdown: every mechanism with its structure, what is special, sheets, scene, report."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from drawings.gallery.catalogue import Entry
from drawings.lettering.words import number
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import frame_slide
from plans.model.structure import Dyad, formula, mechanism_class

PAGE = "README.md"

OPENING = """\
# Gallery

Mechanisms of the courses, each a scene to start from, drawn and compared with the analysis. A picture opens its sheet;
the report beside it holds every position's values by both roads.

```console
plandraft new shaper              # puts shaper.toml into this folder, to be changed; without a name: the list
plandraft draw shaper.toml -o out/
python -m drawings.gallery        # redraws every sheet, every report, the alphabet and this page
```

| mechanism | scene | structure | output | sheet |
|---|---|---|---|---|
"""

CLOSING = """
The [alphabet](alphabet.svg) in which the sheets are lettered is drawn by the same command.
"""

PAIRS = {"R": "turning", "P": "sliding"}
LANGUAGES = {"en": "English", "ru": "Russian"}


class Exhibit(NamedTuple):
    """A scene of the gallery with its study, and the files that were written for it."""

    entry: Entry
    study: LinkageStudy
    paths: tuple[Path, ...]


def index(exhibits: Sequence[Exhibit]) -> str:
    """Write the index page."""
    rows = "".join(map(row, exhibits))
    return OPENING + rows + "".join(map(section, exhibits)) + CLOSING


def row(exhibit: Exhibit) -> str:
    """Write a mechanism's row of the table."""
    entry, study = exhibit.entry, exhibit.study
    link = f"[{entry.title}](#{_anchor(entry.title)})"
    return f"| {link} | `{entry.name}` | {_formula(study)} | {_travel(study)} | {_sheet(study)} |\n"


def section(exhibit: Exhibit) -> str:
    """Write a mechanism's section: its words, structure, sheets, and where to go on."""
    entry, study = exhibit.entry, exhibit.study
    sheets = [path.name for path in exhibit.paths if path.suffix == ".svg"]
    pictures = "\n\n".join(f"[![{entry.title}: {name}]({name})]({name})" for name in sheets)
    others = [f"[{path.name}]({path.name})" for path in exhibit.paths if path.suffix != ".svg"]
    links = " · ".join([f"[{entry.name}.toml]({entry.name}.toml)", *others, f"`plandraft new {entry.name}`"])
    return f"\n## {entry.title}\n\n{entry.about}\n\n{_structure(study)}\n\n{pictures}\n\n{links}\n"


def _formula(study: LinkageStudy) -> str:
    return re.sub(r"II(\d)", r"II<sub>\1</sub>", formula(study.mechanism, study.groups).replace("->", "→"))


def _structure(study: LinkageStudy) -> str:
    """Say the formula of structure in words: the crank, then each group with its kind and the order of its pairs."""
    groups = "; ".join(_group(group) for group in study.groups)
    return (
        f"Structure: {_formula(study)}, class {mechanism_class(study.groups)}: crank {study.mechanism.drive.link}; "
        f"{groups}. Output: {_travel(study)}."
    )


def _group(group: Dyad) -> str:
    pairs = ", ".join(PAIRS[letter] for letter in group.kind)
    return f"links {group.links[0]} and {group.links[1]}, {group.kind} ({pairs})"


def _travel(study: LinkageStudy) -> str:
    """Say how far the output goes and with what time ratio, or that it has no extreme positions."""
    output, found = study.output, study.found
    if output.point and frame_slide(study.mechanism, output.link) is None:
        return f"point {output.point} of link {output.link}"
    if found is None:
        return f"link {output.link}, within the angles given"
    extremes = found.extremes
    far = f"stroke {number(1000 * extremes.stroke)} mm"
    if not extremes.sliding:
        far = f"swing {number(float(np.degrees(extremes.stroke)))}°"
    ratio = f"K = {number(extremes.ratio)}" if len(found.rests) == 2 else f"reverses {len(found.rests)} times"
    return f"link {output.link}, {far}, {ratio}"


def _sheet(study: LinkageStudy) -> str:
    table = study.scene.sheet
    return f"{table.format}, {table.standard}, {LANGUAGES[table.language]}"


def _anchor(title: str) -> str:
    """Give the anchor that readers of Markdown make of a heading: small letters, hyphens, no other signs."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")
