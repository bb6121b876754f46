"""A mechanism balanced by the analysis, in one position: places, chains of vectors (уравновешенный механизм)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import KNOWN
from drawings.page.drafting import Drafting
from plans.analytic.balance.main_points import vectors
from plans.analytic.balance.mass_centre import bodies
from plans.analytic.points import placed
from plans.balance.study import BalanceStudy
from plans.checks.balance.comparison import BalanceComparison
from plans.model.balance.linkage import Balance, Counterweight, State
from plans.model.machine import Body
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import NOTHING

BEFORE, AFTER = "before", "after"  # the states of a machine
ROOMY, FEW = 36, 12  # positions that all have room in a graph; about so many of more are told
APART = 1e-3  # of its link: a mass centre nearer to a point than this bears no letter of its own


class Nothing(NamedTuple):
    """The force N, the moment N*m about the shaft and the way m that are no more than rounding."""

    force: float
    moment: float
    way: float


class Side(NamedTuple):
    """A vector of a chain by its name: where it begins, and its value."""

    name: str
    start: complex
    value: complex


@dataclass(frozen=True)
class Balanced:
    """A mechanism balanced by analysis, in one position of the scene."""

    own: BalanceStudy
    comparison: BalanceComparison
    drafting: Drafting
    shown: int

    @property
    def balance(self) -> Balance:
        """All of it."""
        return self.comparison.analysis

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        return self.own.linkage.mechanism

    @property
    def after(self) -> State | None:
        """The machine with its counterweights on; None where none is put on."""
        return None if self.balance.still else self.balance.after

    @cached_property
    def states(self) -> dict[str, State]:
        """The states that a sheet shows."""
        return {BEFORE: self.balance.before} | ({} if self.after is None else {AFTER: self.after})

    @property
    def whole(self) -> bool:
        """Whether the crank turns fully: else nothing is drawn between the positions."""
        return self.balance.before.whole

    @cached_property
    def told(self) -> frozenset[int]:
        """The positions that the graphs must tell."""
        count = len(self.balance.before.centre.phi)
        every = 1 if count <= ROOMY else math.ceil(count / FEW)
        return frozenset({*range(0, count, every), self.shown})

    @cached_property
    def none(self) -> Nothing:
        """What is nothing on the sheets."""
        largest = max(one.forces.largest for one in self.states.values())
        return Nothing(NOTHING * largest, NOTHING * largest * self.reach, NOTHING * self.reach)

    @cached_property
    def reach(self) -> float:
        """How far points come from the shaft of the crank, m."""
        rows = [np.abs(point.r) for point in self.comparison.motion.analysis.points.values()]
        return float(np.nanmax(rows))

    def weights(self, state: str) -> list[Counterweight]:
        """List the counterweights that are on in a state."""
        return [one for one in self.balance.counterweights if one.needed] if state == AFTER else []

    def solid(self, state: str) -> list[Body]:
        """List what has mass in a state, each counterweight by itself."""
        return bodies(self.own.machine, self.weights(state))

    def at(self, link: int, spot: complex) -> complex:
        """Place a spot of a link, or of the frame, in the shown position."""
        if link == FRAME:
            return spot
        return complex(placed(self.mechanism, self.comparison.motion.analysis, link, spot)[self.shown])

    @cached_property
    def points(self) -> dict[str, complex]:
        """The places of the points of all links, the fixed ones among them, and of mass centres that no point names."""
        fixed, moving = self.mechanism.links[FRAME].points, self.comparison.motion.analysis.points
        found = dict(fixed) | {name: complex(one.r[self.shown]) for name, one in moving.items() if name not in fixed}
        for link, body in self.own.machine.bodies.items():
            if f"S{link}" not in found and self._is_apart(link, body.centre):
                found[f"S{link}"] = self.at(link, body.centre)
        return {name: spot for name, spot in found.items() if cmath.isfinite(spot)}

    def _is_apart(self, link: int, centre: complex) -> bool:
        """Tell whether a mass centre lies in none of the points of its link."""
        sizes = [abs(place - centre) for place in self.mechanism.links[link].points.values()]
        return min(sizes) > APART * max(sizes)

    def centre(self, state: str) -> complex:
        """Place the common mass centre."""
        return complex(self.states[state].centre.r[self.shown])

    def vectors(self, state: str) -> Mapping[int, complex]:
        """Give the vectors of main points, m in the links' own frames."""
        return vectors(self.solid(state), self.own.tree.stems)

    def chain(self, state: str) -> Iterator[Side]:
        """Lay the main-point vectors end to end: of the frame's hinges, of the links, along guides."""
        solid, end = self.solid(state), 0j
        mass = sum(one.mass for one in solid)
        for name, value in self._sides(state, solid, mass):
            if abs(value) > KNOWN * self.reach:
                yield Side(name, end, value)
            end += value

    def _sides(self, state: str, solid: list[Body], mass: float) -> Iterator[tuple[str, complex]]:
        tree, motion = self.own.tree, self.comparison.motion.analysis
        behind = {one.link: sum(b.mass for b in solid if b.link in set(tree.behind(one.link))) for one in tree.stems}
        yield "h_0", sum((behind[one.link] * one.at for one in tree.rooted), 0j) / mass
        for link, own in self.vectors(state).items():
            yield f"h_{link}", own * cmath.exp(1j * float(motion.links[link].angle[self.shown]))
        for one in tree.variable:
            along = self.at(one.link, one.origin) - self.at(one.parent, one.at)
            yield f"u_{one.link}", behind[one.link] * along / mass

    def moments(self) -> Iterator[Side]:
        """Lay the static moments kg*m of the links end to end."""
        end = 0j
        told = {one.link: one for one in self.solid(BEFORE)}
        for stem in self.own.tree.stems:
            if stem.link in told:
                value = told[stem.link].mass * self.at(stem.link, told[stem.link].centre)
                yield Side(f"m_{stem.link}r_S{stem.link}", end, value)
                end += value

    def slack(self, name: str, plan: str = "centre", position: int | None = None) -> float:
        """Give twice what the two roads may differ by in a quantity, in a position or in any."""
        rows = [one.allowed for one in self.comparison.of(plan) if one.name == name]
        told = [float(np.nanmax(row)) if position is None else float(row[min(position, len(row) - 1)]) for row in rows]
        return 2 * max(told, default=0.0)
