"""What the graphs over a machine's turn and its run must show by the analysis: curves, ordinates (диаграммы цикла)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np

from drawings.checks.expected import Expected, course
from drawings.checks.readers import Frame, Place
from drawings.paper.strokes import Kind
from plans.model.dynamics import TURN, Cycle, Flywheel, Speeds, Task, edge_names
from plans.model.motion import Complexes, Floats
from plans.model.run import Account, MachineRun

MOMENTS, WORKS, SURPLUS, INERTIA, SPEEDS = "moments", "works", "surplus", "inertia", "speeds"
# A break is known to half the digits of an angle, however it is found; work and inertia beside it, to that share.
KNOWN = 1e-7
STEPS = 360  # of a turn at least: by these the loop is drawn

Curve: TypeAlias = Callable[[Floats], Floats]


@dataclass(frozen=True)
class AnalysedTurn:
    """The motion of a machine by analysis on the strips of the construction."""

    task: Task
    account: Account

    @property
    def cycle(self) -> Cycle:
        """The account of the turn."""
        assert self.account.cycle is not None  # else no graph is drawn
        return self.account.cycle

    @property
    def wheel(self) -> Flywheel | None:
        """The flywheel that the corners of the loop ask for."""
        return self.account.flywheel

    @property
    def omega(self) -> Floats | None:
        """The speed at the edges, rad/s; None where no fluctuation is asked for, or the machine would stop."""
        return None if self.account.speeds is None else self.account.speeds.omega

    @property
    def mean(self) -> float:
        """The mean of the least and the greatest speed, rad/s."""
        return 0.0 if self.account.speeds is None else self.account.speeds.mean

    @cached_property
    def graphs(self) -> Mapping[str, Floats]:
        """The values of each graph at the edges, behind a jump; of the speed above its mean."""
        cycle = self.cycle
        after = cycle.way * np.append(cycle.moments[:, 0], cycle.moments[-1, 1])
        found = {MOMENTS: after, WORKS: cycle.way * cycle.work, SURPLUS: cycle.surplus, INERTIA: cycle.varying}
        return found if self.omega is None else {**found, SPEEDS: self.omega - self.mean}

    @property
    def before(self) -> Floats:
        """The moments before each edge, N*m."""
        return self.cycle.way * np.append(self.cycle.moments[0, 0], self.cycle.moments[:, 1])

    def moment(self, at: Floats) -> Floats:
        """Give the moment of the loads as it is drawn: in each strip a parabola through its ends and its middle."""
        k, s, _ = self._strip(at)
        (first, last), middle = self.cycle.moments[k].T, self.cycle.means[k]
        return np.asarray(first + (last - first) * s + 4 * (middle - (first + last) / 2) * s * (1 - s))

    def energy(self, at: Floats) -> Floats:
        """Give the surplus energy as it is drawn: its slopes are those of the moments."""
        return self.cycle.driving * at + self._cubic(at, self.cycle.work, self.cycle.moments)

    def inertia(self, at: Floats) -> Floats:
        """Give the inertia that varies as it is drawn: at an edge with the slope of the parabola through three."""
        x, y = self.cycle.turned, self.cycle.varying
        around = np.gradient(np.r_[y[-2], y, y[1]], np.r_[x[-2] - TURN, x, x[1] + TURN])[1:-1]
        return self._cubic(at, y, np.column_stack([around[:-1], around[1:]]))

    def speed(self, at: Floats, speeds: Speeds) -> Floats:
        """Give the speed by the energy and the inertia of the whole machine, rad/s."""
        energy = np.maximum(speeds.energy + self.energy(at), 0.0)
        return np.asarray(np.sqrt(2 * energy / (speeds.inertia + self.inertia(at))))

    @property
    def loop(self) -> Complexes:
        """The loop: inertia kg*m2 and energy J, at the edges and between them."""
        turned, count = self.cycle.turned, -(-STEPS // len(self.cycle.means))
        at = (turned[:-1, None] + np.diff(turned)[:, None] * np.linspace(0.0, 1.0, count + 1)).ravel()
        return np.asarray(self.inertia(at) + 1j * self.energy(at))

    def _strip(self, at: Floats) -> tuple[np.ndarray[tuple[int, ...], np.dtype[np.intp]], Floats, Floats]:
        """Give the strips in which angles are, in which share of them, and how wide they are."""
        turned = self.cycle.turned
        k = np.clip(np.searchsorted(turned, at, "right") - 1, 0, len(turned) - 2)
        wide = np.diff(turned)[k]
        return k, (at - turned[k]) / wide, wide

    def _cubic(self, at: Floats, y: Floats, slopes: Floats) -> Floats:
        """Follow in each strip the cubic with given ends and slopes there (n, 2)."""
        k, s, wide = self._strip(at)
        ends = y[k] * (1 + 2 * s) * (1 - s) ** 2 + y[k + 1] * s**2 * (3 - 2 * s)
        return np.asarray(ends + wide * s * (1 - s) * (slopes[k, 0] * (1 - s) - slopes[k, 1] * s))


BEFORE, TACHOGRAM = "before", "tachogram"
WHOLE, DIGITS = 360.0, 4  # degrees of a turn; digits of what a tachogram tells


def graphs(turn: AnalysedTurn, shown: Mapping[Place, Frame]) -> Iterator[Expected]:
    """Give the graphs over the turn: curves, straight lines, ordinates at the edges; the pole distance, mm."""
    cycle, steady, (loads, other) = turn.cycle, abs(turn.cycle.driving), turn.cycle.indices
    yield _curve(turn, MOMENTS, f"M_{{{loads}}}", lambda at: cycle.way * turn.moment(at))
    yield _curve(turn, MOMENTS, f"M_{{{other}}}", level(steady))
    yield _curve(turn, WORKS, f"A_{{{loads}}}", course(cycle.turned, cycle.way * cycle.work))
    yield _curve(turn, WORKS, f"A_{{{other}}}", lambda at: steady * at)
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


def _curve(turn: AnalysedTurn, figure: str, name: str, curve: Curve) -> Expected:
    return Expected(Kind.CURVE, figure, name, curve, _slack(turn.graphs[figure]), ends=(0.0, TURN))


def _after(turn: AnalysedTurn) -> Iterator[Expected]:
    """Give the speeds with the flywheel from their mean on, and their extremes."""
    if (speeds := turn.account.speeds) is not None:
        yield _speed(turn, SPEEDS, "ω", speeds, speeds.mean)
        yield Expected(Kind.PHRASE, SPEEDS, "ω_m", turn.task.speed, digits=DIGITS + 1)
        for name, extreme in zip(("ω_{min}", "ω_{max}"), speeds.extremes, strict=True):
            curve = level(extreme - speeds.mean)
            yield Expected(Kind.CURVE, SPEEDS, name, curve, KNOWN * extreme, ends=(0.0, TURN))


def _before(turn: AnalysedTurn) -> Iterator[Expected]:
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


def _speed(turn: AnalysedTurn, figure: str, name: str, speeds: Speeds, base: float) -> Expected:
    """Give the curve of speeds; where the machine all but stops, they are known the less."""
    low, high = speeds.extremes
    slack = math.sqrt(low**2 + KNOWN * high**2) - low
    return Expected(Kind.CURVE, figure, name, lambda at: turn.speed(at, speeds) - base, slack, ends=(0.0, TURN))


def tachogram(run: MachineRun) -> Iterator[Expected]:
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
    if run.steady is not None and run.drift:
        yield Expected(Kind.PHRASE, TACHOGRAM, "Δω", run.steady.closing, KNOWN * most, digits=DIGITS)
    elif run.steady is not None:
        low, high = run.steady.extremes
        mean, delta = (low + high) / 2, 2 * (high - low) / (high + low)
        yield Expected(Kind.CURVE, TACHOGRAM, "ω_{st}", level(mean), KNOWN * mean, ends=ends)
        yield Expected(Kind.PHRASE, TACHOGRAM, "ω_{st}", mean, digits=DIGITS)
        yield Expected(Kind.PHRASE, TACHOGRAM, "δ", delta, KNOWN, digits=DIGITS)
