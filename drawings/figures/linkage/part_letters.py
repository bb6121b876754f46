"""Letters of relative vectors and parts on the plans of velocities and accelerations: v_BA, a^n_BA (обозначения).

A vector bears its letter where it is as long as that and an arrowhead; the longest choose their places first.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.lettering.indices import with_index
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Statement
from drawings.paper.strokes import Group, Text
from drawings.paper.ties import tied
from drawings.paper.walk import stating
from drawings.symbols.symbols import ARROW_LENGTH
from plans.linkage.letters import POLES

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


def part_letter(name: str, drafting: Drafting) -> str:
    """Write the letter of a part as courses of the sheet's language do: a^n_BA with its index lowered."""
    return drafting.letter(with_index(name))


def is_relative(name: str, vector: str) -> bool:
    """Tell whether a part is no whole velocity or acceleration of a point, whose end bears the point's letter.

    >>> is_relative("v_A3", "p a3"), is_relative("v_BA", "a b"), is_relative("a^n_A", "π n_A")
    (False, True, True)
    """
    return "^" in name or vector.split(" ", maxsplit=1)[0] not in POLES.values()


def least_length(text: str, hand: Hand) -> float:
    """Give how long a vector is at least that bears a letter beside it, mm."""
    return text_width(Text(0j, text, hand.number, "start", True)) + ARROW_LENGTH * hand.symbol


def _up(part: LaidPart) -> float:
    return cmath.phase(part.end - part.start) + math.pi / 2


def letter_parts(parts: Iterable[LaidPart], labels: Labels, hand: Hand, plan: str) -> Group:
    """Letter vectors beside their middles, the longest first."""
    order = sorted(parts, key=lambda part: -tied(part.length))
    return Group(
        tuple(
            stating(one.states, labels.along(one.start, one.end, one.text, hand.number, GAP, _up(one))) for one in order
        ),
        f"{plan}-{PARTS}",
    )
