"""plandraft draw: the sheets of a scene, the comparison, and the report beside them."""

from __future__ import annotations

import argparse
import os.path
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, takewhile
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from drawings.commands.stderr import noted, tell
from drawings.commands.trace import TracedMark
from drawings.files.atomic_files import staged
from drawings.files.sheet_set import (
    manifest_name,
    manifest_of,
    output_folder,
    placed_sheets,
    publish,
    read_manifest,
    sheet_path,
    stem_of,
)
from drawings.lettering.lettering import lettered
from drawings.report.report import headlines, lines, remarks, summary, text_of
from drawings.sheets.documents import of_scales, of_title
from drawings.sheets.kind import sheet_kind
from plans.scene.forms import resting
from plans.scene.scene import Scene, read_scene
from plans.study import Study
from plans.techniques import makers_of
from plans.words.words import Message, message, placed

if TYPE_CHECKING:
    from drawings.checks.expected import Expected, Wrong
    from drawings.paper.strokes import Key, Leaf
    from drawings.reading.sheet import SeenSheet

GAPS, WITHHELD = 4, 5
SHEETS_MOST = 1000  # of one scene; looked for until one is missing


class SheetSet(NamedTuple):
    """A scene that was drawn: its study, its sheets by kind as they were laid out, and the files written.

    What is right and badly drawn is `told`; what was withheld, and why, is in `withheld`.
    """

    study: Study
    leaves: Mapping[str, Sequence[Leaf]]
    paths: tuple[Path, ...]
    told: tuple[Message, ...] = ()
    withheld: tuple[Message, ...] = ()

    @property
    def sheets(self) -> tuple[Leaf, ...]:
        """All sheets, in the order of their files."""
        return tuple(leaf for leaves in self.leaves.values() for leaf in leaves)


def run(options: argparse.Namespace) -> int:
    """Draw a scene's sheets into a folder; give the exit code."""
    trace: TracedMark = options.trace or TracedMark()
    sheets = drawn(options.scene, options.output, trace)
    study = sheets.study
    print(summary(study.comparisons, study.scene.sheet.language))
    for line in (*headlines(study), *sheets.paths):
        print(line)
    stem, found = stem_of(sheets.study.scene), []
    for kind, leaves in sheets.leaves.items():
        further = (sheet_path(options.output, stem, kind, k) for k in range(len(leaves), SHEETS_MOST))
        found += list(takewhile(os.path.lexists, further))
    for path in found:
        _say(study.scene, placed(path, message("file.earlier")))
    if options.trace:
        tell(trace.stated(study))
    warnings = (*remarks(study), *sheets.told)
    for line in (*warnings, *sheets.withheld):
        _say(study.scene, line)
    return WITHHELD if sheets.withheld else GAPS if warnings else 0


def draw(path: Path, folder: Path, trace: TracedMark | None = None) -> SheetSet:
    """Draw a scene's sheets and report into a folder; one that is withheld is raised once the others are written."""
    sheets = drawn(path, folder, trace or TracedMark())
    if sheets.withheld:
        from drawings.checks.verify import SelfCheckFailed

        raise SelfCheckFailed(sheets.withheld[0])
    return sheets


def drawn(path: Path, folder: Path, trace: TracedMark) -> SheetSet:
    """Draw a scene's sheets and report into a folder, but for those that are withheld."""
    with trace.stage("reading the scene"):
        study = Study(read_scene(path))
        noted(study)
        admit(study.scene)
    with output_folder(folder) as left:
        for fault in chain(left.faults(folder), _strangers(study.scene, folder)):
            _say(study.scene, fault)
        return _of_study(study, folder, trace)


def _of_study(study: Study, folder: Path, trace: TracedMark) -> SheetSet:
    """Draw the sheets whose techniques find the same by both roads; where they do not for any, raise what differs."""
    from drawings.checks.verify import disagreement

    with trace.stage("construction"):
        study.construct()
    with trace.stage("analysis"):
        apart = {name: failed for name in study.techniques if (failed := disagreement(study.comparison(name)))}
    kinds = [kind for kind in study.scene.sheets if apart.keys().isdisjoint(resting(makers_of(kind)))]
    if not apart:
        return _sheets(study, folder, trace)
    if not kinds:
        raise next(iter(apart.values()))
    right = _of_study(Study(study.scene.changed(sheets=tuple(kinds))), folder, trace)
    lost = tuple(kind for kind in study.scene.sheets if kind not in kinds)
    return right._replace(withheld=(*(_withheld(lost, failed.args[0]) for failed in apart.values()), *right.withheld))


def _withheld(names: tuple[str, ...], why: object) -> Message:
    return message("check.withheld", names=names, why=why)


