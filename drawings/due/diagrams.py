"""What must stand of the kinematic diagrams, by the analysis alone (to be written)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from drawings.checks.expected import Expected
from drawings.checks.hold import stated_keys
from drawings.paper.strokes import Leaf
from plans.study import Study

FIGURES = ("diagrams", "output")  # how their names begin


def due(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Let anything stand that the diagrams and their table state."""
    for kind, figure, name, position in {key for leaf in leaves for key in stated_keys(leaf)}:
        if figure.startswith(FIGURES):
            yield Expected(kind, figure, name, 0.0, math.inf, position)
