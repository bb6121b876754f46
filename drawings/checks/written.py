"""Numbers and scales as they are written on a sheet, read back (чтение чисел и масштабов)."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterator, Sequence

from drawings.lettering.words import number
from drawings.paper.statement import Kind
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import groups, texts
from plans.words.words import Message, message

MARKED = ("vector", "point")
_NUMBER = re.compile(r"[-−]?\d+(?:[.,]\d+)?")
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


def last_place(text: str) -> float:
    """Give what one in the last place of a number is worth.

    >>> last_place("0,25"), last_place("−14")
    (0.01, 1.0)
    """
    return math.pow(10.0, -len(re.split("[.,]", text)[-1])) if re.search("[.,]", text) else 1.0


def marked_scales(leaf: Leaf) -> Iterator[Message]:
    """Name the written scales of figures and headings to which no mark of their letter and no axis is drawn."""
    for figure in leaf.groups:
        own = [*groups(one for one in leaf.groups if one is figure or (figure.name and _below(one, figure)))]
        marks = {(one.data["quantity"], float(one.data["scale"])) for one in own if one.data.get("kind") in MARKED}
        axes = {one.states.scale for one in own if one.states is not None and one.states.kind is Kind.AXIS}
        for text in (text.plain for text in texts((figure,))):
            if not _agrees(text, marks, axes):
                yield message("wrong.scale", text=text)


def _below(one: Group, head: Group) -> bool:
    """Tell whether a figure stands under a heading: "diagrams-travel" under "diagrams"."""
    return one.name.startswith(f"{head.name}-")


def _agrees(text: str, marks: Collection[tuple[str, float]], axes: Collection[float]) -> bool:
    """Tell whether the scales of a line are those of marks of their letters, one of the others that of an axis."""
    written = [found.groups() for found in _SCALE.finditer(text)] if _SCALE.match(text) else []
    letters = {quantity for quantity, _ in marks}
    known = [one for one in written if one[1] in letters]
    others = [one for one in (written if axes else written[:1]) if one not in known]  # abscissas bear no marks
    every = {*axes, *(mu for _, mu in marks)}
    right = all(_is(one, {mu for quantity, mu in marks if quantity == one[1]}) for one in known)
    lost = text.startswith("μ") and marks and not written
    return right and not lost and (not every or not others or any(_is(one, every) for one in others))


def _is(written: Sequence[str], scales: Collection[float]) -> bool:
    """Tell whether a scale is one of some; K is 1/mu, to its own digits."""
    symbol, _, read = written
    return read.replace(",", ".") in {number(1 / mu if symbol == "K" else mu) for mu in scales}


def written_scales(group: Group) -> dict[str, float]:
    """Read the scales that a figure states by their letters, true units a mm; a K is the inverse of mu, 0 is none.

    >>> from drawings.paper.strokes import Text
    >>> written_scales(Group((Text(0j, "μ_{φ} = 0,02 рад/мм;  K_M = 4 mm/(N·m);  K_A = 0 mm/J"),)))
    {'φ': 0.02, 'M': 0.25}
    """
    found = (match for text in texts((group,)) for match in _SCALE.finditer(text.plain))
    pairs = ((match[1], match[2], float(match[3].replace(",", "."))) for match in found)
    return {letter: 1 / value if kind == "K" else value for kind, letter, value in pairs if value}
