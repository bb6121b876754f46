"""Machines by hand: masses, drives and loads of mechanisms that no scene file describes; SI units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import radians

import numpy as np

from plans.analytic.kinematics import Analysis
from plans.analytic.kinetostatics import kinetostatics
from plans.model.decomposition import decompose
from plans.model.dyad import Pair, pairs
from plans.model.kinetostatics import Applied, Kinetostatics, Loading, Twist
from plans.model.machine import GEAR, Body, Machine, Transmission
from plans.model.mechanism import Mechanism, Slide
from plans.model.motion import Floats, Motion

DOWN = -9.81j
MASSES = {1: Body(1, 6, 0.25, 0j), 3: Body(3, 15, 0.6, 0.35 + 0j), 4: Body(4, 3, 0.01, 0.1 + 0j), 5: Body(5, 25, 0, 0j)}
GEARED = Transmission(GEAR, 0.18, radians(210), radians(20))


def machine(
    bodies: Mapping[int, Body] | None = None, gravity: complex = DOWN, transmission: Transmission | None = None
) -> Machine:
    return Machine(bodies or {}, gravity, (), (), (), transmission or Transmission(), {})


SHAPER = machine(MASSES, transmission=GEARED)


def steady(
    count: int, forces: Mapping[tuple[int, complex], complex], moments: Mapping[int, float] | None = None
) -> Loading:
    """Load links at points of their own frames by forces, and by moments, that never change."""
    applied = [
        Applied(f"F{link}", link, "P", at, np.full(count, force, dtype=complex)) for (link, at), force in forces.items()
    ]
    twists = [Twist(f"M{link}", link, np.full(count, moment)) for link, moment in (moments or {}).items()]
    return Loading(tuple(applied), tuple(twists))


def pointed(mechanism: Mechanism) -> Mechanism:
    """Let every slide name a point of its slider, as a scene's do: the last one, mostly not the link's origin."""

    def named(slide: Slide) -> Slide:
        return slide._replace(point=list(mechanism.links[slide.slider].points)[-1])

    return replace(mechanism, slides=tuple(map(named, mechanism.slides)))


class Run:
    """A mechanism with a machine at some crank angles rad: its motion by analysis, and its forces."""

    def __init__(
        self,
        mechanism: Mechanism,
        its: Machine,
        phi: Floats,
        loading: Loading | None = None,
        told: tuple[Pair, ...] = (),
    ) -> None:
        self.mechanism, self.machine, self.road = mechanism, its, Analysis(mechanism)
        self.motion: Motion = self.road.motion(np.asarray(phi, dtype=float))
        self.loading = loading or Loading((), ())
        self.pairs = told or pairs(mechanism, decompose(mechanism))

    @property
    def case(self) -> tuple[Analysis, Machine, Motion, Loading]:
        return self.road, self.machine, self.motion, self.loading

    @property
    def forces(self) -> Kinetostatics:
        return kinetostatics(*self.case, self.pairs)

    def own(self, link: int, place: complex) -> complex:
        """Give the place of a point of a link in the link's own frame, from where it is at the first position."""
        point, first = next(iter(self.mechanism.links[link].points.items()))
        turn = np.exp(1j * self.motion.links[link].angle[0])
        return complex(first + (place - self.motion.points[point].r[0]) / turn)
