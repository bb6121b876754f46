"""The SVG pen: the only place where svgwrite is imported.

Neighbouring lines and arcs of one style become one path, which is what makes the pen fast; strokes of a group with data
stay one element each, so that they can be measured and moved one by one.
"""

from __future__ import annotations

import cmath
import json
import math
import re
import sys
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache, lru_cache
from importlib import import_module
from itertools import groupby
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias
from xml.etree import ElementTree

from drawings.lettering.alphabet import GAP
from drawings.lettering.lettering import index_size, pen, text_width
from drawings.paper.limits import FORMAT
from drawings.paper.strokes import (
    LOWERED,
    RAISED,
    Arc,
    Circle,
    Curve,
    Fill,
    Group,
    Leaf,
    Line,
    LineStyle,
    Polyline,
    Run,
    SheetError,
    Stroke,
    Text,
)
from drawings.paper.walk import groups as within
from drawings.paper.walk import tied, unstated
from drawings.pens.paths import Plain, commands, curve, lettering, number, numbers
from drawings.reading.seal import seal

# Drawing fonts first, then the one whose advances are known: librsvg sets it as long as it must be.
FONTS = "'GOST type B','osifont','DejaVu Sans',sans-serif"
EM = 1.4  # a font's size over the height of its capitals: 1.37 to 1.43 in the usual ones
WIDEST = Path(__file__).parent / "advances.json"  # of DejaVu Sans, one of the widest
_RISES = {-1: -LOWERED, 1: RAISED}  # of levels, in sizes
SURE = 9  # decimals of a place, mm, that all processors agree on: one on the edge of the last written stays there
THOUSAND = 1000  # parts of a font's size in which its advances are counted


def pieces(text: Text) -> Iterator[Text]:
    """Take a text apart by its levels, each piece from where our own alphabet would write it, without spaces around it.

    librsvg is mistaken about how long a narrowed text is: where its middle lies, and where it goes on after a level.

    >>> from drawings.paper.strokes import Text
    >>> [(one.plain, one.size) for one in pieces(Text(0j, "v_{BA} = 2", 5.0))]
    [('v', 5.0), ('BA', 3.5), ('= 2', 5.0)]
    """
    turn = cmath.rect(1, math.radians(text.rotation))
    start = text.at - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.anchor] * text_width(text) * turn
    for k, (plain, level) in enumerate(text.runs):
        if not plain.strip():
            continue
        size, rise = (index_size(text.size), _RISES[level] * text.size) if level else (text.size, 0.0)
        piece = text._replace(content=(Run(plain.strip()),), size=size, anchor="start")
        through = text._replace(content=(*text.runs[:k], Run(plain.rstrip(), level)))
        yield piece._replace(at=start + complex(text_width(through) - text_width(piece), rise) * turn)


def longest(text: Text) -> float:
    """Give the length of a text without levels in the widest font that a viewer may take, mm.

    >>> from drawings.paper.strokes import Text
    >>> longest(Text(0j, "ИН", 10.0)) > longest(Text(0j, "ii", 10.0)) > 0
    True
    """
    return EM * text.size * _advance(text.plain)


def _advance(plain: str) -> float:
    """Give the length of a text in font sizes; accents stand over their letters, a foreign sign is a square."""
    signs = (sign for sign in unicodedata.normalize("NFD", plain) if not unicodedata.combining(sign))
    return sum(_advances().get(sign, THOUSAND) for sign in signs) / THOUSAND


@cache
def _advances() -> Mapping[str, int]:
    table = json.loads(WIDEST.read_text("utf-8"))
    return {sign: int(advance) for advance, signs in table.items() for sign in signs}


Attributes: TypeAlias = dict[str, str]

# What XML carries unchanged. As a class of a regular expression it takes 5 ms to compile, a tenth of all imports.
_LEGAL = (range(0x20, 0x7F), range(0xA0, 0xD800), range(0xE000, 0xFFFE), range(0x10000, 0x110000))
_NAME = re.compile(r"[^\W\d][\w.-]*")
_DATA = re.compile(r"[a-z][a-z0-9-]*")
_RESERVED = ("sheet", "seal")


