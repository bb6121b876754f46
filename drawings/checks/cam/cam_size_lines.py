"""The lines, hatching, heads and words of the diagram of the main sizes (линии и надписи диаграммы размеров)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from drawings.checks.cam.cam_diagram import NEARBY, SizeDiagram
from drawings.checks.graphs.figure_strokes import FLUSH
from drawings.checks.graphs.linework import FAR, Dimensioned, Linework, Way
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.size_diagram import LEAST
from drawings.figures.cam.size_marks import ROUNDED
from drawings.figures.cam.size_view import NAME
from drawings.paper.strokes import Line
from drawings.symbols.hatching import LEAN
from drawings.symbols.symbols import HATCH_STEP, TICK
from plans.analytic.cam.contour import contour
from plans.model.motion import Complexes

SLIGHT = LEAST / 10  # mm: a shorter KD is a point
MANY = 121  # turns of a phase at which the diagram is looked for on paper
COVERED = 0.5  # mm: what a chord between corners that are held may cut off
UNDER = 6.0  # mm under O, where all limits of a follower in a guide are kept


@dataclass(frozen=True)
class SizeLines:
    """The diagram of one cam with what it must be drawn of."""

    own: SizeDiagram

    @cached_property
    def work(self) -> Linework:
        """All that it draws straight or writes."""
        return Linework(NAME, self.own.strokes, self.own.drafting.hand.symbol)

    def faults(self) -> Iterator[Wrong]:
        """Hold them all."""
        due = [*self._axes(), *self._construction(), *self._rulers(), *self._reaches(), *self._chord()]
        for size in self._sizes():
            rounded = abs(abs(size.end - size.start) - LEAST) <= FLUSH  # it may be drawn or not
            found = [*self.work.dimensions([size])]
            due += [one for one in found if isinstance(one, Way)]
            yield from (one for one in found if not isinstance(one, Way) and not rounded)
        yield from self._straight(due)
        yield from self.work.heads()
        yield from self.work.dots("D", self._spots())
        yield from self._whole()
        yield from self._hatched()
        yield from self._words()

    def on(self, place: complex) -> complex:
        """Give a place of the diagram on paper, mm."""
        return self.own.origin + place / self.own.mu

    @cached_property
    def centre(self) -> complex:
        """O on paper, mm."""
        return self.on(-self.own.known.zero)

    @cached_property
    def ends(self) -> Complexes:
        """D of the numbered positions on paper, mm; none under the face of a rocker."""
        own = self.own
        if not own.points:
            return np.zeros(0, dtype=complex)
        return np.asarray(own.origin + own.known.ends(own.expected.contour) / own.mu)

    @cached_property
    def tips(self) -> Complexes:
        """K of the numbered positions on paper, mm."""
        own, contour_ = self.own, self.own.expected.contour
        if not own.points:
            return np.zeros(0, dtype=complex)
        rocks = own.expected.cam.rocks
        places = contour_.tip - own.expected.sizes.pivot if rocks else 1j * contour_.travel.s
        return np.asarray(own.origin + places / own.mu)

    def _axes(self) -> Iterator[Way]:
        """Give the axes of S and S', or the arms of a rocker at both ends of its way."""
        own, zero = self.own, self.own.origin
        if own.expected.cam.rocks:
            yield from self._arms()
            return
        left, right = float(self.ends.real.min()), float(self.ends.real.max())
        yield Way("S'", complex(min(left, zero.real), zero.imag), complex(max(right, zero.real), zero.imag), FAR)
        top = max(float(self.tips.imag.max()), zero.imag)
        yield Way("S", complex(zero.real, min(self.centre.imag, zero.imag)), complex(zero.real, top), FAR)

    def _arms(self) -> Iterator[Way]:
        zero = self.own.origin
        if not self.own.points:
            return
        top = max(self.tips.tolist(), key=lambda one: one.imag)
        start = zero + (self.own.known.lowest - self.own.expected.sizes.pivot) / self.own.mu
        yield from (Way("l", zero, end) for end in (start, top))

    def _construction(self) -> Iterator[Way]:
        """Give the tick of each K, and KD."""
        rocks, zero = self.own.expected.cam.rocks, self.own.origin
        for k, (tip, end) in enumerate(zip(self.tips.tolist(), self.ends.tolist(), strict=True)):
            across = TICK * self.work.symbol * ((tip - zero) / abs(tip - zero) if rocks else 1.0)
            yield Way(f"K {k}", tip - across, tip + across)
            yield Way(f"K {k} D", tip, end, due=abs(end - tip) > SLIGHT + FLUSH)

    def _rulers(self) -> Iterator[Way]:
        """Give the rulers as they are held to touch, and the follower's way from which their angles are counted."""
        own = self.own
        if not own.points:
            return
        if own.expected.cam.flat:
            touch = (
                self.centre + 1j * (own.expected.found.sharpest.value if own.expected.found.sharpest else 0.0) / own.mu
            )
            yield Way("ρ_{min}", touch, touch + (1 - 1j), FAR, due=False)
            return
        for line, way in own.ruled():
            yield Way("α", line.start, line.end, due=False)
            top = max(line.start, line.end, key=lambda end: end.imag)
            yield Way("α", top, top + way / abs(way), FAR, due=False)

    def _reaches(self) -> Iterator[Way]:
        """Give what reaches from O: R0, the line of centres; the face of a rocker at the start."""
        own, sizes = self.own, self.own.expected.sizes
        cam = own.expected.cam
        if cam.rocks:
            yield Way("L", self.centre, own.origin)
        if cam.flat and cam.rocks:
            foot = self.centre + complex(own.expected.contour.lever[0]) * own.known.back * sizes.base / own.mu
            yield Way("R_0", self.centre, foot)
            along = 1j * (foot - self.centre)
            yield Way("R_0", foot, foot + along / abs(along), FAR, due=False)
            yield from (Way("O", one.start, one.end, due=False) for one in self.work.lines if self._bounding(one))
        elif not cam.flat:
            yield Way("R_0", self.centre, self.on(own.known.lowest - own.known.zero))

    def _bounding(self, line: Line) -> bool:
        """Tell whether a line goes through O: one that bounds where it may be."""
        run = line.end - line.start
        return abs(((self.centre - line.start) / run).imag) * abs(run) <= FLUSH

    def _chord(self) -> Iterator[Way]:
        """Give the chord of a rocker's way and the tangents by it, which meet in O'; they may be shown."""
        meeting = next((one.at for one in self.own.measured.points if (one.plan, one.name) == (NAME, "O'")), None)
        if meeting is None or not len(self.tips):
            return
        start, top = (way.end for way in self._arms())
        yield Way("l", start, top)
        for line in self.work.lines:
            if min(abs(line.start - meeting), abs(line.end - meeting)) <= FLUSH:
                yield Way("O'", line.start, line.end, due=False)

    def _sizes(self) -> Iterator[Dimensioned]:
        """Give the dimensions of S0 and e; under a flat face of R0 and the least radius of curvature."""
        own, sizes, zero = self.own, self.own.expected.sizes, self.own.origin
        if own.expected.cam.rocks:
            return
        foot = complex(zero.real, self.centre.imag)
        if own.expected.cam.flat:
            least = own.expected.found.sharpest.value if own.expected.found.sharpest else 0.0
            yield from self._long("R_0", sizes.base, zero, self.centre)
            yield from self._long("ρ_{min}", least, self.centre + 1j * least / own.mu, self.centre)
            return
        yield from self._long("S_0", math.sqrt(sizes.base**2 - sizes.offset**2), foot, zero)
        if abs(sizes.offset) > ROUNDED * sizes.base:
            yield Dimensioned(self._written("e", sizes.offset), self.centre, foot, -1j)

    def _long(self, letter: str, size: float, start: complex, end: complex) -> Iterator[Dimensioned]:
        if abs(end - start) >= LEAST - FLUSH:
            yield Dimensioned(self._written(letter, size), start, end, 1.0)

    def _written(self, letter: str, size: float) -> str:
        return f"{letter} = {self.own.drafting.number(1000 * size)}"

    def _straight(self, due: list[Way]) -> Iterator[Wrong]:
        """Hold the straight lines; those of the hatching are held by themselves."""
        yield from self.work.ways(due, {id(one) for one in self.hatch})
        rocks = self.own.expected.cam.rocks
        for way, name in () if rocks else ((1j, "S"), (1.0, "S'")):
            axis = (tip for tip, back in self.work.tips if abs(((tip - self.own.origin) / way).imag) <= FLUSH)
            if not any(self.work.headed(tip) and ((tip - self.own.origin) / way).real > 0 for tip in axis):
                yield on("head", NAME, name=name)

    @cached_property
    def hatch(self) -> tuple[Line, ...]:
        """The thin lines at 45 degrees of the hatching; the ruler of a flat face leans the other way."""
        thin = [one for one in self.work.lines if one.style == self.own.drafting.hand.drafted]
        return tuple(one for one in thin if abs(((one.end - one.start) / LEAN).imag) <= FLUSH)

    def _hatched(self) -> Iterator[Wrong]:
        """See that what is left to O is hatched, and nothing that a limit of a follower in a guide takes away."""
        own = self.own
        if not own.limits:
            return
        if not self.hatch:
            yield on("missing_on", NAME, name="O")
        elif not own.expected.cam.rocks:
            spots = [(end - own.origin) * own.mu for one in self.hatch for end in (one.start, one.end)]
            if any(own.beyond(limit, spot) < -NEARBY for limit in own.limits for spot in spots):
                yield on("line", NAME)
            under = self.centre - 1j * UNDER
            off = min(abs(((under - one.start) / LEAN).imag) * abs(LEAN) for one in self.hatch)
            if off > HATCH_STEP * self.work.symbol:
                yield on("missing_on", NAME, name="O")

    def _spots(self) -> Iterator[complex]:
        """Give the places of all points."""
        yield from (self.own.origin, self.centre, *self.ends.tolist())
        yield from (one.at for one in self.own.measured.points if one.plan == NAME)

    def _whole(self) -> Iterator[Wrong]:
        """See that the curve is drawn over all phases with motion."""
        own, chains = self.own, self.own.strokes.chains
        if not own.points:
            return
        drawn = [one.points for one in chains if one.style.width >= own.drafting.hand.main]
        pairs = np.array([pair for one in drawn for pair in pairwise(one)], dtype=complex)
        for phase in own.expected.cam.moving():
            turned = np.linspace(phase.start, phase.end, MANY)[1:-1]
            cam, sizes, roller = own.expected.cam, own.expected.sizes, own.expected.found.roller
            spots = own.origin + own.known.ends(contour(cam, sizes, roller, turned)) / own.mu
            if not pairs.size or _apart(spots, pairs) > COVERED:
                yield on("curve", NAME)
                return

    def _words(self) -> Iterator[Wrong]:
        """Hold the letters of points, of axes, and numbers beside their own points; no other word."""
        own, cam = self.own, self.own.expected.cam
        due = ["O", "O_1" if cam.rocks else "A"]
        axes = () if cam.rocks else ("S", "S''" if cam.flat else "S'")
        letters = [one.name for one in own.measured.points if one.plan == NAME and one.name != "D"]
        others = [text for text in own.strokes.texts if "=" in text or text == "45°"]
        numbers = [str(k) for k in range(len(own.expected.contour.turned))]
        known = [own.title, *others, *numbers, *letters, *(["A"] if cam.rocks else [])]
        yield from self.work.words([*due, *axes], known)
        for text in own.strokes.texts:
            k = int(text) if text in numbers else None
            if k is not None and not own.strokes.lettered(text, [complex(self.ends[k])]):
                yield on("letter", NAME, name=text)
        for letter, way in zip(axes, (1j, 1.0), strict=False):
            tips = [tip for tip, back in self.work.tips if abs(((tip - back) / way).imag) <= FLUSH]
            if not own.strokes.lettered(letter, tips):
                yield on("letter", NAME, name=letter)


def _apart(spots: Complexes, pairs: np.ndarray) -> float:
    """Give how far the farthest of some places is from the pieces of chains, mm."""
    start, run = pairs[:, 0], pairs[:, 1] - pairs[:, 0]
    share = np.clip(((spots[:, None] - start) * run.conj()).real / np.maximum(np.abs(run) ** 2, FLUSH**2), 0.0, 1.0)
    return float(np.abs(spots[:, None] - start - share * run).min(axis=1).max())
