"""A tracing: the acts of a record, put in a row to be followed again from another given (калька).

The words of a record are the same whatever its givens are; only the numbers differ. A tracing takes a record that was
drawn once and follows its acts at other positions: each number that the acts need is worked out once, by the same
formulas, and the marks themselves are made when somebody looks at them.
"""

from collections.abc import Callable, Iterable, Mapping
from copy import copy
from functools import partial, reduce
from operator import getitem
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np

from geometry import meet as loci
from geometry.acts import Acts, Place
from geometry.board import Arc, Board, Line, Mark
from geometry.meet import Meeting, Vectors

_RAYS = Meeting._fields.index("first"), Meeting._fields.index("second")
_TIMES = Meeting._fields.index("into_first"), Meeting._fields.index("into_second")


class Trace(NamedTuple):
    """Where the numbers of a mark are: its value (of a line or an arc both), its rays, its meeting."""

    value: tuple[Place, ...]
    rays: tuple[Place, ...] = ()
    meeting: Place | None = None


class Tracing:
    """The acts behind some marks, in drafting order; `free` is the given mark that takes another value each time.

    A vector that was turned by a row of numbers is turned by another row each time: see `sizes`.

    >>> board = Board("positions")
    >>> a, e = board.given("A", 1j), board.given("φ", 1 + 0j)
    >>> tracing = Tracing([a, e, board.lay_off("B", a, e)], e)
    >>> numbers = tracing.follow(-1 + 0j)
    >>> complex(numbers[tracing.place(board["B"])])
    (-1+1j)
    """

    def __init__(self, marks: Iterable[Mark], free: Mark) -> None:
        self.acts = Acts()
        self._origin = self.acts.fix(0j)
        self._fields = [self.acts.fix(field) for field in range(len(Meeting._fields))]
        self._traces: dict[Mark, Trace] = {}
        self.sizes: dict[Mark, Place] = {}  # where the numbers are by which a vector is turned, if they change
        self._meetings: list[Place] = []
        self._trace(marks, {free: self.acts.free})

    def _trace(self, marks: Iterable[Mark], given: Mapping[Mark, Place]) -> None:
        for mark in marks:
            trace = Trace((given[mark],)) if mark in given else _RULES[mark.step.op](self, mark)
            self._traces[mark] = trace
            if trace.meeting is not None:
                self._meetings.append(trace.meeting)

    def over(self, marks: Iterable[Mark], free: Iterable[Mark]) -> "Tracing":
        """Trace what was drawn over this record afterwards; `free` are its given marks that change each time."""
        other = copy(self)
        other.acts, other._traces, other._meetings = self.acts.over(), self._traces.copy(), []
        given = {mark: other.acts.vary() for mark in free}
        other._trace((mark for mark in marks if mark not in self._traces), given)
        return other

    def follow(self, free: Vectors, sizes: Mapping[Mark, Vectors] | None = None) -> list[Any]:
        """Give the numbers of all acts with another value of the free mark, and other sizes of the marks that vary."""
        return self.acts.follow(free, {self.sizes[mark]: size for mark, size in (sizes or {}).items()})

    def follow_on(self, numbers: list[Any], given: Mapping[Mark, Any]) -> list[Any]:
        """Give the numbers of all acts over those of the record below, with other values of the free marks."""
        return self.acts.follow_on(numbers, {self.place(mark): value for mark, value in given.items()})

    def clear(self, numbers: list[Any]) -> bool:
        """Whether no meeting has at any position a miss, a dead centre or anything unknown."""
        return all(numbers[place].clear for place in self._meetings)

    def meetings(self, numbers: list[Any]) -> list[Meeting]:
        """List how the loci of the record met; of one that was traced over another, its own meetings."""
        return [numbers[place] for place in self._meetings]

    def place(self, mark: Mark) -> Place:
        """Tell where the value of a point or a vector is."""
        (value,) = self._traces[mark].value
        return value

    def meeting(self, mark: Mark) -> Place:
        """Tell where it is how the loci of a mark met."""
        met = self._traces[mark].meeting
        assert met is not None  # asked of such marks alone
        return met

    def follows(self, vector: Mark, span: complex) -> bool:
        """Whether a vector that is `span` beside a free one of 1 has the very direction of the free one."""
        by = self.acts.known_ratio(self.place(vector), self.acts.free)
        turn = None if by is None else self.acts.fixed(by)
        return turn is not None and (turn / span).imag == 0 < (turn / span).real

    def boards(self, numbers: list[Any]) -> tuple[dict[str, Board], dict[Mark, Mark]]:
        """Make the marks with these numbers, on boards of their own; each old mark is answered by its new one."""
        boards: dict[str, Board] = {}
        made: dict[Mark, Mark] = {}
        for mark in self._traces:
            board = boards.setdefault(mark.subject, Board(mark.subject))
            made[mark] = board.keep(self._mark(mark, numbers, made))
        return boards, made

    def _mark(self, mark: Mark, numbers: list[Any], made: Mapping[Mark, Mark]) -> Mark:
        trace = self._traces[mark]
        value = [numbers[place] for place in trace.value]
        rays = zip((made[origin] for origin, _ in mark.rays), (numbers[place] for place in trace.rays), strict=True)
        return mark._replace(
            value=type(mark.value)(*value) if isinstance(mark.value, Line | Arc) else value[0],
            step=mark.step._replace(
                inputs=tuple(made[source] for source in mark.step.inputs),
                size=numbers[self.sizes[mark]] if mark in self.sizes else mark.step.size,
            ),
            rays=tuple(rays),
            meeting=None if trace.meeting is None else numbers[trace.meeting],
        )

    # What the rules of the verbs put down

    def ray(self, met: Place, end: int, along: Place | None = None) -> Place:
        """Give the vector to a meeting from the first or the second locus; `along` is the direction of a line's."""
        found = self._field(met, _RAYS[end])
        return found if along is None else self.acts.turned(found, along, self._field(met, _TIMES[end]))

    def _field(self, met: Place, field: int) -> Place:
        return self.acts.do(getitem, met, self._fields[field])

    def end(self, start: Mark, vector: Place) -> Place:
        """Lay a vector off from a point; from the origin it is the vector itself."""
        place = self.place(start)
        return vector if self.acts.is_origin(place) else self.acts.do(np.add, place, vector)

    def between(self, start: Mark, end: Mark) -> Place:
        """Give the vector from one point to another as the board does."""
        rays = zip(end.rays, self._traces[end].rays, strict=True)
        back = zip(start.rays, self._traces[start].rays, strict=True)
        for (origin, _), ray in rays:
            if origin is start:
                return ray
        for (origin, _), ray in back:
            if origin is end:
                return self.acts.do(np.subtract, self._origin, ray)
        if self.acts.is_origin(self.place(start)):
            return self.place(end)
        return self.acts.do(np.subtract, self.place(end), self.place(start))

    def size(self, mark: Mark) -> Place:
        """Tell where the number is by which a vector is turned."""
        if not np.ndim(mark.step.size):
            return self.acts.fix(mark.step.size)
        return self.sizes.setdefault(mark, self.acts.vary())

    def locus(self, mark: Mark) -> tuple[Place, Place]:
        """Tell where the point of a line or an arc is, and its direction or radius."""
        point, measure = self._traces[mark].value
        return point, measure


