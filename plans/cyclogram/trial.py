"""Where on its strokes the output comes to given places, by trial on the plan of positions (по перемещению).

The notches from the tool need it to know on which side they meet; where no notches lead back it is all there is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from plans.linkage.assembly_limits import FAN, LOOKS, NODES, Sweep, at_angles
from plans.linkage.pressure import pressure
from plans.linkage.travel import Travel
from plans.model.cyclogram import BESIDE, TURN, Stop
from plans.model.group import Group
from plans.model.mechanism import Output
from plans.model.motion import Extremes, Floats


class Trial:
    """The travel of an output between its extremes; crank angles rad."""

    def __init__(self, sweep: Sweep, out: Output, extremes: Extremes) -> None:
        self.sweep, self.extremes = sweep, extremes
        self.sense = -1.0 if sweep.mechanism.drive.omega < 0 else 1.0
        drive = replace(sweep.mechanism.drive, omega=1.0, epsilon=0.0)
        self.travel = Travel(sweep.over(replace(sweep.mechanism, drive=drive)), out)

    @cached_property
    def way(self) -> tuple[Stroke, Stroke]:
        """The working stroke, and the way back."""
        first, last = self.extremes.phi
        there = self.sense * ((self.sense * (last - first)) % TURN)
        return Stroke(first, there), Stroke(first + there, self.sense * TURN - there)

    def along(self, phi: Floats) -> Floats:
        """Give the share of the stroke that the output has gone at crank angles; an angle is taken as the nearer."""
        begin, end = self.extremes.reach
        off = self.travel.coordinate(at_angles(phi)) - begin
        if not self.travel.sliding:
            off -= TURN * np.round((off - (end - begin) / 2) / TURN)
        return np.asarray(off / (end - begin))

    def rate(self, phi: Floats) -> Floats:
        """Give how fast the share of the stroke grows by the crank angle, 1/rad, off the velocity plan."""
        begin, end = self.extremes.reach
        return np.asarray(self.travel.speed(at_angles(phi)) / (end - begin))

    def stops(self, asked: Sequence[Stop]) -> Floats:
        """Give the crank angles at which the output comes to places of its stroke, (N,)."""
        if not asked:
            return np.zeros(0)
        low, high = (np.array(ends) for ends in zip(*map(self._between, asked), strict=True))
        shares = np.array([one.share for one in asked])
        for _ in range(LOOKS):
            fan = np.linspace(low, high, FAN)
            beyond = self.along(fan.ravel()).reshape(fan.shape) >= shares
            change = np.argmax(beyond != beyond[0], axis=0)
            each = np.arange(len(asked))
            low, high = fan[np.maximum(change - 1, 0), each], fan[change, each]
        return np.asarray((low + high) / 2)

    def _between(self, stop: Stop) -> tuple[float, float]:
        """Give the neighbouring nodes of a stroke between which the output comes to a place."""
        nodes = self.way[stop.back].nodes
        shares = self.along(nodes)
        shares[[0, -1]] = (1.0, 0.0) if stop.back else (0.0, 1.0)  # the extremes are exact
        beyond = shares >= stop.share
        change = int(np.argmax(beyond != beyond[0]))
        return float(nodes[change - 1]), float(nodes[change])

    def watched(self, group: Group) -> list[tuple[float, bool]]:
        """Give where the pressure angle of a group is extreme within a stroke, and whether on the way back."""
        found = []
        for back, stroke in enumerate(self.way):
            nodes = stroke.within(BESIDE * self.sense).nodes
            angles = np.broadcast_to(pressure(self.sweep.plan(nodes), group), nodes.shape)
            growth = np.diff(angles)
            turns = np.flatnonzero((growth[1:] >= 0) != (growth[:-1] >= 0))
            found += [(float(nodes[k + 1]), bool(back)) for k in turns.tolist()]
        return found


class Stroke(NamedTuple):
    """A stroke by the crank angle rad where it begins, and how far the crank turns over it, signed."""

    begin: float
    sweep: float

    @property
    def nodes(self) -> Floats:
        """Crank angles close to each other over the stroke, rad."""
        return np.asarray(np.linspace(self.begin, self.begin + self.sweep, NODES // 2 + 1))

    def within(self, by: float) -> Stroke:
        """Give the stroke without its ends."""
        return Stroke(self.begin + by, self.sweep - 2 * by)
