"""Sheet 5, a bank of mechanisms: its shaft, polygons of every order, graphs, compensators (взаимоуравновешивание)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from functools import partial
from typing import Any

import numpy as np

from drawings.figures.bank import bank_polygon, bank_table, compensators, shaft, star, turn_graph
from drawings.figures.bank.bank_view import BankView
from drawings.figures.bank.compensator_layout import Layout
from drawings.figures.bank.turn_graph import FORCE, LEFT, TurnCurve, TurnGraph
from drawings.figures.bank.turn_graph import MOMENT as MOMENTS
from drawings.figures.graphs import hodograph
from drawings.figures.graphs.hodograph import Hodograph
from drawings.layout import value_table
from drawings.layout.contents import Panel
from drawings.layout.picture import Spot
from drawings.layout.table import Later
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.agreement import agreed
from drawings.report.balance.bank_notes import BankNotes, crank_of, straight
from drawings.sheets.leaves import EQUATION, lay_out
from drawings.sheets.stated_scales import Draft, Exhibit
from plans.bank.letters import FORCE as F
from plans.bank.letters import MOMENT as M
from plans.bank.study import BankStudy
from plans.checks.comparison import Comparison
from plans.checks.hand.bank import bank_by_hand
from plans.model.motion import Complexes
from plans.scene.scene import Scene
from plans.study import Study

AFTER = "'"  # behind the letter of what is left
LIKE = 0.3  # of the force before: what is left is drawn to the same scale, unless it is much less


def admit(scene: Scene) -> None:
    """See nothing more: a bank's author names nothing, and any number of mechanisms can be shown."""


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's bank (row of the table of sheets)."""
    return sheets(study.scene, study["bank"], view_of(study), study.comparison("bank"))


def view_of(study: Study) -> BankView:
    """Give what the sheets of a scene's bank show."""
    bank = study["bank"]
    drawing = bank.drawing
    return BankView(bank.balance, {F: drawing.forces, M: drawing.moments}, crank_of(study))


def sheets(scene: Scene, bank: BankStudy, shown: BankView, comparison: Comparison) -> tuple[Leaf, ...]:
    """Lay out the sheets of a bank."""
    drafting = drafting_of(scene)
    polygons = tuple(_polygons(shown, drafting))
    shows = (*_views(shown, drafting), *polygons, *_courses(shown, drafting))
    shows += tuple(_layouts(shown, drafting))
    told = bank_table.orders, bank_table.compensators
    tables = [
        *(write(shown.balance, drafting) for write in told),
        bank_table.results(comparison, bool(polygons), drafting),
    ]
    notes = *BankNotes(shown.balance, drafting).all, *agreed(bank_table.compared(comparison), drafting, bool(polygons))
    title = drafting.word("bank sheet title")
    there = tuple(one for one in tables if one is not None)
    later = partial(_later, bank, drafting)
    return lay_out(scene, [Draft("bank", title, shows, there, notes, _facts, narrow=EQUATION, later=later)])


def _later(bank: BankStudy, drafting: Drafting, spots: Mapping[str, Spot]) -> Callable[[Later], str]:
    """Write what a hand may be out in the polygons, at their scales."""
    scales = {name: spot.scale.mu for name, spot in spots.items()}
    return value_table.by_hand(bank_by_hand(bank, scales), drafting.language)


def _facts(names: Collection[str]) -> dict[str, Any]:
    """Say in the data of a sheet which figures it shows."""
    return {"figures": list(names)}


def _views(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the bank along its shaft; across it too, unless all mechanisms stand in one plane."""
    room = star.measure(shown, drafting)
    yield Exhibit(Panel(room), partial(star.draw, shown, room, drafting=drafting))
    if not shaft.is_thin(shown):
        room = shaft.measure(shown, drafting)
        yield Exhibit(Panel(room), partial(shaft.draw, shown, room, drafting=drafting))


def _polygons(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the polygons of every order whose vectors do not vanish."""
    for one in map(bank_polygon.told_apart, shown.shown()):
        if one.vectors:
            room = bank_polygon.measure(one, drafting)
            yield Exhibit(Panel(room), partial(bank_polygon.draw, one, room, drafting=drafting))


def _courses(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    """Show force and moment over a turn: along the guides, or by their hodographs where they leave that line."""
    if shown.shaken:
        yield from (_force_graph if shown.straight else _force_hodographs)(shown, drafting)
    if shown.rocked:
        yield _moment(shown, drafting)


def _force_graph(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    balance, compensated = shown.balance, shown.compensated
    force = TurnCurve(FORCE, F, balance.force.real, "relative" if compensated else "result")
    left = (TurnCurve(LEFT, F + AFTER, balance.left.real),) if compensated else ()
    yield _graph(TurnGraph("force_graph", drafting.word("bank force title"), F, "N", (force, *left)), drafting)


def _moment(shown: BankView, drafting: Drafting) -> Exhibit:
    values = shown.balance.moment
    if not straight(values, values):
        return _hodograph(MOMENTS, M, "N*m", shown.on_sheet(values), drafting)
    curve = TurnCurve(MOMENTS, M, values.real)
    return _graph(TurnGraph("moment_graph", drafting.word("bank moment title"), M, "N*m", (curve,)), drafting)


def _graph(graph: TurnGraph, drafting: Drafting) -> Exhibit:
    room = turn_graph.measure(graph, drafting)
    return Exhibit(Panel(room), partial(turn_graph.draw, graph, room, drafting=drafting))


def _force_hodographs(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    before, after = shown.on_sheet(shown.balance.force), shown.on_sheet(shown.balance.left)
    scale = FORCE if float(np.abs(after).max()) >= LIKE * float(np.abs(before).max()) else ""
    yield _hodograph(FORCE, F, "N", before, drafting, scale)
    if shown.compensated and shown.lasting:
        yield _hodograph(LEFT, F + AFTER, "N", after, drafting, scale)


def _hodograph(name: str, letter: str, unit: str, values: Complexes, drafting: Drafting, scale: str = "") -> Exhibit:
    """Show a hodograph."""
    turn = values[:-1]
    ends, title = turn[:: len(turn) // turn_graph.STATIONS], drafting.word(f"hodograph of {name}")
    one = Hodograph(letter, letter.rstrip(AFTER), unit, turn, ends, 0, title)
    room = hodograph.measure(one, name, drafting)
    return Exhibit(Panel(room, scale=scale), partial(hodograph.draw, one, room, drafting=drafting))


def _layouts(shown: BankView, drafting: Drafting) -> Iterator[Exhibit]:
    """Show the compensators of every order that needs some."""
    for found in shown.balance.compensators:
        one = Layout(found, shown.turn)
        if any(one.weights()):
            room = compensators.measure(one, drafting)
            yield Exhibit(Panel(room), partial(compensators.draw, one, shown.task.speed, room, drafting=drafting))
