"""Loops of a profile that crosses itself, and what is lost where they are cut away (петли профиля).

All pairs of chords are tried; the two turns are then found by Newton's method with differences in place of derivatives.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np

from plans.analytic.cam.contour import ContourValues
from plans.analytic.cam.extremes import WholeTurn
from plans.model.cam_motion import CamFlaw, Extreme, Points
from plans.model.motion import Floats

CHORDS: Final = 64  # of a piece: of crossings close together each is to be on chords of its own
ABOUT: Final = 32  # chords about what is undercut: its loop is closed within its own width to both sides
TRIES: Final = 30  # of Newton's method
DIFFERENCE: Final = 1e-6  # rad or m: the root of a rounding, and more
SEARCHES: Final = 40  # of a golden section: where a value is greatest half the digits of the place give all of it
GOLDEN: Final = (5**0.5 - 1) / 2
SWEPT: Final = 512  # places of the ray that sweeps round a loop
JOINED: Final = 1e-9  # of a chord: ends that are nearer are one
MET: Final = 1e-9  # of the turn: by how much less two points are one
LEAST: Final = 5e-6  # of the turn: a loop that is shorter is a cusp, undercut by less than 1e-9 of the radius
ROUNDING: Final = 1e-9  # of the lift: less than this is not lost
APART: Final = 1e-9  # rad or m: two crossings that are nearer are one
Pair = tuple[float, float]


@dataclass(frozen=True)
class Loops:
    """The search for loops of one profile."""

    turn: WholeTurn
    roller: float  # m

    def flaws(self) -> Iterator[CamFlaw]:
        """Give every loop with how much of S is lost on it."""
        spans = self._undercut()
        for first, second in self.crossings(spans):
            start, end = self._loop(first, second)
            yield CamFlaw("crossing", start, end, self._loss(first, start, end))

    def _undercut(self) -> list[Pair]:
        """Give the parts of the turn where the edge runs backwards."""
        found = []
        for start, end in self.turn.pieces.T.tolist():
            roots = [root for root in self.turn.roots(self._forward) if start < root < end]
            cuts = [start, *roots, end]
            middles = self._forward(self.turn.at(np.add(cuts[:-1], cuts[1:]) / 2))
            found += [pair for pair, m in zip(pairwise(cuts), middles, strict=True) if m < 0]
        return found

    def _forward(self, curve: ContourValues) -> Floats:
        if not curve.cam.flat:
            return 1 - self.roller * curve.curvature
        return np.where(curve.lead > 0, curve.radius, -1.0) if curve.cam.rocks else curve.radius

    def edge(self, turned: Floats, before: bool = False) -> Points:
        """Give the profile, mirrored where the cam turns clockwise."""
        return self.turn.at(np.asarray(turned), before).edge(-self.roller)

    def crossings(self, spans: list[Pair]) -> list[Pair]:
        """Give the pairs of turns at which the profile is at one point."""
        pieces = [self._chords(piece, spans) for piece in self.turn.pieces.T.tolist()]
        whole = np.concatenate([turned for turned, _ in pieces])
        start, way = (np.concatenate(rows) for rows in zip(*[(z[:-1], np.diff(z)) for _, z in pieces], strict=True))
        pieces_of = np.concatenate([np.full(len(z) - 1, k) for k, (_, z) in enumerate(pieces)])
        turned = np.delete(whole, np.cumsum([len(z) for _, z in pieces]) - 1)
        chord, other = self._crossed(start, way)
        found = [self._newton(turned[[i, j]], pieces_of[[i, j]]) for i, j in zip(chord, other, strict=True)]
        return _distinct(sorted(pair for pair in found if pair is not None))

    def _crossed(self, start: Points, way: Points) -> tuple[np.ndarray, np.ndarray]:
        """Give which chords cross, of all pairs that have no end in common."""
        chord, other = (k.ravel() for k in np.triu_indices(len(start), 1))
        near = _overlap(start, start + way, chord, other)
        chord, other = chord[near], other[near]
        base = start[other] - start[chord]
        sines = (np.conj(way[chord]) * way[other]).imag
        with np.errstate(divide="ignore", invalid="ignore"):
            along, back = ((np.conj(base) * way[k]).imag / sines for k in (other, chord))
        hit = (along >= 0) & (along < 1) & (back >= 0) & (back < 1)
        common = np.abs(base - way[chord]) <= JOINED * np.abs(way[chord])
        common |= np.abs(base + way[other]) <= JOINED * np.abs(way[chord])
        return chord[hit & ~common], other[hit & ~common]

    def _chords(self, piece: list[float], spans: list[Pair]) -> tuple[Floats, Points]:
        start, end = piece
        near = [np.linspace(2 * a - b, 2 * b - a, ABOUT + 1) for a, b in spans]
        inner = np.unique(np.concatenate([np.linspace(start, end, CHORDS + 1)[:-1], *near]))
        inner = inner[(inner >= start) & (inner < end)]
        last = self.edge(np.array([end]), before=True)
        return np.append(inner, end), np.append(self.edge(inner), last)

    def _newton(self, pair: Floats, piece: np.ndarray) -> Pair | None:
        """Close in on a crossing, each turn within its own piece; None about a cusp, where chords cross alone."""
        low, high = self.turn.pieces[:, piece]
        high = np.nextafter(high, low)
        for _ in range(TRIES):
            ahead, behind = np.minimum(pair + DIFFERENCE, high), np.maximum(pair - DIFFERENCE, low)
            at = self.edge(np.concatenate([pair, ahead, behind]))
            gap, (u, v) = at[0] - at[1], (at[2:4] - at[4:6]) / (ahead - behind)
            sine = (np.conj(u) * v).imag
            if sine == 0:
                break
            step = np.array([-(np.conj(gap) * v).imag, (np.conj(u) * gap).imag]) / sine
            pair = np.clip(pair + step, low, high)
        close = abs(complex(np.subtract(*self.edge(pair)))) <= MET * self.turn.cam.turn
        first, second = pair.tolist()
        least, most = LEAST * self.turn.cam.turn, (1 - LEAST) * self.turn.cam.turn
        loops = least < second - first < most or (self.turn.cam.translates and second - first >= most)
        return (first, second) if close and loops else None

    def _loop(self, first: float, second: float) -> Pair:
        """Give where the loop starts and ends: it is the part round which the radius from the crossing sweeps less.

        All stands for a cam that turns counter-clockwise, whose profile runs clockwise.
        """
        cam, corner = self.turn.cam, self.edge(np.array([first]))[0]
        parts = np.array([[first, second], [second, first + cam.turn]])
        swept = []
        for start, end in parts.tolist():
            turned = np.linspace(start, end, SWEPT)
            ray = self.edge(np.where(turned > cam.turn, turned - cam.turn, turned)) - corner
            swept.append(-float((np.conj(ray[:-1]) * ray[1:]).imag.sum()))
        return (first, second) if cam.translates or swept[0] <= swept[1] else (second, first)

    def _loss(self, crossed: float, start: float, end: float) -> Extreme:
        """Find the greatest loss of S on a loop, by a golden section about the greatest of some."""
        end += self.turn.cam.turn if end < start else 0.0
        corner = complex(self.edge(np.array([crossed]))[0])
        looks = np.linspace(start, end, 257)
        lost = self._lost(corner, looks)
        if np.isnan(lost).all():
            return Extreme(float("nan"), start)
        best = int(np.nanargmax(lost))
        low, high = looks[max(best - 1, 0)], looks[min(best + 1, 256)]
        for _ in range(SEARCHES):
            tried = np.array([high - GOLDEN * (high - low), low + GOLDEN * (high - low)])
            left, right = self._lost(corner, tried)
            low, high = (low, tried[1]) if left >= right or np.isnan(right) else (tried[0], high)
        ends = np.array([looks[best], (low + high) / 2])
        most = self._lost(corner, ends)
        at = int(np.nanargmax(most))
        if most[at] <= ROUNDING * self.turn.cam.lift:
            return Extreme(0.0, looks[0].item())
        return Extreme(float(most[at]), float(np.mod(ends[at], self.turn.cam.turn)))

    def _lost(self, corner: complex, turned: Floats) -> Floats:
        """Give S less that with which the follower rests on a corner, NaN where it cannot."""
        whole = self.turn.cam.turn
        curve = self.turn.at(np.where(turned > whole, turned - whole, turned))
        with np.errstate(invalid="ignore"):
            place = np.asarray(corner - curve.turned if curve.cam.translates else corner * np.exp(1j * curve.turned))
            rest = _rocked(curve, place, self.roller) if curve.cam.rocks else _lifted(curve, place, self.roller)
            return curve.travel.s - rest


def _lifted(curve: ContourValues, place: Points, roller: float) -> Floats:
    if curve.cam.flat:
        return np.asarray(place.imag - curve.sizes.base)
    aside = np.abs(place.real - curve.sizes.offset)
    lift = place.imag + np.sqrt((roller - aside) * (roller + aside))
    return np.asarray(lift - (curve.height - curve.travel.s))


def _rocked(curve: ContourValues, place: Points, roller: float) -> Floats:
    """Give it for a rocker: by the triangle of its pivot, its pin and the corner, or of the foot under its face."""
    cam = curve.cam
    centre, direction = curve.pivot
    way = place - centre * np.exp(1j * direction)
    size, sense = np.abs(way), cam.follower.sense
    if cam.flat:
        off = np.arcsin(cam.follower.face / size)
    else:
        around = (size - curve.length + roller) * (curve.length - size + roller)
        off = -2 * np.arctan2(np.sqrt(around), np.sqrt((size + curve.length) ** 2 - roller**2))
    theta = np.angle(way) - sense * off
    swung = theta if sense > 0 else np.pi - theta
    return np.asarray(np.mod(swung + np.pi, 2 * np.pi) - np.pi + cam.lift / 2)


def _overlap(start: Points, end: Points, chord: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Tell which pairs of chords have boxes that overlap."""
    apart = np.zeros(len(chord), dtype=bool)
    for first, last in ((start.real, end.real), (start.imag, end.imag)):
        low, high = np.minimum(first, last), np.maximum(first, last)
        apart |= (low[chord] > high[other]) | (low[other] > high[chord])
    return ~apart


def _distinct(found: list[Pair]) -> list[Pair]:
    kept: list[Pair] = []
    for pair in found:
        if not kept or abs(pair[0] - kept[-1][0]) + abs(pair[1] - kept[-1][1]) > APART:
            kept.append(pair)
    return kept
