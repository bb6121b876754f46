"""The parts that figures of balancing have in common, ticked off one by one: headings, arrows, axes (части фигур)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from drawings.checks.graphs.figure_strokes import FLUSH, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.wrong import Wrong, on
from drawings.measure.measured import MeasuredVector
from drawings.paper.limits import QUANTUM, SEEN
from drawings.paper.strokes import Circle, Group, Line, Polyline
from drawings.paper.walk import groups
from drawings.symbols.symbols import TICK

NEAR = FLUSH + 8 * QUANTUM  # mm: places are read off marks that are rounded, their ends and their scales
HEADED = 0.1  # mm: a shorter vector has no head
BEYOND = 9.0  # mm that an axis goes beyond its graph, for its arrowhead
JOIN = ";  "  # between what stands in one line under a title


class Axis(NamedTuple):
    """An axis of a graph on paper: its letter, which may be none, and where its graph begins and ends, mm."""

    letter: str
    start: complex
    end: complex


def inventory(plan: str, part: Group, near: float = NEAR) -> Inventory:
    """Take stock of a figure: all of its strokes."""
    return Inventory(plan, (part,), near)


def headed(ink: Inventory, title: str, under: Sequence[str]) -> None:
    """Tick off a title, and the line under it."""
    ink.text(read(title), on("title", ink.plan, text=title))
    told = read(JOIN.join(under))
    ink.text(told, on("scale_missing", ink.plan, text=told))


def arrow(ink: Inventory, one: MeasuredVector, letter: str) -> None:
    """Tick off a vector with its arrowhead, and its letter along it; one that is short bears none."""
    ink.line(one.start, one.end, on("missing_on", ink.plan, name=one.name))
    length = abs(one.end - one.start)
    if length > HEADED - NEAR:
        ink.head(one.end, one.end - one.start, on("head", ink.plan, name=one.name) if length > HEADED + NEAR else None)
    if length >= SEEN - NEAR:
        ink.letter_along(
            read(letter), one.start, one.end, on("letter", ink.plan, name=letter) if length > SEEN + NEAR else None
        )


def weighed(ink: Inventory, part: Group, whole: str, main: float) -> None:
    """See that the vector of the whole is drawn in a main line, and every other thinner."""
    vectors = [one for one in groups((part,)) if one.data.get("kind") == "vector"]
    for name, line in ((one.data["name"], one.strokes[0]) for one in vectors):
        if isinstance(line, Line) and (line.style.width >= main) != (name == whole):
            ink.wrong.append(on("line_named", ink.plan, name=name))


def lined(ink: Inventory, part: Group | None, name: str, heavy: bool, main: float) -> None:
    """See that the chains of a curve are drawn in a main line, mm wide, or all thinner."""
    widths = [one.style.width for one in part.strokes if isinstance(one, Polyline)] if part is not None else []
    if any((width >= main) != heavy for width in widths):
        ink.wrong.append(on("line_named", ink.plan, name=name))


def spot(ink: Inventory, at: complex, letter: str, name: str, radius: float | None = None) -> None:
    """Tick off a place that is marked by a circle, and its letter."""
    ink.circle(at, on("missing_on", ink.plan, name=name), radius)
    ink.letter(read(letter), [at], on("letter", ink.plan, name=name))


def axes(ink: Inventory, rows: Iterable[Axis]) -> None:
    """Tick off axes with their arrowheads, and their letters beside these."""
    for letter, start, end in rows:
        way = (end - start) / abs(end - start)
        holds = _Tip(end + BEYOND * way, ink.near).holds
        tip = ink.arrow(start, holds, on("axes", ink.plan, name=read(letter)))
        if tip is not None and letter:
            ink.letter(read(letter), [tip], on("letter", ink.plan, name=read(letter)))


class _Tip(NamedTuple):
    """Where the tip of an axis must be, and how near to it."""

    at: complex
    near: float

    def holds(self, spot: complex) -> bool:
        """Tell whether a place is there."""
        return abs(spot - self.at) <= self.near


def tick(ink: Inventory, at: complex, way: complex, wrong: Wrong | None) -> None:
    """Tick off a tick across an axis."""
    half = TICK * way
    ink.line(at - half, at + half, wrong)


def dots(ink: Inventory, spots: Iterable[tuple[str, complex]], sure: bool = True) -> None:
    """Tick off the points of a curve by their names."""
    for name, at in spots:
        ink.circle(at, on("edge", ink.plan, name=name) if sure else None)


def carried(ink: Inventory, one: MeasuredVector, start: complex, value: complex) -> None:
    """Tick off the thin lines that carry the ends of a vector from their own places, mm, over to its lane."""
    shift = one.start - start
    if abs(shift) <= ink.near:
        return
    for end in (start, start + value):
        ink.take(Line, _Carrier(end, shift, ink.near).holds, on("carried", ink.plan, name=one.name))


class _Carrier(NamedTuple):
    """A thin line from a place past the lane that it carries an end over to."""

    start: complex
    shift: complex
    near: float

    def holds(self, line: Line) -> bool:
        """Tell whether a line is such a one."""
        if abs(line.start - self.start) > self.near or line.start == line.end:
            return False
        own = (line.end - line.start) / self.shift
        return own.real > 1 and abs(own.imag) * abs(self.shift) <= self.near


def chains(ink: Inventory, part: Group | None, count: int, name: str) -> None:
    """Tick off the chains of a curve that is held elsewhere: as many as it has runs, and none twice."""
    own = set(map(id, part.strokes)) if part is not None else set[int]()
    found = ink.every(Polyline, lambda one: id(one) in own)
    found_lines = ink.every(Line, lambda one: id(one) in own)
    circles = ink.every(Circle, lambda one: id(one) in own)
    if len(found) + len(found_lines) + len(circles) != count:
        ink.wrong.append(on("path", ink.plan, name=name))


def faults(inks: Iterable[Inventory]) -> Iterator[Wrong]:
    """Give what is missing from figures and what is too much on them."""
    for one in inks:
        yield from one.faults()
