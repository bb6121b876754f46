"""The share of the reciprocating mass that the crank balances, as a choice: by superposed force plans (выбор доли).

With the share the static moment of the crank's counterweight changes evenly; a mass that follows from its radius, and
its inertia, follow with it. Forces are superposed: those of one machine, and what each of the three adds. What a gear's
teeth press the shafts apart with is not, for either flank may bear: it follows from the moment, which is superposed.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.precision import condition
from plans.balance.mass_centre import EMPTY, Drawing, MainPoints, centre_drawing
from plans.balance.weights import Tree
from plans.forces.statics import Statics
from plans.linkage.assembly import meeting
from plans.linkage.drafts import Drafts
from plans.linkage.primary import CrankPositions
from plans.linkage.study import BLOCK, LinkageStudy
from plans.linkage.sweep import at_angles
from plans.model.balance.linkage import CONSTRUCTION, EPS, SHARES, STEPS, Choice, MassCentre, Shares, State
from plans.model.dyad import pair
from plans.model.kinetostatics import Kinetostatics
from plans.model.machine import FORCE, GEAR, Body, Machine
from plans.model.mechanism import FRAME
from plans.model.motion import ACCELERATIONS, Complexes, Floats


def state(points: MainPoints, statics: Statics) -> State:
    """Give the state of a machine whose main points are known; `statics` are the forces of that machine."""
    study = statics.study
    centre = mass_centre(points, study, study.turn)
    around = mass_centre(points, study, positions_around(study)) if turns(study) else centre
    return State(centre, around, forces_around(statics), _magnified(study))


def _magnified(study: LinkageStudy) -> Floats:
    """Give kappa of the worst meeting of a group over the positions of a turn: by so much it magnifies rounding."""
    drafts = Drafts(study, positions_around(study))
    found = np.ones(len(drafts.turn))
    for group in study.groups:
        found = np.fmax(found, condition(meeting(drafts.positions, group)))
    return found


def turns(study: LinkageStudy) -> bool:
    """Tell whether the crank turns fully."""
    return study.assembly.phi is not None and not study.barriers


def positions_around(study: LinkageStudy) -> CrankPositions:
    """Divide a whole turn from the first position on into even steps; of a crank that has none the scene's positions.

    The last position of a turn is the first once more.
    """
    if not turns(study):
        return study.turn
    phi = study.turn.phi[0] + study.sense * 2 * np.pi * np.arange(STEPS + 1) / STEPS
    return at_angles(phi).paced(study.pace)


def forces_around(statics: Statics) -> Kinetostatics:
    """Give the forces over a whole turn, or where the crank has none over the scene's positions."""
    return statics.around(STEPS) if turns(statics.study) else statics.forces


def mass_centre(points: MainPoints, study: LinkageStudy, turn: CrankPositions) -> MassCentre:
    """Find the mass centre at crank positions, in blocks; NaN at gaps."""
    parts = [_part(points, study, turn.part(slice(start, start + BLOCK))) for start in range(0, len(turn), BLOCK)]
    r, a, moment = (np.concatenate([part[row] for part in parts]) for row in range(3))
    return MassCentre(CONSTRUCTION, turn.phi, points.mass, r, a, moment.real)


def drawing(points: MainPoints, drafts: Drafts) -> Drawing:
    """Draw the mass centre over the positions of some drafts."""
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN inside
        return centre_drawing(points, drafts.plan(ACCELERATIONS.number))


def _part(points: MainPoints, study: LinkageStudy, turn: CrankPositions) -> tuple[npt.NDArray[Any], ...]:
    drafts = Drafts(study, turn)
    made = drawing(points, drafts)
    rows = (np.broadcast_to(mark.point, len(turn)) for mark in (made.centre, made.accelerations.end, made.moment))
    r, a, moment = (np.array(row, dtype=complex) for row in rows)
    r[drafts.lost] = np.nan
    for row in (a, moment):
        row[drafts.lost | drafts.unborne] = np.nan
    return r, a, moment


HALVINGS = 53  # of an interval of shares: as many as a number has binary digits
SPAN = EPS ** (1 / 3)  # of a chord over a curve: its error and that of rounding are about the same
Machines = Callable[[float], Machine]  # by share
Forces = Callable[[float], Complexes]  # by share, over the positions


