"""The task of dynamics made from the scene, its faults and its notes (задача динамики)."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import NamedTuple, TypeVar

from plans.dynamics.form import DynamicsForm, DynamicsTable, FlywheelTable, ShaftTable, motor_of
from plans.gears.crank import CrankTrain
from plans.gears.form import geared
from plans.gears.reading import GearsSurvey, crank_train, unknown
from plans.linkage.reading.form import LinkageForm
from plans.model.dynamics import Rim, Shaft, Task
from plans.scene.faults import Fault, Path
from plans.scene.scene import Meaning, Scene

T = TypeVar("T", ShaftTable, FlywheelTable)


class DynamicsSurvey(NamedTuple):
    """What the examination of a scene's dynamics found."""

    faults: list[Fault]


def task_of(scene: Scene) -> Task:
    """Make the task: without a speed of its own it is the drive's, in whatever sense the crank turns."""
    form = scene.of(DynamicsForm).dynamics
    speed = scene.of(LinkageForm).drive.omega if form.speed is None else form.speed
    delta = None if form.fluctuation is None else float(form.fluctuation)
    return Task(abs(float(speed)), delta, form.divisions, tuple(_shafts(form)), _rim(form))


def _shafts(form: DynamicsTable) -> Iterator[Shaft]:
    if form.motor is not None and form.motor.rotor is not None:
        yield Shaft("rotor", float(form.motor.rotor), float(form.motor.ratio))
    for shaft in form.shafts:
        yield Shaft(shaft.name, float(shaft.inertia), float(shaft.ratio))


def _rim(form: DynamicsTable) -> Rim:
    rim = form.flywheel
    return Rim(float(rim.ratio), _float(rim.diameter), float(rim.density), float(rim.breadth))


def _float(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


def survey_of(meaning: Meaning) -> DynamicsSurvey:
    """Examine a scene's dynamics."""
    scene = meaning.scene
    if geared(scene) and meaning.of(GearsSurvey).faults:  # of a speed that is not the train's nothing more is said
        return DynamicsSurvey([*_train_faults(scene)])
    form, drive = scene.of(DynamicsForm).dynamics, scene.of(LinkageForm).drive
    still = ("dynamics", "speed") if form.speed is not None else ("drive", "speed")
    speed = drive.omega if form.speed is None else form.speed
    return DynamicsSurvey(
        [scene.fault(still, "crank_at_rest")]
        if speed == 0 and drive.stroke is None
        else [*_motor_faults(meaning, abs(speed)), *_train_faults(scene)]
    )


def with_train(scene: Scene) -> Scene:
    """Give a scene with the turns of motor, shafts and flywheel by the train before the crank, and with its inertia."""
    form, train = scene.of(DynamicsForm), crank_train(scene)
    if train is None:
        return scene
    machine, motor = form.dynamics, form.dynamics.motor
    if motor is not None and "ratio" not in motor.given:
        motor = motor.changed(ratio=train.turns(train.train.drives[0][0]))
    own = [ShaftTable(inertia=Decimal(train.inertia), name="train")] if train.inertia else []
    shafts, wheel = (*(_turned(shaft, train) for shaft in machine.shafts), *own), _turned(machine.flywheel, train)
    return scene.changed(form.changed(dynamics=machine.changed(motor=motor, shafts=shafts, flywheel=wheel)))


def _turned(part: T, train: CrankTrain) -> T:
    return part.changed(ratio=train.turns(part.on)) if part.on in train.links else part


def _train_faults(scene: Scene) -> Iterator[Fault]:
    """Give what of a machine does not fit the train before its crank: a speed, a link that something is on."""
    form, train = scene.of(DynamicsForm).dynamics, crank_train(scene)
    if train is None and geared(scene):
        return
    if train is not None and form.speed is not None:
        yield from train.unlike(scene, ("dynamics", "speed"), form.speed.copy_sign(train.speed))
    links = train.links if train is not None else ()
    parts: list[tuple[Path, str]] = [(("dynamics", "flywheel", "on"), form.flywheel.on)]
    parts += [(("dynamics", "shafts", k, "on"), shaft.on) for k, shaft in enumerate(form.shafts)]
    for path, name in parts:
        if name and name not in links:
            yield scene.fault(path, "no_link_before_crank", **unknown(name, links))


def _motor_faults(meaning: Meaning, speed: Decimal) -> Iterator[Fault]:
    """Give what keeps a motor from running the machine: no law of its moment, or one that ends below its speed."""
    scene = meaning.scene
    form = scene.of(DynamicsForm).dynamics
    if form.motor is None or form.motor.law is None:
        doubted = any(path[:2] == ("dynamics", "motor") for path in meaning.doubts)
        if scene.has(("dynamics", "run")) and not doubted:
            yield scene.fault(("dynamics", "run"), "no_law")
    elif form.motor.speeds and form.motor.speeds[-1] < speed * abs(form.motor.ratio):
        found, wanted = (f"{float(limit):.5g}" for limit in (form.motor.speeds[-1], speed * abs(form.motor.ratio)))
        path = ("dynamics", "motor", "speeds", len(form.motor.speeds) - 1)
        yield scene.fault(path, "speeds_end", found=found, wanted=wanted)


def notes_of(scene: Scene) -> Iterator[Fault]:
    """Give the notes on a scene's dynamics."""
    form = scene.of(DynamicsForm).dynamics
    if form.fluctuation is not None and form.fluctuation > LARGE:
        yield scene.fault(("dynamics", "fluctuation"), "large_fluctuation", found=f"{float(form.fluctuation):g}")
    if geared(scene) and scene.meaning.faults:
        return
    motor, speed, drive = motor_of(form.motor), task_of(scene).speed, abs(float(scene.of(LinkageForm).drive.omega))
    if drive and speed and not 1 / OTHER <= speed / drive <= OTHER:
        yield scene.fault(("dynamics", "speed"), "other_speed", found=f"{speed:.5g}", drive=f"{drive:.5g}")
    free = motor.speed(0.0) if motor else None
    if free is not None and not speed <= free <= FASTEST * speed:
        yield scene.fault(("dynamics", "motor"), "free_speed", found=f"{free:.5g}", wanted=f"{speed:.5g}")


OTHER = 9.0  # times the speed of the drive, or as many times less: rpm written for rad/s is 9.55 times
FASTEST = 2.0  # times its speed under load: no motor runs faster without it, and a ratio left out is mostly more
LARGE = Decimal("0.2")  # machines that beat, crush and punch: tables of permitted fluctuation end at 1/5
