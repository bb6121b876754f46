"""The self-check of a note on forces: equations and friction against the analysis (проверка силового расчёта)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.checks.forces.report_tables import ForceTables
from drawings.checks.note.arithmetic import miscounted
from drawings.checks.note.force_lines import ForceLines
from drawings.checks.note.lines import part
from drawings.checks.verify_friction import report_of
from drawings.checks.wrong import Wrong
from drawings.lettering.words import number
from plans.forces.reversals import reversals
from plans.model.machine import BACKWARD, FORWARD, IDLE, WORKING
from plans.study import Study
from plans.words.words import message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

WAYS = {WORKING: FORWARD, IDLE: BACKWARD}  # that a load may be made to act on instead


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold the equations of forces, with the scales of the sheets, and what is told of friction."""
    statics, comparison, language = study["forces"], study.comparison("forces"), study.scene.sheet.language
    lines = part(text, word(language, "report.force_equations"))
    yield from miscounted(lines)
    yield from ForceLines(lines, statics, comparison, leaves).faults()
    yield from report_of(text, comparison, language)


def report_faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold a whole report: the note, and the tables of forces over the positions."""
    yield from faults(text, study, leaves)
    yield from ForceTables(text, study["forces"], study.comparison("forces")).faults()
    shown = dict.fromkeys(
        leaf.metadata["position"] for own in leaves.values() for leaf in own if "position" in leaf.metadata
    )
    due = word(study.scene.sheet.language, "report.forces_drawn", positions=", ".join(map(str, shown)))
    if due not in text.splitlines():
        yield message("wrong.missing", name=due)


def said_first(study: Study) -> Iterator[str]:
    """Give the lines that are said first of forces beside their numbers: loads whose output reverses in a stroke."""
    language = study.scene.sheet.language
    for load, rests in reversals(study["forces"]):
        angles = ", ".join(f"{number(math.degrees(one), language)}°" for one in rests)
        parts = {"name": load.name, "during": load.during, "way": WAYS[load.during], "count": len(rests)}
        yield word(language, "verdict.reverses", **parts, angles=angles)
