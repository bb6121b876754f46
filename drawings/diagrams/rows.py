"""Kinematic diagrams of the output: a row a graph, over the crank angle (кинематические диаграммы)."""

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import OVER, UNDER, Letter, Part, Parts, Plot
from drawings.kinds.graph import TURNED, Graph
from drawings.kinds.row_frame import Proportions, RowFrame, RowPlate
from drawings.kinds.smooth import smooth
from drawings.layout.picture import Picture, Spot
from drawings.lettering.lettering import every, spaced, text_width
from drawings.lettering.words import Slot, joined
from drawings.page.page import Drafting, Scale
from drawings.paper.strokes import INK, Group, LineStyle, Stroke, Text
from drawings.paper.walk import PLACES, flat
from drawings.symbols.figure import LINE, heading
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import TURN, Axis, ChordError, Diagrams, OutputRates, chord_error
from plans.model.motion import Floats

TRAVEL, VELOCITY, ACCELERATION = KEYS = ("travel", "velocity", "acceleration")  # from the top
SLIDING, TURNING = ("S", "v", "a"), ("ψ", "ω", "ε")
AHEAD = ("Δψ", "Δω", "ε")  # of an output that turns fully: what it is ahead of an even turn
STEPS = 360  # of a turn at least: a degree, of which no curve on paper shows the corners
GREATEST, LEAST = "Δφ greatest", "Δφ least"
STEEP = 30.0  # times higher than all the rest a peak between positions leaves of it less than 2 mm of a row
NOUGHT = 1e-9  # of what the row above would make it: a rounding, which no scale is told of


