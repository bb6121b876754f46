"""A cam by the analysis, as its figures show it: the law by chords, the diagram of the sizes, the profile (кулачок)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.checks.hold import bows
from plans.analytic.cam.contour import contour
from plans.analytic.cam.laws import travel
from plans.analytic.cam.stretches import stretches
from plans.cam.quantities import ComparedCam
from plans.cam.study import CamDrawing
from plans.model.cam import RETURN, RISE, Cam
from plans.model.cam_motion import HARD, SOFT, CamFound, CamSizes, Contour, FollowerTravel
from plans.model.motion import Complexes, Floats

ACCELERATION, VELOCITY, TRAVEL = "acceleration", "velocity", "travel"
EQUAL = 1e-9  # of a turn: what is so near to an edge is on it
DENSE, ROUNDS = 721, 6  # turns at which a curve is known; so often they are halved where its chords are off
LOOPED = ("undercut", "crossing", "concave", "sharp", "hollow")  # flaws of a shape that no follower can go along
CUSP = 100.0  # tolerances
ROUND = 65  # places of such a corner
Course = Callable[[Floats], Floats]


def law_named(cam: Cam, key: str) -> str:
    """Name a row of the diagrams of a cam's law."""
    return f"law-{cam.name}-{key}"


class LawCourse(NamedTuple):
    """A row of the law's diagrams: its values at the edges after and before a jump, and its curve at any turns."""

    key: str
    after: Floats  # (n + 1,)
    before: Floats
    curve: Course


