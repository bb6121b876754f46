"""What a task asks for: vectors and points, each with its true value and its construction (задание)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple, TypeAlias

from drawings.grading.records import RECORDS, Found, Record
from drawings.measure.measured import MeasuredVector
from drawings.original.originals import Original, Originals
from geometry.board import Mark
from geometry.span import Span
from plans.techniques import named, technique_of

Place: TypeAlias = tuple[str, int | None]  # a plan and its position


class Asked(NamedTuple):
    """One vector or point that is asked for: letters of its ends, its name, its true value, how the record finds it."""

    name: str  # "v_BA"; of what has no letters of its own, those of its ends
    start: str  # "" : measured from the pole, as a point is
    end: str
    true: complex
    found: Found | None

    @property
    def letters(self) -> tuple[str, str]:
        """The letters of its ends."""
        return self.start, self.end


class PlanAsked(NamedTuple):
    """A plan that is asked for: which, on what sheet, its unit, its vectors, the scales of the plans that it rests on.

    The scales are true units a mm, by the subjects of the plans, its own among them.
    """

    plan: str
    position: int | None
    sheet: str
    unit: str
    vectors: tuple[Asked, ...]
    scales: Mapping[str, float]

    @property
    def place(self) -> Place:
        """Which plan it is."""
        return self.plan, self.position

    @property
    def letters(self) -> frozenset[str]:
        """The letters that stand on it."""
        return frozenset(letter for one in self.vectors for letter in one.letters if letter)


def plans_asked(originals: Originals, kinds: Mapping[str, str] = RECORDS) -> tuple[PlanAsked, ...]:
    """Give the plans that the sheets of a scene ask for."""
    return tuple(plan for sheet in originals.sheets for plan in _of_sheet(originals, sheet, kinds))


def ungraded(originals: Originals, kinds: Mapping[str, str] = RECORDS) -> tuple[str, ...]:
    """Give the kinds of sheets of a scene that are not graded yet."""
    own = dict.fromkeys(sheet.kind for sheet in originals.sheets)
    return tuple(kind for kind in own if technique_of(kind) not in kinds)


def _of_sheet(originals: Originals, sheet: Original, kinds: Mapping[str, str]) -> Iterator[PlanAsked]:
    row = kinds.get(technique_of(sheet.kind))
    if row is None:
        return
    marks = originals.seen(sheet).measured
    places: dict[Place, list[Asked]] = {}
    measures: dict[Place, tuple[str, float]] = {}
    for mark in marks.marks:
        place = mark.plan, mark.position
        if place not in places:
            places[place], measures[place] = [], (mark.unit, mark.scale)
        start, end = _ends(mark.name) if isinstance(mark, MeasuredVector) else ("", mark.name)
        places[place].append(Asked(mark.name, start, end, mark.stated, None))
    record: Record = named(row)(originals.study, sheet.leaf)
    for place, own in places.items():
        if place[0] in record.plans:
            vectors = tuple(_known(one, record, place) for one in own)
            unit, scale = measures[place]
            behind = {name: own[place[1]] for name, own in record.plans.items() if place[1] in own}
            yield PlanAsked(*place, sheet.name, unit, vectors, behind | {place[0]: scale})


def _ends(name: str) -> tuple[str, str]:
    start, _, end = name.rpartition(" ")
    return start, end


def _known(one: Asked, record: Record, place: Place) -> Asked:
    """Give a vector with what the record tells of it; of one that has no name there, which marks it lies between."""
    found = record.found.get((*place, *one.letters))
    if found is None:
        marks = _marks(record, place)
        if one.start not in marks or one.end not in marks:
            return one
        found = Found(one.name, one.true, Span(marks[one.start], marks[one.end]))
    return one._replace(name=found.name, true=found.true, found=found)


def _marks(record: Record, place: Place) -> dict[str, Mark]:
    own = {(start, end): found.span for (*there, start, end), found in record.found.items() if tuple(there) == place}
    return {letter: mark for letters, span in own.items() for letter, mark in zip(letters, span, strict=True)}
