"""Every stroke and letter of the views of a bank and of its compensators ticked off, and none beside (опись видов)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from itertools import pairwise

from drawings.checks.balance import balance_marks as marks
from drawings.checks.balance import bank_layouts
from drawings.checks.balance import figure_parts as parts
from drawings.checks.balance.bank_expected import LINE, Expected
from drawings.checks.balance.bank_views import origin
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank import shaft, star
from drawings.figures.bank.compensator_layout import speed
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Fill, Group, Leaf, Line, Polyline, Text
from drawings.paper.walk import groups
from drawings.symbols.symbols import HINGE
from plans.model.balance.bank import Compensator

ZERO = "O"  # the letter of the shaft


def faults(leaf: Leaf, expected: Expected, by: Drafting, figures: Collection[str]) -> Iterator[Wrong]:
    """Hold all that the views of a sheet show."""
    for name, hold in ((star.NAME, _star), (shaft.NAME, _shaft)):
        part = marks.figure(leaf, name)
        if part is not None and name in figures:
            yield from hold(part, expected, by)
    for one in expected.analysis.compensators:
        part = marks.figure(leaf, bank_layouts.name_of(one))
        if part is not None and part.name in figures:
            yield from _layout(part, expected, by, one)


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
    parts.headed(ink, by.word("star of cranks"), [parts.scale(mu, "l", "m", by) if known else by.word("angles alone")])
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
    _turning(ink, zero, 1 if expected.task.speed > 0 else -1, "ω")
    yield from ink.faults()


def _rim(part: Group, zero: complex) -> float:
    own = (one.radius for one in FigureStrokes(part).circles if abs(one.centre - zero) <= parts.NEAR)
    return max(own, default=0.0)


def _passes(one: Line, at: complex, way: complex) -> bool:
    """Tell whether a line goes in a direction through a place and beyond it."""
    start, end = (one.start - at) / way, (one.end - at) / way
    return max(abs(start.imag), abs(end.imag)) <= parts.NEAR and start.real < -parts.NEAR < parts.NEAR < end.real


def _turning(ink: Inventory, centre: complex, sense: int, letter: str) -> None:
    """Tick off an arrow about a place, with what stands beside it."""
    wrong = on("sense", ink.plan, name=letter)
    middle = ink.turning(centre, sense, wrong)
    if middle is not None:
        ink.letter(letter, [middle], wrong)


def _shaft(part: Group, expected: Expected, by: Drafting) -> Iterator[Wrong]:
    """Tick off the view across the shaft: axis, pieces, cranks, guides; dimensions are held by themselves."""
    zero, mu = origin(FigureStrokes(part))
    ink, symbol = parts.inventory(shaft.NAME, part), by.hand.symbol
    parts.headed(ink, by.word("view across"), [parts.scale(mu, "l", "m", by)])
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


def _layout(part: Group, expected: Expected, by: Drafting, found: Compensator) -> Iterator[Wrong]:
    """Tick off the layout of compensators: arms, masses and senses with their letters; sizes are held by themselves."""
    strokes = FigureStrokes(part)
    zero, mu = origin(strokes)
    ink, symbol = parts.inventory(part.name, part), by.hand.symbol
    nominal = [by.word("arms nominal")] if any(by.word("arms nominal") in text for text in strokes.texts) else []
    carried = expected.carried(found)
    own = {} if carried else {"order": found.asked.order}
    title = by.word("compensator of order" if own else "counterweight on crank", **own)
    parts.headed(ink, title, [parts.scale(mu, "l", "m", by), *nominal])
    parts.spot(ink, zero, ZERO, ZERO)
    masses = [one for one in strokes.circles if one.style.fill == "#000000"]
    for body in expected.bodies(found):
        name, wrong = lowered(body.name), on("mass", part.name, name=body.name)
        text = next((one for one in ink.left(Text) if one.plain == read(name)), None)
        near = [one for one in masses if text is not None and ink.beside(text, [one.centre])]
        mass = next(iter(near or masses), None)
        if mass is None:
            ink.wrong.append(wrong)
            continue
        masses.remove(mass)
        ink.circle(mass.centre, wrong, mass.radius)
        ink.letter(read(name), [mass.centre], wrong)
        arm = ink.take(Line, partial(_ends, at=mass.centre), wrong)
        if arm is not None:
            _on_shaft(ink, arm.start, 1 if body.turns * expected.task.speed > 0 else -1, speed(body.turns))
            if not body.coupled and not carried:
                ink.take(Circle, partial(_about, at=arm.start), on("circle", part.name, name=name))
    if expected.directed(found):
        _axes(ink, zero, expected.line(found), 1 if carried or not found.asked.offset else 2)
    else:
        ink.every(Line, lambda one: True)
    _dimensions(ink, part, symbol)
    yield from ink.faults()


def _on_shaft(ink: Inventory, at: complex, sense: int, letter: str) -> None:
    _turning(ink, at, sense, letter)
    smallest = min((one.radius for one in ink.left(Circle) if abs(one.centre - at) <= parts.NEAR), default=0.0)
    ink.circle(at, on("circle", ink.plan, name=letter), smallest)


def _ends(one: Line, at: complex) -> bool:
    return abs(one.end - at) <= parts.NEAR


def _about(one: Circle, at: complex) -> bool:
    return abs(one.centre - at) <= parts.NEAR


def _axes(ink: Inventory, zero: complex, way: complex, count: int) -> None:
    """Tick off the line of the force through the shaft of the crank, and that of the compensators beside it."""
    for _ in range(count):
        ink.take(Line, partial(_along, zero=zero, way=way), on("line", ink.plan))


def _along(one: Line, zero: complex, way: complex) -> bool:
    start, end = (one.start - zero) / way, (one.end - zero) / way
    return abs(start.imag - end.imag) <= parts.NEAR + LINE * abs(end - start) and start.real < 0 < end.real


def _dimensions(ink: Inventory, part: Group, symbol: float) -> None:
    """Leave the dimensions aside, which are held by themselves: their lines, heads and texts."""
    texts = [one for one in ink.left(Text) if one.plain.startswith(("z = ", "L = "))]
    heads = ink.every(Fill, lambda one: True) if texts else []
    for text in texts:
        ink.text(text.plain)
    if texts:
        ink.every(Line, lambda one: True)
    if len(heads) != 2 * len(texts):
        ink.wrong.append(on("head", ink.plan, name="z, L"))
