"""The self-check of a written sheet of a cam: every figure, table and note against the analysis (проверка листа)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from drawings.checks import reading
from drawings.checks.cam import (
    cam_charts,
    cam_law_lines,
    cam_law_poles,
    cam_laws,
    cam_page,
    cam_table,
    cam_told,
)
from drawings.checks.cam.cam_diagram import SizeDiagram
from drawings.checks.cam.cam_expected import Expected
from drawings.checks.cam.cam_lines import ProfileLines
from drawings.checks.cam.cam_marks import marks
from drawings.checks.cam.cam_pressure import PressureGraph
from drawings.checks.cam.cam_profile_lines import ProfileWork
from drawings.checks.cam.cam_size_lines import SizeLines
from drawings.checks.cam.profile_marks import wrong_marks
from drawings.checks.cam.profiles import analysed, wrong
from drawings.checks.cam.shape import profile_styles
from drawings.checks.cam.shape.round_lines import RoundLines
from drawings.checks.cyclogram.cyclogram_charts import BARS, CIRCLE
from drawings.checks.documents_old import together
from drawings.checks.graphs.figure_strokes import figure
from drawings.checks.graphs.scale_line import ratio, scale_line
from drawings.checks.linkage import accord
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.pressure_graph import NAME as PRESSURE
from drawings.figures.cam.profile_view import NAME as PROFILE
from drawings.figures.cam.profile_view import PITCH
from drawings.figures.cam.size_view import NAME as DIAGRAM
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from plans.cam.study import CYCLOGRAM
from plans.checks.cam.comparison import of_cam
from plans.checks.comparison import Finding
from plans.checks.hand.cam import readings
from plans.cyclogram.rows import EVERY
from plans.study import Study
from plans.words.words import message

ROLLED = 180  # parts of a turn at which the written curves are held to the law


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a cam shows against the analysis (row of the table of sheets)."""
    cams = {one.cam.name: one for one in study.comparison("cam").analysis.cams}
    name = leaf.metadata["cam"]
    if name == EVERY:
        yield from cam_page.paper(leaf, study.scene, "cam", drafting_of(study.scene).word("cyclogram sheet title"), "")
        yield from cam_charts.faults(measured, leaf, [one.cam for one in cams.values()], drafting_of(study.scene))
        return
    expected, compared = Expected(cams[name], study["cam"].drawings[name]), of_cam(study.comparison("cam"), name)
    drafting = drafting_of(study.scene)
    yield from check(measured, leaf, expected, compared, drafting)
    profile = figure(leaf, PROFILE)
    pole = None if profile is None else cam_page.pole_of(profile)
    title = drafting.word("cam sheet title", name=name)
    scale = "" if pole is None else ratio(pole[1], drafting.language)
    yield from cam_page.paper(leaf, study.scene, "cam", title, scale)


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """See that every cam has its figures, its whole table and its notes on its sheets, and a shaft its charts."""
    leaves, drafting = [leaf for _, leaf in sheets], drafting_of(study.scene)
    cams = study.comparison("cam").analysis.cams
    for found in cams:
        own = [leaf for leaf in leaves if leaf.metadata["cam"] == found.cam.name]
        expected = Expected(found, study["cam"].drawings[found.cam.name])
        yield from together.figures(own, [*_figures(expected)])
        rows = (row.title(drafting) for row in cam_table.rows(expected))
        yield from together.table(own, cam_table.NAME, [*rows])
        yield from together.notes(own)
    shared = [leaf for leaf in leaves if leaf.metadata["cam"] not in [one.cam.name for one in cams]]
    if shared or (CYCLOGRAM not in study.scene.sheets and sum(not one.cam.translates for one in cams) > 1):
        yield from together.figures(shared, (BARS, CIRCLE))
        yield from together.notes(shared)


def _figures(expected: Expected) -> Iterator[str]:
    """Give the figures that the sheets of a cam bear."""
    yield from (PROFILE, cam_laws.named(expected.cam))
    yield from () if expected.cam.translates else (DIAGRAM,)
    yield from (PRESSURE,) if expected.cam.rocks or not expected.cam.flat else ()


