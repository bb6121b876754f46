"""Verdicts and marks: what is said of a vector, a plan, its drawing, and what that costs (оценка, шкала баллов)."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Final, NamedTuple

from drawings.grading.allowance import allowance
from drawings.paper.limits import TEXT_LENGTH
from geometry.errors import DraftError, regular_bytes
from plans.scene.guard import Places, line_column
from plans.words.words import message

RIGHT, FOLLOWS = GOOD = "right", "follows"
# By which a quantity is wrong that may keep a share of its points; of all of it, of its size, of its direction alone.
MISSING, REVERSED, WRONG, LONG, TURNED = _OF_ANY = "missing", "reversed", "wrong", "long", "turned"
SIMILAR, BRANCH, ASIDE, LEVEL = _OF_PLACES = "similar", "branch", "aside", "level"
NORMAL, CORIOLIS = _OF_PARTS = "normal", "coriolis"  # reversed parts, which have names of their own
INERTIA, UPWARD, REACTION = _OF_FORCES = "inertia", "upward", "reaction"  # reversed forces, which have too
MOMENT, COUPLE, FORGOTTEN, SLANT = _OF_MOMENTS = "moment", "couple", "forgotten", "slant"  # in an equation, of an arm
# Of a counterweight, of what is multiplied, of an arm's sign, of a harmonic.
HEAVY, PRODUCT, BEYOND, ORDER = _OF_MASSES = "heavy", "product", "beyond", "order"
SIGN, DECADE, DEGREES, TURNS, TWICE = _OF_NUMBERS = "sign", "decade", "degrees", "turns", "twice"
ROW, PLACE = _OF_CELLS = "row", "place"
OF_QUANTITIES = (
    *_OF_ANY, *_OF_PLACES, *_OF_PARTS, *_OF_FORCES, *_OF_MOMENTS, *_OF_MASSES, *_OF_NUMBERS, *_OF_CELLS,
)  # fmt: skip
# By which a plan or a curve is wrong as a whole.
SCALE, MIRRORED, OPPOSITE, ASKEW, INVERTED, FACTOR = _OF_ALL = (
    "scale", "mirrored", "opposite", "askew", "inverted", "factor",
)  # fmt: skip
SHIFTED, IDLE, UNLOADED, UNDRIVEN = _OF_TURNS = "shifted", "idle", "unloaded", "undriven"
AXES, EXCHANGED, STRAIGHT, FLYWHEEL = _OF_RUNS = "axes", "exchanged", "straight", "flywheel"
PHASES, SIDE, BACKWARDS, BASE = _OF_CAMS = "phases", "side", "backwards", "base"
OF_PLANS = (*_OF_ALL, LEVEL, *_OF_TURNS, *_OF_RUNS, *_OF_CAMS)
# By which it is drawn badly.
UNSCALED, OPEN, UNCLOSED, OUTSIDE = _OF_LINES = "unscaled", "open", "unclosed", "outside"
UNLETTERED, SWAPPED, APART, HEADLESS = _OF_LETTERS = "unlettered", "swapped", "apart", "headless"
OF_DRAWING = (*_OF_LINES, *_OF_LETTERS)
# What somebody has to look at himself: not read, taken apart by an editor, standing there twice otherwise, unlettered.
UNREAD, UNGROUPED, ILLEGIBLE = _UNREAD = "unread", "ungrouped", "illegible"
UNTABLED, DOUBLED, UNNAMED = _UNSURE = "untabled", "doubled", "unnamed"
UNSEEN = (*_UNREAD, *_UNSURE)
DEAD, SMALL = "dead", "small"  # too near a dead centre, too short to be found by its letter: not graded
WORKINGS, ZERO = "workings", "zero"  # told, and nothing hangs on them: numbers beside the tables, a zero that is free
UNGRADED = (DEAD, SMALL, WORKINGS, ZERO, *UNSEEN)


class Verdict(NamedTuple):
    """What is said of a vector, or of a plan (without a name): its kind, by how much it is out of what is allowed.

    `off` and `allowed` are in the plan's unit; `at` is the place on paper, mm, y up; `step` names the mark of the
    record to look at again.
    """

    plan: str
    position: int | None
    name: str
    kind: str
    off: float | None = None
    allowed: float | None = None
    unit: str = ""
    at: tuple[complex, complex] | None = None
    letters: tuple[str, str] = ("", "")
    of: str = ""  # in which quantity the mistake is, if not in this one
    frames: tuple[tuple[complex, ...], ...] = ()  # corners on paper, mm: of a cell, or about all of a table's

    @property
    def good(self) -> bool:
        """Whether nothing is lost by it."""
        return self.kind in GOOD

    @property
    def aside(self) -> bool:
        """Whether it is of no quantity: of a plan, of how it is drawn, or not graded."""
        return self.kind in (*OF_DRAWING, *UNGRADED) or not self.name


TABLE = "table"  # by which the points of a cell are told from those of the vector that it tells of
OTHERS = "default"  # the key of the points that all other quantities have
# What a fault of a whole plan, and one of how it is drawn, costs where the table does not say.
PLAN_COST, DRAWING_COST = 1.0, 0.0
MOST = 1e6  # points of a quantity: nobody has more, and sums of such keep their third decimal
CELL = 0.25  # of what any other quantity has: a table tells once more what the drawing shows, in many cells
# The tables of marks: how large their numbers may be, if they have any, and which kinds of mistakes are their keys.
TABLES: Final[Mapping[str, tuple[float, tuple[str, ...]]]] = {
    "points": (MOST, ()),
    "keeps": (1.0, OF_QUANTITIES),
    "costs": (MOST, (*OF_PLANS, *OF_DRAWING)),
    "tolerance": (0.0, ()),
    "caps": (MOST, ()),
}


class MarkingError(DraftError, ValueError):
    """A table of marks that is wrong, with what to write instead."""

    exit_code = 3


@dataclass(frozen=True)
class Marking:
    """Points by quantity, the share that a kind of mistake keeps, and what faults of plans and of drawing cost.

    A quantity is named as it is ("v_B"), or by how its letters begin ("a^k"), or all others by "default"; a
    cell of a table so too, with "table" before ("table v_B", "table v", "table"), or with its table ("table values"):
    of which nothing is said, it has a quarter of the others. A figure or table loses no more than its cap.
    """

    points: Mapping[str, float] = field(default_factory=dict)
    keeps: Mapping[str, float] = field(default_factory=dict)
    costs: Mapping[str, float] = field(default_factory=dict)
    tolerance: Mapping[str, str] = field(default_factory=dict)
    caps: Mapping[str, float] = field(default_factory=dict)

    def most(self, said: Verdict) -> float:
        """Give the points of a quantity; faults of a plan or of drawing have none."""
        if said.aside:
            return 0.0
        other = self.points.get(OTHERS, 1.0) * (CELL if said.plan.startswith(TABLE) else 1.0)
        return next((self.points[key] for key in keys_of(said) if key in self.points), other)

    def won(self, said: Verdict) -> float:
        """Give the points that a verdict wins, or loses."""
        if said.aside:
            return -self.costs.get(said.kind, PLAN_COST if said.kind in OF_PLANS else DRAWING_COST)
        return self.most(said) * (1.0 if said.good else self.keeps.get(said.kind, 0.0))

    def cap(self, plan: str) -> float:
        """Give what a figure or a table may lose at the most: by its name, by how that begins, or as all others."""
        keys = (plan, plan.partition("-")[0], plan.partition(" ")[0], OTHERS)
        return next((self.caps[key] for key in keys if key in self.caps), MOST)


def keys_of(said: Verdict) -> Iterator[str]:
    """Give by what the points of a quantity may be told, the nearest first."""
    if said.plan.startswith(TABLE):
        name = said.name.partition(" (")[0]
        yield from (f"{TABLE} {key}" for key in (name, name.partition("_")[0]))
        yield from (said.plan, TABLE)
    else:
        yield from (said.name, said.name.partition("_")[0])


def read_marking(path: Path) -> Marking:
    """Read a table of marks."""
    source = regular_bytes(path, TEXT_LENGTH + 1)
    if len(source) > TEXT_LENGTH:
        raise MarkingError(message("grade.marks.long", file=path, limit=TEXT_LENGTH))
    try:
        tables = tomllib.loads(text := source.decode("utf-8"))
    except (ValueError, RecursionError) as error:  # also the plain ValueError of an integer with thousands of digits
        raise MarkingError(message("grade.marks.toml", file=path, error=str(error))) from None
    for name, table in tables.items():
        if name not in TABLES or not isinstance(table, dict):
            raise MarkingError(message("grade.marks.table", file=_at(path, text, name), name=name, names=tuple(TABLES)))
        for key, value in table.items():
            _held(_at(path, text, name, key), name, key, value)
    return Marking(**{name: tables.get(name, {}) for name in TABLES})


def _at(path: Path, text: str, *keys: str) -> str:
    return f"{path}:{line_column(text, Places(text).offset(keys))[0]}"


def _held(file: str, table: str, key: str, value: object) -> None:
    """Hold a row of a table of marks to what it may say."""
    name, (most, kinds) = f"{table}.{key}", TABLES[table]
    if kinds and key not in kinds:
        raise MarkingError(message("grade.marks.kind", file=file, name=name, names=kinds))
    if not most and (not isinstance(value, str) or allowance(value) is None):
        raise MarkingError(message("grade.marks.tolerance", file=file, name=name))
    if most and (not isinstance(value, int | float) or isinstance(value, bool) or not 0 <= value <= most):
        raise MarkingError(message("grade.marks.number", file=file, name=name, most=f"{most:.0f}"))


def points_of(verdicts: Sequence[Verdict], marking: Marking) -> tuple[float, float]:
    """Give the points that are won, none below zero, and those that there are, to the third decimal."""
    figures: dict[tuple[str, int | None], list[Verdict]] = {}
    for said in verdicts:
        position = None if said.plan.startswith(TABLE) else said.position
        figures.setdefault((said.plan, position), []).append(said)
    won, most = Fraction(), Fraction()
    for (plan, _), every in figures.items():
        roads = ([points(said) for said in every] for points in (marking.most, marking.won))
        there, got = (sum((Fraction(str(round(one, 6))) for one in road), Fraction()) for road in roads)
        most += there
        won += there - min(there - got, Fraction(str(marking.cap(plan))))
    return round(float(max(won, Fraction())), 3), round(float(most), 3)
