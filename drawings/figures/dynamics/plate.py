"""The plate of the graphs: one under another over one angle, beside them the loop in line with them (диаграммы).

Moments, works, surplus energy and speeds share the axis of angles; the loop stands beside the surplus energy in its
scale, and under the inertia, turned by 90 degrees, in that one's.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import NamedTuple

from drawings.figures.dynamics import loop as loop_figure
from drawings.figures.dynamics import quantities, rays, strip_graph
from drawings.figures.dynamics.curves import Dense, dense
from drawings.figures.dynamics.loop import Loop
from drawings.figures.dynamics.part import Part, caption
from drawings.figures.dynamics.strip_graph import StripGraph
from drawings.figures.dynamics.strips import Strips, strips
from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale, fitting
from drawings.paper.formats import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Stroke
from plans.model.dynamics import TURN, Cycle, Flywheel, Speeds, Task

MOMENTS, WORKS, SURPLUS, SPEEDS = 0.30, 0.40, 0.76, 0.34  # heights of the rows, in lengths of the axis of angles
WIDE = 0.82  # width of the loop, likewise
LONG = 24.0  # sizes of a letter that the axis of angles has at least: its positions are numbered
POLE = (3.5, 9.0)  # least and greatest pole distance, in sizes of a letter
LEFT, MIDDLE, RIGHT = 10.5, 9.0, 6.0  # paper beside the graphs, between them and the loop, beside it, likewise
LARGER = 1 + 1e-9  # times an extent that fits: no two standard scales lie so near
COARSER = 4  # scales tried beyond the largest: they differ by ten times
GRAPHS, ENERGY = "diagrams", "energy-mass"  # names of the plates


class Machine(NamedTuple):
    """What the plates show of a machine: its task, the account of its turn, its flywheel, its speeds."""

    task: Task
    cycle: Cycle
    flywheel: Flywheel | None = None
    speeds: Speeds | None = None
    before: Speeds | None = None


class Row(NamedTuple):
    """A row of a plate: what it shows, and its height in lengths of the axis of angles."""

    name: str
    high: float


@dataclass(frozen=True)
class Plate:
    """What stands on one plate: graphs, the loop, or both of them in line."""

    name: str
    machine: Machine
    graphs: bool
    loop: bool
    drafting: Drafting

    @property
    def hand(self) -> Hand:
        """The hand that draws."""
        return self.drafting.hand

    @cached_property
    def dense(self) -> Dense:
        """The turn followed densely."""
        return dense(self.machine.cycle)

    @cached_property
    def strips(self) -> Strips:
        """The strips of the turn."""
        return strips(self.machine.cycle, self.machine.task.divisions)

    @cached_property
    def shown(self) -> Loop:
        """The loop."""
        return Loop(self.machine.cycle, self.dense, self.strips, self.machine.flywheel)

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows from the top."""
        middle = Row(quantities.SURPLUS, SURPLUS)
        if not self.graphs:
            return Row(quantities.INERTIA, MOMENTS + WORKS), middle
        first = Row(quantities.MOMENTS, MOMENTS), Row(quantities.WORKS, WORKS)
        last = (Row(quantities.SPEEDS, SPEEDS),) if self.machine.speeds else ()
        return *first, middle if self.loop else Row(quantities.SURPLUS, WORKS), *last

    @property
    def over(self) -> float:
        """Paper over the lines of a row, mm: the end of an axis, its title."""
        return BEYOND + self.hand.title + 0.4 * self.hand.letter

    @property
    def under(self) -> float:
        """Paper under the lines of a row, mm: numbers."""
        return 2 * self.hand.number

    @property
    def beside(self) -> tuple[float, float, float]:
        """Paper on the left of the graphs, between them and the loop, on its right, mm."""
        size = self.hand.letter
        middle = (BEYOND + 2 * size if self.graphs else 0.0) + (MIDDLE * size if self.loop else 0.0)
        return LEFT * size if self.graphs else 0.0, middle, RIGHT * size + BEYOND if self.loop else 0.0

    @property
    def wide(self) -> float:
        """Width without the paper beside, in lengths of the axis of angles."""
        return (1.0 if self.graphs else 0.0) + (WIDE if self.loop else 0.0)

    @property
    def high(self) -> float:
        """Height without the paper between, likewise."""
        return sum(row.high for row in self.rows)


def measure(plate: Plate) -> Picture:
    """Measure the room of a plate; its scale is that of the angle, to which all its sizes go."""
    wide, high = TURN * plate.wide, TURN * plate.high
    between = len(plate.rows) * (plate.over + plate.under)
    margins = Margins(sum(plate.beside) / 2, 0.0, between)
    least = LONG * plate.hand.letter * max(plate.wide, plate.high)
    return Picture(plate.name, wide, high, complex(wide, high) / 2, "φ", "rad", margins, 0.0, least)


