"""Sheet 4, a cam: laws, main sizes by tangents, profile by inversion, pressure angle, table (кулачок, лист 4)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from typing import Any

from drawings.figures.cam import law_diagrams, profile_figure
from drawings.figures.cam.profile_view import profile_view
from drawings.layout.contents import Panel
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.cam_notes import CamNotes
from drawings.sheets.leaves import Caption, Draft, Exhibit, lay_out
from plans.cam.study import CamDrawing
from plans.scene.scene import Scene
from plans.study import Study

FOREMOST = 2.0  # weight of the profile, for which all the rest is drawn


def admit(scene: Scene) -> None:
    """See nothing more: whatever cam is read can be shown."""


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cams, each on sheets of its own (row of the table of sheets)."""
    scene, cams = study.scene, study["cam"].drawings.values()
    return lay_out(scene, [_draft(one, drafting_of(scene)) for one in cams])


def _draft(drawing: CamDrawing, drafting: Drafting) -> Draft:
    said = CamNotes(drawing.found, drafting).all
    title = drafting.word("cam sheet title", name=drawing.cam.name)
    return Draft("cam", title, tuple(_shows(drawing, drafting)), (), said, partial(_facts, drawing.cam.name))


def _facts(name: str, figures: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which cam it is of, and which figures it shows."""
    return {"cam": name, "figures": list(figures)}


def _shows(drawing: CamDrawing, drafting: Drafting) -> Iterator[Exhibit | Caption]:
    """Show laws and sizes in a column, the profile foremost, what it leads to beside it."""
    law = law_diagrams.measure(drawing.diagrams, drafting)
    yield Exhibit(Panel(law), partial(law_diagrams.draw, drawing.diagrams, law, drafting=drafting))
    view = profile_view(drawing.found)
    room = profile_figure.measure(view, drafting)
    yield Exhibit(Panel(room, FOREMOST), partial(profile_figure.draw, view, room, drafting=drafting))
