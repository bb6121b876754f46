"""What of a sheet can be seen on white paper, and in what line it is drawn: a hidden vector is not (видимость)."""

import math
import re
from collections.abc import Callable, Mapping
from functools import lru_cache
from operator import itemgetter
from typing import Any, NamedTuple, TypeAlias

from drawings.paper.limits import NUMERAL_LENGTH, REACH, SheetRefused
from drawings.paper.strokes import LineStyle, Stroke
from drawings.reading.pathdata import NUMERAL, SPACE, numbers
from plans.words.words import Message, message

# Contents that are kept for other uses, or are not a drawing at all.
_KEPT = "defs symbol marker clipPath mask pattern filter linearGradient radialGradient"
UNDRAWN = frozenset(f"{_KEPT} metadata title desc style script foreignObject".split())
ANIMATIONS = frozenset(("animate", "animateTransform", "animateMotion", "animateColor", "set", "discard"))

# Properties that decide what is seen and where; those of a style attribute are followed.
_SEEN = "display visibility opacity stroke stroke-width stroke-opacity fill fill-opacity clip-path mask filter"
_FOLLOWED = frozenset(f"{_SEEN} transform transform-origin".split())
# Those that say how what is seen looks.
_LOOKS = _FOLLOWED | frozenset(
    ["stroke-dasharray", "stroke-linecap", "stroke-linejoin", "font-size", "font-style", "text-anchor"]
)
# Properties by which a style could move what the attributes show.
_SHAPES = "cx cy r rx ry x y x1 y1 x2 y2 d points"
_MOVING = frozenset(f"{_SHAPES} translate rotate scale offset-path motion-path zoom transform-box".split())
# Attributes that say where an element lies, or who it is, and nothing of its look; so do its data.
_PLACES = frozenset(("d", "points", "cx", "cy", "r", "x", "y", "x1", "y1", "x2", "y2", "id", "class"))
_DATA = "data-"
_INVISIBLE = ("none", "transparent")

Said: TypeAlias = tuple[tuple[str, str], ...]  # attributes that may tell of a look: hundreds of elements have the same
_SAID = 40  # letters of a strange value that are told


class Look(NamedTuple):
    """The inherited properties of what is drawn; `gone` says why nothing below it is seen.

    `shade` is the share of its ink that is left by the opacities of all that it stands in.
    """

    gone: Message | None = None
    visibility: str = "visible"
    stroke: str = "none"
    stroke_width: str = "1"
    stroke_opacity: str = "1"
    fill: str = "black"
    fill_opacity: str = "1"
    stroke_dasharray: str = "none"
    stroke_linecap: str = "butt"
    stroke_linejoin: str = "miter"
    font_size: str = "16"
    font_style: str = "normal"
    text_anchor: str = "start"
    shade: float = 1.0

    def hidden(self, filled: bool) -> Message | None:
        """Tell why an element is not seen; None if it is. A mark that is `filled` needs no stroke."""
        if self.gone:
            return self.gone
        if self.visibility != "visible":
            return message("gone.visibility", value=self.visibility[:_SAID])
        stroked = _paints(self.stroke, self.stroke_opacity) and not _vanishes(self.stroke_width)
        if stroked or (filled and _paints(self.fill, self.fill_opacity)):
            return None
        return message("gone.inkless")


_INHERITED = tuple(name.replace("_", "-") for name in Look._fields[1:-1])


class Presentation(NamedTuple):
    """What the attributes of an element say: its properties, its look, and which of them moves it unfollowed."""

    properties: Mapping[str, str]
    look: Look
    moved: str


def said(attributes: Mapping[str, str]) -> Said:
    """Give the attributes of an element that may tell of its look."""
    return tuple((name, text) for name, text in attributes.items() if _tells(name))


def _tells(name: str) -> bool:
    return name not in _PLACES and not name.startswith(_DATA)


@lru_cache(maxsize=1024)  # few elements have other attributes than the rest of their kind
def teller(names: tuple[str, ...]) -> tuple[tuple[str, ...], Callable[[Mapping[str, str]], object]]:
    """Give those of an element's attributes, by their names, that may tell of its look, and how to take out theirs."""
    telling = tuple(name for name in names if _tells(name))
    return telling, itemgetter(*telling) if telling else lambda attributes: ()


@lru_cache(maxsize=1024)  # the sheets of a set have the same looks
def presented(outer: Look, tag: str, said: Said) -> Presentation:
    """Give the presentation of an element inside another: by its attributes, overruled by its style."""
    properties = {name: text.strip(SPACE) for name, text in said if name in _LOOKS} | declarations(said)
    changed: dict[str, Any] = {
        name.replace("-", "_"): properties[name] for name in _INHERITED if properties.get(name, "inherit") != "inherit"
    }
    gone, shade = outer.gone or _goes(tag, properties), outer.shade * share(properties.get("opacity", "1"))
    return Presentation(properties, outer._replace(gone=gone, shade=shade)._replace(**changed), unfollowed(properties))


