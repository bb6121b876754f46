"""What is given of a machine beside its linkage and its loads: motor, rotating masses, brake (дано)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.lettering.words import Phrase, Slot
from drawings.page.page import Drafting
from drawings.report.formula import DIGITS, literal
from plans.dynamics.form import LAWS, DynamicsTable, MotorTable
from plans.gears.quantities import GearsComparison
from plans.gears.study import GearsStudy, pair_of
from plans.model.dynamics import Task
from plans.study import Study
from plans.words.words import word

RPM = 30 / math.pi  # of a rad/s
TURNING = ("speeds", "synchronous")  # what of a motor is told in rpm


def given(form: DynamicsTable, task: Task, drafting: Drafting, train: Sequence[Phrase] = ()) -> Iterator[str]:
    """Tell the motor by its law, the train, each rotating mass reduced to the crank, and the brake of the run."""
    motor = form.motor
    if motor is not None and motor.law is not None:
        yield "; ".join(_motor(motor, drafting))
    yield from train
    for shaft in task.shafts[: -1 if len(train) > 1 else None]:  # that of the train, the last one, is told with it
        rows = {"inertia": shaft.inertia, "ratio": shaft.ratio, "reduced": shaft.reduced}
        texts = {name: drafting.number(value, DIGITS) for name, value in rows.items()}
        key = "report.shaft" if shaft.ratio != 1 else "report.shaft_of_crank"
        yield word(drafting.language, key, name=literal(shaft.name), **texts)
    if motor is not None and motor.law is not None and form.run.brake is not None:
        yield drafting.word("brake given", moment=drafting.number(float(form.run.brake), DIGITS))


def train_given(study: Study, driving: float, drafting: Drafting) -> Iterator[Phrase]:
    """Tell what the train before the crank gives: its ratio, the moment N*m at its driving link, its inertia."""
    train, found = study.of(GearsStudy).train, study.of(GearsComparison).analysis
    drive, crank, gear = train.drives[0][0], train.output, train.gears[0]
    turns = {link: float(share[0] / found.shares(gear)[crank][0]) for link, share in found.shares(gear).items()}
    said = {"letters": f"U_{{{pair_of(drive, crank)}}}", "ratio": Slot("U", turns[drive], DIGITS)}
    if driving:
        moment = Slot(f"M_{drive}", driving / turns[drive], DIGITS)
        lossy = " with friction" if train.efficiency else ""
        yield drafting.phrase(f"gears before crank{lossy}", drive=drive, moment=moment, **said)
    else:
        yield drafting.phrase("gears alone before crank", **said)
    arms = {link: float(train.heights[link] - train.heights[train.carrier_of[link]]) for link in train.masses}
    rows = [("J", link, size, turns[link]) for link, size in train.inertia.items()]
    rows += [("m", link, size, arms[link] * turns[train.carrier_of[link]]) for link, size in train.masses.items()]
    if inertia := found.inertia(gear, crank):
        terms = ",  ".join(
            f"{letter}_{{{link}}}:  {_term(train.count(link), size, arm, drafting)}" for letter, link, size, arm in rows
        )
        yield drafting.phrase("gears at crank", link=crank, terms=terms, inertia=Slot("J_train", inertia, DIGITS))


def _term(count: int, size: float, arm: float, drafting: Drafting) -> str:
    """Write what some links alike add to a reduced inertia: 3·0.004·1.667²."""
    factors = [f"{count}"] * (count > 1) + [drafting.number(size, DIGITS)]
    return "·".join([*factors, *[f"{drafting.number(abs(arm), DIGITS)}²"] * (abs(arm) != 1)])


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
