"""The crank's angles over the working and the idle stroke, as arcs about its pivot (фазовые углы).

They are drawn where the scene says which stroke is the working one, or has loads that depend on it.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.rotation import NUMBERS, OUTER
from drawings.paper.strokes import Line, Stroke
from drawings.symbols.symbols import turning_arrow
from plans.words.words import word

INDICES = ("index.work", "index.idle")
WITHIN = 0.75  # of the crank circle, where there is room between it and the arrow of rotation
APART = 5.0  # mm from other arcs about the pivot
PAST = 2.0  # mm that the lines of the extreme positions go past the arcs that they bound


class Phase(NamedTuple):
    """An arc about the crank's pivot from where a stroke begins to where it ends, in the sense of rotation."""

    letter: str
    centre: complex
    radius: float
    start: float
    sweep: float
    crank: float  # radius of the crank circle

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arc, and the direction away from the pivot there."""
        turn = self.start + self.sweep / 2
        return self.centre + cmath.rect(self.radius, turn), turn

    def strokes(self, pairs: Pairs) -> Iterator[Stroke]:
        """Draw it with its arrow, and where it lies outside the crank circle the line that it begins at."""
        yield from turning_arrow(self.centre, self.radius, self.start, self.sweep, pairs.hand, pairs.hand.drafted)
        if self.radius > self.crank:
            ray = cmath.rect(1.0, self.start)
            reach = self.radius + PAST * pairs.hand.symbol
            yield Line(self.centre + self.crank * ray, self.centre + reach * ray, pairs.hand.drafted)


def phases(pairs: Pairs, language: str) -> tuple[Phase, ...]:
    """Give the arcs of both strokes; none where the scene does not say which works, or the output has no extremes."""
    study = pairs.bones.study
    asked = study.scene.has(("output", "working")) or any(form.counts_stroke for form in study.scene.forms)
    if study.travel is None or not asked:
        return ()
    extremes, centre, crank = study.travel.extremes, pairs.bones.pivot(pairs.place), pairs.bones.crank(pairs.place)
    radius = _radius(crank, pairs.hand.symbol)
    names = (f"φ_{{{word(language, index)}}}" for index in INDICES)
    told = zip(names, extremes.phi, extremes.angles, strict=True)
    return tuple(Phase(name, centre, radius, phi, study.sense * arc, crank) for name, phi, arc in told)


def _radius(crank: float, factor: float) -> float:
    """Give the radius of the arcs: within the crank circle beyond the arrow of rotation, or outside its numbers."""
    within = WITHIN * crank
    fits = within >= (OUTER + APART) * factor and crank - within >= APART * factor
    return within if fits else crank + NUMBERS + APART * factor
