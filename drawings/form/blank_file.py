"""The file of a form: written without a seal, and seen again, so that nothing is on it but what the scene gives."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from drawings.checks.verify import SelfCheckFailed
from drawings.form.laid import SCALE, Given, given
from drawings.page.page import BLOCK
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Arc, Curve, Fill, Group, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat, groups
from drawings.pens.svg import svg
from drawings.reading.measure import check
from drawings.reading.sheet import SeenSheet, see, ungiven
from drawings.sheets.kind import table_of
from plans.linkage.reading.linkage import described
from plans.model.mechanism import FRAME
from plans.study import Study
from plans.words.words import message

SEAL = b'<metadata id="seal">'
PAGE = ("frame", BLOCK)  # groups of the page itself: by the standard, and what the author wrote
BENT = (Arc, Curve, Polyline)  # strokes that no place of a form has
STRAIGHT = (Line, Fill)  # and those that only places, axes and tables have
LINED = ("place", "axes")  # what groups with lines say that they are
RATIO = re.compile(r"\(\d+(?:[.,]\d+)?:\d+(?:[.,]\d+)?\)$")  # a scale of lengths as it is written again
NEAR = 1e-9  # of a fixed point's coordinate: what twelve digits in a file leave of it
MOST = 5  # of what is told too much, that is named


def blank_file(leaf: Leaf) -> bytes:
    """Write a sheet of a form, unsealed: it is there to be drawn on."""
    return svg(leaf).partition(SEAL)[0] + b"</svg>\n"


def see_blank(source: bytes, study: Study) -> None:
    """See that a written form has no vector, no point but poles and fixed ones, no curve, no number not given."""
    try:
        sheet = see(source)
    except SheetRefused as refused:
        raise SelfCheckFailed(message("check.unmeasured", refusal=refused)) from refused
    lines = [
        *_marks(sheet, study),
        *(
            group.name or group.title or type(group.strokes[0]).__name__
            for group in groups(group for group in ungiven(sheet.written).groups if group.name not in PAGE)
            if any(isinstance(stroke, BENT) for stroke in group.strokes)
        ),
        *_astray(ungiven(sheet.written), study.scene.sheets),
        *_numbers(sheet.written, given(study.scene)),
    ]
    if lines:
        raise SelfCheckFailed(message("check.form", told=tuple(dict.fromkeys(lines))[:MOST]))


def _marks(sheet: SeenSheet, study: Study) -> Iterator[str]:
    """Name the vectors, the points that the scene does not fix, and those that are not drawn where they are."""
    yield from (f"{miss.key.plan} {miss.key.name}" for miss in check(sheet.measured))
    yield from (f"{vector.plan} {vector.name}" for vector in (*sheet.measured.vectors, *sheet.measured.profiles))
    fixed = described(study.scene).links[FRAME].points if "linkage" in study.scene.techniques else {}
    for point in sheet.measured.points:
        if point.name not in fixed or abs(point.stated - fixed[point.name]) > NEAR * abs(point.stated):
            yield f"{point.plan} {point.name}"


def _astray(leaf: Leaf, sheets: Iterable[str]) -> Iterator[str]:
    """Name the groups with lines that are no place, no axes and no table of some sheets, beside the page itself."""
    for group in (group for group in leaf.groups if group.name not in PAGE):
        known = group.data.get("kind") in LINED or any(table_of(kind, group.name) for kind in sheets)
        if not known and any(isinstance(stroke, STRAIGHT) for stroke in _unled(group)):
            yield group.name or group.title or Line.__name__


def _unled(group: Group) -> Iterator[Stroke]:
    """Give the strokes of a group that are no leaders with their letters."""
    if [type(stroke) for stroke in group.strokes] != [Line, Text]:
        for stroke in group.strokes:
            yield from _unled(stroke) if isinstance(stroke, Group) else (stroke,)


def _numbers(leaf: Leaf, known: Given) -> Iterator[str]:
    """Give the lettering, beside that of the page itself, that writes a number which is no scale and not given."""
    strokes: Iterator[Stroke] = flat(group for group in leaf.groups if group.name not in PAGE)
    for text in (stroke for stroke in strokes if isinstance(stroke, Text)):
        if not known.says(RATIO.sub("", SCALE.sub("", text.plain))):
            yield text.plain
