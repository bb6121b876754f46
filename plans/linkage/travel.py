"""The output's travel over the turn: its coordinate, its velocity, and where it rests (перемещение выходного звена)."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any, TypeVar, cast

import numpy as np

from geometry.board import Board, Mark
from geometry.meet import dot
from plans.linkage.assembly_limits import FAN, LOOKS, NODES, Sweep, at_angles, changes_of_sign
from plans.linkage.crank_positions import CrankPositions
from plans.model.mechanism import FRAME, Mechanism, Output, Parting, Slide
from plans.model.motion import Complexes, Floats, Motion, PointMotion

T = TypeVar("T")


def remade(value: T, made: Mapping[Mark, Mark], boards: Mapping[str, Board]) -> T:
    """Give a value with each mark in it answered by its new one, and each board by that of its subject."""
    found: Any = value
    if isinstance(value, Mark):
        found = made[value]
    elif isinstance(value, Board):
        found = boards[value.subject]
    elif isinstance(value, tuple):
        parts = [remade(part, made, boards) for part in value]
        found = type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    elif isinstance(value, list):
        found = [remade(part, made, boards) for part in value]
    elif isinstance(value, dict):
        found = {key: remade(part, made, boards) for key, part in value.items()}
    return cast(T, found)


# An output slower than this, m/s or rad/s with the crank at 1 rad/s, stands: what is left are roundings of a true zero.
STILL = 1e-12


def frame_slide(mechanism: Mechanism, link: int) -> Slide | None:
    """Give the slide of a link on the frame, if it has one."""
    return next((s for s in mechanism.slides if {s.slider, s.owner} == {link, FRAME}), None)


class Travel:
    """The output's coordinate and velocity over the crank angle: along the frame's guide, or the output link's turn.

    Of an output that parts from another point it is the way between them along a line of points.
    """

    def __init__(self, sweep: Sweep, out: Output) -> None:
        self.sweep, self.out = sweep, out
        self.slide = None if out.parting else frame_slide(sweep.mechanism, out.link)

    @property
    def sliding(self) -> bool:
        """Whether the output slides, on the frame or away from another point."""
        return self.slide is not None or self.out.parting is not None

    def coordinate(self, turn: CrankPositions) -> Floats:
        """Read off the plan of positions: metres along the guide from its own point, or radians."""
        seen = self.sweep.motion(turn, 0)
        if self.out.parting is not None:
            apart, along = self._parting(self.out.parting, seen)
            return np.asarray(dot(along, apart.r))
        return self.rows(seen)[0]

    def speed(self, turn: CrankPositions) -> Floats:
        """Read off the velocity plan the output's velocity, or its omega."""
        seen = self.sweep.motion(turn, 1)
        if self.out.parting is not None:  # its point and the other are on the line, so that turning moves neither along
            apart, along = self._parting(self.out.parting, seen)
            return np.asarray(dot(along, apart.v))
        return self.rows(seen)[1]

    def rows(self, seen: Motion) -> tuple[Floats, ...]:
        """Read the coordinate off a motion, with its derivatives by time; of an output that parts from no other."""
        if self.slide is None:
            return tuple(seen.links[self.out.link])
        way, (place, *rates) = self.slide.way(FRAME), seen.points[self._pin(self.slide)]
        return tuple(np.asarray(dot(way.direction, one)) for one in (place - way.through, *rates))

    def _parting(self, parting: Parting, seen: Motion) -> tuple[PointMotion, Complexes]:
        """Give place and velocity of the output's point from the other, and the unit direction of their line."""
        own, far = (seen.points[name] for name in (self.out.point or "", parting.other))
        start, end = (seen.points[name].r for name in parting.line)
        with np.errstate(invalid="ignore"):  # a gap is NaN
            along = (end - start) / np.abs(end - start)
        return PointMotion(one - other for one, other in zip(own, far, strict=False)), along

    def _pin(self, slide: Slide) -> str:
        return self.out.point or slide.point

    @cached_property
    def path(self) -> tuple[Floats, Floats]:
        """The way over a turn: crank angles rad and the coordinate there, an angle unwrapped."""
        nodes = 2 * np.pi * np.arange(NODES + 1) / NODES
        along = self.coordinate(at_angles(nodes))
        return nodes, along if self.sliding else np.unwrap(along)

    @property
    def turns_fully(self) -> bool:
        """Whether a turn of the crank turns the output fully, though it may reverse on the way."""
        _, along = self.path
        return not self.sliding and bool(abs(along[-1] - along[0]) > np.pi)

    def rests(self) -> Floats:
        """Find the crank angles, rad in [0, 2 pi), in which the output stands: its velocity changes sign."""
        step = 2 * np.pi / NODES
        nodes = step * np.arange(NODES, dtype=np.float64)
        speeds = self.speed(at_angles(nodes))
        none = np.isnan(speeds)  # a change point that the linkage is carried through
        speeds = np.where(none, (np.roll(speeds, 1) + np.roll(speeds, -1)) / 2, speeds)
        if not np.abs(speeds).max() > STILL:
            return np.zeros(0)
        turns = np.flatnonzero((speeds >= 0) != (np.roll(speeds, -1) >= 0))  # the last node is followed by the first
        low, high = nodes[turns], nodes[turns] + step
        for between in self._touches(nodes, speeds):
            low, high = np.append(low, (between - step, between)), np.append(high, (between, between + step))
        places = changes_of_sign(lambda phi: self.speed(at_angles(phi)), low, high)
        return np.asarray(np.mod(places, 2 * np.pi))

    def _touches(self, nodes: Floats, speeds: Floats) -> list[float]:
        """Find where the speed goes through zero and back between two nodes: two rests less than a node apart."""
        before, after = np.roll(speeds, 1), np.roll(speeds, -1)
        sign = np.where(speeds >= 0, 1.0, -1.0)
        bend = sign * (before + after - 2 * speeds)
        with np.errstate(invalid="ignore", divide="ignore"):
            dip = np.abs(speeds) - np.where(bend > 0, (after - before) ** 2 / (8 * bend), 0.0)
        same = (sign * before > 0) & (sign * after > 0) & (np.abs(speeds) <= np.minimum(np.abs(before), np.abs(after)))
        found = (self._dips(nodes[k], sign[k]) for k in np.flatnonzero(same & (dip < np.abs(speeds) / 2)))
        return [place for place in found if place is not None]

    def _dips(self, node: float, sign: float) -> float | None:
        """Close in on the least speed about a node; None if it stays of one sign."""
        low, high = node - 2 * np.pi / NODES, node + 2 * np.pi / NODES
        for _ in range(LOOKS):
            fan = np.linspace(low, high, FAN)
            speeds = sign * self.speed(at_angles(fan))
            least = int(np.argmin(speeds))
            if speeds[least] < 0:
                return float(fan[least])
            low, high = fan[max(least - 1, 0)], fan[min(least + 1, FAN - 1)]
        return None
