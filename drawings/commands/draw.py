"""plandraft draw: the sheets of a scene, the comparison, and the report beside them."""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator
from itertools import chain, takewhile
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from drawings.commands.process import tell
from drawings.commands.talk import noted, verdict
from drawings.commands.trace import Trace
from drawings.files.atomic_files import staged
from drawings.files.manifest import manifest_name, manifest_of, read_manifest
from drawings.files.sheet_set import output_folder, publish
from drawings.lettering.lettering import UnknownLetter, demand, lettered
from drawings.lettering.words import runs
from drawings.paper.strokes import Run, SheetError, Text
from drawings.report.report import report, shallow, shown, summary
from geometry.errors import LimitError
from plans.checks.compare import Comparison, compare, compare_extremes
from plans.linkage.study import LinkageStudy
from plans.model.order import POSITIONS
from plans.scene.scene import Scene, read_scene
from plans.scene.wording import said

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf
    from plans.forces.statics import Statics

GAPS = 4
POSITIONS_DRAWN = 360  # more positions than degrees cannot be told apart on any sheet
SHEETS_MOST = 1000  # of one scene; looked for until one is missing


class Drawn(NamedTuple):
    """A scene that was drawn: its study and comparison, its sheets as they were laid out, and the files written."""

    study: LinkageStudy
    comparison: Comparison
    statics: Statics | None  # where a force sheet asks for them
    leaves: tuple[Leaf, ...]
    paths: tuple[Path, ...]


def run(options: argparse.Namespace) -> int:
    """Draw a scene's sheets into a folder; give the exit code."""
    trace: Trace = options.trace or Trace()
    drawn = draw(options.scene, options.output, trace)
    print(summary(drawn.comparison))
    print(shown(drawn.study))
    for path in drawn.paths:
        print(path)
    for path in _earlier(drawn, options.output):
        _say(drawn.study.scene, f"{path}: left by an earlier run with more sheets; it belongs to none of these")
    if options.trace:
        tell(trace.told(drawn.study.made))
    return max(_verdict(drawn.study, drawn.comparison), _jams(drawn))


def draw(path: Path, folder: Path, trace: Trace | None = None) -> Drawn:
    """Draw a scene's sheets and report into a folder; nothing is written where the two roads disagree."""
    trace = trace or Trace()
    with trace.stage("reading the scene"):
        scene = noted(read_scene(path))
        _demand(scene)
    with output_folder(folder) as left:
        for told in chain(left.told(folder), _strangers(scene, folder)):
            _say(scene, told)
        return _drawn(LinkageStudy(scene), folder, trace)


def _drawn(study: LinkageStudy, folder: Path, trace: Trace) -> Drawn:
    with trace.stage("construction"):
        _construct(study)
        statics = _statics(study)
    with trace.stage("analysis"):
        comparison = _compared(study, statics)
        _agree(comparison)
    return _sheets(study, comparison, statics, folder, trace)


def _statics(study: LinkageStudy) -> Statics | None:
    """Give the statics of a study, whose forces are made; None where no sheet asks for them."""
    if "forces" not in study.scene.sheets:
        return None
    from plans.forces.statics import Statics

    statics = Statics(study)
    _ = statics.forces
    return statics


def _compared(study: LinkageStudy, statics: Statics | None) -> Comparison:
    comparison = compare_extremes(study, compare(study))
    if statics is None:
        return comparison
    from plans.checks.force_comparison import compare_forces

    return compare_forces(statics, comparison)


def _construct(study: LinkageStudy) -> None:
    """Make all plans that the sheet needs."""
    if len(study.turn) > POSITIONS_DRAWN:
        raise LimitError(
            f"{study.scene.file}: drive.positions = {len(study.turn)}: a sheet shows at most {POSITIONS_DRAWN}. "
            "Fix: fewer positions, or plandraft solve for the numbers alone"
        )
    _ = study.found, study.drafts().accelerations  # each is made when it is asked for


def _demand(scene: Scene) -> None:
    """Refuse what the scene's author wrote in letters that the sheet cannot show, before any work, at its line."""
    for path, text in _own_words(scene):
        try:
            demand([Text(0j, (Run(text),))])
        except UnknownLetter as unknown:
            line, column = scene.place(path)
            where = f"{scene.file}:{line}:{column}: {'.'.join(map(str, path))}"
            raise SheetError(f"{where}: {unknown}") from None


def _own_words(scene: Scene) -> Iterator[tuple[tuple[str | int, ...], str]]:
    """Give what the scene's author wrote and the sheet shows, with its key."""
    sheet, mechanism = scene.sheet, scene.mechanism
    yield ("title",), scene.title
    for key in ("designation", "drawn", "checked", "approved", "date", "group", "organisation"):
        yield ("sheet", key), getattr(sheet, key)
    for table in ("frame", "points"):
        yield from ((("mechanism", table, name), name) for name in getattr(mechanism, table))
    for kind in ("forces", "moments", "springs") if scene.loads else ():
        loads = enumerate(getattr(scene.loads, kind))
        yield from ((("loads", kind, k, "name"), load.name) for k, load in loads if load.name)
    for link, letters in mechanism.links.items():
        yield from ((("mechanism", "links", str(link)), point) for point in letters)


