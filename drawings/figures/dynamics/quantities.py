"""What is drawn over the turn: moments, works, surplus energy, inertia, speeds (величины за цикл)."""

from __future__ import annotations

import numpy as np

from drawings.figures.dynamics.curves import Dense
from drawings.figures.dynamics.strip_graph import StripGraph, Trace
from drawings.figures.graphs.part import OVER, RIGHT, UNDER
from plans.model.dynamics import TURN, Cycle, Speeds
from plans.model.motion import Floats

MOST = 4.0  # times as far as with the flywheel: what swings more has a graph of its own
MOMENTS, WORKS, SURPLUS, INERTIA, SPEEDS, BEFORE = "moments", "works", "surplus", "inertia", "speeds", "before"


def moments(cycle: Cycle, dense: Dense) -> StripGraph:
    """The reduced moment of resistance, with both sides of its jumps, and the constant one of the drive."""
    after = np.append(-cycle.moments[:, 0], -cycle.moments[-1, 1])
    before = np.append(-cycle.moments[0, 0], -cycle.moments[:, 1])
    most = int(np.argmax(np.abs(dense.moment)))
    traces = (
        Trace(
            dense.turned, -dense.moment, "result", "M_{us}", most / (len(dense.moment) - 1), _away(-dense.moment[most])
        ),
        _level(cycle.driving, "relative", "M_{dr}", RIGHT, 1.0),
    )
    return StripGraph(MOMENTS, "M_{red}", "N*m", after, before, traces)


def works(cycle: Cycle) -> StripGraph:
    """The work of resistance by the chords of its construction, and that of the drive, a straight line."""
    own = -cycle.work
    traces = (
        Trace(cycle.turned, own, "result", "A_{us}", 0.6, _away(-cycle.driving)),
        Trace(np.array([0.0, TURN]), np.array([0.0, own[-1]]), "relative", "A_{dr}", 0.0, OVER),
    )
    return StripGraph(WORKS, "A", "J", own, own, (traces[0], _halved(traces[1])))


def _halved(trace: Trace) -> Trace:
    """Give a straight line a point at which its letter stands."""
    x, y = (np.array([row[0], row[0] + 0.25 * (row[1] - row[0]), row[1]]) for row in (trace.x, trace.y))
    return trace._replace(x=x, y=y, at=0.5)


def surplus(cycle: Cycle, dense: Dense) -> StripGraph:
    """The change of the kinetic energy."""
    energy = cycle.driving * dense.turned + dense.work
    return StripGraph(SURPLUS, "ΔT", "J", cycle.surplus, cycle.surplus, (Trace(dense.turned, energy),))


def inertia(cycle: Cycle, dense: Dense) -> StripGraph:
    """The part of the reduced inertia that changes."""
    own = cycle.varying
    return StripGraph(INERTIA, "ΔJ", "kg*m2", own, own, (Trace(dense.turned, dense.varying),))


def speeds(cycle: Cycle, dense: Dense, speeds: Speeds, before: Speeds | None = None) -> StripGraph:
    """The speed with the flywheel from its mean on, the extremes; that without it dashed, if it swings little more."""
    low, high = speeds.extremes
    traces = [Trace(dense.turned, omega(cycle, dense, speeds))]
    traces += [_level(high, "drafted", "ω_{max}"), _level(low, "drafted", "ω_{min}", UNDER)]
    if before is not None and beside(speeds, before):
        traces.append(Trace(dense.turned, omega(cycle, dense, before), "path", "ω_0", 0.15))
    return StripGraph(SPEEDS, "ω", "rad/s", speeds.omega, speeds.omega, tuple(traces), speeds.mean)


def beside(speeds: Speeds, before: Speeds) -> bool:
    """Tell whether the speeds without the flywheel are drawn among those with it: they are others, and not too far."""
    apart = before.extremes[1] - before.extremes[0]
    return before.inertia != speeds.inertia and apart <= MOST * (speeds.extremes[1] - speeds.extremes[0])


def omega(cycle: Cycle, dense: Dense, speeds: Speeds) -> Floats:
    """Give the speed densely, rad/s: by the energy and the inertia of the whole machine."""
    energy = speeds.energy + cycle.driving * dense.turned + dense.work
    whole = speeds.inertia + dense.varying
    return np.asarray(np.sqrt(2 * np.maximum(energy, 0.0) / whole))


def _level(value: float, style: str, letter: str, side: float = OVER, at: float = 0.5) -> Trace:
    """Draw a constant over the whole turn."""
    return Trace(np.array([0.0, 0.9 * TURN, TURN]), np.full(3, value), style, letter, at, side)


def _away(value: float) -> float:
    return OVER if value >= 0 else UNDER
