"""Tables of a machine's motion in the report: reduction, works, run (таблицы динамики)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from functools import partial

import numpy as np

from drawings.linkage.report import ROUNDED
from drawings.page.page import Drafting
from drawings.report.formula import DIGITS
from drawings.report.report import column, header, row, tabled, tiny, united
from plans.model.dynamics import Cycle, Flywheel, Reduced, Speeds, Task, edge_names
from plans.model.motion import Floats
from plans.model.run import RUN_UP, STEADY, MachineRun, Stage
from plans.words.words import word

OTHERS = (4.0, 2.0, 1.0, 0.5, 0.25)  # times the fluctuation that is asked for
NOISE = 1e-9  # of the largest of a column: digits of what is less differ from machine to machine
ABSENT = "—"
LARGEST = 1.0  # fluctuation: a machine that comes to rest once in a turn has 2


def reduction(found: Reduced, drafting: Drafting) -> Iterator[str]:
    """Tell moment, inertia and its slope at the positions of the scene."""
    heads = ("φ, °", "M_red, N*m", "J_red, kg*m2", "dJ/dφ, kg*m2")
    columns = [np.round(np.degrees(found.phi), ROUNDED) % 360, found.moment, found.inertia, found.slope]
    yield from tabled(united(heads, drafting), columns, drafting.language, ABSENT)


def works(cycle: Cycle, speeds: Speeds | None, divisions: int, drafting: Drafting) -> Iterator[str]:
    """Tell moments on both sides of each edge, works, energy, inertia, and the speed with the flywheel."""
    heads = ["Δφ, °", "M−, N*m", "M+, N*m", f"A_{cycle.indices[0]}, J", "ΔT, J", "J, kg*m2", "ΔJ, kg*m2"]
    before = np.roll(cycle.moments[:, 1], 1)
    sides = np.append(before, before[0]), np.append(cycle.moments[:, 0], cycle.moments[0, 0])
    columns = [np.degrees(cycle.turned), *sides, cycle.way * cycle.work, cycle.surplus, cycle.inertia, cycle.varying]
    if speeds is not None:
        heads.append("ω, rad/s")
        columns.append(speeds.omega)
    names = edge_names(cycle.turned, divisions)
    yield from tabled(united(heads, drafting), columns, drafting.language, ABSENT, names)


def tangents(wheel: Flywheel, exact: Flywheel | None, drafting: Drafting) -> Iterator[str]:
    """Tell both tangents: slope, where they touch, what they cut off, as drawn and exactly."""
    heads = ["", "tan ψ, J/(kg*m2)", "Δφ, °", "ΔJ, kg*m2", "ΔT, J", "o_{1}l, J", "o_{1}k, J"]
    yield from header(united(heads, drafting))
    roads = [("report.as_drawn", wheel), *([("report.exactly", exact)] if exact is not None else [])]
    numbers = np.array([_tangent(wheel, k) for _, wheel in roads for k in range(2)])
    rows = zip(*(column(part, drafting.language, ABSENT) for part in numbers.T), strict=True)
    for (said, k), cells in zip(((said, k) for said, _ in roads for k in range(2)), rows, strict=True):
        yield row([f"{('ψ_min', 'ψ_max')[k]}, {word(drafting.language, said)}", *cells])
    yield f"\n{word(drafting.language, 'report.slopes')}"


def _tangent(wheel: Flywheel, k: int) -> list[float]:
    """Give the numbers of a tangent; NaN for what the other one cuts off."""
    touch, cuts = wheel.touches[k], [math.nan, math.nan]
    cuts[k] = wheel.cuts[k]
    return [wheel.slopes[k], math.degrees(touch.turned), touch.varying, touch.surplus, *cuts]


def others(
    task: Task, at: Callable[[float], Flywheel], written: Callable[[float], str], drafting: Drafting
) -> Iterator[str]:
    """Tell what flywheel other fluctuations would ask for."""
    yield from header(united(["δ", "J_0, kg*m2", "J_fly, kg*m2"], drafting))
    for times in OTHERS:
        delta = times * (task.delta or 0.0)
        if delta <= LARGEST:
            found = at(delta)
            yield row([written(delta), *(drafting.number(inertia, DIGITS) for inertia in (found.whole, found.inertia))])


def without_rounding(column: Floats) -> Floats:
    """Give a column as it is told: what is nothing but for rounding is 0."""
    largest = np.nanmax(np.abs(column), initial=0.0)
    return np.where(np.abs(column) <= NOISE * largest, 0.0, column)


STAGES = ("stage", "from", "to", "driving", "useful_work", "braking", "weights", "energy", "closing")


def stages(runs: Mapping[str, MachineRun], drafting: Drafting) -> Iterator[str]:
    """Tell each stage by each road: its instants, works, kinetic energy, and by how much the account does not close."""
    yield from header([word(drafting.language, f"table.{head}") for head in STAGES])
    for said, run in runs.items():
        for stage in run.stages:
            yield row(
                [f"{named(run, stage, drafting)}, {word(drafting.language, said)}", *_cells(run, stage, drafting)]
            )


def named(run: MachineRun, stage: Stage, drafting: Drafting) -> str:
    """Give the name of a stage by what the machine does in it: it runs up without load, or is not steady yet."""
    unloaded = stage.name == RUN_UP and not stage.works.useful
    unsteady = stage.name == STEADY and run.drift
    return word(drafting.language, f"run.{'unloaded' if unloaded else 'unsteady' if unsteady else stage.name}")


def _cells(run: MachineRun, stage: Stage, drafting: Drafting) -> Iterator[str]:
    write, works = partial(drafting.number, digits=DIGITS), stage.works
    yield from (write(float(run.t[at])) for at in (stage.first, stage.last))
    yield from (write(work) for work in (works.driving, works.useful, works.braking, works.weights))
    yield " → ".join(write(energy) for energy in stage.energies)
    noise = NOISE * max(map(abs, (works.driving, works.braking, *stage.energies)))
    yield ABSENT if abs(stage.closing) <= noise else tiny(stage.closing, drafting.language)


def run_lines(runs: Mapping[str, MachineRun], drafting: Drafting) -> Iterator[str]:
    """Say how the run ends, how even its steady turn is, and by what method and at what cost it was found."""
    say = partial(word, drafting.language)
    for key, run in runs.items():
        by = say(key)
        if run.failure is not None:
            yield f"{by}: {run.failure.message.worded(drafting.language)}"
        if run.steady is not None:
            turn, write = run.steady, partial(drafting.number, digits=DIGITS)
            numbers = {"mean": write(turn.mean), "delta": write(turn.delta), "period": write(turn.period)}
            share = turn.works.efficiency if turn.repeats else None  # else the flywheel gives or takes a part
            useful = ABSENT if share is None else write(share)
            which = "unsteady_turn" if run.drift and not turn.repeats else "steady_turn"
            yield say(f"report.{which}", by=by, **numbers, efficiency=useful, closing=write(turn.closing))
        yield _method(run, by, drafting)


def _method(run: MachineRun, by: str, drafting: Drafting) -> str:
    """Tell the method: the step of a table, the tolerance and the cost of a solver."""
    how, write = run.method, partial(drafting.number, digits=3)
    if how.step is not None:
        return word(drafting.language, "report.run_table", by=by, step=write(how.step), rows=len(run.t))
    tolerance = tiny(how.tolerance or 0.0, drafting.language)
    stiffness = write(how.stiffness)
    return word(drafting.language, "report.run_solver", by=by, name=how.name, tolerance=tolerance, stiffness=stiffness)
