"""The self-check of the kinematic diagrams on a written sheet, against the analysis (проверка диаграмм)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.checks.diagrams import diagram_told
from drawings.checks.diagrams.diagram_poles import poles
from drawings.checks.diagrams.diagram_rows import graphs
from drawings.checks.diagrams.expected_rows import KEYS, ExpectedRow, expected_rows
from drawings.checks.graphs.figure_strokes import figure
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.workings import diagram_workings
from drawings.checks.wrong import Wrong, on
from drawings.figures.diagrams.frame import NAME
from drawings.lettering.words import number
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from plans.checks.diagrams_comparison import DiagramsComparison
from plans.diagrams.study import DiagramsStudy
from plans.linkage.travel import frame_slide
from plans.study import Study
from plans.words.words import message


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold the diagrams that a sheet shows, the table of the output and the notes; of a lone sheet none is missing."""
    own: DiagramsStudy = study["diagrams"]
    drafting = drafting_of(study.scene)
    if not own.wanted:
        return
    comparison = study.comparison("diagrams")
    if not isinstance(comparison, DiagramsComparison):
        yield from diagram_told.notes(leaf, own, (), drafting)
        return
    rows, omega = expected_rows(comparison), abs(own.linkage.mechanism.drive.omega)
    if leaf.metadata["diagrams"]:
        yield from _figure(measured, leaf, own, rows, drafting)
    elif leaf.metadata["of"] == 1:
        yield message("wrong.missing", name=NAME)
    yield from diagram_told.table(leaf, comparison, omega, drafting)
    yield from diagram_told.notes(leaf, own, rows, drafting)


def notes(study: Study) -> list[list[str]]:
    """Give the words of each note on the diagrams that is due."""
    own: DiagramsStudy = study["diagrams"]
    if not own.wanted:
        return []
    comparison = study.comparison("diagrams")
    rows = expected_rows(comparison) if isinstance(comparison, DiagramsComparison) else ()
    return diagram_told.sentences(own, rows, drafting_of(study.scene))


def _figure(
    measured: Measured, leaf: Leaf, own: DiagramsStudy, rows: tuple[ExpectedRow, ...], drafting: Drafting
) -> Iterator[Wrong]:
    """Hold the heading with the scales along the axis, each row, the poles."""
    head, omega = figure(leaf, NAME), abs(own.linkage.mechanism.drive.omega)
    stated = {} if head is None else written_scales(head.group)
    along = stated.get("φ", 1.0)
    if _written(stated.get("t", math.inf), drafting) != _written(along / omega, drafting):
        yield message("wrong.scale", text="μ_t")
    if _written(dict(own.linkage.scene.sheet.scale.stated).get("angle", along), drafting) != _written(along, drafting):
        yield on("scale_stated", NAME)
    due = _title(own, drafting)
    if head is None or due not in head.texts:
        yield on("title", NAME, text=due)
    found = graphs(measured, leaf, rows, drafting, along)
    if len(found) < len(KEYS):
        yield message("wrong.missing", name=NAME)
        return
    shared = frozenset(k for one in found for k in (*one.marks, *one.numbered))
    for one in found:
        yield from one.faults(shared)
    yield from poles(leaf, found, omega)
    yield from diagram_workings.of_diagrams(leaf, found, omega, own.linkage.mechanism.drive.link, drafting)


def _written(mu: float, drafting: Drafting) -> str:
    """Give the number of a scale as it is written, mu or K = 1/mu; of none at all nothing."""
    return number(1 / mu if drafting.notation == "K" else mu) if math.isfinite(mu) else ""


def _title(own: DiagramsStudy, drafting: Drafting) -> str:
    """Give the heading: the output by its number, one that slides by its point too."""
    output = own.linkage.output
    slide = frame_slide(own.linkage.mechanism, output.link)
    slides = slide is not None or output.parting is not None
    point = (output.point or (slide.point if slide else "")) if slides else ""
    return drafting.word(f"diagrams of {'point' if point else 'link'}", link=output.link, point=point)
