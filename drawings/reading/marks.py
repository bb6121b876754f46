"""Marks of a sheet: where each that can be measured is drawn, and what it is in true units (знаки листа)."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from drawings.paper.limits import SheetRefused
from drawings.reading.pathdata import Spots, centre, curve, number, numbers, trace
from drawings.reading.transform import Affine, Viewport
from drawings.reading.visibility import Look, Said
from plans.words.words import Message, message


class Nest:
    """What an open element hands to those inside: its map to paper, its look, and why a mark in it is refused.

    `said` are its own attributes that may tell of its look. Elements that are alike in all this share one frame.
    """

    __slots__ = ("look", "refusal", "said", "tag", "to_paper")

    def __init__(self, tag: str, to_paper: Affine, look: Look, refusal: Message | None, said: Said = ()) -> None:
        self.tag, self.to_paper, self.look, self.refusal, self.said = tag, to_paper, look, refusal, said


class Witness(Protocol):
    """Who looks on while a sheet is read, element by element, within the reader's limits."""

    def opened(self, attributes: Mapping[str, str]) -> Viewport:
        """Give the paper that a root lays what is drawn on."""

    def enter(self, frame: Nest, attributes: Mapping[str, str]) -> None:
        """See an element begin; one that is no SVG has no tag."""

    def hear(self, text: str) -> None:
        """Take the characters within the innermost element."""

    def leave(self) -> None:
        """See the innermost element end."""


KINDS = ("vector", "point", "pole", "corner", "profile")
LINES = ("vector", "profile")  # kinds that are seen by their lines alone
NAMES = ("quantity", "name", "position")  # that tell a mark of a plan from its others
_PREFIX = "data-"
LONGEST = 60  # letters of a name that are told


class SheetMark(NamedTuple):
    """A marked element: its data without "data-", and its two ends or its centre on paper (mm, y up).

    Of a profile its points are those of its pieces one after another; `parts` says how many each has.
    """

    kind: str
    data: Mapping[str, str]
    points: tuple[complex, ...]
    parts: tuple[int, ...] = ()

    @property
    def who(self) -> Message:
        """What to call it in a message."""
        return called(self.data)


def called(data: Mapping[str, str]) -> Message:
    """Name a mark by its data, for a message.

    >>> str(called({"kind": "vector", "plan": "velocities", "name": "v_B", "position": "3", "unit": "m/s"}))
    'vector v_B 3 (velocities)'
    """
    kind, plan = data.get("kind", ""), data.get("plan", "")[:LONGEST]
    names = " ".join(part for name in NAMES if (part := data.get(name, "")[:LONGEST]))
    if not plan:
        return message("unreadable.bare_mark", kind=kind, names=names)
    return message("unreadable.mark", kind=kind, names=names, plan=plan)


def marked(attributes: Mapping[str, str]) -> dict[str, str]:
    """Give the data of an element that is a mark."""
    return {name.removeprefix(_PREFIX): text for name, text in attributes.items() if name.startswith(_PREFIX)}


def drawn(kind: str, tag: str, attributes: Mapping[str, str]) -> list[Spots]:
    """Give the ends of a vector, the centre of a round mark, or the pieces of a profile, in the element's own place."""
    if kind == "profile":
        return curve(attributes.get("d", ""))
    return [_ends(tag, attributes) if kind == "vector" else (_middle(tag, attributes),)]


def _ends(tag: str, attributes: Mapping[str, str]) -> tuple[complex, ...]:
    points: tuple[complex, ...] = ()
    if tag == "line":
        return at(attributes, "x1", "y1"), at(attributes, "x2", "y2")
    if tag in ("polyline", "polygon"):
        flat = numbers(attributes.get("points", ""))
        points = tuple(map(complex, flat[::2], flat[1::2])) if len(flat) % 2 == 0 else ()
    elif tag == "path":
        followed = trace(attributes.get("d", ""))
        points = followed.points if followed.straight else ()
    if len(points) != 2:
        raise SheetRefused("straight", tag=tag[:40])
    return points


def _middle(tag: str, attributes: Mapping[str, str]) -> complex:
    if tag in ("circle", "ellipse"):
        return at(attributes, "cx", "cy")
    middle = centre(trace(attributes.get("d", ""))) if tag == "path" else None
    if middle is None:
        raise SheetRefused("circle", tag=tag[:40])
    return middle


def at(attributes: Mapping[str, str], across: str, down: str) -> complex:
    """Give the place that two attributes of an element say."""
    return complex(number(attributes.get(across, "0")), number(attributes.get(down, "0")))


class MarkKey(NamedTuple):
    """What a vector or point is called."""

    plan: str
    quantity: str
    name: str
    position: int | None = None


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredMark:
    """A mark of a sheet: what it is called, its value by measurement and as stated, in true units."""

    plan: str
    quantity: str
    name: str
    position: int | None
    value: complex
    stated: complex
    unit: str
    scale: float

    @property
    def key(self) -> MarkKey:
        """What it is called."""
        return MarkKey(self.plan, self.quantity, self.name, self.position)


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredVector(MeasuredMark):
    """A vector: its ends on the sheet (mm, y up)."""

    start: complex
    end: complex

    @property
    def reach(self) -> float:
        """How far from the sheet's corner its ends are (mm), which its rounding is a share of."""
        return abs(self.start) + abs(self.end)


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredPoint(MeasuredMark):
    """A point: its place on the sheet (mm, y up); its value is measured from the pole."""

    at: complex

    @property
    def reach(self) -> float:
        """How far from the sheet's corner it is (mm), which its rounding is a share of."""
        return abs(self.at)
