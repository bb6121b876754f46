"""The drafting board: an append-only record of drafting acts, for one position and for a million at once.

A point or a vector is a complex number x + iy, or an array of them, one for each position. The vocabulary is closed:
given, lay_off, join, parallel, square, arc, meet, tangent, settle, direct, turn, transfer, similar, divide, close; and
of forces, whose arms are measured on the drawing, moment, couple, balance. A moment is a real number. Readers of the
record (replay, precision, explain, the sheets) know the verbs; no construction knows its readers.
"""

from collections.abc import Iterator, Sequence
from functools import reduce
from operator import add
from typing import NamedTuple, TypeAlias, cast

import numpy as np

from geometry import meet as loci
from geometry.branch import Settling
from geometry.meet import Meeting, Sizes, Vectors
from geometry.three_leads import GUIDE, SLOT, BodyPose

GIVEN, CONSTRUCTION, RESULT = "given", "construction", "result"


class Line(NamedTuple):
    """A line: a point of it and a direction of any size but zero (прямая)."""

    through: Vectors
    direction: Vectors


class Arc(NamedTuple):
    """An arc: its centre and radius (дуга засечки)."""

    centre: Vectors
    radius: Sizes


Value: TypeAlias = Vectors | Sizes | Line | Arc


class Step(NamedTuple):
    """One drafting act: the verb, the marks it used, its numbers, the side it chose, and why."""

    op: str
    inputs: "tuple[Mark, ...]"
    size: Vectors
    side: Sizes
    why: object  # a text, or what can be said in a language
    settling: Settling | None = None  # of a body on three leads


class Mark(NamedTuple):
    """A thing on a board with the step that drew it.

    `rays` are the vectors to a point from the marks it was drawn from, kept as they were constructed, not as
    differences of absolute points. `meeting` is how the loci met that it was found by.
    """

    subject: str
    number: int
    name: str
    value: Value
    step: Step
    rays: "tuple[tuple[Mark, Vectors], ...]"
    meeting: Meeting | None

    # A mark is itself: two marks that happen to lie on one place stay two.
    def __eq__(self, other: object) -> bool:
        return self is other

    def __ne__(self, other: object) -> bool:
        return self is not other

    def __hash__(self) -> int:
        return id(self)

    @property
    def sharpness(self) -> Sizes | None:
        """The sine of the crossing angle of the meeting that found it."""
        return None if self.meeting is None else self.meeting.sharpness

    @property
    def miss(self) -> Sizes | None:
        """By how much the loci of its meeting miss each other."""
        return None if self.meeting is None else self.meeting.miss

    @property
    def point(self) -> Vectors:
        """The value of a point, a vector or a moment; a line or an arc has none."""
        if isinstance(self.value, tuple):
            raise TypeError(f"{self.name} is a {type(self.value).__name__.lower()}, not a point or a vector")
        return cast(Vectors, self.value)  # a moment is a real number, which is a complex one too

    @property
    def is_moment(self) -> bool:
        """Whether it is a moment, a real number, and no point or vector."""
        return not isinstance(self.value, tuple) and bool(np.isrealobj(self.value))

    @property
    def role(self) -> str:
        """What the line weight says of it: given, construction or result."""
        if self.step.op == "given":
            return GIVEN
        return CONSTRUCTION if isinstance(self.value, tuple) else RESULT


