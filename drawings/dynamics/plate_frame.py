"""The plate of graphs and loop as one figure: its frames, its lines, its letters (лист диаграмм)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product

from drawings.dynamics import graphs
from drawings.dynamics import graphs as quantities
from drawings.dynamics import loop as loop_figure
from drawings.dynamics.graphs import StripGraph
from drawings.dynamics.loop import NAME, TAIL, height, write
from drawings.dynamics.plate import TITLE, WIDE, Content, Plate, plate_of, room_of_plate
from drawings.kinds.axes import BEYOND, Axes, Part, Parts, caption
from drawings.layout.picture import Picture, Spot
from drawings.lettering.phrase import Slot, joined, telling
from drawings.page.scale import Drafting, Scale, fitting
from drawings.paper.formats import Field
from drawings.paper.strokes import Group, Line, Stroke
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.trimming import around, trim
from plans.model.dynamics import TURN

POLE = (3.2, 8.2)  # least and greatest pole distance, in sizes of a letter
LARGER = 1 + 1e-9  # times an extent that fits: no two standard scales lie so near
COARSER = 4  # scales tried beyond the largest: they differ by ten times
FIRST = (quantities.SURPLUS, quantities.WORKS, quantities.MOMENTS, quantities.SPEEDS)  # what is enlarged first


@dataclass(frozen=True)
class PlateFrame:
    """A plate at its scale: the fields of its rows, its graphs, their axes."""

    plate: Plate
    spot: Spot

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
        if quantities.SPEEDS in found:
            found[quantities.SPEEDS] = max(found[quantities.SPEEDS], self._beside)
        for name in FIRST:
            if name in found:
                spare = sum(rooms.values()) - sum(found.values())
                found[name] = max(found[name], self._filled(name, found[name] + spare))
        spare = sum(rooms.values()) - sum(found.values())
        return {name: high + spare / len(found) for name, high in found.items()}

    @property
    def _beside(self) -> float:
        """The height of the row of speeds beside which there is room for what is told under the loop, mm."""
        return self.plate.telling - self.plate.over - 2 * self.plate.under if self.plate.loop else 0.0

    def _filled(self, name: str, room: float) -> float:
        """Give how much of a room the values of a row fill at a standard scale, mm."""
        low, high = self.spans[name]
        return room if high == low else (high - low) / self.fitting(high - low, room, "", "").mu

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
        plate, found = self.plate, self.plate.account.speeds
        return quantities.speeds(plate.cycle, plate.dense, found, plate.account.before) if found else None

    @cached_property
    def surplus(self) -> StripGraph:
        """The graph of the surplus energy."""
        return quantities.surplus(self.plate.cycle, self.plate.dense)

    @cached_property
    def inertia(self) -> StripGraph:
        """The graph of the inertia."""
        return quantities.inertia(self.plate.cycle, self.plate.dense)

    @cached_property
    def energy_scale(self) -> Scale:
        """The scale of energy, which surplus and loop share."""
        low, high = self.plate.shown.up if self.plate.loop else self.surplus.span
        return self.fitting(high - low, self.fields[quantities.SURPLUS].height, "T", "J")

    @cached_property
    def inertia_scale(self) -> Scale:
        """The scale of inertia, which loop and turned graph share."""
        low, high = self.plate.shown.across
        return self.fitting(high - low, WIDE * self.length, "J", "kg*m2")

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
        steps = [self.fitting(high - low, self.fields[graph.name].height, letter, unit)]
        for _ in range(COARSER):
            steps.append(self.fitting(steps[-1].mu * LARGER, 1.0, letter, unit))
        return steps

    @cached_property
    def moments(self) -> StripGraph:
        """The graph of the moments."""
        return quantities.moments(self.plate.cycle, self.plate.dense)

    @cached_property
    def works(self) -> StripGraph:
        """The graph of the works."""
        return quantities.works(self.plate.cycle)

    def fitting(self, extent: float, room: float, letter: str, unit: str) -> Scale:
        """Choose the largest standard scale of an extent for a room, mm."""
        return fitting(extent, room, letter, unit, self.plate.drafting.standard)

    def axes(self, graph: StripGraph, up: Scale) -> Axes:
        """Stand a graph in the middle of its row."""
        field = self.fields[graph.name]
        low, high = graph.span
        spare = field.height - (high - low) / up.mu
        return Axes(complex(field.left, field.bottom + spare / 2 - low / up.mu), self.spot.scale, up)

    def speed_axes(self, graph: StripGraph) -> Axes:
        """The axes of the speeds, that of angles at their mean."""
        low, high = graph.span
        return self.axes(graph, self.fitting(high - low, self.fields[graph.name].height, "ω", "rad/s"))

    @cached_property
    def loop_axes(self) -> Axes:
        """The axes of the loop: in line with those of the surplus energy."""
        plate, field, up = self.plate, self.fields[quantities.SURPLUS], self.energy_scale
        low, high = plate.shown.up
        spare = field.height - (high - low) / up.mu
        start = (field.right if plate.graphs else self.spot.box.left) + plate.beside[1]
        left = start - plate.shown.across[0] / self.inertia_scale.mu
        return Axes(complex(left, field.bottom + spare / 2 - low / up.mu), self.inertia_scale, up)

    @property
    def loop_left(self) -> float:
        """Where the loop, or its axis of energy, begins from the left, mm."""
        return self.loop_axes.on(self.plate.shown.across[0]).real

    @cached_property
    def surplus_axes(self) -> Axes:
        """The axes of the surplus energy: level with the loop's."""
        if not self.plate.loop:
            return self.axes(self.surplus, self.energy_scale)
        zero = complex(self.fields[quantities.SURPLUS].left, self.loop_axes.zero.imag)
        return Axes(zero, self.spot.scale, self.energy_scale)

    @cached_property
    def inertia_axes(self) -> Axes:
        """The axes of the inertia turned by 90 degrees: its angle runs down towards the loop."""
        fields = self.fields
        top = max(field.top for field in fields.values())
        bottom = fields[quantities.SURPLUS].top + self.plate.over + self.plate.under
        down = self.fitting(TURN, top - bottom - 2 * BEYOND, "φ", "rad")
        return Axes(complex(self.loop_axes.zero.real, top - BEYOND), down, self.inertia_scale, -1j, 1 + 0j)