def declarations(said: Said) -> dict[str, str]:
    """Read the style among the attributes of an element.

    >>> declarations((("style", "stroke:none; Fill : red ! important; fill: blue"),))
    {'stroke': 'none', 'fill': 'red'}
    """
    style = dict(said).get("style", "")
    if "/*" in style or "\\" in style:
        raise SheetRefused("style", text=repr(style[:_SAID]))
    found: dict[str, str] = {}
    grave: dict[str, str] = {}  # what is important goes before all else, wherever it stands
    for declaration in style.split(";"):
        name, colon, value = declaration.partition(":")
        value, mark, _ = value.partition("!")
        if colon:
            (grave if mark else found)[name.strip(SPACE).lower()] = value.strip(SPACE)
    return found | grave


def unfollowed(found: Mapping[str, str]) -> str:
    """Name a property in a style that would move the element and that we do not follow; "" if there is none."""
    return next((name for name in sorted(found) if name in _MOVING), "")


def telling(sheet: str) -> str:
    """Name a property of a style sheet that could move or hide what is drawn; "" if there is none.

    >>> telling(".a { font-size: 3px } g{Display:none}"), telling(".st0{font-family:'x1'}")
    ('display', '')
    """
    if "\\" in sheet or "@import" in sheet.lower():
        return "\\" if "\\" in sheet else "@import"
    words = sheet.lower().replace("{", ";").replace("/", ";").replace("*", ";").split(";")
    names = (word.partition(":")[0].strip(SPACE) for word in words)
    return next((name for name in names if name in _MOVING | _FOLLOWED), "")


def _goes(tag: str, properties: Mapping[str, str]) -> Message | None:
    if tag in UNDRAWN:
        return message("gone.inside", tag=tag)
    if properties.get("display", "").lower() == "none":
        return message("gone.display")
    if _vanishes(properties.get("opacity", "1")):
        return message("gone.opacity")
    under = (name for name in ("clip-path", "mask", "filter") if properties.get(name, "none") != "none")
    return next((message(f"gone.{name}") for name in under), None)


def share(opacity: str) -> float:
    """Read an opacity, from 0 to 1; one that is not understood leaves nothing.

    >>> share("0.5"), share("50%"), share("half")
    (0.5, 0.5, 0.0)
    """
    match = NUMERAL.match(opacity.strip(SPACE)[:NUMERAL_LENGTH])
    if match is None or opacity.strip(SPACE)[match.end() :] not in ("", "%"):
        return 0.0
    return min(max(float(match[0]) / (100 if opacity.strip(SPACE).endswith("%") else 1), 0.0), 1.0)


