"""The SVG pen: the only place where svgwrite is imported, where y turns downward, and where numbers become text.

Neighbouring lines and arcs of one style become one path, which is what makes the pen fast; strokes of a group with data
stay one element each, so that they can be measured and moved one by one.
"""

from __future__ import annotations

import cmath
import json
import math
import re
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from itertools import groupby, pairwise
from typing import Any, TypeAlias
from xml.etree import ElementTree

from drawings.alphabet import GAP
from drawings.lettering import index_size, pen, width
from drawings.limits import FORMAT
from drawings.pens.deferred import deferred
from drawings.pens.letters import lettering
from drawings.pens.numerals import number, numbers
from drawings.seal import seal
from drawings.strokes import (
    LOWERED,
    RAISED,
    Arc,
    Circle,
    Fill,
    Group,
    Leaf,
    Line,
    LineStyle,
    Polyline,
    SheetError,
    Stroke,
    Text,
)

# A sheet fetches no fonts from the web, and its paths are not checked by svgwrite: half of its import is for these.
with deferred("urllib.request", "svgwrite.data.svgparser"):
    import svgwrite
    from svgwrite import container, path, shapes, text

# Drawing fonts first, then narrow ones: letters of the standard are narrow.
FONTS = "'GOST type B','osifont','Liberation Sans Narrow','Arial Narrow','DejaVu Sans Condensed',sans-serif"
EM = 1.4  # a font's size over the height of its capitals: 1.37 to 1.43 in the usual ones
# The kinds that are measured, and the only stroke that can stand for each.
BEARERS: dict[str, type[Line] | type[Circle]] = {"vector": Line, "point": Circle, "pole": Circle, "corner": Circle}

Attributes: TypeAlias = dict[str, str]
_Plain: TypeAlias = Line | Polyline | Arc | Fill

