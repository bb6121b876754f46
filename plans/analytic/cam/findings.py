"""All that the analysis finds of one cam (кулачок, итог расчёта)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from typing import Final

import numpy as np

from plans.analytic.cam.contour import ContactForces, ContourValues, contour, forces_of
from plans.analytic.cam.extremes import CurveExtremes, SidedTurn, Value, WholeTurn
from plans.analytic.cam.laws import shocks
from plans.analytic.cam.loops import Loops
from plans.analytic.cam.sizes import sizes as sizes_of
from plans.model.cam import FORCE, GROOVE, NO_SIZES, RETURN, RISE, ROLLER, Cam, interval_of
from plans.model.cam_motion import HARD, CamError, CamFlaw, CamFound, CamSizes, Extreme
from plans.model.motion import Floats

NEAR: Final = 1e-9  # of a limit: sizes found by it touch it but for rounding, and so may a roller a radius
LEAST: Final = ("undercut", "concave", "sharp", "lift-off")


@dataclass(frozen=True)
class Flaws:
    """What is wrong with one profile."""

    extremes: CurveExtremes
    roller: float  # m
    forces: ContactForces | None

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.extremes.cam

    @property
    def turn(self) -> WholeTurn:
        """The whole turn."""
        return self.extremes.turn

    def all(self) -> tuple[CamFlaw, ...]:
        """Give all flaws, by their kinds, and those of a kind as the cam turns."""
        fast = self.extremes.outrun
        if fast:
            return (CamFlaw("outrun", fast.turned, fast.turned, fast),)
        found = (
            *self._rolling("undercut", 1.0),
            *(self._rolling("hollow", -1.0) if self.cam.closure == GROOVE else ()),
            *(self._flat() if self.cam.flat else ()),
            *Loops(self.turn, self.roller).flaws(),
            *self._pressed(),
            *self._short(),
            *self._lifted(),
        )
        return tuple(sorted(found, key=lambda flaw: (flaw.kind, flaw.start)))

    def _rolling(self, kind: str, side: float) -> Iterator[CamFlaw]:
        if self.roller == 0:
            return

        def value(curve: ContourValues) -> Floats:
            return side * self.roller * curve.curvature - 1

        def radius(curve: ContourValues) -> Floats:
            with np.errstate(divide="ignore"):
                return np.where(side * curve.curvature > 0, np.abs(1 / curve.curvature), np.inf)

        spans = list(self._beyond(kind, value, radius, self.extremes.bends))
        yield from spans
        worst = self.extremes.sharpest if side > 0 else self.extremes.hollow
        if worst and not spans and abs(abs(worst.value) - self.roller) <= NEAR * self.roller:
            yield CamFlaw(kind, worst.turned, worst.turned, worst)
        yield from (CamFlaw(kind, turned, turned, Extreme(0.0, turned)) for turned in self.corners(side))

    def corners(self, side: float) -> Iterator[float]:
        """Give where a hard shock makes a corner of the curve: the normal swings by the jump of the pressure angle."""
        for shock in shocks(self.cam):
            ends = np.array([shock.turned or (0.0 if self.cam.translates else self.cam.turn)])
            outside = self.cam.translates and shock.turned in (0.0, self.cam.turn)
            if shock.order == HARD and not outside:
                after = self.turn.at(np.array([shock.turned])).pressure[0]
                before = self.turn.at(ends, before=True).pressure[0]
                if side * (after - before) < 0:
                    yield shock.turned

    def _flat(self) -> Iterator[CamFlaw]:
        def hollow(curve: ContourValues) -> Floats:
            if not curve.cam.rocks:
                return -curve.radius
            return np.where(curve.lead > 0, -curve.radius * curve.lead, curve.sizes.base)

        spans = list(self._beyond("concave", hollow, lambda curve: curve.radius, self.extremes.bends))
        yield from spans
        falls = [shock.turned for shock in shocks(self.cam) if shock.order == HARD and shock.jump < 0]
        yield from (CamFlaw("concave", turned, turned, Extreme(0.0, turned)) for turned in falls)
        least, asked = self.extremes.sharpest, self.cam.limits.curvature
        if least and not spans and asked > 0 and least.value < asked * (1 - NEAR):
            yield CamFlaw("sharp", least.turned, least.turned, least)

    def _pressed(self) -> Iterator[CamFlaw]:
        for kind in (RISE, RETURN):
            interval = interval_of(self.cam, kind)
            if interval is not None:
                turn = WholeTurn(self.cam, self.extremes.sizes, (kind,))
                places = turn.places(lambda curve: curve.pressure)
                for side, limit in ((1.0, interval.high), (-1.0, -interval.low)):
                    value = partial(_excess, side, limit)
                    for flaw in self._beyond("pressure", value, lambda curve: np.abs(curve.pressure), places, turn):
                        yield flaw._replace(worst=flaw.worst._replace(value=side * flaw.worst.value))

    def _short(self) -> Iterator[CamFlaw]:
        reach = self.cam.follower.reach
        if self.cam.flat and reach is not None:
            places = self.turn.places(lambda curve: curve.place)
            for side in (1.0, -1.0):
                value = partial(_off_face, side, reach)
                yield from self._beyond("short face", value, lambda curve: np.abs(curve.place), places)

    def _lifted(self) -> Iterator[CamFlaw]:
        forces = self.forces
        if forces is not None and self.cam.closure == FORCE:
            places = self.turn.places(forces.normal)
            yield from self._beyond("lift-off", lambda curve: -forces.along(curve), forces.normal, places)

    def _beyond(
        self, kind: str, value: Value, reported: Value, tops: Sequence[SidedTurn], turn: WholeTurn | None = None
    ) -> Iterator[CamFlaw]:
        """Give the parts of the turn where a value is above 0, with the worst of what is told of it, at its tops."""
        turn = turn or self.turn
        places = (*tops, *(SidedTurn(root) for root in turn.roots(value)))
        for start, end in self._parts(turn, value, places):
            inside = [place for place in places if _inside(place, start, end)]
            found = turn.read(reported, inside)
            best = int(np.nanargmin(found) if kind in LEAST or kind == "hollow" else np.nanargmax(found))
            size = -found[best] if kind == "hollow" else found[best]
            yield CamFlaw(kind, start, end, Extreme(float(size), inside[best].turned))

    def _parts(self, turn: WholeTurn, value: Value, places: tuple[SidedTurn, ...]) -> list[tuple[float, float]]:
        cuts = sorted({place.turned for place in places})
        middles = np.array([(start + other) / 2 for start, other in pairwise(cuts)])
        above = value(turn.at(middles)) > 0
        above &= [any(s <= m <= e for s, e in turn.pieces.T.tolist()) for m in middles.tolist()]
        parts: list[tuple[float, float]] = []
        for (start, end), bad in zip(pairwise(cuts), above.tolist(), strict=True):
            if bad and parts and parts[-1][1] == start:
                parts[-1] = parts[-1][0], end
            elif bad:
                parts.append((start, end))
        return self._round(parts)

    def _round(self, parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
        """Join the last part with the first where both meet at the end of the turn."""
        if self.cam.translates or len(parts) < 2 or parts[0][0] > 0 or parts[-1][1] < self.cam.turn:
            return parts
        return [(parts[-1][0], parts[0][1]), *parts[1:-1]]


def _excess(side: float, limit: float, curve: ContourValues) -> Floats:
    """Give how far the pressure angle is beyond its limit to one side."""
    return side * curve.pressure - limit * (1 + NEAR)


def _off_face(side: float, reach: float, curve: ContourValues) -> Floats:
    """Give how far contact is off the face on one side."""
    return side * curve.place - reach * (1 + NEAR)


def _inside(place: SidedTurn, start: float, end: float) -> bool:
    if start > end:
        return place.turned >= start or place.turned <= end
    return start <= place.turned <= end


def cam_found(cam: Cam, sizes: CamSizes, turned: Floats) -> CamFound:
    """Find a cam's profile at some turns, rad, its extremes over the whole turn, and its flaws."""
    extremes = CurveExtremes(cam, sizes)
    roller, rule = roller_radius(cam, extremes, sizes.base)
    forces = forces_of(cam, roller)
    flaws = Flaws(extremes, roller, forces).all()
    return CamFound(
        cam=cam,
        sizes=sizes,
        roller=roller,
        contour=contour(cam, sizes, roller, turned),
        shocks=shocks(cam),
        peaks=extremes.peaks,
        pressure=extremes.pressure,
        sharpest=extremes.sharpest,
        hollow=extremes.hollow,
        face=extremes.face,
        flaws=flaws,
        rule=rule,
        pressing=extremes.pressing(forces) if forces and not extremes.outrun else None,
        mending=extremes.mending,
        advised=advised(cam) if any(flaw.kind == "pressure" for flaw in flaws) else None,
    )


def advised(cam: Cam) -> CamSizes | None:
    """Give the sizes that keep to the limits where none is given, if there are such."""
    if cam.flat or cam.translates:
        return None
    try:
        return sizes_of(replace(cam, given=NO_SIZES))
    except CamError:
        return None


def roller_radius(cam: Cam, extremes: CurveExtremes, base: float) -> tuple[float, str]:
    """Give the roller's radius, m, and by what it was taken: r <= 0.7 ρ_min, r <= 0.4 R0, the smaller (M2.14).

    In a groove 0.7 of the hollow's radius bounds it too. A cam that translates has no R0, a curve that is nowhere
    convex no ρ_min.
    """
    if cam.follower.end != ROLLER:
        return 0.0, "given"
    if cam.roller is not None:
        return cam.roller, "given"
    bends = {"curvature": extremes.sharpest, "hollow": extremes.hollow if cam.closure == GROOVE else None}
    rules = [(0.7 * abs(extreme.value), rule) for rule, extreme in bends.items() if extreme]
    rules += [(0.4 * base, "wear")] if base > 0 else []
    return min(rules, default=(0.0, "curvature"))
