"""Where a flat face touches the cam, and how the profile bends there (плоский толкатель: место касания).

The face touches where the perpendicular from the relative instant centre of cam and follower meets it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Final, NamedTuple, cast

import numpy as np
import numpy.typing as npt

from geometry.meet import Vectors
from plans.cam.course import FollowerCourse, law_of
from plans.model.cam import Cam, Phase
from plans.model.cam_motion import CamSizes, Extreme, FollowerTravel, Points
from plans.model.motion import Floats


def guide_start(sizes: CamSizes) -> float:
    """Give S0, the height of the tip above O at the start of a follower that translates, m."""
    return math.sqrt((sizes.base - sizes.offset) * (sizes.base + sizes.offset))


def arm(cam: Cam, s: Floats) -> Points:
    """Give the unit direction of a rocker from its pivot; at mid-swing it is level, whence it rises."""
    return np.asarray(cam.rising * np.exp(1j * cam.rising * (s - cam.lift / 2)))


@dataclass(frozen=True)
class Tip:
    """The tip at N turns of the cam: K and its derivatives to the third, and those of its curve on the cam.

    `before` takes the sides before a joint, where the law has a jump.
    """

    course: FollowerCourse
    sizes: CamSizes
    turned: Floats  # rad
    before: bool = False

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.course.cam

    @cached_property
    def travel(self) -> FollowerTravel:
        """S, S', S''."""
        return self.course.at(self.turned, self.before)

    @cached_property
    def jerk(self) -> Floats:
        """S''', m/rad3."""
        found = np.zeros_like(self.turned)
        for phase in self.cam.moving():
            here = self.within(phase)
            if phase.law is not None:
                share = np.clip((self.turned[here] - phase.start) / phase.angle, 0.0, 1.0)
                found[here] = phase.change / phase.angle**3 * law_of(phase.law).at(share, 3, self.before)
        return found

    def within(self, phase: Phase) -> npt.NDArray[np.bool_]:
        """Tell which turns lie in a phase, (N,): at its ends by the side that is taken."""
        phi = self.turned
        if self.before:
            return np.asarray((phase.start < phi) & (phi <= phase.end))
        return np.asarray((phase.start <= phi) & (phi < phase.end))

    @cached_property
    def heading(self) -> Points:
        """The unit direction in which the tip goes when S grows."""
        if not self.cam.rocks:
            return np.full_like(self.travel.s, 1j, dtype=complex)
        return np.asarray(1j * self.cam.rising * arm(self.cam, self.travel.s))

    @property
    def turns(self) -> float:
        """How the cam turns as φ grows: +1 counter-clockwise, -1 clockwise, 0 of one that translates."""
        return 0.0 if self.cam.translates else float(self.cam.sense)

    @cached_property
    def orders(self) -> tuple[Points, Points, Points, Points]:
        """K, K', K'', K''' of a pointed follower or a roller."""
        s, slope, bend = self.travel
        if not self.cam.rocks:
            start = complex(self.cam.sense * self.sizes.offset, guide_start(self.sizes))
            return _points(start + 1j * s, 1j * slope, 1j * bend, 1j * self.jerk)
        by = 1j * self.cam.rising
        reach = (self.cam.follower.length or 0.0) * arm(self.cam, s)
        first, second = by * slope, by * bend - slope**2
        third = by * self.jerk - 3 * slope * bend - by * slope**3
        return _points(self.sizes.pivot + reach, first * reach, second * reach, third * reach)

    @cached_property
    def trail(self) -> tuple[Points, Points, Points]:
        """Derivatives by φ of the curve that the tip leaves on the cam, as they stand in the frame."""
        k, first, second, third = self.orders
        w = 1j * self.turns
        if self.cam.translates:
            return first + self.cam.sense, second, third
        return first - w * k, second - 2 * w * first - k, third - 3 * w * second - 3 * first + w * k

    @cached_property
    def lever(self) -> Points:
        """OD of the book, square to the curve, out of the cam; its size is how fast the tip goes along it, m/rad."""
        return np.asarray(1j * self.cam.sense * self.trail[0])

    def on_cam(self, place: Points) -> Points:
        """Give the points of the cam, m, that are at places in the frame, (N,)."""
        if self.cam.translates:
            return np.asarray(place + self.cam.sense * self.turned)
        return np.asarray(place * np.exp(-1j * self.turns * self.turned))

    def in_frame(self, point: complex) -> Points:
        """Give where a point of the cam is in the frame at each turn, (N,) m."""
        if self.cam.translates:
            return np.asarray(point - self.cam.sense * self.turned)
        return np.asarray(point * np.exp(1j * self.turns * self.turned))


