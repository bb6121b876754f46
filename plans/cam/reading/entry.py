"""A cam of the scene while it is examined: its faults, its pace, keys that it has no use for (данные кулачка)."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any

from plans.cam.reading.fields import CYCLOGRAM, Measure
from plans.cam.reading.form import CamTable
from plans.cam.reading.keyways import LEAST, MOST, standard
from plans.model.cam import DWELL, FLAT, ROCKING, ROLLER
from plans.scene import units
from plans.scene.faults import Fault, Path, Wrong
from plans.scene.scene import Scene
from plans.scene.units import UnitKind
from plans.words.words import message

Exact = tuple[Fraction, ...]


@dataclass(frozen=True)
class CamEntry:
    """A [[cam]] of a scene, and the list that its faults are put into."""

    scene: Scene
    number: int
    form: CamTable
    doubts: frozenset[Path] = frozenset()
    faults: list[Fault] = field(default_factory=list)

    @property
    def name(self) -> str:
        """Its name; of one without, its number from 1."""
        return self.form.name or str(self.number + 1)

    @property
    def translates(self) -> bool:
        """Whether the cam itself translates: a phase is given by its travel."""
        return any(phase.travel is not None for phase in self.form.phases)

    @property
    def rocks(self) -> bool:
        """Whether its follower rocks."""
        return self.form.follower.motion == ROCKING

    @property
    def flat(self) -> bool:
        """Whether its follower has a flat face."""
        return self.form.follower.end == FLAT

    @property
    def lift(self) -> Fraction:
        """The whole way of the follower, m, or degrees of one that rocks."""
        return Fraction((self.form.follower.swing if self.rocks else self.form.follower.lift) or 0)

    @property
    def asks_cyclogram(self) -> bool:
        """Whether it takes a phase or its setting from the cyclogram."""
        return CYCLOGRAM in (self.form.setting, *(phase.angle for phase in self.form.phases))

    def path(self, *path: str | int) -> Path:
        """Give the path of one of its keys in the file."""
        return "cam", self.number, *path

    def fault(self, path: Path, kind: str, /, **details: object) -> None:
        """Put a fault at one of its keys."""
        self.faults.append(self.scene.fault(self.path(*path), kind, **details))

    def doubted(self, *keys: str) -> bool:
        """Tell whether something within some of its keys is at fault already."""
        heads = {self.path(name) for name in keys}
        return any(path[: len(head)] == head for path in self.doubts for head in heads)

    def quantity(self, measure: Measure | None, kind: UnitKind, *path: str | int) -> Decimal | None:
        """Give a quantity that is of one kind in this cam; one of another is a fault."""
        try:
            return None if measure is None else measure.of(kind)
        except Wrong as error:
            self.fault(path, error.kind, **error.details)
            return None

    def spare(self, names: Iterable[str], given: Iterable[str], owner: str, *path: str | int) -> None:
        """Put a fault at each of some keys that is given, though it is of another owner."""
        for name in sorted({*names} & {*given}):
            self.fault((*path, name), "out_of_place", name=name, owner=message(f"owner.{owner}"))

    def sized(self, way: Fraction) -> tuple[str, str]:
        """Show a part of the follower's way with its unit: millimetres, or degrees of one that rocks."""
        return (shown(way), "°") if self.rocks else (shown(1000 * way), "mm")


def shown(number: Fraction | Decimal) -> str:
    """Show a number in at most ten digits."""
    return f"{float(number):.10g}"


def pace_of(entry: CamEntry) -> tuple[int, float | None]:
    """Give the sense of a cam, +1 counter-clockwise, and its speed, rad/s (m/s of one that translates), or none."""
    kind = units.VELOCITY if entry.translates else units.SPEED
    speed = entry.quantity(entry.form.speed, kind, "speed")
    if speed == 0:
        entry.fault(("speed",), "zero", kind=kind.name)
    if entry.form.speed is None and not entry.translates:
        linkage: Any = entry.scene.part("linkage")
        speed = linkage.drive.omega if linkage is not None else None
    return -1 if speed is not None and speed < 0 else 1, abs(float(speed)) if speed else None


METRE, HUNDREDS = 1, 100  # m, and of the way of the follower: so large a roller is one in millimetres
DEGREE = Fraction(math.radians(1))


