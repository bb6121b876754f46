"""Effects: properties that change what is seen, and that no pen of a drawing writes (приёмы показа)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.measure.pathdata import SPACE
from drawings.measure.visibility import declarations, unfollowed

# What each may say without any effect; editors write many of them so.
_IDLE = {
    **dict.fromkeys(("stroke-dashoffset", "letter-spacing", "word-spacing"), ("0", "0px", "normal")),
    **dict.fromkeys(("marker", "marker-start", "marker-mid", "marker-end"), ("none",)),
    **dict.fromkeys(("vector-effect", "mask-image", "text-decoration"), ("none",)),
    **dict.fromkeys(("mix-blend-mode", "paint-order", "font-variant", "font-stretch"), ("normal",)),
    "font-weight": ("normal", "400"),
    **dict.fromkeys(("baseline-shift", "dominant-baseline", "alignment-baseline"), ("baseline", "auto", "0")),
    "writing-mode": ("lr-tb", "lr", "horizontal-tb"),
    "content-visibility": ("visible",),
    "stroke-linejoin": ("round",),  # a pen draws all its corners so
    "clip": ("auto",),
    "all": (),
}
# Attributes on which it depends whether an element is shown at all, or how long its dashes are.
_NEVER = ("systemLanguage", "requiredExtensions", "pathLength", "rotate")
_MADE = ("var(", "env(", "attr(", "calc(")  # what a viewer works out
_FOREIGN, _DATA = "-webkit-", "data-"


def effects(attributes: Mapping[str, str]) -> Iterator[str]:
    """Name the properties of an element that change what is seen of it and are not followed.

    >>> list(effects({"stroke-dashoffset": "0", "style": "mix-blend-mode:screen; -webkit-filter: blur(9px)"}))
    ['mix-blend-mode', '-webkit-filter']
    """
    yield from (name for name in _NEVER if name in attributes)
    style = declarations(attributes["style"]) if "style" in attributes else {}
    yield from filter(None, (unfollowed(style),))
    for name, text in (*attributes.items(), *style.items()):
        if name != "style" and not name.startswith(_DATA) and not _idle(name, text.strip(SPACE).lower()):
            yield name


def _idle(name: str, value: str) -> bool:
    """Tell whether a property is followed, or has no effect."""
    if name.startswith(_FOREIGN):
        return value in ("none", "normal", "auto")
    return value in _IDLE.get(name, (value,)) and not any(made in value for made in _MADE)
