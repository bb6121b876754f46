"""Balancing a mechanism: what is asked, counterweights, mass centre, shaking force, what it costs (уравновешивание).

Values alone, SI. A vector fixed in a link is complex in the link's own frame, from the point at which the link begins;
vectors of the mechanism are in the scene's axes, places from the datum.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from plans.model.kinetostatics import Kinetostatics
from plans.model.mechanism import FRAME
from plans.model.motion import NOTHING, Complexes, Floats, Gap

CONSTRUCTION, ANALYSIS = "construction", "analysis"
NONE, FULL, PARTIAL, SHARE = "none", "full", "partial", "share"  # what is aimed at
FORCE, REACTION = "force", "reaction"  # of a share that is sought: what is to be least at its largest
DISC, SECTOR = "disc", "sector"  # shapes of a counterweight
STEPS = 360  # positions of a turn over which paths, hodographs and largest values are taken
BEYOND = 10  # turns of so many positions are told as the outermost of them alone
SHARES = 21  # shares from 0 to 1 that the curve of the choice is told at
EPS = 2.0**-52
ROUNDING = 8.0  # a static moment is none where it is within so many eps of the sum of what it is made of
ORDERS = 4  # kappa magnifies roundings of a place, and once more of its velocity, its acceleration and the reactions


class Site(NamedTuple):
    """What the scene allows on a link: mass kg or place m (one of them, or neither of a sector), shape and material.

    `radius` is the distance of its centre from the link's beginning, in the direction that is found; `at` is a
    distance along the link's line from there, negative beyond the beginning, which fixes the direction too.
    """

    link: int
    mass: float | None = None
    radius: float | None = None
    at: float | None = None
    shape: str = DISC
    density: float = 7850.0  # kg/m3
    thickness: float = 0.03  # m
    half_angle: float = math.pi / 3  # rad, of a sector


class BalanceTask(NamedTuple):
    """What is asked: the aim, the links that may carry counterweights, the share or what is to be least by it."""

    aim: str = NONE
    places: tuple[Site, ...] = ()
    share: float | None = None  # of the reciprocating mass; None of an aim SHARE: the one that makes `least` least
    least: str = FORCE

    def place(self, link: int) -> Site | None:
        """Give what is allowed on a link; None where nothing may be put there."""
        return next((place for place in self.places if place.link == link), None)


class Counterweight(NamedTuple):
    """A counterweight (противовес): static moment kg*m in its link's frame from the link's beginning, and mass kg.

    `begin` is the letter of that point, `origin` its place in the link's frame; a mass of 0 stands for none needed.
    """

    place: Site
    begin: str
    origin: complex
    moment: complex
    mass: float

    @property
    def link(self) -> int:
        """The link that carries it."""
        return self.place.link

    @property
    def needed(self) -> bool:
        """Whether anything is to be put on."""
        return self.mass > 0

    @property
    def centre(self) -> complex:
        """Its centre in the link's own frame, m."""
        return self.origin + (self.moment / self.mass if self.mass else 0j)

    @property
    def distance(self) -> float:
        """The distance m of its centre from the link's beginning."""
        return abs(self.moment) / self.mass if self.mass else 0.0

    @property
    def outer(self) -> float:
        """The radius m of its disc, or the outer radius of its sector."""
        place = self.place
        solid = place.density * place.thickness
        return math.sqrt(self.mass / (solid * (math.pi if place.shape == DISC else place.half_angle)))

    @property
    def inertia(self) -> float:
        """Its moment of inertia about its own centre, kg*m2."""
        about = self.mass * self.outer**2 / 2
        return about if self.place.shape == DISC else about - self.mass * self.distance**2


def _largest(row: Complexes | Floats, least: Floats) -> float:
    """Give the largest size, 0 of what is no more than `least`; NaN where there is none at all."""
    sizes = np.abs(row)
    return float(np.fmax.reduce(np.where(sizes <= least, 0.0, sizes)))


def _outermost(spots: Complexes) -> Complexes:
    """Give the places that lie outermost in very many directions: the ends of the largest distance."""
    turns = 2 * np.pi * np.arange(BEYOND * STEPS) / (BEYOND * STEPS)
    return spots[[int(np.argmax((spots * np.exp(-1j * turn)).real)) for turn in turns]]


