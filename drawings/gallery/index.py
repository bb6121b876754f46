"""The index of the gallery in Markdown: every mechanism with its structure, what is special, sheets, scene, report."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from drawings.gallery.catalogue import Entry
from drawings.lettering.words import number
from drawings.report.report import TableSubject, report_of
from plans.bank.engines import ENGINES, Engine
from plans.bank.harmonics import SliderCrank
from plans.bank.study import BankStudy
from plans.model.balance.bank import BankBalance, BankTask, Harmonic, Member, Unit
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


def subject_of(study: Study) -> TableSubject:
    """Tell what is studied: the first technique of a scene says it."""
    return report_of(study.techniques[0]).subject(study)


def _sheet(study: Study) -> str:
    table = study.scene.sheet
    return f"{table.format}, {table.standard}, {word(table.language, 'language.name')}"


def anchor(title: str) -> str:
    """Give the anchor that readers of Markdown make of a heading: small letters, hyphens, no other signs."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")


UNIT, SPEED = Unit(0.04, 0.14, 0.0, 0.5), 300.0  # of every engine: what is told are ratios alone
ORDERS = (1, 2, 4, 6)
DIGITS = 4
ENGINES_OPENING = """
### The usual engines

What a [bank](../../README.md) of equal cylinders leaves of each order: forces as so many times the largest force of
that order of one cylinder, moments along the shaft as so many times that force by the pitch of the cylinders. What
turns with the crank alone (↻, of the first order) can be taken by counterweights on the crank. Angles are in degrees;
cylinders at one place along the shaft stand together.

| engine | cranks | guides | forces left, order: times | moments left, order: times |
|---|---|---|---|---|
"""


def engines() -> str:
    """Write the table of the usual engines."""
    return ENGINES_OPENING + "".join(map(engine_row, ENGINES))


def engine_row(engine: Engine) -> str:
    """Write the row of an engine: each order with what is left of it, or nothing."""
    balance = BankStudy(BankTask(UNIT, engine.members, SPEED, ORDERS), SliderCrank(UNIT, SPEED)).balance
    cells = word("en", f"engine.{engine.key}"), *_angles(engine), _left(balance, balance.forces)
    return f"| {' | '.join((*cells, _left(balance, balance.moments)))} |\n"


def _angles(engine: Engine) -> Iterator[str]:
    """Write the angles of the cranks and of the guides along the shaft, those at one place together."""
    places: dict[Fraction, list[Member]] = {}
    for member in engine.members:
        places.setdefault(member.place, []).append(member)
    yield ", ".join(_together(member.crank for member in place) for place in places.values())
    yield ", ".join(dict.fromkeys(_together(member.axis for member in place) for place in places.values()))


def _together(angles: Iterable[Fraction]) -> str:
    return " and ".join(dict.fromkeys(f"{float(angle):g}" for angle in angles)).replace("-", "−")


def _left(balance: BankBalance, found: Mapping[int, Harmonic]) -> str:
    """Write each order of which something is left, in what one cylinder has of it."""
    shares = [_share(harmonic, balance.single[order]) for order, harmonic in found.items() if not harmonic.vanishes]
    return "; ".join(shares) or "none"


def _share(harmonic: Harmonic, single: Harmonic) -> str:
    turns = " ↻" if harmonic.order == 1 and abs(harmonic.back) <= harmonic.slack else ""
    return f"{harmonic.order}: {number(harmonic.size / single.size, 'en', DIGITS)}{turns}"
