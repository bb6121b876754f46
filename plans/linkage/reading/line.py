"""A line of the frame or of a link by a point of it and its angle (прямая звена)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

from plans.linkage.reading import fields as g
from plans.model.mechanism import FRAME
from plans.scene import fields as f
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import either
from plans.scene.tables import Missing, Table, key

Place = tuple[Decimal, Decimal]


class LineTable(Table):
    """A line of the frame or of a link: it needs no second point that would show its direction."""

    link: int = key(g.ANY_LINK, FRAME, meaning="The link that bears the line, its slot or its rod; default: the frame.")
    through: Place | str | None = key(
        either(list, f.PLACE, f.POINT),
        None,
        meaning="A point of the line: its place, of a link in the link's own frame, or the letter of a point of the "
        "link; default: the first point of the link.",
        missing=Missing("point of the line", "through = [0, 0]"),
    )
    angle: Decimal = key(
        f.ANGLE, Decimal(0), meaning="Angle of the line from +x, of a link from the link's own +x, counter-clockwise."
    )

    @property
    def letter(self) -> str | None:
        """The letter that names the point of the line."""
        return self.through if isinstance(self.through, str) else None

    def place(self, points: Mapping[str, Place]) -> Place | None:
        """Give the point of the line, by the places of its link's points."""
        if isinstance(self.through, tuple):
            return self.through
        return points.get(self.through or next(iter(points)))

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """Give the point that a line of the frame lacks."""
        if "through" not in value and value.get("link", FRAME) == FRAME:
            yield wrong("missing", at=("through",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a line of the frame needs a point."""
        return {"anyOf": [{"required": ["through"]}, {"required": ["link"], "properties": {"link": {"minimum": 1}}}]}
