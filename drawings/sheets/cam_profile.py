"""The sheet of a cam to be made: the working profile alone, its radii by the turn, datum, notes (чертёж кулачка)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import partial
from typing import Any

from drawings.figures.cam import manufacturing_figure, manufacturing_notes, radius_table
from drawings.figures.cam.manufacturing import Manufacture, manufacture
from drawings.layout.contents import Panel
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.leaves import Draft, Exhibit, cost, lay_out
from plans.scene.scene import Scene
from plans.study import Study

KIND = "profile"
EVERY = (1, 2, 3, 6)  # every which tabled turn is told, as the paper takes them


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cams, one for each (row of the table of sheets)."""
    return sheets(study.scene, [manufacture(one) for one in study["cam"].found])


def sheets(scene: Scene, parts: Sequence[Manufacture]) -> tuple[Leaf, ...]:
    """Lay out the sheets of cams whose profiles are found."""
    drafting = drafting_of(scene)
    return lay_out(scene, [_draft(scene, one, len(parts) > 1, drafting) for one in parts])


def _draft(scene: Scene, shown: Manufacture, several: bool, drafting: Drafting) -> Draft:
    """Give the draft whose figure can be read on the fewest sheets, with as many rows of the table as it takes."""
    drafts = [_told(shown, every, several, drafting) for every in EVERY]
    return min(drafts, key=partial(cost, scene))


def _told(shown: Manufacture, every: int, several: bool, drafting: Drafting) -> Draft:
    title = drafting.word("cam profile sheet title") + (f" {shown.view.cam.name}" if several else "")
    room = manufacturing_figure.measure(shown, drafting)
    figure = Exhibit(Panel(room), partial(manufacturing_figure.draw, shown, room, drafting=drafting))
    table = radius_table.radii(shown.table, every, drafting)
    return Draft(
        KIND,
        title,
        (figure,),
        (table,),
        tuple(manufacturing_notes.notes(shown.table, drafting)),
        partial(_facts, shown, every),
    )


def _facts(shown: Manufacture, every: int, names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which cam and which figures it shows, and every which tabled turn it tells."""
    return {"cam": shown.view.cam.name, "figures": list(names), "every": every}
