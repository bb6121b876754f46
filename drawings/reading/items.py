"""Items: every line, area and lettering of a sheet, where it lies, and the figures that they are of (вхождения)."""

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple, TypeAlias

from drawings.paper.strokes import Arc, Circle, Curve, Fill, Group, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import groups, texts
from drawings.reading.transform import Affine
from geometry.curve import CubicPiece, Piece
from plans.words.words import Message, message

Ink: TypeAlias = Line | Polyline | Arc | Circle | Fill | Curve | Text

TRIANGLE = 3  # corners of an arrowhead
# What a stroke is by its kind, where nothing around it says more.
_KINDS: dict[type, str] = {
    Line: "line", Polyline: "line", Arc: "arc", Circle: "circle", Fill: "area", Curve: "curve", Text: "letter",
}  # fmt: skip
# What the first stroke of a marked group is, by the group's kind.
BEARERS = {
    "vector": "vector", "point": "point", "pole": "pole", "corner": "corner", "profile": "profile",
    "force": "arrow", "couple": "couple",
}  # fmt: skip


class Home(NamedTuple):
    """Where an item stands in the tree of a sheet: its top group, and the mark that it is a part of."""

    top: int  # number of its group among those of the leaf
    figure: str = ""  # that group's name
    lettering: str = "letter"  # what lettering there is
    mark: Mapping[str, str] = MappingProxyType({})  # data of the marked group around it


class Item(NamedTuple):
    """A stroke of a sheet: what it is, the mark that it is a part of, and the number of its top group."""

    stroke: Ink
    what: str
    home: Home

    @property
    def name(self) -> str:
        """What it is called: a mark by its name, lettering by itself."""
        return self.stroke.plain if isinstance(self.stroke, Text) else self.home.mark.get("name", "")


def items(leaf: Leaf) -> list[Item]:
    """List what inks a sheet, from back to front."""
    tables = leaf.metadata.get("rows", {})
    homes = ((group, Home(top, group.name, _lettering(group, tables))) for top, group in enumerate(leaf.groups))
    return [item for group, home in homes for item in _within(group, home)]


def inside(stroke: Stroke, figure: str) -> list[Item]:
    """List what inks of a stroke by itself, or of a group, which is of a figure."""
    return list(_within(stroke if isinstance(stroke, Group) else Group((stroke,)), Home(0, figure)))


def _lettering(group: Group, tables: object) -> str:
    if isinstance(tables, Mapping) and group.name.rpartition("-")[0] in tables:
        return "cell"
    if group.name.startswith(EQUATIONS):
        return "equation"
    return {"title-block": "title_cell", "notes": "note", "frame": "title_cell"}.get(group.name, "letter")


def _within(group: Group, home: Home) -> Iterator[Item]:
    kind = group.data.get("kind", "")
    inner = home._replace(mark=group.data) if kind in BEARERS else home
    headed = home.lettering == "letter" and not group.data
    for place, stroke in enumerate(group.strokes):
        if isinstance(stroke, Group):
            heading = headed and place == 0 and is_heading(stroke)
            yield from _within(stroke, inner._replace(lettering="heading") if heading else inner)
        else:
            bears = place == 0 and kind in BEARERS
            yield Item(stroke, BEARERS[kind] if bears else _what(stroke, inner), inner)


def is_heading(group: Group) -> bool:
    """Tell whether a group is lettering alone, as a heading with its scale is."""
    return bool(group.strokes) and not group.name and all(isinstance(stroke, Text) for stroke in group.strokes)


def _what(stroke: Stroke, home: Home) -> str:
    if isinstance(stroke, Text):
        return home.lettering
    return "arrowhead" if isinstance(stroke, Fill) and len(stroke.points) == TRIANGLE else _KINDS[type(stroke)]


def spots(stroke: Ink) -> tuple[complex, ...]:
    """Give the points of a stroke, mm, which go with it wherever it is brought; of a circle its centre alone."""
    match stroke:
        case Line(start, end):
            return start, end
        case Polyline() | Fill():
            return stroke.points
        case Arc():
            return stroke.at(0.0), stroke.at(0.5), stroke.at(1.0)
        case Circle(centre):
            return (centre,)
        case Curve():
            return tuple(spot for piece in stroke.pieces for spot in _of_piece(piece))
        case Text():
            return stroke.at, stroke.at + cmath.rect(stroke.size, math.radians(stroke.rotation))


def _of_piece(piece: Piece) -> tuple[complex, ...]:
    return tuple(piece) if isinstance(piece, CubicPiece) else (piece.at(0.0), piece.at(0.5), piece.at(1.0))


def middle(stroke: Ink) -> complex:
    """Give the middle of a stroke's points; of a circle its centre, of lettering where it begins."""
    points = spots(stroke)
    return points[0] if isinstance(stroke, Circle | Text) else sum(points) / len(points)


