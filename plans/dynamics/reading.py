"""The task of dynamics made from the scene, its faults and its notes (задача динамики)."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import NamedTuple

from plans.dynamics.form import DynamicsForm, DynamicsTable
from plans.linkage.reading.form import LinkageForm
from plans.model.dynamics import Rim, Shaft, Task
from plans.scene.faults import Fault
from plans.scene.scene import Meaning, Scene


class DynamicsSurvey(NamedTuple):
    """What the examination of a scene's dynamics found."""

    faults: list[Fault]


def task_of(scene: Scene) -> Task:
    """Make the task: without a speed of its own it is the drive's, in whatever sense the crank turns."""
    form = scene.of(DynamicsForm).dynamics
    speed = scene.of(LinkageForm).drive.speed if form.speed is None else form.speed
    delta = None if form.fluctuation is None else float(form.fluctuation)
    return Task(abs(float(speed)), delta, form.divisions, tuple(_shafts(form)), _rim(form))


def _shafts(form: DynamicsTable) -> Iterator[Shaft]:
    if form.motor is not None and form.motor.rotor is not None:
        yield Shaft("rotor", float(form.motor.rotor), float(form.motor.ratio))
    for one in form.shafts:
        yield Shaft(one.name, float(one.inertia), float(one.ratio))


def _rim(form: DynamicsTable) -> Rim:
    rim = form.flywheel
    return Rim(float(rim.ratio), _float(rim.diameter), float(rim.density), float(rim.breadth))


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


def survey_of(meaning: Meaning) -> DynamicsSurvey:
    """Examine a scene's dynamics (row of the table of techniques)."""
    scene = meaning.scene
    form, drive = scene.of(DynamicsForm).dynamics, scene.of(LinkageForm).drive
    still = ("dynamics", "speed") if form.speed is not None else ("drive", "speed")
    speed = drive.speed if form.speed is None else form.speed
    return DynamicsSurvey([scene.fault(still, "crank_at_rest")] if speed == 0 else [])


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's dynamics (row of the table of techniques)."""
    form = scene.of(DynamicsForm).dynamics
    if form.fluctuation is not None and form.fluctuation > LARGE:
        yield scene.fault(("dynamics", "fluctuation"), "large_fluctuation", found=f"{float(form.fluctuation):g}")


LARGE = Decimal("0.2")  # machines that beat, crush and punch: tables of permitted fluctuation end at 1/5
