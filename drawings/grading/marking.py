"""Marking: how many points a quantity has and what a mistake costs, by the teacher's own table (шкала баллов)."""

from __future__ import annotations

import tomllib
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final, NamedTuple, TypeAlias

from drawings.grading import verdict
from drawings.grading.verdict import Verdict
from drawings.paper.limits import TEXT_LENGTH
from geometry.board import Board
from geometry.errors import DraftError
from geometry.regular_file import regular_bytes
from geometry.steps import Span
from plans.words.words import message

Place: TypeAlias = tuple[str, int | None]  # a plan and its position
Letters: TypeAlias = tuple[str, int | None, str, str]  # plan, position, and the letters of both ends


class Slip(NamedTuple):
    """A mistake that students make: its kind, what the vector is by it, and of which quantity the mistake is."""

    kind: str
    value: complex
    of: str = ""


class Found(NamedTuple):
    """How a vector is found: its name, and the marks of the record that it lies between.

    The side of a polygon has the corners of the polygon that it is laid between, and so has a diagonal; `slips` are
    mistakes known of it, and `back` what it is to be turned round, if that has a name of its own.
    """

    name: str
    span: Span
    side: Span | None = None
    diagonal: bool = False
    slips: tuple[Slip, ...] = ()
    back: str = ""


class Record(NamedTuple):
    """What a technique knows of how a sheet is drawn: how vectors are found, which plans it has to what scales.

    The marks of a plan's `boards` bear the letters of its ends. `subjects` are those of the record under which plans
    are drawn that have names of their own, `arrows` and `arcs` the known forces and moments that a plan shows by such
    as are not to scale.
    """

    found: Mapping[Letters, Found]
    plans: Mapping[str, Mapping[int | None, float]]
    boards: Mapping[Place, Board] = MappingProxyType({})
    subjects: Mapping[str, str] = MappingProxyType({})
    arrows: Mapping[str, Collection[str]] = MappingProxyType({})
    arcs: Mapping[str, Collection[str]] = MappingProxyType({})


# By technique: of a study and a leaf to the record of that sheet.
RECORDS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "linkage": "drawings.grading.techniques.forces:record_of_linkage",
        "forces": "drawings.grading.techniques.forces:record_of_forces",
        "balance": "drawings.grading.techniques.rotor:record_of_balance",
        "bank": "drawings.grading.techniques.rotor:record_of_bank",
        "rotor": "drawings.grading.techniques.rotor:record_of_rotor",
    }
)


TABLES = ("points", "keeps", "costs", "tolerance")
TABLE = "table"  # by which the points of a cell are told from those of the vector that it tells of
OTHERS = "default"  # the key of the points that all other quantities have
# What a fault of a whole plan, and one of how it is drawn, costs where the table does not say.
PLAN_COST, DRAWING_COST = 1.0, 0.0
MOST = 1e6  # points of a quantity: nobody has more, and sums of such keep their third decimal
CELL = 0.25  # of what any other quantity has: a table tells once more what the drawing shows, in many cells


class MarkingError(DraftError, ValueError):
    """A table of marks that is wrong, with what to write instead."""

    exit_code = 3


@dataclass(frozen=True)
class Marking:
    """Points by quantity, the share that a kind of mistake keeps, and what faults of plans and of drawing cost.

    A quantity is named as it is ("v_B"), or by how its letters begin ("a^k"), or all others by "default"; a
    cell of a table so too, with "table" before ("table v_B", "table v", "table"), or with its table ("table values"):
    of which nothing is said, it has a quarter of the others.
    """

    points: Mapping[str, float] = field(default_factory=dict)
    keeps: Mapping[str, float] = field(default_factory=dict)
    costs: Mapping[str, float] = field(default_factory=dict)
    tolerance: Mapping[str, str] = field(default_factory=dict)

    def most(self, one: Verdict) -> float:
        """Give the points of a quantity; faults of a plan or of drawing have none."""
        if _aside(one):
            return 0.0
        other = self.points.get(OTHERS, 1.0) * (CELL if _is_cell(one) else 1.0)
        return next((self.points[key] for key in keys_of(one) if key in self.points), other)

    def won(self, one: Verdict) -> float:
        """Give the points that a verdict wins, or loses."""
        if _aside(one):
            return -self.costs.get(one.kind, PLAN_COST if one.kind in verdict.OF_PLANS else DRAWING_COST)
        return self.most(one) * (1.0 if one.good else self.keeps.get(one.kind, 0.0))


def _aside(one: Verdict) -> bool:
    """Tell whether a verdict is of no quantity: of a plan, of how it is drawn, or not graded."""
    return one.kind in (*verdict.OF_DRAWING, *verdict.UNGRADED) or not one.name


def _is_cell(one: Verdict) -> bool:
    return one.plan.startswith(TABLE)


def keys_of(one: Verdict) -> Iterator[str]:
    """Give by what the points of a quantity may be told, the nearest first."""
    if _is_cell(one):
        name = one.name.partition(" (")[0]
        yield from (f"{TABLE} {key}" for key in (name, name.partition("_")[0]))
        yield from (one.plan, TABLE)
    else:
        yield from (one.name, one.name.partition("_")[0])


def read_marking(path: Path) -> Marking:
    """Read a table of marks."""
    source = regular_bytes(path, TEXT_LENGTH + 1)
    if len(source) > TEXT_LENGTH:
        raise MarkingError(message("grade.marks.long", file=path, limit=TEXT_LENGTH))
    try:
        tables = tomllib.loads(source.decode("utf-8"))
    except (ValueError, RecursionError) as error:  # also the plain ValueError of an integer with thousands of digits
        raise MarkingError(message("grade.marks.toml", file=path, error=str(error))) from None
    for name, table in tables.items():
        if name not in TABLES or not isinstance(table, dict):
            raise MarkingError(message("grade.marks.table", file=path, name=name, names=TABLES))
    known = {"keeps": verdict.OF_QUANTITIES, "costs": (*verdict.OF_PLANS, *verdict.OF_DRAWING)}
    for table, kinds in known.items():
        for name in tables.get(table, {}):
            if name not in kinds:
                raise MarkingError(message("grade.marks.kind", file=path, name=f"{table}.{name}", names=kinds))
    most = {"points": MOST, "keeps": 1.0, "costs": MOST}
    numbers = {name: _numbers(path, name, tables.get(name, {}), most[name]) for name in most}
    return Marking(**numbers, tolerance=_texts(path, tables.get("tolerance", {})))


def _numbers(path: Path, table: str, own: Mapping[str, Any], most: float) -> dict[str, float]:
    for name, value in own.items():
        if not isinstance(value, int | float) or isinstance(value, bool) or not 0 <= value <= most:
            raise MarkingError(message("grade.marks.number", file=path, name=f"{table}.{name}", most=f"{most:.0f}"))
    return {name: float(value) for name, value in own.items()}


def _texts(path: Path, own: Mapping[str, Any]) -> dict[str, str]:
    for name, value in own.items():
        if not isinstance(value, str):
            raise MarkingError(message("grade.marks.tolerance", file=path, name=f"tolerance.{name}"))
    return dict(own)


def points_of(verdicts: tuple[Verdict, ...], marking: Marking) -> tuple[float, float]:
    """Give the points that are won, none below zero, and those that there are, to the third decimal."""
    exact = sum((Fraction(str(round(marking.won(one), 6))) for one in verdicts), Fraction())
    most = sum((Fraction(str(round(marking.most(one), 6))) for one in verdicts), Fraction())
    return round(float(max(exact, Fraction())), 3), round(float(most), 3)
