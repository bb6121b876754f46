"""A force that a pressure gives on a piston, as the scene gives it: pressure, bore, rod (давление на поршень)."""

from __future__ import annotations

from decimal import Decimal

from plans.forces.reading import fields as h
from plans.forces.reading.diagram import DiagramTable
from plans.forces.reading.load import LoadTable
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.tables import Missing, key, table
from plans.scene.units import PI, WORKING

_BESIDE = ("bore", "rod", "behind")


class PressedTable(LoadTable):
    """A load that a pressure Pa may give: on a piston of a bore m, on the side of its rod less the rod."""

    diagram: DiagramTable | None = key(
        table(DiagramTable), None, meaning="The size of the force over the stroke, instead of value."
    )
    pressure: Decimal | None = key(
        h.PRESSURE, None, meaning="The pressure on a piston, instead of value; also in kPa, MPa, bar."
    )
    bore: Decimal | None = key(
        f.LENGTH,
        None,
        meaning="Diameter of the piston (диаметр поршня) that a pressure acts on.",
        missing=Missing("bore", 'bore = "80 mm"'),
    )
    rod: Decimal | None = key(
        f.LENGTH, None, meaning="Diameter of the rod, where the pressure is on its side of the piston."
    )
    behind: Decimal = key(
        h.PRESSURE,
        Decimal(0),
        meaning=(
            "Pressure on the piston's other side, as that of the air where pressures are absolute; without it they are "
            "the excess over it."
        ),
    )

    @property
    def pressed(self) -> bool:
        """Whether a pressure gives the load."""
        return self.pressure is not None or (self.diagram is not None and bool(self.diagram.pressure))

    @property
    def area(self) -> Decimal:
        """The area m2 that a pressure acts on; 1 where the load is no pressure."""
        if not self.pressed:
            return Decimal(1)
        bore, rod = self.bore or Decimal(0), self.rod or Decimal(0)
        return WORKING.multiply(PI / 4, WORKING.subtract(bore * bore, rod * rod))

    def forced(self, size: Decimal) -> float:
        """Give the force N of a pressure Pa; a force as it is."""
        return float(WORKING.multiply(size - self.behind, self.area)) if self.pressed else float(size)

    def check(self) -> None:
        """See that a pressure has a piston to act on, thicker than its rod, and nothing else has one."""
        given = [name for name in _BESIDE if name in self.given]
        if not self.pressed and given:
            raise wrong("no_pressure", name=given[0], at=(given[0],))
        if self.pressed and self.bore is None:
            raise wrong("missing", at=("bore",))
        if self.rod is not None and self.bore is not None and self.rod >= self.bore:
            raise wrong("thick_rod", at=("rod",))
        super().check()


def with_piston() -> Form:
    """Give the rule that a pressure has a bore, and nothing else a piston."""
    inner: Form = {"required": ["diagram"], "properties": {"diagram": {"required": ["pressure"]}}}
    piston: list[Form] = [{"required": [name]} for name in _BESIDE]
    pressed: Form = {"anyOf": [{"required": ["pressure"]}, inner]}
    return {"if": pressed, "then": {"required": ["bore"]}, "else": {"not": {"anyOf": piston}}}