DIGITS = 5
TOLD = "told"  # the name of what is told under the loop
CLEAR = 1.5  # mm around a caption


def measure(shown: Content, drafting: Drafting) -> Picture:
    """Measure the room of a plate."""
    return room_of_plate(plate_of(shown, drafting))


def draw(shown: Content, spot: Spot, drafting: Drafting) -> Parts:
    """Draw a plate in its spot."""
    plate = plate_of(shown, drafting)
    return _Drawing(plate, PlateFrame(plate, spot)).figure


@dataclass(frozen=True)
class _Drawing:
    """A plate at its scale, to be drawn."""

    plate: Plate
    frame: PlateFrame

    @property
    def figure(self) -> Parts:
        parts = [*self._graphs(), *self._energy()]
        masks = [around(part.lines[0], CLEAR) for part in parts if part.name != graphs.NAME]
        joining = fit_dashes(trim(self._joining(), masks))
        return Parts((Group(tuple(joining), f"{self.plate.name}-transfer"),), (*parts, *self._told()))

    def _told(self) -> Iterator[Part]:
        """Write under the loop what it gives, and the table under that."""
        plate, wheel = self.plate, self.plate.account.flywheel
        if not plate.loop:
            return
        left = self.frame.loop_left - TAIL * plate.hand.letter
        corner = complex(left, self.frame.fields[graphs.SURPLUS].bottom - 2 * plate.under)
        if wheel is not None:
            lines = write(wheel, self.frame.loop_axes, corner, plate.drafting)
            yield Part(NAME, (lines,), ())
            corner -= 1j * height(plate.drafting)
        if plate.told is not None:
            table, setting = plate.told
            yield Part(TOLD, tuple(table.draw(corner, setting, plate.drafting)), ())

    def _graphs(self) -> Iterator[Part]:
        """Draw the graphs over the angle."""
        frame, shown = self.frame, [row.name for row in self.plate.rows] if self.plate.graphs else []
        if graphs.MOMENTS in shown:
            yield from self._works()
        if graphs.SURPLUS in shown:
            yield self._graph(frame.surplus, frame.surplus_axes, "surplus energy")
        if frame.speeds is not None and graphs.SPEEDS in shown:
            yield self._graph(frame.speeds, frame.speed_axes(frame.speeds), "speed over the turn", self._mean())

    def _works(self) -> Iterator[Part]:
        """Draw the moments, the pole with its rays, and the works under them."""
        frame, (moments, works, distance) = self.frame, self.frame.integration
        axes = frame.axes(frame.moments, moments)
        yield self._graph(frame.moments, axes, "reduced moments")
        yield graphs.pole_part(self.plate.cycle, axes, distance, self.plate.hand)
        yield self._graph(frame.works, frame.axes(frame.works, works), "works", self._pole(distance))

    def _pole(self, distance: float) -> str:
        """Write the pole distance, mm."""
        drafting = self.plate.drafting
        number = drafting.slot(Slot(graphs.DISTANCE, distance))
        return joined("", (f"{graphs.DISTANCE} = ", number, f" {drafting.word('mm')}"))

    def _mean(self) -> str:
        """Write the mean speed, from which the speeds are drawn."""
        drafting = self.plate.drafting
        number = drafting.slot(Slot("ω_m", self.plate.task.speed, DIGITS))
        return joined("", ("ω_m = ", number, f" {drafting.word('rad/s')}"))

    def _graph(self, graph: StripGraph, axes: Axes, title: str, more: str = "") -> Part:
        """Draw a graph with its title over it."""
        plate, drafting = self.plate, self.plate.drafting
        part = graphs.graph_part(graph, plate.strips, axes, drafting)
        scales = joined(";  ", (drafting.scale(axes.up), more or drafting.scale(axes.across)))
        head = caption(drafting.word(title), scales, self._over(graph.name), plate.hand)
        return part._replace(lines=(telling(graph.name, head), *part.lines))

    def _energy(self) -> Iterator[Part]:
        """Draw the loop, and the inertia over it."""
        if not self.plate.loop:
            return
        plate, drafting = self.plate, self.plate.drafting
        turned = graphs.graph_part(self.frame.inertia, plate.strips, self.frame.inertia_axes, drafting)
        yield self._headed(
            turned, plate.rows[0].name, "reduced inertia", (self.frame.inertia_scale, self.frame.inertia_axes.across)
        )
        loop = loop_figure.loop_part(plate.shown, self.frame.loop_axes, drafting)
        yield self._headed(loop, graphs.SURPLUS, "loop", (self.frame.energy_scale, self.frame.inertia_scale))

    def _headed(self, part: Part, row: str, title: str, scales: Sequence[Scale]) -> Part:
        """Write the title of what stands beside the graphs, level with that of a row."""
        drafting, over = self.plate.drafting, self._over(row)
        left = self.frame.loop_left + TITLE * self.plate.hand.letter
        field = over._replace(left=left, right=self.frame.spot.box.right)
        head = caption(drafting.word(title), drafting.scale(*scales), field, self.plate.hand)
        return part._replace(lines=(head, *part.lines))

    def _over(self, row: str) -> Field:
        """Give the field of a row with the paper over it."""
        field = self.frame.fields[row]
        return field._replace(top=field.top + self.plate.over)

    def _joining(self) -> Iterator[Stroke]:
        """Draw the strip edges of jumps through the graphs, and the transfer of points into the loop."""
        if self.plate.graphs:
            yield from self._jumps()
        if self.plate.loop:
            for k in self.plate.shown.touches:
                yield from self._transfer(k)

    def _jumps(self) -> Iterator[Stroke]:
        """Draw the edges at which a load jumps through the graphs of works and energy."""
        frame, lines = self.frame, list[tuple[StripGraph, Axes]]()
        if graphs.WORKS in frame.fields:
            lines.append((frame.works, frame.axes(frame.works, frame.integration[1])))
        if graphs.SURPLUS in frame.fields:
            lines.append((frame.surplus, frame.surplus_axes))
        for k, (graph, axes) in product(self.plate.strips.jumps, lines):
            across, (low, high) = float(self.plate.strips.turned[k]), graph.span
            yield Line(axes.on(across, low), axes.on(across, high), self.plate.hand.axis)

    def _transfer(self, k: int) -> Iterator[Stroke]:
        """Carry an edge's inertia and energy into the loop."""
        cycle, frame, style = self.plate.cycle, self.frame, self.plate.hand.drafted
        turned, inertia, energy = float(cycle.turned[k]), float(cycle.varying[k]), float(cycle.surplus[k])
        spot = frame.loop_axes.on(inertia, energy)
        yield Line(frame.inertia_axes.on(turned, inertia), spot, style)
        if self.plate.graphs:
            yield Line(frame.surplus_axes.on(turned, energy), spot, style)
