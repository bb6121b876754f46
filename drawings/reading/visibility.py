"""What of a sheet can be seen: a hidden vector is not drawn, whatever its data say."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from operator import itemgetter
from typing import Any, NamedTuple, TypeAlias

from drawings.paper.limits import NUMERAL_LENGTH, SheetRefused
from drawings.reading.pathdata import NUMERAL, SPACE
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
    return next(
        (name for name in (word.partition(":")[0].strip(SPACE) for word in words) if name in _MOVING | _FOLLOWED), ""
    )


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
