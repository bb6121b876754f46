"""The form of a stroke: from where to where a primary link slides along its guide, and how fast (ход)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from itertools import pairwise
from typing import Any

from plans.linkage.reading import fields as g
from plans.model.mechanism import FRAME
from plans.scene import fields as f
from plans.scene.faults import Wrong, wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many
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


class StrokeTable(Table):
    """The stroke of a primary link that slides: places of its point along the guide, metres, and its speed.

    Of a cylinder between two points it is told by their distance.
    """

    between: tuple[str, ...] | None = key(
        g.LINE,
        None,
        meaning=(
            'A cylinder that drives, by the points that it acts between, "EF": of two links, or a fixed one and one '
            "of a link; the stroke is told by their distance. Default: a link that slides on the frame is pushed along."
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
    speed: Decimal | None = key(
        g.SPEED,
        None,
        meaning='Speed of the slider, also as "40 mm/s", from the one place to the other: the same in all positions.',
        missing=Missing("speed of the slider", 'speed = "40 mm/s"', 1),
    )
    acceleration: Decimal = key(g.ACCELERATION, Decimal(0), meaning="Acceleration of the slider, in the same sense.")
    speeds: tuple[Decimal, ...] = key(
        many(g.SPEEDS, first=f.FEW),
        (),
        meaning=(
            "In place of a speed its law over the stroke (закон движения): speeds at places, straight lines between "
            "them; the acceleration follows. 0 at an end is rest, with one acceleration from it or to it."
        ),
    )
    places: tuple[Decimal, ...] = key(
        many(f.COORDINATE, first=f.FEW),
        (),
        meaning="The places of these speeds, from the one end to the other; default: evenly over the stroke.",
    )

    @property
    def sense(self) -> int:
        """Whether it goes along the guide, +1, or back, -1."""
        return 1 if self.to > self.from_ else -1

    @property
    def rates(self) -> tuple[float, float]:
        """The signed speed m/s and acceleration m/s2; of a law its first speed alone that is none of rest."""
        speed = next(filter(None, self.speeds), Decimal(0)) if self.speeds else self.speed or Decimal(0)
        return self.sense * float(speed), self.sense * float(self.acceleration)

    @property
    def law(self) -> tuple[tuple[float, float], ...]:
        """The law: places m that rise, and signed speeds m/s there; none where one speed is told."""
        even = [self.from_ + (self.to - self.from_) * k / max(len(self.speeds) - 1, 1) for k in range(len(self.speeds))]
        told = zip(self.places or even, self.speeds, strict=True)
        return tuple(sorted((float(place), self.sense * float(speed)) for place, speed in told))

    def check(self) -> None:
        """See that the stroke has a length, and that a law is told over the whole of it."""
        if self.from_ == self.to:
            raise wrong("no_stroke", at=("to",))
        if self.speeds and "acceleration" in self.given:
            raise wrong("one_of_two", first="acceleration", second="speeds", found="both", at=("acceleration",))
        if self.places or "speeds" in self.given:
            self._check_law()

    def _check_law(self) -> None:
        places = self.places or (self.from_, self.to)
        steps = [self.sense * (high - low) for low, high in pairwise(places)]
        if (places[0], places[-1]) != (self.from_, self.to) or min(steps, default=Decimal(0)) <= 0:
            raise wrong("law_places", at=("places",))
        if len(self.speeds) < 2 or (self.places and len(self.places) != len(self.speeds)):
            raise wrong("law_speeds", count=max(len(self.places), 2), at=("speeds",))
        rests = [k for k, speed in enumerate(self.speeds) if not speed]
        inside = [k for k in rests if 0 < k < len(self.speeds) - 1] or (rests[1:] if len(self.speeds) == 2 else [])
        if inside:
            raise wrong("law_at_rest", at=("speeds", inside[0]))

    @classmethod
    def misfits(cls, value: Mapping[str, Any]) -> Iterator[Wrong]:
        """Give the speed that a stroke lacks, or has twice."""
        if not {"speed", "speeds"} & value.keys():
            yield wrong("missing", at=("speed",))
        if {"speed", "speeds"} <= value.keys():
            yield wrong("one_of_two", first="speed", second="speeds", found="both", at=("speed",))

    @classmethod
    def rules(cls) -> Form:
        """Say that a stroke has a speed or a law."""
        return {"oneOf": [{"required": ["speed"]}, {"required": ["speeds"]}]}
