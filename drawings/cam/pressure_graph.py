"""The graph of the pressure angle over the cam's turn: limits, extremes with values, phases (угол давления)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from drawings.cam.notes import phase_letter
from drawings.kinds.axes import BEYOND, Axes, Letter
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import Phrase, Slot, joined, telling
from drawings.page.scale import Drafting, Scale, fitting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, Polyline, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.dashes import fit
from drawings.symbols.figure import Subject, heading
from drawings.symbols.symbols import TICK
from plans.model.cam import DWELL, RETURN, RISE, Cam, Limits
from plans.model.cam_motion import CamFound, Contour, Extreme
from plans.model.motion import Floats

NAME, LETTER, UNIT = "pressure", "α", "°"
RATIO = 3.4  # it is drawn so many times as long as high
TALLER = 2.0  # times as high as that, where there is room
MARGINS = Margins(3.2, 5.2, 0.8)  # paper around it for letters and the row of phases, in sizes of a letter
LETTERS = 24.0  # it is drawn at least so many letters long
UNDER = 3.2  # letters from the graph to the row of phases
DOT = 0.7  # mm, radius of a point
LEAST = 0.05  # mm: a shorter ordinate is a point
APART = 2.0  # sizes of a number from one numbered position to the next


@dataclass(frozen=True)
class PressureView:
    """The pressure angle of a cam: densely, at its numbered positions, at its extremes; degrees, over rad or m."""

    cam: Cam
    limits: Limits  # rad
    turned: Floats  # dense
    angles: Floats  # degrees
    stations: Floats  # of the numbered positions
    ordinates: Floats  # degrees
    extremes: Mapping[str, Extreme]  # rad: on each kind of phase

    @property
    def levels(self) -> tuple[tuple[str, float], ...]:
        """The limits with the kinds of phases that they hold on, degrees, signed: two on each that is limited."""
        held = {kind: self.limits.interval(kind, self.cam.closure) for kind in (RISE, RETURN)}
        return tuple((kind, math.degrees(end)) for kind, interval in held.items() if interval for end in interval)

    @property
    def named(self) -> Iterator[tuple[str, float]]:
        """The limits that are lettered, on the phases that they are of: above on a rise, below on a return."""
        return ((kind, level) for kind, level in self.levels if (level > 0) == (kind == RISE))

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest angle, 0 and the limits among them, degrees."""
        every = [*self.angles.tolist(), *(math.degrees(one.value) for one in self._moving), 0.0]
        every += [level for _, level in self.levels]
        return min(every), max(every)

    @property
    def _moving(self) -> tuple[Extreme, ...]:
        return tuple(one for kind, one in self.extremes.items() if kind != DWELL)

    @property
    def marked(self) -> tuple[tuple[str, Extreme], ...]:
        """The extremes that are marked, with their phases."""
        return tuple((kind, one) for kind, one in self.extremes.items() if kind != DWELL and one.value)


def pressure_view(limits: Limits, curve: Contour, found: CamFound) -> PressureView:
    """Give what the graph shows of a cam: its contour at many turns, and what is found at its numbered positions."""
    own, angles = found.contour, np.degrees(curve.pressure)
    return PressureView(found.cam, limits, curve.turned, angles, own.turned, np.degrees(own.pressure), found.pressure)


@dataclass(frozen=True)
class PressureFigure:
    """The graph placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    lines: tuple[Stroke, ...]
    letters: tuple[Letter, ...]

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole graph, its limits, extremes, phases and positions lettered."""
        ranked = sorted(self.letters, key=lambda one: -one.size)
        placed = (labels.beside(one.at, one.text, one.size, one.gap, one.side) for one in ranked)
        letters = tuple(telling(NAME, one) for one in placed)
        return (Group((*self.lines, Group(letters)), NAME),)


def measure(view: PressureView, drafting: Drafting) -> Picture:
    """Measure the room of the graph: its scale is that of the cam's turn, the angle's own follows from the height."""
    hand, high = drafting.hand, view.cam.turn / RATIO
    side, below, above = (share * hand.letter for share in MARGINS)
    margins = Margins(side + BEYOND / 2, below, above + BEYOND + 2 * hand.title + hand.text)
    title = text_width(Text(0j, drafting.word("cam pressure graph"), hand.title))
    letter, unit = ("x", "m") if view.cam.translates else ("φ", "rad")
    middle = complex(view.cam.turn, high) / 2
    return Picture(
        NAME, view.cam.turn, high, middle, letter, unit, margins, title, LETTERS * hand.letter, taller=TALLER
    )


def draw(view: PressureView, room: Picture, spot: Spot, drafting: Drafting) -> PressureFigure:
    """Draw the graph in its spot: axes, limits dashed, phases under it, the curve, extremes over it."""
    room, hand, (low, high) = room.filling(spot), drafting.hand, view.span
    up = fitting((high - low) or 1.0, room.high / spot.scale.mu, LETTER, UNIT, drafting.standard)
    axes = Axes(room.place(*spot).on(0j) + 1j * _lift(room, spot, up, low, high), spot.scale, up)
    scales = f"{drafting.scale(up)};  {drafting.scale(spot.scale)}"
    lines = (
        heading(spot.box, drafting.word("cam pressure graph"), scales, hand),
        *axes.lines((0.0, view.cam.turn), (low, high), hand, NAME),
        *_phases(view, axes, hand),
        *_levels(view, axes, hand),
        *_stations(view, axes, hand),
        stating(
            Statement(Kind.CURVE, NAME, LETTER),
            Polyline(tuple(axes.on(*one) for one in _curve(view)), False, hand.result),
        ),
        *_marks(view, axes, drafting),
    )
    letters = (*_letters(view, axes, drafting), *_named(view, axes, drafting), *_numbers(view, axes, hand))
    return PressureFigure(lines, letters)


