"""The sheets of cams: laws, sizes and profile; the drawing to make one by; charts of all (кулачок, лист 4, чертёж)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, Final, NamedTuple

from drawings.cam import hub, law_diagrams, law_frame, manufacturing, pressure_graph, size_diagram, size_view
from drawings.cam import profile as profile_figure
from drawings.cam.coordinates import enclosures
from drawings.cam.due import expected
from drawings.cam.due_notes import expected as workshop_due
from drawings.cam.manufacturing import TRUE, Manufacture, manufacture
from drawings.cam.notes import CamNotes
from drawings.cam.pressure_graph import PressureView
from drawings.cam.profile_view import profile_view
from drawings.cam.size_view import SizeView
from drawings.kinds import bar_chart, circular_chart
from drawings.kinds.bar_chart import Chart
from drawings.layout.contents import Composition
from drawings.layout.picture import SMALLER, Picture
from drawings.layout.table import RuledTable
from drawings.page.page import Drafting, drafting_of, page_of
from drawings.paper.hand import SIZES
from drawings.paper.strokes import Leaf, SheetError
from drawings.sheets.documents import letter
from drawings.sheets.kind import GRAPH, PLAN, SheetKind
from drawings.sheets.leaves import compositions, lay_out_each
from drawings.sheets.stated_scales import Draft, Exhibit, exhibit, figures_facts
from plans.cam.numbers import cam_by_hand, readings, results
from plans.cam.reading.form import CamForm
from plans.cam.study import CYCLOGRAM, CamDrawing, CamStudy
from plans.cyclogram.rows import EVERY as ALL_CAMS
from plans.cyclogram.rows import rows_of_cams
from plans.model.cam import Cam
from plans.model.cam_motion import CamFound
from plans.scene.scene import Scene
from plans.study import Study

ALONE = "1"  # what an only cam is named without a word
FOREMOST = 2.0  # weight of the profile, for which all the rest is drawn
JOINED, TURN = "joined", "turn"  # the pressure angle under the law over one axis; both apart with one scale of the turn


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cams, each on sheets of its own."""
    scene, cams = study.scene, study.of(CamStudy).drawings.values()
    comparison, drafting = study.comparison("cam"), drafting_of(scene)
    pairs = zip(cams, comparison.analysis.cams, strict=True)
    shared = [] if CYCLOGRAM in scene.sheets else charts(scene, [drawing.cam for drawing in cams])
    several = len(cams) > 1
    return lay_out_each([*((scene, _draft(*pair, several, drafting)) for pair in pairs), *shared])


class _CamContents(NamedTuple):
    """What a sheet shows of a cam however its figures are laid out."""

    drawing: CamDrawing
    angle: PressureView
    profile: Exhibit
    table: RuledTable
    notes: tuple[str, ...]


def _draft(drawing: CamDrawing, exact: CamFound, several: bool, drafting: Drafting) -> Draft:
    """Give the draft that keeps one axis of the turn; instead the turn has one scale, or each figure has its own."""
    ways = (JOINED, TURN, "") if drawing.cam.pressed else ("",)
    contents = _contents(drawing, exact, drafting)
    named = several or drawing.cam.name != ALONE
    title = drafting.word("cam sheet title" + (" of" if named else ""), name=drawing.cam.name)
    first, *further = (_variant(contents, title, drafting, way) for way in ways)
    return first._replace(instead=tuple(further))


def _contents(drawing: CamDrawing, exact: CamFound, drafting: Drafting) -> _CamContents:
    """Make once what every draft of a sheet shows alike: the profile foremost, and what both roads found."""
    by_hand = any(readings(drawing))
    ours, theirs = (results(found) for found in (drawing.found, exact))
    return _CamContents(
        drawing,
        PressureView(drawing.sizing.limits, drawing.curve, drawing.found),
        exhibit(profile_figure, profile_view(drawing.found), drafting, weight=FOREMOST),
        size_view.sizes(ours, theirs, by_hand, drafting),
        CamNotes(drawing.found, drafting).all,
    )


def _variant(contents: _CamContents, title: str, drafting: Drafting, way: str) -> Draft:
    cam = contents.drawing.cam
    shows = (*_shows(contents, way, drafting), contents.profile)
    facts, later = partial(_facts, cam, way == JOINED), partial(cam_by_hand, contents.drawing)
    return Draft("cam", title, shows, (contents.table,), contents.notes, facts, later=later)


