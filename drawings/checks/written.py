"""What is written on a sheet: numbers and scales as they are read, title blocks and stated scales held (надписи)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain

from drawings.checks.expected import Wrong, on
from drawings.lettering.words import number
from drawings.page.page import BLOCK
from drawings.page.title_cell import NUMBERS
from drawings.paper.statement import Kind
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import groups, texts
from drawings.reading.measure import Measured
from plans.scene.sheet import SheetTable
from plans.words.words import Message, message

_NUMBER = re.compile(r"[-−]?\d+(?:[.,]\d+)?")
PAPER = "mm"  # the unit of what is drawn in millimetres of paper, to no scale
_MARKED = ("vector", "point")  # the kinds of marks that are drawn to scale
_SCALE = re.compile(r"(μ|K)(\S+) = (\d+(?:[.,]\d+)?)\s")  # of a plan, after its letter: mu_v, K_v


def reads(text: str, true: float, slack: float, digits: int = 0) -> bool:
    """Tell whether a text is a value to the half of its last digit, beside what the two roads may differ by.

    Of a number written with so many `digits` its end may be left off that is zero.

    >>> reads("0.096", 0.0961, 0.0), reads("0.096", 0.0961, 0.0, 5), reads("123460", 123456.0, 0.0, 5)
    (True, False, True)
    """
    if text == "—":
        return math.isnan(true)
    found = value(text)
    if found is None:
        return False
    last: float = -len(re.split("[.,]", text)[-1]) if re.search("[.,]", text) else 0
    if digits:
        last = math.floor(math.log10(abs(true))) + 1 - digits if true else -math.inf
    return abs(found - true) <= 0.5000001 * math.pow(10.0, last) + 1e-9 * abs(true) + slack


def value(text: str) -> float | None:
    """Read a number; None of what is none.

    >>> value("−0,5"), value("—")
    (-0.5, None)
    """
    return float(text.replace("−", "-").replace(",", ".")) if _NUMBER.fullmatch(text) else None


def marked_scales(leaf: Leaf) -> Iterator[Message]:
    """Name the figures whose marks or axes are drawn to no written scale: of their letter there, else anywhere."""
    scales = [_stated((figure,)) for figure in leaf.groups]
    everywhere = set(chain(*(pairs for stated in scales for pairs in stated.values())))
    for figure, stated in zip(leaf.groups, scales, strict=True):
        tree = [*groups((figure,))]
        marks = (part.data for part in tree if part.data.get("kind") in _MARKED and part.data["unit"] != PAPER)
        drawn = {(data["quantity"], float(data["scale"])) for data in marks}
        drawn |= {("", part.states.scale) for part in tree if part.states is not None and part.states.kind is Kind.AXIS}
        for letter, mu in drawn if everywhere else ():
            if not _written(mu, stated.get(letter) or everywhere):
                yield message("wrong.scale", text=figure.name)


def _stated(figures: Iterable[Group]) -> dict[str, set[tuple[str, str]]]:
    """Read the scales that figures state: by their letters the symbol, mu or K, and the number."""
    stated: dict[str, set[tuple[str, str]]] = {}
    for symbol, letter, size in (found for text in texts(figures) for found in _SCALE.findall(text.plain)):
        stated.setdefault(letter, set()).add((symbol, size.replace(",", ".")))
    return stated


def _written(mu: float, stated: Iterable[tuple[str, str]]) -> bool:
    return any(size == number(1 / mu if symbol == "K" else mu) for symbol, size in stated)


def written_scales(group: Group) -> dict[str, float]:
    """Read the scales that a figure states by their letters, true units a mm; a K is the inverse of mu, 0 is none.

    >>> from drawings.paper.strokes import Text
    >>> written_scales(Group((Text(0j, "μ_{φ} = 0,02 рад/мм;  K_M = 4 mm/(N·m);  K_A = 0 mm/J"),)))
    {'φ': 0.02, 'M': 0.25}
    """
    found = (match for text in texts((group,)) for match in _SCALE.finditer(text.plain))
    pairs = ((match[1], match[2], float(match[3].replace(",", "."))) for match in found)
    return {letter: 1 / value if kind == "K" else value for kind, letter, value in pairs if value}


Sheets = Sequence[tuple[Mapping[str, str], Measured]]  # how names of figures begin, and their keys of [sheet.scale]

# Keys that govern an axis of graphs, with the quantities of the marks along it: the others measure ordinates.
AXES: Mapping[str, tuple[str, ...]] = {"angle": (), "way": ("S", "ψ")}


def block_faults(leaf: Leaf, sheet: SheetTable) -> Iterator[Wrong]:
    """Give what the title block says otherwise than the set: its number among the sheets of its document, its name."""
    document = leaf.metadata["document"]
    name, number, count = (document[key] for key in ("designation", "sheet", "sheets"))
    gost = [f"{number}"] * (count > 1) + [f"{count}"] * (number == 1)
    block = [group for group in groups(leaf.groups) if group.name in (BLOCK, NUMBERS)]
    numbers = [text.plain for group in block if group.name == NUMBERS for text in texts(group.strokes)]
    if numbers != (gost if sheet.standard == "GOST" else [f"{number}/{count}"]):
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