class Burden(NamedTuple):
    """What the forces of a crank follow from, about its shaft: mass kg, static moment kg*m, moment of inertia kg*m2."""

    mass: float
    moment: complex
    inertia: float

    @classmethod
    def of(cls, body: Body, shaft: complex) -> Burden:
        """Take those of a body."""
        arm = body.centre - shaft
        return cls(body.mass, body.mass * arm, body.inertia + body.mass * abs(arm) ** 2)

    def body(self, link: int, shaft: complex) -> Body:
        """Give a body that has them."""
        arm = self.moment / self.mass
        return Body(link, self.mass, self.inertia - self.mass * abs(arm) ** 2, shaft + arm)


class Superposition:
    """The shaking force and the reaction of the shaft at any share, over the positions of a turn."""

    def __init__(self, statics: Statics, tree: Tree, machines: Machines) -> None:
        self.statics, self.tree, self.machines = statics, tree, machines
        mechanism = statics.study.mechanism
        drive = mechanism.drive
        self.link, self.shaft = drive.link, mechanism.links[drive.link].points[drive.pivot]
        self.key = pair(FRAME, drive.link, drive.pivot).key
        first = self.burden(0.0)
        self.first = first._replace(mass=first.mass or 1.0)  # without a mass it has no static moment

    def burden(self, share: float) -> Burden:
        """Give the crank's mass, static moment and inertia at a share."""
        return Burden.of(self.machines(share).bodies.get(self.link, EMPTY), self.shaft)

    @cached_property
    def step(self) -> complex:
        """What the whole share adds to the crank's static moment, kg*m."""
        return self.burden(1.0).moment - self.burden(0.0).moment

    @property
    def bend(self) -> float | None:
        """The share at which a counterweight whose mass follows is lightest: mass and reaction bend there."""
        if len({self.burden(share).mass for share in (0.0, 0.5, 1.0)}) == 1:
            return None
        bare = Burden.of(self.statics.machine.bodies.get(self.link, EMPTY), self.shaft)
        share = -((self.burden(0.0).moment - bare.moment) / self.step).real
        return share if 2 * SPAN < share < 1 - 2 * SPAN else None

    def _machine(self, burden: Burden) -> Machine:
        machine = self.machines(0.0)
        level = machine.transmission._replace(pressure=0.0)  # its teeth press along the pitch tangent
        bodies = {**machine.bodies, self.link: burden.body(self.link, self.shaft)}
        return replace(machine, bodies=bodies, transmission=level)

    def _shaking(self, burden: Burden) -> Complexes:
        points = MainPoints(self.tree, self._machine(burden).bodies)
        return mass_centre(points, self.statics.study, positions_around(self.statics.study)).force

    def _reaction(self, burden: Burden) -> Complexes:
        """Give the shaft's reaction N, and the balancing moment N*m in a row below, (2, N)."""
        forces = forces_around(self.statics.bearing(self._machine(burden)))
        return np.stack([forces.reactions[self.key].force, forces.balancing.moment])

    @cached_property
    def _apart(self) -> complex:
        """What the teeth press the shafts apart with, N for each N*m of the moment."""
        how = self.statics.machine.transmission
        return cmath.rect(math.tan(how.pressure) / how.radius, how.at) if how.kind == GEAR else 0j

    def _more(self, share: float) -> tuple[float, float]:
        """Give by how much mass and inertia of the crank at a share differ from those of the first machine."""
        here = self.burden(share)
        return abs(here.mass - self.first.mass), abs(here.inertia - self.first.inertia)

    @cached_property
    def _shakes(self) -> tuple[Complexes, Complexes]:
        """Give the shaking force of the first machine, and what the whole share adds."""
        first = self._shaking(self.first)
        return first, self._shaking(self.first._replace(moment=self.first.moment + self.step)) - first

    @cached_property
    def _bears(self) -> tuple[Complexes, Complexes, Complexes | float, Complexes | float]:
        """Give the shaft's reaction of the first machine, and what step, a kilogram and a unit of inertia add."""
        first, machine = self._reaction(self.first), self.statics.machine
        by_force = machine.transmission.kind in (FORCE, GEAR)  # a moment on the crank loads the shaft too
        step = self._reaction(self.first._replace(moment=self.first.moment + self.step)) - first
        # By steps as large as those that are weighed: the difference of two forces is rounded as they are.
        heavier, slower = (max(1.0, *sizes) for sizes in zip(*map(self._more, (0.0, 1.0)), strict=True))
        mass, turning = 0.0, 0.0
        if machine.gravity:
            mass = (self._reaction(self.first._replace(mass=self.first.mass + heavier)) - first) / heavier
        if by_force:
            turning = (self._reaction(self.first._replace(inertia=self.first.inertia + slower)) - first) / slower
        return first, step, mass, turning

    def shaking(self, share: float) -> Complexes:
        """Give the shaking force at a share, N."""
        first, step = self._shakes
        return np.asarray(first + share * step)

    def _borne(self, share: float) -> Complexes:
        (first, step, mass, turning), here = self._bears, self.burden(share)
        more, slower = here.mass - self.first.mass, here.inertia - self.first.inertia
        return np.asarray(first + share * step + more * mass + slower * turning)

    def reaction(self, share: float) -> Complexes:
        """Give the reaction of the shaft on the crank at a share, N."""
        force, moment = self._borne(share)
        return np.asarray(force + self._apart * np.abs(moment))

    def _rate(self, share: float) -> Complexes:
        """Give how the shaft's reaction grows with the share, N: evenly but for a mass that follows, and a flank."""
        _, step, mass, turning = self._bears
        last, first = self.burden(share + SPAN), self.burden(share - SPAN)
        more, slower = (last.mass - first.mass) / (2 * SPAN), (last.inertia - first.inertia) / (2 * SPAN)
        force, moment = step + more * mass + slower * turning
        return np.asarray(force + self._apart * np.sign(self._borne(share)[1].real) * moment)

    def choice(self, share: float) -> Choice:
        """Tell what is largest at a share."""
        return Choice(share, largest(self.shaking(share)), largest(self.reaction(share)))

    def drawn(self, share: float) -> Choice:
        """Tell what is largest at a share by plans of that machine itself, nothing superposed."""
        machine, study = self.machines(share), self.statics.study
        shaking = mass_centre(MainPoints(self.tree, machine.bodies), study, positions_around(study)).force
        reaction = forces_around(self.statics.bearing(machine)).reactions[self.key].force
        return Choice(share, largest(shaking), largest(reaction))

    @cached_property
    def shares(self) -> Shares:
        """The curve of the choice, and its two best shares."""
        curve = tuple(self.choice(float(share)) for share in np.linspace(0, 1, SHARES))
        force = least(self.shaking, lambda _: self._shakes[1])
        return Shares(curve, self.choice(force), self.choice(least(self.reaction, self._rate, self.bend)))