def _facts(cam: Cam, joined: bool, figures: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which cam it is of, and which figures it shows."""
    under = [pressure_graph.NAME] if joined and law_frame.name_of(cam) in figures else []
    return {"cam": cam.name, "figures": [*figures, *under]}


def _shows(contents: _CamContents, way: str, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the law, and the sizes that follow from it."""
    drawing, angle = contents.drawing, contents.angle
    if way == JOINED:
        yield exhibit(pressure_graph, replace(angle, law=drawing.diagrams), drafting)
    else:
        yield exhibit(law_diagrams, drawing.diagrams, drafting, scale=way)
    if not drawing.cam.translates:
        yield exhibit(size_diagram, SizeView(drawing.sizing), drafting)
    if drawing.cam.pressed and way != JOINED:
        yield exhibit(pressure_graph, angle, drafting, scale=way)


def charts(scene: Scene, cams: Sequence[Cam]) -> list[tuple[Scene, Draft]]:
    """Give the charts, on the smallest format that takes them; a cam alone has its phases on its own sheet."""
    turning = [cam for cam in cams if not cam.translates]
    if len(turning) < 2:
        return []
    drafts = [(small, _chart_draft(turning, drafting_of(small))) for small in (*_formats(scene), scene)]
    return [next((pair for pair in drafts if len(_composed(*pair)) == 1), drafts[-1])]


def _chart_draft(cams: Sequence[Cam], drafting: Drafting) -> Draft:
    facts, chart = partial(figures_facts, cam=ALL_CAMS), Chart(rows_of_cams(cams), cams[0].sense)
    shows = tuple(exhibit(figure, chart, drafting) for figure in (bar_chart, circular_chart))
    return Draft("cam", drafting.word("cyclogram sheet title"), shows, (), (), facts)


def _composed(scene: Scene, draft: Draft) -> Sequence[Composition]:
    """Give the sheets that a draft takes; none where there is not even room for its heading."""
    try:
        return compositions(scene, draft)
    except SheetError:
        return ()


KIND = "profile"
EVERY = (1, 2, 3, 6)  # every which tabled turn is told, as the paper takes them


def workshop_leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cams, one for each."""
    return workshop_sheets(study.scene, [manufacture(found) for found in study.of(CamStudy).found])


def workshop_sheets(scene: Scene, parts: Sequence[Manufacture]) -> tuple[Leaf, ...]:
    """Lay out the sheets of cams whose profiles are found."""
    return lay_out_each([_workshop_draft(scene, part, len(parts) > 1) for part in parts])


def _workshop_draft(scene: Scene, shown: Manufacture, several: bool) -> tuple[Scene, Draft]:
    """Give the smallest format on which the profile stands at its own size with the whole table, and the draft.

    Where none takes that, the scene's own: with the draft whose figure can be read on the fewest sheets, and of its
    table as many rows as they take.
    """
    for small in _formats(scene):
        draft = _workshop_variant(shown, EVERY[0], several, drafting_of(small))
        composed = _composed(small, draft)
        room = draft.shows[0].panel.item
        assert isinstance(room, Picture)
        natural = max(room.wide, room.high) * TRUE
        large = max(natural, room.least) * SMALLER
        if len(composed) == 1 and room.extent(composed[0].spots[room.name].scale) >= large:
            return small, draft
    first, *further = (_workshop_variant(shown, every, several, drafting_of(scene)) for every in EVERY)
    return scene, first._replace(instead=tuple(further))


def _formats(scene: Scene) -> Iterator[Scene]:
    """Give a scene by formats up to its own that its standard lays as the scene wants them, the smallest first."""
    names = [*reversed(SIZES)]
    for name in names[: names.index(scene.sheet.format) + 1]:
        small = scene.changed(sheet=scene.sheet.changed(format=name))
        if _lies(small):
            yield small


def _lies(scene: Scene) -> bool:
    """Tell whether the standard lays the format as the scene wants it."""
    try:
        page_of(scene, KIND)
    except SheetError:
        return False
    return True


def _workshop_variant(shown: Manufacture, every: int, several: bool, drafting: Drafting) -> Draft:
    title = drafting.word("cam profile sheet title" + (" of" if several else ""), name=shown.cam.name)
    shows = [exhibit(manufacturing, shown, drafting, weight=FOREMOST)]
    shows += [exhibit(hub, shown.cam.hub, drafting)] if shown.cam.hub else []
    table = manufacturing.radii(shown, every, drafting)
    notes, facts = tuple(manufacturing.notes(shown, drafting)), partial(figures_facts, cam=shown.cam.name, every=every)
    return Draft(KIND, title, tuple(shows), (table,), notes, facts, manufacturing.PLAN)


def of_cams(scene: Scene) -> None:
    """See that the names of a scene's cams can be lettered; whatever else is read of them can be shown."""
    letter(scene, [(("cam", k, "name"), cam.name) for k, cam in enumerate(scene.of(CamForm).cam)])


SCALES, WORKSHOP = {"sizes": "cam", "profile": "cam"}, {manufacturing.PLAN: "cam"}
FORM: Final = {"law-": GRAPH, "pressure": GRAPH, **dict.fromkeys(SCALES, PLAN)}
COORDINATES = ("radii", "coordinates")
SHEETS: Final = {
    "cam": SheetKind(leaves, expected, SCALES, of_cams, figures=FORM, tables=("sizes", "results")),
    "profile": SheetKind(
        workshop_leaves, workshop_due, WORKSHOP, of_cams, enclosures=enclosures,
        figures=dict.fromkeys(WORKSHOP, PLAN), tables=COORDINATES,
    ),
}  # fmt: skip
