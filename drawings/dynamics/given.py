"""What is given of a machine beside its linkage and its loads: motor, rotating masses, brake (дано)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from drawings.page.page import Drafting
from drawings.report.formula import DIGITS, literal
from plans.dynamics.form import DynamicsTable
from plans.model.dynamics import Task
from plans.model.motor import Constant, Kloss, Linear, MotorLaw, Tabled
from plans.words.words import word

RPM = 30 / math.pi  # of a rad/s


def given(form: DynamicsTable, task: Task, drafting: Drafting) -> Iterator[str]:
    """Tell the motor by its law, each rotating mass reduced to the crank, and the brake of the run."""
    if form.motor is not None and form.motor.law is not None:
        kind, numbers = _law(form.motor.law)
        law = drafting.word(f"motor {kind}", **{name: _listed(row, drafting) for name, row in numbers.items()})
        geared = drafting.word("motor ratio", ratio=drafting.number(float(form.motor.ratio), DIGITS))
        yield law if form.motor.ratio == 1 else f"{law}; {geared}"
    for shaft in task.shafts:
        rows = {"inertia": shaft.inertia, "ratio": shaft.ratio, "reduced": shaft.reduced}
        texts = {name: drafting.number(value, DIGITS) for name, value in rows.items()}
        key = "report.shaft" if shaft.ratio != 1 else "report.shaft_of_crank"
        yield word(drafting.language, key, name=literal(shaft.name), **texts)
    if form.motor is not None and form.motor.law is not None and form.run.brake is not None:
        yield drafting.word("brake given", moment=drafting.number(float(form.run.brake), DIGITS))


def _law(law: MotorLaw) -> tuple[str, dict[str, Iterable[float]]]:
    """Name a law, and give what it is given by: moments N*m, speeds rpm, a slip."""
    match law:
        case Linear(starting, synchronous):
            return "line", {"starting": [starting], "synchronous": [RPM * synchronous]}
        case Kloss(breakdown, slip, synchronous):
            return "kloss", {"breakdown": [breakdown], "slip": [slip], "synchronous": [RPM * synchronous]}
        case Tabled(speeds, moments):
            return "table", {"moments": moments, "speeds": [RPM * speed for speed in speeds]}
        case Constant(moment):
            return "constant", {"moment": [moment]}
    raise AssertionError(law)  # a law is one of these


def _listed(row: Iterable[float], drafting: Drafting) -> str:
    return "; ".join(drafting.number(value, DIGITS) for value in row)
