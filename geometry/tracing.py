"""A tracing: the acts of a record, put in a row to be followed again from another given (калька).

The words of a record are the same whatever its givens are; only the numbers differ. A tracing takes a record that was
drawn once and follows its acts at other positions: each number that the acts need is worked out once, by the same
formulas, and the marks themselves are made when somebody looks at them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial, reduce
from operator import getitem
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from geometry import meet as loci
from geometry.board import Arc, Board, Line, Mark
from geometry.meet import Meeting, Vectors

Place: TypeAlias = int  # of a number among those of a tracing
Rule: TypeAlias = Callable[[Any, Any], Any]

_RAYS = Meeting._fields.index("first"), Meeting._fields.index("second")
_TIMES = Meeting._fields.index("into_first"), Meeting._fields.index("into_second")


class Trace(NamedTuple):
    """Where the numbers of a mark are: its value (of a line or an arc both), its rays, its meeting."""

    value: tuple[Place, ...]
    rays: tuple[Place, ...] = ()
    meeting: Place | None = None


class Tracing:
    """The acts behind some marks, in drafting order; `free` is the given mark that takes another value each time.

    >>> board = Board("positions")
    >>> a, e = board.given("A", 1j), board.given("φ", 1 + 0j)
    >>> tracing = Tracing([a, e, board.lay_off("B", a, e)], e)
    >>> numbers = tracing.follow(-1 + 0j)
    >>> complex(numbers[tracing.place(board["B"])])
    (-1+1j)
    """

    def __init__(self, marks: Iterable[Mark], free: Mark) -> None:
        self._numbers: list[Any] = []  # those that never change, in their places; None: worked out each time
        self._varying: set[Place] = set()
        self._acts: list[tuple[Place, Rule, Place, Place]] = []
        self._done: dict[tuple[Rule, Place, Place], Place] = {}
        self._turned: dict[Place, tuple[Place, Place]] = {}  # a vector turned and stretched: from which, by which
        self._free, self._nothing = self._vary(), self.fix(None)
        self._origin, self._quarter = self.fix(0j), self.fix(1j)
        self._real, self._imaginary = self.fix("real"), self.fix("imag")
        self._fields = [self.fix(field) for field in range(len(Meeting._fields))]
        self._traces: dict[Mark, Trace] = {}
        for mark in marks:
            self._traces[mark] = Trace((self._free,)) if mark is free else _RULES[mark.step.op](self, mark)
        self._meetings = [trace.meeting for trace in self._traces.values() if trace.meeting is not None]

    def follow(self, free: Vectors) -> list[Any]:
        """Give the numbers of all acts with another value of the free mark."""
        numbers = self._numbers.copy()
        numbers[self._free] = free
        for place, act, one, other in self._acts:
            numbers[place] = act(numbers[one], numbers[other])
        return numbers

    def clear(self, numbers: list[Any]) -> bool:
        """Whether no meeting has at any position a miss, a dead centre or anything unknown."""
        return all(numbers[place].clear for place in self._meetings)

    def place(self, mark: Mark) -> Place:
        """Tell where the value of a point or a vector is."""
        (value,) = self._traces[mark].value
        return value

    def ratio(self, image: Place, of: Place) -> Place:
        """Divide one vector by another, where it is not known by what it was turned and stretched from the other."""
        known = self._known_ratio(image, of)
        return self.do(np.divide, image, of) if known is None else known

    def rate(self, image: Place, of: Place) -> Place:
        """Give the part of that ratio which is square to the vector."""
        source, by = self._turned.get(image, (None, self._nothing))
        if source is not None and self._known_ratio(source, of) == self._quarter:
            return self.do(_part, by, self._real)
        return self.do(_part, self.ratio(image, of), self._imaginary)

    def follows(self, vector: Mark, free: Mark, span: complex) -> bool:
        """Whether a vector that is `span` beside a free one of 1 has the very direction of the free one."""
        by = self._known_ratio(self.place(vector), self.place(free))
        turn = None if by is None else self.fixed(by)
        return turn is not None and (turn / span).imag == 0 < (turn / span).real

    def _known_ratio(self, image: Place, of: Place) -> Place | None:
        if image not in self._turned:
            return None
        source, by = self._turned[image]
        if source == of:
            return by
        before = self._known_ratio(source, of)
        return None if before is None else self.do(np.multiply, before, by)

    def fixed(self, place: Place) -> Any:
        """Give a number that is the same with any free mark; None where it changes."""
        return self._numbers[place]

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
            step=mark.step._replace(inputs=tuple(made[source] for source in mark.step.inputs)),
            rays=tuple(rays),
            meeting=None if trace.meeting is None else numbers[trace.meeting],
        )

    # What the rules of the verbs put down

    def fix(self, number: Any) -> Place:
        """Give a place to a number that never changes."""
        self._numbers.append(number)
        return len(self._numbers) - 1

    def _vary(self) -> Place:
        self._varying.add(self.fix(None))
        return len(self._numbers) - 1

    def do(self, act: Rule, one: Place, other: Place | None = None) -> Place:
        """Put down an act on one or two numbers: done at once where they never change, and never twice."""
        other = self._nothing if other is None else other
        key = (act, one, other)
        if key not in self._done:
            if one in self._varying or other in self._varying:
                self._done[key] = self._vary()
                self._acts.append((self._done[key], *key))
            else:
                self._done[key] = self.fix(act(self._numbers[one], self._numbers[other]))
        return self._done[key]

    def turned(self, vector: Place, by: Place) -> Place:
        """Turn and stretch a vector by a number."""
        found = self.do(np.multiply, vector, by)
        self._turned.setdefault(found, (vector, by))
        return found

    def square(self, vector: Place) -> Place:
        """Turn a vector by a quarter."""
        return self.turned(vector, self._quarter)

    def ray(self, met: Place, end: int, along: Place | None = None) -> Place:
        """Give the vector to a meeting from the first or the second locus; `along` is the direction of a line's."""
        found = self.do(getitem, met, self._fields[_RAYS[end]])
        if along is not None:
            self._turned.setdefault(found, (along, self.do(getitem, met, self._fields[_TIMES[end]])))
        return found

    def end(self, start: Mark, vector: Place) -> Place:
        """Lay a vector off from a point; from the origin it is the vector itself."""
        place = self.place(start)
        return vector if self._is_origin(place) else self.do(np.add, place, vector)

    def between(self, start: Mark, end: Mark) -> Place:
        """Give the vector from one point to another as the board does."""
        rays = zip(end.rays, self._traces[end].rays, strict=True)
        back = zip(start.rays, self._traces[start].rays, strict=True)
        for (origin, _), ray in rays:
            if origin is start:
                return ray
        for (origin, _), ray in back:
            if origin is end:
                return self.do(np.subtract, self._origin, ray)
        if self._is_origin(self.place(start)):
            return self.place(end)
        return self.do(np.subtract, self.place(end), self.place(start))

    def locus(self, mark: Mark) -> tuple[Place, Place]:
        """Tell where the point of a line or an arc is, and its direction or radius."""
        point, measure = self._traces[mark].value
        return point, measure

    def _is_origin(self, place: Place) -> bool:
        return place not in self._varying and np.ndim(self._numbers[place]) == 0 and self._numbers[place] == 0


