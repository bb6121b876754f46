"""Series of what a technique has of its own: its error by the number of strips, positions, ordinates, steps (ряды).

Each gives roads over several counts, whose order is then told.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from typing import Any, Final, NamedTuple

import numpy as np

from geometry.board import Board
from geometry.calculus import integral
from geometry.strips import departure, middles, strips
from plans.analytic.dynamics import run as solver
from plans.analytic.dynamics.flywheel import Exact, exact_cycle, flywheel, flywheel_of_points
from plans.bank.harmonics import Harmonics, of_ordinates
from plans.bank.study import BankStudy
from plans.bench.motion import turns, with_positions
from plans.bench.quantities import quantities
from plans.bench.trial import Demand, Errors, Timing
from plans.dynamics import run as table
from plans.dynamics.cycle import SteadyStrips
from plans.dynamics.loop import loop
from plans.dynamics.quantities import DynamicsComparison
from plans.dynamics.study import DynamicsStudy, reduced_link
from plans.model.dynamics import TURN
from plans.model.motion import Floats
from plans.model.run import RUN_UP, MachineRun
from plans.study import Study

STRIPS: Final = (12, 24, 96, 384, 1024, 4096)
FEW: Final = (12, 24, 48)  # ordinates, or positions, as they are taken on paper
PARTS: Final = (1, 2, 4, 8, 16)  # of the table's own step
POSITIONS: Final = (12, 24, 48, 96, 192, 360)
CHORDS, EDGES, MEAN = "flywheel: chords, loop", "flywheel: extremes at edges", "driving moment: mean of positions"
RUN, DIAGRAMS = "table of the run", "diagrams: {} by chords"
ORDINATES = "harmonics: few ordinates"
DYNAMICS_DEFINED = (
    "strips: chord integration of known diagrams, in shares of the integral's largest at their edges; J_0 by chords, "
    "or from extremes at edges of even strips with true energies, in shares of that of the exact turn; the driving "
    "moment as a mean, in shares of the largest moment; the run-up's time by the table with parts of its step, in "
    "shares of the solver's. An edge stands on every jump but where it is told"
)
DIAGRAMS_DEFINED = "kinematic diagrams: chords of S and of v against the exact v and a where they belong"
BANK_DEFINED = "harmonics: from so many ordinates as are taken on paper, against those that have settled"


class KnownDiagram(NamedTuple):
    """A diagram with a known integral: over which axis, with which breaks as edges, and what is said of it."""

    name: str
    ordinate: Callable[[Floats], Floats]
    whole: Callable[[Floats], Floats]
    end: float
    breaks: tuple[float, ...] = ()
    note: str = ""

    def road(self, count: int) -> Timing:
        """Integrate it by chords over so many strips, and judge that by the largest difference at their edges."""
        edges = strips(0.0, self.end, count, self.breaks)

        def judge(values: Floats) -> Errors:
            return Errors.alone(departure(values, self.whole(edges)).share)

        means = self.ordinate(middles(edges))
        return Timing(lambda: integral(Board("bench"), "A", edges, means).values, count, {self.name: judge}, self.note)


JUMPS: Final = math.acos(0.9), math.acos(-0.9)  # where a tool bites and leaves: 5 and 95 per cent of its stroke
GOLDEN: Final = (math.sqrt(5) - 1) / 2  # the section of the axis that no division comes near


def _load(x: Floats) -> Floats:
    return np.where((x > JUMPS[0]) & (x < JUMPS[1]), 1.0, 0.0)


def _work(x: Floats) -> Floats:
    return np.asarray(np.cos(JUMPS[0]) - np.cos(np.clip(x, *JUMPS)))


KNOWN: Sequence[KnownDiagram] = (
    KnownDiagram("chords: smooth", np.exp, np.expm1, 2.0),
    KnownDiagram("chords: jumps on edges", lambda x: _load(x) * np.sin(x), _work, TURN, JUMPS),
    KnownDiagram("chords: constant load", _load, lambda x: np.clip(x, *JUMPS) - JUMPS[0], TURN, JUMPS, "exact"),
    KnownDiagram(
        "chords: jump in a strip", lambda x: np.where(x > GOLDEN, 1.0, 0.0), lambda x: np.maximum(x - GOLDEN, 0.0), 1.0,
        note="what not to do: put an edge on the jump",
    ),
)  # fmt: skip


def dynamics(study: Study, order: Demand) -> Iterator[Timing]:
    """List the chords over strips, the flywheel and the table of the run of a scene's machine."""
    found = study.of(DynamicsStudy)
    counts = STRIPS if order.startup else STRIPS[:4]
    yield from (diagram.road(count) for diagram in KNOWN for count in counts)
    turn: Exact | None = getattr(study.of(DynamicsComparison), "turn", None)
    if turn is not None:
        most = float(np.abs(turn.moment(turn.load.looks)).max(initial=0.0)) or 1.0
        for count in FEW:
            yield Timing(partial(_mean, turn, count), count, {MEAN: partial(_off, turn.driving, most)})
    if turn is not None and found.task.delta is not None:
        whole = flywheel(turn, found.task).whole
        for count in counts:
            yield Timing(partial(_chords, found, count), count, {CHORDS: partial(_off, whole, whole)})
            yield Timing(partial(_edges, found, turn, count), count, {EDGES: partial(_off, whole, whole)})
    if found.motor is not None and found.run is not None and found.run.failure is None:
        link = reduced_link(found.works, found.constant)
        asked = found.run_task._replace(turns=0, brake=None)
        true, step = _time(solver.run(link, found.motor, asked)), table.step_of(link, found.motor, found.run_task)
        for count in PARTS:
            ours = partial(table.run, link, found.motor, asked._replace(step=step / count))
            yield Timing(ours, count, {RUN: lambda run: _off(true, true, _time(run))})


