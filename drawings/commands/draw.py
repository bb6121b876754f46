"""plandraft draw: the sheets of a scene, the comparison, and the report beside them."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from drawings.lettering import demand, lettered
from drawings.report import report, shallow, summary
from drawings.strokes import Run, Text
from drawings.trace import Trace
from geometry.errors import LimitError
from plans.compare import Comparison, compare, compare_extremes
from plans.scene import Scene, read_scene
from plans.study import Study

GAPS = 4
POSITIONS_DRAWN = 360  # more positions than degrees cannot be told apart on any sheet


def run(options: argparse.Namespace) -> int:
    """Draw a scene's sheets into a folder; give the exit code."""
    trace: Trace = options.trace or Trace()
    with trace.stage("reading the scene"):
        scene = read_scene(options.scene)
        demand(Text(0j, (Run(text),)) for text in _own_words(scene))
    study = Study(scene)
    with trace.stage("construction"):
        _construct(study)
    with trace.stage("analysis"):
        comparison = compare_extremes(study, compare(study))
        _agree(comparison)
    written = _sheet(study, comparison, options.output, trace)
    print(summary(comparison))
    for path in written:
        print(path)
    if options.trace:
        print(trace.told(study.made), file=sys.stderr)
    return _verdict(study, comparison)


def _construct(study: Study) -> None:
    """Make all plans that the sheet needs."""
    if len(study.turn) > POSITIONS_DRAWN:
        raise LimitError(
            f"{study.scene.file}: drive.positions = {len(study.turn)}: a sheet shows at most {POSITIONS_DRAWN}. "
            "Fix: fewer positions, or plandraft solve for the numbers alone"
        )
    _ = study.found, study.drafts().accelerations  # each is made when it is asked for


def _own_words(scene: Scene) -> Iterator[str]:
    """Give what the scene's author wrote and the sheet shows: a letter that it cannot show is told before any work."""
    sheet, mechanism = scene.sheet, scene.mechanism
    yield from (scene.title, sheet.designation, sheet.drawn, sheet.checked, sheet.approved, sheet.date)
    yield from (sheet.group, sheet.organisation, *mechanism.frame, *mechanism.points)
    yield from (point for letters in mechanism.links.values() for point in letters)


def _agree(comparison: Comparison) -> None:
    from drawings.verify import SelfCheckFailed

    if not comparison.agrees:
        worst = max(comparison.findings, key=lambda finding: float(finding.excess.max()))
        raise SelfCheckFailed(
            f"construction and analysis differ in {worst.name}: {float(worst.excess.max()):.3g} times the allowed "
            "difference; the sheet is withheld"
        )


def _sheet(study: Study, comparison: Comparison, folder: Path, trace: Trace) -> list[Path]:
    """Lay out, write beside, measure back, and only then give the sheet its name."""
    with trace.stage("imports"):
        from drawings import press
        from drawings.pens.svg import svg
        from drawings.sheets import kinematics
        from drawings.verify import verify

    with trace.stage("layout"):
        leaf = kinematics.sheet(study, comparison)
    stem = Path(os.fspath(study.scene.file)).stem
    path, beside = folder / f"{stem}-kinematics.svg", folder / f"{stem}-report.md"
    with trace.stage("writing"):
        content = svg(lettered(leaf, study.scene.sheet.lettering))
        text = report(study, comparison, tuple(leaf.metadata["plans"]), leaf.metadata["shown"])
        press.prepare(folder)
    with (
        press.fresh(beside, text.encode("utf-8")),
        press.fresh(path, content) as temporary,
        trace.stage("measuring"),
    ):
        verify(temporary, leaf, study, comparison)
    return [path, beside]


def _verdict(study: Study, comparison: Comparison) -> int:
    gaps = comparison.construction.gaps
    for gap in gaps:
        print(f"position {gap.position}: {gap.plan}: {gap.reason} at {gap.where}: {gap.advice}", file=sys.stderr)
    for barrier in study.met if not gaps else ():
        print(f"{barrier.kind} at {barrier.where} between two positions: see the report", file=sys.stderr)
    near = shallow(study)
    for k in near:
        print(f"position {k}: too near a dead centre to be graded: see Conditions in the report", file=sys.stderr)
    return GAPS if gaps or near or study.met else 0
