"""What must stand on the sheets of a machine's motion, by the analysis: graphs, loop, tables, notes (лист 3)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import NOTES, Expected, cells, course, measured, phrases
from drawings.checks.readers import Frame, frames
from drawings.dynamics.due_graphs import INERTIA, KNOWN, MOMENTS, SURPLUS, WHOLE, WORKS, AnalysedTurn, graphs, tachogram
from drawings.forces.due_acting import diagrams
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from drawings.paper.walk import groups as marks
from plans.analytic.dynamics.flywheel import flywheel_of_points, wheel
from plans.dynamics.quantities import DynamicsComparison, reducing_of
from plans.dynamics.study import DynamicsStudy
from plans.forces.statics import Statics
from plans.gears.form import geared
from plans.gears.quantities import GearsComparison
from plans.linkage.quantities import MotionComparison
from plans.model.dynamics import THICKEST, TURN, Cycle, Flywheel, Task, Wheel, edge_names, settled
from plans.model.motion import Floats
from plans.model.run import Account
from plans.study import Study

LOOP, EQUATIONS, SKETCH = "loop", "loop-equations", "flywheel_sketch"
TURNED = ("Δφ slowest", "Δφ fastest")
TANGENTS, SEGMENTS, ANGLES, CUTS = ("ψmin", "ψmax"), ("o1l", "o1k"), ("ψ_{min}", "ψ_{max}"), ("l", "k")
RESULTS, POSITIONS = "results", "positions"
DIGITS, FEW, FINE, FINER = 4, 3, 5, 6  # of numbers in notes; of per cents there; in equations; of results
EVEN = 0.5e-4  # of the largest of a column: half of its fifth digit, to which the whole column is told
MARKED = 72  # strips: of more not all edges bear marks
LOST = 1e-9  # of the largest work: all that a turn of weights leaves over
TOUCHED = 1e-5  # of the loop's height: a corner so near a tangent may be the one that it touches
TIMES = (("2δ", 2.0), ("δ/2", 0.5))  # fluctuations beside the one that is asked for
METHODS = (("by Mertsalov", "mertsalov"), ("by Gutyar", "gutyar"), ("without δ²", "book"))


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's machine."""
    statics, comparison, drafting = study.of(Statics), study.of(DynamicsComparison), drafting_of(study.scene)
    strokes = statics.over(study.of(MotionComparison).road.extremes)
    yield from diagrams(statics.machine.loads, strokes)
    if geared(study.scene):
        yield from phrases(NOTES, _train(study, comparison.analysis.cycle), DIGITS, may_lack=True)
    if comparison.analysis.cycle is None:
        yield from phrases(NOTES, _rates(study.of(DynamicsStudy).task), DIGITS, may_lack=True)
        yield from _reduction(study, comparison.analysis)
        return
    level, strokes = statics.level(study.of(MotionComparison).road.extremes)
    yield from diagrams(level.loads, strokes)
    turn = AnalysedTurn(study.of(DynamicsStudy).task, comparison.analysis)
    machine, shown = _FullTurn(turn, comparison, drafting), dict(chain(*(frames(leaf).items() for leaf in leaves)))
    frame = shown.get((LOOP, None)) or Frame(0j, 1 + 0j, 1j, 1.0, 1.0)  # without a loop it is stated nowhere
    drawn = dict(chain(*map(_drawn, leaves)))
    yield from chain(graphs(turn, shown), machine.loop(frame, drawn), machine.rim())
    yield from chain(machine.positions(), machine.results(), machine.notes())
    if comparison.construction.run is not None:
        yield from tachogram(comparison.construction.run)


def _train(study: Study, cycle: Cycle | None) -> Iterator[tuple[str, float, float]]:
    """Give ratio, driving moment and inertia of the train before the crank, by exact equations."""
    found = study.of(GearsComparison).analysis
    gear, ratio = found.train.gears[0], float(found.ratio(found.train.gears[0]) or math.nan)
    yield from (("U", ratio, 0.0), ("J_train", found.inertia(gear, found.train.output) or 0.0, 0.0))
    if cycle is not None:
        yield f"M_{found.train.drives[0][0]}", cycle.driving / ratio, KNOWN * float(np.abs(cycle.work / ratio).max())