def proportions(entry: CamEntry) -> None:
    """Put a fault at each of the given sizes that the others do not allow."""
    sizes, follower = entry.form.sizes, entry.form.follower
    if entry.rocks and entry.flat and sizes.centre is None and not entry.doubted("sizes"):
        stated = {"thing": "distance of the centres", "example": 'centre = "150 mm"'}
        entry.fault(("sizes", "centre"), "missing_for", **stated, why=message("why.flat_rocker"))
    if sizes.base is not None and sizes.offset is not None and abs(sizes.offset) >= sizes.base:
        entry.fault(("sizes", "offset"), "offset_beyond", base=_mm(sizes.base), offset=_mm(abs(sizes.offset)))
    if sizes.roller is not None and sizes.roller >= METRE and sizes.roller >= HUNDREDS * _way(entry):
        entry.fault(("sizes", "roller"), "huge_roller", way=shown(1000 * _way(entry)), example=shown(sizes.roller))
    elif sizes.base is not None and sizes.roller is not None and sizes.roller >= sizes.base and not entry.translates:
        entry.fault(("sizes", "roller"), "roller_beyond", base=_mm(sizes.base), roller=_mm(sizes.roller))
    if entry.rocks and None not in (three := (sizes.base, sizes.centre, follower.length)):
        _reach(entry, *three)  # type: ignore[arg-type]


def _reach(entry: CamEntry, base: Decimal, centre: Decimal, length: Decimal) -> None:
    """See that R0, L and the rocker make a triangle."""
    least, most = abs(centre - length), centre + length
    if not least < base < most:
        entry.fault(("sizes", "base"), "rocker_reach", least=_mm(least), most=_mm(most))


def _way(entry: CamEntry) -> Fraction:
    """Give how far the follower's end goes, m."""
    return Fraction(entry.form.follower.length or 0) * entry.lift * DEGREE if entry.rocks else entry.lift


def _mm(size: Decimal) -> str:
    return shown(1000 * size)


def misplaced(entry: CamEntry) -> None:
    """Put a fault at each key that is of another kind of cam."""
    _follower(entry)
    part, owner = ("lift", "translating") if entry.rocks else ("swing", "rocking")
    for number, phase in enumerate(entry.form.phases):
        entry.spare((part,), phase.given, owner, "phases", number)
        if phase.kind == DWELL and entry.path("phases", number, "kind") not in entry.doubts:
            entry.spare({"law", "lift", "swing"} - {part}, phase.given, "moving", "phases", number)
    _sizes(entry)
    _load(entry)
    _hub(entry)
    if entry.translates and entry.flat:
        entry.fault(("follower", "end"), "flat_translating")


def _follower(entry: CamEntry) -> None:
    given = entry.form.follower.given
    if not entry.rocks:
        entry.spare(("swing", "length", "turns"), given, "rocking", "follower")
    else:
        entry.spare(("lift",), given, "translating", "follower")
    if entry.rocks and entry.flat:
        entry.spare(("length",), given, "pinned", "follower")
    else:
        entry.spare(("face",), given, "flat_rocking", "follower")
    if not entry.flat:
        entry.spare(("reach",), given, "flat", "follower")


def _sizes(entry: CamEntry) -> None:
    given = entry.form.sizes.given
    if entry.form.follower.end != ROLLER:
        entry.spare(("roller",), given, "roller", "sizes")
    if entry.translates:
        entry.spare(("base", "offset", "centre"), given, "turning", "sizes")
    elif entry.rocks:
        entry.spare(("offset",), given, "translating", "sizes")
    else:
        entry.spare(("centre",), given, "rocking", "sizes")
    if not entry.flat:
        entry.spare(("curvature",), entry.form.limits.given, "flat", "limits")


def _hub(entry: CamEntry) -> None:
    hub = entry.form.hub
    if entry.translates:
        entry.spare(("hub",), entry.form.given, "turning")
    elif hub is not None and hub.width != 0:
        needs = [name for name in ("width", "depth") if getattr(hub, name) is None]
        if needs and not standard(1000 * hub.bore):
            ends = {"least": LEAST, "most": MOST, "names": " = ..., ".join(needs)}
            entry.fault(("hub", "bore"), "no_keyway", bore=_mm(hub.bore), **ends)
        elif hub.width is not None and hub.width >= hub.bore:
            entry.fault(("hub", "width"), "broad_keyway", bore=_mm(hub.bore), width=_mm(hub.width))
    elif hub is not None:
        entry.spare(("depth", "angle"), hub.given, "keyed", "hub")


def _load(entry: CamEntry) -> None:
    given = entry.form.load.given if entry.form.load else ()
    names, owner = (("mass", "force"), "translating") if entry.rocks else (("inertia", "moment"), "rocking")
    entry.spare(names, given, owner, "load")
