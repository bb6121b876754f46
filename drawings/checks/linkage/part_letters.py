"""The self-check of the letters of relative vectors and of parts on the plans, against the analysis (составляющие)."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from drawings.checks.letters import NEAREST, along, distance, labels_of
from drawings.checks.wrong import on
from drawings.figures.linkage.part_letters import PARTS, least_length, part_letter
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import groups
from plans.words.words import Message


class TruePart(NamedTuple):
    """A part by its letters: which vector of the plan it is, by the names of its ends, and its value by analysis."""

    name: str
    vector: str
    value: complex


class LetteredPlan(NamedTuple):
    """A plan of one position on its sheet: its vectors as they were measured, and what they may be out, mm."""

    plan: str
    position: int
    vectors: tuple[MeasuredVector, ...]
    allowed: float

    def of(self, part: TruePart) -> MeasuredVector | None:
        """Give the vector that a part is, if it is drawn and is what the analysis says."""
        seen = next((one for one in self.vectors if one.name == part.vector), None)
        right = seen is not None and abs(seen.value - part.value) <= self.allowed * seen.scale
        return seen if right else None


def faults(leaf: Leaf, shown: LetteredPlan, parts: Iterable[TruePart], by: Drafting) -> Iterator[Message]:
    """See that each vector that a part is bears its letter where it is long enough, and that no letter is elsewhere."""
    name = f"{shown.plan}-{shown.position}-{PARTS}"
    lettered = (one for one in groups(leaf.groups) if one.name == name)
    labels = labels_of(tuple(stroke for group in lettered for stroke in group.strokes))
    for part in parts:
        letter, vector = part_letter(part.name, by), shown.of(part)
        own = labels.pop(Text(0j, letter).plain, None)
        length = 0.0 if vector is None else abs(vector.end - vector.start)
        must = cmath.isfinite(part.value) and length >= least_length(letter, by.hand) + shown.allowed
        if (must and own is None) or (
            own is not None and not (vector and distance(own, along(vector.start, vector.end)) <= NEAREST)
        ):
            yield on("part", shown.plan, name=part.name, position=shown.position)
    yield from (on("part", shown.plan, name=text, position=shown.position) for text in labels)