def _points(*orders: Vectors) -> tuple[Points, Points, Points, Points]:
    return cast(tuple[Points, Points, Points, Points], orders)


PARTS: Final = 48  # of a stretch: a law has at most seven turning points on one, and what is made of it not many more
Value = Callable[[Tip], Floats]


class TurnSide(NamedTuple):
    """A turn of the cam, rad, and the side on which a value is taken there."""

    turned: float
    before: bool


class TurnSpan(NamedTuple):
    """A part of the turn, rad, and its places at which a value can be the worst."""

    start: float
    end: float
    places: tuple[TurnSide, ...]


@dataclass(frozen=True)
class Stretches:
    """The stretches of a cam's turn; a value is looked at on all of them at once."""

    course: FollowerCourse
    sizes: CamSizes

    @cached_property
    def edges(self) -> Floats:
        """The joints, rad."""
        return np.array(self.course.joints)

    @cached_property
    def grid(self) -> Floats:
        """Where a value is looked at: a row a stretch, its ends among them, and closer towards those.

        At an end a law begins so gently that a derivative vanishes there; its last change of sign lies close by.
        """
        shares = (1 - np.cos(np.linspace(0.0, np.pi, PARTS + 1))) / 2
        found = self.edges[:-1, None] + np.diff(self.edges)[:, None] * shares
        found[:, -1] = self.edges[1:]
        return np.asarray(found)

    def at(self, value: Value, turned: Floats) -> Floats:
        """Give a value within stretches; at a joint after it."""
        return value(Tip(self.course, self.sizes, turned))

    def ends(self, value: Value) -> Floats:
        """Give a value at the ends of the stretches, after the first and before the second, (2, stretches)."""
        last = value(Tip(self.course, self.sizes, self.edges[1:], before=True))
        return np.array([self.at(value, self.edges[:-1]), last])

    def sampled(self, value: Value) -> Floats:
        """Give a value on the grid."""
        found = self.at(value, self.grid.ravel()).reshape(self.grid.shape)
        found[:, -1] = self.ends(value)[1]
        return found

    def roots(self, value: Value) -> Floats:
        """Give the turns where a value changes its sign inside a stretch, rising."""
        found = self.sampled(value)
        row, part = np.nonzero(found[:, :-1] * found[:, 1:] < 0)
        near, far = self.grid[row, part], self.grid[row, part + 1]
        inner = closed_in(lambda phi: self.at(value, phi), near, far, found[row, part], found[row, part + 1])
        on = self.grid[:, 1:-1][(found[:, 1:-1] == 0) & ((found[:, :-2] != 0) | (found[:, 2:] != 0))]
        return np.sort(np.concatenate([inner, on]))

    def places(self, slope: Value) -> tuple[TurnSide, ...]:
        """Give where a value can be greatest or least: ends of stretches, and where its derivative vanishes."""
        starts = [TurnSide(phi, False) for phi in self.edges[:-1].tolist()]
        ends = [TurnSide(phi, True) for phi in self.edges[1:].tolist()]
        return (*starts, *ends, *(TurnSide(phi, False) for phi in self.roots(slope).tolist()))

    def read(self, value: Value, places: tuple[TurnSide, ...]) -> Floats:
        """Give a value at places."""
        turned = np.array([place.turned for place in places])
        found = self.at(value, turned)
        back = np.array([place.before for place in places], dtype=bool)
        found[back] = value(Tip(self.course, self.sizes, turned[back], before=True))
        return found

    def most(self, value: Value, places: tuple[TurnSide, ...]) -> Extreme | None:
        """Give the greatest value at places, the first where there are several."""
        found = self.read(value, places)
        if not places or np.isnan(found).all():
            return None
        best = int(np.nanargmax(found))
        return Extreme(float(found[best]), places[best].turned)

    def spans(self, value: Value, places: tuple[TurnSide, ...]) -> Iterator[TurnSpan]:
        """Give the parts of the turn where a value is above 0; places on two sides of a joint make one part."""
        cuts = np.unique(np.concatenate([self.edges, self.roots(value), [place.turned for place in places]]))
        above = self.at(value, (cuts[:-1] + cuts[1:]) / 2) > 0
        start = np.flatnonzero(above & ~np.concatenate([[False], above[:-1]]))
        end = np.flatnonzero(above & ~np.concatenate([above[1:], [False]]))
        for begin, other in zip(cuts[start].tolist(), cuts[end + 1].tolist(), strict=True):
            yield TurnSpan(begin, other, tuple(place for place in places if begin <= place.turned <= other))