def largest(forces: Complexes) -> float:
    """Give the largest force, N; NaN where there is none at all."""
    return float(np.fmax.reduce(np.abs(forces)))


def least(forces: Forces, rate: Forces, bend: float | None = None) -> float:
    """Find the share in [0, 1] at which the largest force is least: it falls before, and rises after.

    Where it bends at a share it may do so on either side of that one; no chord is laid across the bend.
    """
    if np.isnan(largest(forces(0.0))) or not rate(0.0).any():
        return 0.0  # the mechanism cannot be assembled, or nothing is left at sliders and all shares are alike
    if bend is None:
        return _lowest(forces, rate, 0.0, 1.0)
    before, after = max(bend - 2 * SPAN, 0.0), min(bend + 2 * SPAN, 1.0)
    sides = _lowest(forces, rate, 0.0, before), bend, _lowest(forces, rate, after, 1.0)
    return min(sides, key=lambda share: largest(forces(share)))


def _lowest(forces: Forces, rate: Forces, start: float, end: float) -> float:
    """Halve by the sense in which the force of the position that has the largest goes with the share."""
    # With a mass that follows, the curve may bend any way.
    row: list[float] = [start, *(share for share in np.linspace(0, 1, SHARES).tolist() if start < share < end), end]
    best = int(np.argmin([largest(forces(share)) for share in row]))
    low, high = row[max(best - 1, 0)], row[min(best + 1, len(row) - 1)]
    if _rises(forces, rate, low) or not _rises(forces, rate, high):
        return low if _rises(forces, rate, low) else high
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if _rises(forces, rate, middle) else (middle, high)
    return (low + high) / 2


def _rises(forces: Forces, rate: Forces, share: float) -> bool:
    here = forces(share)
    at = int(np.argmax(np.nan_to_num(np.abs(here))))
    return bool((here[at].conjugate() * rate(share)[at]).real > 0)
