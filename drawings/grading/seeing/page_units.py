"""Units of a page: how long the units of a sheet are that does not say it, or says it as editors do (единицы листа)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

from drawings.lettering.extent import bounds
from drawings.measure.pathdata import NUMERAL, SPACE, numbers
from drawings.measure.viewport import PIXEL, viewport
from drawings.paper.formats import SIZES
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Leaf
from drawings.paper.walk import flat

# mm: of ours, of a screen, of Inkscape before 0.92, of Illustrator. A page that has a standard's size in one has it in
# no other, by NEAR mm.
UNITS: Final = (1.0, PIXEL, OLD := 25.4 / 90, 25.4 / 72)
NEAR = 0.3
EDGE = 1.02  # of a page: so far lines may reach that go to its edge
_ROOT = re.compile(rb"<(?:[A-Za-z]+:)?svg(?=\s)")
_VERSION = "http://www.inkscape.org/namespaces/inkscape version"
_OLD = ("0.4", "0.91")  # how the versions of Inkscape begin that write no viewBox


def stated(attributes: Mapping[str, str]) -> Mapping[str, str]:
    """Give a root with its size in mm and its viewBox, where a standard's page or its editor tells of its units.

    >>> stated({"width": "841", "height": "594"})
    {'width': '841mm', 'height': '594mm', 'viewBox': '0 0 841 594'}
    """
    size, box = [_size(attributes.get(name)) for name in ("width", "height")], _box(attributes)
    if all(unit in ("", "px") for _, unit in size):
        wide, high = box or [number for number, _ in size]
        unit = next((unit for unit in UNITS if _is_standard(wide * unit, high * unit)), None)
        return attributes if unit is None else boxed(attributes, (wide * unit, high * unit), unit)
    if box is None and attributes.get(_VERSION, "").startswith(_OLD) and all(unit == "mm" for _, unit in size):
        return boxed(attributes, (size[0][0], size[1][0]), OLD)
    return attributes


def boxed_in(attributes: Mapping[str, str], unit: float) -> Mapping[str, str]:
    """Give a root without a viewBox one in units of so many mm."""
    paper = viewport(attributes)
    return boxed(attributes, (paper.width, paper.height), unit)


def boxed(attributes: Mapping[str, str], size: tuple[float, float], unit: float) -> dict[str, str]:
    """Give a root of a size, mm, whose units are so many mm; a viewBox that it has stays."""
    wide, high = size
    own = {"width": f"{wide:.9g}mm", "height": f"{high:.9g}mm", "viewBox": f"0 0 {wide / unit:.9g} {high / unit:.9g}"}
    return {**attributes, **own, **({"viewBox": attributes["viewBox"]} if "viewBox" in attributes else {})}


def shown(source: bytes, box: str) -> bytes:
    """Write the viewBox of a sheet in which it was read and which it lacks, so that it fills the place of a picture."""
    return _ROOT.sub(rb'\g<0> viewBox="%s"' % box.encode("ascii"), source, count=1) if box else source


def in_millimetres(leaf: Leaf) -> bool:
    """Tell of a page without a viewBox whether its units are mm: all drawn in pixels it would lie in a corner of it."""
    own = [bounds(one) for one in flat(leaf.groups)]
    if not own:
        return False
    right, low = max(box[2] for box in own), min(box[1] for box in own)
    corner = EDGE * PIXEL
    return right <= corner * leaf.width and leaf.height - low <= corner * leaf.height


def _is_standard(wide: float, high: float) -> bool:
    """Tell whether a page is one of a standard, laid either way, mm."""
    page = sorted((wide, high))
    return any(all(abs(a - b) <= NEAR for a, b in zip(page, sorted(own), strict=True)) for own in SIZES.values())


def _size(text: str | None) -> tuple[float, str]:
    """Read a length: its number and its unit; what is left to the viewer has neither."""
    text = (text or "").strip(SPACE)
    match = NUMERAL.match(text)
    if match is None or text.endswith("%"):
        return 0.0, ""
    return float(match[0]), text[match.end() :]


def _box(attributes: Mapping[str, str]) -> list[float] | None:
    """Give the width and height of a viewBox; None where there is none that can be read."""
    try:
        own = numbers(attributes.get("viewBox", ""))
    except SheetRefused:
        return None
    return own[2:] if len(own) == 4 else None
