"""The pressure angle over the cam's turn, alone or under the diagrams of the law over one axis (угол давления)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from drawings.cam import law_diagrams
from drawings.cam.law_frame import LawPlate
from drawings.cam.notes import phase_letter
from drawings.kinds.axes import Axes, Letter, Part, Parts
from drawings.kinds.graph import DOT, Graph, GraphForm, standing
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.lettering import spaced
from drawings.lettering.words import Phrase, Slot, joined
from drawings.page.page import Drafting, Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.paper.walk import tied
from drawings.symbols.figure import arrows, heading
from drawings.symbols.symbols import TICK, fit
from plans.cam.diagrams import LawDiagrams
from plans.model.cam import RETURN, RISE, Cam, Limits
from plans.model.cam_motion import CamFound, Contour, Extreme
from plans.model.motion import Floats

NAME, LETTER, UNIT = "pressure", "α", "°"
FORM = GraphForm(3.4, 2.0, Margins(3.2, 5.2, 0.8), 24.0)  # below it is the row of phases
UNDER = 3.2  # letters from the graph to the row of phases
APART = 2.0  # sizes of a number from one numbered position to the next


@dataclass(frozen=True)
class PressureView:
    """The pressure angle of a cam: densely, at its numbered positions, at its extremes."""

    limits: Limits  # rad
    curve: Contour  # at many turns
    found: CamFound  # with its contour at the numbered positions
    law: LawDiagrams | None = None  # what stands over it on one axis

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.found.cam

    @property
    def angles(self) -> Floats:
        """The pressure angle at many turns, degrees."""
        return np.degrees(self.curve.pressure)

    @property
    def ordinates(self) -> Floats:
        """The pressure angle at the numbered positions, degrees."""
        return np.degrees(self.found.contour.pressure)

    @property
    def levels(self) -> tuple[tuple[str, float], ...]:
        """The limits with the kinds of phases that they hold on, degrees, signed: two on each that is limited."""
        intervals = {kind: self.limits.interval(kind, self.cam.closure) for kind in (RISE, RETURN)}
        return tuple((kind, math.degrees(end)) for kind, interval in intervals.items() if interval for end in interval)

    @property
    def named(self) -> Iterator[tuple[str, float]]:
        """The limits that are lettered, on the phases that they are of: above on a rise, below on a return."""
        return ((kind, level) for kind, level in self.levels if (level > 0) == (kind == RISE))

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest angle, 0 and the limits among them, degrees."""
        every = [*self.angles.tolist(), *(math.degrees(extreme.value) for extreme in self.found.pressure.values()), 0.0]
        every += [level for _, level in self.levels]
        return min(every), max(every)

    @property
    def marked(self) -> tuple[tuple[str, Extreme], ...]:
        """The extremes that are marked, with their phases."""
        return tuple((kind, extreme) for kind, extreme in self.found.pressure.items() if extreme.value)


def measure(view: PressureView, drafting: Drafting) -> Picture:
    """Measure the room of the graph, with the diagrams over it: as wide as they are, as high as both."""
    low = _room(view, drafting)
    if view.law is None:
        return low
    law = law_diagrams.measure(view.law, drafting)
    above = law.margins.above + law.margins.below + low.margins.above
    around = law.margins._replace(above=above, below=low.margins.below)
    high = law.high + low.high
    least = law.least * max(law.wide, high) / law.wide  # the axis stays as long
    return law._replace(high=high, middle=complex(law.wide, high) / 2, margins=around, least=least)


def _room(view: PressureView, drafting: Drafting) -> Picture:
    """Measure the room of the graph alone: its scale is that of the cam's turn."""
    axis = ("x", "m") if view.cam.translates else ("φ", "rad")
    return FORM.room(NAME, view.cam.turn, axis, drafting.word("cam pressure graph"), drafting.hand)


def draw(view: PressureView, room: Picture, spot: Spot, drafting: Drafting) -> Part | Parts:
    """Draw the graph in its spot; under diagrams its axis begins where theirs do."""
    if view.law is None:
        return _graph(view, room, spot, drafting)
    law, low, (box, scale) = law_diagrams.measure(view.law, drafting), _room(view, drafting), spot
    spare = (box.height - room.size(scale)[1]) * law.high / room.high  # each is as much taller as the other
    level = box.top - law.size(scale)[1] - spare
    middle = box.left + LawPlate.proportions.left * drafting.hand.letter + law.wide / scale.mu / 2
    half = low.size(scale)[0] / 2
    under = Spot(Field(middle - half, box.bottom, middle + half, level), scale)
    over = Spot(box._replace(bottom=level), scale)
    return Parts((), (law_diagrams.draw(view.law, law, over, drafting), _graph(view, low, under, drafting)))


