"""What a position is worth drawing for its forces: loads that do work, plans that are open (выбор положения).

The position is chosen by it in drawings/linkage/positions.py, and the choice is told by drawings/forces/notes.py.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from plans.forces.friction import useful_power
from plans.forces.statics import Statics
from plans.linkage.motion_plans import openness
from plans.model.kinetostatics import Kinetostatics
from plans.model.motion import ACCELERATIONS, VELOCITIES, Floats

FLAT = 0.1  # openness: of a plan that is flatter a hand sees one line, and a polygon is laid in lanes
PLACES = 6  # of shares: far over the last bits of a processor, which decide nothing


class PositionWorth(NamedTuple):
    """What the positions are worth: the work that is done there, and how open each plan is; rows over the positions."""

    loaded: bool  # does any useful load do work?
    done: Floats  # the power of the useful loads as a share of its greatest; of a machine without any |M_bal|
    open: dict[str, Floats]  # by the names of plans, "velocities" or "forces-4-5", as they are seen at one scale
    balancing: Floats  # |M_bal| as a share of its greatest
    lines: tuple[str, ...] = ()  # those that are lines wherever loads act: no position is better for them

    @property
    def sizes(self) -> Floats:
        """What the positions are worth: the share of the work by the geometric mean of how open the plans are.

        At a dead centre no load does work, and one plan that is a line makes the whole mean nothing. A plan that is a
        line wherever loads act, as that of two forces is, tells no position from another: it is not counted. Where a
        hand sees a plan of the motion as one line, beside a dead centre or an extreme, it is worth a tenth; as much
        where hardly any moment balances, of which the slips of a hand leave nothing.
        """
        rows = {name: row for name, row in self.open.items() if name not in self.lines}
        lines = [rows[name] < FLAT for name in (VELOCITIES.plan, ACCELERATIONS.plan) if name in rows]
        lines.append(self.balancing < FLAT)
        mean = np.prod([*rows.values()], axis=0) ** (1.0 / max(len(rows), 1))
        return np.asarray(np.round(self.done * np.where(np.any(lines, axis=0), FLAT, 1.0) * mean, PLACES))

    @property
    def hardest(self) -> int:
        """The position in which the loads do most."""
        return int(np.nanargmax(self.done))


def worth(statics: Statics, forces: Kinetostatics) -> PositionWorth:
    """Rate the positions of a machine by the construction; NaN where there are no forces."""
    study, moments = statics.study, np.abs(forces.balancing.moment)
    motion = study.motion(2)
    power = np.where(np.isnan(moments), np.nan, useful_power(study.mechanism, motion, statics.loading(motion)))
    largest = np.nanmax(moments, initial=0.0) * abs(study.mechanism.drive.omega)
    loaded = bool(np.nanmax(power, initial=0.0) > 10.0**-PLACES * largest)  # less is rounding
    sizes = power if loaded else moments
    done = np.round(sizes / (np.nanmax(sizes, initial=0.0) or 1.0), PLACES)
    found = [(name, np.where(np.isnan(done), np.nan, row), share) for name, row, share in _plans(statics)]
    shares = np.round(moments / (np.nanmax(moments, initial=0.0) or 1.0), PLACES)
    lines = tuple(name for name, row, _ in found if not np.any(row[done > 0.0] >= FLAT))
    return PositionWorth(loaded, done, {name: row * share for name, row, share in found}, shares, lines)


def _plans(statics: Statics) -> Iterator[tuple[str, Floats, Floats]]:
    """Give how open the plans of motion and of the forces of each group are; of these the share of their largest."""
    motion = statics.study.motion(2).points.values()
    rest = np.zeros(len(statics.study.turn), dtype=complex)
    yield VELOCITIES.plan, openness([rest, *(point.v for point in motion)]), np.ones(len(rest))
    yield ACCELERATIONS.plan, openness([rest, *(point.a for point in motion)]), np.ones(len(rest))
    for cut in statics.drafts().plans.plan.cuts:
        if cut.group is not None and cut.sides:
            corners = [np.broadcast_to(np.asarray(side.end.point), rest.shape) for side in cut.sides]
            size = np.ptp(np.real(corners), axis=0) + np.ptp(np.imag(corners), axis=0)
            yield f"forces-{cut.label}", openness(corners), size / (np.nanmax(size, initial=0.0) or 1.0)
