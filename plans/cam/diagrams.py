"""The diagrams of a law by the book's graphical calculus (диаграммы S'', S', S, 5.9.2, figures 5.44-5.46; M2.3, M2.4).

S'' is given; S' is drawn from it by chords, S from S' in the same way. A hard shock is an impulse of S'' that no area
shows: past it S' begins anew from what the law has there. Of a law by a table S is what is given: it is differentiated.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from geometry.board import Board
from geometry.calculus import Integral, integral
from geometry.strips import SLIVER, Departure, departure, middles, strips
from plans.cam.course import FollowerCourse, positions, settled
from plans.model.cam import SHAPE, TABLE, Cam
from plans.model.cam_motion import HARD, SOFT, FollowerTravel
from plans.model.motion import Floats
from plans.words.calculus import REASONS

SLOPE, TRAVEL = "S'", "S"
# How the mean ordinate of a strip is read: at its middle, as the book does; from three ordinates, at both ends and the
# middle, of which that counts four times; or as it truly is.
MIDDLE, THREE, TRUE = "middle", "three", "true"


@dataclass(frozen=True)
class TurnStrips:
    """The strips of a cam's turn: those of the numbered positions, with an edge on every corner of S'' (участки)."""

    course: FollowerCourse
    edges: Floats  # (n + 1,) rad

    @cached_property
    def after(self) -> FollowerTravel:
        """S, S', S'' at the edges, after what jumps there."""
        return self.course.at(self.edges)

    @cached_property
    def before(self) -> FollowerTravel:
        """S, S', S'' at the edges, before what jumps there."""
        return self.course.at(self.edges, before=True)

    @cached_property
    def hard(self) -> tuple[int, ...]:
        """The edges at which there is a hard shock, both ends of a turn if there is one between two turns."""
        return self._at(HARD)

    @cached_property
    def jumps(self) -> tuple[int, ...]:
        """The edges at which there is a shock of either kind."""
        return tuple(sorted({*self.hard, *self._at(SOFT)}))

    def _at(self, order: int) -> tuple[int, ...]:
        turned = [shock.turned for shock in self.course.shocks if shock.order == order]
        turned += [self.course.cam.turn] if 0.0 in turned and not self.course.cam.translates else []
        return tuple(np.flatnonzero(np.isin(self.edges, turned)).tolist())

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What the edges are called: numbered positions by their numbers, one between two of them 1', the end 0."""
        return tuple(_names(self.edges, self.course.cam))


def strips_of(cam: Cam) -> TurnStrips:
    """Divide the turn: each phase that moves the follower in equal strips, a dwell is one."""
    course = FollowerCourse(cam)
    edges = [np.zeros(1)]
    for phase in (phase for phase in cam.phases if phase.angle > 0):
        inside = [corner for corner in course.corners if phase.start < corner < phase.end]
        edges.append(strips(phase.start, phase.end, cam.divisions if phase.law else 1, inside)[1:])
    return TurnStrips(course, settled(np.concatenate(edges), course))


@dataclass(frozen=True)
class LawDiagrams:
    """S' and S as they are constructed: S' in runs between hard shocks, mean ordinates and all (диаграммы закона)."""

    strips: TurnStrips
    board: Board
    means: Floats  # of S'', (n,)
    runs: tuple[slice, ...]  # of strips, between hard shocks
    slopes: tuple[Integral, ...]  # S' over each run
    travel: Integral

    @cached_property
    def slope(self) -> tuple[Floats, Floats]:
        """S' at the beginning and at the end of every strip, (n,) each."""
        parts = [run.values for run in self.slopes]
        return np.concatenate([part[:-1] for part in parts]), np.concatenate([part[1:] for part in parts])

    @cached_property
    def slope_departure(self) -> Departure:
        """How far S' is from the exact one at most, at the ends of strips; a strip's number stands for its end."""
        return departure(self.slope[1], self.strips.before.slope[1:])

    @cached_property
    def travel_departure(self) -> Departure:
        """How far S is from the exact one at most, at the edges."""
        return departure(self.travel.values, self.strips.after.s)

    @property
    def closure(self) -> tuple[float, float]:
        """By how much S' and S do not come back to what they began with after the turn (невязка)."""
        strips_, (first, last) = self.strips, self.slope
        exact = strips_.before.slope[-1] - strips_.after.slope[0]
        s = self.travel.values
        return float(last[-1] - first[0] - exact), float(s[-1] - s[0] - (strips_.before.s[-1] - strips_.after.s[0]))


