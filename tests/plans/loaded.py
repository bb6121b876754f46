"""Mechanisms with masses, loads, springs and drives, drawn at random, each at one crank angle, and their forces.

Generated chains, the worked force analyses, and the gallery's mechanisms at any position of their turn.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cache, cached_property
from math import degrees
from typing import NamedTuple

import numpy as np
from hypothesis import strategies as st

from geometry.meet import EPS
from plans.analytic.kinematics import conditions
from plans.forces.statics import Statics
from plans.linkage.quantities import MOST_ALLOWED
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.machine import FORCE, GEAR, MOMENT, Body, Force, Machine, Moment, Spring, Transmission
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion
from plans.scene.scene import parse_scene, read_scene
from tests.gallery import LINKAGES
from tests.parts import examples
from tests.plans.chains import SIGNS, TURNS, chains, numbers
from tests.plans.force_cases import DYADS, text_of
from tests.plans.machines import pointed
from tests.plans.studies import study_of

ROUNDINGS = 16.0  # of the plan's largest, in each of the equations: as of the motion, see chains.allowed

# The whole is as many machines as see every wrong formula that is a relation's to see.
push = examples(3, 30)

Joint = tuple[int, str, int]  # link, point, and of a sliding pair the other link, of a hinge -1


class Told(NamedTuple):
    """What the joints do to each link, N and N*m, what the drive gives, and what rounding allows of either.

    A pin of several links does to each of them one thing, however it is shared out between the pairs.
    """

    forces: Mapping[Joint, complex]
    moments: Mapping[Joint, float]
    driving: complex
    balancing: float
    slack: float  # N
    turning: float  # N*m


@dataclass(frozen=True)
class Loaded:
    """A mechanism with its machine at one crank angle, degrees."""

    mechanism: Mechanism
    machine: Machine
    phi: float

    @cached_property
    def statics(self) -> Statics:
        """The statics, drawn at that angle; nothing bars the way to the first position itself."""
        statics = self.at(self.phi)
        statics.study.__dict__["barriers"] = ()
        return statics

    def at(self, *angles: float) -> Statics:
        """Give the statics at any angles, degrees."""
        statics = Statics(study_of(self.mechanism, positions=[Decimal(angle) for angle in angles]))
        statics.__dict__["machine"] = self.machine
        return statics

    @property
    def study(self) -> LinkageStudy:
        """The study at that angle."""
        return self.statics.study

    @property
    def motion(self) -> Motion:
        """The motion at that angle."""
        return self.study.motion()

    @property
    def loading(self) -> Loading:
        """The loads at that angle."""
        return self.statics.drafts().loading

    @cached_property
    def size(self) -> float:
        """The longest arm m about the shaft."""
        return max(float(abs(point.r[0])) for point in self.motion.points.values())

    @property
    def margin(self) -> float:
        """What rounding allows of the largest: kappa for the places, and once more for every order up to forces."""
        kappa = float(conditions(self.mechanism, self.motion)[0])
        return min(ROUNDINGS * EPS * kappa**4, MOST_ALLOWED)

    def largest(self, forces: Kinetostatics) -> float:
        """Give the largest force N of all: reactions, loads, weights, and all the inertia that the links may have."""
        motion, loading = self.motion, self.loading
        bent = max(float(abs(point.a[0])) for point in motion.points.values())
        spun = max(float(abs(link.epsilon[0])) for link in motion.links.values())
        bodies = self.machine.bodies.values()
        sizes = [b.mass * (abs(self.machine.gravity) + bent + spun * abs(b.centre)) for b in bodies]
        sizes += [b.inertia * spun / self.size for b in bodies]
        sizes += [abs(load.force[0]) for load in loading.forces]
        sizes += [abs(twist.moment[0]) / self.size for twist in loading.moments]
        for one in forces.reactions.values():
            sizes += [abs(one.force[0]), 0.0 if one.moment is None else abs(one.moment[0]) / self.size]
        return max([*sizes, abs(forces.balancing.moment[0]) / self.size])

    @cached_property
    def told(self) -> Told:
        """The forces at that angle."""
        return self.tell(self.statics.forces)

    def tell(self, found: Kinetostatics, position: int = 0) -> Told:
        """Read the forces at one position."""
        assert not found.gaps, found.gaps
        forces: dict[Joint, complex] = {}
        moments: dict[Joint, float] = {}
        for one in found.reactions.values():
            for sign, link, other in ((1, one.taker, one.giver), (-1, one.giver, one.taker)):
                joint = link, one.point, -1 if one.along is None else other
                forces[joint] = forces.get(joint, 0j) + sign * complex(one.force[position])
                if one.moment is not None:
                    moments[joint] = moments.get(joint, 0.0) + sign * float(one.moment[position])
        force = found.balancing.force
        driving = 0j if force is None else complex(force[position])
        slack = self.margin * self.largest(found)
        return Told(forces, moments, driving, float(found.balancing.moment[position]), slack, slack * self.size)


VECTORS = st.builds(complex, numbers(-1, 1), numbers(-1, 1))
UNITS = TURNS.map(lambda turn: complex(np.exp(1j * turn)))


def _maybe(one: st.SearchStrategy[float]) -> st.SearchStrategy[float]:
    return st.just(0.0) | one


@st.composite
def machines(draw: st.DrawFn, mechanism: Mechanism, kinds: tuple[str, ...] = (MOMENT, FORCE, GEAR)) -> Machine:
    """Draw masses, loads and a drive for a mechanism; gravity takes part in half of them."""
    moving = [number for number in sorted(mechanism.links) if number != FRAME]
    drive = mechanism.drive
    size = max(abs(place) for link in moving for place in mechanism.links[link].points.values())
    bodies = {}
    for link in moving:
        if draw(st.integers(0, 3)):
            mass = draw(numbers(0.1, 20))
            bodies[link] = Body(link, mass, draw(_maybe(numbers(0.1, 1))) * mass * size**2, size * draw(VECTORS))
    gravity = 9.81 * draw(UNITS) if draw(st.booleans()) else 0j
    forces = tuple(_force(draw, mechanism, moving, k) for k in range(draw(st.integers(1, 2))))
    twists = tuple(
        Moment(f"T{k}", draw(st.sampled_from(moving)), draw(numbers(-100, 100)) * size, draw(st.booleans()))
        for k in range(draw(st.integers(0, 2)))
    )
    springs = tuple(_spring(draw, mechanism, size) for _ in range(draw(st.integers(0, 1))))
    crank = mechanism.links[drive.link].points
    radius = 0.7 * abs(crank[drive.end] - crank[drive.pivot])
    how = {MOMENT: Transmission(), FORCE: Transmission(FORCE), GEAR: Transmission(GEAR, radius, draw(TURNS), 0.35)}
    return Machine(bodies, gravity, forces, twists, springs, how[draw(st.sampled_from(kinds))], {})


def _force(draw: st.DrawFn, mechanism: Mechanism, moving: list[int], number: int) -> Force:
    link = draw(st.sampled_from(moving))
    point, at = draw(st.sampled_from(sorted(mechanism.links[link].points.items())))
    return Force(f"F{number}", link, point, at, draw(numbers(1, 500)), draw(st.none() | UNITS))


def _spring(draw: st.DrawFn, mechanism: Mechanism, size: float) -> Spring:
    """Hang a spring between the shaft and a point of a link off it, or between two links."""
    ends = [(n, p, z) for n, link in sorted(mechanism.links.items()) for p, z in sorted(link.points.items())]
    moving = [end for end in ends if end[0] != FRAME and end[1] not in mechanism.links[FRAME].points]
    one = draw(st.sampled_from(moving))
    other = draw(st.sampled_from([end for end in ends if end[1] != one[1]]))
    links, points, at = zip(one, other, strict=True)
    return Spring("spring", links, points, at, draw(numbers(1, 1000)) / size, 0.0)


@cache
def scenes() -> tuple[tuple[Mechanism, tuple[float, ...]], ...]:
    """Give the worked and the gallery's mechanisms that a crank drives, each at crank angles, degrees, that it reaches.

    A drive over a stroke has no crank angles to be posed at.
    """
    texts = [parse_scene(text_of(name)) for name in (*DYADS, "shaper")]
    studies = [LinkageStudy(scene) for scene in (*texts, *map(read_scene, LINKAGES))]
    return tuple((pointed(study.mechanism), _angles(study)) for study in studies if study.mechanism.drive.turns)


def _angles(study: LinkageStudy) -> tuple[float, ...]:
    """Give the angles of a scene; one that starts at an extreme is taken from its sketch on."""
    positions = study.form.drive.positions
    if isinstance(positions, tuple):
        return tuple(float(angle) for angle in positions)
    assert study.assembly.phi is not None
    return tuple(degrees(study.assembly.phi) + k * 360.0 / positions for k in range(positions))


@cache
def posed(which: int, angle: int) -> tuple[Mechanism, float]:
    """Give a scene's mechanism sketched just as it is at one of its angles."""
    mechanism, angles = scenes()[which]
    phi = angles[angle % len(angles)]
    study = study_of(mechanism, angles[0], positions=[Decimal(angles[0]), Decimal(phi)])
    places = study.motion(0).points
    sketch = {name: complex(point.r[1]) for name, point in places.items() if name not in mechanism.links[FRAME].points}
    return replace(mechanism, sketch=sketch), phi


@st.composite
def loaded(draw: st.DrawFn, kinds: tuple[str, ...] = (MOMENT, FORCE, GEAR)) -> Loaded:
    """Draw a chain of one or two groups, or take a worked scene or one of the gallery, and load it."""
    if draw(st.booleans()):
        chain = draw(chains(most=2))
        mechanism, phi = pointed(chain.mechanism), chain.phi
    else:
        mechanism, phi = posed(draw(st.integers(0, len(scenes()) - 1)), draw(st.integers(0, 11)))
        omega, epsilon = mechanism.drive.omega, draw(_maybe(SIGNS))
        drive = mechanism.drive._replace(omega=draw(SIGNS) * omega, epsilon=epsilon * omega**2)
        mechanism = replace(mechanism, drive=drive)
    return Loaded(mechanism, draw(machines(mechanism, kinds)), phi)