class Board:
    """A record of drafting acts with one subject, such as "positions" or "velocities" (чертёжная доска).

    >>> board = Board("positions")
    >>> a, c = board.given("A", 0j), board.given("C", 6 + 0j)
    >>> b = board.meet("B", board.arc("AB", a, 5.0), board.arc("CB", c, 5.0), side=+1, why="5 m from A and from C")
    >>> complex(b.point)
    (3+4j)
    """

    def __init__(self, subject: str) -> None:
        self.subject = subject
        self.marks: list[Mark] = []
        self.clear = True  # no meeting has at any position a miss, a dead centre or anything unknown
        self._named: dict[str, Mark] = {}

    def __getitem__(self, name: str) -> Mark:
        return self._named[name]

    def __contains__(self, name: object) -> bool:
        return name in self._named

    def __iter__(self) -> Iterator[Mark]:
        return iter(self.marks)

    def __len__(self) -> int:
        return len(self.marks)

    def _draw(
        self,
        name: str,
        value: Value,
        op: str,
        inputs: tuple[Mark, ...],
        why: object,
        size: Vectors = 0j,
        side: Sizes = 0.0,
        rays: tuple[tuple[Mark, Vectors], ...] = (),
        meeting: Meeting | None = None,
        settling: Settling | None = None,
    ) -> Mark:
        step = Step(op, inputs, size, side, why, settling)
        return self.keep(Mark(self.subject, len(self.marks), name, value, step, rays, meeting))

    def keep(self, mark: Mark) -> Mark:
        """Put down a mark that is made."""
        self.marks.append(mark)
        self._named.setdefault(mark.name, mark)  # the first mark of a name keeps it
        if mark.meeting is not None and not mark.meeting.clear:
            self.clear = False
        return mark

    def given(self, name: str, value: Value, why: object = "") -> Mark:
        """Put a known point, vector, line or arc on the board."""
        return self._draw(name, value, "given", (), why)

    def lay_off(self, name: str, start: Mark, vector: Mark, why: object = "") -> Mark:
        """Lay a vector off from a point; the mark is its end (отложить вектор)."""
        by = vector.point
        return self._draw(name, _end(start, by), "lay_off", (start, vector), why, rays=((start, by),))

    def join(self, name: str, start: Mark, end: Mark, why: object = "") -> Mark:
        """Join two points by a vector, taken from the construction that drew one from the other where there is one."""
        return self._draw(name, between(start, end), "join", (start, end), why)

    def parallel(self, name: str, through: Mark, to: Mark, why: object = "") -> Mark:
        """Draw through a point the line parallel to a vector."""
        return self._draw(name, Line(through.point, to.point), "parallel", (through, to), why)

    def square(self, name: str, through: Mark, to: Mark, why: object = "") -> Mark:
        """Draw through a point the line square to a vector, directed 90 degrees counter-clockwise from it."""
        return self._draw(name, Line(through.point, 1j * to.point), "square", (through, to), why)

    def arc(self, name: str, centre: Mark, radius: Sizes, why: object = "") -> Mark:
        """Strike an arc of a given radius about a point (засечка)."""
        return self._draw(name, Arc(centre.point, radius), "arc", (centre,), why, size=cast(Vectors, radius))

    def meet(self, name: str, first: Mark, second: Mark, side: Sizes = 0.0, why: object = "") -> Mark:
        """Find the meeting of two lines or arcs; `side` chooses one of two.

        Two arcs: +1 left of the ray from the first centre to the second. A line and an arc: +1 ahead of the foot of the
        perpendicular from the centre, along the line. Two lines meet once.
        """
        if isinstance(first.value, Arc) and isinstance(second.value, Line):
            first, second = second, first
        origin, other = first.step.inputs[0], second.step.inputs[0]
        found = _meeting(first, second, between(origin, other), side)
        rays = ((origin, found.first), (other, found.second))
        return self._draw(name, _end(origin, found.first), "meet", (first, second), why, 0j, side, rays, found)

    def tangent(self, name: str, pivot: Mark, pin: Mark, offset: float, side: Sizes, why: object = "") -> Mark:
        """Direct the slot through a pin at a given offset from a pivot: a unit vector (касательная из точки).

        The pin lies `offset` to the left of the pivot's line; `side` is +1 where it lies ahead of the pivot.
        """
        found = loci.tangent_direction(between(pivot, pin), offset, side)
        return self._draw(name, found.first, "tangent", (pivot, pin), why, offset, side, (), found)

    def settle(self, name: str, settling: Settling, begins: Sequence[Mark], free: Mark, why: object = "") -> Mark:
        """Settle a body on three leads by trial, along its branch: the mark is its point at the first (M3.10).

        `begins` are points of the leads, then directions of guides; `free` is what drives the mechanism.
        """
        found = settling.met([mark.point for mark in begins], free.point)
        rays = ((begins[0], found.first),)
        inputs = (*begins, free)
        return self._draw(name, _end(begins[0], found.first), "settle", inputs, why, 0j, 0.0, rays, found, settling)

    def direct(self, name: str, settled: Mark, why: object = "") -> Mark:
        """Give the direction of a body that was settled on its leads: a unit vector."""
        if settled.meeting is None:
            raise TypeError(f"{settled.name} is not of a body on leads")
        return self._draw(name, settled.meeting.second, "direct", (settled, *settled.step.inputs), why)

    def turn(self, name: str, vector: Mark, by: Vectors, why: object = "") -> Mark:
        """Turn and stretch a vector by a known complex number: 1j is a quarter turn counter-clockwise."""
        return self._draw(name, vector.point * by, "turn", (vector,), why, size=by)

    def transfer(self, name: str, mark: Mark, why: object = "") -> Mark:
        """Carry a vector unchanged from another board with the set square (параллельный перенос)."""
        return self._draw(name, mark.point, "transfer", (mark,), why)

    def similar(self, name: str, image: Mark, of: Mark, shape: Mark, times: float = 1.0, why: object = "") -> Mark:
        """Find the vector that is to `shape` as `image` is to `of`: similar triangles, taken `times` (подобие).

        With `shape` = `image` it is the third proportional: the normal acceleration ab2/AB. The similarity theorem
        (теорема подобия) gives the image of any vector of a link.
        """
        value = shape.point * (image.point / of.point)
        if times != 1.0:
            value = value * times
        return self._draw(name, value, "similar", (image, of, shape), why, size=times)

    def divide(self, name: str, circle: Mark, directions: Mark, why: object = "") -> Mark:
        """Divide a circle at given unit directions from its centre; the mark is the points on it."""
        if not isinstance(circle.value, Arc):
            raise TypeError(f"{circle.name} is not a circle")
        centre = circle.step.inputs[0]
        ray = circle.value.radius * directions.point
        return self._draw(name, _end(centre, ray), "divide", (circle, directions), why, rays=((centre, ray),))

    def close(self, name: str, *vectors: Mark, why: object = "") -> Mark:
        """Close a chain of vectors: the vector from its end back to its start (замкнуть многоугольник)."""
        total = reduce(add, (v.point for v in vectors)) if vectors else 0j
        return self._draw(name, -total, "close", vectors, why)

    def moment(self, name: str, about: Mark, at: Mark, force: Mark, why: object = "") -> Mark:
        """Take the moment about a point of a force that acts at another, its arm measured (момент силы)."""
        return self._draw(name, loci.cross(between(about, at), force.point), "moment", (about, at, force), why)

    def couple(self, name: str, arm: Mark, turning: Mark, times: float, why: object = "") -> Mark:
        """Take a moment from how a link turns: `times` the part of `turning` square to the arm, over the arm."""
        value = (turning.point / arm.point).imag * times
        return self._draw(name, value, "couple", (arm, turning), why, size=times)

    def balance(self, name: str, about: Mark, line: Mark, *moments: Mark, why: object = "") -> Mark:
        """Find the force along a line that balances moments about a point (уравнение моментов)."""
        if not isinstance(line.value, Line):
            raise TypeError(f"{line.name} is no line of action")
        total = reduce(add, (moment.point.real for moment in moments)) if moments else 0.0
        found = loci.lever(between(about, line.step.inputs[0]), line.value.direction, total)
        return self._draw(name, found.first, "balance", (about, line, *moments), why, meeting=found)