def brought(stroke: Stroke, by: Affine) -> Stroke:
    """Give a stroke brought elsewhere by a similarity; the widths of its lines stay."""
    size, turn = abs(by.p), cmath.phase(by.p)
    match stroke:
        case Group():
            return stroke._replace(strokes=tuple(brought(inner, by) for inner in stroke.strokes))
        case Line(start, end):
            return stroke._replace(start=by(start), end=by(end))
        case Polyline() | Fill():
            return stroke._replace(points=tuple(by(point) for point in stroke.points))
        case Arc(centre, radius, first, last):
            start, end = first + turn, last + turn
            return stroke._replace(centre=by(centre), radius=radius * size, start_angle=start, end_angle=end)
        case Circle(centre, radius):
            return stroke._replace(centre=by(centre), radius=radius * size)
        case Curve():
            return stroke._replace(pieces=tuple(piece.placed(by.p, by.t) for piece in stroke.pieces))
        case Text():
            rotation = stroke.rotation + math.degrees(turn)
            return stroke._replace(at=by(stroke.at), size=stroke.size * size, rotation=rotation)


EQUATIONS = "equations-"  # begins the name of a group of workings, which has no heading
STILL = ("frame", "corners", "title-block", "notes")  # what every sheet has, by the names of its groups


class MarkScale(NamedTuple):
    """How much a millimetre of a figure stands for, and of what."""

    size: float
    unit: str


class Box(NamedTuple):
    """The rectangle that a figure takes, mm."""

    left: float
    bottom: float
    right: float
    top: float

    def off(self, spot: complex) -> tuple[float, float]:
        """Give how far outside a place lies, and the area, by which the smaller one of two figures is chosen."""
        across = max(self.left - spot.real, 0.0, spot.real - self.right)
        up = max(self.bottom - spot.imag, 0.0, spot.imag - self.top)
        return math.hypot(across, up), (self.right - self.left) * (self.top - self.bottom)


class SheetFigures:
    """The figures of a sheet as it must be: groups at the top that have a name."""

    def __init__(self, leaf: Leaf) -> None:
        self.leaf = leaf

    @cached_property
    def named(self) -> dict[str, Group]:
        """The groups with a name."""
        return {group.name: group for group in self.leaf.groups if group.name}

    @cached_property
    def boxes(self) -> dict[str, Box]:
        """The rectangles that figures take, without the frame, which is around all of them."""
        corners: dict[str, list[complex]] = {}
        for item in items(self.leaf):
            if item.home.figure not in ("", *STILL[:2]):
                corners.setdefault(item.home.figure, []).extend(spots(item.stroke))
        return {name: _box(places) for name, places in corners.items()}

    def of(self, item: Item) -> str:
        """Name the figure that an item is of: its own group, or else the one where it stands."""
        if item.home.figure or not self.boxes:
            return item.home.figure
        spot = middle(item.stroke)
        return min(self.boxes, key=lambda name: self.boxes[name].off(spot))

    def scale(self, item: Item) -> MarkScale | None:
        """Give the scale at which an item is drawn: its own mark's, or the first that is stated in its figure."""
        group = self.named.get(self.of(item))
        marks = [item.home.mark, *(part.data for part in groups((group,) if group is not None else ()))]
        return next(filter(None, (_scale(data.get("scale"), data.get("unit")) for data in marks)), None)

    def called(self, name: str) -> Message:
        """Name a figure for a message: by its heading, or by what it is."""
        if name in STILL:
            return message(f"exhibit.{name}")
        if name.rpartition("-")[0] in self.leaf.metadata.get("rows", {}):
            return message("exhibit.table", name=name)
        if name.startswith(EQUATIONS):
            return message("exhibit.equations")
        heading = self._heading(name)
        return message("exhibit.headed", title=heading) if heading else message("exhibit.other", name=name)

    def _heading(self, name: str) -> str:
        """Read the heading of a figure: the first group in it, or a group without a name before it."""
        for place, group in enumerate(self.leaf.groups):
            if group.name == name:
                before = self.leaf.groups[place - 1] if place and is_heading(self.leaf.groups[place - 1]) else None
                return next(_headings(group), "") or next(_headings(before), "")
        return ""


def _headings(group: Group | None) -> Iterator[str]:
    if group is None:
        return
    first = group if is_heading(group) else next(iter(group.strokes), None)
    if isinstance(first, Group) and is_heading(first):
        yield from (text.plain for text in first.strokes if isinstance(text, Text))
        return
    lettering = [*texts((first,) if first else ())]
    if len(lettering) > 1 and lettering[0].size > lettering[1].size:  # a title that its scale stands beside
        yield lettering[0].plain


def _box(places: list[complex]) -> Box:
    across, up = [spot.real for spot in places], [spot.imag for spot in places]
    return Box(min(across), min(up), max(across), max(up))


def _scale(size: str | None, unit: str | None) -> MarkScale | None:
    try:
        found = MarkScale(float(size or ""), unit or "")
    except ValueError:
        return None
    return found if math.isfinite(found.size) and found.size > 0 else None