class DiagramRow(NamedTuple):
    """A row: its points by the plans, what is drawn thick and thin, the points and values by chords."""

    key: str
    letter: str
    unit: str
    at: Floats  # (M,): of the plans, at the positions; NaN at gaps
    results: tuple[Plot, ...]
    thin: tuple[Plot, ...]
    chords: Plot  # where the values by chords belong, and these; nothing in the first row
    off: ChordError | None = None  # of the values by chords
    flat: bool = False  # whether it shows nothing that a scale could be told of

    @property
    def rays(self) -> Plot:
        """The values to which the rays of its pole go: those by chords."""
        return self.chords

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest value, zero among them; nothing of a row that shows nothing."""
        if self.flat:
            return 0.0, 0.0
        values = np.concatenate([self.at, *(curve.y for curve in (*self.results, *self.thin, self.chords))])
        return float(np.nanmin(values, initial=0.0)), float(np.nanmax(values, initial=0.0))


class Peak(NamedTuple):
    """Where between two positions the drawn curve is greatest or least: which of them, angle rad, value."""

    name: str
    turned: float
    value: float


def peaks(row: DiagramRow, axis: Axis) -> Iterator[Peak]:
    """Give where the thick curve of a row is greatest and least, but for what a position shows, or an end."""
    if row.flat or len(row.results) != 1:
        return
    x, first = np.unique(row.results[0].x.round(PLACES), return_index=True)
    y, near = row.results[0].y[first], TURN / STEPS / 2
    middles, steep = (x[1:] + x[:-1]) / 2, np.diff(y) / np.diff(x)
    for name, sense in ((GREATEST, 1.0), (LEAST, -1.0)):
        k = int(np.argmax(sense * y))
        if 0 < k < len(y) - 1:
            turned = float(np.interp(0.0, -sense * steep[k - 1 : k + 1], middles[k - 1 : k + 1]))  # it rises no more
            if np.abs(axis.turned - turned).min() > near and x[0] + 4 * near < turned < x[-1] - 4 * near:
                yield Peak(name, turned, float(y[k]))


def letters_of(diagrams: DiagramsStudy) -> tuple[str, str, str]:
    """Give the letters of the rows."""
    if diagrams.course.travel.sliding:
        return SLIDING
    return AHEAD if diagrams.course.count.turns else TURNING


def rows_of(diagrams: DiagramsStudy) -> tuple[DiagramRow, ...]:
    """Give the rows from the top."""
    found = diagrams.drawn
    axis, nodes = found.axis, found.axis.nodes(STEPS)
    dense = [diagrams.course.at(row) for row in nodes]
    travel = _row(diagrams, 0, found.at.s, _curves(nodes, [course.s for course in dense]))
    chords = tuple(Plot(axis.turned[run], found.at.s[run]) for run in axis.runs)
    return (
        travel._replace(thin=chords),
        _by_chords(
            _row(diagrams, 1, found.at.v, _curves(nodes, [course.v for course in dense])), diagrams, axis.middles
        ),
        _by_chords(_row(diagrams, 2, found.even, _curves(nodes, _even(found, dense))), diagrams, axis.places),
    )


def _row(diagrams: DiagramsStudy, order: int, at: Floats, curves: tuple[Plot, ...]) -> DiagramRow:
    nothing = Plot(np.zeros(0), np.zeros(0))
    return DiagramRow(KEYS[order], letters_of(diagrams)[order], diagrams.units[order], at, curves, (), nothing)


def _by_chords(row: DiagramRow, diagrams: DiagramsStudy, places: Floats) -> DiagramRow:
    """Let the values by chords be the result, and what is exact stand thin beside them."""
    found, fast = diagrams.drawn, row.key == VELOCITY
    values, exact = (found.speeds, found.true_speeds) if fast else (found.growths, found.true_growths)
    there, off = ~np.isnan(values), chord_error(values, exact)
    above = float(np.nanmax(np.abs(found.at.s if fast else found.speeds), initial=0.0))
    flat = bool(np.nanmax(np.abs(values), initial=0.0) <= NOUGHT * diagrams.course.omega * above)
    results = () if flat else tuple(_smooth(found.axis, places, values))
    chords = Plot(places[there], values[there])
    rest = max(np.nanmax(np.abs(of), initial=0.0) for of in (values, row.at))
    steep = any(np.nanmax(np.abs(curve.y), initial=0.0) > STEEP * rest for curve in row.results)
    return row._replace(results=results, thin=() if flat or steep else row.results, chords=chords, off=off, flat=flat)


def _even(found: Diagrams, dense: list[OutputRates]) -> list[Floats]:
    return [course.even(found.lead) for course in dense]


def _curves(nodes: Sequence[Floats], values: list[Floats]) -> tuple[Plot, ...]:
    return tuple(Plot(x, y) for x, y in zip(nodes, values, strict=True))


def _smooth(axis: Axis, places: Floats, values: Floats) -> Iterator[Plot]:
    """Join the values by chords of each run smoothly; those of a whole turn go on from its end to its beginning."""
    for run, nodes in zip(axis.runs, axis.nodes(STEPS), strict=True):
        part = slice(run.start, run.stop - (len(values) < len(axis.turned)))
        there = ~np.isnan(values[part])
        x, y = places[part][there], values[part][there]
        if axis.closed:
            x, y = _around(x, y)
        if len(x) > 1:
            at = np.sort(np.concatenate([_within(nodes, x), _within(x, nodes)]))
            yield Plot(at, smooth(x, y, at))


def _within(places: Floats, ends: Floats) -> Floats:
    """Give the places between the first and the last of others."""
    counted, (first, last) = places.round(PLACES), ends[[0, -1]].round(PLACES)
    return np.asarray(places[(first <= counted) & (counted <= last)])


def _around(x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Let a row of a turn go on a little beyond both its ends."""
    if x[-1] - x[0] >= TURN - np.diff(x).min() / 2:  # its end is its beginning
        x, y = x[:-1], y[:-1]
    return np.concatenate([x[-2:] - TURN, x, x[:2] + TURN]), np.concatenate([y[-2:], y, y[:2]])


NAME = "diagrams"
# Twelve coarser scales differ by five hundred times and more.
PROPORTIONS = Proportions(high=0.9, left=10.4, right=1.8, pole=(2.8, 8.0), coarser=12, rises=False)
# Graphs of a part of a turn, all three as high as one another, want a pole half the axis away: what goes forth alone
# has a course three times as long for its speed as what comes back too.
FORTH = PROPORTIONS._replace(left=22.4, pole=(2.8, 20.0))
PER_CENT = 2  # digits of an error


