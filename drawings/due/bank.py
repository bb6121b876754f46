"""What must stand on these sheets (to be written)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks.expected import Expected
from drawings.paper.strokes import Leaf
from plans.study import Study


def due(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets."""
    yield from ()