def check(
    measured: Measured, leaf: Leaf, expected: Expected, compared: Sequence[Finding], drafting: Drafting
) -> Iterator[Wrong]:
    """Hold what a sheet shows against what is expected: the figures that its data name, tables, notes, scales."""
    shown = leaf.metadata["figures"]
    if PROFILE in shown:
        yield from _profile(measured, leaf, expected, drafting)
    if DIAGRAM in shown:
        yield from _diagram(measured, leaf, expected, drafting)
    strokes = figure(leaf, PRESSURE)
    if strokes is not None:
        yield from PressureGraph(strokes, measured, expected, drafting).faults()
    elif PRESSURE in shown or (leaf.metadata["of"] == 1 and _pressed(expected)):
        yield on("missing_on", PRESSURE, name="α")
    yield from cam_table.results(leaf, expected, drafting)
    if cam_laws.named(expected.cam) in shown:
        yield from cam_laws.diagrams(measured, leaf, expected, drafting)
        graphs = cam_laws.graphs(measured, leaf, expected, drafting)
        if not any(math.isnan(one.along) for one in graphs):
            yield from cam_law_poles.poles(leaf, graphs, expected)
            yield from cam_law_lines.lines(leaf, graphs, expected, drafting)
    read_off = any(readings(expected.drawing))
    yield from cam_told.notes(leaf, expected, accord.due(compared, drafting.language, read_off), drafting)
    yield from reading.marked_scales(leaf)
    yield from cam_told.decimals(leaf, drafting)


def _profile(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the figure of the profile: curves, marks, lines, letters."""
    strokes = figure(leaf, PROFILE)
    pole = None if strokes is None else cam_page.pole_of(strokes)
    if strokes is None or pole is None:
        yield on("missing_on", PROFILE, name="O")
        return
    origin, mu = pole
    yield from wrong(measured.profiles, PROFILE, analysed(expected.found, ROLLED))
    if expected.found.roller and all(one.name != PITCH for one in measured.profiles if one.plan == PROFILE):
        yield on("missing_on", PROFILE, name=PITCH)
    yield from profile_styles.faults(strokes, PROFILE, expected.found, drafting.hand)
    yield from wrong_marks(measured, leaf, expected.found, drafting)
    yield from marks(measured, expected, origin, mu, drafting.hand)
    lines = ProfileLines(strokes, expected, origin, mu, drafting)
    yield from lines.faults()
    sized = (one for one in measured.vectors if one.plan == PROFILE and one.name == "ρ_min")
    yield from RoundLines(lines, next(sized, None)).faults()
    title, scale = drafting.word("cam profile"), scale_line(mu, "l", "m", drafting)
    yield from ProfileWork(lines, measured, title, scale).faults()
    yield from cam_told.sizes(strokes, expected, drafting)
    yield from cam_page.headed(strokes, PROFILE, drafting.word("cam profile"), mu, drafting)
    yield from cam_told.headings(leaf, strokes, mu, expected, drafting)


def _diagram(measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the figure of the main sizes."""
    strokes = figure(leaf, DIAGRAM)
    pole = None if strokes is None else cam_page.pole_of(strokes)
    if strokes is None or pole is None:
        yield on("missing_on", DIAGRAM, name="O")
        return
    diagram = SizeDiagram(strokes, measured, expected, *pole, drafting)
    yield from diagram.faults()
    yield from SizeLines(diagram).faults()
    yield from cam_page.headed(strokes, DIAGRAM, diagram.title, pole[1], drafting)
    if not math.isclose(leaf.metadata["scales"][DIAGRAM], pole[1]):
        yield message("wrong.scale", text=f"{DIAGRAM} {pole[1]:g}")


def _pressed(expected: Expected) -> bool:
    """Tell whether a cam has a pressure angle that is not 0 throughout."""
    return not (expected.cam.flat and not expected.cam.rocks) and bool(expected.found.pressure)