def _reduction(study: Study, found: Account) -> Iterator[Expected]:
    """Give graphs and table of what is reduced where there is no steady turn; a swing is held by its positions."""
    made, motion, reduced = study.of(DynamicsStudy), study.of(MotionComparison), found.reduced
    reducing, _ = reducing_of(made, motion)
    turned = np.degrees(reducing.sense * (reduced.phi - reduced.phi[0])) % WHOLE
    columns = [turned, reduced.moment, reduced.inertia, reduced.slope]
    yield from _columns(columns, map(str, range(len(reduced.phi))))
    angles = np.linspace(0.0, TURN, 2 * int(WHOLE) + 1)
    dense = reducing.ordinates(reducing.motion(angles)) if motion.road.whole is not None else None
    unknown = np.full(len(angles), math.nan)
    for figure, letter, part in (MOMENTS, "M_{red}", "moment"), (INERTIA, "J_{red}", "inertia"):
        values, curve = getattr(reduced, part), unknown if dense is None else getattr(dense, part)
        slack, whole = KNOWN * float(np.nanmax(np.abs(values), initial=0.0)), not np.isnan(curve).any()
        allowed, ends = (slack, (0.0, WHOLE)) if whole else (math.inf, (math.nan, math.nan))
        yield Expected(Kind.CURVE, figure, letter, course(np.degrees(angles), curve), allowed, ends=ends)
        for k, value in enumerate(values.tolist()):
            if math.isfinite(value):
                yield Expected(Kind.VECTOR, figure, str(k), 1j * value, slack, position=k, may_lack=True)


def _columns(columns: Sequence[Floats], rows: Iterator[str], among: Sequence[Floats] = ()) -> Iterator[Expected]:
    """Give the cells of a table of values over the turn; rounding is a share of the largest of a column, or `among`."""
    whole = (np.append(column, others) for column, others in zip(columns, among or columns, strict=True))
    slacks = [(KNOWN + EVEN) * float(np.nanmax(np.abs(column), initial=0.0)) for column in whole]
    for row, values in zip(rows, np.column_stack(columns).tolist(), strict=True):
        pairs = (None if math.isnan(value) else (value, slack) for value, slack in zip(values, slacks, strict=True))
        yield from cells(POSITIONS, row, pairs, digits=FINE, may_lack=True)


class _Value(NamedTuple):
    """A result: letter, unit, value, how far off it may be, what a difference is told as a share of."""

    letter: str
    unit: str
    value: float
    slack: float
    whole: float


def _rates(task: Task) -> Iterator[tuple[str, float, float]]:
    """Give the speed that is asked for, turns a minute and rad/s."""
    yield from (("n", task.speed * 30 / math.pi, 0.0), ("ω_m", task.speed, 0.0))


