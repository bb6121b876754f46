"""A mechanism found by synthesis, whichever road found it: sizes, places of its construction (найденный механизм).

Values alone, SI: m, rad, rad/s.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Final, NamedTuple, Protocol

from plans.model.motion import Complexes, Gap

EPS: Final = 2.0**-52
QUARTER: Final = math.pi / 2
CONSTRUCTION, ANALYSIS = "construction", "analysis"


class SynthesisTask(Protocol):
    """What is asked of a mechanism."""

    @property
    def asked(self) -> Mapping[str, float]:
        """The demands as the sheet tells them, by the letters of sizes."""
        ...


class LocusCircle(NamedTuple):
    """A circle of a construction, m."""

    centre: complex
    radius: float


class BarredArc(NamedTuple):
    """An arc on which no pivot is admitted: of a circle by its name, from an angle rad on by a sweep rad."""

    circle: str
    start: float
    sweep: float


@dataclass(frozen=True)
class Design:
    """A mechanism that does what a task asks: sizes and places by the letters that they have on the sheet.

    Sizes are lengths m (l_1, e, H), angles rad (θ, ψ, μ_min, α_max), speeds rad/s (ω_1) and bare ratios (K, λ), in the
    order in which they are told; the first are the lengths of the links. A circle has the name of its centre. Of
    several designs the first with the largest merit is taken.
    """

    sizes: Mapping[str, float]
    places: Mapping[str, complex]
    circles: Mapping[str, LocusCircle] = field(default_factory=dict)
    barred: tuple[BarredArc, ...] = ()
    merit: float = 0.0
    curves: Mapping[str, Complexes] = field(default_factory=dict)  # that are no circles: a coupler's curve, m

    def moved(self, by: complex) -> Design:
        """Give it with all its places moved by a way, m."""
        places = {name: spot + by for name, spot in self.places.items()}
        circles = {name: one._replace(centre=one.centre + by) for name, one in self.circles.items()}
        return replace(
            self, places=places, circles=circles, curves={name: one + by for name, one in self.curves.items()}
        )


class TaskReading(NamedTuple):
    """One reading of a task (толкование): the demands that are kept, and every mechanism that meets them."""

    kept: tuple[str, ...]
    found: tuple[Design, ...]

    @property
    def best(self) -> int:
        """Which of its mechanisms is taken, and shown."""
        return max(range(len(self.found)), key=lambda k: self.found[k].merit)


@dataclass(frozen=True)
class Synthesis:
    """What one road found: the readings of a task."""

    by: str
    readings: tuple[TaskReading, ...]

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """Nothing: a task that no mechanism meets is refused before."""
        return ()

    @property
    def chosen(self) -> Design:
        """The mechanism that is taken: the best of the first reading that has one, which may be on several circles."""
        kept = next(one.kept for one in self.readings if one.found)
        found = (design for one in self.readings if one.kept == kept for design in one.found)
        return max(found, key=lambda design: design.merit)


UNITS: Final = {**dict.fromkeys("leHhrRxy", "m"), **dict.fromkeys("θψφβγμα", "rad"), "ω": "rad/s", "v": "m/s"}


def unit_of(name: str) -> str:
    """Give the unit of a size by its letter.

    >>> unit_of("l_1"), unit_of("μ_min"), unit_of("K")
    ('m', 'rad', '')
    """
    return UNITS.get(name[0], "")
