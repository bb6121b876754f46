"""The tables of mechanisms that are found by their extreme positions (задания по крайним положениям)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any, ClassVar

from plans.scene import fields as f
from plans.scene import units
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.tables import Missing, key
from plans.synthesis.tables.demands import HALF, MOST_RATIO, DemandTable, within
from plans.synthesis.tables.slots import MEAN_SPEED, OUTPUT, PRESSURE, STROKE

LEFT = Decimal(270)  # degrees: where the left half of a circle ends


class SwingTable(DemandTable):
    """A mechanism of four links that is wanted by its swing and overlap, and what is chosen freely."""

    free: ClassVar[str] = "frame"  # the length that may be told instead of a place
    swing: Decimal = key(
        within("0.1", HALF),
        meaning="Swing psi (угол размаха) of the rocker, or of the coupler on its driver, degrees.",
        missing=Missing("swing", "swing = 40", 40),
        also=("psi", "ψ"),
    )
    place: Decimal | None = key(
        within("90", LEFT),
        None,
        meaning="Where O is on the circle that sees the chord, degrees at M, instead of the frame; the rocker's middle "
        "position is at 90, and beyond 270 all is mirrored.",
    )
    beyond: bool = key(
        f.FLAG,
        False,
        meaning="Whether O lies on the circle whose centre is beyond the chord; else a frame, or the best "
        "place, is looked for on both circles.",
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that no more than one parameter is told, and the overlap."""
        yield from super().misfits(value)
        if cls.free in value and "place" in value:
            yield wrong("one_of_two", first=cls.free, second="place", found="both", at=("place",))
        if "overlap" not in value and "time_ratio" not in value:
            yield wrong("missing", at=("overlap",))

    @classmethod
    def rules(cls) -> Form:
        """Say that no more than one parameter is told, and the overlap once."""
        return {
            "not": {"required": [cls.free, "place"]},
            "oneOf": [{"required": ["overlap"]}, {"required": ["time_ratio"]}],
        }


class RockerTable(SwingTable):
    """A crank-rocker that is wanted."""

    rocker: Decimal = key(
        f.LENGTH, meaning="Length of the rocker l3, m.", missing=Missing("rocker", 'rocker = "300 mm"', "300 mm")
    )
    frame: Decimal | None = key(
        f.LENGTH, None, meaning="Frame l4, m; default: that with the largest least transmission angle."
    )


class DoubleCrankTable(SwingTable):
    """A double crank that is wanted, as a crank-rocker whose crank is fixed."""

    free = "driver"
    coupler: Decimal = key(
        f.LENGTH, meaning="Length of the coupler l2, m.", missing=Missing("coupler", 'coupler = "300 mm"', "300 mm")
    )
    driver: Decimal | None = key(
        f.LENGTH, None, meaning="Driving crank l1, m; default: that with the largest least transmission angle."
    )


class SliderTable(DemandTable):
    """A slider-crank that is wanted: its stroke, and two of offset, overlap, ratio of lengths, pressure angle.

    With an overlap alone it is that with the largest least transmission angle.
    """

    stroke: Decimal = STROKE
    offset: Decimal | None = key(
        f.not_negative(units.LENGTH), None, meaning="Offset e of the guide (дезаксиал), m.", also=("e",)
    )
    ratio: Decimal | None = key(
        within("1.001", MOST_RATIO, units.NUMBER), None, meaning="Ratio l2/l1 of the rod to the crank."
    )
    pressure: Decimal | None = PRESSURE
    mean_speed: Decimal | None = MEAN_SPEED
    output: Decimal | None = OUTPUT
