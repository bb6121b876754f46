"""Ink: in what line an element is drawn, and whether an eye can see it on white paper (видимость линий)."""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import Literal, NamedTuple

from drawings.paper.limits import NUMERAL_LENGTH, REACH, SheetRefused
from drawings.paper.strokes import LineStyle, Stroke
from drawings.reading.pathdata import NUMERAL, SPACE, numbers
from drawings.reading.visibility import Look, share

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
    style = LineStyle(width, dash, colour, fill, _cap(look.stroke_linecap), join)
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
    """Tell whether black can be told from paper under a filling."""
    black = "#" + "".join(f"{max(part - round(255 * _left(look)), 0):02x}" for part in _parts(fill))
    return _contrast(_parts(fill), _parts(black)) >= CONTRAST


def _left(look: Look) -> float:
    """Give the share of what is under a filling that shows through it."""
    paint = look.fill.lower()
    alpha = _alpha(paint) if _HEX.fullmatch(paint) else 1.0
    return 1 - alpha * share(look.fill_opacity) * look.shade


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


def _cap(text: str) -> Literal["butt", "round"]:
    return "round" if text == "round" else "butt"


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
    """Give the relative luminance of a colour of sRGB."""
    linear = [math.pow((part / 255 + 0.055) / 1.055, 2.4) if part > 10 else part / 255 / 12.92 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
