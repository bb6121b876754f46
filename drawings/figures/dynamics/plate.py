"""The plate of the graphs: one under another over one angle, beside them the loop in line with them (диаграммы).

Moments, works, surplus energy and speeds share the axis of angles; the loop stands beside the surplus energy in its
scale, and under the inertia, turned by 90 degrees, in that one's.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import NamedTuple

from drawings.figures.dynamics import equations, quantities, rays, strip_graph
from drawings.figures.dynamics import loop as loop_figure
from drawings.figures.dynamics.curves import Dense, dense
from drawings.figures.dynamics.loop import Loop
from drawings.figures.dynamics.part import Part, caption, wide
from drawings.figures.dynamics.strip_graph import StripGraph
from drawings.figures.dynamics.strips import Strips, strips
from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.extent import bounds
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale, fitting
from drawings.paper.formats import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Polyline, Stroke
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.trimming import trim
from plans.model.dynamics import TURN, Account, Cycle, Task

MOMENTS, WORKS, SURPLUS, SPEEDS = 0.30, 0.40, 0.76, 0.34  # heights of the rows, in lengths of the axis of angles
WIDE = 0.86  # width of the loop, likewise
LONG = 24.0  # sizes of a letter that the axis of angles has at least: its positions are numbered
POLE = (3.5, 9.0)  # least and greatest pole distance, in sizes of a letter
LEFT, MIDDLE, RIGHT = 10.0, 8.0, 5.4  # paper beside the graphs, between them and the loop, beside it, likewise
LARGER = 1 + 1e-9  # times an extent that fits: no two standard scales lie so near
TITLES = ("reduced moments", "works", "surplus energy", "speed over the turn", "loop")
CLEAR = 1.5  # mm around a caption
FIRST = (quantities.SURPLUS, quantities.WORKS, quantities.MOMENTS, quantities.SPEEDS)  # what is enlarged first
COARSER = 4  # scales tried beyond the largest: they differ by ten times
GRAPHS, ENERGY = "diagrams", "energy-mass"  # names of the plates


class Row(NamedTuple):
    """A row of a plate: what it shows, and its height in lengths of the axis of angles."""

    name: str
    high: float


@dataclass(frozen=True)
class Plate:
    """What stands on one plate: graphs, the loop, or both of them in line."""

    name: str
    task: Task
    account: Account
    graphs: bool
    loop: bool
    drafting: Drafting

    @property
    def hand(self) -> Hand:
        """The hand that draws."""
        return self.drafting.hand

    @property
    def cycle(self) -> Cycle:
        """The account of the steady turn."""
        assert self.account.cycle is not None  # without one there is nothing to draw over the turn
        return self.account.cycle

    @cached_property
    def dense(self) -> Dense:
        """The turn followed densely."""
        return dense(self.cycle)

    @cached_property
    def strips(self) -> Strips:
        """The strips of the turn."""
        return strips(self.cycle, self.task.divisions)

    @cached_property
    def shown(self) -> Loop:
        """The loop."""
        return Loop(self.cycle, self.dense, self.strips, self.account.flywheel)

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows from the top."""
        middle = Row(quantities.SURPLUS, SURPLUS)
        if not self.graphs:
            return Row(quantities.INERTIA, MOMENTS + WORKS), middle
        first = Row(quantities.MOMENTS, MOMENTS), Row(quantities.WORKS, WORKS)
        last = (Row(quantities.SPEEDS, SPEEDS),) if self.account.speeds else ()
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
    def below(self) -> float:
        """Paper under the last row, mm: for the equations of the loop, where they do not stand beside a row."""
        written = self.account.flywheel is not None and self.loop and not (self.graphs and self.account.speeds)
        return equations.height(self.drafting) if written else 0.0

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
    margins = Margins(sum(plate.beside) / 2, plate.below, between)
    least = max(LONG * plate.hand.letter, _longest(plate)) * max(plate.wide, plate.high)
    return Picture(plate.name, wide, high, complex(wide, high) / 2, "φ", "rad", margins, 0.0, least)


