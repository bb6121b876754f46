"""The self-check of the forces on a loading scheme: each arrow and couple at its place (проверка схем нагружения)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.checks.arrowheads import BENT
from drawings.checks.forces.laid_scheme import FINE, Arrow, LaidScheme
from drawings.checks.graphs.figure_strokes import Turning
from drawings.checks.letters import NEAREST
from drawings.checks.wrong import Wrong, on
from drawings.figures.forces.force_letters import force_letter
from drawings.paper.strokes import Line
from drawings.symbols.symbols import BLOCK
from plans.checks.force_bill import ActingForce, Bearing, ForceBill

ASKEW = 1e-3  # of an arrow's direction, which is drawn with the coordinates of paper
REACH = abs(complex(*BLOCK)) / 2  # mm: no symbol of a point reaches further
RADIUS, APART = 6.5, 2.5  # mm on A1: radius of the arc of a couple, and how much wider each next one is
HALF, THREE_QUARTERS = math.pi, 1.5 * math.pi


class Floor(NamedTuple):
    """What is none: a force N, a moment N*m; and the sheet's letters of reactions."""

    force: float
    moment: float
    language: str
    reactions: str

    def letter(self, name: str) -> str:
        """Write the letter of a force."""
        return force_letter(name, self.language, self.reactions)


class SchemeForces:
    """The forces on a scheme, each arrow and arc of which is taken by what it shows."""

    def __init__(self, plan: str, laid: LaidScheme, bill: ForceBill, floor: Floor) -> None:
        self.plan, self.laid, self.bill, self.floor = plan, laid, bill, floor
        self.arrows: list[Arrow] = list(laid.arrows)
        self.arcs: list[Turning] = list(laid.strokes.turnings)

    def faults(self) -> Iterator[Wrong]:
        """Hold what must be there; what is left then is nothing that the analysis knows."""
        driving = [] if self.bill.driving is None else [self.bill.driving]
        for one in (*self.bill.known, *driving):
            yield from self._force(one, one.at)
        for couple in self.bill.couples:
            yield from self._couple(couple.name, couple.moment, couple.at)
        for bearing in self.bill.bearings:
            yield from self._hinge(bearing) if bearing.along is None else self._guide(bearing)
        yield from (on("stranger_on", self.plan, name="→") for _ in self.arrows)
        yield from (on("stranger_on", self.plan, name="↻") for _ in self.arcs)

    def _force(self, one: ActingForce, place: complex) -> Iterator[Wrong]:
        """Hold a force: its arrow, true in direction, at its place, and its letter at the free end."""
        arrow = self._arrow(one.value, self.laid.on(place), self.floor.letter(one.name))
        nothing = abs(one.value) <= self.floor.force
        if arrow is None or (nothing and self._off(arrow, place, one.name) > NEAREST):
            if not nothing:  # a rounding has an arrow only where that bears its letter: another may have its direction
                yield on("missing_on", self.plan, name=one.name)
            return
        self.arrows.remove(arrow)
        if self._off(arrow, place, one.name) > NEAREST:
            yield on("letter", self.plan, name=one.name)

    def _off(self, arrow: Arrow, place: complex, name: str) -> float:
        return self.laid.strokes.far(self.floor.letter(name), arrow.ends(self.laid.on(place))[1:])

    def _arrow(self, value: complex, spot: complex, letter: str) -> Arrow | None:
        """Find the arrow of a force at a place of the paper; of several alike the one by its letter."""
        if not abs(value) > 0:
            return None
        way = value / abs(value)
        fit = [one for one in self.arrows if abs(one.way - way) <= ASKEW and one.aside(spot) <= FINE]
        held = [one for one in fit if self._held(one, spot)]
        return min(held, key=lambda one: self.laid.strokes.far(letter, one.ends(spot)[1:]), default=None)

    def _held(self, arrow: Arrow, spot: complex) -> bool:
        """Tell whether an arrow begins or ends at a place, or is led there by a line."""
        near, _ = arrow.ends(spot)
        if abs(near - spot) <= REACH:
            return True
        return any(self._leads(line, near, spot, arrow) for line in self.laid.strokes.lines)

    def _leads(self, line: Line, near: complex, spot: complex, arrow: Arrow) -> bool:
        other, end = sorted((line.start, line.end), key=lambda one: -abs(one - near))
        return abs(end - near) <= FINE and abs(other - spot) <= REACH and arrow.aside(other) <= FINE

    def _hinge(self, one: Bearing) -> Iterator[Wrong]:
        """Hold the reaction of a hinge: whole, or by both of its parts."""
        spot = self.laid.on(one.hinge)
        split = [part for part in one.parts if self._arrow(part.value, spot, "") and self._lettered(part.name)]
        for force in one.parts if split else (one.whole,):
            yield from self._force(force, one.hinge)

    def _lettered(self, name: str) -> bool:
        return self.laid.strokes.far(self.floor.letter(name), self.laid.marked) < math.inf

    def _guide(self, one: Bearing) -> Iterator[Wrong]:
        """Hold the reaction of a guide where it acts, or at the slider's point beside its moment."""
        assert one.along is not None  # of a guide
        turned = abs(one.moment) > self.floor.moment
        if turned and self._lettered(one.couple):
            yield from self._force(one.whole, one.foot)
            yield from self._couple(one.couple, one.moment, one.foot)
        elif turned and math.isfinite(one.arm):
            yield from self._force(one.whole, one.foot + one.along * one.arm)
        else:
            yield from self._force(one.whole, one.foot)

    def _couple(self, name: str, moment: float, place: complex) -> Iterator[Wrong]:
        """Hold a couple: an arc about its place, its head in its sense, its letter beside its middle."""
        spot = self.laid.on(place)
        fit = [one for one in self.arcs if abs(one.centre - spot) <= FINE]
        letter = self.floor.letter(name)
        arc = min(fit, key=lambda one: self.laid.strokes.far(letter, [one.middle]), default=None)
        if arc is None or self.laid.strokes.far(letter, [arc.middle]) > NEAREST:
            if abs(moment) > self.floor.moment:
                yield on("missing_on", self.plan, name=name)
            return
        self.arcs.remove(arc)
        if abs(moment) > self.floor.moment and arc.sense != math.copysign(1, moment):
            yield on("sense", self.plan, name=name)
        if not self._sized(arc):
            yield on("size", self.plan, name=name)

    def _sized(self, arc: Turning) -> bool:
        """Tell whether an arc is of half or three quarters of a turn, as wide as its symbols ask: one in the next."""
        size = arc.head / BENT[0]
        steps = (arc.radius / size - RADIUS) / APART if size else -1.0
        whole = round(steps) >= 0 and abs(steps - round(steps)) * APART * size <= FINE
        return whole and any(abs(arc.swept - sweep) * arc.radius <= FINE for sweep in (HALF, THREE_QUARTERS))
