"""What is said of a cam beside its shape, by both roads: shocks, contact forces, flaws, what mends them (выводы)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import pairwise

import numpy as np

from plans.cam.centre.place import Sizing
from plans.cam.centre.sizes import sizing
from plans.cam.course import FollowerCourse, law_of
from plans.cam.study import LAWS, PROFILE, CamDrawing
from plans.model.cam import NO_SIZES, RETURN, RISE, TABLE, FollowerLoad, Law, dimensions, interval_of
from plans.model.cam_motion import CamFound, CamSizes, Contour, Extreme
from plans.model.motion import Floats
from plans.quantity import Quantity

EPS = 2.0**-52
# What a term of a law goes through on either road: the share of the phase, its power or sine, its coefficient, which is
# itself scaled to the lift, and the sum; a tangent, a root, a product and a quotient are no more.
TERM = 16 * EPS


@dataclass(frozen=True)
class Slack:
    """How far rounding can move the numbers of one cam by either road; (N,) at the turns of a contour."""

    found: CamFound
    sizing: Sizing
    contour: Contour

    def travel(self, order: int) -> float:
        """Of S, S' or S''."""
        cam = self.found.cam
        moving = (abs(p.change) / p.angle**order * gross(p.law, order) for p in cam.moving() if p.law)
        return TERM * (max(moving, default=0.0) + (cam.lift if order == 0 else 0.0))

    def way(self, order: int) -> float:
        """Of the tip's path or a derivative of it, m."""
        cam = self.found.cam
        return self.travel(order) * ((cam.follower.length or 0.0) + self.reach if cam.rocks else 1.0)

    @cached_property
    def reach(self) -> float:
        """The longest length of the cam, m."""
        sizes, contour = self.found.sizes, self.found.contour
        known = (sizes.base, sizes.centre, abs(sizes.pivot), self.found.roller, float(np.max(np.abs(contour.pitch))))
        return max(known)

    @cached_property
    def centre(self) -> float:
        """Of the centre O, m: where limiting lines cross, it is moved by more than they are."""
        ways = [complex(tangent.direction.point) for tangent in self.sizing.binding]
        sines = [abs((a.conjugate() * b).imag) / abs(a * b) for a in ways for b in ways if a is not b]
        moved = self.way(0) + self.way(1) + TERM * self.reach
        return moved / min(sines, default=1.0)

    @property
    def point(self) -> float:
        """Of a point of the pitch curve, m."""
        return self.way(0) + self.centre + TERM * self.reach

    @property
    def lever(self) -> float:
        """Of OD, m; of a unit normal too."""
        return self.point + self.way(1)

    @property
    def angle(self) -> Floats:
        """Of the direction of OD, rad."""
        return np.asarray(self.lever / np.abs(self.contour.lever) + TERM)

    @property
    def profile(self) -> Floats:
        """Of a point of the working profile, m."""
        return np.asarray(self.point + self.found.roller * self.angle)

    @property
    def curvature(self) -> Floats:
        """Of 1/ρ, 1/m: a quotient of the second derivative and the cube of the first, OD."""
        contour = self.contour
        if self.found.cam.flat:
            with np.errstate(divide="ignore"):  # where ρ is 0, 1/ρ is anything: there ρ itself is held
                return np.asarray(self.radius / contour.radius**2)
        size, (first, second) = np.abs(contour.lever), (self.way(1), self.way(2))
        slope = np.abs(contour.travel.slope)
        bend = np.abs(contour.travel.bend) + 2 * slope + (slope**2 if self.found.cam.rocks else 0.0)
        bend = bend * (self.found.cam.follower.length or 1.0) + np.abs(contour.tip)
        moved = second + 2 * (1 + slope) * first + self.point  # of the second derivative: S'', S' and its square, S
        return np.asarray((moved + 3 * self.lever * bend / size) / size**2)

    @property
    def radius(self) -> Floats:
        """Of ρ under a flat face, m: a sum of lengths, of a rocker over powers of 1 - θ'."""
        cam, contour = self.found.cam, self.contour
        lead = 1 - cam.follower.sense * contour.travel.slope if cam.rocks else np.ones_like(contour.turned)
        return np.asarray((self.point + self.way(1) + self.way(2)) / np.abs(lead) ** 3)


