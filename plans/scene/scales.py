"""Scales that a scene states (заданные масштабы): true units a millimetre, of lengths as a ratio such as "1:2" too."""

from __future__ import annotations

import re
from collections.abc import Iterator
from decimal import Decimal
from functools import partial
from typing import Any, ClassVar

from plans.scene import forms, units
from plans.scene.faults import wrong
from plans.scene.readers import Field, one
from plans.scene.tables import Table, key

FACTOR = units.Kind("scale factor", "", {}, Decimal("1e-12"), Decimal("1e12"))
MM = Decimal("0.001")  # m
PART = r"([0-9]+(?:\.[0-9]+)?)"
RATIO = re.compile(rf"\s*{PART}\s*:\s*{PART}\s*")


def length(value: object) -> Decimal:
    """Read a scale of lengths: metres a millimetre, or a ratio of the paper to the machine.

    >>> length("1:2"), length("2.5:1"), length(Decimal("0.005"))
    (Decimal('0.002'), Decimal('0.0004'), Decimal('0.005'))
    """
    if not isinstance(value, str):
        return units.positive(value, FACTOR)
    found = RATIO.fullmatch(value)
    paper, machine = map(Decimal, found.groups()) if found else (Decimal(0), Decimal(0))
    if not (paper and machine):
        raise wrong("scale_ratio")
    return units.positive(units.WORKING.divide(machine, paper) * MM, FACTOR)


def _form() -> forms.Form:
    return {"anyOf": [_number(), forms.text(rf"^\s*{PART}\s*:\s*{PART}\s*$")]}


_number = partial(forms.quantity, FACTOR, exclusiveMinimum=0)
LENGTH = one(length, _form, 'm a mm, or "1:2"')


def _factor(unit: str) -> Field:
    return one(units.positive, _number, f"{unit} a mm", kind=FACTOR)


def _stated(field: Field, meaning: str) -> Any:
    return key(field, None, meaning=meaning)


class ScaleTable(Table):
    """Scales that figures must have, whatever their room; each key governs the figures that its meaning names."""

    bare: ClassVar[str] = "bare_scale"

    length: Decimal | None = _stated(LENGTH, "Of the plan of positions.")
    velocity: Decimal | None = _stated(_factor("m/s"), "Of all velocity plans.")
    acceleration: Decimal | None = _stated(_factor("m/s2"), "Of all acceleration plans.")
    angle: Decimal | None = _stated(
        _factor("rad"), "Of the crank angle of the kinematic diagrams; the larger it is, the smaller these are."
    )
    scheme: Decimal | None = _stated(LENGTH, "Of loading schemes, and of schemes of a balanced machine.")
    force: Decimal | None = _stated(_factor("N"), "Of force plans, and of the hodograph of shaking forces.")
    lever: Decimal | None = _stated(_factor("m/s"), "Of Zhukovsky's lever.")
    moment: Decimal | None = _stated(
        _factor("N*m"), "Of the graph of the balancing moment, and of the moments of a bank of cylinders."
    )
    way: Decimal | None = _stated(_factor("m"), "Of the way of load diagrams; of a link that swings, degrees a mm.")
    unbalance: Decimal | None = _stated(_factor("kg*m"), "Of polygons of static moments.")
    couple: Decimal | None = _stated(_factor("kg*m2"), "Of the polygon of a rotor's moments of unbalance.")
    rotor: Decimal | None = _stated(LENGTH, "Of the views of a rotor.")
    cam: Decimal | None = _stated(LENGTH, "Of a cam's profile and of the figure of its sizes.")
    wheel: Decimal | None = _stated(LENGTH, "Of the sketch of the flywheel.")

    @property
    def stated(self) -> Iterator[tuple[str, float]]:
        """Give the keys that the scene states, each with its scale in 12 digits, as sheets write them."""
        yield from ((name, float(f"{mu:.12g}")) for name in self.keys if (mu := getattr(self, name)) is not None)
