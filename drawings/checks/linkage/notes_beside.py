"""What the notes of a kinematics sheet say beside what is due: what is said twice, or is of another sheet (лишнее)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TypeAlias

from drawings.checks import reading
from drawings.checks.diagrams import diagram_told, verify_diagrams
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.linkage import accord, linkage_notes, own_scales
from drawings.checks.reading import NOTES
from drawings.checks.wrong import Wrong, within
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from plans.checks.compare import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.study import Study
from plans.words.words import said

Due: TypeAlias = tuple[list[str], Collection[int]]  # a sentence by its words, and how many digits its numbers may have


def faults(leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Give what is left of the notes, written and described, once each sentence that is due has been taken out."""
    due = _due(leaf, study)
    for words in (reading.notes(leaf), read(leaf.description.replace("\n", " "))):
        left = _left(words.replace("\N{NO-BREAK SPACE}", " ").split(), due, study) if words else ""
        if left:
            yield within("note_beside", NOTES, text=left)


def _due(leaf: Leaf, study: Study) -> list[Due]:
    told = linkage_notes.sentences(study["linkage"], study.comparison("linkage"))
    graphs = verify_diagrams.notes(study) if "diagrams" in leaf.metadata else ()
    return [*((one, linkage_notes.DIGITS) for one in told), *((one, diagram_told.NOTE_DIGITS) for one in graphs)]


def _left(words: list[str], due: list[Due], study: Study) -> str:
    """Take each sentence out once; what is not said at all is told elsewhere."""
    for one, digits in due:
        k = linkage_notes.begun(words, one, digits)
        if k is None:
            return ""
        words = [*words[:k], *words[k + len(one) :]]
    drafting = drafting_of(study.scene)
    rest = own_scales.cut(accord.cut(" ".join(words), drafting.language), drafting)
    for advice in _advice(study["linkage"], study.comparison("linkage")):
        rest = rest.replace(read(advice), "", 1)
    return " ".join(rest.split())


def _advice(linkage: LinkageStudy, comparison: MotionComparison) -> Iterator[str]:
    """Give what a sheet without any position says would mend the mechanism."""
    if linkage.lost.all():
        yield said(comparison.construction.gaps[0].advice, linkage.language)