def _longest(plate: Plate) -> float:
    """Give the length of the axis of angles beside whose end the captions of the graphs have room, mm."""
    drafting = plate.drafting
    scales = f"{drafting.scale(Scale(0.025, 'J', 'kg*m2'))};  {drafting.scale(Scale(0.025, 'φ', 'rad'))}"
    longest = max(wide(drafting.word(title), scales, plate.hand) for title in TITLES)
    return longest - BEYOND - 2 * plate.hand.letter


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
        masks = [_mask(part.lines[0]) for part in parts if part.name != rays.NAME]
        joining = fit_dashes(trim(self._joining(), masks))
        return PlateFigure((*parts, *self._equations()), Group(tuple(joining), "transfer"))

    def _equations(self) -> Iterator[Part]:
        """Write under the loop what it gives."""
        wheel = self.plate.account.flywheel
        if self.plate.loop and wheel is not None:
            left = self.loop_axes.zero.real - loop_figure.TAIL * self.plate.hand.letter
            corner = complex(left, self.fields[quantities.SURPLUS].bottom - 2 * self.plate.under)
            yield Part(equations.NAME, (equations.write(wheel, self.loop_axes, corner, self.plate.drafting),), ())

    @property
    def length(self) -> float:
        """The length of the axis of angles, mm."""
        return TURN / self.spot.scale.mu

    @cached_property
    def fields(self) -> dict[str, Field]:
        """The fields of the rows' lines, by what they show, as wide as the axis of angles."""
        box, plate = self.spot.box, self.plate
        left, top, fields = box.left + plate.beside[0], box.top, {}
        for name, high in self.heights.items():
            top -= plate.over
            fields[name] = Field(left, top - high, left + self.length, top)
            top -= high + plate.under
        return fields

    @cached_property
    def heights(self) -> dict[str, float]:
        """The heights of the rows, mm: what one leaves at its scale goes to the loop first, then to the others."""
        rooms = {row.name: row.high * self.length for row in self.plate.rows}
        found = {name: self._filled(name, room) for name, room in rooms.items()}
        for name in FIRST:
            if name in found:
                spare = sum(rooms.values()) - sum(found.values())
                found[name] = self._filled(name, found[name] + spare)
        spare = sum(rooms.values()) - sum(found.values())
        return {name: high + spare / len(found) for name, high in found.items()}

    def _filled(self, name: str, room: float) -> float:
        """Give how much of a room the values of a row fill at a standard scale, mm."""
        low, high = self.spans[name]
        return room if high == low else (high - low) / self._fitting(high - low, room, "", "").mu

    @cached_property
    def spans(self) -> dict[str, tuple[float, float]]:
        """The least and the greatest value of each row."""
        graphs = (self.moments, self.works, self.surplus, *([self.speeds] if self.speeds else []))
        spans = {graph.name: graph.span for graph in graphs}
        if self.plate.loop:
            spans[quantities.SURPLUS] = self.plate.shown.up
        return {**spans, quantities.INERTIA: (0.0, 0.0)}

    @cached_property
    def speeds(self) -> StripGraph | None:
        """The graph of the speeds."""
        found = self.plate.account.speeds
        return quantities.speeds(self.plate.cycle, self.plate.dense, found) if found else None

    @cached_property
    def surplus(self) -> StripGraph:
        return quantities.surplus(self.plate.cycle, self.plate.dense)

    @cached_property
    def inertia(self) -> StripGraph:
        return quantities.inertia(self.plate.cycle, self.plate.dense)

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
        return quantities.moments(self.plate.cycle, self.plate.dense)

    @cached_property
    def works(self) -> StripGraph:
        return quantities.works(self.plate.cycle)

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
        cycle, hand = self.plate.cycle, self.plate.hand
        axes = self._axes(self.moments, moments)
        yield self._graph(self.moments, axes, "reduced moments")
        yield rays.draw(cycle, axes, distance, hand)
        yield self._graph(
            self.works,
            self._axes(self.works, works),
            "works",
            f"H = {self.plate.drafting.number(distance)} {self.plate.drafting.word('mm')}",
        )
        yield self._graph(self.surplus, self.surplus_axes, "surplus energy")
        if self.speeds is not None:
            low, high = self.speeds.span
            up = self._fitting(high - low, self.fields[self.speeds.name].height, "ω", "rad/s")
            yield self._graph(self.speeds, self._axes(self.speeds, up), "speed over the turn", self._mean())

    def _mean(self) -> str:
        """Write the mean speed, from which the speeds are drawn."""
        drafting = self.plate.drafting
        return f"ω_m = {drafting.number(self.plate.task.speed, 5)} {drafting.word('rad/s')}"

    def _graph(self, graph: StripGraph, axes: Axes, title: str, more: str = "") -> Part:
        """Draw a graph with its title over it."""
        plate, drafting = self.plate, self.plate.drafting
        part = strip_graph.draw(graph, plate.strips, axes, drafting)
        scales = ";  ".join((drafting.scale(axes.up), more or drafting.scale(axes.across)))
        head = caption(drafting.word(title), scales, self._over(graph.name), plate.hand)
        return part._replace(lines=(head, *part.lines))

    def _energy(self) -> Iterator[Part]:
        """Draw the loop, and the inertia over it."""
        if not self.plate.loop:
            return
        plate, drafting = self.plate, self.plate.drafting
        turned = strip_graph.draw(self.inertia, plate.strips, self.inertia_axes, drafting)
        yield self._headed(
            turned, plate.rows[0].name, "reduced inertia", (self.inertia_scale, self.inertia_axes.across)
        )
        loop = loop_figure.draw(plate.shown, self.loop_axes, drafting)
        yield self._headed(loop, quantities.SURPLUS, "loop", (self.energy_scale, self.inertia_scale))

    def _headed(self, part: Part, row: str, title: str, scales: Sequence[Scale]) -> Part:
        """Write the title of what stands beside the graphs, level with that of a row."""
        drafting, over = self.plate.drafting, self._over(row)
        left = self.loop_axes.zero.real - 2 * loop_figure.TAIL / 3 * self.plate.hand.letter
        field = over._replace(left=left, right=self.spot.box.right)
        head = caption(drafting.word(title), ";  ".join(map(drafting.scale, scales)), field, self.plate.hand)
        return part._replace(lines=(head, *part.lines))

    def _over(self, row: str) -> Field:
        """Give the field of a row with the paper over it."""
        field = self.fields[row]
        return field._replace(top=field.top + self.plate.over)

    def _joining(self) -> Iterator[Stroke]:
        """Draw the strip edges of jumps through the graphs, and the transfer of points into the loop."""
        hand, cycle, strips_ = self.plate.hand, self.plate.cycle, self.plate.strips
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
                    yield Line(
                        self.surplus_axes.on(float(cycle.turned[k]), float(cycle.surplus[k])), spot, hand.drafted
                    )


def _mask(head: Stroke) -> Polyline:
    """Give the box around a caption: no line that joins graphs runs through it."""
    left, bottom, right, top = bounds(head)
    low, high = complex(left, bottom) - CLEAR * (1 + 1j), complex(right, top) + CLEAR * (1 + 1j)
    return Polyline((low, complex(high.real, low.imag), high, complex(low.real, high.imag)), True)