def law_diagrams(cam: Cam, means: str = MIDDLE) -> LawDiagrams:
    """Draw S' from S'' and S from S' by chords; a strip's mean ordinate is read at its middle, or by three, or true.

    Of a law by points S'' is straight from point to point: there the true mean ordinate is drawn in any case.

    >>> from plans.model.cam import Follower, Law, Phase
    >>> rise = Phase("rise", 3.0, 0.0, 0.0, 0.9, Law("constant acceleration"))
    >>> cam = Cam("K", 1, None, (rise,), Follower("translating", "pointed"), "force", translates=True, divisions=2)
    >>> law_diagrams(cam).slope[1].round(12).tolist(), law_diagrams(cam).travel.values.round(12).tolist()
    ([0.6, 0.0], [0.0, 0.45, 0.9])
    """
    divided = strips_of(cam)
    ordinates = np.where(_straight(divided), _true_bends(divided), _bends_by(divided, means))
    board = Board("law")
    bounds = sorted({0, *divided.hard, len(divided.edges) - 1})
    runs = tuple(slice(low, high) for low, high in pairwise(bounds))
    slopes = tuple(_slopes(board, divided, ordinates, runs))
    start = float(divided.after.s[0])
    travel = integral(board, TRAVEL, divided.edges, _slopes_by(divided, slopes, means), start=start, why=REASONS)
    return LawDiagrams(divided, board, ordinates, runs, slopes, travel)


def _bends_by(strips: TurnStrips, means: str) -> Floats:
    """Give the mean ordinates of S'' over the strips, (n,), as they are read."""
    if means == TRUE:
        return _true_bends(strips)
    middle = strips.course.at(middles(strips.edges)).bend
    return middle if means == MIDDLE else (strips.after.bend[:-1] + 4 * middle + strips.before.bend[1:]) / 6


def _slopes_by(strips: TurnStrips, slopes: tuple[Integral, ...], means: str) -> Floats:
    """Give those of S': of its chords; by three of the smooth curve, which S'' tells to bend; or the true ones."""
    width = np.diff(strips.edges)
    if means == TRUE:
        return np.asarray((strips.before.s[1:] - strips.after.s[:-1]) / width)
    chords = np.concatenate([(run.values[1:] + run.values[:-1]) / 2 for run in slopes])
    return chords if means == MIDDLE else chords + width * (strips.after.bend[:-1] - strips.before.bend[1:]) / 12


def _slopes(board: Board, strips: TurnStrips, means: Floats, runs: tuple[slice, ...]) -> Iterator[Integral]:
    for number, run in enumerate(runs, 1):
        name = SLOPE if len(runs) == 1 else f"{SLOPE}_{number}"
        edges = strips.edges[run.start : run.stop + 1]
        start = float(strips.after.slope[run.start])
        yield integral(board, name, edges, means[run], start=start, why=REASONS)


def _straight(strips: TurnStrips) -> npt.NDArray[np.bool_]:
    """Tell the strips in which S'' goes straight from point to point, (n,)."""
    at = middles(strips.edges)
    phases = [phase for phase in strips.course.cam.moving() if phase.law and phase.law.name in (TABLE, SHAPE)]
    inside = [np.zeros(len(at), dtype=bool), *((phase.start < at) & (at < phase.end) for phase in phases)]
    return np.asarray(np.any(inside, axis=0))


def _true_bends(strips: TurnStrips) -> Floats:
    """Give the mean of S'' over each strip, in which it has no impulse: what S' gains by its width."""
    return np.asarray((strips.before.slope[1:] - strips.after.slope[:-1]) / np.diff(strips.edges))


def _names(edges: Floats, cam: Cam) -> Iterator[str]:
    numbered = np.append(positions(cam), [] if cam.translates else [cam.turn])
    last = len(numbered) - 1
    near, between = SLIVER * float(np.diff(edges).min()), 0
    for edge in edges.tolist():
        k = int(np.abs(numbered - edge).argmin())
        if abs(numbered[k] - edge) <= near:
            between = 0
            yield "0" if k == last and not cam.translates else str(k)
        else:
            between += 1
            yield f"{int(np.searchsorted(numbered, edge)) - 1}" + "'" * between
