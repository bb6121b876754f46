"""The form of machine dynamics: what is asked of the motion, motor, shafts and flywheel (исходные данные динамики)."""

from __future__ import annotations

from decimal import Decimal

from plans.dynamics import fields as d
from plans.dynamics.motor import MotorTable, RunTable
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import many
from plans.scene.scene import TechniqueForm
from plans.scene.tables import Missing, Table, key, table

DRIVE, DYNAMICS = "drive", "dynamics"  # where the speed of the crank comes from


class ShaftTable(Table):
    """A rotating mass beside the linkage: moment of inertia kg*m2, and its turns for one turn of the crank."""

    inertia: Decimal = key(
        d.INERTIA,
        meaning="Moment of inertia about its own axis.",
        missing=Missing("moment of inertia", "inertia = 0.4"),
    )
    ratio: Decimal = key(d.RATIO, Decimal(1), meaning="Its turns for one turn of the crank (передаточное отношение).")
    name: str = key(f.TEXT, "", meaning="What it is: gear, pulley, carrier.")


class FlywheelTable(Table):
    """What is known of the flywheel: the shaft that it is to sit on, mean diameter of its rim m, material."""

    ratio: Decimal = key(d.RATIO, Decimal(1), meaning="Turns of its shaft for one turn of the crank: 1 is the crank's.")
    diameter: Decimal | None = key(f.LENGTH, None, meaning="Mean diameter of the rim; its mass is found.")
    density: Decimal = key(d.MATERIAL, Decimal(7200), meaning="Density of the rim; default: grey iron.")
    breadth: Decimal = key(d.SHARE, Decimal("1.5"), meaning="Axial breadth of the rim's section over its thickness.")


class DynamicsTable(Table):
    """The steady motion that is asked for: mean speed, fluctuation, and the machine beside the linkage."""

    fluctuation: Decimal | None = key(
        d.FLUCTUATION,
        None,
        meaning='Coefficient of fluctuation of speed δ (неравномерность хода), 0.0125 or "1/80"; asks for a flywheel.',
    )
    reduction: bool = key(
        f.FLAG, False, meaning="The reduction alone, at the positions of the scene: no steady turn, no flywheel."
    )
    speed: Decimal | None = key(
        f.ANGULAR_SPEED, None, meaning="Mean angular speed of the crank; default: that of the drive."
    )
    divisions: int = key(d.DIVISIONS, 24, meaning="Strips of a turn in which the graphs are drawn.")
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
        meaning="Whether plans and forces are at the speed of the drive or at the machine's true one in each position.",
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
