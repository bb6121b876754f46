"""Strokes: the plain drawables of paper, in millimetres, x to the right and y up from the sheet's lower left corner.

A point is a complex number. Strokes know nothing of SVG: a pen turns them into a format, and turns y there, once.
"""

import cmath
import math
import re
from collections.abc import Mapping
from decimal import Decimal
from enum import StrEnum
from functools import lru_cache
from typing import Any, Literal, NamedTuple, TypeAlias

from drawings.paper.limits import STATED_DIGITS
from geometry.curve import Piece
from geometry.errors import DraftError


class Kind(StrEnum):
    """The kinds of statements; each has one reader, which alone knows how a kind is drawn."""

    VECTOR = "vector"
    POINT = "point"
    CURVE = "curve"
    LENGTH = "length"
    ANGLE = "angle"
    DIRECTION = "direction"
    NUMBER = "number"
    LETTER = "letter"
    AXIS = "axis"
    PHRASE = "phrase"


Key: TypeAlias = tuple[Kind, str, str, int | None]


class Statement(NamedTuple):
    """What ink states: its key, and how much of the true unit a millimetre of it is worth, where it is to scale.

    `figure` is the name of a plan, a graph, a table; `name` that of the vector, the row, the point.
    """

    kind: Kind
    figure: str
    name: str
    position: int | None = None
    scale: float = 0.0

    @property
    def key(self) -> Key:
        """What is stated of whom; a sheet states it once."""
        return self[:4]


# Share of the size: how far the line of writing of a subscript or a superscript is lowered or raised.
LOWERED, RAISED = 0.25, 0.4
# Slanted letters stand at 75 degrees to their line (GOST 2.304-81).
LEAN = math.tan(math.radians(15))
TURN = 2 * math.pi

Box: TypeAlias = tuple[float, float, float, float]
Anchor: TypeAlias = Literal["start", "middle", "end"]


class SheetError(DraftError, ValueError):
    """A sheet that cannot be laid out, written or verified."""


class LineStyle(NamedTuple):
    """How a stroke is drawn: width and dash in mm, colour and fill as "#rrggbb" or "none", its ends, its corners."""

    width: float = 0.5
    dash: tuple[float, ...] = ()
    colour: str = "#000000"
    fill: str = "none"
    cap: Literal["butt", "round"] = "butt"
    join: str = "round"  # a pen draws all its corners so


PLAIN = LineStyle()
INK = LineStyle(width=0, colour="none", fill="#000000")
NO_DATA: Mapping[str, Any] = {}
GIVEN = "given"  # the kind of a figure of a form that is a part of its task: no line of it is a student's


class Line(NamedTuple):
    """A straight line from `start` to `end`."""

    start: complex
    end: complex
    style: LineStyle = PLAIN


class Polyline(NamedTuple):
    """A chain of straight lines through `points`; a closed one returns to the first."""

    points: tuple[complex, ...]
    closed: bool = False
    style: LineStyle = PLAIN


class Arc(NamedTuple):
    """An arc drawn counter-clockwise from `start_angle` to `end_angle` (rad), raised by whole turns if it is less."""

    centre: complex
    radius: float
    start_angle: float
    end_angle: float
    style: LineStyle = PLAIN

    @property
    def sweep(self) -> float:
        """The angle drawn, from 0 to a whole turn."""
        sweep = self.end_angle - self.start_angle
        return sweep if 0 <= sweep <= TURN else sweep % TURN

    def at(self, share: float) -> complex:
        """Give the point after a share (0 to 1) of the sweep."""
        return self.centre + cmath.rect(self.radius, self.start_angle + share * self.sweep)


class Circle(NamedTuple):
    """A whole circle."""

    centre: complex
    radius: float
    style: LineStyle = PLAIN


class Fill(NamedTuple):
    """A filled polygon that does not cross itself: an arrowhead, a dot of a hinge."""

    points: tuple[complex, ...]
    style: LineStyle = INK


class Curve(NamedTuple):
    """A curve of cubics and arcs, each piece of which begins where the last one ends; a closed one comes back."""

    pieces: tuple[Piece, ...]
    closed: bool = False
    style: LineStyle = PLAIN