@dataclass(frozen=True, eq=False, repr=False)
class DiagramsPlate(RowPlate[DiagramRow]):
    """Diagrams to be drafted: their rows and the paper about them."""

    diagrams: DiagramsStudy
    drafting: Drafting

    @property
    def proportions(self) -> Proportions:
        """How the figure is laid out."""
        return PROPORTIONS if self.axis.closed else FORTH

    @property
    def axis(self) -> Axis:
        """The axis of all rows."""
        return self.diagrams.axis

    @property
    def omega(self) -> float:
        """How fast the crank turns, rad/s."""
        return self.diagrams.course.omega

    @cached_property
    def rows(self) -> tuple[DiagramRow, ...]:
        """The rows from the top."""
        return rows_of(self.diagrams)

    @property
    def length(self) -> float:
        """How far the axis goes, rad."""
        return float(self.axis.turned[-1])

    def named(self, key: str) -> str:
        """Name a part of the figure."""
        return f"{NAME}-{key}"

    @property
    def above(self) -> float:
        """Paper over the first row, mm: the heading of the figure."""
        return 3 * self.hand.title + LINE * self.hand.text * len(self.explained)

    @cached_property
    def explained(self) -> tuple[str, ...]:
        """Lines under the heading: what the scales follow from, what is drawn how, what is left aside."""
        (s, v, a), out, course = letters_of(self.diagrams), self.diagrams.linkage.output, self.diagrams.course
        turned = self.diagrams.linkage.coupler_point and not course.travel.sliding
        more = {"diagrams even": course.lead, "diagrams turn": turned, "diagrams along": out.along}
        rule, angle = f"diagrams rule {self.drafting.notation}", self.drafting.number(out.course, 4)
        keys = rule, "diagrams explained", *(key for key, true in more.items() if true)
        parts = {"s": s, "v": v, "a": a, "link": out.link, "point": out.point, "angle": angle}
        return tuple(line for key in keys for line in self.drafting.word(key, **parts).split("\n"))

    @property
    def widest(self) -> str:
        """The pole distance behind the scale of a row, as long as it may be."""
        return f"H_1 = 55.55 {self.drafting.word('mm')}"

    def title(self, row: DiagramRow) -> str:
        """Give the title of a row: its letter over the angle that the crank has turned."""
        return f"{row.letter}({TURNED})"

    def said(self, row: DiagramRow) -> Iterator[str]:
        """Tell from where the way is counted, by what chords a row is drawn and how far they are off; or nothing."""
        if row.flat:
            yield self.drafting.word("diagram flat")
        elif row.key == TRAVEL:
            s, v, _ = letters_of(self.diagrams)
            yield self.drafting.word(f"diagram {self.diagrams.counted}", s=s, v=v)
        else:
            above = self.rows[self.place(row) - 1].letter
            by = self.drafting.word("diagram by chords", above=above, pole=self.pole_letters(row)[0])
            yield "".join((by, *self._off(row), "" if row.thin else self.drafting.word("diagram steep")))

    def _off(self, row: DiagramRow) -> Iterator[str]:
        """Tell how far the chords are off at the most, and where."""
        if row.off is not None:
            numbers, k = self.axis.numbers, row.off.at
            place = f"{numbers[k]}–{numbers[k + 1]}" if row.key == VELOCITY else str(numbers[k])
            yield self.drafting.word(
                "diagram off", off=self.drafting.number(100 * row.off.share, PER_CENT), place=place
            )


PEAK = 1.6  # mm from a greatest or least value to its angle
DOT, RING = 0.6, 1.0  # mm, radii: of a point by chords, of one by the plans
APART = 0.8  # sizes of a number between two numbers
MARKED = 72  # positions: of more only the numbered ones have a point and a tick
TALLER = 2.2  # times the height that the rows may have where there is room
SHORTER = 12, 0.8  # positions: the axis of fewer has room for their numbers in a share of the usual least length


