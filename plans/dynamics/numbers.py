"""A machine's motion as plain data, for `solve`, and the pace that it gives its crank (числа динамики)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from geometry.errors import ConstructionError
from plans.analytic.dynamics.flywheel import reduced_link
from plans.analytic.dynamics.run import SteadySwing
from plans.analytic.dynamics.speeds import Swing
from plans.dynamics.form import DYNAMICS, DynamicsForm
from plans.dynamics.quantities import DynamicsComparison, compare_dynamics
from plans.dynamics.study import FLYWHEEL, REDUCTION, RUN, SPEEDS, WORKS, DynamicsStudy
from plans.linkage.quantities import compare
from plans.model.dynamics import CONSTRUCTION, Cycle, Flywheel, Reduced, Speeds
from plans.model.motion import VELOCITIES, Floats, Pace, Rates
from plans.model.run import Account, MachineRun, Stage, SteadyTurn
from plans.quantity import Numbers, Quantity, gap_numbers, plain
from plans.study import Study
from plans.words.words import message, placed

SEGMENTS = {"o_1k": 1, "o_1l": 0}  # cut off the axis of energy, at the greatest and the least speed
CRANK = "crank"
NOISE = 1e-9  # of the largest work: what of it is less is rounding, whose digits differ from machine to machine


def numbers(study: Study, by: str) -> Numbers:
    """Give a machine's motion by a road."""
    made = study.of(DynamicsStudy)
    account: Account = made.account if by == CONSTRUCTION else study.of(DynamicsComparison).exact
    plans, data = study.plans, dict[str, Any]()
    if REDUCTION in plans:
        data[REDUCTION] = _reduced(account.reduced)
    if WORKS in plans and account.cycle is not None:
        data[WORKS] = _cycle(account.cycle)
    if FLYWHEEL in plans and account.flywheel is not None:
        data[FLYWHEEL] = _flywheel(account.flywheel, made.task.rim.ratio)
    if SPEEDS in plans:
        data[SPEEDS] = {"after": _speeds(account.speeds), "before": _speeds(account.before)}
    if RUN in plans and account.run is not None:
        data[RUN] = {"flywheel": _borne(made.flywheel)} | _run(account.run)
    return Numbers({"scene": study.scene.heading(), "by": account.by, "dynamics": data}, bool(account.gaps))


def _reduced(found: Reduced) -> dict[str, Any]:
    return _rows(found, "phi", "moment", "inertia", "slope") | {"gaps": [gap_numbers(gap) for gap in found.gaps]}


def _rows(found: Any, *names: str) -> dict[str, Any]:
    """Give some rows of what is found by their names."""
    return {name: plain(getattr(found, name)) for name in names}


def _cycle(found: Cycle) -> dict[str, Any]:
    return {
        **_rows(found, "turned", "breaks"),
        "moments": [plain(row) for row in found.moments],
        **_rows(found, "means", "work", "surplus", "inertia"),
        "driving": found.driving + 0.0,
    }


def _flywheel(found: Flywheel, ratio: float) -> dict[str, Any]:
    """Give a flywheel; its inertias are reduced to the crank, on its own shaft it has that over the ratio squared."""
    return {
        "psi": np.arctan(found.slopes).tolist(),
        "cuts": list(found.cuts),
        "touches": [touch._asdict() for touch in found.touches],
        **{name: getattr(found, name) for name in ("whole", "energy", "own", "present", "needed", "inertia")},
        "reduced_to": CRANK,
        "on_its_shaft": {"ratio": ratio, "inertia": found.inertia / ratio**2},
    }


def _borne(wheel: Flywheel | None) -> dict[str, Any] | None:
    """Tell which flywheel runs, by either road that which was drawn, for the machine has but one."""
    return None if wheel is None else {"inertia": wheel.inertia, "reduced_to": CRANK, "by": wheel.by}


def _speeds(found: Speeds | None) -> dict[str, Any] | None:
    if found is None:
        return None
    return {
        **_rows(found, "turned", "omega"),
        "epsilon": [plain(row) for row in found.epsilon],
        "extremes": list(found.extremes),
        "delta": found.delta,
    }


def _run(found: MachineRun) -> dict[str, Any]:
    why = found.failure
    return {
        "stages": [_stage(found, stage) for stage in found.stages],
        "steady": None if found.steady is None else _steady(found.steady),
        "method": found.method._asdict(),
        "failure": None if why is None else {**why._asdict(), "advice": str(why.message)},
        **_rows(found, "t", "turned", "omega", "epsilon"),
    }


