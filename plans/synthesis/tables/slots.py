"""The tables of mechanisms with a slot: slotted lever, Whitworth, sine, tangent (задания на кулисные механизмы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any, Final

from plans.scene import fields as f
from plans.scene import units
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.tables import Missing, Table, key
from plans.synthesis.tables.demands import QUARTER, DemandTable, within

STROKE: Final[Any] = key(
    f.LENGTH, meaning="Stroke H (ход), m.", missing=Missing("stroke", 'stroke = "120 mm"', "120 mm"), also=("H",)
)
PRESSURE: Final[Any] = key(
    within("0.1", QUARTER), None, meaning="Largest pressure angle (угол давления), degrees.", also=("alpha", "α")
)
MEAN_SPEED: Final[Any] = key(
    f.positive(units.VELOCITY),
    None,
    meaning="Mean speed of the working stroke (средняя скорость рабочего хода), m/s: the crank's speed is found.",
    also=("v",),
)
OUTPUT: Final[Any] = key(
    f.positive(units.NUMBER),
    None,
    meaning="Output (производительность): working strokes a minute; beside a mean speed it tells the overlap.",
    also=("n",),
)


class SlotTable(DemandTable):
    """A slotted link that is wanted: overlap, crank and frame, and what is asked of a ram."""

    crank: Decimal | None = key(f.LENGTH, None, meaning="Crank OA (кривошип), m.")
    frame: Decimal | None = key(f.LENGTH, None, meaning="Frame OC (стойка, межосевое расстояние), m.")
    stroke: Decimal | None = key(f.LENGTH, None, meaning="Stroke H (ход) of the ram, m.", also=("H",))
    pressure: Decimal | None = key(
        within("0.1", QUARTER),
        None,
        meaning="Largest pressure angle of the rod to the ram (угол давления), degrees; default: no rod is made.",
        also=("alpha", "α"),
    )
    mean_speed: Decimal | None = MEAN_SPEED
    output: Decimal | None = OUTPUT


class LeverTable(SlotTable):
    """An oscillating slotted link that is wanted: what fixes its swing, its crank or frame, and its lever."""

    swing: Decimal | None = key(
        within("0.1", QUARTER),
        None,
        meaning="Swing of the slotted link psi (угол размаха), degrees, instead of the overlap, which it is.",
        also=("psi", "ψ"),
    )
    lever: Decimal | None = key(f.LENGTH, None, meaning="Lever CB from its pivot to the end that drives the ram, m.")

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that the swing is told once."""
        yield from super().misfits(value)
        for name in ("overlap", "time_ratio"):
            if "swing" in value and name in value:
                yield wrong("one_of_two", first=name, second="swing", found="both", at=("swing",))

    @classmethod
    def rules(cls) -> Form:
        """Say that the swing is told once."""
        pairs = (("overlap", "time_ratio"), ("overlap", "swing"), ("swing", "time_ratio"))
        return {"not": {"anyOf": [{"required": [*pair]} for pair in pairs]}}


class SineTable(Table):
    """A sine mechanism that is wanted: its stroke, and how fast it is to be."""

    stroke: Decimal = STROKE
    mean_speed: Decimal | None = MEAN_SPEED
    output: Decimal | None = OUTPUT

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that its speed is told once: both strokes take the same time."""
        if "mean_speed" in value and "output" in value:
            yield wrong("one_of_two", first="mean_speed", second="output", found="both", at=("output",))

    @classmethod
    def rules(cls) -> Form:
        """Say that its speed is told once."""
        return {"not": {"required": ["mean_speed", "output"]}}


class TangentTable(Table):
    """A tangent mechanism that is wanted: two of stroke, pressure angle, and distance of its guide."""

    stroke: Decimal | None = key(f.LENGTH, None, meaning="Stroke H (ход), m.", also=("H",))
    pressure: Decimal | None = PRESSURE
    distance: Decimal | None = key(f.LENGTH, None, meaning="Distance h of the guide from O, m.", also=("h",))
    one_sided: bool = key(f.FLAG, False, meaning="Whether the lever leans to one side only from its shortest place.")
