"""Loads as the scene gives them: gravity, forces, moments, springs (нагрузки)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal
from typing import Any

from plans.forces.reading import fields as h
from plans.linkage.reading import fields as g
from plans.model.machine import ALWAYS, IDLE, WORKING
from plans.model.mechanism import FRAME
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.forms import Form
from plans.scene.readers import either, many
from plans.scene.tables import Missing, Table, key, table
from plans.words.words import message

DURING = (ALWAYS, WORKING, IDLE)
Vector = tuple[Decimal, Decimal]
NO_OVERRUN = (Decimal(0), Decimal(0))
ON_LINK = Missing("number of a moving link", "on = 2")
POINT_OF_LINK = Missing("point of the link", 'point = "B"')

# What editors are told of keys that fit each other or do not.
_LIST = {"type": "array"}
_ASIDE: list[Form] = [{"required": ["against"]}, {"required": ["direction"]}]
_PART: Form = {"required": ["during"], "properties": {"during": {"enum": [WORKING, IDLE]}}}
_BACK = {"diagram": {"required": ["back"]}}


def _symbol() -> Any:
    """Declare the letters of a load."""
    return key(h.SYMBOL, None, meaning="Its letters on the sheet; default: F_us, F_D, M_3, F_s.")


def _only_with_stroke(*others: Form) -> Form:
    """Give the rule that only a load which changes over a stroke names one."""
    return {"dependentSchemas": {"stroke": {"anyOf": [_PART, {"required": ["overrun"]}, *others]}}}


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


class LoadTable(Table):
    """What loads on links have in common: when they act, and whether their work is the machine's purpose."""

    on: int = key(h.LOADED_LINK, meaning="The link.", missing=ON_LINK)
    during: str | None = key(
        f.words(*DURING),
        None,
        meaning="When it acts; default: always, but a diagram against the motion without back on the working stroke.",
    )
    overrun: Decimal | Vector = key(
        h.OVERRUN,
        NO_OVERRUN,
        meaning="Shares of the stroke at its ends (перебег) in which the load rests.",
    )
    stroke: str | None = key(f.POINT, None, meaning="The point whose stroke counts; default: the output's.")
    useful: bool = key(f.FLAG, True, meaning="Whether its work is what the machine is for.")
    name: str | None = _symbol()

    @property
    def phase(self) -> str:
        """The part of the turn in which the load acts."""
        return self.during or ALWAYS

    @property
    def rests(self) -> Vector:
        """The shares of the stroke, at its two ends, in which the load rests."""
        return self.overrun if isinstance(self.overrun, tuple) else (self.overrun, self.overrun)

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


class ForceTable(LoadTable):
    """A force on a point of a link: a vector N; or a size or a diagram of sizes, against the motion or at an angle."""

    point: str = key(f.POINT, meaning="Point of the link.", missing=POINT_OF_LINK)
    value: Decimal | Vector | None = key(
        either(list, f.pair(h.FORCE, "[Fx, Fy]"), h.FORCE),
        None,
        meaning="The force; or its size, against the motion or in a direction.",
    )
    against: str | None = key(f.words("motion"), None, meaning="The force acts against the motion of its point.")
    direction: Decimal | None = key(f.ANGLE, None, meaning="The direction of the force, from +x.")
    diagram: DiagramTable | None = key(
        table(DiagramTable), None, meaning="The size of the force over the stroke, instead of value."
    )

    @property
    def phase(self) -> str:
        """The part of the turn in which the force acts: of a diagram against the motion, the stroke that it is of."""
        whole = self.diagram is None or self.against is None or bool(self.diagram.back)
        return self.during or (ALWAYS if whole else WORKING)

    @property
    def changes(self) -> bool:
        """Whether the force needs to know the stroke."""
        return self.diagram is not None or super().changes

    def check(self) -> None:
        """See that the force has one form."""
        if (self.value is None) == (self.diagram is None):
            found = "none" if self.value is None else "both"
            raise wrong("one_of_two", first="value", second="diagram", found=found)
        if self.against is not None and self.direction is not None:
            raise wrong("one_of_two", first="against", second="direction", found="both")
        self._check_direction()
        if self.diagram is not None and self.diagram.back and self.phase != ALWAYS:
            raise wrong("one_stroke", at=("during",))
        super().check()

    @classmethod
    def rules(cls) -> Form:
        """Say which form a force has one of, and that only one which changes over a stroke names one."""
        return {
            "oneOf": [{"required": ["value"]}, {"required": ["diagram"]}],
            "if": {"required": ["value"], "properties": {"value": _LIST}},
            "then": {"not": {"anyOf": _ASIDE}},
            "else": {"oneOf": _ASIDE},
            "not": {"required": ["diagram", *_PART["required"]], "properties": _PART["properties"] | _BACK},
            **_only_with_stroke({"required": ["diagram"]}),
        }

    def _check_direction(self) -> None:
        vector = isinstance(self.value, tuple)
        if self.against is None and self.direction is None and not vector:
            wanted, advice = "a vector [Fx, Fy] in N", message("advice.vector")
            if self.diagram is not None:
                wanted, advice = "a direction of the force", message("advice.direction")
            raise wrong("force_value", wanted=wanted, advice=advice, at=("diagram" if self.diagram else "value",))
        if vector and (self.against is not None or self.direction is not None):
            wanted = "the size of the force, because its direction is against the motion"
            if self.direction is not None:
                wanted = "the size of the force, because its direction is given"
            raise wrong("force_value", wanted=wanted, advice=message("advice.size"), at=("value",))


