"""A study whose linkage, statics and comparisons are at hand already: nothing of them is made twice."""

from __future__ import annotations

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