@dataclass(frozen=True)
class MassCentre:
    """The common mass centre over positions, by one road, with main vector and main moment of the inertia forces.

    `moment` N*m is about the datum, the crank's shaft; NaN at gaps.
    """

    by: str
    phi: Floats  # (N,) rad
    mass: float  # kg, of all moving links
    r: Complexes  # (N,) m from the datum
    a: Complexes  # (N,) m/s2
    moment: Floats  # (N,) N*m

    @property
    def force(self) -> Complexes:
        """The main vector of the inertia forces, N (главный вектор): what shakes the frame."""
        return np.asarray(-self.mass * self.a)

    @property
    def path(self) -> float:
        """The largest distance m between two places of the centre: however the frame is turned it is the same."""
        known = self.r[np.isfinite(self.r)]
        ends = known if len(known) <= BEYOND * STEPS else _outermost(known)
        return max((float(np.abs(known - end).max()) for end in ends), default=math.nan)


@dataclass(frozen=True)
class State:
    """The machine before or after: mass centre at the scene's positions and over a turn, and its forces over a turn.

    `around` and `forces` are over STEPS + 1 even positions of a turn from position 0 on; of a crank that cannot turn
    fully over the scene's, and `around` is `centre` itself. `kappa` is how much the mechanism magnifies rounding there,
    `beside` N the largest force of the other state: what is within rounding of the larger is 0.
    """

    centre: MassCentre
    around: MassCentre
    forces: Kinetostatics
    kappa: Floats
    beside: float = 0.0

    @property
    def whole(self) -> bool:
        """Whether it is known over a whole turn, and not at the scene's positions alone."""
        return self.around is not self.centre

    @property
    def count(self) -> int:
        """How many positions it is known in; the last of a turn is the first once more."""
        return len(self.around.phi) - self.whole

    @property
    def none(self) -> tuple[Floats, Floats]:
        """The force N and the moment N*m over the turn that are nothing but rounding."""
        share = np.clip(ORDERS * ROUNDING * EPS * self.kappa**ORDERS, NOTHING, 1.0)
        force = np.asarray(share * max(self.forces.largest, self.beside))
        return force, force * self.forces.size

    @property
    def path(self) -> float:
        """How far the common mass centre moves over the turn, m."""
        path = self.around.path
        return 0.0 if path <= NOTHING * self.forces.size else path

    @property
    def shaking(self) -> float:
        """The largest main vector of the inertia forces, N."""
        return _largest(self.around.force, self.none[0])

    @property
    def rocking(self) -> float:
        """The largest main moment of the inertia forces, N*m, by its size."""
        return _largest(self.around.moment, self.none[1])

    @property
    def reactions(self) -> Mapping[str, float]:
        """The largest reaction N of every pair."""
        force, _ = self.none
        return {key: _largest(reaction.force, force) for key, reaction in self.forces.reactions.items()}

    def reaction(self, link: int) -> float:
        """Give the largest reaction N of the frame on a link that is hinged to it."""
        found = self.forces.reactions.items()
        return next(self.reactions[key] for key, pair in found if {pair.giver, pair.taker} == {FRAME, link})

    @property
    def balancing(self) -> float:
        """The largest balancing moment, N*m, by its size."""
        return _largest(self.forces.balancing.moment, self.none[1])


class Choice(NamedTuple):
    """A share of the reciprocating mass, and what is largest with it, N: shaking force, reaction of the shaft."""

    share: float
    force: float
    reaction: float


@dataclass(frozen=True)
class Shares:
    """The share of the reciprocating mass as a choice: a curve of SHARES points, and the two best (выбор доли)."""

    curve: tuple[Choice, ...]
    least_force: Choice
    least_reaction: Choice

    def best(self, least: str) -> Choice:
        """Give the choice with which the shaking force or the reaction of the shaft is least."""
        return self.least_force if least == FORCE else self.least_reaction


@dataclass(frozen=True)
class Balance:
    """What balances a mechanism, by one road; `left` kg is what stays at sliders by letter: it moves along guides."""

    by: str
    task: BalanceTask
    counterweights: tuple[Counterweight, ...]
    left: Mapping[str, complex]
    before: State
    after: State | None  # None where nothing is asked for
    shares: Shares | None
    gaps: tuple[Gap, ...] = ()

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps, as a comparison asks for them."""
        return self.gaps

    @property
    def share(self) -> float:
        """The share of the reciprocating mass that is balanced: the given one, or the best; 0 of none."""
        if self.task.share is not None or self.shares is None:
            return self.task.share or 0.0
        return self.shares.best(self.task.least).share

    @property
    def loaded(self) -> State | None:
        """The machine with its counterweights on; None where none is put on."""
        return None if self.still else self.after

    @property
    def added(self) -> float:
        """The mass kg of all counterweights."""
        return sum(weight.mass for weight in self.counterweights)

    @property
    def still(self) -> bool:
        """Whether nothing needs to be put on, though it is asked for: the mechanism is balanced so far already."""
        return self.task.aim != NONE and not any(weight.needed for weight in self.counterweights)
