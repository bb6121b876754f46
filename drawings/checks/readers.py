"""Readers: what ink states, read off it; they alone know how a kind of statement is drawn (чтение утверждений).

A reader takes the strokes of one statement and the frame of its figure, which is itself read from ink.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Final, NamedTuple, TypeAlias, TypeGuard

import numpy as np

from drawings.paper.statement import Kind
from drawings.paper.strokes import Arc, Circle, Fill, Group, Leaf, Line, Polyline, Stroke
from drawings.paper.walk import flat, groups, stated, texts
from drawings.reading.covering import corners
from plans.model.motion import Complexes

ACROSS, UP = "x", "y"  # the names of the axes of a graph
ZERO = "zero"  # that of a mark from which the places of a figure are told
Place: TypeAlias = tuple[str, str | None]  # a figure, and the position that it is of


class Frame(NamedTuple):
    """Where the values of a graph lie on paper: its zero, mm; a mm along each axis, and what it is worth."""

    zero: complex
    along: complex
    rise: complex
    across: float
    up: float

    def true(self, spots: Complexes) -> Complexes:
        """Give the true values x + iy of places on paper."""
        off = spots - self.zero
        area = (self.along.conjugate() * self.rise).imag
        x = (off.conjugate() * self.rise).imag / area
        y = (self.along.conjugate() * off).imag / area
        found: Complexes = x * self.across + 1j * y * self.up
        return found


class Read(NamedTuple):
    """What is read of one statement: a value, and of what is drawn to scale the worth of a mm."""

    value: complex | float | str | Complexes
    scale: float = 0.0
    up: float = 0.0


def frames(leaf: Leaf) -> Mapping[Place, Frame]:
    """Read the frames of all figures: of graphs off the lines of their axes, which cross in zero, else off a mark."""
    found = {(group.data["plan"], group.data.get("position")): _about(group) for group in _poles(leaf) if group.strokes}
    axes: dict[str, dict[str, tuple[Line, float]]] = {}
    for group in stated(leaf.groups):
        if group.states is not None and group.states.kind is Kind.AXIS and group.states.name == ZERO:
            (_, figure, _, position), mu = group.states.key, group.states.scale
            at = None if position is None else str(position)
            for spot in spots(group.strokes):
                found[figure, at] = Frame(spot, 1 + 0j, 1j, mu, mu)
        elif group.states is not None and group.states.kind is Kind.AXIS:
            for line in (stroke for stroke in flat((group,)) if isinstance(stroke, Line)):  # none on a forged sheet
                axes.setdefault(group.states.figure, {})[group.states.name] = line, group.states.scale
    graphs = {(figure, None): sides for figure, sides in axes.items() if sides.keys() == {ACROSS, UP}}
    return found | {place: _frame(sides[ACROSS], sides[UP]) for place, sides in graphs.items()}


def _poles(leaf: Leaf) -> Iterator[Group]:
    return (group for group in groups(leaf.groups) if group.data.get("kind") == "pole")


def _about(pole: Group) -> Frame:
    """Read the frame about a pole, which says of which true place it is."""
    scale, (spot,) = float(pole.data["scale"]), spots(pole.strokes)
    x, y = map(float, pole.data["value"].split())
    return Frame(spot - complex(x, y) / scale, 1 + 0j, 1j, scale, scale)


def _frame(across: tuple[Line, float], up: tuple[Line, float]) -> Frame:
    (level, x), (upright, y) = across, up
    along, rise = (_way(line.end - line.start) for line in (level, upright))
    off = upright.start - level.start
    share = (off.conjugate() * rise).imag / (along.conjugate() * rise).imag
    return Frame(level.start + share * along, along, rise, x, y)


def _way(run: complex) -> complex:
    return run / abs(run)


def read(group: Group, frame: Frame | None) -> Read:
    """Read what a group states."""
    assert group.states is not None
    found = READERS[group.states.kind](group, frame)
    scale = group.states.scale or (frame.across if frame is not None else 0.0)
    return Read(found, scale, frame.up if frame is not None else scale)


def _vector(group: Group, frame: Frame | None) -> complex:
    line = next(stroke for stroke in flat((group,)) if isinstance(stroke, Line))
    return (line.end - line.start) * _scale(group)


def _point(group: Group, frame: Frame | None) -> complex:
    spot = next(iter(spots((group,))))
    return complex(frame.true(np.array([spot]))[0]) if frame is not None else spot * _scale(group)


def _curve(group: Group, frame: Frame | None) -> Complexes:
    places: Complexes = np.array([spot for stroke in flat((group,)) for spot in corners(stroke)], dtype=np.complex128)
    return np.asarray(places * _scale(group)) if frame is None else frame.true(places)


def _length(group: Group, frame: Frame | None) -> float:
    """Read a dimension between the tips of its two arrows, or the length of a line without any."""
    tips = [_head(stroke.points)[0] for stroke in flat((group,)) if _is_head(stroke)]
    return abs(tips[1] - tips[0]) * _scale(group) if len(tips) == 2 else abs(_vector(group, frame))


def _angle(group: Group, frame: Frame | None) -> float:
    """Read how far arcs about a centre go, to the tips of their arrows."""
    strokes = [*flat((group,))]
    arcs = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    about, heads = arcs[0].centre, [_head(stroke.points) for stroke in strokes if _is_head(stroke)]
    swept = sum(abs(cmath.phase((tip - about) / (back - about))) for tip, back in heads)
    swept += sum(arc.sweep for arc in arcs)
    if len(heads) != 2:
        return swept
    turned = abs(cmath.phase((heads[1][0] - about) / (heads[0][0] - about)))
    return min((turned, math.tau - turned), key=lambda angle: abs(angle - swept))


def _direction(group: Group, frame: Frame | None) -> complex:
    """Read the way of a straight arrow, a unit vector, or the sense of a bent one, 1 or -1, off its head."""
    strokes = [*flat((group,))]
    tip, back = next(_head(ink.points) for ink in strokes if isinstance(ink, Fill | Polyline) and len(ink.points) == 3)
    arc = next((stroke for stroke in strokes if isinstance(stroke, Arc)), None)
    if arc is None:
        return _way(tip - back)
    return complex(math.copysign(1.0, ((back - arc.centre).conjugate() * (tip - arc.centre)).imag))


def _is_head(stroke: Stroke) -> TypeGuard[Fill]:
    return isinstance(stroke, Fill) and len(stroke.points) == 3


def _head(points: tuple[complex, ...]) -> tuple[complex, complex]:
    """Give the tip of an arrowhead and the middle of its back: the tip is the corner furthest from the two others."""
    far = [abs(2 * corner - sum(points) + corner) for corner in points]
    tip = points[far.index(max(far))]
    return tip, (sum(points) - tip) / 2


def _written(group: Group, frame: Frame | None) -> str:
    return " ".join(text.plain for text in texts((group,)))


def _scale(group: Group) -> float:
    assert group.states is not None
    return group.states.scale or 1.0


def spots(strokes: Sequence[Stroke]) -> Iterator[complex]:
    """Give the places of the marks among strokes: the centres of circles, else the ends of lines."""
    ink = [*flat(strokes)]
    circles = [stroke.centre for stroke in ink if isinstance(stroke, Circle)]
    yield from circles or [end for stroke in ink for end in corners(stroke)]


READERS: Final[Mapping[Kind, Callable[[Group, Frame | None], complex | float | str | Complexes]]] = {
    Kind.VECTOR: _vector,
    Kind.POINT: _point,
    Kind.CURVE: _curve,
    Kind.LENGTH: _length,
    Kind.ANGLE: _angle,
    Kind.DIRECTION: _direction,
    Kind.NUMBER: _written,
    Kind.LETTER: _written,
    Kind.PHRASE: _written,
}
