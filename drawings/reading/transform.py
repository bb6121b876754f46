"""Plane maps w = p*z + q*conj(z) + t: a similarity has q = 0, a mirrored one p = 0, and a stretch has both."""

import cmath
import math
import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from drawings.paper.limits import ELEMENT_TRANSFORMS, QUANTUM, REACH, SheetRefused
from drawings.reading.pathdata import GAP, NUMERAL, SPACE, number, numbers
from plans.words.words import Message, message

_CALL = re.compile(rf"([A-Za-z]+)[{SPACE}]*\(([^()]*)\)")
ROUNDED = 1e-6  # of a transform's numbers, as editors write them
# A style sheet's transform carries units; px and deg are what the attribute means without them.
_UNIT = re.compile(r"(?<=[0-9.])(?:px|deg)(?![a-z])")


class Affine(NamedTuple):
    """The map w = p*z + q*conj(z) + t."""

    p: complex = 1 + 0j
    q: complex = 0j
    t: complex = 0j

    def __call__(self, z: complex) -> complex:
        """Map a point."""
        return self.p * z + self.q * z.conjugate() + self.t

    def after(self, first: "Affine") -> "Affine":
        """Give the map that makes `first`, then this one."""
        p, q, t = first
        return Affine(self.p * p + self.q * q.conjugate(), self.p * q + self.q * p.conjugate(), self(t))

    @property
    def singular(self) -> bool:
        """Whether the plane falls onto a line or a point."""
        return abs(self.p) == abs(self.q)

    @property
    def stretched(self) -> bool:
        """Whether a circle becomes an ellipse, by more than an editor's six digits."""
        return min(abs(self.p), abs(self.q)) > ROUNDED * max(abs(self.p), abs(self.q))


STAY = Affine()
MIRROR = Affine(0j, 1 + 0j)


def matrix(a: float, b: float, c: float, d: float, e: float, f: float) -> Affine:
    """Give SVG's matrix: x' = a*x + c*y + e, y' = b*x + d*y + f."""
    return Affine(complex(a + d, b - c) / 2, complex(a - d, b + c) / 2, complex(e, f))


def transform(text: str) -> Affine:
    """Read a transform list, the last one acting first.

    >>> transform("translate(10 0) rotate(90) scale(2)")(1 + 0j)
    (10+2j)
    """
    text = _UNIT.sub("", text).strip(SPACE)
    total, place, count = STAY, 0, 0
    while place < len(text):
        call = _CALL.match(text, place)
        count += 1
        if call is None or count > ELEMENT_TRANSFORMS:
            raise SheetRefused("transform", text=repr(text[place : place + 30]))
        total = total.after(_single(call[1], numbers(call[2])))
        gap = GAP.match(text, call.end())
        place = gap.end() if gap else call.end()
    if not all(abs(size) <= REACH**2 for part in total for size in (part.real, part.imag)):
        raise SheetRefused("far_transform", text=repr(text[:30]))
    return total


def about(origin: complex, turn: Affine) -> Affine:
    """Give a map made about another origin than zero."""
    return Affine(t=origin).after(turn).after(Affine(t=-origin))


def placing(stated: Sequence[complex], found: Sequence[complex]) -> Affine:
    """Find how a whole sheet was moved, from three marks of known place; a mirrored or stretched one is refused."""
    u, v = stated[1] - stated[0], stated[2] - stated[0]
    U, V = found[1] - found[0], found[2] - found[0]
    doubled_area = u * v.conjugate() - u.conjugate() * v
    if doubled_area == 0:
        raise SheetRefused("corners_in_line")
    p = (U * v.conjugate() - V * u.conjugate()) / doubled_area
    q = (V * u - U * v) / doubled_area
    if abs(q) >= abs(p):
        raise SheetRefused("mirrored")
    # Each mark is rounded twice, by us and by the editor, before or after the sheet was scaled.
    rounding = 2 * QUANTUM * max(1.0, abs(p)) * (abs(u) + abs(v)) / abs(doubled_area)
    if not abs(q) <= rounding:
        ratio = (abs(p) + abs(q)) / (abs(p) - abs(q))
        raise SheetRefused("stretched", ratio=f"{ratio:.6f}")
    return Affine(p, 0j, found[0] - p * stated[0])


def _single(name: str, values: list[float]) -> Affine:
    match name, values:
        case "matrix", [a, b, c, d, e, f]:
            return matrix(a, b, c, d, e, f)
        case "translate", [x]:
            return Affine(t=complex(x))
        case "translate", [x, y]:
            return Affine(t=complex(x, y))
        case "scale", [both]:
            return Affine(p=complex(both))
        case "scale", [x, y]:
            return matrix(x, 0, 0, y, 0, 0)
        case "rotate", [angle]:
            return Affine(p=_turned(angle))
        case "rotate", [angle, x, y]:
            return about(complex(x, y), Affine(p=_turned(angle)))
        case "skewX", [angle]:
            return matrix(1, 0, math.tan(math.radians(angle)), 1, 0, 0)
        case "skewY", [angle]:
            return matrix(1, math.tan(math.radians(angle)), 0, 1, 0, 0)
    raise SheetRefused("transform_numbers", text=repr(name[:20]), numbers=len(values))


def _turned(angle: float) -> complex:
    """Quarter turns are exact, as the editor meant them."""
    quarters, rest = divmod(angle, 90)
    return complex(1j ** int(quarters % 4)) * cmath.rect(1, math.radians(rest))


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
    placed = _placed(box, width, height, attributes.get("preserveAspectRatio", "xMidYMid"))
    return Viewport(width, height, Affine(t=1j * height).after(MIRROR).after(placed), notes)


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


def _placed(box: tuple[float, float, float, float], width: float, height: float, fit: str) -> Affine:
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
