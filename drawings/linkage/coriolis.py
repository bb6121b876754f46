"""The direction of a Coriolis acceleration as a small figure: the slip turned with the guide (правило Жуковского)."""

import cmath
import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from drawings.layout.ink import Ink
from drawings.layout.labels import Labels, Lines
from drawings.lettering.lettering import bounds
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Group, Line, Statement, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.symbols import arrowhead
from geometry.board import Mark, at
from geometry.meet import cross
from plans.linkage.plan import POLES

PARTS = "parts"  # the group of their letters, after the name of their plan
GAP = 1.4  # mm between a vector and its letter: nearer the line itself is felt under the letter


class LaidPart(NamedTuple):
    """A vector on paper with its letter."""

    start: complex
    end: complex
    text: str
    states: Statement

    @property
    def length(self) -> float:
        """Its length on paper, mm."""
        return abs(self.end - self.start)


def is_relative(name: str, vector: str) -> bool:
    """Tell whether a part is no whole velocity or acceleration of a point, whose end bears the point's letter.

    >>> is_relative("v_A3", "p a3"), is_relative("v_BA", "a b"), is_relative("a^n_A", "π n_A")
    (False, True, True)
    """
    return "^" in name or vector.split(" ", maxsplit=1)[0] not in POLES.values()


def letter_parts(parts: Iterable[LaidPart], lines: Lines, labels: Labels, hand: Hand, plan: str) -> Group:
    """Letter vectors beside their middles, the longest first, each nearer to it than to others of its plan."""
    texts = list[Stroke]()
    for v in sorted(parts, key=lambda part: -tied(part.length)):
        others = [line for line in lines if line != (v.start, v.end)]
        up = cmath.phase(1j * (v.end - v.start))
        texts.append(stating(v.states, labels.along(v.start, v.end, v.text, hand.number, GAP, up, others)))
    return Group(tuple(texts), f"{plan}-{PARTS}")


ARM = 3.2  # length of either vector, in sizes of a letter
STEP, AROUND = 4.0, 60.0  # mm: the search for a free place, step by step, and how far around the plan
APART = 2.0  # mm between the figure and everything else


class QuarterTurn(NamedTuple):
    """A slip and the Coriolis acceleration that it gives, of true size; `sense` is that of the guide's turning."""

    slip: complex
    result: complex
    sense: int
    size: float
    letter: str


def quarter_turn(mark: Mark, column: int) -> QuarterTurn | None:
    """Read the figure off the record of an acceleration plan; nothing where the slip or the turning is zero."""
    if mark.step.op != "similar" or not mark.name.startswith("a^k_"):
        return None
    image, guide, slip = (at(side.point, column) for side in mark.step.inputs)
    turning = float(cross(guide, image))
    if turning == 0 or abs(slip) == 0 or cmath.isnan(slip):
        return None
    direction = slip / abs(slip)
    sense = 1 if turning > 0 else -1
    size = abs(at(mark.point, column))
    return QuarterTurn(direction, 1j * sense * direction, sense, size, mark.name)


def rule(shown: QuarterTurn, centre: complex, hand: Hand) -> Group:
    """Draw the slip, the acceleration, and the quarter turn between them."""
    arm = ARM * hand.letter
    corner = centre - arm / 2 * (shown.slip + shown.result)
    strokes: list[Stroke] = []
    for direction in (shown.slip, shown.result):
        tip = corner + arm * direction
        head = arrowhead(corner, tip)
        strokes += [Line(corner, tip, hand.other), *([head] if head is not None else [])]
    start, end = sorted((0.0, shown.sense * math.pi / 2))
    base, radius = cmath.phase(shown.slip), arm / 2
    strokes.append(Arc(corner, radius, base + start, base + end, hand.drafted))
    tip = corner + radius * shown.result
    back = corner + cmath.rect(radius, base + shown.sense * (math.pi / 2 - 0.4))
    head = arrowhead(back, tip)
    strokes += [head] if head is not None else []
    return Group((*strokes, *_letters(shown, corner, arm, hand)))


def _letters(shown: QuarterTurn, corner: complex, arm: float, hand: Hand) -> list[Stroke]:
    texts: list[Stroke] = []
    for direction, content in ((shown.slip, "v_r"), (shown.result, shown.letter)):
        text = Text(0j, content, hand.text, "start", True)
        left, bottom, right, top = bounds(text)
        half = complex(right - left, top - bottom) / 2
        reach = 1.0 + abs(half.real * direction.real) + abs(half.imag * direction.imag)
        spot = corner + (arm + reach) * direction - half - complex(left, bottom)
        texts.append(Text(spot, content, hand.text, "start", True))
    return texts


def _outward(rings: int) -> Iterator[complex]:
    """Give the places of a square grid ring by ring, each ring from the middles of its sides to its corners."""
    yield 0j
    for ring in range(1, rings + 1):
        for along in range(2 * ring):
            off = (along + 1) // 2 * (1 if along % 2 else -1)
            for turn in (1, 1j, -1, -1j):
                yield complex(ring, off) * turn


def draw_nearby(shown: QuarterTurn, box: Field, ink: Ink, hand: Hand) -> Group | None:
    """Draw the figure in the free place nearest to its plan; nothing where there is none."""
    left, bottom, right, top = bounds(rule(shown, 0j, hand))
    middle = complex(left + right, bottom + top) / 2
    half = complex(right - left, top - bottom) / 2 + APART * (1 + 1j)
    for off in _outward(math.ceil((max(box.width, box.height) / 2 + AROUND) / STEP)):
        spot = box.centre + off * STEP
        if spot.real < abs(half.real) or spot.imag < abs(half.imag):
            continue
        low, high = spot - half, spot + half
        if not ink.under((low.real, low.imag, high.real, high.imag)):
            group = rule(shown, spot - middle, hand)
            ink.draw([group])
            return group
    return None