@dataclass(frozen=True)
class _FullTurn:
    """A machine that turns fully."""

    turn: AnalysedTurn
    comparison: DynamicsComparison
    drafting: Drafting

    @cached_property
    def slack(self) -> float:
        """How far rounding can have moved an inertia, kg*m2."""
        wheel = self.turn.wheel
        return 0.0 if wheel is None else KNOWN * (wheel.whole + wheel.own + wheel.present)

    def loop(self, frame: Frame, drawn: Mapping[str, complex]) -> Iterator[Expected]:
        """Give the loop with its points, and what its tangents touch, cut off and are inclined by."""
        path, cycle = self.turn.loop, self.turn.cycle
        slack = KNOWN * float(np.abs(path.real).max())
        yield Expected(Kind.CURVE, LOOP, "ΔT(ΔJ)", path, slack)
        for k, name in enumerate(edge_names(cycle.turned, self.turn.task.divisions)):
            spot = complex(cycle.varying[k] / frame.across, cycle.surplus[k] / frame.up)
            yield Expected(Kind.POINT, LOOP, name, spot, KNOWN * abs(spot), position=k, may_lack=True)
        if self.turn.wheel is not None:
            for which in (0, 1):
                yield from self._tangent(self.turn.wheel, which, frame, drawn)
            yield from self._equations(self.turn.wheel, frame)

    def _tangent(self, wheel: Flywheel, which: int, frame: Frame, drawn: Mapping[str, complex]) -> Iterator[Expected]:
        cut, touch, name = wheel.cuts[which], wheel.touches[which], TANGENTS[which]
        psi = math.atan(wheel.slopes[which] * frame.across / frame.up)
        high = sum(map(abs, wheel.cuts)) + np.ptp(self.turn.cycle.surplus)
        long = drawn.get(name, 0j)
        way = complex(math.cos(psi), math.sin(psi)) * math.copysign(abs(long), long.real)
        yield Expected(Kind.VECTOR, LOOP, name, way, KNOWN * abs(way))
        yield Expected(Kind.ANGLE, LOOP, ANGLES[which], psi, KNOWN)
        yield Expected(Kind.POINT, LOOP, CUTS[which], 1j * cut, KNOWN * high * frame.across / frame.up)
        short = not abs(cut) > 1.01 * frame.up  # mm: so short a segment has no dimension
        yield Expected(Kind.VECTOR, LOOP, SEGMENTS[which], 1j * cut, KNOWN * high, may_lack=short)
        spot = complex(touch.varying, touch.surplus)
        tied = self._tied(wheel, which, frame)
        crowded = which == 1 and len(self.turn.cycle.means) > MARKED
        yield Expected(Kind.POINT, LOOP, ANGLES[which], spot, tied, may_lack=crowded)
        angle = (TURNED[which], math.degrees(touch.turned), math.inf if tied > TOUCHED * frame.across else KNOWN)
        yield from phrases(LOOP, [angle], DIGITS, may_lack=touch.turned in self.turn.cycle.turned)

    def _tied(self, wheel: Flywheel, which: int, frame: Frame) -> float:
        """Give how far the corners that a tangent touches by rounding are apart, kg*m2."""
        cycle, touch = self.turn.cycle, wheel.touches[which]
        off = np.abs(cycle.surplus - wheel.slopes[which] * cycle.varying - wheel.cuts[which])
        near = off <= TOUCHED * (np.ptp(cycle.surplus) + abs(wheel.slopes[which]) * np.ptp(cycle.varying))
        apart = cycle.varying - touch.varying + 1j * (cycle.surplus - touch.surplus) * frame.across / frame.up
        return float(np.abs(apart[near]).max(initial=0.0)) + KNOWN * float(np.abs(cycle.varying).max())

    def _equations(self, wheel: Flywheel, frame: Frame) -> Iterator[Expected]:
        """Give what is worked out beside the loop: angles °, segments mm, the origin of the whole diagram, inertia."""
        low, high = (math.degrees(math.atan(slope * frame.across / frame.up)) for slope in wheel.slopes)
        cuts = wheel.cuts
        energy = KNOWN * (sum(map(abs, cuts)) + abs(wheel.energy))
        values = [("ψ_{min}", low, KNOWN * 90), ("ψ_{max}", high, KNOWN * 90)]
        values += [("o_1l", cuts[0] / frame.up, energy / frame.up), ("o_1k", cuts[1] / frame.up, energy / frame.up)]
        values += [("x_O", -wheel.whole / frame.across, self.slack / frame.across)]
        values += [("y_O", -wheel.energy / frame.up, energy / frame.up), ("T_0", wheel.energy, energy)]
        values += [("J_0", wheel.whole, self.slack)]
        yield from phrases(EQUATIONS, values, FINE)
        yield from phrases(EQUATIONS, [("J_0^*", wheel.own + wheel.present, self.slack)], FINE, may_lack=True)
        yield from phrases(EQUATIONS, [("J_{fly}", wheel.inertia, self.slack)], FINE, may_lack=not wheel.needed > 0)

    @cached_property
    def wheel(self) -> Wheel | None:
        """The rim of the flywheel, if one is asked for."""
        return None if self.turn.wheel is None else wheel(self.turn.wheel.inertia, self.turn.task.rim)

    def rim(self) -> Iterator[Expected]:
        """Give the flywheel's sketch: sizes m as they are drawn, mm as they are lettered, mass and inertia."""
        rim = self.wheel
        if rim is None or rim.thickness > THICKEST * rim.diameter:
            return
        share = self._share
        for name, value in (("D", 1j * rim.diameter), ("t", 1j * rim.thickness), ("b", complex(rim.breadth))):
            row = Expected(Kind.VECTOR, SKETCH, name, value, share * abs(value))
            yield from measured(row, 1000 * abs(value), DIGITS)
        figures = ("m", rim.mass, share * rim.mass), ("J", rim.inertia, share * rim.inertia)
        yield from phrases(SKETCH, figures, DIGITS)
        if (ratio := self.turn.task.rim.ratio) != 1 and self.turn.wheel is not None:
            yield from phrases(SKETCH, [("u", ratio, 0.0), ("J_{fly}", self.turn.wheel.inertia, self.slack)], DIGITS)

    @property
    def _share(self) -> float:
        """How far rounding can have moved the flywheel's inertia, as a share of it."""
        return self.slack / self.turn.wheel.inertia if self.turn.wheel and self.turn.wheel.inertia else 0.0

    def positions(self) -> Iterator[Expected]:
        """Give the values at the edges, at jumps on both sides: some of them are told."""
        cycle, graphs, speeds = self.turn.cycle, self.turn.graphs, self.turn.account.speeds
        angles, none = np.degrees(cycle.turned), np.full(len(cycle.turned), np.nan)
        omega, after, before = none, none, none
        if speeds is not None:
            omega, sides = speeds.omega, speeds.epsilon
            after, before = np.append(sides[:, 0], sides[-1, 1]), np.append(np.nan, sides[:, 1])
        values = [graphs[name] for name in (MOMENTS, WORKS, SURPLUS, INERTIA)]
        names = edge_names(cycle.turned, self.turn.task.divisions)
        behind, ahead = [angles, *values, omega, after], [angles, self.turn.before, none, none, none, none, before]
        yield from _columns(behind, iter(names))
        yield from _columns(behind, (f"{name}+0" for name in names))
        yield from _columns(ahead, (f"{name}−0" for name in names), behind)

    def results(self) -> Iterator[Expected]:
        """Give what both roads find and by how much the strips are out; then the inertia by other methods."""
        for drawn, true in zip(*map(self._values, (self.turn.account, self.comparison.exact)), strict=True):
            unit = f", {self.drafting.word(drawn.unit)}" if drawn.unit else ""
            yield from self._row(f"{self.drafting.letter(drawn.letter)}{unit}", drawn, true)
        methods, whole = self.comparison.methods, self.comparison.exact.flywheel
        for key, name in METHODS if methods is not None and whole is not None else ():
            computed = _Value("", "", float(getattr(methods, name)), self.slack, 0.0)
            true = _Value("", "", whole.whole if whole else 0.0, self.slack, whole.whole if whole else 0.0)
            yield from self._row(f"J_0 {self.drafting.word(key)}", computed, true, alone=True)

    def _row(self, row: str, drawn: _Value, true: _Value, alone: bool = False) -> Iterator[Expected]:
        """Give a row of both roads and their difference, per cent; of what is found by analysis `alone` no other."""
        share, slack = 100 * (drawn.value - true.value), 100 * (drawn.slack + true.slack)
        off = (share / true.whole, slack / true.whole) if true.whole else None
        mine, exact = (drawn.value, drawn.slack), (true.value, true.slack)
        first, second, last = cells(RESULTS, row, [mine, mine if alone else exact, off], digits=FINER)
        yield from (first._replace(value="") if alone else first, second, last._replace(digits=0))

    def _values(self, account: Account) -> Iterator[_Value]:
        """Give each quantity of the results; the parts of a length are told in shares of it."""
        cycle, wheel, speeds = account.cycle, account.flywheel, account.speeds
        if cycle is not None:
            most = float(np.abs(cycle.work).max())
            lost = abs(cycle.work[-1]) <= LOST * most
            (loads, other), way = self.turn.cycle.indices, self.turn.cycle.way
            for letter, unit, value in (
                (f"M_{{{other}}}", "N*m", -way * cycle.driving),
                (f"A_{{{loads}}}(2π)", "J", way * float(cycle.work[-1])),
            ):
                size = 0.0 if lost else value
                yield _Value(letter, unit, size, KNOWN * most, abs(size))
        if wheel is not None:
            (low, high), there = wheel.cuts, wheel.own + wheel.present
            both = abs(low) + abs(high)
            for letter, cut in (("o_1k", high), ("o_1l", low)):
                yield _Value(self.drafting.true(letter, "T"), "J", cut, KNOWN * both, both)
            inertias = ("J_0", wheel.whole), ("T_0", wheel.energy), ("J_0^*", there), ("J_{fly}", wheel.inertia)
            for letter, value in inertias:
                unit, slack = ("J", KNOWN * (abs(value) + both)) if letter == "T_0" else ("kg*m2", self.slack)
                yield _Value(letter, unit, value, slack, abs(value))
        if speeds is not None:
            low, high = speeds.extremes
            ends = ("max", high), ("min", low)
            yield from (_Value(f"ω_{{{end}}}", "rad/s", extreme, KNOWN * high, extreme) for end, extreme in ends)
            delta = 2 * (high - low) / (high + low)
            yield _Value("δ", "", delta, 2 * KNOWN, delta)

    def notes(self) -> Iterator[Expected]:
        """Give the numbers of the notes, by the names of their quantities; which of them are told the words decide."""
        for name, value, slack in chain(self._task(), self._reasons(), self._achieved(), self._sizes()):
            digits = FEW if name in ("J_fly off", "rim added") else DIGITS
            period = 360.0 if name.startswith("Δφ") else 0.0
            yield Expected(Kind.PHRASE, NOTES, name, value, slack, may_lack=True, digits=digits, period=period)

    def _task(self) -> Iterator[tuple[str, float, float]]:
        task, cycle = self.turn.task, self.turn.cycle
        work = KNOWN * float(np.abs(cycle.work).max())
        yield from _rates(task)
        yield from (("A_us(2π)", abs(cycle.net), work), ("M_dr", abs(cycle.driving), work))
        if task.delta is not None:
            yield from ((f"1/{of}", 1 / (times * task.delta), 0.0) for of, times in (("δ", 1.0), *TIMES))

    def _reasons(self) -> Iterator[tuple[str, float, float]]:
        """Give from where to where the excess is taken, what divides it, what the links and the shafts have of it."""
        wheel, cycle, task = self.turn.wheel, self.turn.cycle, self.turn.task
        if wheel is None or not task.delta:
            return
        slow, fast = wheel.touches
        excess, energy = fast.surplus - slow.surplus, KNOWN * float(np.abs(cycle.surplus).max())
        share, most = excess / (task.speed**2 * task.delta), _greatest(cycle, fast.turned, slow.turned)
        tied = math.inf if self._ties(wheel) else 0.0  # rounding alone decides which corner is touched
        yield from (("Δφ fastest", math.degrees(fast.turned), tied), ("Δφ slowest", math.degrees(slow.turned), tied))
        yield from (("A excess", excess, 2 * energy + tied), ("M_us most", -cycle.way * most, KNOWN * abs(most) + tied))
        rest, off = wheel.whole - share, self.slack + 2 * energy / (task.speed**2 * task.delta) + tied
        yield from (("J_0 of loads", share, off), (f"J_0 of links {'−' if rest < 0 else '+'}", abs(rest), off))
        if not abs(rest) > off:
            yield f"J_0 of links {'+' if rest < 0 else '−'}", abs(rest), off
        there = wheel.own + wheel.present
        inertias = ("J_0", wheel.whole), ("J_fly", wheel.inertia), ("J_0^*", there), ("J_0^* of links", wheel.own)
        yield from ((name, value, self.slack) for name, value in inertias)
        yield "J_0^* of shafts", wheel.present, 0.0
        yield from self._others(wheel, there)

    def _ties(self, wheel: Flywheel) -> bool:
        """Tell whether rounding decides which corner of the loop a tangent touches."""
        spots = self.turn.cycle.varying + 1j * self.turn.cycle.surplus
        frame = Frame(0j, 1, 1j, float(np.ptp(spots.real)) or 1.0, float(np.ptp(spots.imag)) or 1.0)
        return any(self._tied(wheel, which, frame) > TOUCHED * frame.across for which in (0, 1))

    def _others(self, wheel: Flywheel, there: float) -> Iterator[tuple[str, float, float]]:
        """Give what other fluctuations ask for, and how far the strips are off."""
        task, true = self.turn.task, self.comparison.exact.flywheel
        for of, times in TIMES:
            other = flywheel_of_points(self.turn.cycle, task._replace(delta=times * (task.delta or 0.0)))
            yield f"J_fly at {of}", max(other.whole - there, 0.0), KNOWN * (other.whole + there)
        if true is not None and true.inertia:
            off = float(settled(np.array([wheel.inertia - true.inertia]), true.inertia)[0])
            yield "J_fly exact", true.inertia, self.slack
            yield "J_fly off", 100 * off / true.inertia, 200 * self.slack / true.inertia

    def _achieved(self) -> Iterator[tuple[str, float, float]]:
        speeds, before = self.turn.account.speeds, self.turn.account.before
        for name, motion in (("δ", speeds), ("δ without flywheel", before)):
            if motion is not None and all(map(math.isfinite, motion.extremes)):
                low, high = motion.extremes
                slack = 2 * KNOWN + (0.0 if low > LOST * high else math.sqrt(KNOWN))
                yield name, 2 * (high - low) / (high + low), slack
        if speeds is not None:
            yield from zip(("ω_min", "ω_max"), speeds.extremes, [KNOWN * speeds.extremes[1]] * 2, strict=True)

    def _sizes(self) -> Iterator[tuple[str, float, float]]:
        """Give mass, sizes mm and speed m/s of the rim on its own shaft; of one that is too thick, what would do."""
        ring, rim, share = self.wheel, self.turn.task.rim, self._share
        if ring is None:
            return
        least = ring.diameter * (ring.thickness / (THICKEST * ring.diameter)) ** 0.4
        values = [("rim m", ring.mass), ("rim D", 1000 * ring.diameter), ("rim D least", 1000 * least)]
        values += [("rim b", 1000 * ring.breadth), ("rim t", 1000 * ring.thickness)]
        values += [("rim v", abs(self.turn.task.speed * rim.ratio) * ring.diameter / 2)]
        yield from ((name, value, share * value) for name, value in values)
        yield "rim added", 100 * (ring.thickness / ring.diameter) ** 2, 200 * share


def _drawn(leaf: Leaf) -> Iterator[tuple[str, complex]]:
    """Give the vectors of the loop as they are drawn, mm: how long a tangent is the layout chose."""
    for mark in marks(leaf.groups):
        if mark.data.get("plan") == LOOP and mark.data.get("kind") == "vector":
            yield mark.data["name"], complex(*map(float, mark.data["value"].split()))


def _greatest(cycle: Cycle, start: float, end: float) -> float:
    """Give the greatest moment of resistance N*m from an angle to another one, rad, on and over the turn's end."""
    middles = (cycle.turned[1:] + cycle.turned[:-1]) / 2
    within = (middles - start) % TURN <= (end - start) % TURN
    resisting = -np.minimum(cycle.moments.min(axis=1), cycle.means)
    return float(resisting[within].max()) if within.any() else 0.0