# A flag that is rounded with the ends decides the wrong half of a large arc; a quarter turn leaves no doubt.
_QUARTER = math.pi / 2
# An arc's flags stand as one letter in a template, so that every zero before a gap there is a needless decimal.
_FLAGS = ("F", "0 0 0 ")
_ILLEGAL = re.compile("[^\t\n\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_NAME = re.compile(r"[^\W\d][\w.-]*")
_DATA = re.compile(r"[a-z][a-z0-9-]*")
_RESERVED = ("sheet", "seal")
# svgwrite gives an element its maker's settings; without a maker it would set up a validator for each.
_UNCHECKED = container.Group(debug=False)


def svg(leaf: Leaf) -> bytes:
    """Draw a sheet: the same leaf gives the same bytes on every run."""
    root = _drawing(leaf).get_xml()
    _describe(root, leaf)
    for part in root:
        part.tail = "\n"
    root.text = "\n"
    drawn = '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode")
    body = drawn.removesuffix("</svg>").encode("utf-8")
    return body + seal(body, sum(1 for _ in root.iter()))


def legal(text: str) -> str:
    """Pass text on if XML can carry it unchanged; control characters and halves of characters are refused."""
    if found := _ILLEGAL.search(text):
        raise SheetError(f"{text!r}: the character {found[0]!r} at {found.start()} cannot be written")
    return text


def _drawing(leaf: Leaf) -> Any:
    width, height = number(leaf.width), number(leaf.height)
    if not (leaf.width > 0 and leaf.height > 0):
        raise SheetError(f"a sheet of {width} x {height} mm has no room")
    drawing = svgwrite.Drawing(size=(f"{width}mm", f"{height}mm"), viewBox=f"0 0 {width} {height}", debug=False)
    drawing.elements.clear()  # an empty <defs>, which we never use
    for group in leaf.groups:
        drawing.add(_group(group, leaf))
    _own_ids(leaf.groups)
    return drawing


def _describe(root: ElementTree.Element, leaf: Leaf) -> None:
    try:
        described = json.dumps({**leaf.metadata, "format": FORMAT}, sort_keys=True, ensure_ascii=False, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise SheetError(f"the sheet's description cannot be written: {error}") from error
    for place, (tag, content) in enumerate(
        (("title", leaf.title), ("desc", leaf.description), ("metadata", described))
    ):
        element = ElementTree.Element(tag, {"id": "sheet"} if tag == "metadata" else {})
        element.text = legal(content)
        root.insert(place, element)


def _own_ids(groups: Iterable[Group]) -> None:
    seen = set(_RESERVED)
    for name in _names(groups):
        if not _NAME.fullmatch(name):
            raise SheetError(f"{name!r} cannot name a group: a letter, then letters, digits, '_', '-', '.'")
        if name in seen:
            raise SheetError(f"two groups of a sheet are named {name!r}")
        seen.add(name)


def _names(groups: Iterable[Group]) -> Iterator[str]:
    for group in groups:
        if group.name:
            yield group.name
        yield from _names(inner for inner in group.strokes if isinstance(inner, Group))


def _group(group: Group, leaf: Leaf) -> Any:
    data = _data(group)
    bearer = BEARERS.get(group.data.get("kind", ""))
    own = {"id": legal(group.name)} if group.name else {}
    if "kind" in group.data:
        own["class"] = legal(group.data["kind"])
    element = _element(container.Group, own if bearer else own | data)
    if group.title:
        element.set_desc(title=legal(group.title))
    parts = [_one(stroke, leaf) for stroke in group.strokes] if data else list(_merged(group.strokes, leaf))
    if bearer:
        if not (group.strokes and isinstance(group.strokes[0], bearer)):
            raise SheetError(
                f"a {group.data['kind']} begins with a {bearer.__name__}, which is what is measured: {data}"
            )
        parts[0].attribs.update(data)
    element.elements.extend(parts)
    return element


def _data(group: Group) -> Attributes:
    for key in group.data:
        if not _DATA.fullmatch(key):
            raise SheetError(f"{key!r} cannot name data: small letters, digits, '-'")
    return {f"data-{key}": legal(value) for key, value in group.data.items()}


def _merged(strokes: Iterable[Stroke], leaf: Leaf) -> Iterator[Any]:
    for kind, run in groupby(strokes, _mergeable):
        if kind is None:
            yield from (_one(stroke, leaf) for stroke in run)
        else:
            yield _path((stroke for stroke in run if isinstance(stroke, _Plain)), kind[0], leaf.height)


def _mergeable(stroke: Stroke) -> tuple[LineStyle, bool] | None:
    """Outlines of one style can be one path, and so can fills; a filled outline must go on hiding what it hides."""
    match stroke:
        case Fill():
            return stroke.style, True
        case Line() | Polyline() | Arc() if stroke.style.fill == "none":
            return stroke.style, False
    return None


def _path(strokes: Iterable[_Plain], style: LineStyle, height: float) -> Any:
    template: list[str] = []
    values: list[float] = []
    for stroke in strokes:
        _trace(stroke, height, template, values)
    element = _element(path.Path, dict(_style(style)))
    element.commands = [numbers("".join(template), values).replace(*_FLAGS)]
    return element


def _trace(stroke: _Plain, height: float, template: list[str], values: list[float]) -> None:
    """Add a stroke to a path: the form of its commands and its coordinates, y turned."""
    match stroke:
        case Line(start, end):
            template.append("M%s %sL%s %s")
            values += (start.real, height - start.imag, end.real, height - end.imag)
        case Polyline(points, closed):
            template.append("M%s %s" + "L%s %s" * (len(points) - 1) + "Z" * closed)
            for point in points:
                values += (point.real, height - point.imag)
        case Fill(points):
            _trace(Polyline(_counter_clockwise(points), closed=True), height, template, values)
        case Arc():
            pieces = max(1, math.ceil(stroke.sweep / _QUARTER))
            template.append("M%s %s" + "A%s %s F%s %s" * pieces)
            values += (stroke.at(0).real, height - stroke.at(0).imag)
            for piece in range(1, pieces + 1):
                end = stroke.at(piece / pieces)
                values += (stroke.radius, stroke.radius, end.real, height - end.imag)


def _counter_clockwise(points: tuple[complex, ...]) -> tuple[complex, ...]:
    """Fills of one path that turn one way cover each other where they overlap; else they would make holes."""
    doubled_area = sum((a.conjugate() * b).imag for a, b in pairwise((*points, points[0])))
    return points if doubled_area >= 0 else points[::-1]


def _one(stroke: Stroke, leaf: Leaf) -> Any:
    """Draw one stroke as one element."""
    height = leaf.height
    match stroke:
        case Line(start, end, style):
            return _element(
                shapes.Line, _at(("x1", "y1"), start, height) | _at(("x2", "y2"), end, height) | _style(style)
            )
        case Circle(centre, radius, style):
            return _element(shapes.Circle, _at(("cx", "cy"), centre, height) | {"r": number(radius)} | _style(style))
        case Polyline() | Arc() | Fill():
            return _path((stroke,), stroke.style, height)
        case Text():
            return _letters(stroke, height) if leaf.lettering == "strokes" else _text(stroke, height)
        case Group():
            return _group(stroke, leaf)


def _letters(stroke: Text, height: float) -> Any:
    """Write a text as one path, or as a group of one for each width of the pen; either says what is written."""
    data = {"data-text": legal(stroke.plain)}
    paths = []
    for unit, commands in lettering(stroke, height).items():
        paths.append(_element(path.Path, dict(_style(pen(unit, stroke.style)))))
        paths[-1].commands = [commands]
    if len(paths) == 1:
        paths[0].attribs.update(data)
        return paths[0]
    group = _element(container.Group, data)
    group.elements.extend(paths)
    return group


def _text(stroke: Text, height: float) -> Any:
    """Leave a text to the viewer's fonts, as long as our own alphabet would write it where the viewer can do that.

    A font keeps half of the gap between letters free at either end.
    """
    plain, free = legal(stroke.plain), GAP / 2 * stroke.size / 10
    before = {"start": -free, "middle": 0.0, "end": free}[stroke.anchor]
    place = _at(("x", "y"), stroke.at + before * cmath.rect(1, math.radians(stroke.rotation)), height)
    own = place | {"font-family": FONTS, "font-size": number(EM * stroke.size), "data-text": plain, "aria-label": plain}
    if length := width(stroke):
        own |= {"textLength": number(round(length + 2 * free, 2)), "lengthAdjust": "spacingAndGlyphs"}
    if stroke.anchor != "start":
        own["text-anchor"] = stroke.anchor
    if stroke.slanted:
        own["font-style"] = "italic"
    if stroke.rotation:
        own["transform"] = f"rotate({number(-stroke.rotation)} {place['x']} {place['y']})"
    element = _element(text.Text, own | _style(stroke.style))
    element.text = ""
    level = 0
    for run in stroke.runs:
        if run.level == 0 and not element.elements:
            element.text = run.text
        else:
            element.elements.append(_span(run.text, run.level, _rise(run.level) - _rise(level), stroke.size))
        level = run.level
    return element


def _rise(level: int) -> float:
    return {-1: -LOWERED, 0: 0.0, 1: RAISED}[level]


def _span(content: str, level: int, rise: float, size: float) -> Any:
    """Levels are shifted by dy: half of the viewers ignore baseline-shift."""
    own = {} if rise == 0 else {"dy": number(-rise * size)}
    if level:
        own["font-size"] = number(EM * index_size(size))
    element = _element(text.TSpan, own)
    element.text = content
    return element


def _at(names: tuple[str, str], point: complex, height: float) -> Attributes:
    across, down = numbers("%s %s", (point.real, height - point.imag)).split()
    return {names[0]: across, names[1]: down}


@lru_cache(maxsize=256)
def _style(style: LineStyle) -> Attributes:
    own = {"fill": legal(style.fill), "stroke": legal(style.colour)}
    if style.colour != "none":
        own |= {"stroke-width": number(style.width), "stroke-linejoin": "round"}
    if style.cap != "butt":
        own["stroke-linecap"] = legal(style.cap)
    if style.dash:
        own["stroke-dasharray"] = numbers(",".join(["%s"] * len(style.dash)), style.dash)
    return own


def _element(kind: Callable[..., Any], attributes: Attributes) -> Any:
    """Make an svgwrite element with our attributes only: its own checks are slow, and pass NaN."""
    element = kind("", factory=_UNCHECKED) if kind in (text.Text, text.TSpan) else kind(factory=_UNCHECKED)
    element.attribs = attributes
    return element
