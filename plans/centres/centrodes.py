"""Centrodes: the paths of the centre of two links on each of them, which roll on each other (центроиды).

The centre is found by Aronhold and Kennedy over the whole turn, over the same links in each position, and carried into
each link by similarity.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.board import Board, Mark
from geometry.precision import errors
from plans.centres.kennedy import CENTRES, ONE_PLACE, PARALLEL, Kennedy, Pair
from plans.linkage.plan import Plan
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import NODES
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats
from plans.scene.faults import Fault, SceneError
from plans.words.words import because

Window = tuple[complex, float]
Flags = npt.NDArray[np.bool_]

SOME = 24  # positions among which the one is sought whose lines of centres are drawn in all: the sharpest of them
SHOWN = 1.6  # sizes of the mechanism from its middle: so far centres and centrodes are shown
LEAP = 0.5  # of that way: a centre that goes so far in half a degree passes through infinity


class Centrodes(NamedTuple):
    """The centre of two links over the turn, m, (N,) each: its marks on both links, in their own axes."""

    phi: Floats  # rad, half a degree apart
    free: Flags  # whether the position is reached
    centre: Mark
    marks: dict[int, Mark]

    @property
    def allowed(self) -> dict[int, Floats]:
        """How far rounding can have moved the marks, m."""
        bounds = errors(*self.marks.values())
        return {link: bounds[mark].place for link, mark in self.marks.items()}

    @property
    def gone(self) -> Complexes:
        """What blots out the positions where its lines are parallel, or that are not reached; else 0."""
        sharpness = self.centre.sharpness
        sharp = self.free if sharpness is None else self.free & (np.asarray(sharpness) > PARALLEL)
        return np.where(sharp, 0j, np.nan + 0j)

    def path(self, link: int) -> Complexes:
        """Give the centrode of a link, in its axes."""
        return np.asarray(self.marks[link].point + self.gone)


def centrodes(linkage: LinkageStudy, asked: Sequence[Pair]) -> dict[Pair, Centrodes]:
    """Find the centrodes of pairs of links over the reached turn; a centre always at infinity is a SceneError."""
    phi = nodes(linkage)
    free = linkage.reached(phi)
    some = phi[free][:: max(int(free.sum()) // SOME, 1)]
    found = [Kennedy(linkage.sweep.plan(some[k : k + 1])) for k in range(len(some))]
    plan, made, faults = linkage.sweep.plan(phi), dict[Pair, Centrodes](), list[Fault]()
    for index, pair in enumerate(asked):
        like = max(found, key=lambda one: _sharpness(one, pair), default=None)
        if like is not None and _sharpness(like, pair) > 0:
            every = Kennedy(plan, like)
            centre = every.found[pair].mark
            made[pair] = Centrodes(phi, free, centre, {link: carried(every.board, plan, centre, link) for link in pair})
        elif any(pair in one.found for one in found):
            way = (CENTRES, "centrodes", index)
            faults.append(linkage.scene.fault(way, "centrode_translates", first=pair[0], second=pair[1]))
    if faults:
        raise SceneError(faults)
    return made


def nodes(linkage: LinkageStudy) -> Floats:
    """Give crank angles close to each other over the turn, or the stroke, rad."""
    first = float(linkage.turn.phi[0])
    last = first + 2 * np.pi if linkage.mechanism.drive.turns else float(linkage.turn.phi[-1])
    return np.linspace(first, last, NODES + 1)


def _sharpness(found: Kennedy, pair: Pair) -> float:
    """Give the least sine under which lines of centres meet for a centre of a position; 0: it is at infinity."""
    centre = found.found.get(pair)
    if centre is None or centre.infinite:
        return 0.0
    sines = (np.ravel(mark.sharpness)[0] for mark in found.board if mark.sharpness is not None)
    return float(min(sines, default=1.0))


def carried(board: Board, plan: Plan, centre: Mark, link: int) -> Mark:
    """Carry a centre into the axes of a link by similarity."""
    if link == FRAME:
        return centre
    image, name = plan.images[link], own(centre.name, link)
    assert image.arm is not None  # on the plan of positions every link has one
    reach = board.join(f"{image.origin.name}{centre.name}", image.origin, centre)
    arm = board.given(image.arm.name, image.span, because("own_vector", link=link))
    why = because("centre_carried", link=link)
    vector = board.similar(f"{image.origin.name}{name}", arm, image.arm, reach, why=why)
    origin = board.given(image.origin.name, image.at, because("own_point", link=link))
    return board.lay_off(name, origin, vector, because("centrode_point", link=link))


def own(name: str, link: int) -> str:
    """Letter a centre in the axes of a link.

    >>> own("P_02", 2)
    'P_02^2'
    """
    return f"{name}^{link}"


def plan_of(pair: Pair) -> str:
    """Name what marks of the centrodes of two links belong to."""
    return f"centrodes-{pair[0]}-{pair[1]}"


def window(points: Sequence[complex]) -> Window:
    """Give the middle and the radius of what is shown about a mechanism in a position, m."""
    size = max(abs(one - other) for one in points for other in points)
    return sum(points) / len(points), SHOWN * size


def named(path: Complexes, name: str, shown: Window) -> dict[str, Complexes]:
    """Name the pieces of a curve that are shown, each of them once: p_2, or p_2.1, p_2.2."""
    pieces = [piece for piece in _pieces(path, shown) if len(piece) > 2]
    longest = sorted(range(len(pieces)), key=lambda n: -len(pieces[n]))
    again = {n for k, n in enumerate(longest) if any(_lies_on(pieces[n], pieces[other]) for other in longest[:k])}
    found = [piece for n, piece in enumerate(pieces) if n not in again]
    return {name if len(found) == 1 else f"{name}.{n}": piece for n, piece in enumerate(found, 1)}


def _pieces(path: Complexes, shown: Window) -> list[Complexes]:
    """Part a curve at infinity, where it turns back, and after the first of two times round."""
    middle, most = shown
    path = path[np.append(True, ~(np.abs(np.diff(path)) <= ONE_PLACE * most))]
    near, steps, half = np.abs(path - middle) <= most, np.diff(path), len(path) // 2
    gaps = {*(np.flatnonzero(~(near[1:] & near[:-1] & (np.abs(steps) < LEAP * most))) + 1).tolist()}
    on = {*(np.flatnonzero((steps[1:] * steps[:-1].conj()).real < 0) + 1).tolist()} - gaps
    on |= {half} if not gaps and _lies_on(path[half:], path[: half + 1]) else set()
    return [path[one : other + (other in on)] for one, other in pairwise([0, *sorted(gaps | on), len(path)])]


def _lies_on(piece: Complexes, other: Complexes) -> bool:
    """Tell whether a piece goes where another one does: each of its places is hard by one of that."""
    off = np.abs(piece[:, None] - other[None]).min(axis=1)
    return bool(off.max() < 0.75 * np.abs(np.diff(other)).max(initial=0.0))
