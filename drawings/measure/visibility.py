"""What of a sheet can be seen: a hidden vector is not drawn, whatever its data say."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import NamedTuple

from drawings.measure.pathdata import NUMERAL, SPACE
from drawings.paper.limits import NUMERAL_LENGTH, SheetRefused

# Contents that are kept for other uses, or are not a drawing at all.
_KEPT = "defs symbol marker clipPath mask pattern filter linearGradient radialGradient"
UNDRAWN = frozenset(f"{_KEPT} metadata title desc style script foreignObject".split())
ANIMATIONS = frozenset(("animate", "animateTransform", "animateMotion", "animateColor", "set", "discard"))

# Properties that decide what is seen and where; those of a style attribute are followed.
_SEEN = "display visibility opacity stroke stroke-width stroke-opacity fill fill-opacity clip-path mask filter"
_FOLLOWED = frozenset(f"{_SEEN} transform transform-origin".split())
# Properties by which a style could move what the attributes show.
_SHAPES = "cx cy r rx ry x y x1 y1 x2 y2 d points"
_MOVING = frozenset(f"{_SHAPES} translate rotate scale offset-path motion-path zoom transform-box".split())
_INVISIBLE = ("none", "transparent")


class Look(NamedTuple):
    """The inherited properties that decide whether an element is seen; `gone` says why nothing below it is."""

    gone: str = ""
    visibility: str = "visible"
    stroke: str = "none"
    stroke_width: str = "1"
    stroke_opacity: str = "1"
    fill: str = "black"
    fill_opacity: str = "1"

    def below(self, tag: str, properties: Mapping[str, str]) -> Look:
        """Give the look of an element inside, from its own properties."""
        return _below(self, tag, tuple(properties.items()))

    def hidden(self, filled: bool) -> str:
        """Tell why an element is not seen; "" if it is. A mark that is `filled` needs no stroke."""
        if self.gone:
            return self.gone
        if self.visibility != "visible":
            return f"visibility {self.visibility}"
        stroked = _paints(self.stroke, self.stroke_opacity) and not _vanishes(self.stroke_width)
        if stroked or (filled and _paints(self.fill, self.fill_opacity)):
            return ""
        return "drawn with nothing"


_INHERITED = tuple(name.replace("_", "-") for name in Look._fields[1:])


@lru_cache(maxsize=1024)  # a sheet has thousands of elements in a dozen looks
def _below(outer: Look, tag: str, listed: tuple[tuple[str, str], ...]) -> Look:
    own = dict(listed)
    inherited = (
        outer[place] if own.get(name, "inherit") == "inherit" else own[name]
        for place, name in enumerate(_INHERITED, start=1)
    )
    return Look(outer.gone or _goes(tag, own), *inherited)


def properties(attributes: Mapping[str, str]) -> dict[str, str]:
    """Give the presentation of an element: its attributes, overruled by its style."""
    found = {name: text.strip(SPACE) for name, text in attributes.items() if name in _FOLLOWED}
    return found | declarations(attributes["style"]) if "style" in attributes else found


def declarations(style: str) -> dict[str, str]:
    """Read the style attribute of an element.

    >>> declarations("stroke:none; Fill : red !important;")
    {'stroke': 'none', 'fill': 'red'}
    """
    if "/*" in style or "\\" in style:
        raise SheetRefused(f"style {style[:40]!r} is not understood")
    found: dict[str, str] = {}
    for declaration in style.split(";"):
        name, colon, value = declaration.partition(":")
        if colon:
            found[name.strip(SPACE).lower()] = value.replace("!important", "").strip(SPACE)
    return found


def unfollowed(found: Mapping[str, str]) -> str:
    """Name a property in a style that would move the element and that we do not follow; "" if there is none."""
    return next((name for name in sorted(found) if name in _MOVING), "")


def telling(sheet: str) -> str:
    """Name a property of a style sheet that could move or hide what is drawn; "" if there is none.

    >>> telling(".a { font-size: 3px } g{Display:none}"), telling(".st0{font-family:'x1'}")
    ('display', '')
    """
    if "\\" in sheet or "@import" in sheet.lower():
        return "@import or an escape"
    words = sheet.lower().replace("{", ";").replace("/", ";").replace("*", ";").split(";")
    return next(
        (name for name in (word.partition(":")[0].strip(SPACE) for word in words) if name in _MOVING | _FOLLOWED), ""
    )


def _goes(tag: str, own: Mapping[str, str]) -> str:
    if tag in UNDRAWN:
        return f"inside <{tag}>"
    if own.get("display") == "none":
        return "display none"
    if _vanishes(own.get("opacity", "1")):
        return "opacity 0"
    return next((f"under a {name}" for name in ("clip-path", "mask", "filter") if own.get(name, "none") != "none"), "")


def _paints(paint: str, opacity: str) -> bool:
    paint = paint.lower()
    clear = len(paint) in (5, 9) and paint.startswith("#") and not paint[-(len(paint) // 4) :].strip("0")
    return not (paint in _INVISIBLE or clear or _vanishes(opacity))


def _vanishes(size: str) -> bool:
    match = NUMERAL.match(size.strip(SPACE)[:NUMERAL_LENGTH])
    return match is not None and float(match[0]) <= 0