def _stage(run: MachineRun, stage: Stage) -> dict[str, Any]:
    return {
        "name": stage.name,
        "t": [float(run.t[stage.first]), float(run.t[stage.last])],
        "works": stage.works._asdict(),
        "energies": list(stage.energies),
        "closing": stage.closing,
    }


def _steady(turn: SteadyTurn) -> dict[str, Any]:
    names = "start", "extremes", "mean", "delta", "period", "closing", "repeats"
    told = {name: getattr(turn, name) for name in names} | {"extremes": list(turn.extremes)}
    return told | {"works": turn.works._asdict(), "efficiency": turn.works.efficiency}


def quantities_of(study: Study) -> tuple[Quantity, ...]:
    """Give what is compared of a machine's motion, and what the table of results tells."""
    found = study.of(DynamicsComparison)
    return *found.findings, *results(found.construction, found.exact)


def results(account: Account, exact: Account) -> Iterator[Quantity]:
    """Put the results of the strips beside those without their error; segments are parts of one length."""
    cuts = () if exact.flywheel is None else exact.flywheel.cuts
    for drawn, other in zip(_results(account, account.cycle), _results(exact, account.cycle), strict=True):
        named, value = drawn
        largest = sum(map(abs, cuts)) if named[1] in SEGMENTS else abs(other[1])
        yield Quantity.of(named, (value, other[1]), np.inf, largest)


def _results(account: Account, lettered: Cycle | None) -> Iterator[tuple[tuple[str, str, str], float]]:
    """Give what an account finds, lettered as another one says of the loads that they drive."""
    cycle, wheel, speeds = account.cycle, account.flywheel, account.speeds
    if cycle is not None and lettered is not None:
        (loads, other), way = lettered.indices, lettered.way
        lost = np.abs(cycle.work[-1]) <= NOISE * np.abs(cycle.work).max()  # all that a turn of weights leaves over
        yield (WORKS, f"M_{{{other}}}", "N*m"), 0.0 if lost else -way * cycle.driving
        yield (WORKS, f"A_{{{loads}}}(2π)", "J"), 0.0 if lost else way * float(cycle.work[-1])
    if wheel is not None:
        yield from (((FLYWHEEL, name, "J"), wheel.cuts[k]) for name, k in SEGMENTS.items())
        yield (FLYWHEEL, "J_0", "kg*m2"), wheel.whole
        yield (FLYWHEEL, "T_0", "J"), wheel.energy
        yield (FLYWHEEL, "J_0^*", "kg*m2"), wheel.own + wheel.present
        yield (FLYWHEEL, "J_{fly}", "kg*m2"), wheel.inertia
    if speeds is not None:
        yield (SPEEDS, "ω_{max}", "rad/s"), speeds.extremes[1]
        yield (SPEEDS, "ω_{min}", "rad/s"), speeds.extremes[0]
        yield (SPEEDS, "δ", ""), speeds.delta


class NoPace(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """Rates were asked of a machine that does not come to a steady motion."""


def pace_of(study: Study) -> Pace | None:
    """Give the rates of the crank in the steady motion of the machine, where the scene asks for them."""
    scene = study.scene
    if scene.of(DynamicsForm).drive.speed_from != DYNAMICS:
        return None
    dynamics = study.of(DynamicsStudy)
    found = compare_dynamics(dynamics, compare(dynamics.linkage, VELOCITIES.number))
    motion = _steady_motion(dynamics, found)
    if motion is None:
        line, column = scene.place(("drive", "speed_from"))
        raise NoPace(placed(f"{scene.file}:{line}:{column}", message("dynamics.no_pace")))
    return _pace(motion, dynamics.reduction.start, dynamics.linkage.sense)


def _steady_motion(study: DynamicsStudy, found: DynamicsComparison) -> Swing | SteadySwing | None:
    """Give the turn that repeats itself: with its motor, or where none is told by a constant moment."""
    if study.motor is None or study.motor.steepness == 0:
        motion = found.after or found.before
        return motion if isinstance(motion, Swing) else None
    from plans.analytic.dynamics.run import SteadySwing  # noqa: PLC0415  (the solver is paid for by motors)

    run = found.exact.run
    if found.turn is None or run is None or run.steady is None:
        return None
    return SteadySwing(reduced_link(found.turn, study.constant), study.motor, run.steady.start)


def _pace(motion: Swing | SteadySwing, start: float, sense: int) -> Pace:
    def rates(phi: Floats) -> Rates:
        turned = np.mod(sense * (phi - start), 2 * np.pi)
        return Rates(sense * motion.omega(turned), sense * motion.epsilon(turned))

    return rates
