"""The techniques (разделы курса): their names, and what each is asked. Each is an object of its own folder.

Nothing of a technique but its `__init__` is imported before a scene asks for it: it is asked late for the rest.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, Final

if TYPE_CHECKING:
    from plans.explanation import Explanation, NoMark
    from plans.model.motion import Pace
    from plans.quantity import Comparison, Quantity, Stated
    from plans.scene.faults import Fault
    from plans.scene.scene import Meaning, Scene, Survey, TechniqueForm
    from plans.study import Made, Study
    from plans.words.words import Message

TECHNIQUES: Final = (
    "linkage", "diagrams", "forces", "dynamics", "balance", "bank", "rotor", "cyclogram", "cam", "structure",
    "transfer", "centres", "gears", "involute", "synthesis",
)  # fmt: skip

MOTION: Final = ("extremes", "positions", "velocities", "accelerations")


class Technique(ABC):
    """What one technique reads of a scene, what studies it, and what it can show."""

    tables: ClassVar[tuple[str, ...]] = ()  # its keys at the top of a file
    shares: ClassVar[Mapping[str, tuple[str, ...]]] = MappingProxyType({})  # its keys of tables that are not its own
    plans: ClassVar[tuple[str, ...]]  # what it makes, in order: the names that --only and --trace know
    sheets: ClassVar[Mapping[str, tuple[str, ...]]] = MappingProxyType({})  # each with the plans that it needs
    scales: ClassVar[Mapping[str, tuple[str, str]]] = MappingProxyType({})  # its keys of [sheet.scale]: unit, meaning
    needs: ClassVar[tuple[str, ...]] = ()  # techniques that it rests on
    borrows: ClassVar[tuple[str, ...]] = ()  # those whose tables it reads, though it makes none of their plans
    paces: ClassVar[bool] = False  # whether it may give the drive its rates

    @abstractmethod
    def form(self) -> type[TechniqueForm]:
        """Give what a scene says of it: its tables, and its keys of shared ones."""

    def completed(self, scene: Scene) -> Scene:
        """Give a scene with what its part in it says of the parts of others."""
        return scene

    def survey(self, meaning: Meaning) -> Survey:
        """Examine its part of a scene for faults that only it can see; its form has told all others."""
        from plans.scene.scene import Sound

        return Sound()

    def notes(self, scene: Scene) -> Iterable[Fault]:
        """Tell what is odd in its part of a scene."""
        return ()

    def asks(self, scene: Scene) -> Iterable[str]:
        """Name the techniques that the values of a scene's part refer to, though others like it stand alone."""
        return ()

    @abstractmethod
    def study(self, study: Study) -> Made:
        """Make its own study of a scene."""

    @abstractmethod
    def comparison(self, study: Study) -> Comparison:
        """Compare what it found by both roads."""

    def quantities(self, study: Study) -> Sequence[Quantity]:
        """Give all that its tables tell, which may be more than is compared."""
        return study.comparison(name_of(self)).findings

    def numbers(self, study: Study, by: str) -> Stated:
        """Give what it finds by a road as plain data, for `solve`: its quantities, where it has no more to say."""
        from plans.quantity import Numbers, numbers_of

        asked = (finding for finding in self.quantities(study) if finding.plan in study.plans)
        return Numbers({"scene": study.scene.heading(), "by": by, name_of(self): numbers_of(asked, by)})

    def marks(self, study: Study, position: int, name: str) -> Explanation | NoMark:
        """Give the drafting steps behind a name in a position, for `explain`: any that show its quantities."""
        from plans.explanation import explained_by

        return explained_by(self.quantities(study), position, name)

    def idle(self, scene: Scene) -> Iterable[Message]:
        """Say what is left out of a scene whose sheets do not ask for it."""
        return ()

    def pace(self, study: Study) -> Pace | None:
        """Give the rates of the drive at its positions, where the scene asks this technique for them."""
        return None

    def driving(self, study: Study) -> float | None:
        """Give the constant moment N*m of the drive that a steady turn of the machine needs, where it is told."""
        return None


def late(made: str, *of: str) -> Any:
    """Answer a question to a technique by what stands in its folder, as "module:name"; without a subject it is that.

    Where it takes no whole study, but parts `of` it, these are named so too, each in the folder of its technique.
    """

    def answer(technique: Technique, *subject: Any) -> Any:
        found = named(f"plans.{name_of(technique)}.{made}")
        given = [subject[0].of(named(f"plans.{part}")) for part in of] or subject
        return found(*given) if given else found

    return answer


def named(place: str) -> Any:
    """Import what stands in a place: "module:name"."""
    module, _, name = place.partition(":")
    return getattr(import_module(module), name)


@cache
def techniques() -> Mapping[str, Technique]:
    """Give the techniques by their names.

    >>> techniques()["forces"].needs
    ('linkage',)
    """
    return {name: import_module(f"plans.{name}").TECHNIQUE for name in TECHNIQUES}


def name_of(part: object) -> str:
    """Name the technique in whose folder something is defined: a technique, or a kind of form or study.

    >>> name_of(techniques()["rotor"])
    'rotor'
    """
    module = (part if isinstance(part, type) else type(part)).__module__
    return next(name for name in module.split(".") if name in TECHNIQUES)


def makers_of(sheet: str) -> tuple[str, ...]:
    """Give the techniques that make the plans which a sheet needs.

    >>> makers_of("kinematics")
    ('linkage', 'diagrams')
    """
    needed = techniques()[technique_of(sheet)].sheets[sheet]
    return tuple(name for name, technique in techniques().items() if not set(technique.plans).isdisjoint(needed))


def sheet_of(technique: str) -> str:
    """Give the first sheet of a technique, or of one that has none of its own the first that shows what it makes.

    >>> sheet_of("forces"), sheet_of("diagrams")
    ('forces', 'kinematics')
    """
    sheets = techniques()[technique].sheets
    others = (sheet for other in techniques().values() for sheet in other.sheets if technique in makers_of(sheet))
    return next(iter(sheets), "") or next(others)


def technique_of(sheet: str) -> str:
    """Give the technique whose sheet it is.

    >>> technique_of("forces")
    'forces'
    """
    return next(name for name, technique in techniques().items() if sheet in technique.sheets)
