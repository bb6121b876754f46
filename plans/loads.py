"""Masses, loads and the drive's gear, as the scene gives them (массы, силы, привод); kinematics needs none."""

from __future__ import annotations

from decimal import Decimal

from plans import fields as f
from plans.faults import wrong
from plans.tables import Table, either, key, many, named, one, table

DURING = ("always", "working stroke", "idle stroke")
Vector = tuple[Decimal, Decimal]


class GearTable(Table):
    """The gear by which the machine is driven: pitch radius, place of the pinion, pressure angle."""

    radius: Decimal = key(f.LENGTH)
    at: Decimal = key(f.ANGLE)
    pressure_angle: Decimal = key(f.ANGLE, Decimal(20))


class MassTable(Table):
    """Mass kg, moment of inertia about the mass centre kg*m2, and the centre in the link's own frame."""

    mass: Decimal = key(f.MASS)
    inertia: Decimal = key(f.INERTIA, Decimal(0))
    centre: str | Vector = key(either(list, f.PLACE, one(f.choice, choices=("middle",))), (Decimal(0), Decimal(0)))


class DiagramTable(Table):
    """A load over the working stroke: shares of the stroke, and the force N at each."""

    travel: tuple[Decimal, ...] = key(many(f.NUMBER, first=f.FEW))
    force: tuple[Decimal, ...] = key(many(f.FORCE, first=f.FEW))

    def check(self) -> None:
        """See that travel rises from 0 to 1 with one force each."""
        rises = all(low <= high for low, high in zip(self.travel, self.travel[1:], strict=False))
        whole = len(self.travel) > 1 and self.travel[0] == 0 and self.travel[-1] == 1
        if not (rises and whole and len(self.travel) == len(self.force)):
            raise wrong("diagram")


class ForceTable(Table):
    """A force on a point of a link: a vector N, or a size against the motion, or a diagram of sizes."""

    on: int = key(f.MOVING_LINK)
    point: str = key(f.POINT)
    value: Decimal | Vector | None = key(either(list, many(f.FORCE, first=f.check_pair), f.FORCE), None)
    against: str | None = key(one(f.choice, choices=("motion",)), None)
    during: str = key(one(f.choice, choices=DURING), "always")
    diagram: DiagramTable | None = key(table(DiagramTable), None)

    def check(self) -> None:
        """See that the force has one form."""
        if (self.value is None) == (self.diagram is None):
            found = "none" if self.value is None else "both"
            raise wrong("one_of_two", first="value", second="diagram", found=found)
        if self.against is None and not isinstance(self.value, tuple):
            wanted, advice = "a vector [Fx, Fy] in N", 'write value = [Fx, Fy], or add against = "motion"'
            raise wrong("force_value", wanted=wanted, advice=advice, at=("diagram" if self.diagram else "value",))
        if self.against is not None and isinstance(self.value, tuple):
            wanted = "the size of the force, because its direction is against the motion"
            raise wrong("force_value", wanted=wanted, advice="write value = 1500, for example", at=("value",))


class MomentTable(Table):
    """A moment on a link, N*m, positive counter-clockwise."""

    on: int = key(f.MOVING_LINK)
    value: Decimal = key(f.MOMENT)
    during: str = key(one(f.choice, choices=DURING), "always")


class LoadsTable(Table):
    """Gravity, forces and moments; gravity as a number is downward."""

    gravity: Decimal | Vector | None = key(either(list, many(f.GRAVITY, first=f.check_pair), f.GRAVITY), None)
    forces: tuple[ForceTable, ...] = key(many(table(ForceTable), first=f.FEW), ())
    moments: tuple[MomentTable, ...] = key(many(table(MomentTable), first=f.FEW), ())


MASSES = named(f.LINK_NUMBER, table(MassTable), first=f.FEW_LINKS)
