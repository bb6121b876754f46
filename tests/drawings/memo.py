"""A study whose linkage, statics and comparisons are at hand already: nothing of them is made twice."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from drawings.checks.expected import Expected
from drawings.checks.verify import SelfCheckFailed, measured_wrongs
from drawings.due import forces, linkage
from drawings.measure.measure import Measured, measure_file
from drawings.paper.strokes import Leaf
from plans.checks.compare import MotionComparison
from plans.checks.force_comparison import ForceComparison
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.study import Study


def memo(linkage: LinkageStudy, motion: MotionComparison) -> Study:
    study = Study(linkage.scene)
    study._made["linkage"], study._compared["linkage"] = linkage, motion
    return study


def loaded_memo(statics: Statics, comparison: ForceComparison) -> Study:
    study = memo(statics.study, comparison.motion)
    study._made["forces"], study._compared["forces"] = statics, comparison
    return study


def cams_of(study: Study, other: Study) -> Study:
    """Give a study the cams of another, whose scene differs in its sheet alone."""
    study._made["cam"], study._compared["cam"] = other["cam"], other.comparison("cam")
    return study


def held(path: Path, leaf: Leaf, study: Study, due: Callable[..., Iterable[Expected]]) -> Measured:
    """Hold a written sheet against what must stand on it, and give what was measured."""
    measured, rows = measure_file(path), {row.key: row for row in due(study, [leaf])}
    if wrong := list(measured_wrongs(measured, leaf, rows, rows)):
        raise SelfCheckFailed(str(wrong))
    return measured


def verify_motion(path: Path, leaf: Leaf, study: Study) -> Measured:
    return held(path, leaf, study, linkage.due)


def verify_loaded(path: Path, leaf: Leaf, statics: Statics, comparison: ForceComparison) -> Measured:
    return held(path, leaf, loaded_memo(statics, comparison), forces.due)
