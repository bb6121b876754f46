"""A body on three leads: its assemblies, a branch of them, and what moves it (трёхповодковая группа, M3.10).

Each lead holds one length. A rod keeps a hinge of the body at a distance from its own outer hinge; a guide keeps a
hinge of the body so far to its left; a slot of the body has its lead's outer hinge so far to its left. No ruler finds
the body: the three lengths are met by trial, from a pose close by (метод ложных положений). All functions work on one
position, in plain complex numbers, and on an array of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.meet import EPS, UNBORNE, Meeting, Vectors, cross, dot

ROD, GUIDE, SLOT = "RR", "PR", "RP"  # a lead's outer and inner pair: turning or sliding
ROUNDS = 12  # of Newton's method: from one true digit four rounds make sixteen; the rest is for slow beginnings
THERE = 64.0 * EPS  # of a correction, in sizes of the body: a few roundings of what it is reckoned from
ANGLES = np.exp(2j * np.pi * np.arange(7) / 7)  # a sum of sines of up to three angles is told by seven of its values
AROUND = np.linspace(-1.0, 1.0, 65)  # rad
MERGED = EPS**0.25  # sine of two lines that are one: at a double root, of which half the digits are known
ROUND = 0.05  # a root so near to the unit circle may be a direction of the body


class Lead(NamedTuple):
    """One lead of a body: its kind, its hinge on the body or a point of the body's slot, its size m, the slot's way."""

    kind: str
    at: complex  # in the body's own frame
    size: float  # of a rod its length; how far a hinge lies to the left of its guide or slot
    slot: complex = 0j


class Known(NamedTuple):
    """Where the leads begin: a point of each, outer hinge or point of a guide, and the directions of guides."""

    places: tuple[Any, Any, Any]
    ways: tuple[Any, Any, Any]

    def at(self, position: int) -> Known:
        """Give what is known in one position, in plain numbers."""
        places, ways = (tuple(_number(value, position) for value in row) for row in self)
        return Known((places[0], places[1], places[2]), (ways[0], ways[1], ways[2]))


def _number(value: Any, position: int) -> complex:
    row = np.asarray(value)
    return complex(row[position] if row.ndim else row)


@dataclass(frozen=True, eq=False)
class BodyPose:
    """Where a body is: the vector from the first lead's beginning to its place on the body, and the body's +x axis."""

    reach: Any
    turn: Any

    def __getitem__(self, position: int) -> BodyPose:
        return BodyPose(_number(self.reach, position), _number(self.turn, position))

    def over(self, _: Vectors) -> tuple[BodyPose, Any]:
        """Give the pose to begin from at other positions: itself."""
        return self, True


def chosen(poses: Sequence[BodyPose], which: npt.NDArray[np.intp]) -> BodyPose:
    """Give at each position one of several poses."""
    return BodyPose(*(np.choose(which, list(row)) for row in zip(*((p.reach, p.turn) for p in poses), strict=True)))


class Held(NamedTuple):
    """How the leads hold a body in a pose: the lines of their forces, and by how much their lengths are missed, m."""

    along: tuple[Any, Any, Any]  # the direction of the only force that each lead can transmit
    moments: tuple[Any, Any, Any]  # of those about the first lead's place on the body, m
    misses: tuple[Any, Any, Any]  # m
    contacts: tuple[Any, Any, Any]  # a point of each lead's line, from the first lead's place on the body

    @property
    def crosses(self) -> tuple[Any, Any, Any]:
        """The sines at which the second and third, third and first, first and second line cross."""
        first, second, third = self.along
        return cross(second, third), cross(third, first), cross(first, second)

    @property
    def determinant(self) -> Any:
        """The moment of the three lines, m: nothing where they meet in one point (заклинивание)."""
        return sum(moment * sine for moment, sine in zip(self.moments, self.crosses, strict=True))

    @property
    def moves(self) -> tuple[tuple[Any, Any], ...]:
        """How far a length of each lead moves the first lead's place on the body, and how far it turns the body."""
        whole, found = self.determinant, []
        for lead, sine in enumerate(self.crosses):
            after, before = (lead + 1) % 3, (lead + 2) % 3
            shift = self.along[before] * self.moments[after] - self.along[after] * self.moments[before]
            found.append((1j * shift / whole, sine / whole))
        return tuple(found)

    @property
    def short(self) -> Any:
        """By how much the lengths fail together to be met, m, whatever the body does about it."""
        crosses = self.crosses
        total = sum(miss * sine for miss, sine in zip(self.misses, crosses, strict=True))
        return abs(total) / sum(abs(sine) for sine in crosses)

    def arm(self, pair: int) -> Any:
        """Give the vector from the meeting of two leads' lines to the third lead, times the sine at which they cross.

        `pair` is the lead that is left out.
        """
        first, other = (pair + 1) % 3, (pair + 2) % 3
        between = self.contacts[other] - self.contacts[first]
        apart = (self.contacts[pair] - self.contacts[first]) * self.crosses[pair]
        return apart - self.along[first] * cross(between, self.along[other])


