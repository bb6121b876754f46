"""What a task asks for: vectors and points, their true values, constructions, allowances (задание)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from types import MappingProxyType
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from drawings.checks.expected import Expected
from drawings.checks.hold import MARKS
from drawings.grading.marking import RECORDS, Found, Place, Record
from drawings.paper.limits import QUANTUM
from drawings.paper.statement import Key, Kind
from drawings.paper.walk import groups
from drawings.reading.marks import MeasuredPoint, MeasuredVector
from drawings.redrawn.originals import Original, Originals
from geometry.board import Board, Mark
from geometry.hand_error import EVEN, SlippingHand, Slopes, slopes
from geometry.steps import Span
from plans.by_hand import SLIP
from plans.techniques import named, technique_of

Due: TypeAlias = Mapping[Key, Expected]
# By what the scale of a plan is lettered, where not by the quantity of its marks.
SYMBOLS: Final = MappingProxyType({"r": "l", "h": "l"})


class Asked(NamedTuple):
    """One vector or point that is asked for: letters of its ends, its name, its true value, how the record finds it.

    A free vector is lettered itself, wherever it lies: `letter` is what its sheet writes beside it.
    """

    name: str  # "v_BA"; of what has no letters of its own, those of its ends
    start: str  # "" : measured from the pole, as a point is, or free
    end: str
    true: complex
    found: Found | None
    letter: str = ""
    title: str = ""  # of a point, as its sheet writes it

    @property
    def letters(self) -> tuple[str, str]:
        """The letters of its ends."""
        return self.start, self.end

    @property
    def corners(self) -> tuple[str, str] | None:
        """The corners of a polygon that a free vector is laid between, if it is a side of one."""
        side = self.found.side if self.found is not None else None
        return None if side is None else (side.start.name, side.end.name)

    @property
    def diagonal(self) -> bool:
        """Whether it is read off across a polygon, and no side of it."""
        return self.found is not None and self.found.diagonal


class PlanAsked(NamedTuple):
    """A plan that is asked for: which, on what sheet, its unit, its vectors, the scales of the plans that it rests on.

    The scales are true units a mm, by the subjects of the plans, its own among them; `board` is the subject of its own
    record, and `symbol` letters its scale.
    """

    plan: str
    position: int | None
    sheet: str
    unit: str
    vectors: tuple[Asked, ...]
    scales: Mapping[str, float]
    board: str = ""
    symbol: str = ""
    senses: Mapping[str, complex] = {}  # of arrows that are not to scale; a process hands it on, as it does no proxy
    turns: Mapping[str, int] = {}  # of arcs of moments: +1 counter-clockwise

    @property
    def place(self) -> Place:
        """Which plan it is."""
        return self.plan, self.position

    @property
    def letters(self) -> frozenset[str]:
        """The letters that stand at the ends of its vectors."""
        return frozenset(letter for one in self.vectors if not one.letter for letter in one.letters if letter)

    @property
    def lettered(self) -> bool:
        """Whether it can be found by its letters: a plan of points, or of arms on a scheme, by data alone."""
        free = all(one.letter for one in self.vectors) and any(one.corners for one in self.vectors)
        return free or any(one.start for one in self.vectors)


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
    marks, titles = dict[Place, list[MeasuredVector | MeasuredPoint]](), _titles(sheet)
    for mark in originals.seen(sheet).measured.marks:
        marks.setdefault((mark.plan, mark.position), []).append(mark)
    record, due = named(row)(originals.study, sheet.leaf), originals.due(sheet)
    for place, own in marks.items():
        plan, position = place
        if position in record.plans.get(plan, ()):
            vectors = tuple(_asked(one, record, due, titles) for one in own)
            subject, symbol = record.subjects.get(plan, plan), SYMBOLS.get(own[0].quantity, own[0].quantity)
            scales = {name: own[position] for name, own in record.plans.items() if position in own}
            senses, turns = (_ways(names.get(plan, ()), place, due) for names in (record.arrows, record.arcs))
            arcs = {name: int(way.real) for name, way in turns.items()}
            scales |= {plan: own[0].scale}
            yield PlanAsked(*place, sheet.name, own[0].unit, vectors, scales, subject, symbol, senses, arcs)


def _asked(mark: MeasuredVector | MeasuredPoint, record: Record, due: Due, titles: Mapping[Key, str]) -> Asked:
    """Ask for what a mark of our own sheet shows: its true value is due, its construction is the record's."""
    place, (start, end) = (mark.plan, mark.position), ends_of(mark)
    kind = Kind.VECTOR if isinstance(mark, MeasuredVector) else Kind.POINT
    key = kind, mark.plan, mark.name, mark.position
    found, board = record.found.get((*place, start, end)), record.boards.get(place, ())
    if found is None and isinstance(board, Board) and start in board and end in board:
        found = Found(mark.name, Span(board[start], board[end]))
    name, title = mark.name if found is None else found.name, titles.get(key, mark.name)
    return Asked(name, start, end, due[key].vector, found, title if is_free(mark) else "", title)


