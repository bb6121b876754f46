"""What the graphs over a machine's turn and its run must show by the analysis: curves, ordinates (диаграммы цикла)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from drawings.checks.expected import Expected, course
from drawings.checks.readers import Frame, Place
from drawings.due.turn import INERTIA, KNOWN, MOMENTS, SPEEDS, SURPLUS, WORKS, Curve, Turn
from drawings.paper.statement import Kind
from plans.model.dynamics import TURN, Speeds
from plans.model.edge_names import edge_names
from plans.model.motion import Floats
from plans.model.run import Run

BEFORE, TACHOGRAM = "before", "tachogram"
WHOLE, DIGITS = 360.0, 4  # degrees of a turn; digits of what a tachogram tells


def graphs(turn: Turn, shown: Mapping[Place, Frame]) -> Iterator[Expected]:
    """Give the graphs over the turn: curves, straight lines, ordinates at the edges; the pole distance, mm."""
    cycle = turn.cycle
    yield _curve(turn, MOMENTS, "M_{us}", lambda at: -turn.moment(at))
    yield _curve(turn, MOMENTS, "M_{dr}", level(cycle.driving))
    yield _curve(turn, WORKS, "A_{us}", course(cycle.turned, -cycle.work))
    yield _curve(turn, WORKS, "A_{dr}", lambda at: cycle.driving * at)
    yield _curve(turn, SURPLUS, "ΔT", turn.energy)
    yield _curve(turn, INERTIA, "ΔJ", turn.inertia)
    names = edge_names(cycle.turned, turn.task.divisions)
    for figure, values in turn.graphs.items():
        way, slack = 1.0 if figure == INERTIA else 1j, _slack(values)
        for k, value in enumerate(values.tolist()):
            yield Expected(Kind.VECTOR, figure, names[k], way * value, slack, position=k, may_lack=True)
    yield from _after(turn)
    moments, works = (shown.get((figure, None)) for figure in (MOMENTS, WORKS))
    if moments is not None and works is not None:
        distance = works.up / (moments.up * moments.across)
        yield Expected(Kind.PHRASE, WORKS, "H_p", distance, digits=DIGITS)
    yield from _before(turn)


def level(value: float) -> Curve:
    """Give a constant as a curve."""
    return lambda at: np.full_like(at, value)


def _slack(values: Floats) -> float:
    return KNOWN * float(np.abs(values).max(initial=0.0))


def _curve(turn: Turn, figure: str, name: str, curve: Curve) -> Expected:
    return Expected(Kind.CURVE, figure, name, curve, _slack(turn.graphs[figure]), ends=(0.0, TURN))


def _after(turn: Turn) -> Iterator[Expected]:
    """Give the speeds with the flywheel from their mean on, and their extremes."""
    if (speeds := turn.account.speeds) is not None:
        yield _speed(turn, SPEEDS, "ω", speeds, speeds.mean)
        yield Expected(Kind.PHRASE, SPEEDS, "ω_m", turn.task.speed, digits=DIGITS + 1)
        for name, extreme in zip(("ω_{min}", "ω_{max}"), speeds.extremes, strict=True):
            curve = level(extreme - speeds.mean)
            yield Expected(Kind.CURVE, SPEEDS, name, curve, KNOWN * extreme, ends=(0.0, TURN))


def _before(turn: Turn) -> Iterator[Expected]:
    """Give the speeds without the flywheel: they stand among the others or alone."""
    after, before = turn.account.speeds, turn.account.before
    if before is None:
        return
    if after is not None:
        yield _speed(turn, SPEEDS, "ω_0", before, after.mean)._replace(may_lack=True)
    alone = _speed(turn, BEFORE, "ω_0", before, 0.0)._replace(ends=(0.0, WHOLE), may_lack=after is not None)
    yield alone._replace(value=lambda at: turn.speed(np.radians(at), before))
    places = np.searchsorted(before.turned, TURN * np.arange(turn.task.divisions) / turn.task.divisions - KNOWN)
    for k, value in enumerate(before.omega[places].tolist()):
        yield Expected(Kind.VECTOR, BEFORE, str(k), 1j * value, KNOWN * value, position=k, may_lack=True)


def _speed(turn: Turn, figure: str, name: str, speeds: Speeds, base: float) -> Expected:
    """Give the curve of speeds; where the machine all but stops, they are known the less."""
    low, high = speeds.extremes
    slack = math.sqrt(low**2 + KNOWN * high**2) - low
    return Expected(Kind.CURVE, figure, name, lambda at: turn.speed(at, speeds) - base, slack, ends=(0.0, TURN))


def tachogram(run: Run) -> Iterator[Expected]:
    """Give the tachogram: the speed by the table of the run, the ends of its stages, the steady speed."""
    t, omega, most = run.t, run.omega, float(run.omega.max())
    if len(t) < 2:
        return
    ends = float(t[0]), float(t[-1])
    yield Expected(Kind.CURVE, TACHOGRAM, "ω", course(t, omega), KNOWN * most, ends=ends)
    for k, stage in enumerate(run.stages, 1):
        last = float(omega[stage.last])
        slow = not last > 1e-2 * most
        yield Expected(Kind.VECTOR, TACHOGRAM, f"t_{k}", 1j * last, KNOWN * most, may_lack=slow)
        yield Expected(Kind.PHRASE, TACHOGRAM, f"t_{k}", float(t[stage.last]), digits=DIGITS)
    if run.steady is not None:
        low, high = run.steady.extremes
        mean, delta = (low + high) / 2, 2 * (high - low) / (high + low)
        yield Expected(Kind.CURVE, TACHOGRAM, "ω_{st}", level(mean), KNOWN * mean, ends=ends)
        yield Expected(Kind.PHRASE, TACHOGRAM, "ω_{st}", mean, digits=DIGITS)
        yield Expected(Kind.PHRASE, TACHOGRAM, "δ", delta, KNOWN, digits=DIGITS)
