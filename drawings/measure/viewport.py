"""The viewport of a sheet: how its user units lie on paper."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from drawings.measure.pathdata import NUMERAL, SPACE, number, numbers
from drawings.measure.transform import MIRROR, Affine
from drawings.paper.limits import REACH, SheetRefused
from plans.words.words import Message, message

PIXEL = 25.4 / 96
_UNITS = {"": PIXEL, "px": PIXEL, "mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72, "pc": 25.4 / 6}
_ALIGN = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}


class Viewport(NamedTuple):
    """The paper's size in mm, the map from user units to paper with y up, and what had to be assumed."""

    width: float
    height: float
    placing: Affine
    notes: tuple[Message, ...]


def viewport(attributes: Mapping[str, str]) -> Viewport:
    """Read a root's width, height, viewBox and preserveAspectRatio.

    >>> viewport({"width": "21cm", "height": "297mm", "viewBox": "0 0 2100 2970"}).placing(100 + 70j)
    (10+290j)
    """
    box = _box(attributes.get("viewBox"))
    width, height = _length(attributes.get("width")), _length(attributes.get("height"))
    notes: tuple[Message, ...] = ()
    if width is None or height is None:
        if box is None:
            raise SheetRefused("sizeless")
        width, height = box[2] * PIXEL, box[3] * PIXEL
        notes = (message("aside.size"),)
    if box is None:
        box = (0.0, 0.0, width / PIXEL, height / PIXEL)
    laid = _laid(box, width, height, attributes.get("preserveAspectRatio", "xMidYMid"))
    return Viewport(width, height, Affine(t=1j * height).after(MIRROR).after(laid), notes)


def _length(text: str | None) -> float | None:
    """Read a length in mm; None where it is left to the viewer."""
    text = (text or "").strip(SPACE)
    if text in ("", "auto") or text.endswith("%"):
        return None
    match = NUMERAL.match(text)
    unit = _UNITS.get(text[match.end() :]) if match else None
    if match is None or unit is None:
        raise SheetRefused("size", text=repr(text[:20]))
    length = number(match[0]) * unit
    if not 0 < length <= REACH:
        raise SheetRefused("far_size", text=repr(text[:20]))
    return length


def _box(text: str | None) -> tuple[float, float, float, float] | None:
    if text is None:
        return None
    values = numbers(text)
    if len(values) != 4 or not (values[2] > 0 and values[3] > 0):
        raise SheetRefused("view_box", text=repr(text[:40]))
    x, y, width, height = values
    return x, y, width, height


def _laid(box: tuple[float, float, float, float], width: float, height: float, fit: str) -> Affine:
    """Lay the box on the paper, y still downward."""
    x, y, across, down = box
    sx, sy = width / across, height / down
    align, *rule = fit.split() or ["xMidYMid"]
    if align == "none":
        return Affine(complex((sx + sy) / 2), complex((sx - sy) / 2), -complex(sx * x, sy * y))
    try:
        share = complex(_ALIGN[align[1:4]], _ALIGN[align[5:8]])
    except KeyError:
        raise SheetRefused("fit", text=repr(fit[:30])) from None
    scale = max(sx, sy) if rule == ["slice"] else min(sx, sy)
    rest = complex(share.real * (width - scale * across), share.imag * (height - scale * down))
    return Affine(complex(scale), 0j, rest - scale * complex(x, y))