def _lift(room: Picture, spot: Spot, up: Scale, low: float, high: float) -> float:
    """Give how far over the bottom of its room the axis lies, mm."""
    spare = room.high / spot.scale.mu - (high - low) / up.mu
    return spare / 2 - low / up.mu


def _curve(view: PressureView) -> Iterator[tuple[float, float]]:
    yield from zip(view.turned.tolist(), view.angles.tolist(), strict=True)


def _bottom(view: PressureView, axes: Axes, hand: Hand) -> float:
    """Give the level of the row of phases, mm."""
    return axes.on(0.0, view.span[0]).imag - UNDER * hand.letter


def _phases(view: PressureView, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Part the phases by thin lines down to their row."""
    level = _bottom(view, axes, hand)
    for turned in (*(one.start for one in view.cam.phases), view.cam.turn):
        at = axes.on(turned).real
        yield Line(complex(at, axes.on(0.0, view.span[1]).imag), complex(at, level - TICK), hand.drafted)


def _levels(view: PressureView, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw the limits over their own phases."""
    for kind, level in view.levels:
        for one in view.cam.phases:
            if one.kind == kind:
                start, end = (axes.on(at, level) for at in (one.start, one.end))
                yield Line(start, end, fit(hand.path, abs(end - start)))


def _stations(view: PressureView, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw the ordinates of the positions that bear numbers, which can be measured, and the points of all."""
    numbered = _roomy(view, axes, hand)
    for k, (turned, angle) in enumerate(zip(view.stations.tolist(), view.ordinates.tolist(), strict=True)):
        foot, tip = axes.on(turned), axes.on(turned, angle)
        yield Line(foot - 1j * TICK, foot + 1j * TICK, hand.drafted)
        if k in numbered and abs(tip - foot) > LEAST:
            data = Subject(NAME, LETTER, k).data("vector", str(k), 1j * angle, axes.up)
            yield Group((Line(foot, tip, hand.drafted),), "", data, str(k))
        yield Circle(tip, DOT * hand.symbol, INK)


def _degrees(kind: str, one: Extreme, drafting: Drafting) -> Phrase:
    return joined("", (drafting.slot(Slot(kind, math.degrees(one.value))), "°"))


def _marks(view: PressureView, axes: Axes, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the extremes, which can be measured from the axis."""
    hand = drafting.hand
    for kind, one in view.marked:
        foot = axes.on(one.turned)
        tip = axes.on(one.turned, math.degrees(one.value))
        data = Subject(NAME, LETTER, None).data("vector", kind, 1j * math.degrees(one.value), axes.up)
        yield Group((Line(foot, tip, hand.other),), "", data, _degrees(kind, one, drafting))
        yield Circle(tip, 1.5 * DOT * hand.symbol, hand.body)


def _letters(view: PressureView, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    """Letter the axes, the limits and the extremes."""
    hand = drafting.hand
    yield Letter(axes.on(0.0, view.span[1]) + BEYOND * 1j, f"{LETTER}, {UNIT}", hand.letter, 0.0)
    yield Letter(axes.on(view.cam.turn) + BEYOND, "x" if view.cam.translates else "φ", hand.letter, math.pi / 2)
    for kind, one in view.marked:
        at = axes.on(one.turned, math.degrees(one.value))
        side = math.copysign(math.pi / 2, one.value)
        yield Letter(at, _degrees(kind, one, drafting), hand.number, side, 1.6)
    for kind, level in view.named:
        own = next((one for one in view.cam.phases if one.kind == kind), None)
        if own is not None:
            size = drafting.slot(Slot(f"[α_{kind}]", abs(level)))
            text = joined("", (drafting.letter(f"[α_{{{kind}}}] = "), size, "°"))
            side = math.pi / 2 if kind == RISE else -math.pi / 2
            yield Letter(axes.on(own.start + 0.8 * own.angle, level), text, hand.number, side)


def _named(view: PressureView, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    """Name the phases in their row."""
    level = _bottom(view, axes, drafting.hand)
    for k, one in enumerate(view.cam.phases):
        middle = axes.on(one.start + one.angle / 2).real
        yield Letter(
            complex(middle, level), phase_letter(view.cam, k, drafting), drafting.hand.number, -math.pi / 2, 0.0
        )


def _numbers(view: PressureView, axes: Axes, hand: Hand) -> Iterator[Letter]:
    """Number the positions at the axis, each on the side away from its ordinate, those that have room."""
    for k in _roomy(view, axes, hand):
        side = math.pi / 2 if axes.below(float(view.ordinates[k])) else -math.pi / 2
        yield Letter(axes.on(float(view.stations[k])), str(k), hand.number, side, TICK + 0.6)


def _roomy(view: PressureView, axes: Axes, hand: Hand) -> tuple[int, ...]:
    """Choose the positions whose numbers have room."""
    last, kept = -np.inf, list[int]()
    for k, turned in enumerate(view.stations.tolist()):
        foot = axes.on(turned)
        if tied(foot.real - last - APART * hand.number) >= 0:
            last = foot.real
            kept.append(k)
    return tuple(kept)
