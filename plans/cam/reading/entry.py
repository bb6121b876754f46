"""One cam of the file as it is examined: what it says, what is doubted of it already, its faults (запись кулачка)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction

from plans.cam.reading.fields import CYCLOGRAM, Measure
from plans.cam.reading.form import CamTable
from plans.model.cam import FLAT, ROCKING
from plans.scene.faults import Fault, Path, Wrong
from plans.scene.scene import Scene
from plans.scene.units import Kind
from plans.words.words import message

Exact = tuple[Fraction, ...]


@dataclass(frozen=True)
class Entry:
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

    def quantity(self, measure: Measure | None, kind: Kind, *path: str | int) -> Decimal | None:
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