@dataclass(frozen=True, eq=False, repr=False)
class DiagramsFrame(RowFrame[DiagramRow]):
    """The diagrams at their scale, to be drawn."""

    plate: DiagramsPlate
    spot: Spot

    @property
    def argument(self) -> Scale:
        """The scale of time along the axis of the crank angle."""
        return Scale(self.spot.scale.mu / self.plate.omega, "t", "s")

    @cached_property
    def numbered(self) -> tuple[int, ...]:
        """The places of the axis that have room for their numbers: the ends, then every so many."""
        axis, number = self.plate.axis, self.plate.hand.number
        places = (axis.turned / self.plate.length * self.length).tolist()
        size = APART * number + text_width(Text(0j, str(max(axis.numbers)), number))
        count = len(places) - axis.closed
        step = every(size * count / self.length, count)
        order = (*range(0, len(places), step), *range(len(places)))
        return tuple(sorted(set(spaced(places, size, order, (0, len(places) - 1)))))

    @property
    def marked(self) -> Collection[int]:
        """The positions that have a tick and a point."""
        return self.numbered if self._crowded else range(len(self.plate.axis.turned))

    @property
    def _crowded(self) -> bool:
        return len(self.plate.axis.turned) > MARKED + 1

    def drawn(self, row: DiagramRow) -> Part:
        """Draw a row on its axes, each ordinate that is numbered measurable."""
        plate, hand, axes = self.plate, self.plate.hand, self.axes(row)
        graph = Graph(plate.named(row.key), axes, hand)
        lines = (
            *axes.lines((0.0, plate.length), row.span, hand, "" if row.flat else graph.name),
            *self._edges(row, graph),
            *_course(row, row.thin, "exact", graph, hand.other),
            *_course(row, row.results, "result", graph, hand.result),
            *self._points(row, graph),
            *(graph.dot(peak.turned, peak.value, RING) for peak in peaks(row, plate.axis)),
        )
        up = f"{row.letter}, {plate.drafting.word(row.unit)}"
        ends = graph.ends((plate.length, TURNED), (row.span[1], up))
        return Part(graph.name, lines, (*ends, *self._numbers(row, graph), *self._turned(row, graph)))

    def _turned(self, row: DiagramRow, graph: Graph) -> Iterator[Letter]:
        """Letter where a curve is greatest or least between two positions with the angle turned."""
        hand = self.plate.hand
        for name, turned, value in peaks(row, self.plate.axis):
            angle = self.plate.drafting.slot(Slot(name, math.degrees(turned)))
            side = OVER if name == GREATEST else UNDER
            yield Letter(graph.axes.on(turned, value), joined("", (angle, "°")), hand.number, side, PEAK)

    def _edges(self, row: DiagramRow, graph: Graph) -> Iterator[Stroke]:
        """Draw the tick of each position, and the ordinate of one that is numbered; position 0 is told once."""
        axis = self.plate.axis
        for k in self.marked:
            x, value, number = float(axis.turned[k]), _value(row, k), axis.numbers[k]
            yield graph.tick(x)
            if k in self.numbered:
                again = axis.closed and k == len(axis.turned) - 1
                ordinate = graph.ordinate(x, value, str(number), number)
                yield from flat(ordinate) if again else ordinate

    def _points(self, row: DiagramRow, graph: Graph) -> Iterator[Stroke]:
        """Draw a ring at each value by the plans, a dot at each by chords; of S, that both rest on, a dot."""
        if row.flat:
            return
        ring = (RING, self.plate.hand.other) if len(row.chords.x) else (DOT, INK)
        for k in self.marked:
            if not math.isnan(row.at[k]):
                yield graph.dot(float(self.plate.axis.turned[k]), float(row.at[k]), *ring)
        if not self._crowded:
            yield from (graph.dot(x, y, DOT) for x, y in zip(row.chords.x.tolist(), row.chords.y.tolist(), strict=True))

    def _numbers(self, row: DiagramRow, graph: Graph) -> Iterator[Letter]:
        """Number the positions at the axis, each on the side away from its ordinate."""
        axis = self.plate.axis
        for k in self.numbered:
            yield graph.number(float(axis.turned[k]), str(axis.numbers[k]), _value(row, k))


def _value(row: DiagramRow, k: int) -> float:
    """Give the ordinate of a position; of a gap, and of a row that shows nothing, there is none."""
    return 0.0 if row.flat or math.isnan(row.at[k]) else float(row.at[k])


def _course(row: DiagramRow, curves: Collection[Plot], name: str, graph: Graph, style: LineStyle) -> Iterator[Stroke]:
    """Draw curves as what they state; without a scale nothing is stated."""
    lines = [stroke for curve in curves for stroke in graph.curve(curve.x, curve.y, style)]
    yield from lines if row.flat or not lines else (graph.stated(name, lines),)


def measure(diagrams: DiagramsStudy, drafting: Drafting) -> Picture:
    """Measure the room of the diagrams."""
    plate, hand = DiagramsPlate(diagrams, drafting), drafting.hand
    head = text_width(Text(0j, title(diagrams, drafting), hand.title))
    wide = (text_width(Text(0j, line, hand.text)) for line in plate.explained)
    room, (many, share) = plate.room(NAME, ("φ", "rad"), max(head, *wide)), SHORTER
    return room._replace(taller=TALLER, least=room.least * (share if len(plate.axis.turned) < many else 1.0))


def draw(diagrams: DiagramsStudy, spot: Spot, drafting: Drafting) -> Parts:
    """Draw the diagrams in their spot, under their heading and the scales along their axis."""
    frame = DiagramsFrame(DiagramsPlate(diagrams, drafting), spot)
    scales = drafting.scale(spot.scale, frame.argument)
    head = heading(spot.box, title(diagrams, drafting), scales, drafting.hand, *frame.plate.explained)
    return Parts((Group((head,), NAME),), frame.parts)


def title(diagrams: DiagramsStudy, drafting: Drafting) -> str:
    """Head the figure with the output: a point of what slides, a link that turns."""
    travel, out = diagrams.course.travel, diagrams.linkage.output
    point = (out.point or (travel.way[0] if travel.way else "")) if travel.sliding else ""
    return drafting.word("diagrams of point" if point else "diagrams of link", link=out.link, point=point)
