"""The sheet of a cyclogram, and its table of characteristic positions (лист циклограммы)."""

from __future__ import annotations

import math
from functools import partial
from typing import Final

from drawings.cyclogram import characteristic_plan
from drawings.cyclogram.due import expected
from drawings.cyclogram.notes import CyclogramNotes
from drawings.kinds import bar_chart, circular_chart
from drawings.kinds.bar_chart import Chart
from drawings.kinds.course import PLACES
from drawings.layout.contents import Panel
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.words import fixed
from drawings.linkage.positions import of_linkage
from drawings.linkage.skeleton import skeletons
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import FRAME, GRAPH, PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, exhibit, figures_facts
from plans.cyclogram.quantities import CyclogramComparison
from plans.cyclogram.rows import rows_of
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.model.cyclogram import Cyclogram, Position
from plans.study import Study

NAME = "stations"
HEADS, SWINGS = ("S, mm", "φ, °"), ("ψ, °", "φ, °")


def characteristic(comparison: CyclogramComparison, drafting: Drafting) -> RuledTable:
    """Tell all characteristic positions, in whose two decimals the roads agree."""
    found = comparison.construction
    rows = enumerate(found.positions)
    lines = [TableRow(name(k, position, drafting), cells(position, found, drafting)) for k, position in rows]
    heads = tuple(drafting.word(head) for head in (HEADS if found.sliding else SWINGS))
    first = drafting.word("characteristic position")
    return table(lines, first, heads, drafting.hand.text)._replace(name=NAME, least=len(lines))


def cells(position: Position, found: Cyclogram, drafting: Drafting) -> tuple[str, ...]:
    """Write where the tool is in a characteristic position, in mm or of a swing in degrees, and the shaft's turn."""
    gone = position.share * (1000 * found.stroke if found.sliding else math.degrees(found.stroke))
    turned = round(math.degrees(position.turned), PLACES) % 360
    return tuple(fixed(value, drafting.language, PLACES) for value in (gone, turned))


def name(k: int, position: Position, drafting: Drafting) -> str:
    """Write the number of a position and what it is."""
    return f"{k}  {drafting.word(f'role {position.role}')}"


FOREMOST = 1.5  # the plan is the figure from which angles are read


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cyclogram."""
    whole, drafting = study.of(CyclogramStudy), drafting_of(study.scene)
    bones = skeletons(whole.pictured, whole.pictured.motion(0), characteristic_plan.shown_of(whole.cyclogram))
    room = characteristic_plan.measure(bones, drafting)
    draw = partial(characteristic_plan.draw, whole, bones, room, drafting=drafting)
    plan = Exhibit(Panel(room, FOREMOST), draw)
    turned = tuple(position.turned for position in whole.cyclogram.positions)  # from the first extreme
    chart = Chart(rows_of(whole.cyclogram, whole.cams), whole.cyclogram.sense, turned, turned[0])
    charts = [exhibit(kind, chart, drafting) for kind in (bar_chart, circular_chart)]
    written = characteristic(study.of(CyclogramComparison), drafting)
    stations = Caption(Panel(written.block(written.name)), partial(written.write, drafting=drafting))
    said = CyclogramNotes(whole.cyclogram, whole.cams, drafting).all
    title = drafting.word("cyclogram sheet title")
    facts = partial(figures_facts, characteristic=characteristic_plan.shown_of(whole.cyclogram))
    return lay_out(study.scene, [Draft(CYCLOGRAM, title, (plan, *charts, stations), (), said, facts)])


FORM: Final = {"characteristic": FRAME, "bars": GRAPH, "circle": PLAN}
SCALES: Final = {"characteristic": "length"}
SHEETS: Final = {"cyclogram": SheetKind(leaves, expected, SCALES, of_linkage, figures=FORM, tables=(NAME,))}