def _ways(names: Collection[str], place: Place, due: Due) -> dict[str, complex]:
    """Give the ways that arrows have, or 1 and -1 by how arcs turn, of those that rounding does not decide."""
    rows = {name: due.get((Kind.DIRECTION, place[0], name, place[1])) for name in names}
    return {name: row.vector for name, row in rows.items() if row is not None and math.isfinite(row.allowed)}


def _titles(sheet: Original) -> dict[Key, str]:
    """Give what is written beside the vectors and points of a sheet."""
    return {
        (MARKS[one.data["kind"]], one.data["plan"], one.data["name"], position): one.title
        for one in groups(sheet.leaf.groups)
        if one.data.get("kind") in MARKS and one.title
        for position in (int(one.data["position"]) if "position" in one.data else None,)
    }


def is_free(mark: MeasuredVector | MeasuredPoint) -> bool:
    """Tell whether a mark is a vector that is lettered itself, and not at its ends."""
    return isinstance(mark, MeasuredVector) and " " not in mark.name


def ends_of(mark: MeasuredVector | MeasuredPoint) -> tuple[str, str]:
    """Give the letters of the ends of a vector; of a point and of a free vector its own, from nowhere."""
    if not isinstance(mark, MeasuredVector):
        return "", mark.name
    start, _, end = mark.name.rpartition(" ")
    return start, end


# Of ten thousand vectors that a fair hand draws one may be refused: a sheet has some forty.
REFUSED = 1e-4
DEVIATIONS = math.sqrt(-2 * math.log(REFUSED))  # of a vector whose ends are spread evenly about the true one


class Allowance(NamedTuple):
    """What a hand may slip by, mm, and the share of the largest vector of a plan that is allowed instead, if any."""

    slip: float = SLIP
    share: float | None = None


EXACT = Allowance(QUANTUM)


class Allowances(NamedTuple):
    """What is allowed to all quantities, and to some by their names or by how their letters begin."""

    by: Allowance = Allowance()
    own: Mapping[str, Allowance] = MappingProxyType({})

    def of(self, plan: PlanAsked, drawn: Mapping[str, float], coarse: float) -> dict[tuple[str, str], float]:
        """Give what each vector of a plan may be out, true units, by its letters."""
        kinds = {by: allowed(plan, drawn, by, coarse) for by in {self.by, *self.own.values()}}
        return {one.letters: kinds[self.to(one.name)][one.letters] for one in plan.vectors}

    def to(self, name: str) -> Allowance:
        """Give what is allowed to a quantity."""
        return self.own.get(name, self.own.get(name.partition("_")[0], self.by))


def allowed(
    plan: PlanAsked, drawn: Mapping[str, float], by: Allowance, coarse: float = QUANTUM
) -> dict[tuple[str, str], float]:
    """Give what each vector of a plan may be out, true units, by its letters; NaN: slips tell nothing of it.

    `drawn` are the scales of the student's plans, true units a mm, by their subjects; `coarse` is how finely his sheet
    is written, mm.
    """
    scales = {**plan.scales, **drawn}
    if by.share is not None:
        most = max((abs(one.true) for one in plan.vectors), default=0.0)
        return {one.letters: by.share * most for one in plan.vectors}
    slip = max(by.slip, coarse)
    hand = SlippingHand(slip, {name: np.array([mu]) for name, mu in scales.items()})
    found = slopes(hand, *(mark for one in plan.vectors if one.found for mark in one.found.span))
    own = EVEN * slip * scales[plan.plan] * np.array([1, 1j, 1, 1j])[:, None]  # of both ends of the arrow itself
    return {one.letters: DEVIATIONS * _deviation(np.concatenate([_moved(one, found), own])) for one in plan.vectors}


def _moved(one: Asked, found: Mapping[Mark, Slopes]) -> Slopes:
    if one.found is None:
        return np.zeros((0, 1), dtype=np.complex128)
    start, end = one.found.span
    return np.asarray(found[end] - found[start])


def _deviation(moved: Slopes) -> float:
    """Give the standard deviation along the line on which slips spread an end most."""
    total, lean = (np.abs(moved) ** 2).sum(), abs((moved**2).sum())
    return float(np.sqrt((total + lean) / 2))
