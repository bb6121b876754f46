"""Margins of assembly: angles of a crank on its way, barriers that it cannot pass (запас сборки)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Arc, Line, Mark, between
from geometry.meet import UNBORNE, Vectors, cross
from plans.linkage.dyads import KINDS
from plans.linkage.plan import Plan
from plans.model.dyad import Group
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats

RUN = 40  # positions whose angles are measured from the middle one, where they are close to it
CLOSE = 1 / 64  # tangent of an angle whose series may leave out t9/9: less than a rounding


def heading(vector: Vectors, span: complex = 1 + 0j) -> Floats:
    """Give the direction of a link's own +x axis, rad in (-pi, pi], from one of its vectors that is `span` there."""
    vectors = np.asarray(vector if span.imag == 0 < span.real else vector / span)
    # The first run tells most often enough that the others are not close either.
    close = (
        vectors.size >= RUN
        and vectors.size % RUN == 0
        and abs(vectors[RUN // 2] - vectors[0]) <= CLOSE * abs(vectors[0])
    )
    found = _close(vectors.reshape(-1, RUN)) if close else None
    return _turned(vectors) if found is None else found


def _turned(vectors: Complexes) -> Floats:
    turned = np.arctan2(vectors.imag, vectors.real)
    return (
        turned
        if np.minimum.reduce(turned, None, initial=np.inf) > -np.pi
        else np.where(turned <= -np.pi, np.pi, turned)
    )


def _close(runs: Complexes) -> Floats | None:
    """Measure runs of vectors close to each other, each from the middle of its run; None where one is not close.

    An arctangent costs as much as a meeting; of a small tangent t it is t - t3/3 + t5/5 - t7/7 to the last digit.
    """
    middle = runs[:, RUN // 2, None]
    from_middle = np.conjugate(middle) * runs
    tangent = from_middle.imag / from_middle.real
    if not (np.abs(tangent).max() <= CLOSE and from_middle.real.min() > 0):
        return None
    square = tangent * tangent
    angle = square * (-1 / 7)
    for share in (1 / 5, -1 / 3):
        angle += share
        angle *= square
    angle *= tangent
    angle += tangent
    angles = _turned(middle)
    angle += angles
    if np.abs(angles).max() > np.pi - CLOSE:
        angle -= np.where(angle > np.pi, 2 * np.pi, 0.0)
        angle += np.where(angle <= -np.pi, 2 * np.pi, 0.0)
    return angle.ravel()


def angle(plan: Plan, link: int) -> Floats:
    """Read off the plan of positions the direction of a link's own +x axis, rad in (-pi, pi]."""
    if link == FRAME:
        return np.zeros(1)
    return heading(plan.arm(link).point, plan.images[link].span)


def rate(plan: Plan, link: int) -> Floats:
    """Read off a velocity or acceleration plan a link's omega rad/s or epsilon rad/s2: Im(t/AB) (0.1).

    t is the part of the plan's relative vector that is square to the link; a link that does not turn has none.
    """
    if link not in plan.readings:
        return np.zeros(1)
    reading = plan.readings[link]
    return np.imag(reading.turning.point / reading.arm.point)


SAME = 1e-6  # rad: an edge that touches is known to half the digits of an angle


class BarrierEdge(NamedTuple):
    """An edge of a barrier: its crank angle, rad, the first that is barred, and which group fails there, and how."""

    phi: float
    beyond: float
    kind: str  # "change point", "out of reach" or "parallel guides"
    group: int
    where: str  # the mark whose loci miss or touch


class Barrier(NamedTuple):
    """A part of the turn that the crank cannot pass, from one edge counter-clockwise to the other."""

    edges: tuple[BarrierEdge, BarrierEdge]
    miss: float  # m, the largest miss seen

    @property
    def start(self) -> float:
        """Where it begins, rad."""
        return self.edges[0].phi

    @property
    def end(self) -> float:
        """Where it ends, rad."""
        return self.edges[1].phi

    @property
    def kind(self) -> str:
        """What bars the crank where it begins."""
        return self.edges[0].kind

    @property
    def group(self) -> int:
        """The group that fails where it begins."""
        return self.edges[0].group

    @property
    def where(self) -> str:
        """The mark whose loci miss or touch where it begins."""
        return self.edges[0].where

    @property
    def middle(self) -> float:
        """The angle in the middle of it, rad."""
        return (self.start + self.end) / 2


def bounding(phi: float, home: float, barriers: Sequence[Barrier]) -> BarrierEdge | None:
    """Give the edge that keeps the crank from an angle, rad: of the two that bound its way from home, the nearer."""
    if not barriers:
        return None
    turn = 2 * np.pi
    ahead = min((b.edges[0] for b in barriers), key=lambda edge: float(np.mod(edge.phi - home, turn)))
    behind = min((b.edges[1] for b in barriers), key=lambda edge: float(np.mod(home - edge.phi, turn)))
    ways = [abs(float(np.angle(np.exp(1j * (phi - edge.phi))))) for edge in (ahead, behind)]
    return ahead if ways[0] <= ways[1] + SAME else behind


# Two points so much nearer to each other than their figure is large give a direction without a true digit.
NOWHERE = 8.0 * UNBORNE


def margins(plan: Plan, groups: Sequence[Group], sides: Sequence[float]) -> tuple[Floats, list[Mark]]:
    """Give every group's margin over the positions, (groups, positions): above 0 assembled, 0 dead, below 0 missing.

    A miss counts as -1: only its sign is meant. Two guides cross with the sine of their angle, signed as the group's
    side: it changes sign where they are parallel and their pin runs to infinity. NaN: a group before fails.
    """
    marks = [meeting(plan, group) for group in groups]
    count = max(np.size(mark.point) for mark in plan.letters.values())
    rows = []
    for mark, side in zip(marks, sides, strict=True):
        miss = np.broadcast_to(np.asarray(mark.miss, dtype=float), count)
        sharpness = np.broadcast_to(np.asarray(mark.sharpness, dtype=float), count)
        turned = crossing(mark)
        if turned is None:
            rows.append(np.where(miss > 0, -1.0, sharpness**2))
        else:
            rows.append(np.broadcast_to(side * turned, count))
    return np.array(rows).reshape(len(marks), count), marks


def crossing(mark: Mark) -> Floats | None:
    """Give the sine of the angle from the first of two lines to the second where they meet; None for other meetings."""
    first, second = (locus.value for locus in mark.step.inputs[:2])
    if not (mark.step.op == "meet" and isinstance(first, Line) and isinstance(second, Line)):
        return None
    turned = cross(first.direction, second.direction)
    return np.asarray(turned / (np.abs(first.direction) * np.abs(second.direction)))


def undefined(plan: Plan, groups: Sequence[Group]) -> npt.NDArray[np.bool_]:
    """Tell at which positions each group has no one place, (groups, positions): its loci miss, fall into one, ..."""
    count = max(np.size(mark.point) for mark in plan.letters.values())
    return np.array([np.broadcast_to(_nowhere(meeting(plan, group)), count) for group in groups])


def _nowhere(mark: Mark) -> npt.NDArray[np.bool_]:
    """Tell where a meeting has no place, or any: its two centres, or a pin and its slot's pivot, are one point."""
    none = np.asarray(np.isnan(np.asarray(mark.point)))
    arcs = all(isinstance(locus.value, Arc) for locus in mark.step.inputs[:2])
    if mark.step.op != "tangent" and not arcs:
        return none
    ends = mark.step.inputs if not arcs else tuple(locus.step.inputs[0] for locus in mark.step.inputs)
    away = np.maximum(*(np.abs(np.asarray(end.point)) for end in ends))
    return np.asarray(none | (np.abs(between(*ends)) <= NOWHERE * away))


def meeting(plan: Plan, group: Group) -> Mark:
    """Give the mark of a group's own meeting on the plan of positions."""
    return KINDS[group.kind].meeting(plan, group)


def of_arcs(mark: Mark) -> bool:
    """Tell whether a meeting is of an arc, which may be out of reach; two lines are not."""
    return crossing(mark) is None
