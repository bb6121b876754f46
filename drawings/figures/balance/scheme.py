"""What a scheme of balancing shows, in true units: links, main points, counterweights, paths of the mass centre."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.figures.linkage.outlines import outlines
from drawings.figures.linkage.skeleton import Skeletons
from drawings.symbols.polygon import ShownVector
from plans.model.balance.linkage import DISC, Counterweight
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes

BEFORE, AFTER = "before", "after"
SCHEME = "scheme-"  # before a state: the name of its scheme
RIM = 36  # points that stand for the rim of a counterweight


@dataclass(frozen=True)
class PlacedWeight:
    """A counterweight at its link in the shown position, m from the datum."""

    weight: Counterweight
    begin: complex  # where its link begins
    centre: complex

    @property
    def direction(self) -> complex:
        """The unit direction from its link's beginning to it."""
        return (self.centre - self.begin) / abs(self.centre - self.begin)

    @property
    def is_disc(self) -> bool:
        """Whether it is a disc about its centre, not a sector about its link's beginning."""
        return self.weight.place.shape == DISC

    @property
    def rim(self) -> list[complex]:
        """Points along its rim; of a sector the tip comes first."""
        radius, half = self.weight.outer, self.weight.place.half_angle
        if self.is_disc:
            return [self.centre + cmath.rect(radius, 2 * math.pi * k / RIM) for k in range(RIM)]
        turns = (half * (2 * k / RIM - 1) for k in range(RIM + 1))
        return [self.begin, *(self.begin + self.direction * cmath.rect(radius, turn) for turn in turns)]


@dataclass(frozen=True, eq=False)
class BalanceScheme:
    """The scheme before or after balancing in the shown position of a linkage."""

    state: str
    bones: Skeletons
    chain: tuple[ShownVector, ...]  # main-point vectors laid end to end from the datum, m
    paths: Mapping[str, Complexes]  # of the common mass centre over the turn, m, by state: its own comes last
    weights: tuple[PlacedWeight, ...] = ()
    whole: bool = True  # whether the crank turns fully: else the paths are known at the positions alone

    @property
    def name(self) -> str:
        """The name of its figure."""
        return SCHEME + self.state

    @property
    def centre(self) -> complex:
        """The common mass centre in the shown position."""
        return self.chain[-1].end if self.chain else 0j

    @property
    def shown(self) -> int:
        """The shown position."""
        return self.bones.shown

    @cached_property
    def centres(self) -> dict[str, complex]:
        """The mass centres of the links that no point names."""
        numbered = self.bones.numbered
        return {name: complex(numbered.of(*mass)[self.shown]) for name, mass in self.bones.masses.items()}

    @cached_property
    def named(self) -> dict[str, complex]:
        """The places of all named points and mass centres."""
        places = {name: self.bones.spot(name, self.shown) for name in sorted(self.bones.numbered.points)}
        return {name: spot for name, spot in (places | self.centres).items() if not math.isnan(spot.real)}

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [spot for line in self.lines for spot in line]

    @cached_property
    def lines(self) -> list[list[complex]]:
        """All that the figure must hold, in true lines from point to point."""
        runs = (path[~np.isnan(path.real)].tolist() for path in self.paths.values())
        return [
            *([spot] for spot in (0j, *self.named.values(), self.centre)),
            *map(list, self._links()),
            *([one.at, one.end] for one in self.chain),
            *(run for run in runs if run),
            *(one.rim for one in self.weights),
        ]

    def _links(self) -> Iterator[tuple[complex, complex]]:
        """Give all bars, slots as long as their stones' travel, and the frame's guides, by their ends."""
        numbered, k = self.bones.numbered, self.shown
        bars = [(one.link, bar) for one in outlines(self.bones, self.bones.travels) for bar in one.bars]
        ends = [tuple(complex(numbered.of(link, spot)[k]) for spot in bar) for link, bar in bars]
        for slide, travel in self.bones.travels.items():
            if slide.owner == FRAME:
                ends.append(tuple(slide.on_owner.through + along * slide.on_owner.direction for along in travel))
        yield from ((one, other) for one, other in ends if not (math.isnan(one.real) or math.isnan(other.real)))


def placed_weight(weight: Counterweight, bones: Skeletons) -> PlacedWeight:
    """Place a counterweight on its link in the shown position."""
    ends = (complex(bones.numbered.of(weight.link, spot)[bones.shown]) for spot in (weight.origin, weight.centre))
    return PlacedWeight(weight, *ends)
