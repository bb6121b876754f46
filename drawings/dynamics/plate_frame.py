"""The plate of graphs and loop as one figure: its fields, its axes, its lines, its letters (лист диаграмм)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import product

from drawings.dynamics import graphs
from drawings.dynamics.graphs import INERTIA, MOMENTS, SPEEDS, SURPLUS, WORKS, StripGraph, graph_part
from drawings.dynamics.loop import NAME, TAIL, height, loop_part, write
from drawings.dynamics.plate import TITLE, WIDE, Plate, longest, measure
from drawings.kinds.axes import BETWEEN, BEYOND, Axes, Part, Parts, caption, wide
from drawings.kinds.row_frame import coarser, level, stacked
from drawings.kinds.working import TANGENTS, Workings, amount
from drawings.layout.picture import Spot
from drawings.lettering.words import Slot, joined, telling
from drawings.page.page import Scale, fitting
from drawings.paper.hand import Field
from drawings.paper.strokes import INK, Circle, Group, Line, Stroke
from drawings.paper.walk import tied
from drawings.symbols.symbols import fit_dashes
from drawings.symbols.trimming import around, trim
from plans.model.dynamics import TURN, Touch

POLE = (3.2, 8.2)  # least and greatest pole distance, in sizes of a letter
LOW = 0.25  # share of the height of the loop under which moments and works are too low beside it: they grow first
EVEN = 0.65  # share of the room of moments and works that one of them takes at most
COARSER = 7  # scales tried beyond the largest: they differ by a hundred times
TITLES = {MOMENTS: "reduced moments", WORKS: "works", SURPLUS: "surplus energy", SPEEDS: "speed over the turn"}
DIGITS = 5
TOLD = "told"  # the name of what is told under the loop
CLEAR = 1.5  # mm around a caption


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
    def graphs(self) -> dict[str, StripGraph]:
        """The graphs by what they show."""
        plate, account = self.plate, self.plate.account
        cycle, dense = plate.cycle, plate.dense
        found = [graphs.moments(cycle, dense), graphs.works(cycle)]
        found += [graphs.surplus(cycle, dense), graphs.inertia(cycle, dense)]
        if account.speeds:
            found.append(graphs.speeds(cycle, dense, account.speeds, account.before))
        return {graph.name: graph for graph in found}

    @cached_property
    def fields(self) -> dict[str, Field]:
        """The fields of the rows' lines, by what they show, as wide as the axis of angles."""
        box, plate = self.spot.box, self.plate
        return stacked(self.heights, box.left + plate.beside[0], box.top, self.length, plate.over, plate.under)

    @cached_property
    def heights(self) -> dict[str, float]:
        """The heights of the rows, mm: what one leaves goes to the loop, or first to what is low beside it."""
        found = self._rooms
        total, heights = sum(found.values()), {name: self._filled(name, room) for name, room in found.items()}
        if (over := self.plate.rows[0].name) in (SPEEDS, INERTIA):  # the inertia stands beside it, over the loop
            heights[over] = found[over]
        if (plate := self.plate).loop and plate.rows[-1].name == SPEEDS:  # beside it stands what is told under the loop
            heights[SPEEDS] = max(heights[SPEEDS], plate.telling - plate.over - 2 * plate.under)
        if WORKS in found:
            heights |= self._integrated(self._shared)
        order = [name for name in (SURPLUS, WORKS, SPEEDS) if name in found and self._high(name)]  # nothing fills all
        if WORKS in order and SURPLUS in order:
            grown = self._grown(SURPLUS, heights, total)[SURPLUS]
            order.sort(key=lambda name: name != WORKS and min(heights[MOMENTS], heights[WORKS]) < LOW * grown)
        for name in order:
            heights |= self._grown(name, heights, total)
        spare = total - sum(heights.values())
        return {name: high + spare / len(heights) for name, high in heights.items()}

    def _grown(self, name: str, heights: dict[str, float], total: float) -> dict[str, float]:
        """Give a row what is left of the room of all, mm: works share it with the moments."""
        spare = total - sum(heights.values())
        if name == WORKS:
            return self._integrated(spare + heights[MOMENTS] + heights[WORKS])
        return {name: max(heights[name], self._filled(name, heights[name] + spare))}

    @property
    def _rooms(self) -> dict[str, float]:
        """The rooms of the rows as the plate parts its height, mm."""
        return {row.name: row.high * self.length * self._taller for row in self.plate.rows}

    @property
    def _shared(self) -> float:
        """The room that moments and works share, mm."""
        return self._rooms[MOMENTS] + self._rooms[WORKS]

    def _integrated(self, room: float) -> dict[str, float]:
        """Give the heights of moments and works at the scales that they have in a room for both, mm."""
        first, second, _ = self._paired(room)
        return {name: self._high(name) / scale.mu for name, scale in ((MOMENTS, first), (WORKS, second))}

    @property
    def _taller(self) -> float:
        """How many times as high as at least the rows are: a box with room to spare is filled."""
        room = measure(self.plate)
        return tied(room.filling(self.spot).high / room.high)

    def _filled(self, name: str, room: float) -> float:
        """Give how much of a room the values of a row fill at a standard scale, mm."""
        high = self._high(name)
        return high / self._fitting(self._span(name), room, "", "").mu if high else room

    def _high(self, name: str) -> float:
        """Give over how much the values of a row go."""
        low, high = self._span(name)
        return high - low

    def _span(self, name: str) -> tuple[float, float]:
        """Give the least and the greatest value of a row; the inertia fills what it is given."""
        if name == INERTIA:
            return 0.0, 0.0
        return self.plate.shown.up if name == SURPLUS and self.plate.loop else self.graphs[name].span

    def _fitting(self, span: tuple[float, float], room: float, letter: str, unit: str) -> Scale:
        """Choose the largest standard scale of a span for a room, mm."""
        return fitting(span[1] - span[0], room, letter, unit, self.plate.drafting.standard)

    @cached_property
    def energy_scale(self) -> Scale:
        """The scale of energy, which surplus and loop share."""
        return self._fitting(self._span(SURPLUS), self.fields[SURPLUS].height, "T", "J")

    @cached_property
    def inertia_scale(self) -> Scale:
        """The scale of inertia, which loop and turned graph share."""
        return self._fitting(self.plate.shown.across, WIDE * self.length, "J", "kg*m2")

    @cached_property
    def integration(self) -> tuple[Scale, Scale, float]:
        """The scales of moments and works and the pole distance, mm, which follows from them."""
        heights = self.heights[MOMENTS], self.heights[WORKS]
        return self._paired(sum(heights), max(heights))

    def _paired(self, room: float, high: float = 0.0) -> tuple[Scale, Scale, float]:
        """Choose the largest scales of moments and works that share a room, mm, one so high, with a pole near by."""
        size, mu = self.plate.hand.letter, self.spot.scale.mu
        pairs = product(self._steps(MOMENTS, "M", "N*m", room), self._steps(WORKS, "A", "J", room))
        found = [(first, two, two.mu / (first.mu * mu)) for first, two in pairs]
        sizes, most = (self._high(MOMENTS), self._high(WORKS)), max(EVEN * max(room, self._shared), high)
        rows = [(sizes[0] / way[0].mu, sizes[1] / way[1].mu, way) for way in found]
        fitting = [way for one, two, way in rows if tied(max(one, two) - most) <= 0 >= tied(one + two - room)]
        near = [way for way in fitting if tied(POLE[0] - way[2] / size) <= 0 >= tied(way[2] / size - POLE[1])]
        return min(near or fitting, key=lambda way: way[0].mu * way[1].mu)

    def _steps(self, name: str, letter: str, unit: str, room: float) -> Iterator[Scale]:
        """Give the largest scale of a graph that a room takes, and some smaller ones."""
        first = self._fitting(self._span(name), room, letter, unit)
        return coarser(first, COARSER, self.plate.drafting.standard)

    def axes(self, name: str) -> Axes:
        """Stand a graph in the middle of its row; the surplus energy is level with the loop."""
        across, field, span = self.spot.scale, self.fields[name], self.graphs[name].span
        if name == SURPLUS:
            axes = level(field, self._span(name), across, self.energy_scale)
            return axes._replace(zero=complex(field.left, self.loop_axes.zero.imag)) if self.plate.loop else axes
        if name == SPEEDS:
            return level(field, span, across, self._fitting(span, field.height, "ω", "rad/s"))
        moments, works, _ = self.integration
        return level(field, span, across, works if name == WORKS else moments)

    @cached_property
    def loop_axes(self) -> Axes:
        """The axes of the loop: in line with those of the surplus energy."""
        plate, field, (low, _) = self.plate, self.fields[SURPLUS], self.plate.shown.across
        left = field._replace(left=field.right + plate.beside[1] - low / self.inertia_scale.mu)
        return level(left, plate.shown.up, self.inertia_scale, self.energy_scale)

    @property
    def loop_left(self) -> float:
        """Where the loop, or its axis of energy, begins from the left, mm."""
        return self.loop_axes.on(self.plate.shown.across[0]).real

    @cached_property
    def inertia_axes(self) -> Axes:
        """The axes of the inertia turned by 90 degrees: its angle runs down towards the loop."""
        top = max(field.top for field in self.fields.values())
        bottom = self.fields[SURPLUS].top + self.plate.over + self.plate.under
        high = top - bottom
        room = max(high - BEYOND, high / 2)  # on an A4 it is hardly higher than the end of its axis
        down = self._fitting((0.0, TURN), room, "φ", "rad")
        return Axes(complex(self.loop_axes.zero.real, top), down, self.inertia_scale, -1j, 1 + 0j)

    @property
    def figure(self) -> Parts:
        """All parts, and what joins them."""
        parts = [*self._graphs(), *self._energy()]
        masks = [around(part.lines[0], CLEAR) for part in parts if part.name != graphs.NAME]
        joining = fit_dashes(trim(self._joining(), masks))
        return Parts((Group(tuple(joining), f"{self.plate.name}-transfer"),), (*parts, *self._stated()))

    def _stated(self) -> Iterator[Part]:
        """Write under the loop what it gives, and the table under that."""
        plate, wheel = self.plate, self.plate.account.flywheel
        if not plate.loop:
            return
        left = self.loop_left - TAIL * plate.hand.letter
        corner = complex(left, self.fields[SURPLUS].bottom - 2 * plate.under)
        if wheel is not None:
            yield Part(NAME, (write(wheel, self.loop_axes, corner, plate.drafting),), ())
            corner -= 1j * height(plate.drafting)
        if plate.told is not None:
            table, torn = plate.told
            room = corner.imag - self.fields[plate.rows[-1].name].bottom
            fewer = (setting for setting in table.settings() if setting.parts < torn.parts)
            setting = next((setting for setting in fewer if table.size(setting)[1] <= room), torn)
            yield Part(TOLD, tuple(table.draw(corner, setting, plate.drafting)), ())

    def _graphs(self) -> Iterator[Part]:
        """Draw the graphs over the angle with their titles, and the pole by which the works are drawn."""
        plate, drafting = self.plate, self.plate.drafting
        for name in (row.name for row in plate.rows if row.name in TITLES):
            shown, axes = self.graphs[name], self.axes(name)
            part = graph_part(shown, plate.strips, axes, drafting)
            scales = joined(";  ", (drafting.scale(axes.up), self._more(name) or drafting.scale(axes.across)))
            over = self._over(name)
            over = over._replace(left=over.left + self._stacked * BETWEEN)  # the lower line is clear of the axis
            if name != SURPLUS:  # its caption is level with that of the loop
                over = over._replace(top=axes.on(0.0, shown.span[1]).imag + plate.over)
            head = caption(drafting.word(TITLES[name]), scales, over, plate.hand, self._stacked)
            yield part._replace(lines=(telling(name, head), *part.lines))
            if name == MOMENTS:
                yield graphs.pole_part(plate.cycle, axes, self.integration[2], plate.hand)

    def _more(self, name: str) -> str:
        """Write what stands behind the scale of a graph: the pole distance, mm, or the mean of the speeds."""
        if name == WORKS:
            return self._number(Slot(graphs.DISTANCE, self.integration[2]), "mm")
        return self._number(Slot("ω_m", self.plate.task.speed, DIGITS), "rad/s") if name == SPEEDS else ""

    def _number(self, slot: Slot, unit: str) -> str:
        drafting = self.plate.drafting
        return joined("", (f"{slot.quantity} = ", drafting.slot(slot), f" {drafting.word(unit)}"))

    def _energy(self) -> Iterator[Part]:
        """Draw the loop, and the inertia over it."""
        if not self.plate.loop:
            return
        plate, drafting = self.plate, self.plate.drafting
        turned = graph_part(self.graphs[INERTIA], plate.strips, self.inertia_axes, drafting)
        scales = self.inertia_scale, self.inertia_axes.across
        yield self._headed(turned, plate.rows[0].name, "reduced inertia", *scales)
        loop = loop_part(plate.shown, self.loop_axes, drafting)
        yield self._headed(loop, SURPLUS, "loop", self.energy_scale, self.inertia_scale)

    def _headed(self, part: Part, row: str, title: str, *scales: Scale) -> Part:
        """Write the title of what stands beside the graphs, level with that of a row, and its scales."""
        drafting, hand, right = self.plate.drafting, self.plate.hand, self.spot.box.right
        words = drafting.word(title), drafting.scale(*scales)
        left = min(self.loop_left + TITLE * hand.letter, right - wide(*words, hand, self._stacked))
        head = caption(*words, self._over(row)._replace(left=left, right=right), hand, self._stacked)
        return part._replace(lines=(head, *part.lines))

    @property
    def _stacked(self) -> bool:
        """Whether captions on one line have no room: the plate is smaller than can well be read."""
        return self.length < longest(self.plate)

    def _over(self, row: str) -> Field:
        """Give the field of a row with the paper over it."""
        field = self.fields[row]
        return field._replace(top=field.top + self.plate.over)

    def _joining(self) -> Iterator[Stroke]:
        """Draw the strip edges of jumps through the graphs, and the transfer of points into the loop."""
        yield from self._jumps()
        if self.plate.loop:
            wheel = self.plate.account.flywheel
            for touch in wheel.touches if wheel else ():
                yield from self._transfer(touch)

    def _jumps(self) -> Iterator[Stroke]:
        """Draw the edges at which a load jumps through the graphs of works and energy."""
        shown = [(self.graphs[name].span, self.axes(name)) for name in (WORKS, SURPLUS) if name in self.fields]
        for k, ((low, high), axes) in product(self.plate.strips.jumps, shown):
            across = float(self.plate.strips.turned[k])
            yield Line(axes.on(across, low), axes.on(across, high), self.plate.hand.axis)

    def _transfer(self, touch: Touch) -> Iterator[Stroke]:
        """Carry inertia and energy of a point that a tangent touches into the loop, marked on their graphs."""
        spot, hand = self.loop_axes.on(touch.varying, touch.surplus), self.plate.hand
        inertia = self.inertia_axes.on(touch.turned, touch.varying)
        for source in (inertia, self.axes(SURPLUS).on(touch.turned, touch.surplus)):
            yield from (Line(source, spot, hand.drafted), Circle(source, graphs.DOT * hand.symbol, INK))


def working(shown: Plate) -> Workings:
    """Write beside a plate with the loop how steep the tangents to it are."""
    return Workings(TANGENTS, shown.name, lambda spot: list(_lines(shown, spot)), shown.drafting)


def _lines(shown: Plate, spot: Spot | None) -> Iterator[tuple[str, ...]]:
    if not shown.loop or shown.account.flywheel is None:
        return
    drafting, frame = shown.drafting, PlateFrame(shown, spot) if spot else None  # at first it stands nowhere
    across, up = (frame.inertia_scale.mu, frame.energy_scale.mu) if frame else (math.nan, math.nan)
    k = drafting.notation == "K"
    over, under = ("K_{T}", "K_{J}") if k else ("μ_{J}", "μ_{T}")
    factors = [amount(factor, drafting) for factor in ((1 / up, 1 / across) if k else (across, up))]
    for end, slope in zip(("max", "min"), reversed(shown.account.flywheel.slopes), strict=True):
        yield (
            f"tg ψ_{{{end}}} = ω_{{{end}}}^2·{over}/(2·{under})",
            f"{amount(2 * slope, drafting)}·{factors[0]}/(2·{factors[1]})",
            amount(slope * across / up, drafting),
        )
