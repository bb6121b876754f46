"""What a set of sheets shows, and where it stands: a sheet's request and the composer's answer (содержание)."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

from drawings.layout.picture import Notes, Picture, Spot, TextBlock
from drawings.layout.table import RuledTable, Setting
from drawings.page.page import Field

EVEN = 1.0  # weight of a figure that counts as the others do


Item: TypeAlias = Picture | TextBlock


class Panel(NamedTuple):
    """A figure or lettering, and what it wants of its place.

    Panels of one key `together` stand together, in their order; figures of one key `scale` are drawn at one scale. A
    weight above 1 makes a figure larger than the others; the weightiest one is foremost. A figure may want a `share` of
    its sheet: it is drawn at a smaller scale only where the next one does not fit.
    """

    item: Item
    weight: float = EVEN
    together: str = ""
    scale: str = ""
    share: float = 0.0


@dataclass(frozen=True, eq=False, repr=False)
class Contents:
    """What a set of sheets must show: panels in their order, tables, notes; if it is `followed`, none is the last."""

    panels: tuple[Panel, ...] = ()
    tables: tuple[RuledTable, ...] = ()
    notes: Notes | None = None
    followed: bool = False

    @cached_property
    def foremost(self) -> Panel | None:
        """The weightiest figure, if one weighs more than the others."""
        heaviest = max(self.panels, key=lambda panel: panel.weight, default=None)
        return heaviest if heaviest is not None and heaviest.weight > EVEN else None

    @cached_property
    def groups(self) -> tuple[tuple[Panel, ...], ...]:
        """The panels that stand together; one that belongs to no others is alone."""
        groups: dict[tuple[str, int], list[Panel]] = {}
        for k, panel in enumerate(self.panels):
            groups.setdefault((panel.together, 0 if panel.together else k), []).append(panel)
        return tuple(map(tuple, groups.values()))


class TableSpot(NamedTuple):
    """A table, or a part of one, where it stands: its upper left corner, and how it is set."""

    table: RuledTable
    corner: complex
    setting: Setting


class Composition(NamedTuple):
    """One composed sheet: where each figure, by its name, stands, each piece of lettering, the tables, the notes."""

    spots: Mapping[str, Spot]
    blocks: Mapping[str, Field]
    tables: tuple[TableSpot, ...] = ()
    notes: Field | None = None
