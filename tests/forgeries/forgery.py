"""A forgery (подделка): a written sheet that was edited, its seal made anew, and what a check must tell of it."""

from __future__ import annotations

from typing import NamedTuple

from drawings.paper.strokes import Text
from drawings.reading.items import Item, SheetFigures, middle

NEAR = 0.5  # mm: how exactly the place of an edit is told


class Told(NamedTuple):
    """What must be told: kinds of findings that will do, and of an edit its name, figure and place."""

    kinds: tuple[str, ...]
    name: str | None = None
    figure: str | None = None
    at: complex | None = None
    says: str = ""  # in the words of it

    def fits(self, finding: dict[str, object]) -> bool:
        """Tell whether a finding, as plain data, is the one."""
        if finding["finding"] == "refused" and "refused" in self.kinds and not self.says:
            return True
        at = finding.get("at")
        near = self.at is None or (isinstance(at, list) and abs(complex(*at) - self.at) <= NEAR)
        return (
            finding.get("edit", finding["finding"]) in self.kinds
            and self.name in (None, finding.get("name"))
            and self.figure in (None, finding.get("figure"))
            and near
            and self.says in str(finding["told"])
        )


class Forgery(NamedTuple):
    """An edited sheet: the kind of the edit, the sheet that it is made from, its bytes, what must be told."""

    kind: str
    sheet: str
    source: bytes
    told: Told


def of(item: Item, figures: SheetFigures, *kinds: str) -> Told:
    """Say that an item must be told, by its name, figure and place."""
    at = None if isinstance(item.stroke, Text) and item.stroke.anchor != "start" else middle(item.stroke)
    return Told(kinds, item.name, figures.of(item), at)
