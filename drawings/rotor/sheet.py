"""The sheet of a rotor: what stands on it, its tables of masses and of results (лист ротора)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Final, TypeAlias

from drawings.kinds import polygon
from drawings.kinds.polygon import Polygon
from drawings.layout.contents import Panel
from drawings.layout.table import Later, RuledTable, TableRow, table
from drawings.layout.value_table import COLUMNS, value_row
from drawings.lettering.rotor_letters import index, lowered
from drawings.page.page import Drafting, Field, drafting_of
from drawings.paper.strokes import Group, Leaf
from drawings.rotor import across, along
from drawings.rotor.due import expected
from drawings.rotor.polygon import polygon as rotor_polygon
from drawings.rotor.polygon import rotor_view
from drawings.rotor.report import RotorNotes
from drawings.sheets.kind import PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, captions, exhibit, figures_facts
from plans.model.rotor import Correction, Rotor, RotorBalance
from plans.quantity import EQUILIBRIUM, Comparison, Quantity, by_hand
from plans.rotor.study import RotorStudy
from plans.study import Study

MASSES, RESULTS = "masses", "results"  # the names of the tables
HEADINGS = ("m, kg", "D, mm", "φ, °", "h, mm", "m·D, kg·m", "m·D·h, kg·m²")
FLAT = ("m, kg", "D, mm", "φ, °", "m·D, kg·m")  # where every arm is zero
DIGITS = 5
NOTHING = "—"


def masses(rotor: Rotor, balance: RotorBalance, drafting: Drafting) -> RuledTable:
    """Tell the masses of a rotor, then its counterweights."""
    rows: list[tuple[str, Values]] = [
        (mass.name, (mass.mass, mass.radius, float(mass.angle), rotor.arm(mass.place), mass.moment))
        for mass in rotor.masses
    ]
    rows += [_correction(rotor, weight, drafting) for weight in balance.corrections]
    flat = not any(arm for _, (_, _, _, arm, _) in rows)
    lines = [_row(name, values, flat, drafting) for name, values in rows]
    return _table(MASSES, lines, "mass number", FLAT if flat else HEADINGS, drafting)


# Mass kg, radius m, angle in degrees, arm m, static moment kg*m.
Values: TypeAlias = tuple[float | None, float | None, float | None, float, float]


def _correction(rotor: Rotor, weight: Correction, drafting: Drafting) -> tuple[str, Values]:
    moment, arm = weight.moment, rotor.arm(weight.plane.place)
    return index(weight.plane.name, drafting.language), (weight.mass, weight.radius, moment.angle, arm, moment.size)


def _row(name: str, values: Values, flat: bool, drafting: Drafting) -> TableRow:
    mass, radius, angle, arm, moment = values
    far = None if radius is None else 1000 * radius
    cells = (mass, far, angle, moment) if flat else (mass, far, angle, 1000 * arm, moment, moment * arm)
    return TableRow(name, tuple(NOTHING if cell is None else drafting.number(cell, DIGITS) for cell in cells))


def results(comparison: Comparison, drafting: Drafting) -> RuledTable:
    """Tell what both roads found, and what a hand may be out."""
    return _table(RESULTS, [_line(found, drafting) for found in compared(comparison)], "quantity", COLUMNS, drafting)


def compared(comparison: Comparison) -> list[Quantity]:
    """List what the table of results tells."""
    return [finding for finding in comparison.findings if finding.plan != EQUILIBRIUM and finding.largest > 0]


def _line(finding: Quantity, drafting: Drafting) -> TableRow:
    """Give the row of a finding; what vanishes is 0 by both roads."""
    head, _, after = finding.name.partition("'")
    prime = "'" if finding.name.endswith("'") else after
    name = f"{lowered(head, drafting.language)}{prime}, {drafting.word(finding.unit)}"
    line = value_row(finding, name, (0,), drafting.language)
    if max(abs(finding.construction[0]), abs(finding.analysis[0])) <= finding.allowed[0]:
        return line._replace(cells=("0", "0", line.cells[-1]))
    return line


def _table(name: str, lines: list[TableRow], first: str, heads: tuple[str, ...], drafting: Drafting) -> RuledTable:
    words = tuple(drafting.word(head) for head in heads)
    return table(lines, drafting.word(first), words, drafting.hand.text)._replace(name=name, least=6)


TOGETHER = "polygons"  # what stands in one column


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's rotor."""
    rotor, comparison, drafting = study.of(RotorStudy), study.comparison("rotor"), drafting_of(study.scene)
    polygons = tuple(_polygons(rotor, drafting))
    table = results(comparison, drafting)
    panel = Panel(table.block(table.name), together=TOGETHER)
    shows: tuple[Exhibit | Caption, ...] = (
        *(exhibit(polygon, figure, drafting, together=TOGETHER) for figure in polygons),
        Caption(panel, partial(_written, table, drafting), waits=True),
        *_views(rotor, drafting),
        *captions(figure.working(drafting) for figure in polygons),
    )
    tables = (masses(rotor.rotor, rotor.balance, drafting),)
    said = RotorNotes(rotor.rotor, rotor.balance, drafting).all
    title = drafting.word("rotor sheet title")
    later = partial(by_hand, comparison.findings)
    return lay_out(study.scene, [Draft("rotor", title, shows, tables, said, figures_facts, later=later)])


def _views(rotor: RotorStudy, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the rotor along its shaft; across it too, unless it is a thin disc in the plane of correction."""
    shown = rotor_view(rotor.rotor, rotor.balance)
    if shown.bearings or len(set(shown.places)) != 1:  # not thin
        yield exhibit(across, shown, drafting)
    yield exhibit(along, shown, drafting)


def _polygons(rotor: RotorStudy, drafting: Drafting) -> Iterator[Polygon]:
    """Give the polygon of moments, if a second plane asks for it, then that of static moments."""
    drawing = rotor.drawing
    names = frozenset(placed.mark.name for placed in drawing.corrections[:-1])
    for construction in (drawing.moments, drawing.forces) if rotor.rotor.dynamic else (drawing.forces,):
        yield rotor_polygon(construction, names, drafting)


def _written(table: RuledTable, drafting: Drafting, box: Field, write: Callable[[Later], str]) -> Group:
    return table.filled(write).write(box, drafting)


SCALES: Final = {"across": "rotor", "along": "rotor", "unbalances": "unbalance", "couples": "couple"}
FORM: Final = dict.fromkeys(SCALES, PLAN)
SHEETS: Final = {"rotor": SheetKind(leaves, expected, SCALES, figures=FORM, tables=(MASSES, RESULTS))}