@dataclass(frozen=True)
class PlateFigure:
    """A plate placed on paper: its parts, and what joins them."""

    parts: tuple[Part, ...]
    joining: Group

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        return self.joining, *(line for part in self.parts for line in part.lines)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give all its parts, lettered."""
        return self.joining, *(part.group(labels) for part in self.parts)


def draw(plate: Plate, spot: Spot) -> PlateFigure:
    """Draw a plate in its spot."""
    return _Drawing(plate, spot).figure


@dataclass(frozen=True)
class _Drawing:
    """A plate at its scale."""

    plate: Plate
    spot: Spot

    @property
    def figure(self) -> PlateFigure:
        parts = [*self._graphs(), *self._energy()]
        return PlateFigure(tuple(parts), Group(tuple(self._joining()), "transfer"))

    @property
    def length(self) -> float:
        """The length of the axis of angles, mm."""
        return TURN / self.spot.scale.mu

    @cached_property
    def fields(self) -> dict[str, Field]:
        """The fields of the rows' lines, by what they show, as wide as the axis of angles."""
        box, plate = self.spot.box, self.plate
        left, top, fields = box.left + plate.beside[0], box.top, {}
        for row in plate.rows:
            top -= plate.over
            fields[row.name] = Field(left, top - row.high * self.length, left + self.length, top)
            top -= row.high * self.length + plate.under
        return fields

    @cached_property
    def surplus(self) -> StripGraph:
        return quantities.surplus(self.plate.machine.cycle, self.plate.dense)

    @cached_property
    def inertia(self) -> StripGraph:
        return quantities.inertia(self.plate.machine.cycle, self.plate.dense)

    @cached_property
    def energy_scale(self) -> Scale:
        """The scale of energy, which surplus and loop share."""
        low, high = self.plate.shown.up if self.plate.loop else self.surplus.span
        return self._fitting(high - low, self.fields[quantities.SURPLUS].height, "T", "J")

    @cached_property
    def inertia_scale(self) -> Scale:
        low, high = self.plate.shown.across
        return self._fitting(high - low, WIDE * self.length, "J", "kg*m2")

    @cached_property
    def integration(self) -> tuple[Scale, Scale, float]:
        """The scales of moments and works and the pole distance, mm, which follows from them."""
        size, mu = self.plate.hand.letter, self.spot.scale.mu
        pairs = product(self._steps(self.moments, "M", "N*m"), self._steps(self.works, "A", "J"))
        found = [(one, two, two.mu / (one.mu * mu)) for one, two in pairs]
        near = [one for one in found if POLE[0] * size <= one[2] <= POLE[1] * size]
        return min(near or found, key=lambda one: one[0].mu * one[1].mu)

    def _steps(self, graph: StripGraph, letter: str, unit: str) -> list[Scale]:
        """Give the largest scale of a graph that its row takes, and some smaller ones."""
        low, high = graph.span
        steps = [self._fitting(high - low, self.fields[graph.name].height, letter, unit)]
        for _ in range(COARSER):
            steps.append(self._fitting(steps[-1].mu * LARGER, 1.0, letter, unit))
        return steps

    @cached_property
    def moments(self) -> StripGraph:
        return quantities.moments(self.plate.machine.cycle, self.plate.dense)

    @cached_property
    def works(self) -> StripGraph:
        return quantities.works(self.plate.machine.cycle)

    def _fitting(self, extent: float, room: float, letter: str, unit: str) -> Scale:
        return fitting(extent, room, letter, unit, self.plate.drafting.standard)

    def _axes(self, graph: StripGraph, up: Scale) -> Axes:
        """Stand a graph in the middle of its row."""
        field = self.fields[graph.name]
        low, high = graph.span
        spare = field.height - (high - low) / up.mu
        return Axes(complex(field.left, field.bottom + spare / 2 - low / up.mu), self.spot.scale, up)

    @cached_property
    def loop_axes(self) -> Axes:
        """The axes of the loop: in line with those of the surplus energy."""
        plate, field, up = self.plate, self.fields[quantities.SURPLUS], self.energy_scale
        low, high = plate.shown.up
        spare = field.height - (high - low) / up.mu
        start = (field.right if plate.graphs else self.spot.box.left) + plate.beside[1]
        left = start - plate.shown.across[0] / self.inertia_scale.mu
        return Axes(complex(left, field.bottom + spare / 2 - low / up.mu), self.inertia_scale, up)

    @cached_property
    def surplus_axes(self) -> Axes:
        """The axes of the surplus energy: level with the loop's."""
        if not self.plate.loop:
            return self._axes(self.surplus, self.energy_scale)
        zero = complex(self.fields[quantities.SURPLUS].left, self.loop_axes.zero.imag)
        return Axes(zero, self.spot.scale, self.energy_scale)

    @cached_property
    def inertia_axes(self) -> Axes:
        """The axes of the inertia turned by 90 degrees: its angle runs down towards the loop."""
        fields = self.fields
        top = max(field.top for field in fields.values())
        bottom = fields[quantities.SURPLUS].top + self.plate.over + self.plate.under
        down = self._fitting(TURN, top - bottom - 2 * BEYOND, "φ", "rad")
        return Axes(complex(self.loop_axes.zero.real, top - BEYOND), down, self.inertia_scale, -1j, 1 + 0j)

    def _graphs(self) -> Iterator[Part]:
        """Draw the graphs over the angle."""
        if not self.plate.graphs:
            return
        moments, works, distance = self.integration
        cycle, hand = self.plate.machine.cycle, self.plate.hand
        axes = self._axes(self.moments, moments)
        yield self._graph(self.moments, axes, "reduced moments")
        yield rays.draw(cycle, axes, distance, hand)
        yield self._graph(self.works, self._axes(self.works, works), "works", f"H = {self.plate.drafting.number(distance)} {self.plate.drafting.word('mm')}")
        yield self._graph(self.surplus, self.surplus_axes, "surplus energy")
        machine = self.plate.machine
        if machine.speeds is not None:
            graph = quantities.speeds(cycle, self.plate.dense, machine.speeds)
            room = self.fields[graph.name].height
            up = self._fitting(graph.span[1] - graph.span[0], room, "ω", "rad/s")
            yield self._graph(graph, self._axes(graph, up), "speed over the turn")

    def _graph(self, graph: StripGraph, axes: Axes, title: str, more: str = "") -> Part:
        """Draw a graph with its title over it."""
        plate, drafting = self.plate, self.plate.drafting
        part = strip_graph.draw(graph, plate.strips, axes, drafting)
        scales = ";  ".join(filter(None, (drafting.scale(axes.up), drafting.scale(axes.across), more)))
        field = self.fields[graph.name]
        head = caption(complex(field.centre.real, field.top + plate.over), drafting.word(title), scales, plate.hand)
        return part._replace(lines=(head, *part.lines))

    def _energy(self) -> Iterator[Part]:
        """Draw the loop, and the inertia over it."""
        if not self.plate.loop:
            return
        plate, drafting = self.plate, self.plate.drafting
        middle = self.loop_axes.on(sum(plate.shown.across) / 2).real
        turned = strip_graph.draw(self.inertia, plate.strips, self.inertia_axes, drafting)
        scales = f"{drafting.scale(self.inertia_scale)};  {drafting.scale(self.inertia_axes.across)}"
        high = max(field.top for field in self.fields.values()) + plate.over
        head = caption(complex(middle, high), drafting.word("reduced inertia"), scales, plate.hand)
        yield turned._replace(lines=(head, *turned.lines))
        part = loop_figure.draw(plate.shown, self.loop_axes, drafting)
        scales = f"{drafting.scale(self.energy_scale)};  {drafting.scale(self.inertia_scale)}"
        place = complex(middle, self.fields[quantities.SURPLUS].top + plate.over)
        yield part._replace(lines=(caption(place, drafting.word("loop"), scales, plate.hand), *part.lines))

    def _joining(self) -> Iterator[Stroke]:
        """Draw the strip edges of jumps through the graphs, and the transfer of points into the loop."""
        hand, cycle, strips_ = self.plate.hand, self.plate.machine.cycle, self.plate.strips
        if self.plate.graphs:
            top, low = self.fields[quantities.MOMENTS], self.surplus_axes
            for k in strips_.jumps:
                across = low.on(strips_.turned[k]).real
                yield Line(complex(across, top.top), complex(across, low.on(0.0, self.surplus.span[0]).imag), hand.axis)
        if self.plate.loop:
            for k in self.plate.shown.touches:
                spot = self.loop_axes.on(float(cycle.varying[k]), float(cycle.surplus[k]))
                yield Line(self.inertia_axes.on(float(cycle.turned[k]), float(cycle.varying[k])), spot, hand.drafted)
                if self.plate.graphs:
                    yield Line(self.surplus_axes.on(float(cycle.turned[k]), float(cycle.surplus[k])), spot, hand.drafted)
