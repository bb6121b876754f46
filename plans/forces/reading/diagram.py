"""A load over the stroke as the scene gives it: its diagram (диаграмма нагрузки)."""

from __future__ import annotations

from decimal import Decimal

from plans.forces.reading import fields as h
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.readers import many
from plans.scene.tables import Missing, Table, key


class DiagramTable(Table):
    """A load over the stroke: shares of the stroke, the force N at each, and that of the idle stroke there."""

    travel: tuple[Decimal, ...] = key(
        many(h.TRAVEL, h.TWO, first=f.FEW),
        meaning="Places of the stroke as shares of it, rising from 0, where the working stroke begins, to 1.",
        missing=Missing("list of shares of the stroke", "travel = [0, 1]"),
    )
    force: tuple[Decimal, ...] = key(
        many(h.FORCE, h.AS_MANY, first=f.FEW),
        meaning="The force at each.",
        missing=Missing("list of forces", "force = [1500, 1500]"),
    )
    back: tuple[Decimal, ...] = key(
        many(h.FORCE, h.AS_MANY, first=f.FEW),
        (),
        meaning="The force at each on the stroke back, as of an indicator diagram.",
    )

    def check(self) -> None:
        """See that travel rises from 0 to 1 with one force each, on the idle stroke too where it is given."""
        beyond = next((k for k, share in enumerate(self.travel) if not 0 <= share <= 1), None)
        if beyond is not None:
            raise wrong("travel_share", found=f"{self.travel[beyond]:f}", at=("travel", beyond))
        rises = all(low <= high for low, high in zip(self.travel, self.travel[1:], strict=False))
        for name in ("force", "back") if "back" in self.given else ("force",):
            if not rises or len(self.travel) != len(getattr(self, name)):
                raise wrong("diagram", name=name)
        if self.travel[0] != 0 or self.travel[-1] != 1:
            raise wrong("travel", first=f"{self.travel[0]:f}", last=f"{self.travel[-1]:f}", at=("travel",))