def _meeting(first: Mark, second: Mark, base: Vectors, side: Sizes) -> Meeting:
    match first.value, second.value:
        case Arc(), Arc():
            return loci.arc_arc(base, first.value.radius, second.value.radius, side)
        case Line(), Arc():
            return loci.line_arc(base, first.value.direction, second.value.radius, side)
        case Line(), Line():
            return loci.line_line(base, first.value.direction, second.value.direction)
    raise TypeError(f"{first.name} and {second.name} are not two lines or arcs")


def _end(start: Mark, vector: Vectors) -> Vectors:
    """Give the end of a vector laid off from a point; from the origin it is the vector itself."""
    point = start.point
    return vector if type(point) is complex and point == 0 else point + vector


def between(start: Mark, end: Mark) -> Vectors:
    """Give the vector from one point to another as it was constructed, or else as their difference."""
    for origin, ray in end.rays:
        if origin is start:
            return ray
    for origin, ray in start.rays:
        if origin is end:
            return -ray
    point = start.point
    return end.point if type(point) is complex and point == 0 else end.point - point


def at(value: Vectors | Sizes, position: int) -> complex:
    """Give the value at one position, whether or not it changes with the position."""
    array = np.asarray(value)
    return complex(array[position] if array.ndim else array)


class HeldLead(NamedTuple):
    """A lead of a settled body: where it begins among the inputs, the arm from there, its force's direction, its moves.

    `way` is the place of its guide's direction among the inputs, if it has one; a length of it moves the body's point
    by `shift` and turns it by `spin`; `sense` is -1 of a slot, where a larger offset is a shorter arm.
    """

    begin: int
    way: int | None
    arm: Vectors
    along: Vectors
    shift: Vectors
    spin: Sizes
    sense: float


def held_leads(mark: Mark) -> Iterator[HeldLead]:
    """Tell how each lead holds a body where it was settled."""
    assert mark.step.settling is not None and mark.meeting is not None  # asked of such marks alone
    body, begins, way = mark.step.settling.body, [one.point for one in mark.step.inputs[:-1]], 3
    pose = BodyPose(mark.meeting.first, mark.meeting.second)
    held = body.held(mark.step.settling.known(begins), pose)
    for k, lead in enumerate(body.leads):
        arm = pose.reach + held.contacts[k] - (begins[k] - begins[0])
        guided, way = (way, way + 1) if lead.kind == GUIDE else (None, way)
        yield HeldLead(k, guided, arm, held.along[k], *held.moves[k], -1.0 if lead.kind == SLOT else 1.0)


class Span(NamedTuple):
    """A vector of a plan between two of its marks."""

    start: Mark
    end: Mark


class Reading(NamedTuple):
    """What an angular velocity or acceleration is read from: a vector of the link and its turning part on the plan."""

    arm: Mark
    turning: Mark


def behind(*marks: Mark) -> list[Mark]:
    """Give the marks that the given ones rest on, themselves last, in drafting order across boards.

    >>> from geometry.board import Board
    >>> board = Board("positions")
    >>> a, c, d = board.given("A", 0j), board.given("C", 5 + 0j), board.given("D", 9j)
    >>> [mark.name for mark in behind(board.join("AC", a, c))]
    ['A', 'C', 'AC']
    """
    order: dict[Mark, None] = {}
    waiting = [(mark, False) for mark in reversed(marks)]
    while waiting:
        mark, ready = waiting.pop()
        if ready:
            order.setdefault(mark)
        elif mark not in order:
            waiting.append((mark, True))
            waiting.extend((source, False) for source in reversed(mark.step.inputs))
    return list(order)