def legal(text: str) -> str:
    """Pass text on if XML can carry it unchanged; control characters and halves of characters are refused."""
    if text.isprintable():
        return text
    for place, sign in enumerate(text):
        if sign not in "\t\n" and not any(ord(sign) in codes for codes in _LEGAL):
            raise SheetError(f"{text!r}: the character {sign!r} at {place} cannot be written")
    return text


def own_ids(groups: Iterable[Group]) -> None:
    """Refuse groups whose names no file can hold, or that share one."""
    used = set(_RESERVED)
    for name in (group.name for group in within(groups) if group.name):
        if not _NAME.fullmatch(name):
            raise SheetError(f"{name!r} cannot name a group: a letter, then letters, digits, '_', '-', '.'")
        if name in used:
            raise SheetError(f"two groups of a sheet are named {name!r}")
        used.add(name)


def data_of(group: Group) -> Attributes:
    """Give the data of a group as attributes."""
    for key in group.data:
        if not _DATA.fullmatch(key):
            raise SheetError(f"{key!r} cannot name data: small letters, digits, '-'")
    return {f"data-{key}": legal(value) for key, value in group.data.items()}


class _Waiting(ModuleType):
    """Stands for a module while another is imported: its functions import it when they are called."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)

        def late(*given: Any, **named: Any) -> Any:
            return getattr(import_module(self.__name__), name)(*given, **named)

        return late


@contextmanager
def deferred(*names: str) -> Iterator[None]:
    """Import inside the block without these modules, unless they are there already."""
    waiting = {name: _Waiting(name) for name in names if name not in sys.modules}
    sys.modules.update(waiting)
    try:
        yield
    finally:
        for name in waiting:
            del sys.modules[name]


# A sheet fetches no fonts from the web, and its paths are not checked by svgwrite: half of its import is for these.
with deferred("urllib.request", "svgwrite.data.svgparser"):
    import svgwrite
    from svgwrite import container, path, shapes, text

# The kinds that are measured, and the only stroke that can stand for each.
BEARERS: dict[str, type[Line] | type[Circle] | type[Curve]] = {
    "vector": Line, "point": Circle, "pole": Circle, "corner": Circle, "profile": Curve,
}  # fmt: skip
# svgwrite gives an element its maker's settings; without a maker it would set up a validator for each.
_UNCHECKED = container.Group(debug=False)


def svg(leaf: Leaf) -> bytes:
    """Draw a sheet: the same leaf gives the same bytes on every run."""
    leaf = unstated(leaf)
    root = _drawing(leaf).get_xml()
    _describe(root, leaf)
    for part in root:
        part.tail = "\n"
    root.text = "\n"
    drawn = '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode")
    body = drawn.removesuffix("</svg>").encode("utf-8")
    return body + seal(body, sum(1 for _ in root.iter()))


def _drawing(leaf: Leaf) -> Any:
    width, height = number(leaf.width), number(leaf.height)
    if not (leaf.width > 0 and leaf.height > 0):
        raise SheetError(f"a sheet of {width} x {height} mm has no room")
    drawing = svgwrite.Drawing(size=(f"{width}mm", f"{height}mm"), viewBox=f"0 0 {width} {height}", debug=False)
    drawing.elements.clear()  # an empty <defs>, which we never use
    for group in leaf.groups:
        drawing.add(_group(group, leaf))
    own_ids(leaf.groups)
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


def _group(group: Group, leaf: Leaf) -> Any:
    data = data_of(group)
    bearer = BEARERS.get(group.data.get("kind", ""))
    attributes = {"id": legal(group.name)} if group.name else {}
    if "kind" in group.data:
        attributes["class"] = legal(group.data["kind"])
    element = _element(container.Group, attributes if bearer else attributes | data)
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


def _merged(strokes: Iterable[Stroke], leaf: Leaf) -> Iterator[Any]:
    for kind, run in groupby(strokes, _mergeable):
        if kind is None:
            yield from (_one(stroke, leaf) for stroke in run)
        else:
            yield _path(commands((stroke for stroke in run if isinstance(stroke, Plain)), leaf.height), kind[0])


def _mergeable(stroke: Stroke) -> tuple[LineStyle, bool] | None:
    """Outlines of one style can be one path, and so can fills; a filled outline must go on hiding what it hides."""
    match stroke:
        case Fill():
            return stroke.style, True
        case Line() | Polyline() | Arc() if stroke.style.fill == "none":
            return stroke.style, False
    return None


def _path(written: str, style: LineStyle) -> Any:
    element = _element(path.Path, dict(_style(style)))
    element.commands = [written]
    return element


def _one(stroke: Stroke, leaf: Leaf) -> Any:
    height = leaf.height
    match stroke:
        case Line(start, end, style):
            ends = _at(("x1", "y1"), start, height) | _at(("x2", "y2"), end, height)
            return _element(shapes.Line, ends | _style(style))
        case Circle(centre, radius, style):
            return _element(shapes.Circle, _at(("cx", "cy"), centre, height) | {"r": number(radius)} | _style(style))
        case Polyline() | Arc() | Fill():
            return _path(commands((stroke,), height), stroke.style)
        case Curve():
            return _path(curve(stroke, height), stroke.style)
        case Text():
            return _letters(stroke, height) if leaf.lettering == "strokes" else _text(stroke, height)
        case Group():
            return _group(stroke, leaf)


def _letters(stroke: Text, height: float) -> Any:
    """Write a text as one path, or as a group of one for each width of the pen; either says what is written."""
    paths = [_path(written, pen(unit, stroke.style)) for unit, written in lettering(stroke, height).items()]
    return _together(paths, {"data-text": legal(stroke.plain)})


def _text(stroke: Text, height: float) -> Any:
    """Leave a text to the viewer's fonts: one element, or a group of one for each level, and either says it all."""
    said = legal(stroke.plain)
    return _together([_run(piece, height) for piece in pieces(stroke)], {"data-text": said, "aria-label": said})


