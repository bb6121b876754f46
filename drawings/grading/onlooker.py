"""The onlooker: sees a student's sheet as the eye does, and beside it the arrowheads and texts of other editors."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from types import MappingProxyType
from typing import NamedTuple

from drawings.checks.hold import Label, labels_of
from drawings.lettering.lettering import UnknownLetter, lacking, text_width
from drawings.lettering.words import with_index
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Fill, Leaf, Line, Polyline, Run, Stroke, Text
from drawings.paper.walk import flat, groups, texts
from drawings.reading.alphabet import folded
from drawings.reading.pathdata import number
from drawings.reading.sheet import EM, Observer, Opened, without
from drawings.reading.transform import STAY, Affine, Viewport
from drawings.reading.visibility import LineInk, declarations, length, said

_NAMES = {"pi": "π"}


@lru_cache(maxsize=1024)
def spelled(letter: str) -> str:
    """Write a letter as anybody may write it: without the marks of levels, as it looks.

    >>> spelled("n_A"), spelled("n_{A}") == spelled("nA"), spelled("pi") == spelled("π")
    ('nA', True, True)
    """
    plain = Text(0j, letter if "{" in letter else with_index(letter)).plain
    plain = re.sub(r"[_{}^\s]", "", plain)
    return folded(_NAMES.get(plain, plain))


def spelled_labels(strokes: tuple[Stroke, ...]) -> dict[str, list[Label]]:
    """Give the labels of strokes by how their letters look; one label may bear several."""
    found: dict[str, list[Label]] = {}
    for letter, labels in labels_of(strokes).items():
        found.setdefault(spelled(letter), []).extend(labels)
    return found


def legible(leaf: Leaf) -> Leaf:
    """Give a leaf without texts in letters that no alphabet of ours has: none of them names a place of a plan."""
    return without(leaf, [text for text in texts(leaf.groups) if not _known(text)])


def _known(text: Text) -> bool:
    try:
        text_width(text)
    except UnknownLetter:
        return False
    return True


BEGIN, END = "marker-start", "marker-end"
SHARES = MappingProxyType({"middle": 0.5, "end": 1.0})  # of a text that lie before its anchor


class Onlooker(Observer):
    """Sees the elements of a sheet one by one; `heads` are the ends with an arrowhead, of strokes by their ids.

    What was `moved` as a whole, turned or scaled, or is drawn in other units than its page says, is laid back; `page`
    is what the student's own page measures, mm.
    """

    def __init__(self, moved: Affine = STAY) -> None:
        super().__init__()
        self.heads: dict[int, frozenset[str]] = {}
        self.moved, self.page = moved, (0.0, 0.0)

    def opened(self, attributes: Mapping[str, str]) -> Viewport:
        """See the paper that a root lays what is drawn on, as it lies; what was moved off it is on its own yet."""
        self.paper = super().opened(attributes)
        self.page = self.paper.width, self.paper.height
        if self.moved != STAY:
            corners = (complex(x, y) for x in (0.0, self.paper.width) for y in (0.0, self.paper.height))
            far = [complex(*self.page), *((corner - self.moved.t) / self.moved.p for corner in corners)]
            back = Affine(1 / self.moved.p, 0j, -self.moved.t / self.moved.p)
            wide, high = max(spot.real for spot in far), max(spot.imag for spot in far)
            self.paper = Viewport(wide, high, back.after(self.paper.placing), self.paper.notes)
        return self.paper

    def leave(self) -> None:
        """See the innermost element end; what an editor writes in a part of a text is of that text."""
        ended = self.open[-1]
        if ended.frame.tag == "text":
            ended.attributes = _begun(ended)
        super().leave()
        if ended.frame.tag == "tspan" and self.open:
            self.open[-1].heard += ended.heard
            placed = {name: ended.attributes[name] for name in ("x", "y") if name in ended.attributes}
            self.open[-1].attributes = {**placed, **self.open[-1].attributes}

    def _add(self, outer: Opened, strokes: tuple[Stroke, ...], ink: LineInk) -> None:
        if self.open and (heads := _heads(self.open[-1].attributes)):
            self.heads |= {id(part): heads for part in flat(strokes)}
        super()._add(outer, strokes, ink)


def _begun(text: Opened) -> Mapping[str, str]:
    """Give the attributes of a text as if it were set from its beginning, wherever it is anchored."""
    share, plain = SHARES.get(text.frame.look.text_anchor, 0.0), "".join(text.heard).strip()
    if not share or lacking(plain):
        return text.attributes
    try:
        start, size = number(text.attributes.get("x", "0")), length(text.frame.look.font_size) / EM
    except SheetRefused:  # what is no number is told where the text itself is read
        return text.attributes
    return {**text.attributes, "x": f"{start - share * text_width(Text(0j, (Run(plain),), size)):.4f}"}


def _heads(attributes: Mapping[str, str]) -> frozenset[str]:
    if "marker" not in attributes.get("style", "") and not {BEGIN, END} & set(attributes):
        return frozenset()
    look = {**attributes, **declarations(said(attributes))}
    return frozenset(name for name in (BEGIN, END) if look.get(name, "none") != "none")


FORCE = "force"  # the kind of marks that are not to scale
TIP = 1.0  # mm: how far the tip of an arrowhead may be from the end of its line
HEAD = 12.0  # mm: a larger filled figure is no arrowhead
JOINED = 2.0  # mm: ends of arrows that are nearer to each other are at one place


class Segment(NamedTuple):
    """A straight line, and whether it has an arrowhead, to which it goes."""

    start: complex
    end: complex
    headed: bool = False


def segments(leaf: Leaf, heads: Mapping[int, Collection[str]]) -> list[Segment]:
    """Give the straight lines of a sheet; one with an arrowhead goes to it, with two both ways, another as drawn.

    Our own arrows of forces are left out: they are not to scale, and no side of a polygon that bears their letters.
    """
    strokes = list(flat(leaf.groups))
    tips = [spot for stroke in strokes for spot in _tips(stroke)]
    unscaled = {
        id(stroke) for group in groups(leaf.groups) if group.data.get("kind") == FORCE for stroke in group.strokes
    }
    inked = (line for line in strokes if id(line) not in unscaled and isinstance(line, Line | Polyline))
    straight = [
        line for line in inked
        if isinstance(line, Line) or (len(line.points) == 2 and line.style.colour != "none")
    ]  # fmt: skip
    double = [line for line in straight if {BEGIN, END} <= set(heads.get(id(line), ()))]
    back = (Segment(end, start, True) for start, end, _ in (_segment(line, heads, tips) for line in double))
    return [*(_segment(line, heads, tips) for line in straight), *back]


def _tips(stroke: Stroke) -> Iterator[complex]:
    """Give the corners of what may be an arrowhead: a small filled figure of three or four of them."""
    points = stroke.points if isinstance(stroke, Fill | Polyline) else ()
    if isinstance(stroke, Polyline) and stroke.style.fill == "none":
        return
    if 3 <= len(points) <= 5 and max(abs(a - b) for a, b in pairwise((*points, points[0]))) <= HEAD:
        yield from points


def _segment(stroke: Stroke, heads: Mapping[int, Collection[str]], tips: Sequence[complex]) -> Segment:
    start, end = (stroke.start, stroke.end) if isinstance(stroke, Line) else stroke.points  # type: ignore[union-attr]
    marked = heads.get(id(stroke), ())
    at_end = END in marked or _near(end, tips)
    at_start = BEGIN in marked or _near(start, tips)
    return Segment(end, start, True) if at_start and not at_end else Segment(start, end, at_end)


def _near(spot: complex, tips: Sequence[complex]) -> bool:
    return any(abs(spot - tip) <= TIP for tip in tips)


def figures(lines: Sequence[Segment]) -> list[list[Segment]]:
    """Put together the segments with arrowheads that hang together by their ends."""
    found: list[list[Segment]] = []
    for line in (line for line in lines if line.headed):
        ends = [[spot for other in figure for spot in other[:2]] for figure in found]
        near = [any(abs(spot - end) <= JOINED for end in line[:2] for spot in spots) for spots in ends]
        touched = [figure for figure, joined in zip(found, near, strict=True) if joined]
        found = [figure for figure in found if figure not in touched]
        found.append([line, *(part for figure in touched for part in figure)])
    return found
