"""What stands about a cam's profile: stands, guide, ticks, bounds, heads, words (обозначения на фигуре профиля)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from drawings.checks.cam.cam_expected import EQUAL, phase_name
from drawings.checks.cam.cam_lines import CHORDED, ProfileLines, spans
from drawings.checks.cam.shape.rack import Rack
from drawings.checks.graphs.figure_strokes import FLUSH
from drawings.checks.graphs.linework import FAR, LEAN, OUTER, Linework, Way
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.profile_view import NAME
from drawings.figures.cam.size_marks import ROUNDED
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.paper.strokes import Line
from drawings.symbols.symbols import ARROW_LENGTH, HATCH, HINGE, STAND, TICK
from plans.model.cam import POINTED

AXES = 6.0  # mm that the axes of the shaft may go past its stand
BARE = 3.0  # mm: a shorter size may bear arrows of any kind
SIDES = (-1j, 1j, 1.0 + 0j, -1.0 + 0j)


@dataclass(frozen=True)
class ProfileWork:
    """The figure of one profile with what must stand about its curves."""

    lines: ProfileLines
    measured: Measured
    title: str
    scale: str

    def faults(self) -> Iterator[Wrong]:
        """Hold it all."""
        cam = self.lines.expected.cam
        due = [*self._ticks(), *self._sized()]
        if not cam.translates:
            due += [*self._shaft()]
            yield from self._bounds()
            yield from self._angle()
        if cam.rocks:
            due += [*self._stand(self.lines.on(self.lines.expected.sizes.pivot), SIDES, "O_1")]
        else:
            yield from self._guide()
        yield from self._laid(due)
        yield from self._heads()
        yield from self.work.words([*self._due()], [*self._known()])

    @cached_property
    def work(self) -> Linework:
        """All that it draws straight or writes."""
        return Linework(NAME, self.lines.strokes, self.symbol)

    @property
    def symbol(self) -> float:
        """The factor of the hand's symbols."""
        return self.lines.drafting.hand.symbol

    def _laid(self, due: list[Way]) -> Iterator[Wrong]:
        """Hold the lines that must be there; of a roller or a point on a cam that turns no other line is drawn."""
        cam, rack = self.lines.expected.cam, self._rack
        known, but = [*due, *self._turned()], {id(one) for one in self.work.lines if self._hatching(one)}
        known += [*self._flat()] if cam.flat else []
        if cam.translates:
            yield from rack.faults(self.lines.strokes, NAME)
            known += [*rack.ways(), *self._carried()]
            but |= {id(one) for one in self.work.lines if rack.hatching(one)}
        yield from self.work.ways(known, but)

    @property
    def _rack(self) -> Rack:
        lines = self.lines
        return Rack(lines.expected.found, lines.origin, lines.mu, self.symbol)

    def _carried(self) -> Iterator[Way]:
        """Give the arrow of a cam that translates and the dimensions of its phases, which are held by themselves."""
        strokes, lines = self.lines.strokes, self.lines
        own = (one for one in strokes.pointings if strokes.lettered("v", [(one.start + one.tip) / 2]))
        yield from (Way("v", one.start, one.tip, due=False) for one in own)
        for phase in lines.expected.cam.phases:
            ends = [lines.on(complex(lines.expected.back(0j, turned))).real for turned in (phase.start, phase.end)]
            for one in (one for one in self.work.lines if spans(one.start, one.end, ends)):
                yield Way("x", one.start, one.end, OUTER * ARROW_LENGTH * self.symbol, due=False)
            yield from (
                Way("x", complex(x, lines.origin.imag), complex(x, lines.origin.imag + 1), FAR, due=False) for x in ends
            )

    def _flat(self) -> Iterator[Way]:
        """Give the turned faces, and of a rocker what holds each of them before its pivot."""
        lines, expected = self.lines, self.lines.expected
        own, held = expected.contour, expected.cam.follower.face
        for k, (spot, normal) in enumerate(zip(lines.spots.tolist(), expected.normals.tolist(), strict=True)):
            yield Way("", spot, spot - 1j * normal, FAR, due=False)
            pivot = complex(expected.back(expected.sizes.pivot, own.turned[k]))
            if expected.cam.rocks:
                yield Way("", lines.on(pivot), lines.on(pivot + held * normal), due=False)

    def _turned(self) -> Iterator[Way]:
        """Give the turned axes or arms, the bounds of phases, the rod or the arm; other checks see that they are."""
        lines, expected = self.lines, self.lines.expected
        own, rocks = expected.contour, expected.cam.rocks
        for turned, spot in zip(own.turned.tolist(), lines.spots.tolist(), strict=True):
            foot = lines.on(complex(expected.back(expected.axis, turned)))
            way = spot - foot if rocks else complex(expected.ways(1j, turned))
            yield Way("", foot, spot if rocks else foot + way, 0.0 if rocks else FAR, due=False)
        for phase in expected.cam.phases:
            spot = lines.crossing(phase.start, lines.ring)
            yield Way("φ", spot, spot + self._outward(phase.start), FAR, due=False)
        tip = lines.on(complex(own.tip[0]))
        yield Way("", tip, lines.on(expected.sizes.pivot) if rocks else tip + 1j, 0.0 if rocks else FAR, due=False)

    def _outward(self, turned: float) -> complex:
        """Give the direction of a turned axis, or of the ray through a turned pivot."""
        expected = self.lines.expected
        pivot = expected.sizes.pivot
        return complex(expected.ways(pivot / abs(pivot) if expected.cam.rocks else 1j, turned))

    def _hatching(self, line: Line) -> bool:
        """Tell whether a line is of the hatching of a stand or of the guide, or of the guide itself."""
        lines, (high, half, more) = self.lines, (size * self.symbol for size in STAND)
        ends = (line.start, line.end)
        reach = abs(complex(high + HATCH * self.symbol, half + more)) + FLUSH
        pivots = [lines.origin, *([lines.on(lines.expected.sizes.pivot)] if lines.expected.cam.rocks else [])]
        if any(
            all(
                high - FLUSH <= max(abs((end - at).real), abs((end - at).imag)) and abs(end - at) <= reach
                for end in ends
            )
            for at in pivots
        ):
            return True
        axis, tip = lines.on(lines.expected.axis).real, lines.on(complex(lines.expected.contour.tip[0])).imag
        wide = 2 * HATCH * self.symbol
        return not lines.expected.cam.rocks and all(abs(end.real - axis) <= wide and end.imag > tip for end in ends)

    def _shaft(self) -> Iterator[Way]:
        """Give the axes of the shaft, and its stand."""
        zero, half = self.lines.origin, 2 * HINGE * self.symbol
        yield from (Way("O", zero - half * way, zero + half * way, AXES * self.symbol) for way in (1.0, 1j))
        yield from self._stand(zero, SIDES[:1], "O")

    def _stand(self, at: complex, sides: tuple[complex, ...], name: str) -> Iterator[Way]:
        """Give the legs and the base of a stand, on the side on which they are drawn."""
        high, half, more = (size * self.symbol for size in STAND)
        stands = []
        for down in sides:
            feet = [at + high * down + sign * half * 1j * down for sign in (1, -1)]
            legs = [(at + (foot - at) / abs(foot - at) * HINGE * self.symbol, foot) for foot in feet]
            wide = more * 1j * down
            stands.append([*legs, (feet[0] + wide, feet[1] - wide)])
        joins = self.lines.strokes.joins
        own = next((one for one in stands if all(joins(*pair, FLUSH) for pair in one)), stands[0])
        yield from (Way(name, *pair) for pair in own)

    def _guide(self) -> Iterator[Wrong]:
        """See that the rod has a guide: a heavy line at either side of it."""
        lines = self.lines
        axis, tip = lines.on(lines.expected.axis).real, lines.on(complex(lines.expected.contour.tip[0])).imag
        heavy = [one for one in self.work.lines if one.style.width >= lines.drafting.hand.main]
        upright = [one for one in heavy if abs((one.end - one.start).real) <= FLUSH and one.start.imag > tip]
        offs = [one.start.real - axis for one in upright]
        if not any(off > FLUSH and any(abs(off + other) <= FLUSH for other in offs) for off in offs):
            yield on("guide", NAME, name="S")

    def _ticks(self) -> Iterator[Way]:
        """Give the ticks of the follower's divisions: of its way on a rise and on a return."""
        lines, expected = self.lines, self.lines.expected
        cam, own = expected.cam, expected.contour
        if cam.flat and cam.rocks:
            return
        for phase in cam.moving():
            for k, turned in enumerate(own.turned.tolist()):
                last = abs(turned - phase.end) <= EQUAL * cam.turn  # it bears the tick of either phase or of none
                if not last and not phase.start < turned < phase.end:
                    continue
                tip = lines.on(complex(own.tip[k]))
                spot = complex(lines.on(expected.axis).real, tip.imag) if cam.flat else tip
                arm = spot - lines.on(expected.sizes.pivot) if cam.rocks else 1.0 + 0j
                across = TICK * self.symbol * arm / abs(arm)
                yield Way(f"K {k}", spot - across, spot + across, due=not last)

    def _vectors(self) -> dict[str, MeasuredVector]:
        own = (one for one in self.measured.vectors if one.plan == NAME and one.position is None)
        return {one.name: one for one in own}

    def _sized(self) -> Iterator[Way]:
        """Give the lines of sizes and normals, held by themselves, and the level at which e is dimensioned."""
        for one in (one for one in self.measured.vectors if one.plan == NAME):
            beyond = OUTER * ARROW_LENGTH * self.symbol if one.name == "e" else 0.0
            yield Way(one.name, one.start, one.end, beyond, due=False)
        sizes, e = self.lines.expected.sizes, self._vectors().get("e")
        if e is not None and abs(sizes.offset) > ROUNDED * sizes.base:
            hidden = abs(complex(*STAND[:2])) * self.symbol
            yield Way("e", self.lines.origin, complex(self.lines.origin.real, e.start.imag), FAR, hidden=hidden)

    def _bounds(self) -> Iterator[Wrong]:
        """See that the arcs of the phases end at lines that go on from the turned axes."""
        lines = self.lines
        for number, phase in enumerate(lines.expected.cam.phases):
            spot = lines.crossing(phase.start, lines.ring)
            if not lines.strokes.through(spot, self._outward(phase.start), FLUSH):
                yield on("phase", NAME, name=phase_name(lines.expected.cam, number, lines.drafting))

    def _angle(self) -> Iterator[Wrong]:
        """Hold the angle of a rocker at the start: from the line of centres to its arm."""
        lines, expected = self.lines, self.lines.expected
        if not expected.cam.rocks or expected.cam.flat or expected.contour.travel.s[0]:
            return
        pivot = lines.on(expected.sizes.pivot)
        ways = [lines.origin - pivot, lines.on(complex(expected.contour.tip[0])) - pivot]
        own = [one for one in lines.strokes.turnings if abs(one.centre - pivot) <= FLUSH]
        tips = [pivot + one.radius * way / abs(way) for way, one in zip(ways, own, strict=False)]
        both = len(own) == 2 and all(any(abs(one.tip - tip) <= FLUSH for one in own) for tip in tips)
        middle = sum(way / abs(way) for way in ways)
        written = f"ψ_0 = {lines.drafting.number(abs(cmath.phase(ways[1] / ways[0])) * 180 / cmath.pi)}°"
        spots = [pivot + one.radius * middle / abs(middle) for one in own]
        if not both or not lines.strokes.lettered(written, spots):
            yield on("arc", NAME, name="ψ_0")

    def _heads(self) -> Iterator[Wrong]:
        """Hold the arrowheads of the sizes, the circle of curvature, and that no head points elsewhere."""
        lines = self.lines
        for name, one in self._vectors().items():
            pairs = [(one.start, one.end), (one.end, one.start)] if name == "e" else [(one.start, one.end)]
            long = name == "e" or abs(one.end - one.start) > BARE  # e has its arrows outside, however short
            if name in ("R_0", "L", "ρ_min", "e") and long and not all(self._arrowed(name, *pair) for pair in pairs):
                yield on("head", NAME, name=name)
        least = self._vectors().get("ρ_min")
        if least is not None and not any(
            abs(arc.centre - least.start) <= CHORDED and abs(arc.radius - abs(least.end - least.start)) <= CHORDED
            for arc in lines.strokes.arcs
        ):
            yield on("circle", NAME, name="ρ_min")
        tip = lines.on(complex(lines.expected.contour.tip[0]))
        yield from self.work.heads((tip,) if lines.expected.cam.follower.end == POINTED else ())

    def _arrowed(self, name: str, start: complex, end: complex) -> bool:
        """Tell whether a size has its arrow at an end: from within, or of e from outside."""
        backs = [back for tip, back in self.work.tips if abs(tip - end) <= CHORDED]
        runs = [(back - end) / (start - end) for back in backs if start != end]
        return any(abs(run.imag) <= 10 * LEAN and (run.real > 0 or name == "e") for run in runs)

    def _due(self) -> Iterator[str]:
        """Give the words that must be written."""
        cam, drafting = self.lines.expected.cam, self.lines.drafting
        yield from (self.title, self.scale, "O")
        yield from ("v",) if cam.translates else ("ω", "−ω")
        yield from ("O_1",) if self.lines.expected.sizes.pivot else ()
        yield from (phase_name(cam, k, drafting) for k in range(len(cam.phases)))

    def _known(self) -> Iterator[str]:
        """Give the words that may be: sizes and numbers are held by themselves, and flaws are named."""
        found, drafting = self.lines.expected.found, self.lines.drafting
        yield from (text for text in self.lines.strokes.texts if " = " in text.replace("\N{NO-BREAK SPACE}", " "))
        yield from (str(k) for k in range(len(found.contour.turned)))
        yield from (drafting.word(f"cam {one.kind}") for one in found.flaws if one.kind in FLAWS)


FLAWS = ("undercut", "hollow", "crossing", "concave", "sharp", "short face")  # of a shape, which may be named beside it
