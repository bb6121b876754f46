"""Documents of a set (документы комплекта): sheets of one designation are numbered and counted through (ГОСТ 2.104)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace

from drawings.page.page import BLOCK, Page, page_of
from drawings.page.title_cell import NUMBERS
from drawings.paper.strokes import Group, Leaf, Stroke
from plans.scene.scene import Scene

Leaves = Mapping[str, Sequence[Leaf]]


def bind(leaves: Leaves, scene: Scene) -> Leaves:
    """Number the sheets of a scene, in the order of its kinds, through each document that they make up."""
    designations = {kind: scene.sheet.designated(kind) for kind in leaves}
    counts = Counter(designations[kind] for kind, own in leaves.items() for _ in own)
    found: dict[str, tuple[Leaf, ...]] = {}
    for kind, own in leaves.items():
        name = designations[kind]
        first = 1 + sum(len(other) for before, other in found.items() if designations[before] == name)
        page = page_of(scene, kind)
        found[kind] = tuple(_numbered(leaf, page, first + k, counts[name]) for k, leaf in enumerate(own))
    return found


def _numbered(leaf: Leaf, page: Page, sheet: int, sheets: int) -> Leaf:
    """Write the number of a sheet and how many its document has into its title block, and into its data."""
    numbers = page.numbers(sheet, sheets)
    groups = tuple(_filled(group, numbers) if group.name == BLOCK else group for group in leaf.groups)
    document = {"designation": page.designation, "sheet": sheet, "sheets": sheets}
    return replace(leaf, groups=groups, metadata={**leaf.metadata, "document": document})


def _filled(block: Group, numbers: Group) -> Group:
    strokes: list[Stroke] = [
        numbers if isinstance(stroke, Group) and stroke.name == NUMBERS else stroke for stroke in block.strokes
    ]
    return replace(block, strokes=tuple(strokes))
