"""The figure of a plate: its graphs, loop and equations drawn, titled, and joined by transfer lines (чертёж)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

from drawings.figures.dynamics import equations, quantities, rays, strip_graph
from drawings.figures.dynamics import loop as loop_figure
from drawings.figures.dynamics.loop import TAIL
from drawings.figures.dynamics.plate import TITLE, Content, Plate, plate_of, room_of_plate
from drawings.figures.dynamics.plate_frame import PlateFrame
from drawings.figures.dynamics.strip_graph import StripGraph
from drawings.figures.graphs.axes import Axes
from drawings.figures.graphs.part import Part, caption
from drawings.layout.labels import Labels
from drawings.layout.picture import Picture, Spot
from drawings.lettering.phrase import Slot, joined, telling
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale
from drawings.paper.formats import Field
from drawings.paper.strokes import Group, Line, Stroke
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.trimming import around, trim

DIGITS = 5
TOLD = "told"  # the name of what is told under the loop
CLEAR = 1.5  # mm around a caption


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


def measure(shown: Content, drafting: Drafting) -> Picture:
    """Measure the room of a plate."""
    return room_of_plate(plate_of(shown, drafting))


def draw(shown: Content, spot: Spot, drafting: Drafting) -> PlateFigure:
    """Draw a plate in its spot."""
    plate = plate_of(shown, drafting)
    return _Drawing(plate, PlateFrame(plate, spot)).figure


@dataclass(frozen=True)
class _Drawing:
    """A plate at its scale, to be drawn."""

    plate: Plate
    frame: PlateFrame

    @property
    def figure(self) -> PlateFigure:
        parts = [*self._graphs(), *self._energy()]
        masks = [around(part.lines[0], CLEAR) for part in parts if part.name != rays.NAME]
        joining = fit_dashes(trim(self._joining(), masks))
        return PlateFigure((*parts, *self._told()), Group(tuple(joining), f"{self.plate.name}-transfer"))

    def _told(self) -> Iterator[Part]:
        """Write under the loop what it gives, and the table under that."""
        plate, wheel = self.plate, self.plate.account.flywheel
        if not plate.loop:
            return
        left = self.frame.loop_left - TAIL * plate.hand.letter
        corner = complex(left, self.frame.fields[quantities.SURPLUS].bottom - 2 * plate.under)
        if wheel is not None:
            lines = equations.write(wheel, self.frame.loop_axes, corner, plate.drafting)
            yield Part(equations.NAME, (lines,), ())
            corner -= 1j * equations.height(plate.drafting)
        if plate.told is not None:
            table, setting = plate.told
            yield Part(TOLD, tuple(table.draw(corner, setting, plate.drafting)), ())

    def _graphs(self) -> Iterator[Part]:
        """Draw the graphs over the angle."""
        frame, shown = self.frame, [row.name for row in self.plate.rows] if self.plate.graphs else []
        if quantities.MOMENTS in shown:
            yield from self._works()
        if quantities.SURPLUS in shown:
            yield self._graph(frame.surplus, frame.surplus_axes, "surplus energy")
        if frame.speeds is not None and quantities.SPEEDS in shown:
            yield self._graph(frame.speeds, frame.speed_axes(frame.speeds), "speed over the turn", self._mean())

    def _works(self) -> Iterator[Part]:
        """Draw the moments, the pole with its rays, and the works under them."""
        frame, (moments, works, distance) = self.frame, self.frame.integration
        axes = frame.axes(frame.moments, moments)
        yield self._graph(frame.moments, axes, "reduced moments")
        yield rays.pole_part(self.plate.cycle, axes, distance, self.plate.hand)
        yield self._graph(frame.works, frame.axes(frame.works, works), "works", self._pole(distance))

    def _pole(self, distance: float) -> str:
        """Write the pole distance, mm."""
        drafting = self.plate.drafting
        number = drafting.slot(Slot(rays.DISTANCE, distance))
        return joined("", (f"{rays.DISTANCE} = ", number, f" {drafting.word('mm')}"))

    def _mean(self) -> str:
        """Write the mean speed, from which the speeds are drawn."""
        drafting = self.plate.drafting
        number = drafting.slot(Slot("ω_m", self.plate.task.speed, DIGITS))
        return joined("", ("ω_m = ", number, f" {drafting.word('rad/s')}"))

    def _graph(self, graph: StripGraph, axes: Axes, title: str, more: str = "") -> Part:
        """Draw a graph with its title over it."""
        plate, drafting = self.plate, self.plate.drafting
        part = strip_graph.graph_part(graph, plate.strips, axes, drafting)
        scales = joined(";  ", (drafting.scale(axes.up), more or drafting.scale(axes.across)))
        head = caption(drafting.word(title), scales, self._over(graph.name), plate.hand)
        return part._replace(lines=(telling(graph.name, head), *part.lines))

    def _energy(self) -> Iterator[Part]:
        """Draw the loop, and the inertia over it."""
        if not self.plate.loop:
            return
        plate, drafting = self.plate, self.plate.drafting
        turned = strip_graph.graph_part(self.frame.inertia, plate.strips, self.frame.inertia_axes, drafting)
        yield self._headed(
            turned, plate.rows[0].name, "reduced inertia", (self.frame.inertia_scale, self.frame.inertia_axes.across)
        )
        loop = loop_figure.loop_part(plate.shown, self.frame.loop_axes, drafting)
        yield self._headed(loop, quantities.SURPLUS, "loop", (self.frame.energy_scale, self.frame.inertia_scale))

    def _headed(self, part: Part, row: str, title: str, scales: Sequence[Scale]) -> Part:
        """Write the title of what stands beside the graphs, level with that of a row."""
        drafting, over = self.plate.drafting, self._over(row)
        left = self.frame.loop_left + TITLE * self.plate.hand.letter
        field = over._replace(left=left, right=self.frame.spot.box.right)
        head = caption(drafting.word(title), ";  ".join(map(drafting.scale, scales)), field, self.plate.hand)
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
        if quantities.WORKS in frame.fields:
            lines.append((frame.works, frame.axes(frame.works, frame.integration[1])))
        if quantities.SURPLUS in frame.fields:
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
