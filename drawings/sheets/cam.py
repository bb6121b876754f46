"""Sheet 4, a cam: laws, main sizes by tangents, profile by inversion, pressure angle, table (кулачок, лист 4)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from typing import Any

from drawings.figures.cam import law_diagrams, pressure_graph, profile_figure, size_diagram, sizes_table
from drawings.figures.cam.pressure_graph import pressure_view
from drawings.figures.cam.profile_view import profile_view
from drawings.figures.cam.size_view import SizeView
from drawings.layout.contents import Panel
from drawings.layout.table import RuledTable
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.cam_notes import CamNotes
from drawings.sheets import cam_charts
from drawings.sheets.leaves import Caption, Draft, Exhibit, lay_out
from plans.analytic.cam.laws import travel
from plans.cam.study import CYCLOGRAM, CamDrawing
from plans.model.cam_motion import CamFound
from plans.study import Study

FOREMOST = 2.0  # weight of the profile, for which all the rest is drawn


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cams, each on sheets of its own (row of the table of sheets)."""
    scene, cams = study.scene, study["cam"].drawings.values()
    pairs = zip(cams, study.comparison("cam").analysis.cams, strict=True)
    drafting = drafting_of(scene)
    shared = [] if CYCLOGRAM in scene.sheets else cam_charts.drafts([one.cam for one in cams], drafting)
    return lay_out(scene, [*(_draft(*pair, drafting) for pair in pairs), *shared])


def _draft(drawing: CamDrawing, exact: CamFound, drafting: Drafting) -> Draft:
    said = CamNotes(drawing.found, drafting).all
    title = drafting.word("cam sheet title", name=drawing.cam.name)
    shows = tuple(_shows(drawing, exact, drafting))
    return Draft("cam", title, shows, (), said, partial(_facts, drawing.cam.name))


def _facts(name: str, figures: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which cam it is of, and which figures it shows."""
    return {"cam": name, "figures": list(figures)}


def _shows(drawing: CamDrawing, exact: CamFound, drafting: Drafting) -> Iterator[Exhibit | Caption]:
    """Show the law, the sizes that follow from it, the profile foremost, and what both roads found of it."""
    law = law_diagrams.measure(drawing.diagrams, drafting)
    yield Exhibit(Panel(law), partial(law_diagrams.draw, drawing.diagrams, law, drafting=drafting))
    if not drawing.cam.translates:
        shown = SizeView(drawing.sizing)
        room = size_diagram.measure(shown, drafting)
        yield Exhibit(Panel(room), partial(size_diagram.draw, shown, room, drafting=drafting))
    if not (drawing.cam.flat and not drawing.cam.rocks):
        yield _pressure(drawing, drafting)
    view = profile_view(drawing.found)
    room = profile_figure.measure(view, drafting)
    yield Exhibit(Panel(room, FOREMOST), partial(profile_figure.draw, view, room, drafting=drafting))
    table = _results(drawing, exact, drafting)
    yield Caption(Panel(table.block(table.name)), partial(table.write, drafting=drafting))


def _pressure(drawing: CamDrawing, drafting: Drafting) -> Exhibit:
    """Show the pressure angle, which a flat face that translates has none of."""
    shown = pressure_view(drawing.sizing.limits, drawing.curve, drawing.found)
    room = pressure_graph.measure(shown, drafting)
    return Exhibit(Panel(room), partial(pressure_graph.draw, shown, room, drafting=drafting))


def _results(drawing: CamDrawing, exact: CamFound, drafting: Drafting) -> RuledTable:
    """Tell sizes, extremes and shocks by both roads."""
    turned = drawing.curve.turned
    own = sizes_table.quantities(drawing.found, drawing.curve.travel)
    return sizes_table.sizes(own, sizes_table.quantities(exact, travel(exact.cam, turned)), drafting)
