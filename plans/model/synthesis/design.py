"""A mechanism found by synthesis, whichever road found it: sizes, places of its construction (найденный механизм).

Values alone, SI: m, rad, rad/s.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from plans.model.motion import Gap


class Circle(NamedTuple):
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
    order in which they are told; the first are the lengths of the links. Of several designs the one with the largest
    merit is taken.
    """

    sizes: Mapping[str, float]
    places: Mapping[str, complex]
    circles: Mapping[str, Circle] = field(default_factory=dict)
    barred: tuple[BarredArc, ...] = ()
    merit: float = 0.0


class Reading(NamedTuple):
    """One reading of a task (толкование): the demands that are kept, and every mechanism that meets them."""

    kept: tuple[str, ...]
    found: tuple[Design, ...]


@dataclass(frozen=True)
class Synthesis:
    """What one road found: the readings of a task."""

    by: str
    readings: tuple[Reading, ...]

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """Nothing: a task that no mechanism meets is refused before."""
        return ()


UNITS = {"l": "m", "e": "m", "H": "m", "h": "m", "r": "m", "θ": "rad", "ψ": "rad", "φ": "rad", "μ": "rad", "α": "rad"}
OTHER = {"ω": "rad/s", "v": "m/s"}


def unit_of(name: str) -> str:
    """Give the unit of a size by its letter.

    >>> unit_of("l_1"), unit_of("μ_min"), unit_of("K")
    ('m', 'rad', '')
    """
    return {**UNITS, **OTHER}.get(name[0], "")
