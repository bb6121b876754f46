"""The self-check of ticks and numbers on trajectories: each at a point of then (засечки траекторий)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.linkage.laid import LaidMechanism
from drawings.checks.linkage.position_marks import EXACT, named
from drawings.checks.wrong import on
from drawings.figures.linkage.position_letters import NUMBERS
from drawings.figures.linkage.position_plan import TICKS
from drawings.paper.strokes import Leaf, Line
from plans.analytic.balance.mass_centre import placed
from plans.model.mechanism import FRAME
from plans.model.order import POSITIONS
from plans.words.words import Message


def faults(leaf: Leaf, laid: LaidMechanism) -> Iterator[Message]:
    """See that ticks are across places of points in the positions, and that numbers stand at places of their own."""
    places = _places(laid)
    known = [spot for spots in places.values() for spot in spots]
    for group in named(leaf, TICKS):
        middles = [(line.start + line.end) / 2 for line in group.strokes if isinstance(line, Line)]
        wrong = sum(not min(abs(middle - spot) for spot in known) <= EXACT for middle in middles)
        if wrong or len(middles) < len(group.strokes):
            yield on("ticks", POSITIONS.plan, count=wrong)
    for group in named(leaf, NUMBERS):
        for text, labels in labels_of(group.strokes).items():
            if not all(distance([label], places.get(text, ())) <= NEAREST for label in labels):
                yield on("path_number", POSITIONS.plan, name=text)


def _places(laid: LaidMechanism) -> dict[str, list[complex]]:
    """Place all moving points and mass centres in all positions on paper, by the positions' numbers."""
    fixed = laid.mechanism.links[FRAME].points
    rows = [moved.r for name, moved in laid.motion.points.items() if name not in fixed]
    rows += [placed(laid.mechanism, laid.motion, *mass) for mass in laid.centres.values()]
    count = len(laid.motion.phi)
    return {str(k): [laid.at.on(complex(row[k])) for row in rows if not math.isnan(row[k].real)] for k in range(count)}
