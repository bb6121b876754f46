"""What is wanted of a train whose teeth lack: a ratio, how far it may be off, bounds of teeth (задание)."""

from __future__ import annotations

from decimal import Decimal

from plans.scene import fields as f
from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.readers import FieldReader, one
from plans.scene.tables import Missing, Table, key

MOST_SOUGHT = 300  # teeth of a wheel that is sought: beyond it a search takes minutes
LEAST_SOUGHT = 6


def check_tolerance(value: object) -> Decimal:
    """Read how far a ratio may be off: a part, or text in per cent; less than all of it."""
    found = units.part(value)
    if not 0 <= found < 1:
        raise wrong("ratio_tolerance")
    return found


def check_efficiency(value: object) -> Decimal:
    """Read an efficiency: a part, or text in per cent; more than nothing, no more than all."""
    found = units.part(value)
    if not 0 < found <= 1:
        raise wrong("efficiency")
    return found


def check_ratio(value: object) -> Decimal:
    """Read a ratio: negative where the links turn against each other."""
    found = units.quantity(value, units.NUMBER)
    if not found:
        raise wrong("zero", kind="ratio")
    return found


def teeth(least: int, most: int) -> FieldReader:
    """Give the reader of a number of teeth between bounds."""

    def check(value: object) -> int:
        found = f.whole(value, least)
        if found > most:
            raise wrong("many_teeth", most=most)
        return found

    return one(check, lambda: {**forms.whole(least), "maximum": most}, "number")


RATIO = one(check_ratio, lambda: {"type": "number"}, "number")
SOUGHT = teeth(LEAST_SOUGHT, MOST_SOUGHT)
TOLERANCE, EFFICIENCY = (
    one(check, lambda: {"anyOf": [{"type": "number"}, {"type": "string"}]}, shown)
    for check, shown in ((check_tolerance, '"3 %"'), (check_efficiency, "0.98"))
)


class WantedTable(Table):
    """A wanted ratio, and the bounds within which teeth are sought."""

    ratio: Decimal = key(
        RATIO,
        meaning="Wanted ratio of the driving link to the driven one; negative where they turn against each other.",
        missing=Missing("ratio", "ratio = 5.2", 1),
        also=("U", "u", "i"),
    )
    tolerance: Decimal = key(TOLERANCE, Decimal("0.05"), meaning='How far it may be off: a part, or "3 %".')
    least: int = key(SOUGHT, 17, meaning="Least teeth of an external wheel: fewer are undercut by a rack (подрез).")
    ring: int = key(SOUGHT, 85, meaning="Least teeth of a ring; it has 8 more than the wheel within it in any case.")
    greatest: int = key(SOUGHT, 150, meaning="Greatest teeth of any wheel.")

    def check(self) -> None:
        """See that some number of teeth is allowed."""
        if self.least > self.greatest:
            raise wrong("no_teeth_between", least=self.least, greatest=self.greatest, at=("greatest",))
