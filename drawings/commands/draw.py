"""plandraft draw: the sheets of a scene, the comparison, and the report beside them."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from drawings.report import report, shallow, summary
from geometry.errors import LimitError
from plans.compare import Comparison, compare, compare_extremes
from plans.scene import read_scene
from plans.study import Study

if TYPE_CHECKING:
    from drawings.strokes import Leaf

GAPS = 4
POSITIONS_DRAWN = 360  # more positions than degrees cannot be told apart on any sheet


class Drawn(NamedTuple):
    """A scene that was drawn: its study and comparison, its sheets as they were laid out, and the files written."""

    study: Study
    comparison: Comparison
    leaves: tuple[Leaf, ...]
    paths: tuple[Path, ...]


def run(options: argparse.Namespace) -> int:
    """Draw a scene's sheets into a folder; give the exit code."""
    drawn = draw(options.scene, options.output)
    print(summary(drawn.comparison))
    for path in drawn.paths:
        print(path)
    return _verdict(drawn.study, drawn.comparison)


def draw(scene: Path, folder: Path) -> Drawn:
    """Draw a scene's sheets and report into a folder; nothing is written where the two roads disagree."""
    study = Study(read_scene(scene))
    if len(study.turn) > POSITIONS_DRAWN:
        raise LimitError(
            f"{study.scene.file}: drive.positions = {len(study.turn)}: a sheet shows at most {POSITIONS_DRAWN}. "
            "Fix: fewer positions, or plandraft solve for the numbers alone"
        )
    comparison = compare_extremes(study, compare(study))
    _agree(comparison)
    return _sheet(study, comparison, folder)


def _agree(comparison: Comparison) -> None:
    from drawings.verify import SelfCheckFailed

    if not comparison.agrees:
        worst = max(comparison.findings, key=lambda finding: float(finding.excess.max()))
        raise SelfCheckFailed(
            f"construction and analysis differ in {worst.name}: {float(worst.excess.max()):.3g} times the allowed "
            "difference; the sheet is withheld"
        )


def _sheet(study: Study, comparison: Comparison, folder: Path) -> Drawn:
    """Lay out, write beside, measure back, and only then give the sheet its name."""
    from drawings import press
    from drawings.lettering import lettered
    from drawings.pens.svg import svg
    from drawings.sheets import kinematics
    from drawings.verify import verify

    leaf = kinematics.sheet(study, comparison)
    content = svg(lettered(leaf))
    press.prepare(folder)
    stem = Path(os.fspath(study.scene.file)).stem
    path, beside = folder / f"{stem}-kinematics.svg", folder / f"{stem}-report.md"
    text = report(study, comparison, tuple(leaf.metadata["plans"]), leaf.metadata["shown"])
    with press.fresh(beside, text.encode("utf-8")), press.fresh(path, content) as temporary:
        verify(temporary, leaf, study, comparison)
    return Drawn(study, comparison, (leaf,), (path, beside))


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
