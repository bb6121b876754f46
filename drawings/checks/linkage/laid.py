"""A plan of positions as it must lie on its sheet: the links by the analysis (план положений на листе)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np

from drawings.checks.linkage.link_bars import hanging
from drawings.figures.linkage.masses import NEAR
from drawings.figures.linkage.ties import nearest
from drawings.measure.measure import Measured
from plans.analytic.balance.mass_centre import placed
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Link, Mechanism
from plans.model.motion import Motion
from plans.model.order import POSITIONS

if TYPE_CHECKING:
    from plans.forces.reading.form import ForceForm

Piece = tuple[complex, complex]


class Ground(NamedTuple):
    """Where the datum of a plan of positions lies on paper, mm, and its scale, m/mm."""

    origin: complex
    scale: float

    def on(self, value: complex) -> complex:
        """Give where a true place lies on paper, mm."""
        return self.origin + value / self.scale


def ground(measured: Measured) -> Ground | None:
    """Read the datum and the scale off the points of the plan of positions; none where it shows none."""
    seen = next((one for one in measured.points if one.plan == POSITIONS.plan), None)
    return None if seen is None else Ground(seen.at - seen.value / seen.scale, seen.scale)


def mass_centres(study: LinkageStudy) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that no point of the scene is or names: link, and place in its own frame."""
    form, links = cast("ForceForm | None", study.scene.part("forces")), study.mechanism.links
    masses = form.masses.items() if form else ()
    found = {f"S{number}": (number, mass.place(links[number])) for number, mass in masses if number != FRAME}
    known = {name for link in links.values() for name in link.points}
    return {
        name: (link, own)
        for name, (link, own) in found.items()
        if name not in known and not _on_a_point(links[link], own)
    }


class LaidMechanism:
    """The links of a mechanism in one position, on paper by the analysis."""

    def __init__(self, study: LinkageStudy, motion: Motion, position: int, at: Ground) -> None:
        self.study, self.motion, self.position, self.at = study, motion, position, at

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        return self.study.mechanism

    @cached_property
    def centres(self) -> dict[str, tuple[int, complex]]:
        """The mass centres that no point of the scene is or names."""
        return mass_centres(self.study)

    @cached_property
    def reach(self) -> float:
        """How far the points of the mechanism come from its datum, m: no slot is longer than twice that."""
        return float(np.nanmax([np.nanmax(np.abs(moved.r)) for moved in self.motion.points.values()]))

    def true(self, link: int, own: complex) -> complex:
        """Place a spot of a link, m."""
        return own if link == FRAME else complex(placed(self.mechanism, self.motion, link, own)[self.position])

    def on(self, link: int, own: complex) -> complex:
        """Place a spot of a link on paper, mm; NaN at a gap."""
        return self.at.on(self.true(link, own))

    def corners(self, link: int) -> list[complex]:
        """Give the named points of a link on paper, mm."""
        return [self.on(link, own) for own in self.mechanism.links[link].points.values()]

    def pieces(self, link: int) -> Iterator[Piece]:
        """Give what a link is drawn of on paper: pieces between its points, and the lines of its slots."""
        mechanism = self.mechanism
        ends = self.corners(link)
        yield from ((start, end) for start in ends for end in ends)
        for slide in mechanism.slides:
            if slide.owner == link != FRAME:
                way = slide.way(link)
                far = 2 * self.reach * way.direction
                yield self.on(link, way.through - far), self.on(link, way.through + far)
                spot, foot = hanging(mechanism, slide)
                yield self.on(link, spot), self.on(link, foot)
        for slide in mechanism.slides:
            if slide.slider == link:  # a block off its point has a rod from there, square to the line
                pin = mechanism.links[link].points[slide.point]
                off = (pin - slide.on_slider.through) / slide.on_slider.direction
                yield self.on(link, pin), self.on(link, pin - 1j * off.imag * slide.on_slider.direction)

    def apart(self, link: int, spot: complex) -> float:
        """Give how far a spot on paper is from a link, mm; NaN where the link has no place."""
        return min(_apart(*piece, spot) for piece in self.pieces(link))

    def foot(self, link: int, spot: complex) -> complex:
        """Give the place of a link that is nearest to a spot on paper."""
        feet = [start if start == end else nearest(start, end, spot) for start, end in self.pieces(link)]
        return min(feet, key=lambda foot: abs(foot - spot))


def within(corners: Sequence[complex], spot: complex) -> bool:
    """Tell whether a place lies in the plate whose corners these are: they lie all round it.

    >>> within([0j, 4 + 0j, 2j], 1 + 0.5j), within([0j, 4 + 0j, 2j], 3 + 2j)
    (True, False)
    """
    turns = sorted(math.atan2((one - spot).imag, (one - spot).real) for one in corners)
    gaps = [*(after - before for before, after in pairwise(turns)), turns[0] + math.tau - turns[-1]]
    return max(gaps) <= math.pi


def _on_a_point(link: Link, own: complex) -> bool:
    """Tell whether a mass centre lies on a named point of its link, or nearer to it than is seen."""
    off = [abs(place - own) for place in link.points.values()]
    return min(off) <= NEAR * max(off)


def _apart(start: complex, end: complex, spot: complex) -> float:
    if math.isnan(start.real) or math.isnan(end.real):
        return math.nan
    return abs(spot - (nearest(start, end, spot) if start != end else start))
