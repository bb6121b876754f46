"""The form of a stroke: from where to where a primary link slides along its guide, and how fast (ход)."""

from __future__ import annotations

from decimal import Decimal

from plans.linkage.reading import fields as g
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.tables import Missing, Table, key


class StrokeTable(Table):
    """The stroke of a primary link that slides: places of its point along the guide, metres, and its speed.

    Of a cylinder between two points it is told by their distance.
    """

    between: tuple[str, ...] | None = key(
        g.LINE,
        None,
        meaning=(
            'A cylinder that turns the crank, by the points that it acts between, "EF": a fixed one and one of the '
            "crank; the stroke is told by their distance. Default: a link that slides on the frame is pushed along."
        ),
    )
    from_: Decimal = key(
        f.COORDINATE,
        meaning="Where the stroke begins: the slider's point from the point that the guide is given through, along it.",
        missing=Missing("place along the guide", 'from = "100 mm"', 0),
    )
    to: Decimal = key(
        f.COORDINATE,
        meaning="Where it ends.",
        missing=Missing("place along the guide", 'to = "500 mm"', 1),
    )
    speed: Decimal = key(
        g.SPEED,
        meaning='Speed of the slider, also as "40 mm/s", from the one place to the other.',
        missing=Missing("speed of the slider", 'speed = "40 mm/s"', 1),
    )
    acceleration: Decimal = key(g.ACCELERATION, Decimal(0), meaning="Acceleration of the slider, in the same sense.")

    @property
    def sense(self) -> int:
        """Whether it goes along the guide, +1, or back, -1."""
        return 1 if self.to > self.from_ else -1

    def check(self) -> None:
        """See that the stroke has a length."""
        if self.from_ == self.to:
            raise wrong("no_stroke", at=("to",))