def _off(true: float, largest: float, value: float) -> Errors:
    return Errors.alone(abs(value - true) / (abs(largest) or 1.0))


def _mean(turn: Exact, count: int) -> float:
    turned = np.asarray(np.arange(count) * (TURN / count), dtype=np.float64)
    return -float(np.mean(turn.moment(turned) + turn.moment(turned, -1))) / 2


def _chords(found: DynamicsStudy, count: int) -> float:
    """Draw works and loop over so many strips; give J_0, kg*m2."""
    return loop(SteadyStrips(found.reduction, count).works.cycle, found.task).flywheel.whole


def _edges(found: DynamicsStudy, turn: Exact, count: int) -> float:
    """Give J_0, kg*m2, with the extremes of the loop looked for at the edges of even strips alone."""
    return flywheel_of_points(exact_cycle(turn, np.linspace(0.0, TURN, count + 1)), found.task).whole


def _time(run: MachineRun) -> float:
    """Give the time of the run-up, s; one that does not come to its speed takes for ever."""
    ends = run.ends(RUN_UP)
    return math.inf if ends is None else ends[1]


def diagrams(study: Study, order: Demand) -> Iterator[Timing]:
    """List the kinematic diagrams of a scene over several numbers of positions."""
    for count in (POSITIONS if order.startup else POSITIONS[:3]) if turns(study.scene) else ():
        denser = Study(with_positions(study.scene, count))
        letters = [row.name.partition(" ")[0] for row in quantities(denser, "diagrams") if row.name.endswith(" chords")]
        judged = {DIAGRAMS.format(letter): partial(_by_chords, denser, letter) for letter in letters}
        yield Timing(
            partial(lambda made: made.anew("diagrams")["diagrams"].construct(made.plans), denser), count, judged
        )


def _by_chords(study: Study, letter: str, _: Any) -> Errors:
    found = {quantity.name: quantity for quantity in quantities(study, "diagrams")}
    chords, exact = (found[f"{letter} {which}"] for which in ("chords", "middles"))
    return Errors.alone(float(np.nanmax(np.abs(chords.construction - exact.analysis))) / (exact.largest or 1.0))


def bank(study: Study, _: Demand) -> Iterator[Timing]:
    """List the harmonics of a bank by few ordinates."""
    found = study.of(BankStudy)
    true = found.single

    def judge(few: Harmonics) -> Errors | None:
        largest = max(abs(complex(mark.point)) for mark in true.vectors.values()) or 1.0
        off = {mark.name: abs(complex(mark.point - true.vectors[n].point)) for n, mark in few.vectors.items()}
        return Errors.of({name: away / largest for name, away in off.items()})

    yield from (Timing(partial(_few, found, count), count, {ORDINATES: judge}) for count in FEW)


def _few(found: BankStudy, count: int) -> Harmonics:
    return of_ordinates(found.source, found.source.shaking(Fraction(0), count), found.orders)