@dataclass(frozen=True)
class FaceTouch:
    """The contact of a flat face at N turns of the cam: where along the face, the profile's radius, how it slides.

    Of a rocker the place is counted along the face from under its pivot, of one that translates from its axis, to where
    the cam carries it on a rise.
    """

    tip: Tip

    @cached_property
    def normal(self) -> Points:
        """The unit normal out of the cam."""
        return self.tip.heading

    @cached_property
    def lead(self) -> Floats:
        """How fast the cam turns under a rocker's face, in shares of its own speed."""
        return 1 - self.tip.cam.follower.sense * self.tip.travel.slope

    @cached_property
    def place(self) -> Floats:
        """Where the face touches, m."""
        return self._places[0] if self.tip.cam.rocks else self.tip.travel.slope

    @cached_property
    def place_slope(self) -> Floats:
        """Its derivative by the turn, m/rad."""
        return self._places[1] if self.tip.cam.rocks else self.tip.travel.bend

    @cached_property
    def _places(self) -> tuple[Floats, Floats, Floats]:
        """Give a rocker's place of contact and its derivatives: foot of O under the face, over the lead."""
        cam, (_, slope, bend), jerk = self.tip.cam, self.tip.travel, self.tip.jerk
        by, along = 1j * cam.rising, arm(cam, self.tip.travel.s)
        pivot, sense = np.conj(self.tip.sizes.pivot), cam.follower.sense
        foot = -(along * pivot).real
        foot_1 = -(by * slope * along * pivot).real
        foot_2 = -((by * bend - slope**2) * along * pivot).real
        place = foot / self.lead
        place_1 = (foot_1 + place * sense * bend) / self.lead
        return place, place_1, (foot_2 + 2 * place_1 * sense * bend + place * sense * jerk) / self.lead

    @cached_property
    def contact(self) -> Points:
        """Where the face touches, in the frame."""
        tip = self.tip
        if not tip.cam.rocks:
            return np.asarray(tip.cam.sense * self.place + 1j * self.height)
        return tip.sizes.pivot + tip.cam.follower.face * self.normal + self.place * arm(tip.cam, tip.travel.s)

    @property
    def sweep(self) -> Floats:
        """How fast contact goes along the profile, m/rad: above 0 against the cam's rotation, as it should."""
        return self._sweeps[0] if self.tip.cam.rocks else self.radius

    @cached_property
    def height(self) -> Floats:
        """The distance of the face from O along its normal, m."""
        tip = self.tip
        if not tip.cam.rocks:
            return tip.sizes.base + tip.travel.s
        return np.asarray((self.normal * np.conj(tip.sizes.pivot)).real + tip.cam.follower.face)

    @cached_property
    def radius(self) -> Floats:
        """The radius of curvature of the profile, m: below 0 it would be hollow."""
        if not self.tip.cam.rocks:
            return self.tip.sizes.base + self.tip.travel.s + self.tip.travel.bend
        return self._sweeps[0] / self.lead

    @cached_property
    def radius_slope(self) -> Floats:
        """Its derivative by the turn, m/rad."""
        if not self.tip.cam.rocks:
            return self.tip.travel.slope + self.tip.jerk
        sweep, slope = self._sweeps
        return (slope + sweep / self.lead * self.tip.cam.follower.sense * self.tip.travel.bend) / self.lead

    @cached_property
    def _sweeps(self) -> tuple[Floats, Floats]:
        """Give how fast contact goes along the profile, m/rad, and the derivative of that: of a rocker's face."""
        cam, (_, slope, bend) = self.tip.cam, self.tip.travel
        place, place_1, place_2 = self._places
        by, w, back = 1j * cam.rising, 1j * cam.sense, np.conj(self.normal)
        along, face = arm(cam, self.tip.travel.s), cam.follower.face * self.normal
        turn, turn_1 = by * slope, by * bend - slope**2
        first = turn * face + (place_1 + place * turn) * along
        second = turn_1 * face + (place_2 + 2 * place_1 * turn + place * turn_1) * along
        return (w * (first - w * self.contact) * back).real, (w * (second - w * first) * back).real

    @cached_property
    def slip(self) -> Floats:
        """How fast the face slips on the cam, m/rad: the distance of contact from the relative instant centre."""
        follower = self.tip.cam.follower
        return self.height - (follower.sense * self.tip.travel.slope * follower.face if self.tip.cam.rocks else 0.0)

    @cached_property
    def slip_slope(self) -> Floats:
        """Its derivative by the turn."""
        tip, follower = self.tip, self.tip.cam.follower
        if not tip.cam.rocks:
            return tip.travel.slope
        by = 1j * tip.cam.rising * tip.travel.slope
        lift = (by * self.normal * np.conj(tip.sizes.pivot)).real
        return np.asarray(lift - follower.sense * tip.travel.bend * follower.face)

    @cached_property
    def pressure(self) -> Floats:
        """The angle from the way of the point of contact, when S grows, to the normal, rad."""
        if not self.tip.cam.rocks:
            return np.zeros_like(self.tip.turned)
        follower = self.tip.cam.follower
        return -follower.sense * np.arctan2(follower.face, self.place)

    @cached_property
    def pressure_slope(self) -> Floats:
        """Its derivative by the turn."""
        if not self.tip.cam.rocks:
            return np.zeros_like(self.tip.turned)
        follower = self.tip.cam.follower
        return follower.sense * follower.face * self.place_slope / (self.place**2 + follower.face**2)


CLOSINGS: Final = 60  # a false position whose standing end is halved needs about ten
SETTLED: Final = 1e-12  # of what was begun with: the next step would be a rounding, as fast as they shrink


def closed_in(value: Callable[[Floats], Floats], near: Floats, far: Floats, first: Floats, last: Floats) -> Floats:
    """Close in on changes of sign between two places each, whose values are known: false position, a half each time.

    >>> closed_in(lambda x: x**2 - 2, np.array([1.0]), np.array([2.0]), np.array([-1.0]), np.array([2.0])).round(9)
    array([1.41421356])
    """
    near, far, first, last = near.copy(), far.copy(), first.copy(), last.copy()
    wide = np.abs(far - near)
    for _ in range(CLOSINGS if len(near) else 0):
        guess = np.where(first == last, near, far - last * (far - near) / np.where(first == last, 1.0, last - first))
        found = value(guess)
        turns = found * last < 0
        near, first = np.where(turns, far, near), np.where(turns, last, first / 2)
        still = np.all((found == 0) | (np.abs(guess - far) <= SETTLED * wide))
        far, last = guess, found
        if still:
            break
    return far
