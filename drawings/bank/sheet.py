"""The sheet of a bank: what stands on it, its tables of orders and of compensators (лист блока механизмов)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from functools import partial
from typing import Final

import numpy as np

from drawings.balance import scheme
from drawings.balance.scheme import ALONE, SCHEME, BalanceScheme, placed_weight
from drawings.bank import compensators, shaft, star
from drawings.bank.compensators import COUPLED, MASS, CompensatorLayout
from drawings.bank.diagrams import ACTING, LEFT, ROCKING, STATIONS, TurnCurve, TurnGraph, polygon_room, polygons
from drawings.bank.due import expected
from drawings.bank.report import ORDER_HEADS, BankNotes, crank_of, direction, linkage_of, order_rows, straight
from drawings.bank.star import BankView
from drawings.kinds import hodograph, polygon
from drawings.kinds.hodograph import Hodograph
from drawings.kinds.polygon import Polygon
from drawings.layout.contents import Panel
from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import COLUMNS, value_row
from drawings.layout.value_table import DIGITS as FIGURES
from drawings.lettering.words import lowered_bank
from drawings.linkage.pose import general
from drawings.linkage.positions import position_asked
from drawings.linkage.skeleton import skeletons
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import GRAPH, PLAN, SheetKind
from drawings.sheets.leaves import EQUATION, lay_out
from drawings.sheets.stated_scales import Draft, Exhibit, exhibit, figures_facts
from plans.balance.study import BalanceStudy
from plans.bank.harmonics import FORCE, MOMENT, STATIC, letters, roman
from plans.bank.harmonics import MOMENT as M
from plans.bank.quantities import bank_by_hand
from plans.bank.study import BankStudy
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.balance.bank import BankBalance, Compensator
from plans.model.motion import Complexes
from plans.quantity import EQUILIBRIUM, Comparison, Quantity
from plans.scene.scene import Scene
from plans.study import Study

ORDERS, COMPENSATORS, RESULTS = "orders", "compensators", "results"  # the names of the tables
COMPENSATOR_HEADS = ("m·r, kg·m", "m, kg", "r, mm", "shaft speed", "φ, °")
DIGITS = 5
NOTHING = "—"


def order_table(balance: BankBalance, drafting: Drafting) -> RuledTable:
    """Tell of each order what one mechanism and the bank come to."""
    lines = [TableRow(*row) for row in order_rows(balance, drafting, DIGITS)]
    heads = tuple(drafting.word(head) for head in ORDER_HEADS)
    return table(lines, drafting.word("order"), heads, drafting.hand.text)._replace(name=ORDERS, least=6)


def compensator_table(balance: BankBalance, drafting: Drafting) -> RuledTable | None:
    """Tell each mass of the compensators; None where there are none."""
    lines = [row for compensator in balance.compensators for row in _masses(compensator, balance, drafting)]
    heads = tuple(drafting.word(head) for head in COMPENSATOR_HEADS)
    if not lines:
        return None
    return table(lines, drafting.word("mass number"), heads, drafting.hand.text)._replace(name=COMPENSATORS, least=6)


def results(comparison: Comparison, by_hand: bool, drafting: Drafting) -> RuledTable | None:
    """Tell what both roads found of orders and compensators, and what a hand may be out in polygons; or None."""
    heads = tuple(drafting.word(head) for head in (COLUMNS if by_hand else COLUMNS[:-1]))
    # What the table tells: vectors of the bank and masses, more than rounding.
    kept = [one for one in comparison.findings if one.name.partition("_")[0] in (FORCE, MOMENT, STATIC)]
    told = [one for one in kept if one.plan != EQUILIBRIUM and abs(one.analysis[0]) > one.allowed[0]]
    lines = [_result(quantity, drafting) for quantity in told]
    lines = [line._replace(cells=line.cells[: len(heads)]) for line in lines]
    if not lines:
        return None
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=RESULTS, least=6)


def _result(quantity: Quantity, drafting: Drafting) -> TableRow:
    """Give the row of a finding: values to their own digits, as orders differ by powers."""
    known = float(quantity.allowed[0]) * 10 ** (FIGURES - 1)
    sized = quantity._replace(largest=max(float(abs(quantity.analysis[0])), known))  # rounding has no digits
    return value_row(sized, f"{lowered_bank(quantity.name)}, {drafting.word(quantity.unit)}", (0,), drafting.language)


def _masses(compensator: Compensator, balance: BankBalance, drafting: Drafting) -> Iterator[TableRow]:
    """Give the rows of the masses that are needed."""
    order, mass, speed = compensator.asked.order, compensator.asked.mass, balance.task.speed
    slack = balance.forces[order].slack / (order * speed) ** 2
    for signed, moment, angle in compensator.masses:
        far, way = None if mass is None else 1000 * moment / mass, direction(cmath.rect(moment, angle), slack)
        yield TableRow(lowered_bank(letters(MASS, signed)), _cells((moment, mass, far, signed * speed, way), drafting))
    if compensator.couple_angle is not None:
        moment = max(compensator.with_crank, compensator.against)
        angle = direction(cmath.rect(moment, compensator.couple_angle), slack)
        cells = _cells((compensator.couple, None, None, order * speed, angle), drafting)
        yield TableRow(lowered_bank(f"{COUPLED}{roman(order)}"), cells)


def _cells(values: Sequence[float | None], drafting: Drafting) -> tuple[str, ...]:
    return tuple(NOTHING if value is None else drafting.number(value, DIGITS) for value in values)


AFTER = "'"  # behind the letter of what is left
LARGEST = 3.0  # times the least size at which it is legible: no hodograph dwarfs the polygons
LIKE = 0.3  # of the force before: what is left is drawn to the same scale, unless it is much less


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's bank."""
    return sheets(study.scene, view_of(study), study.comparison("bank"), scheme_of(study))


