"""The frame of a plate: where its rows stand on paper, their axes and the scales that they share (разметка чертежа)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import product

from drawings.figures.dynamics import quantities
from drawings.figures.dynamics.plate import WIDE, Plate
from drawings.figures.dynamics.strip_graph import StripGraph
from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.layout.picture import Spot
from drawings.page.scale import Scale, fitting
from drawings.paper.formats import Field
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
