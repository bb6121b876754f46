"""Readers: what ink states, read off it; they alone know how a kind of statement is drawn (чтение утверждений).

A reader takes the strokes of one statement and the frame of its figure, which is itself read from ink.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Final, NamedTuple, TypeAlias, TypeGuard

import numpy as np

from drawings.checks.expected import Wrong, on
from drawings.lettering.words import WRITTEN, last_place, number, numerals
from drawings.page.frame import NUMBERS
from drawings.page.page import BLOCK
from drawings.paper.strokes import Arc, Circle, Fill, Group, Kind, Leaf, Line, Polyline, Stroke
from drawings.paper.walk import flat, groups, stated, texts
from drawings.reading.covering import corners
from drawings.reading.measure import Measured
from plans.model.motion import Complexes
from plans.scene.sheet import SheetTable
from plans.words.words import Message, message

_NUMBER = re.compile(rf"[-−]?{WRITTEN}")
PAPER = "mm"  # the unit of what is drawn in millimetres of paper, to no scale
_MARKED = ("vector", "point")  # the kinds of marks that are drawn to scale
_SCALE = re.compile(rf"(μ|K)(\S+) = ({WRITTEN})\s")  # of a plan, after its letter: mu_v, K_v


def reads(text: str, true: float, slack: float, digits: int = 0) -> bool:
    """Tell whether a text is a value to the half of its last digit, beside what the two roads may differ by.

    Of a number written with so many `digits` its end may be left off that is zero.

    >>> reads("0.096", 0.0961, 0.0), reads("0.096", 0.0961, 0.0, 5), reads("123460", 123456.0, 0.0, 5)
    (True, False, True)
    >>> reads("1.2·10⁻⁷", 1.24e-7, 0.0), reads("1.2·10⁻⁷", 1.26e-7, 0.0)
    (True, False)
    """
    if text == "—":
        return math.isnan(true)
    found = value(text)
    if found is None:
        return False
    last: float = last_place(text)
    if digits:
        last = math.floor(math.log10(abs(true))) + 1 - digits if true else -math.inf
    return abs(found - true) <= 0.5000001 * math.pow(10.0, last) + 1e-9 * abs(true) + slack


def value(text: str) -> float | None:
    """Read a number; None of what is none.

    >>> value("−0,5"), value("—"), value("1,2393·10⁻⁷")
    (-0.5, None, 1.2393e-07)
    """
    return float(numerals(text)) if _NUMBER.fullmatch(text) else None


def marked_scales(leaf: Leaf) -> Iterator[Message]:
    """Name the figures whose marks or axes are drawn to no written scale: of their letter there, else anywhere."""
    scales = [_stated((figure,)) for figure in leaf.groups]
    everywhere = set(chain(*(pairs for letters in scales for pairs in letters.values())))
    for figure, scale in zip(leaf.groups, scales, strict=True):
        tree = [*groups((figure,))]
        marks = (part.data for part in tree if part.data.get("kind") in _MARKED and part.data["unit"] != PAPER)
        drawn = {(data["quantity"], float(data["scale"])) for data in marks}
        drawn |= {("", part.states.scale) for part in tree if part.states is not None and part.states.kind is Kind.AXIS}
        for letter, mu in drawn if everywhere else ():
            stated = scale.get(letter) or everywhere
            if not any(size == numerals(number(1 / mu if symbol == "K" else mu)) for symbol, size in stated):
                yield message("wrong.scale", text=figure.name)


def _stated(figures: Iterable[Group]) -> dict[str, set[tuple[str, str]]]:
    """Read the scales that figures state: by their letters the symbol, mu or K, and the number."""
    stated: dict[str, set[tuple[str, str]]] = {}
    for symbol, letter, size in (found for text in texts(figures) for found in _SCALE.findall(text.plain)):
        stated.setdefault(letter, set()).add((symbol, numerals(size)))
    return stated


def written_scales(group: Group) -> dict[str, float]:
    """Read the scales that a figure states by their letters, true units a mm; a K is the inverse of mu, 0 is none.

    >>> from drawings.paper.strokes import Text
    >>> written_scales(Group((Text(0j, "μ_{φ} = 0,02 рад/мм;  K_M = 4 mm/(N·m);  K_A = 0 mm/J"),)))
    {'φ': 0.02, 'M': 0.25}
    """
    found = (match for text in texts((group,)) for match in _SCALE.finditer(text.plain))
    pairs = ((match[1], match[2], float(numerals(match[3]))) for match in found)
    return {letter: 1 / value if kind == "K" else value for kind, letter, value in pairs if value}


Sheets = Sequence[tuple[Mapping[str, str], Measured]]  # how names of figures begin, and their keys of [sheet.scale]

# Keys that govern an axis of graphs, with the quantities of the marks along it: the others measure ordinates.
AXES: Mapping[str, tuple[str, ...]] = {"angle": (), "way": ("S", "ψ")}


def block_faults(leaf: Leaf, sheet: SheetTable) -> Iterator[Wrong]:
    """Give what the title block says otherwise than the set: its number among the sheets of its document, its name."""
    document = leaf.metadata["document"]
    name, number, count = (document[key] for key in ("designation", "sheet", "sheets"))
    gost = [f"{number}"] * (count > 1) + [f"{count}"] * (number == 1)
    block = [group for group in groups(leaf.groups) if group.name in (BLOCK, NUMBERS)]
    numbers = [text.plain for group in block if group.name == NUMBERS for text in texts(group.strokes)]
    if numbers != (gost if sheet.standard == "GOST" else [f"{number}/{count}"]):
        yield message("wrong.sheet_number", number=number, count=count, kind=leaf.metadata["sheet"])
    if name.replace(" ", "") not in "".join(text.plain for text in texts(block)).replace(" ", ""):
        yield message("wrong.designation", name=name, kind=leaf.metadata["sheet"])


def scale_faults(sheets: Sheets, sheet: SheetTable) -> Iterator[Wrong]:
    """Give the figures of measured sheets whose marks have another scale than the scene states for them."""
    stated = dict(sheet.scale.stated)
    for keys, measured in sheets if stated else ():
        for mark in (*measured.vectors, *measured.points, *measured.profiles):
            figure = f"{mark.plan.replace(' ', '-')}-"
            key = next((key for begin, key in keys.items() if figure.startswith(begin)), "")
            if mark.quantity in AXES.get(key, (mark.quantity,)) and mark.scale != stated.get(key, mark.scale):
                yield on("scale_stated", mark.plan)


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
    scale, spot = float(pole.data["scale"]), next(spots(pole.strokes))  # of a hinge of several links two circles
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
