"""The swing of a rocker between its extreme positions, an arc with two arrows about its pivot (угол размаха)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.phases import sized
from drawings.figures.linkage.tracks import output_point
from drawings.lettering.phrase import Phrase
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Stroke
from drawings.paper.walk import stating
from drawings.symbols.symbols import HEAD, turning_arrow
from plans.model.mechanism import FRAME
from plans.model.order import POSITIONS

LETTER = "ψ"
SHARES = (0.45, 0.35, 0.55, 0.25, 0.65, 0.75)  # of the rocker's arm, where its arc may cross it, the best first
LEAST = 4.0  # lengths of an arrow's head that an arc is long at least: below, its two heads hide it


class Swing(NamedTuple):
    """An arc about a rocker's pivot from one of its extreme positions to the other."""

    text: Phrase
    centre: complex
    radius: float
    start: float
    sweep: float

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arc, and the direction away from the pivot there."""
        turn = self.start + self.sweep / 2
        return self.centre + cmath.rect(self.radius, turn), turn

    def strokes(self, pairs: Pairs) -> Iterator[Stroke]:
        """Draw it from its middle to both sides, each half with its arrow."""
        turn, half = self.start + self.sweep / 2, self.sweep / 2
        halves = [
            turning_arrow(self.centre, self.radius, turn, k * half, pairs.hand, pairs.hand.drafted) for k in (-1, 1)
        ]
        yield stating(Statement(Kind.ANGLE, POSITIONS.plan, LETTER), *halves[0], *halves[1])


def swings(pairs: Pairs, language: str) -> tuple[Swing, ...]:
    """Give the arc of an output that rocks about a hinge of the frame; none of any other, or where it has no room."""
    bones, study, tip = pairs.bones, pairs.bones.study, output_point(pairs.bones)
    own = bones.mechanism.links[study.output.link].points
    pivot = next((name for name in own if name in bones.mechanism.links[FRAME].points), None)
    if study.travel is None or study.travel.extremes.sliding or pivot is None or tip is None or tip == pivot:
        return ()
    low, high = study.travel.extremes.reach
    arm, centre = own[tip] - own[pivot], pairs.place.on(bones.mechanism.links[FRAME].points[pivot])
    start, length = low + cmath.phase(arm), pairs.place.length(abs(arm))
    text = sized(LETTER, abs(high - low), language)
    arcs = (Swing(text, centre, share * length, start, high - low) for share in SHARES)
    least = LEAST * HEAD[0] * pairs.hand.symbol
    roomy = [one for one in arcs if one.radius * abs(one.sweep) >= least]
    return tuple(roomy[:1])
