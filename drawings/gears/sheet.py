"""The sheet of a gear train: scheme, velocity triangles, plan of angular velocities, tables (лист)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import Final

from drawings.gears import angular, linear
from drawings.gears.angular import ShownAngular
from drawings.gears.due import expected, label
from drawings.gears.linear import ShownLinear
from drawings.gears.notes import DIGITS, GearsNotes
from drawings.gears.routing import routed
from drawings.gears.scheme import TrainScheme
from drawings.gears.synthesis import SOLUTIONS, solutions
from drawings.layout.contents import Panel
from drawings.layout.table import Later, RuledTable, TableRow, table
from drawings.layout.value_table import COLUMNS, value_row
from drawings.lettering.gear_letters import link_letters
from drawings.lettering.lettering import text_width
from drawings.page.page import Drafting, Field, drafting_of
from drawings.paper.strokes import Group, Leaf, Text
from drawings.sheets.kind import PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, exhibit, figures_facts
from plans.analytic.gears import TrainSpeeds
from plans.gears.kutzbach import ANGULAR, LINES
from plans.gears.quantities import GearsComparison, tabled
from plans.gears.study import GEARS, GearsStudy
from plans.model.gears import BoxGear
from plans.quantity import by_hand
from plans.study import Study

SPEEDS, RESULTS = "speeds", "results"  # the tables


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's gear train."""
    train, comparison, drafting = study.of(GearsStudy), study.of(GearsComparison), drafting_of(study.scene)
    values = results(comparison, drafting)
    shows: tuple[Exhibit | Caption, ...] = (
        *_figures(train, drafting),
        Caption(Panel(values.block(RESULTS)), partial(_written, values, drafting), waits=True),
    )
    said = GearsNotes(train, comparison.analysis, drafting).all
    later = partial(by_hand, comparison.findings)
    title, scaled = drafting.word("gears sheet title"), train.plans[0].linear.subject
    size, tables = drafting.hand.text, [speeds(comparison.analysis, drafting)]
    tables += [solutions(train.searched, drafting)] if train.searched else []
    # No formula is broken
    narrow = size + max(text_width(Text(0j, note, size)) for note in said if note[0] in "Uωη")
    draft = Draft(GEARS, title, shows, (*tables,), said, figures_facts, scaled, narrow, later=later)
    return lay_out(study.scene, [draft])


def _figures(study: GearsStudy, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the scheme beside the plans of the first gear, then the plans of the others at the same scales."""
    scheme = TrainScheme(study.train, routed(study.train), study.spots)
    for k, plan in enumerate(study.plans):
        titles = ("gears linear" if k == 0 else "gears linear alone", "gears angular")
        over, under = (_title(key, plan.gear, drafting) for key in titles)
        triangles = ShownLinear(plan.linear.subject, over, plan, scheme, k == 0)
        yield exhibit(linear, triangles, drafting, scale=LINES)
        speeds = ShownAngular(plan.angular.subject, under, plan)
        yield exhibit(angular, speeds, drafting, scale=ANGULAR)


def _title(key: str, gear: BoxGear, drafting: Drafting) -> str:
    title = drafting.word(key)
    return drafting.word("gears in gear", title=title, gear=gear.name) if gear.name else title


def results(comparison: GearsComparison, drafting: Drafting) -> RuledTable:
    """Tell angular velocities and ratios by plan and by analysis, and what a hand may be out."""
    lines = [value_row(one, label(one, drafting), (0,), drafting.language) for one in tabled(comparison)]
    heads = tuple(drafting.word(key) for key in COLUMNS)
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=RESULTS, least=6)


def speeds(found: TrainSpeeds, drafting: Drafting) -> RuledTable:
    """Tell the speeds of all links in each gear, as shares of the driving one exactly where there is one."""
    drive = found.train.drives[0][0]
    heads = ["gears n", "gears share"] if found.train.single else ["gears n"]
    words = [(gear, drafting.word(key, drive=drive)) for gear in found.train.gears for key in heads]
    titles = tuple(drafting.word("gears of", gear=gear.name, head=head) if gear.name else head for gear, head in words)
    lines = [TableRow(link_letters(link), tuple(_cells(found, link, drafting))) for link in found.train.links]
    return table(lines, drafting.word("gears link"), titles, drafting.hand.text)._replace(name=SPEEDS)


def _cells(found: TrainSpeeds, link: str, drafting: Drafting) -> Iterator[str]:
    for gear in found.train.gears:
        yield drafting.number(found.true(gear)[link] * 30 / math.pi, DIGITS)
        if found.train.single:
            yield str(found.shares(gear)[link][0]).replace("-", "−")


def _written(table: RuledTable, drafting: Drafting, box: Field, write: Callable[[Later], str]) -> Group:
    return table.filled(write).write(box, drafting)


FORM: Final = {LINES: PLAN, ANGULAR: PLAN}
SCALES: Final = {LINES: "gears", ANGULAR: "speeds"}
SHEETS: Final = {GEARS: SheetKind(leaves, expected, SCALES, figures=FORM, tables=(SPEEDS, RESULTS, SOLUTIONS))}
