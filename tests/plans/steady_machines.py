"""Machines whose crank turns fully, by hand and drawn at random, and their steady turns by analysis; SI units."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from hypothesis import strategies as st

from plans.analytic.dynamics.flywheel import Exact, exact
from plans.analytic.dynamics.reduction import ExactReduction
from plans.analytic.kinematics import Analysis
from plans.forces.loading import OutputStroke, loading, strokes
from plans.model.machine import ALWAYS, IDLE, WORKING, Body, Diagram, Force, Machine, Moment, Spring, Transmission
from plans.model.mechanism import Mechanism, Output
from plans.model.motion import Extremes, Motion
from tests.plans import linkages
from tests.plans.chains import numbers

BODIES = {1: Body(1, 3.0, 0.01, 0.04), 2: Body(2, 4.0, 0.06, 0.15), 3: Body(3, 8.0, 0.0, 0j)}  # of M4.2
OUTWARD = Force("F_us", 3, "B", 0j, 2000.0, None, WORKING, overrun=(0.05, 0.05))  # of M4.7
EXTREMES: dict[str, Extremes | None] = {}
SPEED, DELTA = 4 * np.pi, 1 / 25  # of M4.9


class Steady(NamedTuple):
    """A mechanism with its machine, position 0 at `start` rad."""

    mechanism: Mechanism
    machine: Machine
    start: float = 0.0

    @property
    def strokes(self) -> Mapping[str, OutputStroke]:
        return strokes(self.machine, self.mechanism, self.mechanism.output, self._extremes)

    def _extremes(self, output: Output) -> Extremes | None:
        """Look for extreme positions once in a mechanism, whatever is asked of its machine."""
        key = repr((self.mechanism, output))
        if key not in EXTREMES:
            EXTREMES[key] = Analysis(self.mechanism).extremes(output)
        return EXTREMES[key]

    @property
    def reduction(self) -> ExactReduction:
        runs = self.strokes

        def loads(motion: Motion):
            return loading(self.machine, motion, runs)

        return ExactReduction(Analysis(self.mechanism, first=False), self.machine, loads, self.start)

    @property
    def exact(self) -> Exact:
        return exact(self.reduction, self.strokes)


def machine(
    *loads: Force | Moment, bodies: Mapping[int, Body] = BODIES, gravity: complex = 0j, springs: tuple[Spring, ...] = ()
) -> Machine:
    """Load a machine; no gravity acts unless it is told."""
    forces = tuple(load for load in loads if isinstance(load, Force))
    moments = tuple(load for load in loads if isinstance(load, Moment))
    return Machine(bodies, gravity, forces, moments, springs, Transmission(), {})


def worked(*loads: Force | Moment, start: float = 0.0, omega: float = SPEED) -> Steady:
    """Give the machine of M4.2, loaded as in M4.7 unless otherwise told."""
    return Steady(linkages.slider_crank(0.1, 0.4, omega=omega, epsilon=0.0), machine(*(loads or (OUTWARD,))), start)


def edges(found: Exact, divisions: int = 24):
    """Cut the turn into strips, with all breaks among their edges."""
    even = np.arange(divisions + 1) * (2 * np.pi / divisions)
    return np.unique(np.concatenate((even, found.breaks)))


SHARES = numbers(0.02, 0.3)
DIRECTIONS = st.none() | numbers(-3.1, 3.1).map(lambda turn: complex(np.exp(1j * turn)))
DURING = st.sampled_from((ALWAYS, WORKING, IDLE))
MASSES = st.builds(complex, numbers(-0.2, 0.4), numbers(-0.2, 0.2))


@st.composite
def diagrams(draw: st.DrawFn) -> Diagram:
    """Draw a diagram of a load, in newtons, that may not be the same on the way back."""
    inner = sorted(draw(st.sets(st.sampled_from((0.1, 0.25, 0.4, 0.55, 0.7, 0.9)), min_size=1, max_size=3)))
    travel = (0.0, *inner, 1.0)
    sizes = st.lists(numbers(-1500, 1500), min_size=len(travel), max_size=len(travel)).map(tuple)
    return Diagram(travel, draw(sizes), draw(st.just(()) | sizes))


@st.composite
def loads(draw: st.DrawFn) -> Force | Moment:
    """Draw a load on link 2 or 3: over a stroke, by a diagram, or always."""
    overrun = draw(st.just((0.0, 0.0)) | st.tuples(SHARES, SHARES))
    if draw(st.integers(0, 2)) == 0:
        return Moment("T", 3, draw(numbers(-80, 80)), draw(st.booleans()), draw(DURING), overrun)
    if draw(st.booleans()):
        return Force("F", 3, "B", 0j, 1.0, draw(DIRECTIONS), ALWAYS, draw(diagrams()), overrun)
    return Force("F", 3, "B", 0j, draw(numbers(-2000, 2000)), draw(DIRECTIONS), draw(DURING), None, overrun)


@st.composite
def steadies(draw: st.DrawFn) -> Steady:
    """Draw a slider-crank or a crank-rocker whose crank turns fully, with masses, loads, weights and a spring."""
    a, sense = draw(numbers(0.04, 0.12)), draw(st.sampled_from((-1.0, 1.0)))
    if draw(st.booleans()):
        mechanism = linkages.slider_crank(a, a * draw(numbers(2.2, 5)), a * draw(numbers(-0.8, 0.8)), omega=sense)
        end = 0j
    else:
        frame, coupler = draw(numbers(3.0, 3.4)), draw(numbers(2.8, 3.4))
        rocker = draw(numbers(1.8, 2.4))
        mechanism = crank_rocker(a, coupler * a, rocker * a, frame * a, sense)
        end = complex(rocker * a)
    bodies = {k: Body(k, draw(numbers(0.1, 20)), draw(numbers(0, 0.2)), draw(MASSES)) for k in (1, 2, 3)}
    given = [_at(load, end) for load in draw(st.lists(loads(), min_size=1, max_size=3))]
    gravity = draw(st.sampled_from((0j, -9.81j)))
    spring = Spring("spring", (0, 3), ("O", "B"), (0j, end), draw(numbers(0, 3000)), 0.0)
    springs = (spring,) if draw(st.integers(0, 3)) == 0 else ()
    return Steady(mechanism, machine(*given, bodies=bodies, gravity=gravity, springs=springs), draw(numbers(-3, 3)))


def crank_rocker(a: float, b: float, c: float, d: float, omega: float) -> Mechanism:
    """Give a four-bar whose crank turns fully, sketched at the crank angle 0."""
    apart = d - a
    along = (apart**2 + b**2 - c**2) / (2 * apart)
    sketch = {"A": complex(a), "B": complex(a + along, (b**2 - along**2) ** 0.5)}
    return linkages.four_bar(a, b, c, d, sketch=sketch, omega=omega, epsilon=0.0)


def _at(load: Force | Moment, end: complex) -> Force | Moment:
    return load._replace(at=end) if isinstance(load, Force) else load