def _given(tracing: Tracing, mark: Mark) -> Trace:
    parts = mark.value if isinstance(mark.value, Line | Arc) else (mark.value,)
    return Trace(tuple(tracing.acts.fix(part) for part in parts))


def _laid_off(tracing: Tracing, mark: Mark) -> Trace:
    start, vector = mark.step.inputs
    by = tracing.place(vector)
    return Trace((tracing.end(start, by),), (by,))


def _joined(tracing: Tracing, mark: Mark) -> Trace:
    return Trace((tracing.between(*mark.step.inputs),))


def _parallel(tracing: Tracing, mark: Mark) -> Trace:
    through, to = map(tracing.place, mark.step.inputs)
    return Trace((through, to))


def _square(tracing: Tracing, mark: Mark) -> Trace:
    through, to = map(tracing.place, mark.step.inputs)
    return Trace((through, tracing.acts.square(to)))


def _arc(tracing: Tracing, mark: Mark) -> Trace:
    (centre,) = mark.step.inputs
    return Trace((tracing.place(centre), tracing.acts.fix(mark.step.size)))


def _met(tracing: Tracing, mark: Mark) -> Trace:
    first, second = mark.step.inputs
    origin, other = first.step.inputs[0], second.step.inputs[0]
    base, side = tracing.between(origin, other), mark.step.side
    (_, measure), (_, beside) = tracing.locus(first), tracing.locus(second)
    along: tuple[Place | None, Place | None] = None, None
    match first.value, second.value:
        case Arc(), Arc():
            met = tracing.acts.do(partial(loci.two_arcs, side=side), base, tracing.acts.do(loci.radii, measure, beside))
        case Line(), Arc(radius=radius):
            met = tracing.acts.do(partial(loci.line_arc, radius=radius, side=side), base, measure)
        case _:
            met = tracing.acts.do(loci.two_lines, base, tracing.acts.do(loci.crossing, measure, beside))
            along = measure, beside
    rays = tracing.ray(met, 0, along[0]), tracing.ray(met, 1, along[1])
    return Trace((tracing.end(origin, rays[0]),), rays, met)


