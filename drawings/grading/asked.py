"""What a task asks for of a plan: its vectors and points, their true values and constructions (задание)."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Final, NamedTuple, TypeAlias

from drawings.checks.expected import Expected
from drawings.checks.hold import MARKS
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Key, Kind
from drawings.paper.walk import groups
from drawings.reading.marks import MeasuredPoint, MeasuredVector
from drawings.redrawn import Original, Originals
from drawings.sheets.kind import PLAN, figure_of
from geometry.board import Board, Mark, Span, behind
from plans.study import Study
from plans.techniques import named, technique_of
from plans.words.words import Message, message

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
    are drawn that have names of their own, to which what is read off the plans of `boards` is known, as inertia forces
    are; `known` the known forces and moments that a plan shows by arrows that are not to scale.
    """

    found: Mapping[Letters, Found]
    plans: Mapping[str, Mapping[int | None, float]]
    boards: Mapping[Place, Board] = MappingProxyType({})
    subjects: Mapping[str, str] = MappingProxyType({})
    known: Mapping[str, Collection[str]] = MappingProxyType({})


def lettered(plan: str, position: int | None, vectors: Iterable[Found]) -> dict[Letters, Found]:
    """Give vectors that are lettered themselves by the letters of a plan."""
    return {(plan, position, "", vector.name): vector for vector in vectors}


# By technique: of a study and a leaf to the record of that sheet, where more is known of it than its quantities say.
RECORDS: Final[Mapping[str, str]] = {
    "linkage": "drawings.grading.techniques.forces:record_of_linkage",
    "forces": "drawings.grading.techniques.forces:record_of_forces",
    "centres": "drawings.grading.techniques.forces:record_of_centres",
    "transfer": "drawings.grading.techniques.forces:record_of_transfer",
    "balance": "drawings.grading.techniques.rotor:record_of_balance",
    "bank": "drawings.grading.techniques.rotor:record_of_bank",
    "rotor": "drawings.grading.techniques.rotor:record_of_rotor",
    "gears": "drawings.grading.techniques.gears:record_of_gears",
}
# By technique: of a study and our own sheet to the figures of that sheet, in the order in which they are drawn.
CURVES: Final[Mapping[str, str]] = {
    "dynamics": "drawings.grading.curves.dynamics_figures:figures_of_dynamics",
    "balance": "drawings.grading.curves.diagram_figures:figures_of_loads",
    "forces": "drawings.grading.curves.diagram_figures:figures_of_loads",
    "linkage": "drawings.grading.curves.diagram_figures:figures_of_diagrams",
    "cyclogram": "drawings.grading.curves.diagram_figures:figures_of_cyclogram",
    "cam": "drawings.grading.curves.cam_figures:figures_of_cam",
}
# By what the scale of a plan is lettered, where not by the quantity of its marks.
SYMBOLS: Final = MappingProxyType({"r": "l", "h": "l"})


class VectorAsked(NamedTuple):
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
    def auxiliary(self) -> bool:
        """Whether it has no name but those of its ends: nobody need draw it apart."""
        return self.name == " ".join(self.letters)

    def twins(self, plan: PlanAsked, mu: float) -> list[VectorAsked]:
        """Give the other vectors of its plan that lie on it, to a scale of true units a mm."""
        return [
            other for other in plan.vectors
            if other is not self and other.start == self.start and abs(other.true - self.true) <= SEEN * mu
        ]  # fmt: skip

    @property
    def diagonal(self) -> bool:
        """Whether it is read off across a polygon, and no side of it."""
        return self.found is not None and self.found.diagonal


class PlanAsked(NamedTuple):
    """A plan that is asked for: which, on what sheet, its unit, its vectors, the scales of the plans that it rests on.

    The scales are true units a mm, by the subjects of the plans, its own among them; `board` is the subject of its own
    record, and `symbol` letters its scale. `ways` are those of known forces that are shown by arrows not to scale, of
    moments that are shown by arcs 1.0 counter-clockwise or -1.0.
    """

    plan: str
    position: int | None
    sheet: str
    unit: str
    vectors: tuple[VectorAsked, ...]
    scales: Mapping[str, float]
    board: str = ""
    symbol: str = ""
    ways: Mapping[str, complex] = {}  # a process hands it on, as it does no proxy

    @property
    def place(self) -> Place:
        """Which plan it is."""
        return self.plan, self.position

    @property
    def dotted(self) -> bool:
        """Whether it is of points alone, as the plan of positions is."""
        return not any(vector.start or vector.letter for vector in self.vectors)

    @property
    def lettered(self) -> bool:
        """Whether it can be found by its letters: a plan of points, or of arms on a scheme, by data alone."""
        free = all(vector.letter for vector in self.vectors) and any(vector.corners for vector in self.vectors)
        return free or any(vector.start for vector in self.vectors)


def plans_asked(originals: Originals) -> tuple[PlanAsked, ...]:
    """Give the plans that the sheets of a scene ask for."""
    return tuple(plan for sheet in originals.sheets for plan in _of_sheet(originals, sheet))