class MomentTable(LoadTable):
    """A moment on a link, N*m, positive counter-clockwise; or its size, against the link's rotation."""

    value: Decimal = key(
        h.MOMENT,
        meaning="Moment, positive counter-clockwise; or its size, against the rotation.",
        missing=Missing("moment", "value = 12"),
    )
    against: str | None = key(f.words("motion"), None, meaning="The moment acts against the rotation of its link.")

    @classmethod
    def rules(cls) -> Form:
        """Say that only a moment which changes over a stroke names one."""
        return _only_with_stroke()


class EndTable(Table):
    """An end of a spring: a point of one of the links that have it."""

    on: int = key(g.ANY_LINK, meaning="The link, where several have the point.", missing=ON_LINK)
    point: str = key(f.POINT, meaning="Point of the link.", missing=POINT_OF_LINK)


class SpringTable(Table):
    """A spring between points of two links: its ends, stiffness N/m and free length m."""

    between: tuple[str | EndTable, ...] = key(
        many(either(dict, table(EndTable), f.POINT), first=h.TWO_ENDS),
        meaning='Its two ends: points of two links, ["B", "O"].',
        missing=Missing("pair of ends", 'between = ["B", "O"]'),
    )
    stiffness: Decimal = key(h.STIFFNESS, meaning="Stiffness.", missing=Missing("stiffness", 'stiffness = "20 N/mm"'))
    free: Decimal = key(h.FREE_LENGTH, meaning="Free length.", missing=Missing("free length", 'free = "80 mm"'))
    name: str | None = _symbol()


class LoadsTable(Table):
    """Gravity, forces, moments and springs; gravity as a number is downward, and none where it is not given."""

    gravity: Decimal | Vector | None = key(
        either(list, f.pair(h.GRAVITY, "[gx, gy]"), h.GRAVITY),
        None,
        meaning="Gravity, downward or as a vector; without it links have no weight.",
    )
    forces: tuple[ForceTable, ...] = key(many(table(ForceTable), first=f.FEW), (), meaning="Forces on points of links.")
    moments: tuple[MomentTable, ...] = key(many(table(MomentTable), first=f.FEW), (), meaning="Moments on links.")
    springs: tuple[SpringTable, ...] = key(
        many(table(SpringTable), first=f.FEW), (), meaning="Springs between points of two links (пружины)."
    )

    def check(self) -> None:
        """See that no two loads bear the same letters."""
        seen = set()
        for kind in ("forces", "moments", "springs"):
            for index, load in enumerate(getattr(self, kind)):
                if load.name in seen:
                    raise wrong("repeated", entry=load.name, at=(kind, index, "name"))
                seen |= {load.name} - {None}


def holders(end: str | EndTable, points_of: Mapping[int, Iterable[str]]) -> tuple[int, ...]:
    """Give the links that an end of a spring may be of: the frame alone where the point is fixed.

    >>> holders("O", {0: "OC", 1: "OA", 2: "A"}), holders("A", {0: "OC", 1: "OA", 2: "A"})
    ((0,), (1, 2))
    """
    if isinstance(end, EndTable):
        return (end.on,)
    found = tuple(link for link, points in points_of.items() if end in points)
    return (FRAME,) if FRAME in found else found
