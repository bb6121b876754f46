"""The two ends of a spring, or of a force between links, as the scene gives them (концы)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal
from typing import Any

from plans.forces.reading import fields as h
from plans.linkage.reading import fields as g
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING
from plans.model.mechanism import FRAME, SLOWER
from plans.model.working import STROKES
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import Check, either, many
from plans.scene.tables import Missing, Table, key, table

PARTS = (WORKING, IDLE, FORWARD, BACKWARD)
DURING = (ALWAYS, *PARTS)
Vector = tuple[Decimal, Decimal]
NO_OVERRUN = (Decimal(0), Decimal(0))
ON_LINK = Missing("number of a moving link", "on = 2")
POINT_OF_LINK = Missing("point of the link", 'point = "B"')

# What editors are told of keys that fit each other or do not.
PART: Form = {"required": ["during"], "properties": {"during": {"enum": list(PARTS)}}}


def symbol() -> Any:
    """Declare the letters of a load."""
    return key(h.SYMBOL, None, meaning="Its letters on the sheet; default: F_us, F_D, M_3, F_s.")


def only_with_stroke(*others: Form, owned: tuple[str, ...] = ("stroke",)) -> Form:
    """Give the rule that only a load which changes over a stroke names one, and of its own stroke which works."""
    changes: Form = {"anyOf": [PART, {"required": ["overrun"]}, *others]}
    own: Form = {"anyOf": [{"required": [name]} for name in owned]}
    return {"dependentSchemas": {"stroke": changes, "working": {"allOf": [changes, own]}}}


class LoadTable(Table):
    """What loads on links have in common: when they act, and whether their work is the machine's purpose."""

    during: str | None = key(
        f.words(*DURING),
        None,
        meaning=(
            "When it acts; default: always, but a diagram against the motion without back on the working stroke. A "
            "stroke is the crank's turn from one extreme position to the other; a direction is wherever the point goes "
            "that way, also on a reversal within a stroke."
        ),
    )
    overrun: Decimal | Vector = key(
        h.OVERRUN,
        NO_OVERRUN,
        meaning="Shares of the stroke at its ends (перебег) in which the load rests.",
    )
    stroke: str | None = key(
        f.POINT,
        None,
        meaning="The point whose stroke counts; default: the output's, of a force between two points their own.",
    )
    working: str = key(
        f.words(*STROKES),
        SLOWER,
        meaning="Which stroke of that point is the working one; of the output [output] says it.",
    )
    useful: bool = key(f.FLAG, True, meaning="Whether its work is what the machine is for.")
    name: str | None = symbol()

    @property
    def phase(self) -> str:
        """The part of the turn in which the load acts."""
        return self.during or ALWAYS

    @property
    def rests(self) -> Vector:
        """The shares of the stroke, at its two ends, in which the load rests."""
        return self.overrun if isinstance(self.overrun, tuple) else (self.overrun, self.overrun)

    @property
    def owns_stroke(self) -> bool:
        """Whether the stroke that counts is another than the output's."""
        return self.stroke is not None

    @property
    def changes(self) -> bool:
        """Whether the load needs to know the stroke."""
        return self.phase != ALWAYS or self.rests != NO_OVERRUN

    def check(self) -> None:
        """See that the load acts somewhere on its stroke, and has none without need."""
        if sum(self.rests) >= 1:
            raise wrong("no_stroke_left", at=("overrun",))
        if self.stroke is not None and not self.changes:
            raise wrong("spare_stroke", at=("stroke",))
        if "working" in self.given and not (self.changes and self.owns_stroke):
            raise wrong("spare_working", at=("working",))


class EndTable(Table):
    """An end of a spring or a force between links: a point of one of the links that have it."""

    on: int = key(g.ANY_LINK, meaning="The link, where several have the point.", missing=ON_LINK)
    point: str = key(f.POINT, meaning="Point of the link.", missing=POINT_OF_LINK)


Ends = tuple[str | EndTable, ...]
ENDS = many(either(dict, table(EndTable), f.POINT), first=Check(h.check_ends, least=2, most=2))


def holders(end: str | EndTable, points_of: Mapping[int, Iterable[str]]) -> tuple[int, ...]:
    """Give the links that an end may be of: the frame alone where the point is fixed.

    >>> holders("O", {0: "OC", 1: "OA", 2: "A"}), holders("A", {0: "OC", 1: "OA", 2: "A"})
    ((0,), (1, 2))
    """
    if isinstance(end, EndTable):
        return (end.on,)
    found = tuple(link for link, points in points_of.items() if end in points)
    return (FRAME,) if FRAME in found else found


def point_of(end: str | EndTable) -> str:
    """Give the point that an end is at."""
    return end if isinstance(end, str) else end.point