def _graph(view: PressureView, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw the graph: axes, limits dashed, phases under it, the curve, extremes over it."""
    hand, turn = drafting.hand, view.cam.turn
    axes = standing(room, spot, view.span, (LETTER, UNIT), drafting)
    graph = Graph(NAME, axes, hand)
    lines = (
        heading(spot.box, drafting.word("cam pressure graph"), drafting.scale(axes.up, spot.scale), hand),
        *axes.lines((0.0, turn), view.span, hand, NAME),
        *_phases(view, axes, hand),
        *_levels(view, axes, hand),
        *_stations(view, graph),
        graph.stated(LETTER, graph.curve(view.curve.turned, view.angles, hand.result)),
        *_marks(view, graph, drafting),
    )
    ends = graph.ends((turn, room.letter), (view.span[1], f"{LETTER}, {UNIT}"))
    turns, angles = view.found.contour.turned.tolist(), view.ordinates.tolist()
    numbers = (graph.number(turns[k], str(k), angles[k]) for k in _roomy(view, graph))
    letters = (*_letters(view, axes, drafting), *_named(view, axes, drafting), *numbers)
    return Part(NAME, lines, (*ends, *letters))


def _bottom(view: PressureView, axes: Axes, hand: Hand) -> float:
    """Give the level of the row of phases, mm."""
    return axes.on(0.0, view.span[0]).imag - UNDER * hand.letter


def _phases(view: PressureView, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Part the phases by thin lines down to their row, where they are dimensioned."""
    level = _bottom(view, axes, hand)
    feet = [complex(axes.on(turned).real, level) for turned in (*(p.start for p in view.cam.phases), view.cam.turn)]
    for foot in feet:
        yield Line(complex(foot.real, axes.on(0.0, view.span[1]).imag), foot - TICK * 1j, hand.drafted)
    for start, end in pairwise(feet):
        yield from arrows(start, end, hand) if tied(abs(end - start)) else ()


def _levels(view: PressureView, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    for kind, level in view.levels:
        for phase in view.cam.phases:
            if phase.kind == kind:
                start, end = (axes.on(at, level) for at in (phase.start, phase.end))
                yield Line(start, end, fit(hand.path, abs(end - start)))


def _stations(view: PressureView, graph: Graph) -> Iterator[Stroke]:
    """Draw the ordinates of the positions that bear numbers, which can be measured, and the points of all."""
    numbered = _roomy(view, graph)
    for k, (turned, angle) in enumerate(zip(view.found.contour.turned.tolist(), view.ordinates.tolist(), strict=True)):
        yield from graph.station(turned, [angle], str(k), k, k in numbered)


def _degrees(kind: str, extreme: Extreme, drafting: Drafting) -> Phrase:
    return joined("", (drafting.slot(Slot(kind, math.degrees(extreme.value))), "°"))


def _marks(view: PressureView, graph: Graph, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the extremes, which can be measured from the axis."""
    for kind, extreme in view.marked:
        angle, hand = math.degrees(extreme.value), drafting.hand
        yield from graph.ordinate(extreme.turned, angle, kind, None, hand.other, _degrees(kind, extreme, drafting), 0.0)
        yield graph.dot(extreme.turned, angle, 1.5 * DOT, hand.body)


def _letters(view: PressureView, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    hand = drafting.hand
    for kind, extreme in view.marked:
        at = axes.on(extreme.turned, math.degrees(extreme.value))
        side = math.copysign(math.pi / 2, extreme.value)
        yield Letter(at, _degrees(kind, extreme, drafting), hand.number, side, 1.6)
    for kind, level in view.named:
        phase = next((phase for phase in view.cam.phases if phase.kind == kind), None)
        if phase is not None:
            size = drafting.slot(Slot(f"[α_{kind}]", abs(level)))
            text = joined("", (drafting.letter(f"[α_{{{kind}}}] = "), size, "°"))
            side = math.pi / 2 if kind == RISE else -math.pi / 2
            yield Letter(axes.on(phase.start + 0.8 * phase.angle, level), text, hand.number, side)


def _named(view: PressureView, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    level = _bottom(view, axes, drafting.hand)
    for k, phase in enumerate(view.cam.phases):
        middle = axes.on(phase.start + phase.angle / 2).real
        text = phase_letter(view.cam, k, drafting)
        yield Letter(complex(middle, level), text, drafting.hand.number, math.pi / 2, law_diagrams.ABOVE)


def _roomy(view: PressureView, graph: Graph) -> tuple[int, ...]:
    """Choose the positions whose numbers have room."""
    return spaced([graph.axes.on(turned) for turned in view.found.contour.turned.tolist()], APART * graph.hand.number)
