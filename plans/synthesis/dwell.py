"""A dwell linkage: the circle through places of a coupler's point, the rod to its centre, and the rocker that rests."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark, between
from geometry.meet import Vectors
from plans.model.motion import Floats
from plans.model.synthesis.design import Circle, Design
from plans.model.synthesis.positions import PATH, TIED, TOUCH, DwellTask
from plans.synthesis.centre_points import centres
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.drawn import Drawn, DrawnReading, Figure
from plans.words.words import because

STATIONS = 721  # over the turn; then closer about the largest
CLOSER = 4  # times


class Pose(NamedTuple):
    """The four-bar at one crank angle, or at many."""

    pin: Mark
    end: Mark
    point: Mark


class FourBar(NamedTuple):
    """A four-bar on a board: its pivots."""

    task: DwellTask
    board: Board
    pivot: Mark
    other: Mark

    @classmethod
    def on(cls, task: DwellTask, board: Board) -> FourBar:
        """Put its pivots on a board."""
        return cls(
            task, board, board.given("O", 0j, because("crank_pivot")), board.given("C", complex(task.lengths[3]))
        )

    def pose(self, angles: float | Floats, k: int) -> Pose:
        """Draw it by notches at crank angles rad, and K by its triangle on the coupler."""
        task, board = self.task, self.board
        l1, l2, l3, _ = task.lengths
        ray: Vectors = l1 * np.exp(1j * angles) if isinstance(angles, np.ndarray) else cmath.rect(l1, angles)
        pin = board.lay_off(f"A_{k}", self.pivot, board.given(f"OA_{k}", ray, because("crank_at")))
        arcs = board.arc(f"A_{k}:o", pin, l2), board.arc(f"C:o{k}", self.other, l3)
        end = board.meet(f"B_{k}", *arcs, 1.0 if not task.crossed else -1.0, because("notches"))
        arm = cmath.rect(task.arm / l2, task.lean)
        point = board.lay_off(f"K_{k}", pin, board.turn(f"A_{k}K_{k}", board.join(f"A_{k}B_{k}", pin, end), arm))
        return Pose(pin, end, point)


def drawn(task: DwellTask) -> tuple[DrawnReading, ...]:
    """Draw the dwell linkages of a four-bar, the rocker's pivot to either side of the rod."""
    bars = FourBar.on(task, Board(SYNTHESIS))
    poses = [bars.pose(angle, k) for k, angle in enumerate(task.stations, 1)]
    found: list[Drawn] = []
    if goes_round(task):
        near = [poses[k].point for k in (0, 2, 4)]
        for centre in centres(bars.board, "D", near, None):
            rod = bars.board.join("DK_3", centre, poses[2].point, because("circle_radius"))
            bars.board.arc("D:o", centre, abs(complex(rod.point)), because("arc_through"))
            found += [made for side in (1, -1) if (made := _resting(bars, poses, rod, side))]
    return (DrawnReading(("dwell", "output"), bars.board, tuple(found)),)


def goes_round(task: DwellTask) -> bool:
    """Try the notches with the crank at both places on the line of the pivots: they must cross."""
    tried = FourBar.on(task, Board("trial"))
    sharp = [tried.pose(angle, k).end.sharpness for k, angle in enumerate((0.0, math.pi))]
    return all(one is not None and bool(one > TOUCH) for one in sharp)


def near(task: DwellTask) -> list[complex]:
    """Give the three places of K that the circle passes through."""
    tried = FourBar.on(task, Board("trial"))
    return [complex(tried.pose(angle, k).point.point) for k, angle in enumerate(task.stations[::2])]


def following(task: DwellTask, side: int) -> tuple[float, float]:
    """Give between what lengths m a rocker follows K over the whole turn, its pivot to one side of the rod.

    With d from D to K and v from D to the pivot's side, (rod - r)^2 < |d - r v|^2 < (rod + r)^2 is linear in r.
    """
    bars = FourBar.on(task, Board("trial"))
    poses = [bars.pose(angle, k).point for k, angle in enumerate(task.stations[::2], 1)]
    (centre,) = centres(bars.board, "D", poses, None)
    ray = complex(between(centre, poses[1]))
    path = bars.pose(np.linspace(0.0, math.tau, 5 * STATIONS), 0).point.point - complex(centre.point)
    off, along = np.abs(path) ** 2 - abs(ray) ** 2, (path * np.conjugate(side * 1j * ray / abs(ray))).real
    slope = np.concatenate((2 * (abs(ray) + along), 2 * (abs(ray) - along)))  # r slope > least
    least = np.concatenate((off, -off)) / slope
    return max(0.0, float(least[slope > 0].max())), float(np.min(least[slope < 0], initial=math.inf))