def admit(scene: Scene) -> None:
    """Refuse what no sheet can show, before any work."""
    of_title(scene)
    of_scales(scene)
    for kind in scene.sheets:
        sheet_kind(kind).admit(scene)


def _sheets(study: Study, folder: Path, trace: TracedMark) -> SheetSet:
    """Lay out, write beside, measure back, and only then give the sheets their names: those that are right."""
    with trace.stage("imports"):
        from drawings.checks.hold import phrase_faults
        from drawings.checks.verify import SelfCheckFailed, cramped, enclosure_wrongs, first, obscured
        from drawings.pens.svg import svg
        from drawings.sheets.documents import cuts, leaves_of

    scene, stem, language = study.scene, stem_of(study.scene), study.scene.sheet.language
    with trace.stage("layout"):
        leaves = leaves_of(study)
        for fault in cuts(leaves, scene):
            tell(fault.worded(language))
    with trace.stage("writing"):
        sheets = dict(placed_sheets(folder, stem, leaves))
        contents = {path: svg(lettered(leaf, scene.sheet.lettering)) for path, (_, leaf) in sheets.items()}
        told_lines, report = lines(study, leaves), folder / f"{stem}-report.md"
        contents[report] = text_of(told_lines).encode("utf-8")
        enclosed = (sheet_kind(kind).enclosures(study) for kind in scene.sheets)
        enclosures = {folder / f"{stem}-{enclosure.name}": enclosure for enclosure in chain(*enclosed)}
        contents |= {path: enclosure.content for path, enclosure in enclosures.items()}
    with staged(contents) as beside:
        with trace.stage("measuring"):
            read, wrong, expected = _held(study, sheets, beside)
            wrong[report] = [*phrase_faults(told_lines, expected)]
            wrong |= {path: enclosure_wrongs(beside[path], enclosure) for path, enclosure in enclosures.items()}
            faults = tuple(fault for sheet in read.values() for fault in obscured(sheet))
            faults += tuple(cramped(name) for _, leaf in sheets.values() for name in leaf.cramped)
        withheld = {path: said for path, said in wrong.items() if said}
        right = {path: content for path, content in contents.items() if path not in withheld}
        if sheets.keys() <= withheld.keys():
            why = message("check.sheet", marks=first(chain(*withheld.values())))
            raise SelfCheckFailed(_withheld(tuple(path.name for path in withheld), why))
        manifest = manifest_of(scene.file, scene.content, right, (path.name for path in withheld))
        for path in publish(folder, manifest, {path: beside[path] for path in right}):
            _say(scene, placed(path, message("file.surplus")))
    lost = tuple(_withheld((path.name,), message("check.sheet", marks=first(why))) for path, why in withheld.items())
    return SheetSet(study, leaves, tuple(right), faults, lost)


def _held(
    study: Study, sheets: Mapping[Path, tuple[str, Leaf]], beside: Mapping[Path, Path]
) -> tuple[dict[Path, SeenSheet], dict[Path, list[Wrong]], dict[Key, Expected]]:
    """See the written sheets, and list what is wrong with each; give what had to stand on them."""
    from drawings.checks import verify
    from drawings.checks.expected import subject
    from drawings.paper.limits import SheetRefused

    held = {path: verify.written(beside[path], leaf) for path, (_, leaf) in sheets.items()}
    wrong: dict[Path, list[Wrong]] = {}
    rows: dict[Key, Expected] = {}
    groups: dict[tuple[str, str], dict[Path, verify.WrittenSheet]] = {}
    for path, sheet in held.items():
        groups.setdefault((sheets[path][0], subject(sheet.leaf)), {})[path] = sheet
    for (kind, _), group in groups.items():
        expected = {row.key: row for row in sheet_kind(kind).expected(study, [sheet.leaf for sheet in group.values()])}
        wrong |= zip(group, verify.wrongs([*group.values()], expected, study.scene.sheet), strict=True)
        rows |= expected
    for path, sheet in held.items():
        wrong[path] += verify.scale_wrongs(sheet, sheet_kind(sheets[path][0]).scales, study.scene.sheet)
    return {path: sheet.seen for path, sheet in held.items() if not isinstance(sheet.seen, SheetRefused)}, wrong, rows


def _strangers(scene: Scene, folder: Path) -> Iterator[Message]:
    """Tell what the last run of a scene has written otherwise than it now is."""
    last = read_manifest(folder / manifest_name(stem_of(scene)))
    for name in last.strangers(folder) if last is not None else ():
        yield placed(folder / name, message("file.changed"))


def _say(scene: Scene, saying: Message) -> None:
    tell(saying.worded(scene.sheet.language))
