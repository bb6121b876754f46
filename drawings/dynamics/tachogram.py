"""The tachogram: the speed of the crank over time, from rest to rest, its stages marked (тахограмма)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.dynamics.report_tables import named
from drawings.kinds.axes import OVER, UNDER, Axes, Letter, Part
from drawings.kinds.graph import BESIDE, Graph, GraphForm, standing
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.words import Slot, joined, telling
from drawings.page.page import Drafting
from drawings.paper.strokes import Line, Polyline, Stroke
from drawings.symbols.figure import explained, heading
from drawings.symbols.symbols import TICK
from plans.model.run import MachineRun

NAME = "tachogram"
FORM = GraphForm(2.2, 1.8, Margins(4.0, 2.0, 2.4), 20.0)
CLOSE = 0.1  # mm: rows that lie nearer are one point of the curve
DRIFT = "Δω"  # by how much the speed changes over the last turn
STEADY = "ω_{st}"  # the mean speed of the steady motion that is reached: not the one that is asked for


def measure(run: MachineRun, drafting: Drafting) -> Picture:
    """Measure the room of a tachogram: its scale is that of time."""
    room = FORM.room(NAME, float(run.t[-1]), ("t", "s"), drafting.word("tachogram"), drafting.hand)
    return explained(room, run_lines(run, drafting), drafting.hand)


def draw(run: MachineRun, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw it in its spot: the speed over time, the ends of its stages measurable, the mean of the steady motion."""
    hand, long, most = drafting.hand, float(run.t[-1]), float(run.omega.max())
    axes = standing(room, spot, (0.0, most), ("ω", "rad/s"), drafting)
    graph, title = Graph(NAME, axes, hand), drafting.word("tachogram")
    lines = (
        telling(NAME, heading(spot.box, title, drafting.scale(spot.scale, axes.up), hand, *run_lines(run, drafting))),
        *axes.lines((0.0, long), (0.0, most), hand, NAME),
        graph.stated("ω", [Polyline(tuple(_curve(run, axes)), False, hand.result)]),
        *(stroke for k, row in enumerate(ends(run), 1) for stroke in _end(run, k, row, graph)),
        *_mean(run, graph),
    )
    axis = graph.ends((long, f"t, {drafting.word('s')}"), (most, f"ω, {drafting.word('rad/s')}"))
    return Part(NAME, lines, (*axis, *_letters(run, axes, most, drafting)))


def ends(run: MachineRun) -> tuple[int, ...]:
    """Give the rows in which the stages end."""
    return tuple(stage.last for stage in run.stages)


def run_lines(run: MachineRun, drafting: Drafting) -> tuple[str, ...]:
    """Tell the instants at which the stages end, s, and the steady speed that is reached, rad/s."""
    times = (
        joined("", (f"t_{k} = ", drafting.slot(Slot(f"t_{k}", float(run.t[row])))))
        for k, row in enumerate(ends(run), 1)
    )
    instants = joined(" ", (joined(";  ", times), drafting.word("s")))
    if run.steady is None:
        return (instants,)
    if run.drift:
        return instants, drafting.phrase("unsteady speed", drift=Slot(DRIFT, run.drift))
    numbers = {"mean": Slot(STEADY, run.steady.mean), "delta": Slot("δ", run.steady.delta)}
    return instants, drafting.phrase("steady speed", **numbers)


def _curve(run: MachineRun, axes: Axes) -> Iterator[complex]:
    """Give the points of the curve, those left out that lie close to the last one."""
    last = complex(math.inf)
    for k, (t, omega) in enumerate(zip(run.t.tolist(), run.omega.tolist(), strict=True)):
        place = axes.on(t, omega)
        if abs(place - last) > CLOSE or k in ends(run):
            yield place
            last = place


def _end(run: MachineRun, k: int, row: int, graph: Graph) -> Iterator[Stroke]:
    """Draw the end of a stage: its tick and its ordinate, which can be measured."""
    yield graph.tick(float(run.t[row]))
    yield from graph.ordinate(float(run.t[row]), float(run.omega[row]), f"t_{k}")


def _mean(run: MachineRun, graph: Graph) -> Iterator[Stroke]:
    """Draw the mean of the steady motion across the whole of it."""
    if run.steady is not None and not run.drift:
        start, end = (graph.axes.on(float(t), run.steady.mean) for t in (0.0, run.t[-1]))
        yield graph.stated(STEADY, [Line(start, end, graph.hand.axis)])


def _letters(run: MachineRun, axes: Axes, most: float, drafting: Drafting) -> Iterator[Letter]:
    """Letter the stages at their middles, the instants at which they end, the mean speed."""
    size = drafting.hand.letter
    if run.steady is not None and not run.drift:
        yield Letter(axes.on(float(run.t[-1]), run.steady.mean), drafting.letter(STEADY), size, 0.0)
    for k, stage in enumerate(run.stages):
        yield Letter(axes.on(float(run.t[stage.last])), f"t_{k + 1}", size, UNDER, TICK + BESIDE)
        middle = float(np.mean(run.t[[stage.first, stage.last]]))
        yield Letter(axes.on(middle, most / 4), named(run, stage, drafting), drafting.hand.text, OVER)