class HeldBody(NamedTuple):
    """A body on its three leads; rods come first."""

    leads: tuple[Lead, Lead, Lead]

    def held(self, known: Known, pose: BodyPose) -> Held:
        """Tell how the leads hold the body in a pose."""
        along, moments, misses, contacts = [], [], [], []
        for lead, place, way in zip(self.leads, *known, strict=True):
            spot = pose.turn * (lead.at - self.leads[0].at)
            start = place - known.places[0]
            arm, contact = pose.reach + spot - start, spot
            if lead.kind == ROD:
                far = abs(arm)
                normal, miss = arm / far, far - lead.size
            elif lead.kind == GUIDE:
                normal = 1j * way
                miss = dot(normal, arm) - lead.size
            else:
                normal, contact = 1j * pose.turn * lead.slot, start - pose.reach
                miss = dot(normal, arm) + lead.size
            along.append(normal)
            moments.append(cross(contact, normal))
            misses.append(miss)
            contacts.append(contact)
        return Held(*((row[0], row[1], row[2]) for row in (along, moments, misses, contacts)))

    @property
    def size(self) -> float:
        """How large it is, m."""
        spots = [lead.at - self.leads[0].at for lead in self.leads]
        return max(*map(abs, spots), *(abs(lead.size) for lead in self.leads))

    def nearer(self, known: Known, pose: BodyPose) -> tuple[BodyPose, Any]:
        """Correct a pose once by Newton's method; tell by how much, in sizes of the body."""
        held = self.held(known, pose)
        moved = [(miss * shift, miss * turn) for miss, (shift, turn) in zip(held.misses, held.moves, strict=True)]
        shift, turn = (sum(row) for row in zip(*moved, strict=True))
        spin = 1 - 1j * turn
        turned = pose.turn * spin
        return BodyPose(pose.reach - shift, turned / abs(turned)), abs(shift) / self.size + abs(turn)

    def assemblies(self, known: Known) -> list[BodyPose]:
        """Give all assemblies of the body over positions, (N,) each, NaN where there are fewer (сборки).

        The lengths leave a sum of sines of the body's angle, of three angles at most: of its six roots the real ones.
        """
        values = np.array([np.broadcast_to(self._height(known, turn)[0], _count(known)) for turn in ANGLES.tolist()])
        powers = np.roll(np.fft.fft(values, axis=0) / len(values), 3, axis=0)  # of z from -3 to 3
        while len(powers) > 1 and np.abs(powers[[0, -1]]).max() <= np.sqrt(EPS) * np.abs(powers).max():
            powers = powers[1:-1]
        degree = len(powers) - 1
        companions = np.zeros((powers.shape[1], degree, degree), dtype=complex)
        companions[:, np.arange(1, degree), np.arange(degree - 1)] = 1
        companions[:, :, -1] = -(powers[:-1] / powers[-1]).T
        whole = np.asarray(np.isfinite(companions).all(axis=(1, 2)))
        roots = np.full((degree, whole.size), np.nan + 0j)
        roots[:, whole] = np.linalg.eigvals(companions[whole]).T
        found: list[BodyPose] = []
        for root in roots:
            turn = np.where(np.abs(np.abs(root) - 1) <= ROUND, root / np.abs(root), np.nan)
            for start in self._starts(known, turn):
                pose, ok = self.closed(known, BodyPose(start, turn))
                for other in found:
                    apart = np.abs(other.reach - pose.reach) / self.size + np.abs(other.turn - pose.turn)
                    ok = ok & ~(apart <= np.sqrt(EPS))
                if np.any(ok) or not found:
                    found.append(BodyPose(np.where(ok, pose.reach, np.nan), np.where(ok, pose.turn, np.nan)))
        return found

    def _starts(self, known: Known, turn: Any) -> list[Any]:
        """Tell where a body may be at an angle: where two lines meet, or beside the rod on one that both are."""
        rows, starts = self._lines(known, turn), [self._height(known, turn)[1]]
        if len(rows) == 2:
            (one, first), (two, second) = rows
            merged = np.abs(cross(one, two)) <= MERGED * np.maximum(np.abs(one), np.abs(two)) ** 2
            longer = np.abs(one) >= np.abs(two)
            normal, foot = np.where(longer, one, two), np.where(longer, first, second)
            aside = np.sqrt((self.leads[0].size * np.abs(normal)) ** 2 - foot**2)
            starts += [normal * (foot + way) / np.abs(normal) ** 2 for way in (1j * aside, -1j * aside) if merged.any()]
        return starts

    def _lines(self, known: Known, turn: Any) -> list[tuple[Any, Any]]:
        """Give the lines on which the lengths put a body at an angle: the normal, and how far along it."""
        rows = []
        rod = self.leads[0].kind == ROD
        for lead, place, way in list(zip(self.leads, *known, strict=True))[rod:]:
            apart = turn * (lead.at - self.leads[0].at) - (place - known.places[0])
            if lead.kind == ROD:
                rows.append((2 * apart, lead.size**2 - self.leads[0].size ** 2 - np.abs(apart) ** 2))
            elif lead.kind == GUIDE:
                rows.append((1j * way, lead.size - dot(1j * way, apart)))
            else:
                normal = 1j * turn * lead.slot
                rows.append((normal, -lead.size - dot(normal, apart)))
        return rows

    def _height(self, known: Known, turn: Any) -> tuple[Any, Any]:
        """Tell what the lengths leave open with the body at an angle, and where they put it but for that."""
        (one, first), (two, second), *last = self._lines(known, turn)
        sine, twice = cross(one, two), 1j * (second * one - first * two)
        if not last:
            return np.abs(twice) ** 2 - (self.leads[0].size * sine) ** 2, twice / sine
        ((three, third),) = last
        pairs = ((one, first, two, second), (two, second, three, third), (three, third, one, first))
        crosses = [cross(normal, other) for normal, _, other, _ in pairs]
        over = sum(c * 1j * (b * n - a * m) for c, (n, a, m, b) in zip(crosses, pairs, strict=True))
        open_ = third * crosses[0] + first * crosses[1] + second * crosses[2]
        return open_, over / sum(sine**2 for sine in crosses)

    def locus(self, known: Known, pose: BodyPose, out: int, turns: Any) -> Any:
        """Give where a lead's hinge goes that is let go, as the body turns by some angles on the two others."""
        there = BodyPose(pose.reach, pose.turn * np.exp(1j * np.asarray(turns)))
        for _ in range(ROUNDS):
            held = self.held(known, there)
            (one, first), (two, second) = ((held.along[k], held.misses[k]) for k in range(len(self.leads)) if k != out)
            there = BodyPose(there.reach - 1j * (second * one - first * two) / cross(one, two), there.turn)
        return known.places[0] + there.reach + there.turn * (self.leads[out].at - self.leads[0].at)

    def spanned(self, known: Known, pose: BodyPose, out: int) -> float:
        """Give the length next to its own that a rod must span, as the body turns on the two others; NaN: its own."""
        fan = AROUND
        for _ in range(ROUNDS):
            with np.errstate(invalid="ignore", divide="ignore"):
                spans = np.abs(self.locus(known, pose, out, fan) - known.places[out])
            off = np.where(np.isfinite(spans), np.abs(spans - self.leads[out].size), np.inf)
            best = int(np.argmin(off))
            if best in (0, len(fan) - 1):
                return np.nan
            fan = np.linspace(fan[best - 1], fan[best + 1], len(fan))
        return float(spans[best]) if off[best] > np.sqrt(EPS) * self.size else np.nan

    def closed(self, known: Known, pose: BodyPose) -> tuple[BodyPose, Any]:
        """Close poses that are near to an assembly; tell where that is done."""
        last: Any = np.inf
        for _ in range(ROUNDS):
            pose, off = self.nearer(known, pose)
            done = ~(off > THERE)
            if np.all(done | ~(off < last)):
                break
            last = off
        return pose, np.asarray(off <= np.sqrt(EPS))

    def nearest(self, known: Known, pose: BodyPose) -> tuple[BodyPose, float]:
        """Bring a pose in one position to where the lengths are least missed, jammed or not; tell by how much, m."""
        held = self.held(known, pose)
        for _ in range(ROUNDS):
            rows = [(way.real, way.imag, arm / self.size) for way, arm in zip(held.along, held.moments, strict=True)]
            x, y, turn = np.linalg.lstsq(np.array(rows), np.array(held.misses), np.sqrt(EPS))[0]
            pose = BodyPose(pose.reach - x - 1j * y, pose.turn * np.exp(-1j * turn / self.size))
            held = self.held(known, pose)
        return pose, max(map(abs, held.misses))

    def meeting(self, known: Known, pose: BodyPose, inside: Any, pair: int) -> Meeting:
        """Meet the three lengths; `pair` is the lead that the special point of the others leaves out."""
        with np.errstate(invalid="ignore", divide="ignore"):
            found, ok = self.closed(known, pose)
            short = self.held(known, pose).short
            held = self.held(known, found)
            across, arm = held.determinant, held.arm(pair)
        ok = ok & inside
        clear = bool(np.all(ok & (across**2 > 2 * UNBORNE * np.abs(arm) ** 2)))
        if clear:
            return Meeting(found.reach, found.turn, across, (arm, 1.0), 0.0, clear)
        reach, turn = (np.where(ok, row, np.nan) for row in (found.reach, found.turn))
        begun = np.isfinite(sum(known.places) + sum(known.ways))  # else a group before fails
        miss = np.where(ok | ~begun, 0.0, np.where(np.isfinite(short), short, self.size))
        return Meeting(reach, turn, np.where(ok, across, np.where(miss > 0, 0.0, np.nan)), (arm, 1.0), miss, clear)


def _count(known: Known) -> int:
    return max(np.size(value) for row in known for value in row)