def _agree(comparison: Comparison) -> None:
    from drawings.checks.verify import SelfCheckFailed

    for road, gap in comparison.alone[:1]:
        said_of = f"position {gap.position} ({gap.plan}: {gap.reason})"
        raise SelfCheckFailed(
            f"construction gives up {said_of} and analysis does not; the sheet is withheld"
            if road.by == "construction"
            else f"analysis gives up {said_of} and construction does not; the sheet is withheld"
        )
    if not comparison.agrees:
        worst = max(comparison.findings, key=lambda finding: float(finding.excess.max()))
        if worst.plan == POSITIONS.plan:
            raise SelfCheckFailed(
                f"construction and analysis assemble the mechanism in two ways (they differ in {worst.name}); "
                "the sheet is withheld. Fix: show more points in mechanism.sketch, nearer to where they are at the "
                "first position"
            )
        raise SelfCheckFailed(
            f"construction and analysis differ in {worst.name}: {float(worst.excess.max()):.3g} times the allowed "
            "difference; the sheet is withheld"
        )


def _sheets(study: LinkageStudy, comparison: Comparison, statics: Statics | None, folder: Path, trace: Trace) -> Drawn:
    """Lay out, write beside, measure back, and only then give the sheets their names: all of them or none."""
    with trace.stage("imports"):
        from drawings.checks.verify import check_report, verify
        from drawings.pens.svg import svg

    scene = study.scene
    with trace.stage("layout"):
        leaves = {kind: _leaves(kind, study, comparison, statics) for kind in scene.sheets}
    stem, sheets = _stem(scene), [leaf for kind in leaves.values() for leaf in kind]
    paths = [_named(folder, stem, kind, k) for kind, own in leaves.items() for k in range(len(own))]
    with trace.stage("writing"):
        contents = {path: svg(lettered(leaf, scene.sheet.lettering)) for path, leaf in zip(paths, sheets, strict=True)}
        text = report(study, comparison, leaves, statics)
        contents[folder / f"{stem}-report.md"] = text.encode("utf-8")
    manifest = manifest_of(scene.file, scene.content, contents)
    with staged(contents) as written:
        with trace.stage("measuring"):
            if comparison.friction is not None:
                check_report(text, comparison)
            for path, leaf in zip(paths, sheets, strict=True):
                verify(written[path], leaf, study, comparison, statics)
        for path in publish(folder, manifest, written):
            _say(scene, f"{path}: of an earlier run with more sheets; removed")
    return Drawn(study, comparison, statics, tuple(sheets), tuple(contents))


def _strangers(scene: Scene, folder: Path) -> Iterator[str]:
    """Tell what the last run of a scene has written otherwise than it now is."""
    last = read_manifest(folder / manifest_name(_stem(scene)))
    for name in last.strangers(folder) if last is not None else ():
        yield f"{folder / name}: not as it was drawn: changed since, or its run was stopped; the set is drawn anew"


def _leaves(kind: str, study: LinkageStudy, comparison: Comparison, statics: Statics | None) -> tuple[Leaf, ...]:
    """Lay out the sheets of a kind."""
    if statics is not None and kind == "forces":
        from drawings.sheets import forces

        return forces.sheets(study, comparison, statics)
    from drawings.sheets import kinematics

    return kinematics.sheets(study, comparison)


def _named(folder: Path, stem: str, kind: str, number: int) -> Path:
    return folder / (f"{stem}-{kind}-{number + 1}.svg" if number else f"{stem}-{kind}.svg")


def _stem(scene: Scene) -> str:
    return Path(os.fspath(scene.file)).stem


def _say(scene: Scene, message: str) -> None:
    tell(said(message, scene.sheet.language))


def _earlier(drawn: Drawn, folder: Path) -> list[Path]:
    """Give following sheets that an earlier run left beside fewer new ones."""
    stem, found = _stem(drawn.study.scene), []
    for kind in drawn.study.scene.sheets:
        count = sum(leaf.metadata["sheet"] == kind for leaf in drawn.leaves)
        further = (_named(folder, stem, kind, k) for k in range(count, SHEETS_MOST))
        found += list(takewhile(os.path.lexists, further))
    return found


def _jams(drawn: Drawn) -> int:
    """Say which pairs jam by friction, and where."""
    found = drawn.statics.friction if drawn.statics is not None else None
    if found is None:
        return 0
    for pair in dict.fromkeys(jam.pair for jam in found.jams):
        own = [jam for jam in found.jams if jam.pair == pair]
        where = runs([jam.position for jam in own], "-")
        told = f"pair {pair} jams by friction in positions {where}: {own[0].advice}"
        _say(drawn.study.scene, told)
    return GAPS if found.jams else 0


def _verdict(study: LinkageStudy, comparison: Comparison) -> int:
    gaps, near = comparison.construction.gaps, shallow(study)
    if comparison.forces is not None:
        gaps = comparison.forces[0].gaps
    for line in verdict(gaps, study.met, near, study.scene.sheet.language):
        tell(line)
    return GAPS if gaps or near or study.met else 0
