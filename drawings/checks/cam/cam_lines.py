"""The lines of a cam's profile figure that bear no data: circles, axes, notches, phases, senses (линии построения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.cam.cam_expected import Expected, phase_name
from drawings.checks.graphs.figure_strokes import NEAR, FigureStrokes, Turning
from drawings.checks.letters import NEAREST
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.inversion import MISSED
from drawings.figures.cam.profile_view import NAME
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Line
from drawings.symbols.symbols import HEAD
from plans.model.cam import POINTED
from plans.model.motion import Complexes

CHORDED = 0.01  # mm: the figure looks its faces up along chords of its curves; so much is not to be seen
SHORT = 1.0  # mm: a shorter radius is drawn as no circle
SMALL = 2.5  # mm: circles of points, pins and hinges, at the full size of symbols


@dataclass(frozen=True)
class ProfileLines:
    """The lines of one figure with what they must be."""

    strokes: FigureStrokes
    expected: Expected
    origin: complex  # O on paper, mm
    mu: float
    drafting: Drafting

    def faults(self) -> Iterator[Wrong]:
        """Hold them all."""
        if not self.expected.cam.translates:
            yield from self._circles()
            yield from self._phases()
            yield from self._senses()
        else:
            yield from self._travel()
        if self.expected.cam.flat:
            yield from self._faces()
        if not (self.expected.cam.flat and self.expected.cam.rocks):
            yield from self._frames()
        yield from self._notches()
        yield from self._rollers()
        yield from self._follower()

    def on(self, place: complex) -> complex:
        """Give a place of the cam on paper, mm."""
        return self.origin + place / self.mu

    @cached_property
    def spots(self) -> Complexes:
        """The points of the pitch curve on paper, mm, (N,)."""
        return np.asarray(self.origin + self.expected.contour.pitch / self.mu)

    def _circles(self) -> Iterator[Wrong]:
        """Hold the circles about O: of the least radius, of the offset, of the pivots; there is no other."""
        sizes = self.expected.sizes
        true = {"R_0": sizes.base, "e": abs(sizes.offset), "O_1": abs(sizes.pivot)}
        radii = {name: size / self.mu for name, size in true.items() if size / self.mu > SHORT}
        for name, radius in radii.items():
            if not self.strokes.circled(self.origin, radius):
                yield on("circle", NAME, name=name)
        for one in self.strokes.circles:
            about = abs(one.centre - self.origin) <= NEAR and one.radius > SMALL * self.drafting.hand.symbol
            if about and min((abs(one.radius - radius) for radius in radii.values()), default=0.0) > NEAR:
                yield on("circle", NAME, name=f"{one.radius * self.mu * 1000:.4g}")

    def _frames(self) -> Iterator[Wrong]:
        """Hold the turned frame of each position: the axis with its number at its far end, or the arm of a rocker."""
        own, rocks = self.expected.contour, self.expected.cam.rocks
        feet = self.expected.back(np.full_like(own.pitch, self.expected.axis), own.turned)
        ways = self.expected.ways(np.full_like(own.pitch, 1j), own.turned)
        for k, (spot, foot, up) in enumerate(zip(self.spots.tolist(), feet.tolist(), ways.tolist(), strict=True)):
            way = spot - self.on(foot) if rocks else up
            level = (way.conjugate() * (spot - self.on(foot))).real / abs(way) ** 2
            lines = self.strokes.through(self.on(foot) + level * way, way)
            if not lines:
                yield on("axis", NAME, name=str(k))
            elif not rocks and not self._numbered(k, spot, lines):
                yield on("letter", NAME, name=str(k))

    def _faces(self) -> Iterator[Wrong]:
        """Hold the turned faces: as long as they reach, contact beyond the end of one ringed."""
        for k, (spot, normal) in enumerate(zip(self.spots.tolist(), self.expected.normals.tolist(), strict=True)):
            if self.expected.cam.follower.reach is None:
                right = bool(self.strokes.through(spot, -1j * normal, CHORDED))
            else:
                right = self._reaching(k, spot)
            if not right:
                yield on("face", NAME, name=str(k))

    def _reaching(self, k: int, spot: complex) -> bool:
        """Tell whether a turned face ends where it must, and contact that is beyond is ringed."""
        start, end = (self.on(one) for one in self._face(k))
        off = abs(spot - (start + end) / 2) - abs(end - start) / 2
        ringed = self.strokes.circled(spot, MISSED * self.drafting.hand.symbol)
        return self.strokes.joins(start, end, CHORDED) and (ringed == (off > 0) or abs(off) <= CHORDED)

    def _face(self, k: int) -> tuple[complex, complex]:
        """Give the ends of the face of a position, m: its reach to both sides of the axis, or from the pivot on."""
        own, reach = self.expected.contour, self.expected.cam.follower.reach or 0.0
        along = -1j * self.expected.normals
        feet = self.expected.back(np.full_like(own.pitch, self.expected.axis), own.turned)
        off = ((own.pitch - feet) * along.conj()).real
        low, high = (0.0, math.copysign(reach, off.sum())) if self.expected.cam.rocks else (-reach, reach)
        return complex(own.pitch[k] + (low - off[k]) * along[k]), complex(own.pitch[k] + (high - off[k]) * along[k])

    def _numbered(self, k: int, spot: complex, lines: Iterable[Line]) -> bool:
        """Tell whether an axis bears the number of its position at an end beyond its place."""
        zero = complex(spot.real, self.origin.imag) if self.expected.cam.translates else self.origin
        ends = (end for one in lines for end in (one.start, one.end) if abs(end - zero) > abs(spot - zero))
        return self.strokes.lettered(str(k), ends)

    def _notches(self) -> Iterator[Wrong]:
        """Hold the notches: through each point an arc about O, and one about its turned pivot."""
        cam, own = self.expected.cam, self.expected.contour
        if cam.flat or cam.translates:
            return
        pivots = self.expected.back(np.full_like(own.pitch, self.expected.sizes.pivot), own.turned)
        for k, spot in enumerate(self.spots.tolist()):
            about = [self.origin, self.on(complex(pivots[k]))] if cam.rocks else [self.origin]
            if not all(self.strokes.arched(centre, spot) for centre in about):
                yield on("notch", NAME, name=str(k))

    def _rollers(self) -> Iterator[Wrong]:
        """Hold the rollers: that of the start in its place, all others about points of the pitch curve."""
        radius = self.expected.found.roller / self.mu
        if radius <= SHORT:
            return
        start = self.on(complex(self.expected.contour.tip[0]))
        if not self.strokes.circled(start, radius):
            yield on("roller", NAME, name="0")
        for one in self.strokes.circles:
            apart = abs(one.centre - self.origin) > NEAR and one.radius > SMALL * self.drafting.hand.symbol
            off = np.abs(np.append(self.spots, start) - one.centre)
            if apart and (off.min() > NEAR or abs(one.radius - radius) > NEAR):
                yield on("roller", NAME, name=str(int(off[:-1].argmin())))

    def _follower(self) -> Iterator[Wrong]:
        """Hold the follower at the start: rod or arm in main lines, and its point or its face."""
        cam, own, hand = self.expected.cam, self.expected.contour, self.drafting.hand
        tip = self.on(complex(own.tip[0]))
        away = self.on(self.expected.sizes.pivot) - tip if cam.rocks else 1j
        spot = complex(self.on(self.expected.axis).real, tip.imag) if cam.flat and not cam.rocks else tip
        thick = [one for one in self.strokes.through(spot, away) if one.style.width >= hand.main]
        if not thick and not (cam.flat and cam.rocks):
            yield on("follower", NAME)
        normal = complex(self.expected.normals[0])
        if cam.follower.reach is not None:  # contact may be beyond it
            tip = self.on(sum(self._face(0)) / 2)
        faces = self.strokes.through(tip, -1j * normal, CHORDED) if cam.flat else []
        if cam.flat and not any(one.style.width >= hand.main for one in faces):
            yield on("follower", NAME)
        fills = (one.points[0] for one in self.strokes.heads)
        if cam.follower.end == POINTED and not any(abs(one - tip) <= NEAR for one in fills):
            yield on("follower", NAME)

    @cached_property
    def _turnings(self) -> list[Turning]:
        """The arrows about O."""
        return [one for one in self.strokes.turnings if abs(one.centre - self.origin) <= NEAR]

    @property
    def ring(self) -> float:
        """The radius of the arcs of the phases, mm: the outermost."""
        return max((one.radius for one in self._turnings), default=0.0)

    def _phases(self) -> Iterator[Wrong]:
        """Hold the arcs of the phases: an arrow's tip at either end of each, its letter beside its middle."""
        cam, ring = self.expected.cam, self.ring
        arrows = [one for one in self._turnings if one.radius >= ring - NEAR]
        for number, phase in enumerate(cam.phases):
            start, end = (self.crossing(turned, ring) for turned in (phase.start, phase.end))
            middle = self.origin + (start - self.origin) * cmath.rect(1.0, -cam.sense * phase.angle / 2)
            letter = phase_name(cam, number, self.drafting)
            if not all(any(self._leads(one, middle, tip) for one in arrows) for tip in (start, end)):
                yield on("phase", NAME, name=letter)
            if not self.strokes.lettered(letter, [middle]):
                yield on("letter", NAME, name=letter)
        if len(arrows) != 2 * len(cam.phases):
            yield on("phase", NAME, name="φ")

    def _leads(self, one: Turning, middle: complex, tip: complex) -> bool:
        """Tell whether an arrow leads from the middle of a phase to an end of it; of a short one the tip is held."""
        short = abs(tip - middle) < 2 * HEAD[0] * self.drafting.hand.symbol
        return abs(one.tip - tip) <= NEAR and (short or abs(one.start - middle) <= NEAR)

    def crossing(self, turned: float, radius: float) -> complex:
        """Give where a turned axis, or the ray through a turned pivot, meets a circle about O on paper."""
        axis = self.expected.axis / self.mu
        start = axis / abs(axis) * radius if self.expected.cam.rocks else complex(axis.real, _leg(radius, axis.real))
        return self.origin + complex(self.expected.ways(start, turned))

    def _senses(self) -> Iterator[Wrong]:
        """Hold the two arrows of rotation: that of the cam nearer to its own letter, that of the frame to the other."""
        own = [one for one in self._turnings if one.radius < self.ring - NEAR]
        letters = {self.expected.cam.sense: "ω", -self.expected.cam.sense: "−ω"}
        if sorted(one.sense for one in own) != [-1, 1]:
            yield on("sense", NAME, name="ω")
            return
        for one in own:
            right, other = (self.strokes.far(letters[sense * one.sense], [one.middle]) for sense in (1, -1))
            if not (right <= NEAREST and right < other):
                yield on("sense", NAME, name=letters[one.sense])

    def _travel(self) -> Iterator[Wrong]:
        """Hold the arrow of a cam that translates, and the dimensions of its phases."""
        cam = self.expected.cam
        ways = [one for one in self.strokes.pointings if self.strokes.lettered("v", [(one.start + one.tip) / 2])]
        if not any(
            abs((one.tip - one.start).imag) <= NEAR and (one.tip - one.start).real * cam.sense < 0 for one in ways
        ):
            yield on("sense", NAME, name="v")
        for number, phase in enumerate(cam.phases):
            ends = [self.on(complex(self.expected.back(0j, turned))).real for turned in (phase.start, phase.end)]
            letter = phase_name(cam, number, self.drafting)
            lines = [one for one in self.strokes.lines if spans(one.start, one.end, ends)]
            if not any(self.strokes.lettered(letter, [(one.start + one.end) / 2]) for one in lines):
                yield on("phase", NAME, name=letter)


def _leg(radius: float, aside: float) -> float:
    return math.sqrt(max(radius**2 - aside**2, 0.0))


def spans(start: complex, end: complex, ends: list[float]) -> bool:
    """Tell whether a level line goes from one place to another."""
    level = abs((end - start).imag) <= NEAR
    xs = sorted((start.real, end.real))
    return level and max(abs(one - other) for one, other in zip(xs, sorted(ends), strict=True)) <= NEAR
