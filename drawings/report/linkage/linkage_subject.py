"""A linkage in a few words: formula of structure, output, stroke and time ratio (механизм в двух словах)."""

from __future__ import annotations

import re

import numpy as np

from drawings.lettering.words import number
from drawings.report.table import Subject
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import frame_slide
from plans.model.group import Group
from plans.model.structure import formula, mechanism_class
from plans.study import Study

PAIRS = {"R": "turning", "P": "sliding"}


def subject(study: Study) -> Subject:
    """Tell the structure of a linkage and how far its output goes."""
    linkage = study["linkage"]
    return Subject(_formula(linkage), _travel(linkage), _sentence(linkage))


def _formula(study: LinkageStudy) -> str:
    return re.sub(r"II(\d)", r"II<sub>\1</sub>", formula(study.mechanism, study.groups).replace("->", "→"))


def _sentence(study: LinkageStudy) -> str:
    """Say the formula of structure in words: the crank, then each group with its kind and the order of its pairs."""
    groups = "; ".join(_group(group) for group in study.groups)
    return (
        f"Structure: {_formula(study)}, class {mechanism_class(study.groups)}: crank {study.mechanism.drive.link}; "
        f"{groups}. Output: {_travel(study)}."
    )


def _group(group: Group) -> str:
    pairs = ", ".join(PAIRS[letter] for letter in group.kind)
    return f"links {' and '.join(map(str, group.links))}, {group.kind} ({pairs})"


def _travel(study: LinkageStudy) -> str:
    """Say how far the output goes and with what time ratio, or that it has no extreme positions."""
    output, found = study.output, study.travel
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