def scheme_of(study: Study) -> BalanceScheme | None:
    """Give the linkage that the bank is of, in one position with its counterweights; of one told by sizes none."""
    if study.of(BankStudy).task.unit is not None:
        return None
    linkage, motion = study.of(LinkageStudy), study.of(MotionComparison).construction
    asked, paths = position_asked(linkage), [point.r for point in motion.points.values()]
    bones = skeletons(linkage, motion, int(np.nanargmax(general(paths))) if asked is None else asked)
    found = study.of(BalanceStudy).balance.counterweights if study.scene.has(("balance",)) else ()
    return BalanceScheme(ALONE, bones, (), {}, tuple(placed_weight(one, bones) for one in found if one.needed))


def view_of(study: Study) -> BankView:
    """Give what the sheets of a scene's bank show."""
    bank = study.of(BankStudy)
    drawing = bank.drawing
    return BankView(bank.balance, {FORCE: drawing.forces, M: drawing.moments}, crank_of(study), linkage_of(study))


def sheets(scene: Scene, shown: BankView, comparison: Comparison, linkage: BalanceScheme | None) -> tuple[Leaf, ...]:
    """Lay out the sheets of a bank."""
    drafting = drafting_of(scene)
    orders = tuple(_polygon(polygon, drafting) for polygon in polygons(shown, drafting))
    thin = set(shaft.named(shown)) == {0.0}  # all stand in one plane: there is nothing to be seen across
    views = [exhibit(kind, shown, drafting, scale=shaft.VIEWS) for kind in ((star,) if thin else (star, shaft))]
    shows = (*views, *orders, *_courses(shown, drafting))
    shows += tuple(_layouts(shown, drafting))
    facts = figures_facts
    if linkage is not None:
        room = scheme.measure(linkage, linkage.points, drafting)
        shows = (Exhibit(Panel(room), partial(scheme.draw, linkage, room, drafting=drafting)), *shows)
        facts = partial(figures_facts, position=linkage.shown)
    writers = order_table, compensator_table
    tables = [*(write(shown.balance, drafting) for write in writers), results(comparison, bool(orders), drafting)]
    notes = BankNotes(shown.balance, drafting, shown.linkage).all
    title = drafting.word("bank sheet title")
    there = tuple(written for written in tables if written is not None)
    later = partial(bank_by_hand, comparison.findings)
    return lay_out(scene, [Draft("bank", title, shows, there, notes, facts, narrow=EQUATION, later=later)])


def _polygon(shown: Polygon, drafting: Drafting) -> Exhibit:
    room = polygon_room(shown, drafting)
    return Exhibit(Panel(room), partial(polygon.draw, shown, room, drafting=drafting))


def _courses(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    """Show force and moment over a turn: along the guides, or by their hodographs where they leave that line."""
    if shown.shaken:
        yield from (_force_graph if shown.straight else _force_hodographs)(shown, drafting)
    if shown.rocked:
        yield _moment(shown, drafting)


def _force_graph(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    balance, compensated = shown.balance, shown.compensated
    force = TurnCurve(ACTING, FORCE, shown.along(balance.force).real, "relative" if compensated else "result")
    left = (TurnCurve(LEFT, FORCE + AFTER, shown.along(balance.left).real),) if compensated else ()
    graph = TurnGraph("force_graph", drafting.word("bank force title"), FORCE, "N", (force, *left))
    yield exhibit(TurnGraph, graph, drafting)


def _moment(shown: BankView, drafting: Drafting) -> Exhibit:
    values = shown.balance.moment
    if not straight(values, values):
        return _hodograph(ROCKING, M, "N*m", shown.on_sheet(values), drafting)
    curve = TurnCurve(ROCKING, M, shown.along(values).real)
    graph = TurnGraph("moment_graph", drafting.word("bank moment title"), M, "N*m", (curve,))
    return exhibit(TurnGraph, graph, drafting)


def _force_hodographs(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    before, after = shown.on_sheet(shown.balance.force), shown.on_sheet(shown.balance.left)
    scale = ACTING if float(np.abs(after).max()) >= LIKE * float(np.abs(before).max()) else ""
    yield _hodograph(ACTING, FORCE, "N", before, drafting, scale)
    if shown.compensated and shown.lasting:
        yield _hodograph(LEFT, FORCE + AFTER, "N", after, drafting, scale)


def _hodograph(name: str, letter: str, unit: str, values: Complexes, drafting: Drafting, scale: str = "") -> Exhibit:
    turn = values[:-1]
    ends, title = turn[:: len(turn) // STATIONS], drafting.word(f"hodograph of {name}")
    figure = Hodograph(letter, letter.rstrip(AFTER), unit, turn, ends, 0, name, title, 360 // STATIONS)
    return exhibit(hodograph, figure, drafting, LARGEST, scale=scale)


def _layouts(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the compensators of every order that needs some."""
    for found in shown.balance.compensators:
        layout = CompensatorLayout(found, shown.turn, shown.balance.task.speed)
        if any(layout.weights()):
            yield exhibit(compensators, layout, drafting)


POLYGONS: Final = {"order_forces-": "force", "order_moments-": "moment"}
SCALES: Final = dict.fromkeys((SCHEME, "star", "shaft"), "scheme") | POLYGONS
PLANS = (*SCALES, "force_hodograph", "moment_hodograph")
FORM: Final = dict.fromkeys(PLANS, PLAN) | dict.fromkeys(("force_graph", "moment_graph"), GRAPH)
TABLES = ("orders", "compensators", "results")
SHEETS: Final = {"bank": SheetKind(leaves, expected, SCALES, figures=FORM, tables=TABLES)}
