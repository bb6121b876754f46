"""The onlooker: sees a student's sheet as the eye does, and beside it the arrowheads and texts of other editors."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from types import MappingProxyType

from drawings.checks.letters import Label, labels_of
from drawings.grading.cells.asked_table import NUMBER, levelled, plainly, value_of
from drawings.grading.seeing.units import boxed_in, in_system, in_unit, stated
from drawings.lettering.lettering import UnknownLetter, lacking, text_width
from drawings.lettering.vector_letters import with_index
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Leaf, Run, Stroke, Text
from drawings.paper.walk import flat, texts
from drawings.reading.alphabet import folded
from drawings.reading.ink import Ink, length
from drawings.reading.pathdata import number
from drawings.reading.sheet import EM, Observer, Opened, without
from drawings.reading.transform import Viewport
from drawings.reading.visibility import declarations, said

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


LENGTHS = "l"  # what a scale of lengths is lettered
METRE = 1000.0  # mm
_STATED = re.compile(
    r"(?<![^\W\d_])(?P<kind>μ|mu|K|К)[_\s]?[{(]?(?P<letter>[^\s=:≈{}()]{1,6}?)[})]?\s*[=:≈]\s*"
    rf"{NUMBER}(?:\s*/\s*(?P<under>\d+(?:[.,]\d+)?))?(?=(?P<rest>[^;=,]*))"
)
_RATIO = re.compile(r"\(?(?:M|М|[Ss]cale|[Мм]асштаб)?\s*(\d+(?:[.,]\d+)?)\s*:\s*(\d+(?:[.,]\d+)?)\)?")


def stated_scales(texts: Iterable[Text], due: Mapping[str, str]) -> dict[str, float]:
    """Give the scales that texts state, true units a mm, by the letters that are due with their units; the first goes.

    >>> stated_scales([Text(0j, "μ_{v} = 10 (mm/s)/mm, K_M=2.5·10^{-4} mm/(N·m)")], {"v": "m/s", "M": "N*m"})
    {'v': 0.01, 'M': 4000.0}
    """
    found: dict[str, float] = {}
    for text in texts:
        own = ((letter, next(scales_of(text, letter, unit), None)) for letter, unit in due.items())
        found = {letter: mu for letter, mu in own if mu is not None} | found
    return found


def scales_of(text: Text, letter: str, unit: str) -> Iterator[float]:
    """Give the scales of one letter that a text states, true units a mm; one of lengths may be a ratio.

    >>> [*scales_of(Text(0j, "μl = 0.0025 m/mm (1:2.5)"), "l", "m")], [*scales_of(Text(0j, "M 1:2"), "l", "m")]
    ([0.0025], [0.002])
    """
    plain = plainly(levelled(text))
    for found in _STATED.finditer(plain):
        under = float((found["under"] or "1").replace(",", "."))
        if folded(found["letter"]) == folded(letter) and (value := value_of(found)[0]) and under:
            mu = value / under * _worth(found["rest"], unit, found["kind"] in "KК")
            yield 1 / mu if found["kind"] in "KК" else mu
    if letter == LENGTHS and (ratio := _RATIO.fullmatch(plain)):
        paper, true = (float(one.replace(",", ".")) for one in ratio.groups())
        if paper and true:
            yield true / paper / METRE


def _worth(rest: str, unit: str, inverse: bool) -> float:
    """Give by what a number is multiplied whose unit stands before other words; by nothing where it has none.

    A unit of another quantity is taken as it is: it is the number that tells a plan by its scale.
    """
    words = re.split(r"\(\d", rest)[0].split()
    for count in range(len(words), 0, -1):
        times = _times(" ".join(words[:count]), unit, inverse)
        if times is not None:
            return times
    return 1.0


def _times(own: str, unit: str, inverse: bool) -> float | None:
    """Give what a unit is worth in that which is due, or in that of the system where none is known.

    Where it has no mm in it, it is of what one mm shows.
    """
    if unit:
        told = in_unit(own, f"mm/({unit})" if inverse else f"({unit})/mm")
        return in_unit(own, unit) if told is None and not inverse else told
    worth = in_system(own)
    if worth is None or not re.search("mm|мм", own):
        return worth
    return worth * METRE if inverse else worth / METRE


def legible(leaf: Leaf) -> Leaf:
    """Give a leaf without texts in letters that no alphabet of ours has: none of them names a place of a plan."""
    return without(leaf, [one for one in texts(leaf.groups) if not _known(one)])


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
    own = {**attributes, **declarations(said(attributes))}
    return frozenset(name for name in (BEGIN, END) if own.get(name, "none") != "none")