def _of_sheet(originals: Originals, sheet: Original) -> Iterator[PlanAsked]:
    technique = technique_of(sheet.kind)
    row = RECORDS.get(technique)
    if row is None and technique in CURVES:
        return
    figures, titles = dict[Place, list[MeasuredVector | MeasuredPoint]](), _titles(sheet)
    for mark in originals.read_back(sheet).measured.marks:
        figures.setdefault((mark.plan, mark.position), []).append(mark)
    record = _record(originals.study, sheet.kind, figures) if row is None else named(row)(originals.study, sheet.leaf)
    expected = originals.expected(sheet)
    for (plan, position), marks in figures.items():
        if position in record.plans.get(plan, ()):
            every = (_asked(mark, record, expected, titles) for mark in marks)
            vectors = tuple(vector for vector in every if cmath.isfinite(vector.true))  # of a rate that is open none
            quantity, unit, scale = marks[0].quantity, marks[0].unit, marks[0].scale
            apart = {name for name, _ in record.boards} if plan in record.subjects else ()
            rests = ((name, mu) for name, mu in record.plans.items() if position in mu and name not in apart)
            scales = {name: mu[position] for name, mu in rests} | {plan: scale}
            board, symbol = record.subjects.get(plan, plan), SYMBOLS.get(quantity, quantity)
            ways = dict(_ways(record.known.get(plan, ()), (plan, position), expected))
            yield PlanAsked(plan, position, sheet.name, unit, vectors, scales, board, symbol, ways)


def _record(study: Study, kind: str, figures: Mapping[Place, Sequence[MeasuredVector | MeasuredPoint]]) -> Record:
    """Give the record of a sheet of which no more is known: its plans, and what was laid off for its quantities."""
    plans: dict[str, dict[int | None, float]] = {}
    for (plan, position), marks in figures.items():
        if figure_of(kind, plan) == PLAN:
            plans.setdefault(plan, {})[position] = marks[0].scale
    shown = behind(*(mark for finding in study.quantities(technique_of(kind)) for mark in finding.marks))
    return Record({(plan, None, "", found.name): found for plan, found in _spans(shown)}, plans)


def _spans(marks: Iterable[Mark]) -> Iterator[tuple[str, Found]]:
    """Give by plans, each of which begins with its pole, the vectors that lie between corners: laid off, or joining."""
    poles: dict[str, Mark] = {}
    for mark in marks:
        pole, sources = poles.setdefault(mark.subject, mark), mark.step.inputs
        if mark.step.op == "lay_off":
            yield mark.subject, Found(sources[1].name, Span(pole, sources[1]), Span(sources[0], mark))
        elif mark.step.op == "join":
            yield mark.subject, Found(mark.name, Span(pole, mark), Span(*sources))


def _asked(
    mark: MeasuredVector | MeasuredPoint, record: Record, expected: Mapping[Key, Expected], titles: Mapping[Key, str]
) -> VectorAsked:
    """Ask for what a mark of our own sheet shows: its true value is expected, its construction is the record's."""
    place, (start, end) = (mark.plan, mark.position), ends_of(mark)
    kind = Kind.VECTOR if isinstance(mark, MeasuredVector) else Kind.POINT
    key = kind, mark.plan, mark.name, mark.position
    found, board = record.found.get((*place, start, end)), record.boards.get(place, ())
    if found is None and isinstance(board, Board) and start in board and end in board:
        found = Found(mark.name, Span(board[start], board[end]))
    name, title = mark.name if found is None else found.name, titles.get(key, mark.name)
    return VectorAsked(name, start, end, expected[key].vector, found, title if is_free(mark) else "", title)


def _ways(names: Collection[str], place: Place, expected: Mapping[Key, Expected]) -> Iterator[tuple[str, complex]]:
    """Give the ways of arrows and the senses of arcs, of those that rounding does not decide."""
    for name in names:
        row = expected.get((Kind.DIRECTION, place[0], name, place[1]))
        if row is not None and isinstance(row.value, complex | float) and math.isfinite(row.allowed):
            yield name, row.value


def _titles(sheet: Original) -> dict[Key, str]:
    return {
        (MARKS[group.data["kind"]], group.data["plan"], group.data["name"], position): group.title
        for group in groups(sheet.leaf.groups)
        if group.data.get("kind") in MARKS and group.title
        for position in (int(group.data["position"]) if "position" in group.data else None,)
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


KINEMATIC = ("velocities", "accelerations", "positions")  # plans that the words for them are called by
# By what the data of a figure are called: the key of its name, and what of it is a part of that.
_NAMED: Final = tuple(
    (re.compile(pattern), key)
    for pattern, key in (
        (r"forces-(?P<of>\d+)", "forces_of_link"),
        (r"forces-(?P<of>.+)", "forces_of_group"),
        (r"scheme (?P<of>\d+)", "scheme_of_link"),
        (r"scheme (?P<of>.+)", "scheme_of_group"),
        (r"diagrams-(?P<of>\w+)", "diagram"),
        (r"load_diagram-(?P<of>.+)", "load"),
        (r"circle", "rings"),
        (r"law-(?P<cam>.+)-(?P<of>\w+)", "law"),
        (r"order_(?P<of>forces|moments)-(?P<order>\d+)", "order"),
        (r"order_(?P<of>forces|moments)-(?P<order>\d+)-back", "order_back"),
        (r"compensator-(?P<order>\d+)", "compensator"),
    )
)


def plan_named(plan: str) -> Message:
    """Name a plan as a draughtsman does; one that has no name of its own by the words for figures.

    >>> str(plan_named("forces-4-5")), str(plan_named("loop"))
    ('force plan of group 4-5', "Wittenbauer's loop")
    """
    if plan in KINEMATIC:
        return message(f"grade.named.{plan}")
    for pattern, key in _NAMED:
        if (found := pattern.fullmatch(plan)) is not None:
            return message(f"grade.named.{key}", **found.groupdict())
    return message("grade.named.other", of=plan)


def plan_told(plan: str, position: int | str | None) -> Message:
    """Name a plan, with its position if it has one."""
    return message("grade.plan" if position is not None else "grade.figure", plan=plan_named(plan), position=position)
