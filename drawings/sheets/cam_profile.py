"""The sheet of a cam to be made: the working profile alone, its radii by the turn, datum, notes (чертёж кулачка)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from functools import partial
from typing import Any

from drawings.figures.cam import manufacturing_figure, radius_table
from drawings.figures.cam.manufacturing import Manufacture, TabledProfile, manufacture
from drawings.figures.cam.outlines import SHOWN
from drawings.layout.contents import Panel
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.leaves import Draft, Exhibit, cost, lay_out
from plans.scene.scene import Scene
from plans.study import Study

KIND = "profile"
EVERY = (1, 2, 3, 6)  # every which tabled turn is told, as the paper takes them
MM = 1000.0  # of a metre
DIGITS = 5


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
    return Draft(KIND, title, (figure,), (table,), tuple(notes(shown.table, drafting)), partial(_facts, shown, every))


def _facts(shown: Manufacture, every: int, names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which cam and which figures it shows, and every which tabled turn it tells."""
    return {"cam": shown.view.cam.name, "figures": list(names), "every": every}


def notes(shown: TabledProfile, drafting: Drafting) -> Iterator[str]:
    """Say what a workshop must know beside the curve."""
    cam = shown.cam
    yield drafting.word(_moves(shown))
    curve = drafting.word("mill path" if shown.grooved else "profile told")
    yield drafting.word("plane datum" if cam.translates else "polar datum", curve=curve)
    if shown.found.roller:
        yield drafting.letter(_roller(shown, drafting))
    if not cam.translates:
        yield from _dwells(shown, drafting)
        yield drafting.word("bore of cam")
    yield drafting.word("drawn pieces", tolerance=drafting.number(MM * cam.tolerance))
    wrong = dict.fromkeys(one.kind for one in shown.found.flaws if one.kind in SHOWN)
    if wrong:
        yield drafting.word("profile flaws", flaws=", ".join(drafting.word(f"cam {kind}") for kind in wrong))


def _moves(shown: TabledProfile) -> str:
    """Name the sense in which the cam moves."""
    names = ("leftward cam", "rightward cam") if shown.cam.translates else ("counter-clockwise cam", "clockwise cam")
    return names[shown.cam.sense < 0]


def _roller(shown: TabledProfile, drafting: Drafting) -> str:
    radius = drafting.number(MM * shown.found.roller, DIGITS)
    if not shown.grooved:
        return drafting.word("roller of cam", radius=radius)
    breadth = drafting.number(2 * MM * shown.found.roller, DIGITS)
    return drafting.word("groove of cam", radius=radius, breadth=breadth)


def _dwells(shown: TabledProfile, drafting: Drafting) -> Iterator[str]:
    """Tell the radii of the arcs, and between which turns they are."""
    told = []
    for one, radius in shown.dwells():
        ends = (drafting.number(math.degrees(turn), DIGITS) for turn in (one.start, one.end))
        told.append(f"r = {drafting.number(MM * radius, DIGITS)}, φ {' … '.join(ends)}°")
    if told:
        yield drafting.word("dwells of cam", radii=";  ".join(told))
