"""Sheet 4, a cam: laws, main sizes by tangents, profile by inversion, pressure angle, table (кулачок, лист 4)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from drawings.cam import column, law_diagrams, law_frame, pressure_graph, profile_sheet, size_diagram, size_view
from drawings.cam import profile as profile_figure
from drawings.cam.notes import CamNotes
from drawings.cam.pressure_graph import PressureView, pressure_view
from drawings.cam.profile_view import profile_view
from drawings.cam.size_view import SizeView
from drawings.layout.table import RuledTable
from drawings.page.scale import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.report import agreed
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Draft, Exhibit, exhibit
from plans.cam.numbers import cam_by_hand, readings
from plans.cam.quantities import of_cam
from plans.cam.results import results
from plans.cam.study import CYCLOGRAM, CamDrawing, CamStudy
from plans.model.cam import Cam
from plans.model.cam_motion import CamFound
from plans.quantity import Quantity
from plans.study import Study

LENGTHS = "lengths"  # the diagram of the sizes, whose O is the profile's, has its scale
FOREMOST = 2.0  # weight of the profile, for which all the rest is drawn
JOINED, TURN = "joined", "turn"  # the pressure angle under the law over one axis; both apart with one scale of the turn


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cams, each on sheets of its own (row of the table of sheets)."""
    scene, cams = study.scene, study.of(CamStudy).drawings.values()
    comparison, drafting = study.comparison("cam"), drafting_of(scene)
    pairs = [
        (one, exact, of_cam(comparison, one.cam.name))
        for one, exact in zip(cams, comparison.analysis.cams, strict=True)
    ]
    shared = [] if CYCLOGRAM in scene.sheets else profile_sheet.drafts([one.cam for one in cams], drafting)
    return lay_out(scene, [*(_draft(*pair, drafting) for pair in pairs), *shared])


class _Contents(NamedTuple):
    """What a sheet shows of a cam however its figures are laid out."""

    drawing: CamDrawing
    angle: PressureView
    profile: Exhibit
    table: RuledTable
    notes: tuple[str, ...]


def _draft(drawing: CamDrawing, exact: CamFound, compared: Sequence[Quantity], drafting: Drafting) -> Draft:
    """Give the draft that keeps one axis of the turn; instead the turn has one scale, or each figure has its own."""
    ways = (JOINED, TURN, "") if _pressed(drawing.cam) else ("",)
    contents = _contents(drawing, exact, compared, drafting)
    first, *further = (_told(contents, drafting, way) for way in ways)
    return first._replace(instead=tuple(further))


def _contents(drawing: CamDrawing, exact: CamFound, compared: Sequence[Quantity], drafting: Drafting) -> _Contents:
    """Make once what every draft of a sheet shows alike: the profile foremost, and what both roads found."""
    by_hand = any(readings(drawing))
    return _Contents(
        drawing,
        pressure_view(drawing.sizing.limits, drawing.curve, drawing.found),
        exhibit(profile_figure, profile_view(drawing.found), drafting, weight=FOREMOST, scale=LENGTHS),
        _results(drawing, exact, by_hand, drafting),
        (*CamNotes(drawing.found, drafting).all, *agreed(compared, drafting, by_hand)),
    )


def _told(contents: _Contents, drafting: Drafting, way: str) -> Draft:
    cam = contents.drawing.cam
    shows = (*_shows(contents, way, drafting), contents.profile)
    title = drafting.word("cam sheet title", name=cam.name)
    facts, later = partial(_facts, cam, way == JOINED), partial(cam_by_hand, contents.drawing)
    return Draft("cam", title, shows, (contents.table,), contents.notes, facts, later=later)


def _facts(cam: Cam, joined: bool, figures: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which cam it is of, and which figures it shows."""
    under = [pressure_graph.NAME] if joined and law_frame.name_of(cam) in figures else []
    return {"cam": cam.name, "figures": [*figures, *under]}


def _shows(contents: _Contents, way: str, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the law, and the sizes that follow from it."""
    drawing, angle = contents.drawing, contents.angle
    if way == JOINED:
        yield exhibit(column, (drawing.diagrams, angle), drafting)
    else:
        yield exhibit(law_diagrams, drawing.diagrams, drafting, scale=way)
    if not drawing.cam.translates:
        yield exhibit(size_diagram, SizeView(drawing.sizing), drafting, scale=LENGTHS)
    if _pressed(drawing.cam) and way != JOINED:
        yield exhibit(pressure_graph, angle, drafting, scale=way)


def _pressed(cam: Cam) -> bool:
    """Tell whether a cam has a pressure angle: under a flat face that translates there is none."""
    return cam.rocks or not cam.flat


def _results(drawing: CamDrawing, exact: CamFound, by_hand: bool, drafting: Drafting) -> RuledTable:
    """Tell sizes, extremes and shocks by both roads, and what a hand may be out."""
    own, other = (results(one) for one in (drawing.found, exact))
    return size_view.sizes(own, other, by_hand, drafting)
