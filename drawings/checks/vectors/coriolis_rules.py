"""The self-check of the small figures that tell how Coriolis accelerations are directed (правило Жуковского)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import NamedTuple

from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.letters import NEAREST
from drawings.checks.linkage.position_marks import EXACT
from drawings.checks.vectors.laid_vectors import LaidVectorPlan
from drawings.checks.wrong import on
from drawings.figures.linkage.vector_plan import LEAST
from drawings.paper.strokes import Arc
from drawings.paper.walk import groups
from plans.model.dyad import Dyad
from plans.model.mechanism import FRAME
from plans.model.order import ACCELERATIONS
from plans.words.words import Message

TURNED = 1e-3  # rad by which a vector so short may lean: its ends are rounded
ARM = 3.2  # sizes of a letter that either vector is long
SLIP = "v_r"  # the letter of the slip


class Rule(NamedTuple):
    """A slip and the acceleration that it gives by the analysis: unit vectors, and the letter of the latter.

    Both are drawn as long as `arm` mm, and the turn between them half as far from their corner.
    """

    slip: complex
    result: complex
    letter: str
    arm: float

    def shown(self, strokes: FigureStrokes) -> bool:
        """Tell whether a figure shows it: both vectors from one corner with their letters, and the turn between."""
        ways = {SLIP: self.slip, self.letter: self.result}
        arrows = {
            name: [one for one in strokes.pointings if _along(one.tip - one.start, way)] for name, way in ways.items()
        }
        if not all(len(found) == 1 for found in arrows.values()):
            return False
        slip, result = (found[0] for found in arrows.values())
        lettered = all(strokes.far(name, [found[0].tip]) <= NEAREST for name, found in arrows.items())
        long = all(abs(abs(one.tip - one.start) - self.arm) <= EXACT for one in (slip, result))
        return lettered and long and abs(slip.start - result.start) <= EXACT and self._turned(strokes, slip.start)

    def _turned(self, strokes: FigureStrokes, corner: complex) -> bool:
        """Tell whether an arc with a head goes from the slip to the acceleration, and the head points that way."""
        sense = 1 if (self.result / self.slip).imag > 0 else -1
        start, end = (self.slip, self.result) if sense > 0 else (self.result, self.slip)
        arcs = (one for one in strokes.arcs if abs(one.centre - corner) <= EXACT)
        heads = [one.tip - corner for one in strokes.turnings if one.sense == sense]
        return any(
            abs(arc.radius - self.arm / 2) <= EXACT
            and _along(arc.at(0.0) - corner, start)
            and _along(arc.at(1.0) - corner, end)
            and any(abs(tip - arc.radius * self.result) <= EXACT for tip in heads)
            for arc in arcs
        )


def faults(laid: LaidVectorPlan) -> Iterator[Message]:
    """See that each Coriolis acceleration that is seen has its figure, and that no other stands there."""
    if laid.plan != ACCELERATIONS.plan or laid.figure is None:
        return
    shown = [
        FigureStrokes(one) for one in groups((laid.figure,)) if any(isinstance(stroke, Arc) for stroke in one.strokes)
    ]
    due = list(_due(laid))
    for rule in due:
        if not any(rule.shown(one) for one in shown):
            yield on("rule", laid.plan, name=rule.letter, position=laid.position)
    if len(shown) > len(due):
        yield on("rule", laid.plan, name="a^k", position=laid.position)


def _due(laid: LaidVectorPlan) -> Iterator[Rule]:
    for group in laid.groups:
        for one in laid.sums.of(group) if isinstance(group, Dyad) else ():
            slip, result = one.velocity[1], one.acceleration[1]
            if not one.turns and one.link != FRAME and abs(result) >= LEAST * laid.scale:
                letter = f"a^k_{{{one.images[1].removeprefix('k_')}}}"
                yield Rule(slip / abs(slip), result / abs(result), letter, ARM * laid.drafting.hand.letter)


def _along(way: complex, true: complex) -> bool:
    return way != 0 and abs(cmath.phase(way / true)) <= TURNED
