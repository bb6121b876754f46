"""plandraft draw: the sheets of a scene, the comparison, and the report beside them."""

from __future__ import annotations

import argparse
import os.path
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import chain, takewhile
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from drawings.commands.stderr import tell
from drawings.commands.talk import noted
from drawings.commands.trace import Trace
from drawings.files.atomic_files import staged
from drawings.files.manifest import manifest_name, manifest_of, read_manifest
from drawings.files.sheet_set import output_folder, publish
from drawings.lettering.lettering import lettered
from drawings.original.sheet_paths import placed_sheets, sheet_path, stem_of
from drawings.report.report import faults, headlines, remarks, report, summary
from drawings.sheets.admission import of_scales, of_title
from drawings.sheets.table import SHEETS
from plans.scene.scene import Scene, read_scene
from plans.study import Study
from plans.techniques import named
from plans.words.words import Message, message, placed

if TYPE_CHECKING:
    from drawings.checks.wrong import Wrong
    from drawings.eye.sheet import SeenSheet
    from drawings.files.enclosure import Enclosure
    from drawings.paper.strokes import Leaf

GAPS = 4
SHEETS_MOST = 1000  # of one scene; looked for until one is missing


class SheetSet(NamedTuple):
    """A scene that was drawn: its study, its sheets by kind as they were laid out, and the files written."""

    study: Study
    leaves: Mapping[str, Sequence[Leaf]]
    paths: tuple[Path, ...]

    @property
    def sheets(self) -> tuple[Leaf, ...]:
        """All sheets, in the order of their files."""
        return tuple(leaf for own in self.leaves.values() for leaf in own)


def run(options: argparse.Namespace) -> int:
    """Draw a scene's sheets into a folder; give the exit code."""
    trace: Trace = options.trace or Trace()
    sheets = draw(options.scene, options.output, trace)
    study = sheets.study
    print(summary(study.comparisons, study.scene.sheet.language))
    for line in (*headlines(study), *sheets.paths):
        print(line)
    for path in _earlier(sheets, options.output):
        _say(study.scene, placed(path, message("file.earlier")))
    if options.trace:
        tell(trace.told(study))
    warnings = remarks(study)
    for line in warnings:
        _say(study.scene, line)
    return GAPS if warnings else 0


def draw(path: Path, folder: Path, trace: Trace | None = None) -> SheetSet:
    """Draw a scene's sheets and report into a folder; nothing is written where the two roads disagree."""
    trace = trace or Trace()
    with trace.stage("reading the scene"):
        study = Study(read_scene(path))
        noted(study)
        admit(study.scene)
    with output_folder(folder) as left:
        for told in chain(left.told(folder), _strangers(study.scene, folder)):
            _say(study.scene, told)
        return _of_study(study, folder, trace)


def _of_study(study: Study, folder: Path, trace: Trace) -> SheetSet:
    from drawings.checks.agreement import agree

    with trace.stage("construction"):
        study.construct()
    with trace.stage("analysis"):
        for comparison in study.comparisons:
            agree(comparison)
    return _sheets(study, folder, trace)


def admit(scene: Scene) -> None:
    """Refuse what no sheet can show, before any work."""
    of_title(scene)
    of_scales(scene)
    for kind in scene.sheets:
        named(SHEETS[kind].admit)(scene)


def _sheets(study: Study, folder: Path, trace: Trace) -> SheetSet:
    """Lay out, write beside, measure back, and only then give the sheets their names: all of them or none."""
    with trace.stage("imports"):
        from drawings.checks import verify as checks
        from drawings.checks.documents import compared
        from drawings.checks.documents import headlines as said_first
        from drawings.original.edition import leaves_of
        from drawings.pens.svg import svg
        from drawings.sheets.documents import cuts

    scene, stem, language = study.scene, stem_of(study.scene), study.scene.sheet.language
    with trace.stage("layout"):
        leaves = leaves_of(study)
        for fault in cuts(leaves, scene):
            tell(fault.worded(language))
    with trace.stage("writing"):
        sheets = dict(placed_sheets(folder, stem, leaves))
        text = report(study, leaves)
        contents = {path: svg(lettered(leaf, scene.sheet.lettering)) for path, (_, leaf) in sheets.items()}
        contents[folder / f"{stem}-report.md"] = text.encode("utf-8")
        enclosures = {folder / f"{stem}-{one.name}": one for one in _enclosures(study)}
        contents |= {path: one.content for path, one in enclosures.items()}
    manifest = manifest_of(scene.file, scene.content, contents)
    with staged(contents) as written:
        with trace.stage("measuring"):
            told = compared.faults(text, study.comparisons, language)
            first = said_first.faults(headlines(study), study)
            short = compared.screen_faults(summary(study.comparisons, language), study.comparisons, language)
            checks.verify_report((*faults(text, study, leaves), *told, *first, *short))
            seen: dict[str, list[SeenSheet]] = {kind: [] for kind in leaves}
            for path, (kind, leaf) in sheets.items():
                held = partial(named(SHEETS[kind].faults), study=study)
                seen[kind].append(checks.verify(written[path], leaf, held))
            checks.verify_documents({kind: [one.leaf for one in own] for kind, own in seen.items()}, scene.sheet)
            marked = [(SHEETS[kind].scales, one.measured) for kind, own in seen.items() for one in own]
            checks.verify_scales(marked, scene.sheet)
            checks.verify_set(_of_sets(study, seen))
            for path, enclosure in enclosures.items():
                checks.verify_enclosure(written[path], enclosure)
        for path in publish(folder, manifest, written):
            _say(scene, placed(path, message("file.surplus")))
    return SheetSet(study, leaves, tuple(contents))


def _of_sets(study: Study, seen: Mapping[str, Sequence[SeenSheet]]) -> Iterator[Wrong]:
    """Give what is wrong with all sheets of a kind as a set."""
    for kind in study.scene.sheets:
        if SHEETS[kind].together:
            yield from named(SHEETS[kind].together)([(one.measured, one.leaf) for one in seen[kind]], study)


def _enclosures(study: Study) -> Iterator[Enclosure]:
    """Give the files that are written beside the sheets."""
    for kind in study.scene.sheets:
        if SHEETS[kind].enclosures:
            yield from named(SHEETS[kind].enclosures)(study)


def _strangers(scene: Scene, folder: Path) -> Iterator[Message]:
    """Tell what the last run of a scene has written otherwise than it now is."""
    last = read_manifest(folder / manifest_name(stem_of(scene)))
    for name in last.strangers(folder) if last is not None else ():
        yield placed(folder / name, message("file.changed"))


def _say(scene: Scene, saying: Message) -> None:
    tell(saying.worded(scene.sheet.language))


def _earlier(sheets: SheetSet, folder: Path) -> list[Path]:
    """Give following sheets that an earlier run left beside fewer new ones."""
    stem, found = stem_of(sheets.study.scene), []
    for kind, own in sheets.leaves.items():
        further = (sheet_path(folder, stem, kind, k) for k in range(len(own), SHEETS_MOST))
        found += list(takewhile(os.path.lexists, further))
    return found