def _resting(bars: FourBar, poses: list[Pose], rod: Mark, side: int) -> Drawn | None:
    """Draw the rocker square to the rod in its rest, and try it over the turn."""
    task, board, centre = bars.task, bars.board, bars.board["D"]
    arm = board.turn(f"DF:{side}", rod, 1j * side * task.output / abs(complex(rod.point)), because("square_to_rod"))
    pivot = board.lay_off("F" if side > 0 else "F'", centre, arm)
    rocker = _Resting(task, complex(centre.point), complex(pivot.point), abs(complex(rod.point)), side)
    swing = rocker.swing()
    if not swing < math.pi:
        return None
    off = rocker.largest(lambda angles: np.abs(rocker.turned(angles)), *task.dwell)
    deviation = rocker.largest(rocker.missed, *task.dwell)
    marks = {"O": bars.pivot, "C": bars.other, "D": centre, "F": pivot}
    for k, pose in enumerate(poses, 1):
        marks |= {f"A_{k}": pose.pin, f"B_{k}": pose.end, f"K_{k}": pose.point}
    sizes = dict(zip(("l_1", "l_2", "l_3", "l_4"), task.lengths, strict=True))
    sizes |= {"l_5": abs(complex(rod.point)), "l_6": abs(complex(arm.point)), "ψ": swing, "ψ_d": off, "h": deviation}
    places = {name: complex(mark.point) for name, mark in marks.items()}
    path = {"K": np.asarray(rocker.point(np.linspace(0.0, math.tau, PATH)))}
    circles = {"D": Circle(places["D"], sizes["l_5"])}
    design = Design(sizes, places, circles, merit=round(swing, TIED), curves=path)
    arms = {"ψ": task.output, "ψ_d": task.output}
    return Drawn(design, {"l_5": rod}, arms, _figure())


def _figure() -> Figure:
    first, last = (("O", f"A_{k}", f"B_{k}", "C") for k in (3, 1))
    plate = ("A_3", "K_3", "B_3")
    chains = plate, ("K_3", "D", "F"), last, ("O", "A_5", "B_5", "C")
    lines = tuple(("D", f"K_{k}") for k in (1, 5))
    hinges = frozenset(("O", "C", "A_3", "B_3", "K_3", "D", "F"))
    lengths = ("l_5", "D", "K_3"), ("l_6", "D", "F")
    return Figure(first, chains, lines, (), hinges, frozenset("OCF"), lengths=lengths)


class _Resting(NamedTuple):
    """A rocker that rests: tried at many crank angles by notches, on boards of their own."""

    task: DwellTask
    centre: complex
    pivot: complex
    rod: float
    side: int

    def point(self, angles: Floats) -> Vectors:
        """Give the places of K."""
        return FourBar.on(self.task, Board("trial")).pose(angles, 0).point.point

    def missed(self, angles: Floats) -> Floats:
        """Give how far K is off the circle, m."""
        return np.asarray(np.abs(np.abs(self.point(angles) - self.centre) - self.rod))

    def turned(self, angles: Floats) -> Floats:
        """Give how far the rocker is turned from its rest, rad; not a number where it cannot follow."""
        board = Board("trial")
        drawn = FourBar.on(self.task, board)
        point, pivot = drawn.pose(angles, 0).point, board.given("F", self.pivot)
        arcs = board.arc("K:o", point, self.rod), board.arc("F:o", pivot, self.task.output)
        end = board.meet("D", *arcs, float(self.side))
        return np.asarray(np.angle(np.asarray(between(pivot, end)) / (self.centre - self.pivot)))

    def swing(self) -> float:
        """Give how far it swings over the turn, rad."""
        ahead = self.largest(self.turned, 0.0, math.tau)
        return ahead + self.largest(lambda angles: -self.turned(angles), 0.0, math.tau)

    def largest(self, value: Callable[[Floats], Floats], begin: float, end: float) -> float:
        """Look for the largest value: the way is divided, then again about the best place, and so on."""
        found = -math.inf
        for _ in range(CLOSER):
            places = np.linspace(begin, end, STATIONS)
            values = value(places)
            k = int(np.argmax(values))  # of what is not a number the first
            found = max(found, float(values[k])) if values[k] == values[k] else math.nan
            begin, end = places[max(k - 1, 0)], places[min(k + 1, STATIONS - 1)]
        return found
