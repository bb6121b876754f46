"""The crank's angles over the working and the idle stroke, as arcs about its pivot (фазовые углы).

They are drawn where they differ as they are told, and where the scene says which stroke is the working one.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.linkage.pairs import Pairs
from drawings.figures.linkage.rotation import NUMBERS, OUTER
from drawings.lettering.phrase import Phrase, slotted
from drawings.lettering.words import fixed
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Line, Stroke
from drawings.paper.walk import stating
from drawings.symbols.symbols import turning_arrow
from plans.linkage.extreme import ExtremePositions
from plans.linkage.study import LinkageStudy
from plans.model.order import POSITIONS
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
    text: Phrase  # the letter with the angle's size

    @property
    def middle(self) -> tuple[complex, float]:
        """The middle of the arc, and the direction away from the pivot there."""
        turn = self.start + self.sweep / 2
        return self.centre + cmath.rect(self.radius, turn), turn

    def strokes(self, pairs: Pairs) -> Iterator[Stroke]:
        """Draw it with its arrow, and where it lies outside the crank circle the line that it begins at."""
        arc = turning_arrow(self.centre, self.radius, self.start, self.sweep, pairs.hand, pairs.hand.drafted)
        yield stating(Statement(Kind.ANGLE, POSITIONS.plan, self.letter), *arc)
        if self.radius > self.crank:
            ray = cmath.rect(1.0, self.start)
            reach = self.radius + PAST * pairs.hand.symbol
            yield Line(self.centre + self.crank * ray, self.centre + reach * ray, pairs.hand.drafted)


def phases(pairs: Pairs, language: str) -> tuple[Phase, ...]:
    """Give the arcs of both strokes; none where they are alike and none is asked for, or there are no two strokes."""
    study = pairs.bones.study
    if study.travel is None or not (_asked(study) or _differ(study.travel)):
        return ()
    extremes, centre, crank = study.travel.extremes, pairs.bones.pivot(pairs.place), pairs.bones.crank(pairs.place)
    radius = _radius(crank, pairs.hand.symbol)
    names = (f"φ_{{{word(language, index)}}}" for index in INDICES)
    told = zip(names, extremes.phi, extremes.angles, strict=True)
    return tuple(
        Phase(name, centre, radius, phi, study.sense * arc, crank, sized(name, arc, language))
        for name, phi, arc in told
    )


def sized(letter: str, angle: float, language: str) -> Phrase:
    """Write the letter of an angle rad with its size in degrees."""
    return slotted(f"{letter} = ", letter, fixed(math.degrees(angle), language), "°")


def _asked(study: LinkageStudy) -> bool:
    return study.scene.has(("output", "working"))


def _differ(travel: ExtremePositions) -> bool:
    """Tell whether there are two strokes over a turn, of angles that differ in the digits that are written."""
    first, second = (fixed(abs(math.degrees(arc)), "en") for arc in travel.extremes.angles)
    return len(travel.rests) == 2 and first != second


def _radius(crank: float, factor: float) -> float:
    """Give the radius of the arcs: within the crank circle beyond the arrow of rotation, or outside its numbers."""
    within = WITHIN * crank
    fits = within >= (OUTER + APART) * factor and crank - within >= APART * factor
    return within if fits else crank + NUMBERS + APART * factor
