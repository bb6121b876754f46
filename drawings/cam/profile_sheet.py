"""The sheets of all cams: the drawing that a cam is made by, charts of every cam (чертёж кулачка, циклограмма)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from drawings.cam import manufacturing
from drawings.cam.manufacturing import TRUE, Manufacture, manufacture
from drawings.cyclogram.notes import settings_of
from drawings.kinds import bar_chart, circular_chart
from drawings.kinds.bar_chart import Chart
from drawings.layout.picture import SMALLER, Picture
from drawings.page.page import page_of
from drawings.page.scale import Drafting, drafting_of
from drawings.paper.formats import SIZES
from drawings.paper.strokes import Leaf, SheetError
from drawings.sheets.leaves import compositions, lay_out_each
from drawings.sheets.stated_scales import Draft, Exhibit, exhibit, figures_facts
from plans.cam.study import CamStudy
from plans.cyclogram.rows import EVERY as ALL_CAMS
from plans.cyclogram.rows import rows_of_cams
from plans.model.cam import Cam
from plans.scene.scene import Scene
from plans.study import Study


def drafts(cams: Sequence[Cam], drafting: Drafting) -> list[Draft]:
    """Give the draft of the charts; a cam alone has its phases on its own sheet."""
    turning = [one for one in cams if not one.translates]
    if len(turning) < 2:
        return []
    said, title = tuple(settings_of(turning, drafting)), drafting.word("cyclogram sheet title")
    return [Draft("cam", title, tuple(_shows(turning, drafting)), (), said, partial(figures_facts, cam=ALL_CAMS))]


def _shows(cams: Sequence[Cam], drafting: Drafting) -> Iterator[Exhibit]:
    chart = Chart(rows_of_cams(cams), cams[0].sense)
    yield from (exhibit(one, chart, drafting) for one in (bar_chart, circular_chart))


KIND = "profile"
EVERY = (1, 2, 3, 6)  # every which tabled turn is told, as the paper takes them


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cams, one for each (row of the table of sheets)."""
    return sheets(study.scene, [manufacture(one) for one in study.of(CamStudy).found])


def sheets(scene: Scene, parts: Sequence[Manufacture]) -> tuple[Leaf, ...]:
    """Lay out the sheets of cams whose profiles are found."""
    return lay_out_each([_draft(scene, one, len(parts) > 1) for one in parts])


def _draft(scene: Scene, shown: Manufacture, several: bool) -> tuple[Scene, Draft]:
    """Give the smallest format on which the profile stands at its own size with the whole table, and the draft.

    Where none takes that, the scene's own: with the draft whose figure can be read on the fewest sheets, and of its
    table as many rows as they take.
    """
    for small in _formats(scene):
        draft = _told(shown, EVERY[0], several, drafting_of(small))
        if _true(small, draft):
            return small, draft
    first, *further = (_told(shown, every, several, drafting_of(scene)) for every in EVERY)
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


def _true(scene: Scene, draft: Draft) -> bool:
    """Tell whether one sheet takes a draft with its figure at its own size, or larger."""
    try:
        composed, *further = compositions(scene, draft)
    except SheetError:  # there is not even room for its heading
        return False
    (room,) = (one.panel.item for one in draft.shows if isinstance(one.panel.item, Picture))
    natural = max(room.wide, room.high) * TRUE
    return not further and room.extent(composed.spots[room.name].scale) >= max(natural, room.least) * SMALLER


def _told(shown: Manufacture, every: int, several: bool, drafting: Drafting) -> Draft:
    title = drafting.word("cam profile sheet title") + (f" {shown.view.cam.name}" if several else "")
    figure = exhibit(manufacturing, shown, drafting)
    table = manufacturing.radii(shown.table, every, drafting)
    return Draft(
        KIND,
        title,
        (figure,),
        (table,),
        tuple(manufacturing.notes(shown.table, drafting)),
        partial(figures_facts, cam=shown.view.cam.name, every=every),
        manufacturing.PLAN,
    )