def _together(drawn: list[Any], data: Attributes) -> Any:
    if len(drawn) == 1:
        drawn[0].attribs.update(data)
        return drawn[0]
    group = _element(container.Group, data)
    group.elements.extend(drawn)
    return group


def _run(stroke: Text, height: float) -> Any:
    """Leave a text without levels to the viewer's fonts, as long as our own alphabet would write it.

    A font keeps half of the gap between letters free at either end. Browsers and Inkscape keep to a text's length;
    librsvg does not know it, so that all is narrowed until the widest font that may be taken keeps to it by itself.
    """
    free = GAP / 2 * stroke.size / 10
    place = _at(("x", "y"), stroke.at - free * cmath.rect(1, math.radians(stroke.rotation)), height)
    attributes = place | {"font-family": FONTS, "font-size": number(EM * stroke.size)}
    length = text_width(stroke) + 2 * free
    narrow = min(1.0, length / longest(stroke))
    attributes |= {"textLength": number(round(tied(length / narrow), 2)), "lengthAdjust": "spacingAndGlyphs"}
    if stroke.slanted:
        attributes["font-style"] = "italic"
    if transforms := list(_transforms(stroke, place, narrow)):
        attributes["transform"] = " ".join(transforms)
    element = _element(text.Text, attributes | _style(stroke.style))
    element.text = legal(stroke.plain)
    return element


def _transforms(stroke: Text, place: Attributes, narrow: float) -> Iterator[str]:
    if stroke.rotation:
        yield f"rotate({number(-stroke.rotation)} {place['x']} {place['y']})"
    if narrow < 1:
        yield f"translate({number(float(place['x']) * (1 - narrow))}) scale({number(narrow)} 1)"


def _at(names: tuple[str, str], point: complex, height: float) -> Attributes:
    across, down = numbers("%s %s", (round(point.real, SURE), round(height - point.imag, SURE))).split()
    return {names[0]: across, names[1]: down}


@lru_cache(maxsize=256)
def _style(style: LineStyle) -> Attributes:
    attributes = {"fill": legal(style.fill), "stroke": legal(style.colour)}
    if style.colour != "none":
        attributes |= {"stroke-width": number(style.width), "stroke-linejoin": "round"}
    if style.cap != "butt":
        attributes["stroke-linecap"] = legal(style.cap)
    if style.dash:
        attributes["stroke-dasharray"] = numbers(",".join(["%s"] * len(style.dash)), style.dash)
    return attributes


def _element(kind: Callable[..., Any], attributes: Attributes) -> Any:
    """Make an svgwrite element with our attributes only: its own checks are slow, and pass NaN."""
    element = kind("", factory=_UNCHECKED) if kind in (text.Text, text.TSpan) else kind(factory=_UNCHECKED)
    element.attribs = attributes
    return element
