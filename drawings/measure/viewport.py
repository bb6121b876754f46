"""The viewport of a sheet: how its user units lie on paper."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from drawings.measure.pathdata import NUMERAL, SPACE, number, numbers
from drawings.measure.transform import MIRROR, Affine
from drawings.paper.limits import REACH, SheetRefused

PIXEL = 25.4 / 96
_UNITS = {"": PIXEL, "px": PIXEL, "mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72, "pc": 25.4 / 6}
_ALIGN = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}


class Viewport(NamedTuple):
    """The paper's size in mm, the map from user units to paper with y up, and what had to be assumed."""

    width: float
    height: float
    placing: Affine
    notes: tuple[str, ...]


def viewport(attributes: Mapping[str, str]) -> Viewport:
    """Read a root's width, height, viewBox and preserveAspectRatio.

    >>> viewport({"width": "21cm", "height": "297mm", "viewBox": "0 0 2100 2970"}).placing(100 + 70j)
    (10+290j)
    """
    box = _box(attributes.get("viewBox"))
    width, height = _length(attributes.get("width")), _length(attributes.get("height"))
    notes: tuple[str, ...] = ()
    if width is None or height is None:
        if box is None:
            raise SheetRefused("the sheet has neither a size nor a viewBox")
        width, height = box[2] * PIXEL, box[3] * PIXEL
        notes = ("the sheet's size is not stated; 96 user units are taken as an inch",)
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
        raise SheetRefused(f"the sheet's size {text[:20]!r} is not a length")
    length = number(match[0]) * unit
    if not 0 < length <= REACH:
        raise SheetRefused(f"the sheet's size {text[:20]!r} is not that of a sheet")
    return length


def _box(text: str | None) -> tuple[float, float, float, float] | None:
    if text is None:
        return None
    values = numbers(text)
    if len(values) != 4 or not (values[2] > 0 and values[3] > 0):
        raise SheetRefused(f"viewBox {text[:40]!r} has no area")
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
        raise SheetRefused(f"preserveAspectRatio {fit[:30]!r} is not understood") from None
    scale = max(sx, sy) if rule == ["slice"] else min(sx, sy)
    rest = complex(share.real * (width - scale * across), share.imag * (height - scale * down))
    return Affine(complex(scale), 0j, rest - scale * complex(x, y))
