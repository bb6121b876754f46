"""Masses, loads, gear and friction as the scene gives them (массы, силы, привод, трение); kinematics needs none."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal
from functools import partial

from plans.model.machine import ALWAYS, IDLE, WORKING
from plans.model.mechanism import FRAME, Link
from plans.scene import fields as f
from plans.scene.faults import wrong
from plans.scene.tables import Table, either, key, many, named, one, table
from plans.words.words import message

DURING = (ALWAYS, WORKING, IDLE)
Vector = tuple[Decimal, Decimal]
NO_OVERRUN = (Decimal(0), Decimal(0))

OVERRUN = either(list, many(f.SHARE, first=partial(f.check_pair, what="[start, end]")), f.SHARE)


class GearTable(Table):
    """The gear by which the machine is driven: pitch radius, place of the pinion, pressure angle."""

    radius: Decimal = key(f.LENGTH)
    at: Decimal = key(f.ANGLE)
    pressure_angle: Decimal = key(f.PRESSURE_ANGLE, Decimal(20))


MIDDLE = "middle"  # of a link's first two points: where its mass centre is


class MassTable(Table):
    """Mass kg, moment of inertia about the mass centre kg*m2, and the centre in its frame, or by a point."""

    mass: Decimal = key(f.MASS)
    inertia: Decimal = key(f.INERTIA, Decimal(0))
    centre: str | Vector = key(either(list, f.PLACE, f.POINT), (Decimal(0), Decimal(0)))

    def place(self, link: Link) -> complex:
        """Give the mass centre in the frame of its link; the middle is that of the link's first two points."""
        if isinstance(self.centre, str) and self.centre != MIDDLE:
            return link.points[self.centre]
        if isinstance(self.centre, str):
            first, second = list(link.points.values())[:2]
            return (first + second) / 2
        return complex(float(self.centre[0]), float(self.centre[1]))


class DiagramTable(Table):
    """A load over the stroke: shares of the stroke, the force N at each, and that of the idle stroke there."""

    travel: tuple[Decimal, ...] = key(many(f.NUMBER, f.not_empty, first=f.FEW))
    force: tuple[Decimal, ...] = key(many(f.FORCE, first=f.FEW))
    back: tuple[Decimal, ...] = key(many(f.FORCE, first=f.FEW), ())

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

    on: int
    during: str | None
    overrun: Decimal | Vector
    stroke: str | None
    useful: bool
    name: str | None

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

    on: int = key(f.LOADED_LINK)
    point: str = key(f.POINT)
    value: Decimal | Vector | None = key(either(list, many(f.FORCE, first=f.check_pair), f.FORCE), None)
    against: str | None = key(one(f.choice, choices=("motion",)), None)
    direction: Decimal | None = key(f.ANGLE, None)
    during: str | None = key(one(f.choice, choices=DURING), None)
    diagram: DiagramTable | None = key(table(DiagramTable), None)
    overrun: Decimal | Vector = key(OVERRUN, NO_OVERRUN)
    stroke: str | None = key(f.POINT, None)
    useful: bool = key(f.FLAG, True)
    name: str | None = key(f.SYMBOL, None)

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

    on: int = key(f.LOADED_LINK)
    value: Decimal = key(f.MOMENT)
    against: str | None = key(one(f.choice, choices=("motion",)), None)
    during: str | None = key(one(f.choice, choices=DURING), None)
    overrun: Decimal | Vector = key(OVERRUN, NO_OVERRUN)
    stroke: str | None = key(f.POINT, None)
    useful: bool = key(f.FLAG, True)
    name: str | None = key(f.SYMBOL, None)


class EndTable(Table):
    """An end of a spring: a point of one of the links that have it."""

    on: int = key(f.ANY_LINK)
    point: str = key(f.POINT)


class SpringTable(Table):
    """A spring between points of two links: its ends, stiffness N/m and free length m."""

    between: tuple[str | EndTable, ...] = key(many(either(dict, table(EndTable), f.POINT), first=f.check_ends))
    stiffness: Decimal = key(f.STIFFNESS)
    free: Decimal = key(f.FREE_LENGTH)
    name: str | None = key(f.SYMBOL, None)


class LoadsTable(Table):
    """Gravity, forces, moments and springs; gravity as a number is downward, and none where it is not given."""

    gravity: Decimal | Vector | None = key(either(list, many(f.GRAVITY, first=f.check_pair), f.GRAVITY), None)
    forces: tuple[ForceTable, ...] = key(many(table(ForceTable), first=f.FEW), ())
    moments: tuple[MomentTable, ...] = key(many(table(MomentTable), first=f.FEW), ())
    springs: tuple[SpringTable, ...] = key(many(table(SpringTable), first=f.FEW), ())

    def check(self) -> None:
        """See that no two loads bear the same letters."""
        seen = set()
        for kind in ("forces", "moments", "springs"):
            for index, load in enumerate(getattr(self, kind)):
                if load.name in seen:
                    raise wrong("repeated", entry=load.name, at=(kind, index, "name"))
                seen |= {load.name} - {None}


class PairTable(Table):
    """Friction of one pair, where it differs from that of all: coefficient, journal radius m, length of contact m."""

    coefficient: Decimal | None = key(f.FRICTION, None)
    radius: Decimal | None = key(f.LENGTH, None)
    length: Decimal | None = key(f.LENGTH, None)


class FrictionTable(Table):
    """Friction of all pairs: reduced coefficient, journal radius m of hinges, length of contact m of slides."""

    coefficient: Decimal = key(f.FRICTION)
    radius: Decimal = key(f.LENGTH)
    length: Decimal | None = key(f.LENGTH, None)
    pairs: Mapping[str, PairTable] = key(named(f.PAIR, table(PairTable), first=f.FEW), {})


def holders(end: str | EndTable, points_of: Mapping[int, Iterable[str]]) -> tuple[int, ...]:
    """Give the links that an end of a spring may be of: the frame alone where the point is fixed.

    >>> holders("O", {0: "OC", 1: "OA", 2: "A"}), holders("A", {0: "OC", 1: "OA", 2: "A"})
    ((0,), (1, 2))
    """
    if isinstance(end, EndTable):
        return (end.on,)
    found = tuple(link for link, points in points_of.items() if end in points)
    return (FRAME,) if FRAME in found else found


MASSES = named(f.LINK_NUMBER, table(MassTable), first=f.FEW_LINKS)
