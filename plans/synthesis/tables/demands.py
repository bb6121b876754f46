"""What every table of synthesis may ask, and how its numbers are read (условия заданий)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from functools import partial
from typing import Any

from plans.scene import forms, units
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import FieldReader, one
from plans.scene.tables import Table, key

HALF, QUARTER = Decimal(180), Decimal(90)  # degrees
MOST_RATIO = Decimal(1000)  # of lengths: a rod that never ends
MOST_TIMES = Decimal("2.999")  # K of an overlap near a right angle


def _inside(value: object, least: Decimal, most: Decimal, kind: units.UnitKind) -> Decimal:
    found = units.quantity(value, kind)
    if not least <= found < most:
        raise wrong("demand_range", least=f"{least}", most=f"{most}")
    return found


def within(least: str, most: Decimal, kind: units.UnitKind = units.ANGLE) -> FieldReader:
    """Read a number from the least to less than the most."""
    low = Decimal(least)
    bounds = {"minimum": float(low), "exclusiveMaximum": float(most)}
    return one(partial(_inside), lambda: forms.quantity(kind, **bounds), kind.si, least=low, most=most, kind=kind)


class DemandTable(Table):
    """What every mechanism may be asked: how much slower it works than it returns."""

    overlap: Decimal | None = key(
        within("0", QUARTER), None, meaning="Overlap angle theta (угол перекрытия), degrees.", also=("theta", "θ")
    )
    time_ratio: Decimal | None = key(
        within("1", MOST_TIMES, units.NUMBER),
        None,
        meaning="Coefficient of mean speeds K (коэффициент изменения средней скорости), instead of the overlap.",
        also=("K",),
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that the overlap is told once."""
        if "overlap" in value and "time_ratio" in value:
            yield wrong("one_of_two", first="overlap", second="time_ratio", found="both", at=("time_ratio",))

    @classmethod
    def rules(cls) -> Form:
        """Say that the overlap is told once."""
        return {"not": {"required": ["overlap", "time_ratio"]}}