@lru_cache(maxsize=64)
def gross(law: Law, order: int) -> float:
    """Give what the terms of a law, or of a derivative, add up to, in shares of phase and lift.

    The slopes and bends of a table are differences of its points over its steps, all solved together.
    """
    terms = law_of(law).gross(order) + law_of(law).gross(order + 1)  # the share of the phase is rounded too
    if law.name != TABLE:
        return terms
    step = min(b[0] - a[0] for a, b in pairwise(law.points))
    return terms + len(law.points) / step**order


Near = Callable[[Extreme], tuple[Slack, ...]]
UNKNOWN = math.nan  # what one road does not say
MENDED = ("pressure", "concave", "sharp")  # flaws that another R0 mends


def _pair(plan: str, name: str, unit: str, ours: float | Floats, theirs: float | Floats, allowed: float) -> Quantity:
    return Quantity.of((plan, name, unit), (ours, theirs), allowed, float(np.max(np.abs(ours), initial=0.0)))


@dataclass(frozen=True)
class Verdicts:
    """What both roads say of one cam; `near` tells how far rounding can move it at the place of an extreme."""

    drawing: CamDrawing
    theirs: CamFound
    slack: Slack
    near: Near

    @property
    def ours(self) -> CamFound:
        """The cam by construction."""
        return self.drawing.found

    def shocks(self) -> Iterator[Quantity]:
        """Compare the shocks: where they are, and how large, the hard ones and the soft ones."""
        ours, theirs = self.ours.shocks, self.theirs.shocks
        if [shock.order for shock in ours] != [shock.order for shock in theirs]:
            yield _pair(LAWS, "φ shocks", self._across, np.array([len(ours)]), np.array([UNKNOWN]), 0.0)
            return
        if ours:
            places, their_places = (np.array([shock.turned for shock in road]) for road in (ours, theirs))
            yield _pair(LAWS, "φ shocks", self._across, places, their_places, TERM * self.ours.cam.turn)
        for order, name in enumerate(("ΔS'", "ΔS''"), 1):
            jumps, others = (
                np.array([shock.jump for shock in road if shock.order == order]) for road in (ours, theirs)
            )
            if jumps.size:
                yield _pair(LAWS, name, dimensions(self.ours.cam)[order], jumps, others, 2 * self.slack.travel(order))

    @property
    def _across(self) -> str:
        return "m" if self.ours.cam.translates else "rad"

    def flaws(self) -> Iterator[Quantity]:
        """See that both roads find the same kinds of flaws, in the same order."""
        kinds, others = ([flaw.kind for flaw in road.flaws] for road in (self.ours, self.theirs))
        if kinds or others:
            yield _pair(PROFILE, "flaws", "1", len(kinds), len(others) if kinds == others else UNKNOWN, 0.0)

    def forces(self) -> Iterator[Quantity]:
        """Compare the extremes of the force at the contact, of the wear, and the preload that holds the follower."""
        ours, theirs, load = self.ours.pressing, self.theirs.pressing, self.ours.cam.load
        if ours is None or theirs is None or load is None:
            if ours is not theirs:  # one road alone tells of forces
                force, their_force = (UNKNOWN if road is None else road.least.value for road in (ours, theirs))
                yield _pair(PROFILE, "N_min", "N", force, their_force, 0.0)
            return
        for name, extreme, another in (("N_min", ours.least, theirs.least), ("N_max", ours.most, theirs.most)):
            yield _pair(PROFILE, name, "N", extreme.value, another.value, self._force(extreme, load)[0])
        yield _pair(PROFILE, "N·v_sl", "W", ours.wear.value, theirs.wear.value, self._force(ours.wear, load)[1])
        unit, resisted = "N*m" if self.ours.cam.rocks else "N", self._resistance(self.slack, load)
        yield _pair(PROFILE, "preload", unit, ours.preload, theirs.preload, resisted + TERM * ours.preload)

    def _force(self, extreme: Extreme, load: FollowerLoad) -> tuple[float, float]:
        """Give how far rounding can move the force, N, and force times sliding speed, W, at the place of an extreme."""
        sides = [self._there(slack, load) for slack in self.near(extreme)]
        return max(side[0] for side in sides), max(side[1] for side in sides)

    def _there(self, slack: Slack, load: FollowerLoad) -> tuple[float, float]:
        """Give it on one side: the force is what is overcome along the way over its arm."""
        cam, contour, speed = self.ours.cam, slack.contour, self.ours.cam.speed or 0.0
        travel = contour.travel
        # What the cam overcomes along the follower's way, whatever its terms' signs.
        terms = (load.mass * speed**2 * travel.bend[0], load.stiffness * travel.s[0], load.preload, load.force)
        way = float(sum(map(abs, terms)))
        if not cam.flat:
            size = (cam.follower.length or 0.0) if cam.rocks else 1.0
            arm, moved = size * math.cos(contour.pressure[0]), size * float(slack.angle[0])
        elif cam.rocks:
            normal = contour.lever[0] / abs(contour.lever[0])
            arm = (normal.conjugate() * (contour.tip[0] - self.ours.sizes.pivot)).imag
            moved = float(slack.radius[0])
        else:
            arm, moved = 1.0, 0.0
        if not arm:
            return math.inf, math.inf
        force = way / abs(arm)
        off = self._resistance(slack, load) / abs(arm) + force * moved / abs(arm)
        return off, speed * (off * float(contour.sliding[0]) + force * slack.lever)

    def _resistance(self, slack: Slack, load: FollowerLoad) -> float:
        """Give how far rounding can move it: by S'' and S, and by the sum of its terms."""
        speed = self.ours.cam.speed or 0.0
        moved = load.mass * speed**2 * slack.travel(2) + load.stiffness * slack.travel(0)
        travel = slack.contour.travel
        terms = load.mass * speed**2 * np.abs(travel.bend).max() + load.stiffness * np.abs(travel.s).max()
        return float(moved + TERM * (terms + abs(load.preload) + abs(load.force)))

    def remedies(self) -> Iterator[Quantity]:
        """Compare R0 that mends, and the sizes that the limits alone would give."""
        ours, theirs = self.ours, self.theirs
        if any(flaw.kind in MENDED for flaw in ours.flaws) and (ours.mending, theirs.mending) != (None, None):
            base, their_base = (UNKNOWN if road.mending is None else road.mending for road in (ours, theirs))
            yield _pair(PROFILE, "R_0 mending", "m", base, their_base, self._mended + TERM * abs(base))
        if ours.advised is not None or theirs.advised is not None:
            yield from self._advised(ours.advised, theirs.advised)

    @property
    def _mended(self) -> float:
        """How far rounding can move R0 that mends, m: S0 = (S' - e)/tan α - S; of a flat face a radius."""
        if self.ours.cam.flat:
            return float(np.max(self.slack.radius))
        intervals = [interval for kind in (RISE, RETURN) if (interval := interval_of(self.ours.cam, kind)) is not None]
        steepest = min(math.tan(min(abs(interval.low), abs(interval.high))) for interval in intervals)
        return self.slack.way(0) + (self.slack.way(1) + self.slack.centre) / steepest

    def _advised(self, ours: CamSizes | None, theirs: CamSizes | None) -> Iterator[Quantity]:
        """Compare the sizes that the limits alone would give: R_0, and the offset or the distance of centres."""
        if ours is None or theirs is None:
            base, their_base = (sizes.base if sizes else UNKNOWN for sizes in (ours, theirs))
            yield _pair(PROFILE, "R_0 advised", "m", base, their_base, 0.0)
            return
        cam = replace(self.ours.cam, given=NO_SIZES)
        allowed = Slack(replace(self.ours, cam=cam, sizes=ours), sizing(FollowerCourse(cam)), self.ours.contour).centre
        beside = ("L", ours.centre, theirs.centre) if cam.rocks else ("e", ours.offset, theirs.offset)
        for name, value, true in (("R_0", ours.base, theirs.base), beside):
            yield _pair(PROFILE, f"{name} advised", "m", value, true, allowed)
