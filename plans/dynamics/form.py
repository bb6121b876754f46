"""The form of machine dynamics: what is asked of the motion, motor, shafts and flywheel (исходные данные динамики)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from itertools import pairwise
from typing import Any

from plans.gears.form import PART
from plans.model.motor import Constant, Kloss, Linear, Motor, MotorLaw, Tabled
from plans.model.run import RunTask
from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import Check, many, one
from plans.scene.scene import TechniqueForm
from plans.scene.tables import Missing, Table, key, table
from plans.scene.units import WORKING

FRACTION = re.compile(r"\s*1\s*/\s*([0-9]+(?:[.,][0-9]+)?)\s*")
PLAIN = re.compile(rf"\s*{units.WRITTEN}\s*")
# For editors.
WRITTEN = rf"^\s*1\s*/\s*(?!0+(?:[.,]0+)?\s*$)[0-9]+(?:[.,][0-9]+)?\s*$|^\s*{units.COMMA}\s*$"
DIVISIONS_LEAST, DIVISIONS_MOST = 12, 4096
RATIO_LIMIT = Decimal("1e4")


def fluctuation(value: object) -> Decimal:
    """Read a coefficient of fluctuation of speed, above 0 and at most 1 (коэффициент неравномерности).

    >>> fluctuation("1/80"), fluctuation(Decimal("0.04"))
    (Decimal('0.0125'), Decimal('0.04'))
    """
    found = units.quantity(_unbroken(value) if isinstance(value, str) else value, units.NUMBER)
    if found == 0:
        raise wrong("no_fluctuation")
    if not 0 < found <= 1:
        raise wrong("fluctuation")
    return found


def _unbroken(text: str) -> Decimal | str:
    """Give "1/80" as a number; a decimal comma and a number in quotes have advice of their own."""
    ratio = FRACTION.fullmatch(text)
    if ratio and (part := Decimal(ratio[1].replace(",", "."))):
        return WORKING.divide(Decimal(1), part)
    if ratio or not PLAIN.fullmatch(text):
        raise wrong("fluctuation_written")
    return text


def divisions(value: object) -> int:
    """Read the number of strips of a turn."""
    found = f.whole(value, DIVISIONS_LEAST)
    if found > DIVISIONS_MOST:
        raise wrong("too_many_strips", most=DIVISIONS_MOST)
    return found


def ratio(value: object) -> Decimal:
    """Read how many turns a shaft makes for one of the crank; negative where it turns against it."""
    found = units.quantity(value, units.NUMBER)
    if found == 0 or abs(found) > RATIO_LIMIT:
        raise wrong("shaft_ratio", most=f"{RATIO_LIMIT:f}")
    return found


FLUCTUATION = one(
    fluctuation,
    lambda: {
        "anyOf": [{"type": "number", "exclusiveMinimum": 0, "maximum": 1}, {"type": "string", "pattern": WRITTEN}]
    },
    'share, or "1/80"',
)
DIVISIONS = one(divisions, lambda: forms.whole(DIVISIONS_LEAST) | {"maximum": DIVISIONS_MOST}, "number")
RATIO = one(ratio, lambda: forms.quantity(units.NUMBER) | {"not": {"const": 0}}, "number")
INERTIA = f.positive(units.INERTIA)
MATERIAL = f.positive(units.DENSITY)
SHARE = f.positive(units.NUMBER)
STEP = f.positive(units.TIME)


SPEED, MOMENT = f.positive(units.SPEED), f.positive(units.MOMENT)
TURNS_MOST = 100  # of steady motion that are shown: more are one black band
SETTLED, START = "settled", "start"
# The keys of each law, first the one that tells it from the others.
LAWS: Mapping[str, tuple[str, ...]] = {
    "starting": ("starting", "synchronous"),
    "breakdown": ("breakdown", "slip", "synchronous"),
    "speeds": ("speeds", "moments"),
    "moment": ("moment",),
}
OWN = {name: lead for lead, names in LAWS.items() for name in names if name != "synchronous"}


def turns(value: object) -> int:
    """Read the turns of steady motion that are shown."""
    found = f.whole(value, 1)
    if found > TURNS_MOST:
        raise wrong("too_many_turns", most=TURNS_MOST)
    return found


def _check_points(speeds: tuple[Decimal, ...]) -> None:
    """See that the speeds of a table begin at rest and rise."""
    if len(speeds) < 2 or speeds[0] != 0:
        raise wrong("speeds_from_rest", found=f"{speeds[0]:f}" if speeds else "", at=(0,) if speeds else ())
    for k, (before, after) in enumerate(pairwise(speeds), 1):
        if after <= before:
            raise wrong("speeds_rise", found=f"{after:f}", before=f"{before:f}", at=(k,))


class MotorTable(Table):
    """The motor: its rotor, its turns for one turn of the crank, and by one of four laws its moment over its speed."""

    rotor: Decimal | None = key(INERTIA, None, meaning="Moment of inertia of the rotor.")
    ratio: Decimal = key(
        RATIO,
        Decimal(1),
        meaning="Turns of the motor for one turn of the crank; default: of the train before it, or 1.",
    )
    starting: Decimal | None = key(
        MOMENT,
        None,
        meaning="Starting moment; from it the moment falls in a straight line to 0 at the synchronous speed.",
        missing=Missing("starting moment", 'starting = "60 N*m"'),
    )
    synchronous: Decimal | None = key(
        SPEED,
        None,
        meaning="Speed of the motor at which it has no moment.",
        missing=Missing("synchronous speed", 'synchronous = "1500 rpm"'),
    )
    breakdown: Decimal | None = key(
        MOMENT,
        None,
        meaning="Greatest moment of an induction motor, by Kloss' formula (формула Клосса).",
        missing=Missing("breakdown moment", 'breakdown = "60 N*m"'),
    )
    slip: Decimal | None = key(
        SHARE, None, meaning="Critical slip, at which that moment is.", missing=Missing("critical slip", "slip = 0.2")
    )
    speeds: tuple[Decimal, ...] = key(
        many(f.not_negative(units.SPEED), Check(_check_points, least=2), first=f.FEW),
        (),
        meaning="Speeds of the motor from 0 on, of a law by points; beyond the last its line goes on.",
        missing=Missing("speeds of the motor", "speeds = [0, 120, 157]"),
    )
    moments: tuple[Decimal, ...] = key(
        many(f.number(units.MOMENT), first=f.FEW),
        (),
        meaning="Moments at these speeds.",
        missing=Missing("moments of the motor", "moments = [40, 60, 0]"),
    )
    moment: Decimal | None = key(MOMENT, None, meaning="Moment that does not depend on the speed.")

    def check(self) -> None:
        """See that there is at most one law, that it is whole, and that a law by points comes down at its end."""
        named = [name for name in self.keys if name in self.given and name in OWN]
        leads = list(dict.fromkeys(OWN[name] for name in named))
        if len(leads) > 1:
            second = next(name for name in named if OWN[name] == leads[1])
            raise wrong("one_of_two", first=named[0], second=second, found="both", at=(second,))
        names = LAWS[leads[0]] if leads else ()
        for name in names:
            if name not in self.given:
                raise wrong("missing", at=(name,))
        if "synchronous" in self.given and "synchronous" not in names:
            self._refuse_synchronous(leads)
        if leads == ["speeds"]:
            self._check_moments()

    def _refuse_synchronous(self, leads: list[str]) -> None:
        if not leads:
            raise wrong("missing", at=("starting",))
        raise wrong("one_of_two", first=leads[0], second="synchronous", found="both", at=("synchronous",))

    def _check_moments(self) -> None:
        if len(self.moments) != len(self.speeds):
            raise wrong("as_many_moments", found=len(self.moments), wanted=len(self.speeds), at=("moments",))
        if self.moments[0] <= 0:
            raise wrong("not_positive", kind="moment", at=("moments", 0))
        if self.moments[-1] >= self.moments[-2]:
            raise wrong("moments_fall", at=("moments", len(self.moments) - 1))

    @classmethod
    def rules(cls) -> Form:
        """Say that there is at most one law, and that it is whole."""
        every = {*OWN, "synchronous"}
        laws = [{"required": list(names), **_none_of(every - set(names))} for names in LAWS.values()]
        return {"oneOf": [_none_of(every), *laws]}

    @property
    def law(self) -> MotorLaw | None:
        """The law; None where none is given."""
        if self.starting is not None:
            return Linear(*_floats(self.starting, self.synchronous))
        if self.breakdown is not None:
            return Kloss(*_floats(self.breakdown, self.slip, self.synchronous))
        if self.speeds:
            return Tabled(_floats(*self.speeds), _floats(*self.moments))
        return None if self.moment is None else Constant(float(self.moment))


class RunTable(Table):
    """The run of the machine from rest: step of the table, turns of steady motion, resistance, brake."""

    step: Decimal | None = key(
        STEP,
        None,
        meaning="Step of the table; default: a strip of the turn at full speed, or less where the motor is stiff.",
    )
    turns: int = key(
        one(turns, lambda: forms.whole(1) | {"maximum": TURNS_MOST}, "number"),
        5,
        meaning="Turns of steady motion that are shown.",
    )
    resistance: str = key(
        f.words(SETTLED, START),
        SETTLED,
        meaning="When loads and weights begin to act: at full speed, or from the start.",
    )
    brake: Decimal | None = key(MOMENT, None, meaning="Moment at the crank that stops the machine; without it, no end.")


def _none_of(names: set[str]) -> dict[str, Any]:
    return {"not": {"anyOf": [{"required": [name]} for name in sorted(names)]}}


def _floats(*values: Decimal | None) -> tuple[float, ...]:
    return tuple(float(value) for value in values if value is not None)


def motor_of(form: MotorTable | None) -> Motor | None:
    """Make the motor; None where the scene gives no law of its moment."""
    law = form.law if form else None
    return Motor(law, float(form.ratio)) if form and law is not None else None


def run_task(form: RunTable, speed: float) -> RunTask:
    """Make the task of a run to a mean speed rad/s."""
    brake = None if form.brake is None else float(form.brake)
    step = None if form.step is None else float(form.step)
    return RunTask(speed, form.turns, brake, form.resistance == START, step)


DRIVE, DYNAMICS = "drive", "dynamics"  # where the speed of the crank comes from


class TurningTable(Table):
    """What turns beside the linkage: as fast as a link of the train before the crank, if it is on one."""

    on: str = key(PART, "", meaning="The link of the train before the crank that it turns with, instead of a ratio.")

    def check(self) -> None:
        """See that its turns are told once."""
        if {"on", "ratio"} <= self.given:
            raise wrong("one_of_two", first="ratio", second="on", found="both", at=("on",))

    @classmethod
    def rules(cls) -> Form:
        """Say that its turns are told once."""
        return {"not": {"required": ["on", "ratio"]}}


class ShaftTable(TurningTable):
    """A rotating mass beside the linkage: moment of inertia kg*m2, and its turns for one turn of the crank."""

    inertia: Decimal = key(
        INERTIA, meaning="Moment of inertia about its own axis.", missing=Missing("moment of inertia", "inertia = 0.4")
    )
    ratio: Decimal = key(RATIO, Decimal(1), meaning="Its turns for one turn of the crank (передаточное отношение).")
    name: str = key(f.TEXT, "", meaning="What it is: gear, pulley, carrier.")


class FlywheelTable(TurningTable):
    """What is known of the flywheel: the shaft that it is to sit on, mean diameter of its rim m, material."""

    ratio: Decimal = key(RATIO, Decimal(1), meaning="Turns of its shaft for one turn of the crank: 1 is the crank's.")
    diameter: Decimal | None = key(f.LENGTH, None, meaning="Mean diameter; default: one of row Ra10, with t <= D/8.")
    density: Decimal = key(MATERIAL, Decimal(7200), meaning="Density of the rim; default: grey iron.")
    breadth: Decimal = key(SHARE, Decimal("1.5"), meaning="Axial breadth of the rim's section over its thickness.")


class DynamicsTable(Table):
    """The steady motion that is asked for: mean speed, fluctuation, and the machine beside the linkage."""

    fluctuation: Decimal | None = key(
        FLUCTUATION,
        None,
        meaning='Coefficient of fluctuation of speed δ (неравномерность хода), 0.0125 or "1/80"; asks for a flywheel.',
    )
    reduction: bool = key(
        f.FLAG, False, meaning="The reduction alone, at the positions of the scene: no steady turn, no flywheel."
    )
    speed: Decimal | None = key(
        f.ANGULAR_SPEED, None, meaning="Mean angular speed of the crank; default: that of the drive."
    )
    divisions: int = key(DIVISIONS, 24, meaning="Strips of a turn in which the graphs are drawn.")
    motor: MotorTable | None = key(table(MotorTable), None, meaning="The motor.")
    run: RunTable = key(
        table(RunTable),
        RunTable(),
        meaning="Run-up, steady motion and run-down (тахограмма), of a motor with one of the four laws.",
    )
    shafts: tuple[ShaftTable, ...] = key(
        many(table(ShaftTable), first=f.FEW), (), meaning="Gears and other rotating masses beside the linkage."
    )
    flywheel: FlywheelTable = key(table(FlywheelTable), FlywheelTable(), meaning="What is known of the flywheel.")

    def check(self) -> None:
        """See that a flywheel is not asked of the reduction alone."""
        if self.reduction and self.fluctuation is not None:
            raise wrong("one_of_two", first="reduction", second="fluctuation", found="both", at=("reduction",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a flywheel is not asked of the reduction alone."""
        return {"not": {"required": ["reduction", "fluctuation"], "properties": {"reduction": {"const": True}}}}


class SpeedTable(Table):
    """Of the drive where its speed comes from: the scene's own, or the motion of the machine."""

    speed_from: str = key(
        f.words(DRIVE, DYNAMICS),
        DRIVE,
        meaning="Whether plans and forces are at the speed of the drive or at the machine's true one in each position, "
        "which is that of its motor where it has one.",
    )


class DynamicsForm(TechniqueForm):
    """What a scene says of the motion of the machine."""

    dynamics: DynamicsTable = key(
        table(DynamicsTable),
        meaning="Motion of the machine under its loads (динамика машины): fluctuation, motor, shafts, flywheel.",
        missing=Missing("table", '[dynamics] with fluctuation = "1/80"', {}),
    )
    drive: SpeedTable = key(table(SpeedTable), SpeedTable(), meaning="Where the speed of the crank comes from.")

    @property
    def needs_turn(self) -> bool:
        """Whether it is told over a turn of the drive: it is."""
        return True
