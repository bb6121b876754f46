"""The numbers that the notes of force sheets tell of friction, by the analysis alone (пояснения о трении)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks.expected import Expected
from plans.checks.force_comparison import ForceComparison
from plans.forces.statics import Statics


def notes(statics: Statics, comparison: ForceComparison, shown: Sequence[int]) -> Iterator[Expected]:
    """Give the numbers of the notes."""
    yield from ()
