"""The composer: where on which sheets the contents stand, at which scales (компоновка листов)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from drawings.layout import column_composer, foremost_composer
from drawings.layout.contents import Composition, Contents, Item, Panel, TableSpot
from drawings.layout.picture import Picture, Spot
from drawings.layout.table import RuledTable
from drawings.page.page import Page
from drawings.page.scale import Scale

FURTHER = "table-{}"  # the name of a table that stands among the figures


def compose(contents: Contents, page: Page) -> tuple[Composition, ...]:
    """Compose contents on as many sheets as keep every figure readable, the largest figures that fit."""
    further = {FURTHER.format(k + 2): table for k, table in enumerate(contents.tables[1:])}
    if further:
        panels = tuple(Panel(table.block(name)) for name, table in further.items())
        contents = replace(contents, panels=(*contents.panels, *panels), tables=contents.tables[:1])
    composed = tuple(
        foremost_composer.compose(contents, page)
        if foremost_composer.fits(contents)
        else column_composer.compose(contents, page)
    )
    return _levelled(contents, [_tabled(one, further) for one in composed])


def _tabled(one: Composition, further: Mapping[str, RuledTable]) -> Composition:
    """Set the tables that stand among the figures."""
    standing = ((further[name], box) for name, box in one.blocks.items() if name in further)
    own = tuple(TableSpot(table, complex(box.left, box.top), table.setting(box)) for table, box in standing)
    blocks = {name: box for name, box in one.blocks.items() if name not in further}
    return one._replace(blocks=blocks, tables=(*one.tables, *own)) if own else one


def _levelled(contents: Contents, composed: Sequence[Composition]) -> tuple[Composition, ...]:
    """Draw figures that want one scale at the smallest scale that one of them has."""
    spots = {name: spot for one in composed for name, spot in one.spots.items()}
    keys = {panel.item.name: panel.scale for panel in contents.panels if panel.scale and _sized(panel.item)}
    scales: dict[str, Scale] = {}
    for name, key in keys.items():
        scales[key] = max(scales.get(key, spots[name].scale), spots[name].scale)
    shared = {name: Spot(spots[name].box, scales[key]) for name, key in keys.items()}
    return tuple(
        one._replace(spots={name: shared.get(name, spot) for name, spot in one.spots.items()}) for one in composed
    )


def _sized(item: Item) -> bool:
    """Tell whether an item is more than a point, which has any scale."""
    return isinstance(item, Picture) and max(item.wide, item.high) > 0
