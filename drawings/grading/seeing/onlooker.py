"""The onlooker: sees a student's sheet as the eye does, and beside it the arrowheads and texts of other editors."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from drawings.eye.ink import Ink, length
from drawings.eye.observer import Observer, Opened
from drawings.eye.typeset import EM
from drawings.grading.seeing.page_units import boxed_in, stated
from drawings.lettering.lettering import lacking, text_width
from drawings.measure.pathdata import number
from drawings.measure.viewport import Viewport
from drawings.measure.visibility import declarations
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Run, Stroke, Text
from drawings.paper.walk import flat

BEGIN, END = "marker-start", "marker-end"
SHARES = MappingProxyType({"middle": 0.5, "end": 1.0})  # of a text that lie before its anchor


class Onlooker(Observer):
    """Sees the elements of a sheet one by one; `heads` are the ends with an arrowhead, of strokes by their ids.

    `unit` is how many mm the units of a page are that does not say it, where this is known; `box` is the viewBox that
    it is given then.
    """

    def __init__(self, unit: float = 0.0) -> None:
        super().__init__()
        self.heads: dict[int, frozenset[str]] = {}
        self.unit, self.box, self.boxless = unit, "", False

    def opened(self, attributes: Mapping[str, str]) -> Viewport:
        """See the paper that a root lays what is drawn on, in the units that its editor meant."""
        own = boxed_in(attributes, self.unit) if self.unit else stated(attributes)
        self.boxless = "viewBox" not in own
        self.box = "" if "viewBox" in attributes else own.get("viewBox", "")
        return super().opened(own)

    def leave(self) -> None:
        """See the innermost element end; what an editor writes in a part of a text is of that text."""
        one = self.open[-1]
        if one.frame.tag == "text":
            one.attributes = _begun(one)
        super().leave()
        if one.frame.tag == "tspan" and self.open:
            self.open[-1].heard += one.heard
            placed = {name: one.attributes[name] for name in ("x", "y") if name in one.attributes}
            self.open[-1].attributes = {**placed, **self.open[-1].attributes}

    def _add(self, outer: Opened, strokes: tuple[Stroke, ...], seen: Ink) -> None:
        if self.open and (heads := _heads(self.open[-1].attributes)):
            self.heads |= {id(part): heads for part in flat(strokes)}
        super()._add(outer, strokes, seen)


def _begun(one: Opened) -> Mapping[str, str]:
    """Give the attributes of a text as if it were set from its beginning, wherever it is anchored."""
    share, plain = SHARES.get(one.frame.look.text_anchor, 0.0), "".join(one.heard).strip()
    if not share or lacking(plain):
        return one.attributes
    try:
        start, size = number(one.attributes.get("x", "0")), length(one.frame.look.font_size) / EM
    except SheetRefused:  # what is no number is told where the text itself is read
        return one.attributes
    return {**one.attributes, "x": f"{start - share * text_width(Text(0j, (Run(plain),), size)):.4f}"}


def _heads(attributes: Mapping[str, str]) -> frozenset[str]:
    """Give the ends of an element that have a marker, by its attributes or its style."""
    if "marker" not in attributes.get("style", "") and not {BEGIN, END} & set(attributes):
        return frozenset()
    own = {**attributes, **declarations(attributes.get("style", ""))}
    return frozenset(name for name in (BEGIN, END) if own.get(name, "none") != "none")
