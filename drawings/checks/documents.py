"""What the title blocks and the scales of a set must say, whatever its sheets show (надписи и масштабы комплекта)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.page.page import BLOCK
from drawings.page.title_cell import NUMBERS
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups, texts
from plans.scene.sheet import SheetTable
from plans.words.words import message

Sheets = Sequence[tuple[Mapping[str, str], Measured]]  # how names of figures begin, and their keys of [sheet.scale]

# Keys that govern an axis of graphs, with the quantities of the marks along it: the others measure ordinates.
AXES: Mapping[str, tuple[str, ...]] = {"angle": (), "way": ("S", "ψ")}


def block_faults(leaf: Leaf, sheet: SheetTable) -> Iterator[Wrong]:
    """Give what the title block says otherwise than the set: its number among the sheets of its document, its name."""
    document = leaf.metadata["document"]
    name, number, count = (document[key] for key in ("designation", "sheet", "sheets"))
    gost = [f"{number}"] * (count > 1) + [f"{count}"] * (number == 1)
    block = [group for group in groups(leaf.groups) if group.name in (BLOCK, NUMBERS)]
    told = [text.plain for group in block if group.name == NUMBERS for text in texts(group.strokes)]
    if told != (gost if sheet.standard == "GOST" else [f"{number}/{count}"]):
        yield message("wrong.sheet_number", number=number, count=count, kind=leaf.metadata["sheet"])
    if name.replace(" ", "") not in "".join(text.plain for text in texts(block)).replace(" ", ""):
        yield message("wrong.designation", name=name, kind=leaf.metadata["sheet"])


def scale_faults(sheets: Sheets, sheet: SheetTable) -> Iterator[Wrong]:
    """Give the figures of measured sheets whose marks have another scale than the scene states for them."""
    stated = dict(sheet.scale.stated)
    for keys, measured in sheets if stated else ():
        for mark in (*measured.vectors, *measured.points, *measured.profiles):
            figure = f"{mark.plan.replace(' ', '-')}-"
            key = next((key for begin, key in keys.items() if figure.startswith(begin)), "")
            if mark.quantity in AXES.get(key, (mark.quantity,)) and mark.scale != stated.get(key, mark.scale):
                yield on("scale_stated", mark.plan)
