"""The table of a rocker that drives a slider (коромыслово-ползунный механизм)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from plans.scene import fields as f
from plans.scene import units
from plans.scene.faults import Wrong, wrong
from plans.scene.tables import Table, key
from plans.synthesis.tables.demands import HALF, QUARTER, within
from plans.synthesis.tables.slots import STROKE


class RockerSliderTable(Table):
    """A rocker-slider that is wanted: its stroke, and how its rod leans, how long it is, or between what angles."""

    stroke: Decimal = STROKE
    pressure: Decimal | None = key(
        within("0.1", QUARTER),
        None,
        meaning="Largest pressure angle (угол давления), degrees; without angles it is the same to either side.",
        also=("alpha", "α"),
    )
    ratio: Decimal | None = key(f.positive(units.NUMBER), None, meaning="Ratio of the rocker to the rod.", also=("n",))
    angles: tuple[Decimal, Decimal] | None = key(
        f.pair(within("0", HALF), "[first, second]"),
        None,
        meaning="Angles of the rocker to the guide at both ends of the stroke, degrees: through its pivot.",
    )

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """See that the demands are enough."""
        angles = value.get("angles")
        if isinstance(angles, list) and len(set(map(str, angles))) == 1:
            yield wrong("synthesis_no_swing", at=("angles",))
        elif "angles" not in value and not {"pressure", "ratio"} <= value.keys():
            yield wrong("synthesis_leaning")