def _tangent(tracing: Tracing, mark: Mark) -> Trace:
    base, offset = tracing.between(*mark.step.inputs), tracing.acts.fix(mark.step.size)
    met = tracing.acts.do(partial(loci.tangent_direction, side=mark.step.side), base, offset)
    return Trace((tracing.ray(met, 0),), (), met)


def _settled(tracing: Tracing, mark: Mark) -> Trace:
    *begins, free = map(tracing.place, mark.step.inputs)
    known = reduce(partial(tracing.acts.do, _added), begins, tracing.acts.fix(()))
    met = tracing.acts.do(mark.step.settling.met, known, free) if mark.step.settling else known
    ray = tracing.ray(met, 0)
    return Trace((tracing.end(mark.step.inputs[0], ray),), (ray,), met)


def _added(row: tuple[Any, ...], number: Any) -> tuple[Any, ...]:
    return (*row, number)


def _directed(tracing: Tracing, mark: Mark) -> Trace:
    met = tracing.meeting(mark.step.inputs[0])
    return Trace((tracing.ray(met, 1),))


def _turned(tracing: Tracing, mark: Mark) -> Trace:
    (vector,) = mark.step.inputs
    return Trace((tracing.acts.turn(tracing.place(vector), tracing.size(mark)),))


def _transferred(tracing: Tracing, mark: Mark) -> Trace:
    (source,) = mark.step.inputs
    return Trace((tracing.place(source),))


def _similar(tracing: Tracing, mark: Mark) -> Trace:
    image, of, shape = map(tracing.place, mark.step.inputs)
    found = tracing.acts.do(np.multiply, shape, tracing.acts.ratio(image, of))
    return Trace(
        (found if mark.step.size == 1 else tracing.acts.do(np.multiply, found, tracing.acts.fix(mark.step.size)),)
    )


def _divided(tracing: Tracing, mark: Mark) -> Trace:
    circle, directions = mark.step.inputs
    ray = tracing.acts.turn(tracing.place(directions), tracing.locus(circle)[1])
    return Trace((tracing.end(circle.step.inputs[0], ray),), (ray,))


def _closed(tracing: Tracing, mark: Mark) -> Trace:
    return Trace(
        (tracing.acts.do(np.negative, reduce(partial(tracing.acts.do, np.add), map(tracing.place, mark.step.inputs))),)
    )


def _moment(tracing: Tracing, mark: Mark) -> Trace:
    about, at, force = mark.step.inputs
    return Trace((tracing.acts.do(loci.cross, tracing.between(about, at), tracing.place(force)),))


def _couple(tracing: Tracing, mark: Mark) -> Trace:
    rate = tracing.acts.rate(tracing.place(mark.step.inputs[1]), tracing.place(mark.step.inputs[0]))
    return Trace((tracing.acts.do(np.multiply, rate, tracing.acts.fix(mark.step.size)),))


def _balanced(tracing: Tracing, mark: Mark) -> Trace:
    about, line, *moments = mark.step.inputs
    acts, (_, along) = tracing.acts, tracing.locus(line)
    arm = tracing.between(about, line.step.inputs[0])
    total = reduce(partial(acts.do, np.add), map(tracing.place, moments)) if moments else acts.fix(0.0)
    met = acts.do(_levered, acts.do(_paired, arm, along), total)
    return Trace((tracing.ray(met, 0),), (), met)


def _paired(first: Any, other: Any) -> tuple[Any, Any]:
    return first, other


def _levered(pair: tuple[Any, Any], moment: Any) -> Meeting:
    return loci.lever(*pair, moment)


_RULES: dict[str, Callable[[Tracing, Mark], Trace]] = {
    "given": _given,
    "lay_off": _laid_off,
    "join": _joined,
    "parallel": _parallel,
    "square": _square,
    "arc": _arc,
    "meet": _met,
    "tangent": _tangent,
    "settle": _settled,
    "direct": _directed,
    "turn": _turned,
    "transfer": _transferred,
    "similar": _similar,
    "divide": _divided,
    "close": _closed,
    "moment": _moment,
    "couple": _couple,
    "balance": _balanced,
}


T = TypeVar("T")


def remade(value: T, made: Mapping[Mark, Mark], boards: Mapping[str, Board]) -> T:
    """Give a value with each mark in it answered by its new one, and each board by that of its subject."""
    found: Any = value
    if isinstance(value, Mark):
        found = made[value]
    elif isinstance(value, Board):
        found = boards[value.subject]
    elif isinstance(value, tuple):
        parts = [remade(part, made, boards) for part in value]
        found = type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    elif isinstance(value, list):
        found = [remade(part, made, boards) for part in value]
    elif isinstance(value, dict):
        found = {key: remade(part, made, boards) for key, part in value.items()}
    return cast(T, found)
