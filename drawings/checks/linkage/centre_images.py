"""The self-check of mass centres on the plans of velocities and accelerations (центры масс на планах)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.wrong import on
from drawings.figures.linkage.vector_plan import LEAST
from drawings.lettering.indices import with_index
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import groups
from plans.checks.expected import Expected
from plans.linkage.letters import POLES
from plans.model.order import ORDERS
from plans.words.words import Message


def faults(
    measured: Measured, leaf: Leaf, expected: Expected, centres: Mapping[str, tuple[int, complex]], allowed: float
) -> Iterator[Message]:
    """See that each mass centre is lettered where the analysis has it, and that a vector from the pole ends there.

    `allowed` is what paper and both roads leave open, mm.
    """
    for order in (1, 2):
        plan = ORDERS[order].plan
        vectors = [one for one in measured.vectors if (one.plan, one.position) == (plan, expected.k)]
        pole = next((one for one in vectors if one.name.split(" ")[0] == POLES[plan]), None)
        if pole is None:
            continue
        labels = labels_of(tuple(one for one in groups(leaf.groups) if one.name == f"{plan}-{expected.k}"))
        for name, mass in centres.items():
            letter, tip = expected.letters.small(name), expected.centre(*mass, order) / pole.scale
            ends = (one.end for one in vectors if one.name.split(" ")[0] == POLES[plan])
            drawn = abs(tip) <= 2 * LEAST or any(abs(end - pole.start - tip) <= allowed for end in ends)
            plain = Text(0j, with_index(letter)).plain
            if not drawn or not distance(labels.get(plain, ()), (pole.start + tip,)) <= NEAREST:
                yield on("differs_at", plan, name=letter, position=expected.k)