def _paints(paint: str, opacity: str) -> bool:
    paint = paint.lower()
    clear = len(paint) in (5, 9) and paint.startswith("#") and not paint[-(len(paint) // 4) :].strip("0")
    return not (paint in _INVISIBLE or clear or _vanishes(opacity))


def _vanishes(size: str) -> bool:
    match = NUMERAL.match(size.strip(SPACE)[:NUMERAL_LENGTH])
    return match is not None and float(match[0]) <= 0


# The narrowest line of ISO 128-2, mm; what is finer is no line of a drawing.
NARROWEST = 0.13
# The least contrast with what is beside it by which a line can be told (WCAG 2.1, 1.4.11).
CONTRAST = 3.0
# In the steps of a colour that a screen has: what an editor's rounding leaves of white.
_PAPER = (255, 255, 255)
_NAMES = {
    "black": "#000000", "white": "#ffffff", "gray": "#808080", "grey": "#808080", "silver": "#c0c0c0",
    "red": "#ff0000", "maroon": "#800000", "green": "#008000", "lime": "#00ff00", "blue": "#0000ff",
    "navy": "#000080", "yellow": "#ffff00", "olive": "#808000", "purple": "#800080", "fuchsia": "#ff00ff",
    "magenta": "#ff00ff", "teal": "#008080", "aqua": "#00ffff", "cyan": "#00ffff",
}  # fmt: skip
_HEX = re.compile(r"#(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})")
_RGB = re.compile(r"rgb\(\s*(\d{1,3})[\s,]+(\d{1,3})[\s,]+(\d{1,3})\s*\)")
_NONE = "none"
_CLIPS = ("gone.clip-path", "gone.mask")  # as the reader tells it
_UNITS = {"": 1.0, "px": 1.0, "mm": 96 / 25.4, "cm": 960 / 25.4, "in": 96.0, "pt": 96 / 72, "pc": 16.0}


class Unseen(NamedTuple):
    """A stroke that does not count as drawn, why, and the name of the group that it stands in."""

    stroke: Stroke
    reason: str
    group: str


class LineInk(NamedTuple):
    """The line of an element, and why it cannot be seen: "" if it can; a `clear` filling lets show what is under it."""

    style: LineStyle
    unseen: str = ""
    clear: bool = False


@lru_cache(maxsize=1024)
def ink(look: Look, scale: float) -> LineInk:
    """Give the ink of a look that is drawn so many times as large."""
    colour = _blended(look.stroke, share(look.stroke_opacity) * look.shade)
    fill = _blended(look.fill, share(look.fill_opacity) * look.shade)
    width = length(look.stroke_width) * scale
    dash, join = _dash(look.stroke_dasharray, scale), look.stroke_linejoin
    style = LineStyle(width, dash, colour, fill, "round" if look.stroke_linecap == "round" else "butt", join)
    if colour == _NONE:
        style = LineStyle(0.0, (), colour, fill)
    return LineInk(style, _why(look, style), fill != _NONE and _clear(look, fill))


def _why(look: Look, style: LineStyle) -> str:
    """Tell why what is drawn so is not seen; "" if it is."""
    if look.gone or look.visibility != "visible":
        return "clipped" if look.gone is not None and look.gone.key in _CLIPS else "hidden"
    if style.fill != _NONE and dark(style.fill):
        return ""
    if style.colour == _NONE or not dark(style.colour):
        return "pale"
    return "" if style.width >= NARROWEST else "thin"


def _clear(look: Look, fill: str) -> bool:
    paint = look.fill.lower()
    alpha = _alpha(paint) if _HEX.fullmatch(paint) else 1.0
    left = 1 - alpha * share(look.fill_opacity) * look.shade  # of what is under a filling, which shows through it
    black = "#" + "".join(f"{max(part - round(255 * left), 0):02x}" for part in _parts(fill))
    return _contrast(_parts(fill), _parts(black)) >= CONTRAST


@lru_cache(maxsize=256)
def dark(colour: str) -> bool:
    """Tell whether a colour can be told from white paper.

    >>> dark("#000000"), dark("#ffffff"), dark("#e0e0e0")
    (True, False, False)
    """
    return _contrast(_PAPER, _parts(colour)) >= CONTRAST


def length(text: str) -> float:
    """Read a length in user units.

    >>> length("2px"), round(length("1mm"), 3)
    (2.0, 3.78)
    """
    text = text.strip(SPACE)
    match = NUMERAL.match(text[:NUMERAL_LENGTH])
    unit = _UNITS.get(text[match.end() :]) if match else None
    if match is None or unit is None or not 0 <= float(match[0]) <= REACH:
        raise SheetRefused("length", text=repr(text[:20]))
    return float(match[0]) * unit


def _dash(text: str, scale: float) -> tuple[float, ...]:
    if text.strip(SPACE) in (_NONE, ""):
        return ()
    lengths = numbers(re.sub(r"(?<=[0-9.])px", "", text))
    return tuple(length * scale for length in lengths) if sum(lengths) > 0 else ()


def _blended(paint: str, share_left: float) -> str:
    """Give a paint as it looks on white paper; one that is not understood leaves nothing to be seen."""
    paint = paint.lower()
    if paint in (_NONE, "transparent") or share_left <= 0:
        return _NONE
    colour = _NAMES.get(paint, paint)
    if match := _RGB.fullmatch(colour):
        colour = "#" + "".join(f"{min(int(part), 255):02x}" for part in match.groups())
    if not _HEX.fullmatch(colour):
        return "#ffffff"
    parts, alpha = _parts(colour), _alpha(colour) * share_left
    return "#" + "".join(f"{round(255 + (part - 255) * alpha):02x}" for part in parts) if alpha > 0 else _NONE


def _parts(colour: str) -> tuple[int, int, int]:
    digits = colour[1:]
    if len(digits) < 6:
        digits = "".join(digit * 2 for digit in digits)
    return int(digits[0:2], 16), int(digits[2:4], 16), int(digits[4:6], 16)


def _alpha(colour: str) -> float:
    digits = colour[1:]
    return {4: int(digits[3:4] or "f", 16) / 15, 8: int(digits[6:8] or "ff", 16) / 255}.get(len(digits), 1.0)


def _contrast(light: tuple[int, int, int], deep: tuple[int, int, int]) -> float:
    return (_light(light) + 0.05) / (_light(deep) + 0.05)


def _light(parts: tuple[int, int, int]) -> float:
    linear = [math.pow((part / 255 + 0.055) / 1.055, 2.4) if part > 10 else part / 255 / 12.92 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
