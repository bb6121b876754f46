"""What is given of a machine beside its linkage and its loads: motor, rotating masses, brake (дано)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.page.page import Drafting
from drawings.report.formula import DIGITS, literal
from plans.dynamics.form import LAWS, DynamicsTable, MotorTable
from plans.model.dynamics import Task
from plans.words.words import word

RPM = 30 / math.pi  # of a rad/s
TURNING = ("speeds", "synchronous")  # what of a motor is told in rpm


def given(form: DynamicsTable, task: Task, drafting: Drafting) -> Iterator[str]:
    """Tell the motor by its law, each rotating mass reduced to the crank, and the brake of the run."""
    motor = form.motor
    if motor is not None and motor.law is not None:
        yield "; ".join(_motor(motor, drafting))
    for shaft in task.shafts:
        rows = {"inertia": shaft.inertia, "ratio": shaft.ratio, "reduced": shaft.reduced}
        texts = {name: drafting.number(value, DIGITS) for name, value in rows.items()}
        key = "report.shaft" if shaft.ratio != 1 else "report.shaft_of_crank"
        yield word(drafting.language, key, name=literal(shaft.name), **texts)
    if motor is not None and motor.law is not None and form.run.brake is not None:
        yield drafting.word("brake given", moment=drafting.number(float(form.run.brake), DIGITS))


def _motor(motor: MotorTable, drafting: Drafting) -> Iterator[str]:
    """Tell a motor by the keys of its law, and its turns."""
    lead = next(lead for lead in LAWS if lead in motor.given)
    texts = {}
    for name in LAWS[lead]:
        row = np.ravel(getattr(motor, name)).astype(float) * (RPM if name in TURNING else 1.0)
        texts[name] = "; ".join(drafting.number(value, DIGITS) for value in row.tolist())
    yield drafting.word(f"motor by {lead}", **texts)
    if motor.ratio != 1:
        yield drafting.word("motor ratio", ratio=drafting.number(float(motor.ratio), DIGITS))
