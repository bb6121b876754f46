"""Sheet 5, a rotor balanced: seen along and across its shaft, polygons, counterweights, quality (уравновешивание)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from functools import partial
from typing import Any

from drawings.figures.rotor import across, along, rotor_polygon, rotor_table
from drawings.figures.rotor.rotor_polygon import RotorPolygon, RotorView, rotor_view
from drawings.figures.workings import segment_working
from drawings.figures.workings.working import Working
from drawings.layout import value_table
from drawings.layout.contents import Panel
from drawings.layout.picture import Spot
from drawings.layout.table import Later, RuledTable
from drawings.lettering.rotor_letters import lowered
from drawings.page.drafting import Drafting, drafting_of
from drawings.page.page import Field
from drawings.paper.strokes import Group, Leaf
from drawings.report.agreement import agreed
from drawings.report.rotor_notes import RotorNotes
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, captions
from plans.checks.comparison import Comparison
from plans.checks.hand.rotor import rotor_by_hand
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
        *captions(_workings(rotor, drafting)),
    )
    tables = (rotor_table.masses(rotor.rotor, rotor.balance, drafting),)
    said = *RotorNotes(rotor.rotor, rotor.balance, drafting).all, *agreed(rotor_table.compared(comparison), drafting)
    title = drafting.word("rotor sheet title")
    return lay_out(scene, [Draft("rotor", title, shows, tables, said, _facts, later=partial(_later, rotor, drafting))])


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


def _workings(rotor: RotorStudy, drafting: Drafting) -> Iterator[Working]:
    """How the polygons are laid off: beside them, where paper would stay bare."""
    for shown in _shown(rotor):
        sizes = {lowered(one.name, drafting.language): abs(one.value) for one in shown.vectors}
        yield segment_working.working(sizes, shown.symbol[0].strip("{}"), shown.plan, drafting)


def _shown(rotor: RotorStudy) -> Iterator[RotorPolygon]:
    """Give the polygon of moments, if a second plane asks for it, then that of static moments."""
    drawing = rotor.drawing
    names = frozenset(one.mark.name for one in drawing.corrections[:-1])
    for construction in (drawing.moments, drawing.forces) if rotor.rotor.dynamic else (drawing.forces,):
        yield rotor_polygon.polygon(construction, names)


def _polygons(rotor: RotorStudy, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the polygons in one column."""
    for shown in _shown(rotor):
        room = rotor_polygon.measure(shown, drafting)
        yield Exhibit(Panel(room, together=TOGETHER), partial(rotor_polygon.draw, shown, room, drafting=drafting))


def _results(comparison: Comparison, drafting: Drafting) -> Caption:
    """Tell what both roads found under the polygon that ends the construction."""
    table = rotor_table.results(comparison, drafting)
    panel = Panel(table.block(table.name), together=TOGETHER)
    return Caption(panel, partial(_written, table, drafting), waits=True)


def _written(table: RuledTable, drafting: Drafting, box: Field, write: Callable[[Later], str]) -> Group:
    return table.filled(write).write(box, drafting)


def _later(rotor: RotorStudy, drafting: Drafting, spots: Mapping[str, Spot]) -> Callable[[Later], str]:
    """Write what a hand may be out in the polygons, at their scales."""
    scales = {name: spot.scale.mu for name, spot in spots.items()}
    return value_table.by_hand(rotor_by_hand(rotor, scales), drafting.language)
