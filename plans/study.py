"""A study (исследование): a scene, and what each technique makes of it, made once, when it is first asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from copy import copy
from functools import cached_property
from typing import Protocol, TypeVar

from plans.model.motion import Pace
from plans.quantity import Comparison, Quantity, Stated
from plans.scene.forms import resting
from plans.scene.scene import Scene
from plans.techniques import Technique, name_of, techniques

S = TypeVar("S")


class Made(Protocol):
    """What a technique made of a scene: its own study."""

    @property
    def made(self) -> Collection[str]: ...  # noqa: D102
    def construct(self, plans: frozenset[str], /) -> None: ...  # noqa: D102


class Study:
    """The memo of a scene: study.of(LinkageStudy), or study["linkage"], is its linkage, studied on first demand."""

    def __init__(self, scene: Scene, plans: Iterable[str] | None = None) -> None:
        self.scene = scene
        self.chosen = plans is not None  # asked for by name, not by the scene's sheets
        self.plans = frozenset(plans if plans is not None else plans_of(scene))  # what is asked for, by its name
        self.whole = False  # asked for with all that it rests on
        self._made: dict[str, Made] = {}
        self._compared: dict[str, Comparison] = {}
        self._numbers: dict[tuple[str, str], Stated] = {}

    @classmethod
    def of_all(cls, scene: Scene, whole: bool = False) -> Study:
        """Give a study of all that the tables of a scene allow, whatever its sheets are."""
        study = cls(scene, (plan for row in rows_of(scene) for plan in row.plans))
        study.whole = whole
        return study

    def __getitem__(self, technique: str) -> Made:
        """Give the study of a technique."""
        if technique not in self._made:
            self._made[technique] = techniques()[technique].study(self)
        return self._made[technique]

    def of(self, kind: type[S]) -> S:
        """Give what a technique made of the scene by its kind: its study, or its comparison of the two roads."""
        name = name_of(kind)
        found = self.comparison(name) if issubclass(kind, Comparison) else self[name]
        assert isinstance(found, kind)  # it is made in the folder of the technique
        return found

    @cached_property
    def techniques(self) -> tuple[str, ...]:
        """The techniques that make what is asked for, each after those that it rests on."""
        asked = [name for name, row in techniques().items() if not self.plans.isdisjoint(row.plans)]
        return resting(asked)

    def anew(self, technique: str, constructed: bool = False) -> Study:
        """Give this study with one technique to be made anew, or only compared anew, over what all others made."""
        other = copy(self)
        other._made = {name: made for name, made in self._made.items() if constructed or name != technique}
        other._compared = {name: comparison for name, comparison in self._compared.items() if name != technique}
        other._numbers = {key: numbers for key, numbers in self._numbers.items() if key[0] != technique}
        return other

    def exchanged(self, technique: str, made: Made) -> Study:
        """Give this study with what one technique made exchanged, and all that rests on it to be made anew."""
        other, kept = copy(self), resting([technique])
        other._made = {name: one for name, one in self._made.items() if name in kept} | {technique: made}
        other._compared = {name: one for name, one in self._compared.items() if name in kept and name != technique}
        other._numbers = {}
        return other

    def construct(self) -> None:
        """Make all that is asked for by construction."""
        for technique in self.techniques:
            self[technique].construct(self.plans)

    def comparison(self, technique: str) -> Comparison:
        """Give the comparison of the two roads of a technique."""
        if technique not in self._compared:
            self._compared[technique] = techniques()[technique].comparison(self)
        return self._compared[technique]

    def quantities(self, technique: str) -> Sequence[Quantity]:
        """Give all quantities of a technique that tables tell, by both roads."""
        return techniques()[technique].quantities(self)

    @property
    def comparisons(self) -> tuple[Comparison, ...]:
        """The comparisons of all techniques that are asked for."""
        return tuple(self.comparison(technique) for technique in self.techniques)

    def numbers(self, technique: str, by: str) -> Stated:
        """Give the numbers of a technique by one road."""
        if (technique, by) not in self._numbers:
            self._numbers[technique, by] = techniques()[technique].numbers(self, by)
        return self._numbers[technique, by]

    @property
    def pace(self) -> Pace | None:
        """The rates of the drive in each position, by the technique that the scene asks for them; None: its own."""
        paces = (techniques()[name].pace(self) for name in self.scene.techniques)
        return next((pace for pace in paces if pace is not None), None)

    @property
    def driving(self) -> float | None:
        """The constant moment N*m of the drive over a steady turn of the scene's machine; None where none drives it."""
        found = (techniques()[name].driving(self) for name in self.scene.techniques)
        return next((moment for moment in found if moment is not None), None)

    @property
    def made(self) -> frozenset[str]:
        """The plans that were made so far."""
        return frozenset(plan for study in self._made.values() for plan in study.made)

    @property
    def rows(self) -> tuple[Technique, ...]:
        """The rows of the techniques that are asked for."""
        return tuple(techniques()[technique] for technique in self.techniques)


def rows_of(scene: Scene) -> Iterator[Technique]:
    """Give the techniques that a scene has tables or sheets of, or tables of what one without any rests on."""
    asked = frozenset(scene.sheets)
    rows = techniques().values()
    return (row for row in rows if asked & row.sheets.keys() or any(scene.has((table,)) for table in _homes(row)))


def _homes(row: Technique) -> Iterable[str]:
    """Give the tables by which a scene has a technique."""
    return row.tables or tuple(table for name in row.needs for table in techniques()[name].tables)


def plans_of(scene: Scene) -> Iterable[str]:
    """Give the plans that the sheets of a scene need."""
    sheets = {sheet: plans for row in techniques().values() for sheet, plans in row.sheets.items()}
    return (plan for sheet in scene.sheets for plan in sheets[sheet])
