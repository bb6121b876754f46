"""What a kinematics sheet says in words: structure, drive, stroke, time ratio, pressure angles, gaps (пояснения)."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from drawings.layout.footing import Notes
from drawings.lettering.lettering import text_width
from drawings.lettering.words import fixed, number, runs, word
from drawings.page.page import Field
from drawings.paper.strokes import Group, Stroke, Text
from plans.checks.compare import MotionComparison
from plans.linkage.pressure import interval
from plans.linkage.study import LinkageStudy
from plans.model.structure import formula, mechanism_class
from plans.scene.wording import said as worded

TOGETHER = re.compile(r" (=|…|−|[+]) ")
MOST_LENGTHS = 16  # of a mechanism with more the report and the scene tell them
STEP = 1.8  # sizes of the letters from line to line: GOST 2.304-81 asks for 1.7 at least


def notes(study: LinkageStudy, comparison: MotionComparison, language: str) -> list[str]:
    """Write what the sheet says in words: structure, drive, stroke, time ratio, pressure angles, gaps, agreement."""
    mechanism, drive = study.mechanism, study.mechanism.drive
    said = [
        word(
            language, "structure", n=mechanism.moving_links, p=mechanism.lower_pairs, w=mechanism.mobility,
            formula=formula(mechanism, study.groups).replace("->", "→"), klass=mechanism_class(study.groups),
        ),
        word(
            language, "crank", link=drive.link, omega=number(drive.omega, language),
            epsilon=number(drive.epsilon, language),
        ),
    ]  # fmt: skip
    said += lengths(study, language)
    if study.found is not None:
        said.append(_travel(study, language))
    for group in study.groups:
        found = interval(study.sweep, group, study.nodes)
        low, high = (fixed(float(np.degrees(angle)), language) for angle in (found.low, found.high))
        if low != high:
            said.append(word(language, "pressure", group=group.label, low=low, high=high))
    return [*said, *_gaps(comparison, language), *_why(study, comparison)]


def lengths(study: LinkageStudy, language: str) -> list[str]:
    """Tell the lengths of the scene, where they are not too many."""
    given = study.scene.mechanism.lengths
    if not 0 < len(given) <= MOST_LENGTHS:
        return []
    told = (f"l_{{{name}}} = {number(1000 * float(length), language)}" for name, length in given.items())
    return [word(language, "lengths", lengths=",  ".join(told))]


def _gaps(comparison: MotionComparison, language: str) -> list[str]:
    """Name the gaps, those of one reason together, runs of positions as first-last."""
    reasons: dict[tuple[str, str], list[int]] = {}
    for gap in comparison.construction.gaps:
        reasons.setdefault((gap.reason, gap.where), []).append(gap.position)
    return [
        word(language, "gap", positions=runs(positions), reason=word(language, reason), where=where)
        for (reason, where), positions in reasons.items()
    ]


def _why(study: LinkageStudy, comparison: MotionComparison) -> list[str]:
    """Say on a sheet without any position what would mend the mechanism."""
    return [worded(comparison.construction.gaps[0].advice, study.scene.sheet.language)] if study.lost.all() else []


def _travel(study: LinkageStudy, language: str) -> str:
    found = study.found
    assert found is not None  # asked only where there are extremes
    extremes = found.extremes
    overlap = word(
        language, "overlap", overlap=fixed(float(np.degrees(extremes.overlap)), language),
        ratio=fixed(extremes.ratio, language, 3),
    )  # fmt: skip
    if len(found.rests) > 2:  # a stroke between two reversals of several has no time ratio
        overlap = word(language, "reversals", count=len(found.rests))
    if extremes.sliding:
        return f"{word(language, 'stroke', stroke=number(extremes.stroke, language))};  {overlap}"
    swing = fixed(float(np.degrees(extremes.stroke)), language)
    return f"{word(language, 'swing', link=study.output.link, stroke=swing)};  {overlap}"


def measured(said: Sequence[str], size: float) -> Notes:
    """Measure what the notes need on paper."""
    return Notes(tuple(text_width(Text(0j, _marked(note), size)) for note in said), STEP * size)


def written(said: Sequence[str], field: Field, size: float) -> Group:
    """Write the notes from the top of their field downwards, a long one broken between its parts."""
    lines = [line for note in said for line in _broken(_marked(note), field.width, size)]
    step = min(STEP * size, field.height / max(len(lines), 1))
    strokes: list[Stroke] = [
        Text(complex(field.left, field.top - size - k * step), line, size, "start", True)
        for k, line in enumerate(lines)
    ]
    return Group(tuple(strokes), "notes")


def _broken(note: str, width: float, size: float) -> list[str]:
    """Break a note at its spaces where it is wider than its field, but no equation and no range."""
    lines = [""]
    for part in TOGETHER.sub(lambda sign: f"\N{NO-BREAK SPACE}{sign[1]}\N{NO-BREAK SPACE}", note).split(" "):
        trial = f"{lines[-1]} {part}".strip()
        if lines[-1] and text_width(Text(0j, trial, size)) > width:
            lines.append(part)
        else:
            lines[-1] = trial
    return lines


def _marked(note: str) -> str:
    """Lower the kind's number in II2(4,5); the rest of a note stays as it is."""
    out, k = [], 0
    while k < len(note):
        if note.startswith("II", k) and k + 2 < len(note) and note[k + 2].isdigit():
            out.append(f"II_{{{note[k + 2]}}}")
            k += 3
        else:
            out.append(note[k])
            k += 1
    return "".join(out)