@dataclass(frozen=True)
class CamValues:
    """One cam by the analysis; of the construction only where its strips end and which of equal extremes it names."""

    found: CamFound
    drawing: CamDrawing

    @property
    def cam(self) -> Cam:
        """The cam as it is asked for."""
        return self.found.cam

    @property
    def sizes(self) -> CamSizes:
        """Its main sizes."""
        return self.found.sizes

    @property
    def contour(self) -> Contour:
        """The profile at the numbered positions."""
        return self.found.contour

    def ways(self, directions: Complexes | complex, turned: Floats | float) -> Complexes:
        """Turn directions of the frame against the motion of the cam."""
        sense = 0 if self.cam.translates else self.cam.sense
        return np.asarray(directions * np.exp(-1j * sense * np.asarray(turned)))

    def at(self, turned: Floats, before: bool = False) -> Contour:
        """Give the profile at turns of the cam."""
        return contour(self.cam, self.sizes, self.found.roller, turned, before)

    @cached_property
    def compared(self) -> ComparedCam:
        """Both roads of the cam."""
        return ComparedCam(self.drawing, self.found)

    @cached_property
    def edges(self) -> Floats:
        """The edges of the strips of the law's diagrams, rad."""
        return self.drawing.diagrams.strips.edges

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What the edges are called: numbered positions by their numbers, others by the one before with primes."""
        numbered, last = self.contour.turned.tolist(), self.cam.turn
        names: list[str] = []
        for edge in self.edges.tolist():
            k = int(np.abs(self.contour.turned - edge).argmin())
            if math.isclose(edge, last, rel_tol=EQUAL) and not self.cam.translates:
                names.append("0")
            elif math.isclose(edge, numbered[k], rel_tol=EQUAL, abs_tol=EQUAL * last):
                names.append(str(k))
            else:
                before = sum(turn < edge for turn in numbered) - 1
                names.append(f"{before}" + "'" * (1 + sum(name.startswith(f"{before}'") for name in names)))
        return tuple(names)

    @cached_property
    def after(self) -> FollowerTravel:
        """S, S', S'' at the edges, after what jumps there."""
        return travel(self.cam, self.edges)

    @cached_property
    def before(self) -> FollowerTravel:
        """S, S', S'' at the edges, before what jumps there."""
        return travel(self.cam, self.edges, before=True)

    @cached_property
    def rows(self) -> Mapping[str, LawCourse]:
        """The diagrams of the law by their names: S'' exactly, S' and S as their chords find them."""
        (slope, s), gains = self.compared.chords, self.compared.gains
        begin, bends = slope - gains, (self.after.bend[:-1], self.before.bend[1:])
        first = LawCourse(ACCELERATION, *self._sides(*bends, HARD, SOFT), lambda at: travel(self.cam, at).bend)
        second = LawCourse(VELOCITY, *self._sides(begin, slope, HARD), self._cubics((begin, slope), bends))
        third = LawCourse(TRAVEL, s, s, self._cubics((s[:-1], s[1:]), (begin, slope)))
        return {row.key: self._ended(row) for row in (first, second, third)}

    def means(self, key: str) -> Floats:
        """Give the mean ordinates of the strips, (n,): of S'', or of S'."""
        over = self.compared.gains if key == ACCELERATION else np.diff(self.compared.chords[1])
        return np.asarray(over / np.diff(self.edges))

    def _sides(self, begin: Floats, end: Floats, *orders: int) -> tuple[Floats, Floats]:
        """Give values after and before the edges; at a shock at its ends a cam that turns goes on from the other."""
        after, before = np.append(begin, end[-1]), np.append(begin[:1], end)
        turned = [shock.turned / self.cam.turn for shock in self.found.shocks if shock.order in orders]
        if any(share <= EQUAL for share in turned):
            before[0] = 0.0 if self.cam.translates else end[-1]
        if self.cam.translates and any(share >= 1 - EQUAL for share in turned):
            after[-1] = 0.0
        return after, before

    def _ended(self, row: LawCourse) -> LawCourse:
        """Let a curve come from what is before the turn, and go on to what is after it."""

        def curve(turned: Floats) -> Floats:
            values = np.where(turned >= self.cam.turn, row.after[-1], row.curve(turned))
            return np.where(turned <= 0.0, row.before[0], values)

        return row._replace(curve=curve)

    def _cubics(self, ends: tuple[Floats, Floats], slopes: tuple[Floats, Floats]) -> Course:
        """Give a course of cubics by Hermite, through ends with slopes, a strip each."""
        edges, (first, last), (leaving, coming) = self.edges, ends, slopes

        def at(turned: Floats) -> Floats:
            k = np.clip(np.searchsorted(edges, turned, "right") - 1, 0, len(first) - 1)
            wide = edges[k + 1] - edges[k]
            t = (turned - edges[k]) / wide
            through = (1 + 2 * t) * (1 - t) ** 2 * first[k] + t**2 * (3 - 2 * t) * last[k]
            return np.asarray(through + wide * (t * (1 - t) ** 2 * leaving[k] - t**2 * (1 - t) * coming[k]))

        return at

    @property
    def zero(self) -> complex:
        """The origin of the diagram of the sizes, A or O1, seen from O, m."""
        if self.cam.rocks:
            return self.sizes.pivot
        return 1j * self.sizes.base if self.cam.flat else self.lowest

    @property
    def turned_back(self) -> complex:
        """What turns a rocker back from where it stands at the start to S = 0; a cam may begin at its top."""
        return cmath.rect(1.0, -self.cam.rising * float(self.contour.travel.s[0]))

    @property
    def lowest(self) -> complex:
        """Where the tip is at S = 0, seen from O, m."""
        start, pivot = complex(self.contour.tip[0]), self.sizes.pivot
        if self.cam.rocks:
            return pivot + (start - pivot) * self.turned_back
        return complex(start - 1j * self.contour.travel.s[0])

    def ends(self, contour: Contour) -> Complexes:
        """Give D of the diagram of the sizes: on the line of OD, of a flat face S'' across from S."""
        if self.cam.flat:
            return np.asarray(contour.travel.bend + 1j * contour.travel.s)
        return np.asarray(contour.lever - self.zero)

    @cached_property
    def diagram(self) -> Complexes:
        """The diagram of the sizes densely, m, from its origin."""
        shares = np.clip(np.linspace(0.0, 1.0, DENSE), EQUAL, 1 - EQUAL)  # within what jumps at both ends
        turns = (
            stretch.phase.start + stretch.phase.angle * (stretch.start + (stretch.end - stretch.start) * shares)
            for stretch in stretches(self.cam, (RISE, RETURN))
        )
        return np.concatenate([self.ends(self.at(turned)) for turned in turns])

    def points(self) -> Mapping[str, Complexes]:
        """Give the points of the numbered positions by their letters, (N,) m, in the cam; K and O_1 as they are due."""
        cam, contour = self.cam, self.contour
        division = cam.sense * self.sizes.offset + 1j * contour.tip.imag if cam.flat else contour.tip
        pivots = self.ways(np.full(len(contour.turned), self.sizes.pivot), contour.turned)
        return {"P" if self.found.roller > 0 else "Q": contour.pitch, "K": np.asarray(division), "O_1": pivots}

    def normals(self) -> Mapping[str, Complexes]:
        """Give what leads from the roller's centre to the profile, (N,) m; a follower without a roller has none."""
        return {"Q": np.asarray(self.contour.profile - self.contour.pitch)} if self.found.roller > 0 else {}

    @property
    def drawn(self) -> float:
        """How far the pieces of a drawn curve may lie from it, m; past a cusp of a loop they go farther than at it."""
        looped = any(flaw.kind in LOOPED for flaw in self.found.flaws)
        return self.cam.tolerance * (CUSP if looped else 1.0)

    def curves(self) -> Iterator[tuple[str, Complexes]]:
        """Give the curves of the cam densely by their names, m: the working profile, the pitch curve, a groove's side.

        Where the law has a corner the roller turns about its place from one side of it to the other.
        """
        rolls = self.found.roller > 0
        shown = ("profile", "pitch", "outer") if rolls else ("profile",)
        stretches = self._stretches
        for name in shown if self.contour.outer is not None else shown[:2]:
            parts = [np.append(getattr(contour, name)[:-1], getattr(end, name)) for contour, end in stretches]
            parts += [] if self.cam.translates else [parts[0][:1]]
            corners = [complex(end.pitch[0]) for _, end in stretches]
            turned = [_corner(*pair, at) for pair, at in zip(pairwise(parts), corners, strict=False) if rolls]
            turned += [np.zeros(0, dtype=complex)] * (len(parts) - len(turned))
            yield name, np.concatenate([part for pair in zip(parts, turned, strict=True) for part in pair])

    @cached_property
    def _stretches(self) -> list[tuple[Contour, Contour]]:
        """The contour between shocks, each stretch with its end again, before what jumps there."""
        found, bounds = [], sorted({0.0, *(shock.turned for shock in self.found.shocks), self.cam.turn})
        for start, end in pairwise(bounds):
            turned = np.linspace(start, end, max(int(DENSE * (end - start) / self.cam.turn), 3))
            for _ in range(ROUNDS):
                contour = self.at(turned)
                curves = (contour.profile, contour.pitch, contour.profile if contour.outer is None else contour.outer)
                wide = np.max([bows(curve) for curve in curves], axis=0) > self.cam.tolerance
                if not wide.any():
                    break
                turned = np.sort(np.append(turned, ((turned[:-1] + turned[1:]) / 2)[wide]))
            else:
                contour = self.at(turned)
            found.append((contour, self.at(turned[-1:], True)))
        return found


def _corner(before: Complexes, after: Complexes, at: complex) -> Complexes:
    """Give the arc about a place from the end of one stretch to the beginning of the next."""
    way = complex(before[-1]) - at
    sweep = cmath.phase((complex(after[0]) - at) / way) if way else 0.0
    return np.asarray(at + way * np.exp(1j * sweep * np.linspace(0.0, 1.0, ROUND)))
