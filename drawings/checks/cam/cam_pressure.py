"""The graph of the pressure angle held to the analysis: curve, ordinates, extremes, limits (диаграмма угла)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.cam.cam_expected import Expected, phase_name
from drawings.checks.graphs.figure_strokes import FLUSH, FigureStrokes, read
from drawings.checks.graphs.linework import FAR, Linework, Way
from drawings.checks.graphs.scale_line import scale_line, written_scales
from drawings.checks.letters import NEAREST
from drawings.checks.precise import KNOWN
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.pressure_graph import LEAST, NAME
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.symbols.symbols import TICK
from plans.analytic.cam.contour import Curve
from plans.model.cam import RETURN, RISE, limits_of
from plans.model.cam_motion import Extreme
from plans.model.motion import Floats
from plans.words.words import message

DENSE = 721  # turns at which the least and the greatest angle are looked up: the axis goes beyond both


@dataclass(frozen=True)
class PressureGraph:
    """The graph with what it must show; along it the cam's turn, rad, or its travel, m."""

    strokes: FigureStrokes
    measured: Measured
    expected: Expected
    drafting: Drafting

    def faults(self) -> Iterator[Wrong]:
        """Hold it whole."""
        turn = "x" if self.expected.cam.translates else "φ"
        if turn not in self.written or math.isnan(self.mu):  # nothing says where an angle lies
            yield message("wrong.scale", text=f"μ_{turn}")
            return
        yield from self._scales()
        yield from self._ordinates()
        yield from self._extremes()
        yield from self._curve()
        yield from self._limits()
        yield from self._phases()
        yield from self._lines()
        yield from self._words()

    @cached_property
    def work(self) -> Linework:
        """All that it draws straight or writes."""
        return Linework(NAME, self.strokes, self.drafting.hand.symbol)

    def _lines(self) -> Iterator[Wrong]:
        """Hold all straight lines, heads and dots."""
        cam, own = self.expected.cam, self.expected.contour
        angles = np.degrees(own.pressure).tolist()
        dense = np.concatenate(self._pressure(np.linspace(0.0, cam.turn, DENSE)))
        low, high = min(0.0, float(dense.min())), max(0.0, float(dense.max()))
        due = [Way("φ", self.zero, self.on(cam.turn), FAR), Way("α", self.on(0.0, low), self.on(0.0, high), FAR)]
        spots = [self.on(turned, angle) for turned, angle in zip(own.turned.tolist(), angles, strict=True)]
        for k, spot in enumerate(spots):
            foot = complex(spot.real, self.zero.imag)
            due += [Way(str(k), foot - 1j * TICK, foot + 1j * TICK), Way(str(k), foot, spot, due=False)]
        for extreme in self.expected.found.pressure.values():
            foot, spot = self.on(extreme.turned), self.on(extreme.turned, math.degrees(extreme.value))
            due.append(Way("α", foot, foot + 1j * (spot - foot).imag, FLUSH, due=False))
            spots.append(spot)
        bounds = (*(phase.start for phase in cam.phases), cam.turn)
        due += [Way("φ", self.on(turned, low), self.on(turned, high), FAR) for turned in bounds]
        due += [Way(kind, start, end, due=False) for kind, start, end in self._held()]
        yield from self.work.ways(due)
        yield from self.work.heads()
        yield from self.work.dots("α", self._near(spots))
        rings = [one.end for one in self.measured.vectors if one.plan == NAME and one.position is None]
        if not all(any(abs(one.centre - spot) <= FLUSH for one in self.strokes.circles) for spot in rings):
            yield on("edge", NAME, name="α")
        for tip, name in ((self.on(cam.turn), "φ"), (self.on(0.0, high), "α")):
            way = 1.0 if name == "φ" else 1j
            if not any(self.work.headed(one) and abs(((one - tip) / way).imag) <= FLUSH for one, _ in self.work.tips):
                yield on("head", NAME, name=name)

    def _near(self, spots: list[complex]) -> Iterator[complex]:
        """Give places, those of rings about smooth extremes as they stand: the ordinates hold them."""
        yield from spots
        yield from (one.end for one in self.measured.vectors if one.plan == NAME)

    def _held(self) -> Iterator[tuple[str, complex, complex]]:
        """Give the ends of the lines of the limits."""
        cam = self.expected.cam
        for kind in (RISE, RETURN):
            interval = limits_of(cam).interval(kind, cam.closure)
            for one in (one for one in cam.phases if one.kind == kind and interval is not None):
                for level in (math.degrees(interval.low), math.degrees(interval.high)) if interval else ():
                    yield kind, self.on(one.start, level), self.on(one.end, level)

    def _words(self) -> Iterator[Wrong]:
        """Hold the title, both scales in full, the letters of the axes, the numbers at the axis; no other word."""
        cam, drafting = self.expected.cam, self.drafting
        turn, unit = ("x", "m") if cam.translates else ("φ", "rad")
        scales = [
            scale_line(self.mu, "α", "°", drafting),
            scale_line(self.written.get(turn, math.nan), turn, unit, drafting),
        ]
        letters = [phase_name(cam, k, drafting) for k in range(len(cam.phases))]
        due = [drafting.word("cam pressure graph"), ";  ".join(scales), turn, "α, °", *letters]
        own = [f"{drafting.number(math.degrees(one.value))}°" for one in self.expected.found.pressure.values()]
        known = limits_of(cam)
        for kind in (RISE, RETURN):
            interval = known.interval(kind, cam.closure)
            ends = () if interval is None else (interval.low, interval.high)
            own += [drafting.letter(f"[α_{{{kind}}}] = {drafting.number(abs(math.degrees(end)))}°") for end in ends]
        numbers = [str(k) for k in range(len(self.expected.contour.turned))]
        yield from self.work.words(due, [*own, *numbers])
        for k, turned in enumerate(self.expected.contour.turned.tolist()):
            if str(k) in self.strokes.texts and not self.strokes.lettered(str(k), [self.on(turned)]):
                yield on("letter", NAME, name=str(k))
        for letter, along in ((turn, True), ("α", False)):
            tips = [tip for tip, back in self.work.tips if (abs((tip - back).imag) <= FLUSH) == along]
            if not self.strokes.lettered(letter, tips):
                yield on("letter", NAME, name=letter)

    @cached_property
    def zero(self) -> complex:
        """The beginning of the axis of the cam's turn on paper, mm."""
        axis = (one for one in self.strokes.pointings if abs((one.tip - one.start).imag) <= FLUSH)
        return next((one.start for one in axis), complex("nan"))

    @cached_property
    def written(self) -> dict[str, float]:
        """The written scales by their letters."""
        return written_scales(self.strokes.group)

    @cached_property
    def mu(self) -> float:
        """The scale of the angles, degrees a mm."""
        stated = (one.scale for one in self.measured.vectors if one.plan == NAME)
        return next(stated, self.written.get("α", math.nan))

    def on(self, turned: float, angle: float = 0.0) -> complex:
        """Give the place on paper of an angle in degrees at a turn of the cam, mm."""
        cam = self.expected.cam
        letter = "x" if cam.translates else "φ"
        return complex(self.zero + turned / self.written.get(letter, math.nan) + 1j * angle / self.mu)

    @property
    def slack(self) -> float:
        """How far a measured angle may be off, degrees."""
        return 2 * self.measured.quantum * self.mu + KNOWN * 90.0

    def _scales(self) -> Iterator[Wrong]:
        """Hold the written scale of the angles to that of the ordinates."""
        if not math.isclose(self.written.get("α", math.nan), self.mu, rel_tol=KNOWN):
            yield message("wrong.scale", text="μ_α")

    def _ordinates(self) -> Iterator[Wrong]:
        """Hold the ordinates and points of the numbered positions."""
        own = self.expected.contour
        angles = np.degrees(own.pressure)
        seen = {one.position: one for one in self.measured.vectors if one.plan == NAME and one.position is not None}
        dots = np.array([one.centre for one in self.strokes.circles])
        for k, (turned, angle) in enumerate(zip(own.turned.tolist(), angles.tolist(), strict=True)):
            foot, one = self.on(turned), seen.pop(k, None)
            if one is not None and not abs(one.value - 1j * angle) <= self.slack:
                yield on("differs_at", NAME, name="α", position=k)
            elif one is not None and not abs(one.start - foot) <= FLUSH:
                yield on("foot", NAME, name=str(k))
            elif one is None and self.strokes.lettered(str(k), [foot]) and abs(angle) > LEAST * self.mu + self.slack:
                yield on("missing_at", NAME, name="α", position=k)
            if not (dots.size and np.abs(dots - self.on(turned, angle)).min() <= FLUSH):
                yield on("edge", NAME, name=str(k))
        yield from (on("stranger_on", NAME, name=str(k)) for k in seen)

    def _extremes(self) -> Iterator[Wrong]:
        """Hold the extremes: each with its ordinate where it is, and its value beside its point."""
        true = {kind: one for kind, one in self.expected.found.pressure.items() if one.value}
        seen = {one.name: one for one in self.measured.vectors if one.plan == NAME and one.position is None}
        for kind, extreme in true.items():
            one, angle = seen.get(kind), math.degrees(extreme.value)
            if one is None:
                yield on("missing_on", NAME, name=kind)
            elif not abs(one.value - 1j * angle) <= self.slack or not self._there(one.start, extreme):
                yield on("differs_on", NAME, name=kind)
            elif not self.strokes.lettered(f"{self.drafting.number(angle)}°", [one.end]):
                yield on("letter", NAME, name=kind)
        yield from (on("stranger_on", NAME, name=kind) for kind in seen.keys() - true.keys())

    def _there(self, foot: complex, extreme: Extreme) -> bool:
        """Tell whether an ordinate stands where an extreme is: a smooth one is known to half of the digits."""
        return abs(foot - self.on(extreme.turned)) <= FLUSH

    def _pressure(self, turned: Floats) -> tuple[Floats, Floats]:
        own = (Curve(self.expected.cam, self.expected.sizes, turned, before).pressure for before in (False, True))
        after, before = (np.degrees(one) for one in own)
        return after, before

    def _curve(self) -> Iterator[Wrong]:
        """Hold the curve: corner by corner, from end to end."""
        chains = [one for one in self.strokes.chains if one.style.width >= self.drafting.hand.main]
        spots = np.array([spot for one in chains for spot in one.points])
        ends = [self.on(turned).real for turned in (0.0, self.expected.cam.turn)]
        if not spots.size or abs(spots.real.min() - ends[0]) > FLUSH or abs(spots.real.max() - ends[1]) > FLUSH:
            yield on("curve", NAME)
            return
        turned = np.clip((spots.real - ends[0]) / (ends[1] - ends[0]), 0.0, 1.0) * self.expected.cam.turn
        turned = self._settled(turned)
        level = (spots.imag - self.zero.imag) * self.mu
        off = np.min([np.abs(level - one) for one in self._pressure(turned)], axis=0)
        if not (off <= FLUSH * self.mu + self.slack).all():
            yield on("curve", NAME)

    def _settled(self, turned: Floats) -> Floats:
        """Put turns that are those of edges but for roundings on them."""
        edges = self.expected.edges
        near = edges[np.abs(turned[:, None] - edges).argmin(axis=1)]
        return np.where(np.abs(turned - near) <= KNOWN * self.expected.cam.turn, near, turned)

    def _limits(self) -> Iterator[Wrong]:
        """Hold the limits: two lines over each phase that has them, the letter of its own at one of them."""
        cam = self.expected.cam
        known, kinds = limits_of(cam), {one.kind for one in cam.moving()}
        for kind, side in ((RISE, 1), (RETURN, -1)):
            interval = known.interval(kind, cam.closure) if kind in kinds else None
            if interval is not None:
                yield from self._limit(kind, math.degrees(interval.low), side < 0)
                yield from self._limit(kind, math.degrees(interval.high), side > 0)

    def _limit(self, kind: str, level: float, lettered: bool) -> Iterator[Wrong]:
        own = [one for one in self.expected.cam.phases if one.kind == kind]
        ends = [(self.on(one.start, level), self.on(one.end, level)) for one in own]
        if not all(self.strokes.joins(*pair, near=FLUSH) for pair in ends):
            yield on("limit", NAME, name=kind)
        text = self.drafting.letter(f"[α_{{{kind}}}] = {self.drafting.number(abs(level))}°")
        spots = [pair[0] + (pair[1] - pair[0]) * share / 4 for pair in ends for share in range(5)]
        if lettered and not self.strokes.lettered(text, spots):
            yield on("letter", NAME, name=text)

    def _phases(self) -> Iterator[Wrong]:
        """Hold the row of phases: an upright line at each bound, each letter under its own phase."""
        cam = self.expected.cam
        upright = {round(one.start.real, 3) for one in self.strokes.lines if abs((one.end - one.start).real) <= FLUSH}
        for k, phase in enumerate(cam.phases):
            start, middle = self.on(phase.start).real, self.on(phase.start + phase.angle / 2).real
            letter = phase_name(cam, k, self.drafting)
            labels = self.strokes.labels.get(read(letter), ())
            near = any(one.place[0] - NEAREST <= middle <= one.place[2] + NEAREST for one in labels)
            if not near or not any(abs(one - start) <= FLUSH for one in upright):
                yield on("phase", NAME, name=letter)
