"""Every stroke and letter of the views of a bank and of its compensators ticked off, and none beside (опись видов)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from itertools import pairwise

from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance import figure_parts as parts
from drawings.checks.bank import bank_layouts
from drawings.checks.bank.bank_expected import LINE, Expected
from drawings.checks.bank.bank_views import origin
from drawings.checks.bank.compensator_strokes import ZERO, CompensatorStrokes, turning
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank import shaft, star
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Fill, Group, Leaf, Line, Polyline, Text
from drawings.paper.walk import group_named, groups
from drawings.symbols.symbols import HINGE


def faults(leaf: Leaf, expected: Expected, by: Drafting, figures: Collection[str]) -> Iterator[Wrong]:
    """Hold all that the views of a sheet show."""
    for name, hold in ((star.NAME, _star), (shaft.NAME, _shaft)):
        part = group_named(leaf.groups, name)
        if part is not None and name in figures:
            yield from hold(part, expected, by)
    for one in expected.analysis.compensators:
        part = group_named(leaf.groups, bank_layouts.name_of(one))
        if part is not None and part.name in figures:
            yield from CompensatorStrokes(part, expected, by, one).faults()


def _together(names: Iterator[tuple[str, complex]]) -> list[tuple[str, complex]]:
    """Name what stands at one place together."""
    found: list[tuple[str, complex]] = []
    for name, at in names:
        k = next((k for k, (_, other) in enumerate(found) if abs(other - at) <= LINE), None)
        if k is None:
            found.append((name, at))
        else:
            found[k] = f"{found[k][0]}, {name}", found[k][1]
    return found


def _star(part: Group, expected: Expected, by: Drafting) -> Iterator[Wrong]:
    """Tick off the star of cranks."""
    zero, mu = origin(FigureStrokes(part))
    ink = parts.inventory(star.NAME, part)
    known = expected.crank is not None
    parts.headed(ink, by.word("star of cranks"), [scale_line(mu, "l", "m", by) if known else by.word("angles alone")])
    parts.spot(ink, zero, ZERO, ZERO, HINGE * by.hand.symbol)
    radius = expected.crank / mu if expected.crank is not None else _rim(part, zero)
    ink.circle(zero, on("circle", ink.plan, name="r"), radius)
    for one in expected.members:
        spot = zero + radius * expected.crank_at(one)
        ink.line(zero, spot, on("crank", ink.plan, name=one.name))
        ink.circle(spot, on("crank", ink.plan, name=one.name), star.PIN * by.hand.symbol)
    for names, way in _together((one.name, expected.crank_at(one)) for one in expected.members):
        ink.letter(names, [zero + radius * way], on("letter", ink.plan, name=names))
    guides = _together(iter(expected.ways().items()))
    for names, way in guides:
        axis = ink.take(Line, partial(_passes, at=zero, way=way), on("guide", ink.plan, name=names))
        if axis is not None and len(guides) > 1:
            ink.letter(read(by.word("guide of", names=names)), [axis.end], on("letter", ink.plan, name=names))
    turning(ink, zero, 1 if expected.task.speed > 0 else -1, "ω")
    yield from ink.faults()


def _rim(part: Group, zero: complex) -> float:
    own = (one.radius for one in FigureStrokes(part).circles if abs(one.centre - zero) <= parts.NEAR)
    return max(own, default=0.0)


def _passes(one: Line, at: complex, way: complex) -> bool:
    """Tell whether a line goes in a direction through a place and beyond it."""
    start, end = (one.start - at) / way, (one.end - at) / way
    return max(abs(start.imag), abs(end.imag)) <= parts.NEAR and start.real < -parts.NEAR < parts.NEAR < end.real


def _shaft(part: Group, expected: Expected, by: Drafting) -> Iterator[Wrong]:
    """Tick off the view across the shaft: axis, pieces, cranks, guides; dimensions are held by themselves."""
    zero, mu = origin(FigureStrokes(part))
    ink, symbol = parts.inventory(shaft.NAME, part), by.hand.symbol
    parts.headed(ink, by.word("view across"), [scale_line(mu, "l", "m", by)])
    parts.spot(ink, zero, ZERO, ZERO)
    places = _together((one.name, complex(float(one.place)) / mu) for one in expected.members)
    far = (shaft.THROW + shaft.GUIDE) * symbol
    for one in expected.members:
        spot = zero + float(one.place) / mu
        ink.circle(spot, on("missing_on", ink.plan, name=one.name))
        high = shaft.THROW * symbol * (expected.crank_at(one) * expected.turn.conjugate()).real
        if abs(high) <= LINE * shaft.THROW:
            ink.circle(spot, on("crank", ink.plan, name=one.name))
        else:
            ink.take(Polyline, partial(_is_throw, at=spot, high=high), on("crank", ink.plan, name=one.name))
        up = -1 if (expected.ways()[one.name] * expected.turn.conjugate()).real < -LINE else 1
        ink.line(spot, spot + 1j * far * up, on("guide", ink.plan, name=one.name))
    _sizes(ink, part, [zero + at for _, at in places if at])
    for names, at in places:
        ink.letter(names, [zero + at], on("letter", ink.plan, name=names))
    ink.line(zero - 1j * far, zero + 1j * far, on("line", ink.plan))
    _pieces(ink, zero, [at.real for _, at in places], symbol)
    yield from ink.faults()


def _is_throw(one: Polyline, at: complex, high: float) -> bool:
    corners = [spot - at for spot in one.points]
    return (
        len(corners) == 4
        and all(min(abs(spot.imag), abs(spot.imag - high)) <= parts.NEAR for spot in corners)
        and (abs(sum(corners).real) <= parts.NEAR)
    )


def _pieces(ink: Inventory, zero: complex, places: list[float], symbol: float) -> None:
    """Tick off the axis of the shaft, and the shaft between the webs of its cranks, from end to end."""
    webs = sorted(place + side * shaft.WEB * symbol for place in places for side in (-1, 1))
    axis = ink.take(Line, partial(_level, zero=zero, ends=(webs[0], webs[-1])), on("line", ink.plan))
    half = shaft.WEB * symbol
    for left, right in pairwise(sorted(places)):
        if right - half > left + half:  # cranks that are nearer have their webs in one another
            ink.line(zero + left + half, zero + right - half, on("line", ink.plan))
    ends = ink.every(Line, partial(_is_end, zero=zero, webs=(webs[0], webs[-1])))
    if axis is None or len(ends) != 2:
        ink.wrong.append(on("line", ink.plan))


def _level(one: Line, zero: complex, ends: tuple[float, float]) -> bool:
    start, end = one.start - zero, one.end - zero
    level = max(abs(start.imag), abs(end.imag)) <= parts.NEAR
    return level and start.real < min(ends[0], 0.0) and end.real > max(ends[1], 0.0)


def _is_end(one: Line, zero: complex, webs: tuple[float, float]) -> bool:
    """Tell whether a line is an end of the shaft, outside of its outermost webs."""
    start, end = one.start - zero, one.end - zero
    level = max(abs(start.imag), abs(end.imag)) <= parts.NEAR
    return level and (abs(end.real - webs[0]) <= parts.NEAR or abs(start.real - webs[1]) <= parts.NEAR)


def _sizes(ink: Inventory, part: Group, spots: list[complex]) -> None:
    """Tick off the dimensions of the places, and the lines down to them, one for each place and for that of 0."""
    base = ink.plan
    own = {id(one) for group in groups((part,)) if _is_size(group) for one in group.strokes}
    for kind in (Line, Fill, Text):
        ink.every(kind, lambda one: id(one) in own)
    if not own:
        return
    zero = marks.pole(part)
    for spot in (zero, *spots):
        ink.take(Line, partial(_drops, at=spot), on("size", base, name=f"h {spot.real - zero.real:.0f}"))


def _is_size(group: Group) -> bool:
    return any(isinstance(one, Text) and one.plain.startswith("h") for one in group.strokes) and any(
        isinstance(one, Fill) for one in group.strokes
    )


def _drops(one: Line, at: complex) -> bool:
    """Tell whether a line goes straight down from a place."""
    return (
        abs(one.start - at) <= parts.NEAR and abs((one.end - one.start).real) <= parts.NEAR < (one.start - one.end).imag
    )