def _part(number: Any, part: str) -> Any:
    return getattr(number, part)


def _given(tracing: Tracing, mark: Mark) -> Trace:
    parts = mark.value if isinstance(mark.value, Line | Arc) else (mark.value,)
    return Trace(tuple(tracing.fix(part) for part in parts))


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
    return Trace((through, tracing.square(to)))


def _arc(tracing: Tracing, mark: Mark) -> Trace:
    (centre,) = mark.step.inputs
    return Trace((tracing.place(centre), tracing.fix(mark.step.size)))


def _met(tracing: Tracing, mark: Mark) -> Trace:
    first, second = mark.step.inputs
    one, other = first.step.inputs[0], second.step.inputs[0]
    base, side = tracing.between(one, other), mark.step.side
    (_, measure), (_, beside) = tracing.locus(first), tracing.locus(second)
    along: tuple[Place | None, Place | None] = None, None
    match first.value, second.value:
        case Arc(), Arc():
            met = tracing.do(partial(loci.two_arcs, side=side), base, tracing.do(loci.radii, measure, beside))
        case Line(), Arc(radius=radius):
            met = tracing.do(partial(loci.line_arc, radius=radius, side=side), base, measure)
        case _:
            met = tracing.do(loci.two_lines, base, tracing.do(loci.crossing, measure, beside))
            along = measure, beside
    rays = tracing.ray(met, 0, along[0]), tracing.ray(met, 1, along[1])
    return Trace((tracing.end(one, rays[0]),), rays, met)


def _tangent(tracing: Tracing, mark: Mark) -> Trace:
    base, offset = tracing.between(*mark.step.inputs), tracing.fix(mark.step.size)
    met = tracing.do(partial(loci.tangent_direction, side=mark.step.side), base, offset)
    return Trace((tracing.ray(met, 0),), (), met)


def _turned(tracing: Tracing, mark: Mark) -> Trace:
    (vector,) = mark.step.inputs
    return Trace((tracing.turned(tracing.place(vector), tracing.fix(mark.step.size)),))


def _transferred(tracing: Tracing, mark: Mark) -> Trace:
    (source,) = mark.step.inputs
    return Trace((tracing.place(source),))


def _similar(tracing: Tracing, mark: Mark) -> Trace:
    image, of, shape = map(tracing.place, mark.step.inputs)
    found = tracing.do(np.multiply, shape, tracing.ratio(image, of))
    return Trace((found if mark.step.size == 1 else tracing.do(np.multiply, found, tracing.fix(mark.step.size)),))


def _divided(tracing: Tracing, mark: Mark) -> Trace:
    circle, directions = mark.step.inputs
    ray = tracing.turned(tracing.place(directions), tracing.locus(circle)[1])
    return Trace((tracing.end(circle.step.inputs[0], ray),), (ray,))


def _closed(tracing: Tracing, mark: Mark) -> Trace:
    return Trace((tracing.do(np.negative, reduce(partial(tracing.do, np.add), map(tracing.place, mark.step.inputs))),))


_RULES: dict[str, Callable[[Tracing, Mark], Trace]] = {
    "given": _given,
    "lay_off": _laid_off,
    "join": _joined,
    "parallel": _parallel,
    "square": _square,
    "arc": _arc,
    "meet": _met,
    "tangent": _tangent,
    "turn": _turned,
    "transfer": _transferred,
    "similar": _similar,
    "divide": _divided,
    "close": _closed,
}