class Run(NamedTuple):
    """A piece of lettering on one line of writing: level 0 on it, -1 a subscript, +1 a superscript."""

    text: str
    level: int = 0


class Text(NamedTuple):
    """Lettering of `size` mm that starts, is centred or ends at a point; a string is marked up, runs stay as they are.

    In a string `_` lowers and `^` raises the next character or braced group; a backslash takes the next one as it is.
    """

    at: complex
    content: str | tuple[Run, ...]
    size: float = 3.5
    anchor: Anchor = "start"
    slanted: bool = False
    rotation: float = 0.0
    style: LineStyle = INK

    @property
    def runs(self) -> tuple[Run, ...]:
        """The lettering as runs."""
        return runs(self.content) if isinstance(self.content, str) else self.content

    @property
    def plain(self) -> str:
        """The lettering without its levels, as it is read aloud."""
        return _joined(self.content)


class Group(NamedTuple):
    """Strokes that belong together; `data` tells what they are and is written as data- attributes.

    Kinds that can be measured ("vector", "point", "pole", "corner", "profile") carry their data on their first stroke,
    a Line for a vector, a Curve for a profile, a Circle for the others; every other kind carries them on the group.
    What a group `states` is no part of a file: one that does nothing but state is written as its strokes alone.
    """

    strokes: "tuple[Stroke, ...]"
    name: str = ""
    data: Mapping[str, str] = NO_DATA
    title: str = ""
    states: Statement | None = None


Stroke: TypeAlias = Line | Polyline | Arc | Circle | Fill | Curve | Text | Group


class Leaf(NamedTuple):
    """A whole sheet ready for a pen: size in mm, groups from back to front, and the JSON-able description."""

    width: float
    height: float
    groups: tuple[Group, ...]
    title: str = ""
    description: str = ""
    metadata: Mapping[str, Any] = NO_DATA
    lettering: str = "text"  # "strokes" of our own alphabet, or "text" in the fonts of the viewer
    cramped: tuple[str, ...] = ()  # figures too small for their letters, which is told and not written


@lru_cache(maxsize=4096)
def _joined(content: str | tuple[Run, ...]) -> str:
    return "".join([run.text for run in (runs(content) if isinstance(content, str) else content)])


_MARKUP = re.compile(r"([_^])(?:\{([^{}]*)\}|([^{}\\_^]))|\\(.)|([^_^\\{}]+)", re.DOTALL)


@lru_cache(maxsize=1024)
def runs(markup: str) -> tuple[Run, ...]:
    r"""Read lettering marked up with `_` and `^`.

    >>> runs("a^n_{BA}")
    (Run(text='a', level=0), Run(text='n', level=1), Run(text='BA', level=-1))
    >>> runs(r"snake\_case")
    (Run(text='snake_case', level=0),)
    """
    pieces: list[Run] = []
    place = 0
    while place < len(markup):
        match = _MARKUP.match(markup, place)
        if match is None:
            raise SheetError(
                f"lettering {markup!r}: {markup[place]!r} at {place} opens nothing; write it as \\{markup[place]}"
            )
        mark, braced, single, escaped, text = match.groups()
        level = {"_": -1, "^": 1}.get(mark, 0)
        piece = braced if braced is not None else single or escaped or text
        if pieces and pieces[-1].level == level:
            piece = pieces.pop().text + piece
        pieces.append(Run(piece, level))
        place = match.end()
    return tuple(pieces)


def numeral(value: float) -> str:
    """Write a number of a sheet's data: 12 significant digits, no exponent, no -0.

    >>> numeral(-0.0), numeral(1.5e-7), numeral(1 / 3), numeral(2e6)
    ('0', '0.00000015', '0.333333333333', '2000000')
    """
    if not math.isfinite(value):
        raise SheetError(f"{value} cannot be written: a gap must be said in words")
    if value == 0:
        return "0"
    digits = format(Decimal(f"{value:.{STATED_DIGITS - 1}e}"), "f")
    return digits.rstrip("0").rstrip(".") if "." in digits else digits


def stated(value: complex) -> str:
    """Write a vector's or a point's true value for its data: "x y".

    >>> stated(0.5 - 2j)
    '0.5 -2'
    """
    return f"{numeral(value.real)} {numeral(value.imag)}"
