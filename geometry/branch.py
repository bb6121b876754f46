"""A branch of assemblies, followed from one of them as far as the leads can be met (ветвь сборок, по непрерывности).

A body on three leads has up to six assemblies, and no side of a line tells them apart. One is followed by small steps
of what drives it, each closed by Newton's method from the last; it ends where the three lines of the leads come to meet
in one point, which no step passes, for the determinant must keep its sign.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from geometry.meet import EPS, Meeting, Sizes, Vectors
from geometry.three_leads import GUIDE, ROUNDS, THERE, BodyPose, HeldBody, Known

Floats = npt.NDArray[np.float64]
FAN = 33  # steps in the place of one that is too long
TURN = 2 * np.pi
BAR = 1e-9  # rad, left between an end and a way round to it, which comes there in another pose: nothing may pass it
LOOKS = 10  # 32**10 of a step is below the rounding of an angle
SQRT_EPS = EPS**0.5  # of a correction, where rounding lets it shrink no more
LAW = 0.2  # share of a correction that the next may have: Newton's law holds for a pose so near


@dataclass(frozen=True, eq=False)
class AssemblyBranch:
    """Poses of a body over what drives it, counted from where it was assembled."""

    home: complex  # a crank's direction, or the way of a slide as a vector
    along: complex  # the direction of the slide; 0: a crank
    keys: Floats  # that rise: angles rad or ways m from home
    poses: BodyPose  # at the keys
    out: int  # the lead that the special point leaves out: the lines of the others cross most sharply

    @cached_property
    def _middles(self) -> Floats:
        return np.asarray((self.keys[1:] + self.keys[:-1]) / 2)

    def over(self, free: Vectors) -> tuple[BodyPose, npt.NDArray[np.bool_]]:
        """Give the nearest pose for each place of what drives the body, and whether the branch goes as far."""
        key = self._key(np.asarray(free))
        near = np.searchsorted(self._middles, key)
        pose = BodyPose(np.asarray(self.poses.reach)[near], np.asarray(self.poses.turn)[near])
        return pose, np.asarray((self.keys[0] <= key) & (key <= self.keys[-1]))

    def _key(self, free: npt.NDArray[np.complex128]) -> Floats:
        if self.along:
            return np.asarray(((free - self.home) * self.along.conjugate()).real)
        ahead = np.angle(free * self.home.conjugate()) - self.keys[0]
        return np.asarray(self.keys[0] + np.mod(ahead, TURN))


Side: TypeAlias = Sizes | BodyPose | AssemblyBranch  # of a meeting; of a triad an assembly, or a branch of them


class Settling(NamedTuple):
    """What settles a body on leads that begin at given marks: its lengths, and which assembly it has."""

    body: HeldBody
    start: BodyPose | AssemblyBranch

    def known(self, begins: Sequence[Any]) -> Known:
        """Sort where the leads begin: their points, then the directions of the guides, in the order of the leads."""
        ways = iter(begins[3:])
        guided = [next(ways) if lead.kind == GUIDE else 0j for lead in self.body.leads]
        return Known((begins[0], begins[1], begins[2]), (guided[0], guided[1], guided[2]))

    @property
    def out(self) -> int:
        """The lead that the special point of the two others leaves out."""
        return self.start.out if isinstance(self.start, AssemblyBranch) else 2

    def met(self, begins: Sequence[Any], free: Vectors) -> Meeting:
        """Settle the body over places of what drives it: the vector to its place, its +x axis, how sharply."""
        pose, inside = self.start.over(free)
        return self.body.meeting(self.known(begins), pose, inside, self.out)


class _Reached(NamedTuple):
    key: float
    pose: BodyPose


def follow(
    body: HeldBody, start: BodyPose, look: Callable[[Floats], Known], ends: tuple[float, float], steps: int
) -> tuple[Floats, BodyPose, int]:
    """Follow an assembly both ways from key 0: the keys reached, the poses there, the lead best left out.

    `look` tells where the leads begin at some keys; `ends` are the keys to go to, each by so many steps. Where one of
    them is not reached but the other, half a turn off, is, the way goes on from there round to where the first ended.
    """
    first = _Reached(0.0, start)
    ways = [_way(body, look, first, end, steps) for end in ends]
    for k, (way, other) in enumerate(zip(ways, ways[::-1], strict=True)):
        last = way[-1].key
        if abs(last) == TURN / 2 and other[-1].key != ends[1 - k]:
            end = other[-1].key + math.copysign(TURN - BAR, last)
            ways[k] = way + _way(body, look, way[-1], end, steps)[1:]
    stations = [*reversed(ways[0][1:]), *ways[1]]
    keys = np.array([station.key for station in stations])
    poses = BodyPose(*(np.array([getattr(s.pose, part) for s in stations]) for part in ("reach", "turn")))
    crosses = np.abs(np.array(np.broadcast_arrays(*body.held(look(keys), poses).crosses)))
    return keys, poses, int(np.argmax(crosses.min(axis=1)))


def _way(body: HeldBody, look: Callable[[Floats], Known], start: _Reached, end: float, steps: int) -> list[_Reached]:
    """Go from a station towards a key, as far as it goes."""
    return [start, *_march(body, look, np.linspace(start.key, end, steps + 1), start.pose, LOOKS)[0]]


def _march(
    body: HeldBody, look: Callable[[Floats], Known], keys: Floats, pose: BodyPose, looks: int
) -> tuple[list[_Reached], bool]:
    """Go from key to key, where need be by shorter steps; tell whether the last was reached."""
    known, way = look(keys), list[_Reached]()
    for k in range(1, len(keys)):
        there = _step(body, known.at(k - 1), known.at(k), pose)
        if there is not None:
            way.append(_Reached(float(keys[k]), there))
        else:
            finer = np.linspace(keys[k - 1], keys[k], FAN)
            more, whole = _march(body, look, finer, pose, looks - 1) if looks else ([], False)
            way += more
            if not whole:
                return way, False
        pose = way[-1].pose
    return way, True


def _step(body: HeldBody, before: Known, known: Known, pose: BodyPose) -> BodyPose | None:
    """Close a pose where the leads begin elsewhere; None where it may be of another assembly.

    Newton's corrections must shrink at once, and the determinant keep its sign and at least half its size.
    """
    left, last = body.held(before, pose).determinant, np.inf
    try:
        for _ in range(ROUNDS):
            pose, off = body.nearer(known, pose)
            if off <= THERE or not off <= LAW * last:
                break
            last = off
        reached = body.held(known, pose).determinant
    except ZeroDivisionError:
        return None
    return pose if off <= SQRT_EPS and reached * left >= left * left / 2 else None
