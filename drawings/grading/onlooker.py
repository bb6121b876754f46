"""The onlooker: sees a student's sheet as the eye does, and beside it the arrowheads and texts of other editors."""

from __future__ import annotations

from collections.abc import Mapping

from drawings.eye.ink import Ink
from drawings.eye.observer import Observer, _Open
from drawings.measure.visibility import declarations
from drawings.paper.strokes import Stroke
from drawings.paper.walk import flat

BEGIN, END = "marker-start", "marker-end"


class Onlooker(Observer):
    """Sees the elements of a sheet one by one; `heads` are the ends with an arrowhead, of strokes by their ids."""

    def __init__(self) -> None:
        super().__init__()
        self.heads: dict[int, frozenset[str]] = {}

    def leave(self) -> None:
        """See the innermost element end; what an editor writes in a part of a text is of that text."""
        one = self.open[-1]
        super().leave()
        if one.frame.tag == "tspan" and self.open:
            self.open[-1].heard += one.heard

    def _add(self, outer: _Open, strokes: tuple[Stroke, ...], seen: Ink) -> None:
        if self.open and (heads := _heads(self.open[-1].attributes)):
            self.heads |= {id(part): heads for part in flat(strokes)}
        super()._add(outer, strokes, seen)


def _heads(attributes: Mapping[str, str]) -> frozenset[str]:
    """Give the ends of an element that have a marker, by its attributes or its style."""
    if "marker" not in attributes.get("style", "") and not {BEGIN, END} & set(attributes):
        return frozenset()
    own = {**attributes, **declarations(attributes.get("style", ""))}
    return frozenset(name for name in (BEGIN, END) if own.get(name, "none") != "none")
