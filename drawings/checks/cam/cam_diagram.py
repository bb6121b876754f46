"""The diagram of the main sizes held to the analysis: D, rulers at their limits, O, R0, L (диаграмма S - S')."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.checks.cam.cam_expected import Expected
from drawings.checks.cam.cam_told import numbers
from drawings.checks.cam.known_diagram import KnownDiagram
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.size_diagram import APART, LEAST
from drawings.figures.cam.size_view import NAME
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredMark
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Arc, Line
from plans.analytic.cam.stretches import Peak, peak, stretches
from plans.model.cam import FORCE, RETURN, RISE, limits_of

FAR = 1e-9  # of the largest length: both roads agree far better
RULED = 1e-3  # mm: a ruler is drawn so near to where it lies
LONGEST = 500.0  # mm: no ruler of a figure is longer
NEARBY = 0.1  # mm: what looking between so many turns may miss


class Limit(NamedTuple):
    """A limit of the pressure angle: on which kind of phase, to which side of 0, rad."""

    kind: str
    side: int
    angle: float


@dataclass(frozen=True)
class SizeDiagram:
    """The figure of the main sizes with what it must show."""

    strokes: FigureStrokes
    measured: Measured
    expected: Expected
    origin: complex  # A, or O1 of a rocker, on paper, mm
    mu: float
    drafting: Drafting

    def faults(self) -> Iterator[Wrong]:
        """Hold it whole."""
        yield from self._marks()
        if self.points:
            yield from self._rulers()
            yield from self._curve()
        yield from numbers(self.strokes, self._due(), self.drafting)

    @property
    def title(self) -> str:
        """Its title: by what the sizes are found."""
        kind = "flat" if self.expected.cam.flat else self.expected.cam.follower.motion
        return self.drafting.word(f"cam sizes by {kind}")

    @property
    def points(self) -> bool:
        """Whether it has a diagram: the face of a rocker has none."""
        return not (self.expected.cam.flat and self.expected.cam.rocks)

    @cached_property
    def known(self) -> KnownDiagram:
        """Where the analysis has it."""
        return KnownDiagram(self.expected, self.mu)

    def _marks(self) -> Iterator[Wrong]:
        """Hold the points D that have room for a number, O, R0 and L; what rulers touch is held with the rulers."""
        true = dict(self._true())
        size = max(abs(value) for value in true.values())
        own = {(one.name, one.position): one for one in self.measured.marks if one.plan == NAME}
        slack = 2 * self.measured.quantum * self.mu + FAR * size
        for (name, k), value in true.items():
            called = name if k is None else f"{name} {k}"
            if (name, k) in own and not abs(own[name, k].value - value) <= slack:
                yield on("differs_on", NAME, name=called)
            elif (name, k) not in own and (name != "D" or self._roomy(own, value, k or 0)):
                yield on("missing_on", NAME, name=called)
            if name == "D" and not self._dotted(value):
                yield on("edge", NAME, name=called)
        for name, k in own.keys() - true.keys():
            if not (name.startswith("T_") or (name == "O'" and self.expected.cam.rocks)):
                yield on("stranger_on", NAME, name=name if k is None else f"{name} {k}")

    def _roomy(self, own: Mapping[tuple[str, int | None], MeasuredMark], value: complex, k: int) -> bool:
        """Tell whether a point that is none of the follower's way has room for its number."""
        travel = self.expected.contour.travel
        off = abs((travel.bend if self.expected.cam.flat else travel.slope)[k]) > FAR
        crowd = APART * self.drafting.hand.number * self.mu
        others = (one.value for (name, _), one in own.items() if name == "D")
        return bool(off) and all(abs(one - value) > crowd for one in others)

    def _dotted(self, value: complex) -> bool:
        spot = self.origin + value / self.mu
        return any(abs(one.centre - spot) <= RULED for one in self.strokes.circles)

    def _true(self) -> Iterator[tuple[tuple[str, int | None], complex]]:
        cam, own = self.expected.cam, self.expected.contour
        yield ("O", None), -self.known.zero
        if self.points:
            yield from ((("D", k), end) for k, end in enumerate(self.known.ends(own).tolist()))
        if not cam.flat:
            yield ("R_0", None), self.known.lowest
        elif cam.rocks:
            yield ("R_0", None), complex(own.lever[0]) * self.known.back * self.expected.sizes.base
        if cam.rocks:
            yield ("L", None), self.known.zero

    @cached_property
    def limits(self) -> tuple[Limit, ...]:
        """The limits that rulers are drawn at."""
        cam = self.expected.cam
        known, kinds = limits_of(cam), {one.kind for one in cam.moving()}
        own = [Limit(RISE, 1, known.rise or 0.0), Limit(RETURN, -1, known.back or 0.0)]
        own += [Limit(RISE, -1, known.rise or 0.0)] if cam.closure == FORCE else []
        return () if cam.flat else tuple(one for one in own if one.angle and one.kind in kinds)

    def _rulers(self) -> Iterator[Wrong]:
        """Hold the rulers: one at each limit, that touches the diagram and has none of it beyond, with its angle."""
        spots = [one.value for one in self.measured.points if one.plan == NAME and one.name.startswith("T_")]
        if self.expected.cam.flat:
            yield from self._convex(spots)
            return
        if len(spots) > len(self.limits):
            yield on("touch", NAME, name=f"T_{len(spots)}")
        spots += [] if self.expected.cam.rocks else [*self._near_start()]
        found = {one: [line for spot in spots for line in self._ruled(one, spot)] for one in self.limits}
        for one, lines in found.items():
            letter = self._letter(one)
            if not lines:
                yield on("touch", NAME, name=letter)
            elif not self._lettered(one, found):
                yield on("letter", NAME, name=letter)

    def _lower(self, one: Limit) -> bool:
        """Tell whether a limit is that below 0 of a rise."""
        return one.kind == RISE and one.side < 0

    def _letter(self, one: Limit) -> str:
        """Write the letter of a limit, with its sign where a rise has two."""
        return ("−" if self._lower(one) else "") + self.drafting.letter(f"α_{{{one.kind}}}")

    def _lettered(self, one: Limit, found: Mapping[Limit, list[Line]]) -> bool:
        """Tell whether the letter of a limit stands nearer to the arcs of its angle than to those of another."""
        own = self._arcs(one, found[one])
        others = [spot for other in found if other != one for spot in self._arcs(other, found[other])]
        angle = -one.angle if self._lower(one) else one.angle
        text = f"{self._letter(one)} = {self.drafting.number(math.degrees(angle))}°"
        return self.strokes.far(text, own) < self.strokes.far(text, others)

    def _arcs(self, one: Limit, lines: list[Line]) -> list[complex]:
        """Give the middles of the arcs of an angle: between a ruler and the follower's way, about its upper end."""
        angle = self.expected.cam.sense * one.side * one.angle
        return [_middle(arc) for arc in self.strokes.arcs for line in lines if _between(arc, line, angle)]

    def ruled(self) -> Iterator[tuple[Line, complex]]:
        """Give the rulers that touch, each with the follower's way there."""
        spots = [one.value for one in self.measured.points if one.plan == NAME and one.name.startswith("T_")]
        spots += [] if self.expected.cam.rocks else [*self._near_start()]
        for limit in self.limits:
            for spot in spots:
                lean = self.expected.cam.rising * spot / abs(spot) if self.expected.cam.rocks else 1.0 + 0j
                yield from ((line, 1j * lean) for line in self._ruled(limit, spot))

    def _ruled(self, one: Limit, spot: complex) -> Iterator[Line]:
        """Give the rulers through a point of the diagram at a limit: against the follower's way there by its angle."""
        cam = self.expected.cam
        lean = cam.rising * spot / abs(spot) if cam.rocks else 1.0
        way = 1j * lean * cmath.exp(1j * cam.sense * one.side * one.angle)
        if abs(self.beyond(one, spot)) <= RULED:
            # Near O1 the rounding of the point turns the way of K: along a ruler it is off by so much.
            turned = self.measured.quantum / (abs(spot) / self.mu) * LONGEST if cam.rocks else 0.0
            yield from self.strokes.through(self.origin + spot / self.mu, way, RULED + turned)

    def beyond(self, one: Limit, spot: complex) -> float:
        """Give how far the diagram goes beyond a ruler on paper, mm; of a rocker whether it is touched at all."""
        cam = self.expected.cam
        if cam.rocks:
            return 0.0 if self.known.off(np.array([spot]))[0] <= NEARBY else math.inf
        t, most = math.tan(one.angle), self._touches[one].value
        return (-one.side * cam.sense * spot.real - t * spot.imag - most) * math.cos(one.angle) / self.mu

    @cached_property
    def _touches(self) -> Mapping[Limit, Peak]:
        return {one: self._touch(one) for one in self.limits}

    def _touch(self, one: Limit) -> Peak:
        """Give where a ruler touches the diagram of a follower that translates: side*S' - S tan α is the greatest."""
        t = math.tan(one.angle)
        along = stretches(self.expected.cam, (one.kind,))
        return peak(along, lambda at: one.side * at.slope - t * at.s, lambda at: one.side * at.bend - t * at.slope)

    def _near_start(self) -> Iterator[complex]:
        """Give the touches that are too near to A for letters of their own."""
        for one in self.limits:
            touch = self._touches[one]
            at = touch.stretch.at(np.array([touch.share]))
            spot = complex(-self.expected.cam.sense * at.slope[0], at.s[0])
            if abs(spot) <= LEAST * self.mu + RULED * self.mu:
                yield spot

    def _convex(self, spots: list[complex]) -> Iterator[Wrong]:
        """Hold the ruler of a flat face: on it S + S'' is the least, which is ρ_min less R0."""
        own, sharpest = self.expected.sizes, self.expected.found.sharpest
        for spot in spots:
            least = 0.0 if sharpest is None else sharpest.value - own.base
            lines = self.strokes.through(self.origin + spot / self.mu, 1 - 1j, RULED)
            if not lines or abs(spot.real + spot.imag - least) > RULED * self.mu:
                yield on("touch", NAME, name="T_1")

    def _curve(self) -> Iterator[Wrong]:
        """Hold the curve: each corner of it is on the diagram."""
        chains = [one for one in self.strokes.chains if one.style.width >= self.drafting.hand.main]
        drawn = np.array([spot for one in chains for spot in one.points])
        if not drawn.size or self.known.off((drawn - self.origin) * self.mu).max() > NEARBY:
            yield on("curve", NAME)

    def _due(self) -> Mapping[str, tuple[float, ...]]:
        """Give the numbers that may be written, by their letters; each has room or not."""
        own, sharpest = self.expected.sizes, self.expected.found.sharpest
        level = math.sqrt(own.base**2 - own.offset**2)
        due = {"R_0": own.base, "S_0": level, "e": own.offset, "L": own.centre}
        due |= {"ρ_{min}": sharpest.value if sharpest else 0.0, "l": self.expected.cam.follower.length or 0.0}
        found = {letter: (1000 * value,) for letter, value in due.items()}
        for one in self.limits:
            found[self._letter(one)] = (math.degrees(one.side * one.angle if self._lower(one) else one.angle),)
        return found


def _between(arc: Arc, line: Line, angle: float) -> bool:
    """Tell whether an arc goes from a ruler to a way that it leans from by an angle, both produced upward."""
    up = _upward(line.end - line.start)
    due = [-up, -_upward(up * cmath.rect(1.0, -angle))]
    ends = [cmath.rect(1.0, turn) for turn in (arc.start_angle, arc.end_angle)]
    off = min(max(map(abs, np.subtract(ends, ways))) for ways in (due, due[::-1]))
    corner = max(line.start, line.end, key=lambda end: end.imag)
    return abs(arc.centre - corner) <= RULED and arc.radius * off <= RULED


def _middle(arc: Arc) -> complex:
    return arc.centre + cmath.rect(arc.radius, arc.start_angle + arc.sweep / 2)


def _upward(way: complex) -> complex:
    return math.copysign(1.0, way.imag) * way / abs(way)
