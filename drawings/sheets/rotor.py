"""Sheet 5, a rotor balanced: seen along and across its shaft, polygons, counterweights, quality (уравновешивание)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from typing import Any

from drawings.figures.rotor import across, along, rotor_polygon, rotor_table
from drawings.figures.rotor.rotor_view import RotorView, rotor_view
from drawings.layout.contents import Panel
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.rotor_notes import RotorNotes
from drawings.sheets.leaves import Caption, Draft, Exhibit, lay_out
from plans.checks.comparison import Comparison
from plans.rotor.study import RotorStudy
from plans.scene.scene import Scene
from plans.study import Study

TOGETHER = "polygons"  # what stands in one column


def admit(scene: Scene) -> None:
    """See nothing more: a rotor's author names nothing, and any number of masses can be shown."""


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's rotor (row of the table of sheets)."""
    return sheets(study.scene, study["rotor"], study.comparison("rotor"))


def sheets(scene: Scene, rotor: RotorStudy, comparison: Comparison) -> tuple[Leaf, ...]:
    """Lay out the sheets of a rotor whose two roads are compared."""
    drafting = drafting_of(scene)
    shows: tuple[Exhibit | Caption, ...] = (
        *_polygons(rotor, drafting),
        _results(comparison, drafting),
        *_views(rotor, drafting),
    )
    tables = (rotor_table.masses(rotor.rotor, rotor.balance, drafting),)
    said = RotorNotes(rotor.rotor, rotor.balance, drafting).all
    title = drafting.word("rotor sheet title")
    return lay_out(scene, [Draft("rotor", title, shows, tables, said, _facts)])


def _facts(names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which figures it shows."""
    return {"figures": list(names)}


def _views(rotor: RotorStudy, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the rotor along its shaft; across it too, unless it is a thin disc in the plane of correction."""
    shown = rotor_view(rotor.rotor, rotor.balance)
    if not _thin(shown):
        room = across.measure(shown, drafting)
        yield Exhibit(Panel(room), partial(across.draw, shown, room, drafting=drafting))
    room = along.measure(shown, drafting)
    yield Exhibit(Panel(room), partial(along.draw, shown, room, drafting=drafting))


def _thin(shown: RotorView) -> bool:
    return not shown.bearings and len(set(shown.places)) == 1


def _polygons(rotor: RotorStudy, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the polygon of moments, if a second plane asks for it, then that of static moments."""
    drawing = rotor.drawing
    names = frozenset(one.mark.name for one in drawing.corrections[:-1])
    for construction in (drawing.moments, drawing.forces) if rotor.rotor.dynamic else (drawing.forces,):
        shown = rotor_polygon.polygon(construction, names)
        room = rotor_polygon.measure(shown, drafting)
        yield Exhibit(Panel(room, together=TOGETHER), partial(rotor_polygon.draw, shown, room, drafting=drafting))


def _results(comparison: Comparison, drafting: Drafting) -> Caption:
    """Tell what both roads found under the polygon that ends the construction."""
    table = rotor_table.results(comparison, drafting)
    return Caption(Panel(table.block(table.name), together=TOGETHER), partial(table.write, drafting=drafting))
