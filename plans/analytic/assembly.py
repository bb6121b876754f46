"""Assembling the mechanism as its sketch shows it (сборка механизма).

Block after block of the equations is solved from rough poses turned in all quarters; of the two ways in which a block
can be assembled, told apart by the sign of its determinant, the one nearer to the sketch is taken.
"""

from collections.abc import Sequence
from itertools import permutations, product
from typing import NamedTuple

import numpy as np

from plans.analytic.blocks import Block, Guess
from plans.analytic.closure import EPS, Flags, close, closed, far, inverses, reciprocal_condition, settle, solutions
from plans.analytic.ends import Halt
from plans.analytic.points import TURN, Constraints, Indices, X, Y
from plans.model.mechanism import Drive, Mechanism
from plans.model.motion import (
    BEYOND_CHANGE_POINT,
    CHANGE_POINT,
    DEAD_CENTRE,
    FORCES,
    INDETERMINATE,
    NOT_REACHABLE,
    OUT_OF_REACH,
    PARALLEL_GUIDES,
    Complexes,
    Floats,
    Gap,
)
from plans.words.words import message

ADVICE = {
    reason: message(f"analysis.{key}")
    for reason, key in (
        (OUT_OF_REACH, "out_of_reach"),
        (DEAD_CENTRE, "dead_centre"),
        (PARALLEL_GUIDES, "parallel"),
        (CHANGE_POINT, "change_point"),
        (BEYOND_CHANGE_POINT, "beyond"),
        (NOT_REACHABLE, "not_reachable"),
        (INDETERMINATE, "indeterminate"),
    )
}
# What the end of the march is, by why it ended.
WHAT = {DEAD_CENTRE: "rank", CHANGE_POINT: "rank", PARALLEL_GUIDES: "infinity", NOT_REACHABLE: "way"}
UNASSEMBLED, FAINT, UNBALANCED = (message(f"analysis.{key}") for key in ("unassembled", "faint", "unbalanced"))


def gap(position: int, phi: float, plan: str, reason: str, end: Halt | None, drive: Drive) -> Gap:
    """Word the gap of one position of a drive, phi in rad or in units of its slide."""
    where = UNASSEMBLED if reason == OUT_OF_REACH else FAINT
    if end and drive.pushed:
        way = round(1000 * drive.unit * end.singular, 4)
        where = message(f"analysis.{WHAT[end.reason]}_way", way=f"{way:g}")
    elif end:
        angle = round(np.degrees(end.singular), 4) % 360.0
        where = message(f"analysis.{WHAT[end.reason]}", angle=f"{angle:g}")
    return Gap(position, phi, plan, reason, where, 0.0, ADVICE[reason])


def unbalanced(position: int, phi: float, reason: str) -> Gap:
    """Word the gap of a position whose reactions grow beyond all bounds, or are not told by equilibrium; phi in rad."""
    return Gap(position, phi, FORCES, reason, UNBALANCED, 0.0, ADVICE[reason])


QUARTERS = np.pi / 2 * np.array([0.0, 1.0, -1.0, 2.0])
COARSE = 24  # crank angles among many that are solved from rough poses; the others are from their neighbours
ROUGH = 3  # of these every third for a dyad, where the others follow from their neighbours
DYAD = 2  # links
PROBES = 720  # crank angles without an assembly beside them that are tried from rough poses; of triads COARSE
BOTH = np.array([1.0, -1.0])  # signs of a determinant
# Positions that fit a sketch as well as the best but for this share fit it alike: a symmetric mechanism has two, and
# rounding must not choose between them.
ALIKE = 1e-9
# Sizes of the mechanism: a pin farther away is where guides are parallel but for rounding.
INFINITE = 1.0 / (1000.0 * EPS)


class ClosedPosition(NamedTuple):
    """A closed position: crank angle rad and poses (links, 3) in the units of the constraints."""

    phi: float
    poses: Floats


class Closure(NamedTuple):
    """A mechanism with its equations in blocks, and its rough poses (links, 3)."""

    mechanism: Mechanism
    constraints: Constraints
    blocks: tuple[Block, ...]

    def rough(self, phi: float) -> Floats:
        """Guess the poses at a crank angle."""
        return Guess(self.mechanism, phi).poses(self.constraints)

    def misfits(self, poses: Floats, links: Sequence[int]) -> Floats:
        """Give the squared distances of the sketched points of some links from the sketch, summed, (N,)."""
        constraints, total = self.constraints, np.zeros(len(poses))
        for point, shown in self.mechanism.sketch.items():
            owners = [k for k in links if point in self.mechanism.links[constraints.numbers[k]].points]
            for k in owners[:1]:
                local = self.mechanism.links[constraints.numbers[k]].points[point]
                total += np.abs(_at(poses[:, k], local / constraints.size) - shown / constraints.size) ** 2
        return total

    def behind(self, poses: Floats, links: Sequence[int]) -> Floats:
        """Count the stones of some links that lie behind the points of the links whose slots they are in, (N,)."""
        every, total = self.mechanism.links, np.zeros(len(poses))
        of = {self.constraints.numbers[k]: poses[:, k] for k in links}
        for slide in self.mechanism.slides:
            if slide.owner in of and slide.slider in of:
                pin = next(iter(every[slide.owner].points.values()))
                stone = _at(of[slide.slider], slide.on_slider.through / self.constraints.size)
                way = slide.on_owner.direction * np.exp(1j * of[slide.owner][:, TURN])
                total += ((stone - _at(of[slide.owner], pin / self.constraints.size)) * way.conj()).real < 0.0
        return total

    def whole_misfits(self, poses: Floats) -> Floats:
        """Sum up the misfits of all blocks but the crank's; a point that two blocks share counts in both."""
        moved = [block.links.tolist() for block in self.blocks if self.constraints.crank not in block.links]
        return np.asarray(sum((self.misfits(poses, links) for links in moved), np.zeros(len(poses))))


def _at(poses: Floats, local: complex) -> Complexes:
    x, y, turn = poses.T
    return np.asarray(x + 1j * y + local * np.exp(1j * turn))


def home(shape: Closure, first: float | None, looks: Floats) -> ClosedPosition | None:
    """Assemble at the first crank angle; where that is unknown or cannot be, at the one that fits the sketch best.

    None if the links can be joined at none of the angles `looks`, rad.
    """
    if never(shape.mechanism):
        return None
    for phi in ([] if first is None else [np.array([first])]) + [looks]:
        poses = assemblies(shape, phi)
        misfits = np.where(far(poses) < INFINITE, shape.whole_misfits(poses), np.nan)
        if np.isfinite(misfits).any():
            best = int(np.argmax(misfits <= np.nanmin(misfits) * (1.0 + ALIKE)))
            return ClosedPosition(float(phi[best]), poses[best])
    return None


def never(mechanism: Mechanism) -> bool:
    """Tell whether two points are kept farther apart than the links between them reach, whatever the drive does."""
    links, every = mechanism.links, sorted({point for link in mechanism.links.values() for point in link.points})
    least = np.zeros((len(every), len(every)))
    most = np.where(np.eye(len(every)), 0.0, np.inf)
    for link in links.values():
        for (first, own), (second, other) in permutations(link.points.items(), 2):
            pair = every.index(first), every.index(second)
            least[pair] = most[pair] = abs(own - other)
    for slide in mechanism.slides:
        ends = (links[slide.slider], slide.on_slider), (links[slide.owner], slide.on_owner)
        left = [{p: ((at - way.through) / way.direction).imag for p, at in link.points.items()} for link, way in ends]
        for first, second in product(*left):
            pair = every.index(first), every.index(second)
            least[pair] = max(least[pair], abs(left[0][first] - left[1][second]))
    for by in range(len(every)):
        most = np.minimum(most, most[:, by, None] + most[by])
    return bool((most < least * (1.0 - ALIKE)).any())


def assemblies(shape: Closure, phi: Floats, signs: Floats | None = None) -> Floats:
    """Assemble at crank angles rad, (N,): poses (N, links, 3), NaN where the links cannot be joined.

    The sketch chooses, or the `signs` of the blocks' determinants where they are given.
    """
    poses = np.repeat(shape.rough(float(phi[0]))[None], len(phi), axis=0)
    for place, block in enumerate(shape.blocks):
        there = np.flatnonzero(np.isfinite(poses).all(axis=(1, 2)))
        found = np.full((len(BOTH), *poses.shape), np.nan)
        if there.size:
            found[:, there] = _both(shape, block, poses[there], phi[there])
        if signs is None:
            poses = _nearer(shape, block, found, poses)
        else:
            poses = found[int(signs[place] < 0.0)]
            if block.linear:  # of either sign, as the guides cross
                poses = np.where(np.isnan(found[0]), found[1], found[0])
    return poses


def signs_of(blocks: Sequence[Block], jacobian: Floats) -> Floats:
    """Give the signs of the blocks' determinants at one position."""
    return np.array([np.sign(np.linalg.det(block.of(jacobian[None]))[0]) for block in blocks])


def _nearer(shape: Closure, block: Block, found: Floats, rough: Floats) -> Floats:
    """Take at each angle that of two assemblies of a block which is nearer to the sketch.

    Where the sketch is silent, the one whose slots run from their links' points through their stones, then the one
    whose links are turned less from their rough poses.
    """
    misfits = np.array([shape.misfits(poses, block.links.tolist()) for poses in found])
    turned = 1.0 - np.cos(found[:, :, block.links, TURN] - rough[None, :, block.links, TURN])
    behind = np.array([shape.behind(poses, block.links.tolist()) for poses in found])
    silent = np.abs(misfits[1] - misfits[0]) <= ALIKE * misfits[0]
    grade = np.where(silent, np.where(behind[0] != behind[1], behind, turned.sum(axis=2)), misfits)
    grade[np.isnan(found).any(axis=(2, 3))] = np.inf
    return np.asarray(np.where((grade[1] < grade[0])[:, None, None], found[1], found[0]))


def _both(shape: Closure, block: Block, poses: Floats, phi: Floats) -> Floats:
    """Solve a block at N crank angles: assemblies of determinants above and below zero, (2, N, links, 3)."""
    if block.linear:
        return _straight(shape, block, poses, phi)
    found = np.full((len(BOTH), *poses.shape), np.nan)
    step = coarse = max(1, len(phi) // COARSE)
    done = np.arange(0, len(phi), step)
    _at_coarse(shape, block, found, done, poses, phi)
    while step > 1:
        step = max(1, step // 4)
        here = np.flatnonzero(np.isin(np.arange(0, len(phi), step), done, invert=True)) * step
        _from_next(shape, block, found, here, done, poses, phi)
        done = np.sort(np.concatenate((done, here)))
    lost = np.asarray(np.isnan(found[:, :, 0, 0]).all(axis=0))
    lost[::coarse] = False
    _probe(shape, block, found, np.flatnonzero(lost), poses, phi)
    return found


def _at_coarse(shape: Closure, block: Block, found: Floats, done: Indices, poses: Floats, phi: Floats) -> None:
    """Solve a block at coarse angles from rough poses; a dyad, which has but two assemblies, goes on from both."""
    rough = done[::ROUGH] if len(block.links) == DYAD else done
    found[:, rough] = _from_rough(shape, block, poses[rough], phi[rough])
    others = np.setdiff1d(done, rough, assume_unique=True)
    if others.size:
        _from_next(shape, block, found, others, rough, poses, phi)
        lacking = others[np.isnan(found[:, others, 0, 0]).any(axis=0)]
        if lacking.size:
            found[:, lacking] = _from_rough(shape, block, poses[lacking], phi[lacking])


def _probe(shape: Closure, block: Block, found: Floats, lost: Indices, poses: Floats, phi: Floats) -> None:
    """Try crank angles without an assembly beside them from rough poses: an arc of the crank may begin there."""
    every = -(-lost.size // (PROBES if len(block.links) <= DYAD else COARSE)) or 1
    probes = lost[::every]
    if probes.size:
        found[:, probes] = _from_rough(shape, block, poses[probes], phi[probes])
        _from_next(shape, block, found, lost[np.arange(lost.size) % every > 0], probes, poses, phi)


def _from_next(
    shape: Closure, block: Block, found: Floats, here: Indices, done: Indices, poses: Floats, phi: Floats
) -> None:
    """Solve a block at some crank angles from its assemblies at the next ones that are done."""
    near = done[np.minimum(np.searchsorted(done, here), len(done) - 1)]
    found[:, here] = _from_others(shape, block, found[:, near], poses[here], phi[here])


def _straight(shape: Closure, block: Block, poses: Floats, phi: Floats) -> Floats:
    """Solve a linear block from rough poses: the first step finds the turns, the next the places."""
    there = _brought(block, poses)
    for _ in range(2):
        at = block.equations.place(there)
        step = solutions(block.equations.jacobian(at), block.equations.residual(at, phi))
        there = block.equations.moved(there, -step)
    there, reached = close(block.equations, there, phi)
    return _by_sign(shape, block, there[None], reached[None])


def _from_rough(shape: Closure, block: Block, poses: Floats, phi: Floats) -> Floats:
    """Solve a block from rough poses, with each of its links turned in all quarters."""
    turns = np.array(list(product(QUARTERS, repeat=len(block.links))))
    starts = np.repeat(_brought(block, poses)[None], len(turns), axis=0)
    starts[:, :, block.links, TURN] += turns[:, None, :]
    size = starts.shape
    angles = np.tile(phi, len(turns))
    there, reached = settle(block.equations, starts.reshape(-1, *size[2:]), angles)
    # At a singular position Newton's method is slow, but the joints are closed all the same.
    reached |= closed(block.equations, there, angles)
    return _by_sign(shape, block, there.reshape(size), reached.reshape(size[:2]))


def _brought(block: Block, poses: Floats) -> Floats:
    """Bring a block's rough poses to where its hinges with other links are: these may be far from their sketch."""
    equations, there = block.equations, poses.copy()
    apart = equations.place(poses).apart
    inside = np.isin(equations.links[:, : equations.hinges], block.links)
    ways = [(-1.0 if mine else 1.0) * apart[:, k] for k, (mine, theirs) in enumerate(inside.T) if mine != theirs]
    if ways:
        way = np.mean(ways, axis=0)
        there[:, block.links, X] += way.real[:, None]
        there[:, block.links, Y] += way.imag[:, None]
    return there


def _from_others(shape: Closure, block: Block, near: Floats, poses: Floats, phi: Floats) -> Floats:
    """Solve a block from its assemblies at crank angles close by, (2, N, links, 3)."""
    starts = np.repeat(poses[None], len(near), axis=0)
    starts[:, :, block.links] = near[:, :, block.links]
    known = np.isfinite(starts).all(axis=(2, 3))
    reached = np.zeros(known.shape, dtype=bool)
    angles = np.broadcast_to(phi, known.shape)
    starts[known], reached[known] = close(block.equations, starts[known], angles[known])
    return _by_sign(shape, block, starts, reached)


def _by_sign(shape: Closure, block: Block, tried: Floats, reached: Flags) -> Floats:
    """Sort what was tried at N angles, (tries, N, links, 3), by the sign of the determinant.

    Of a dyad there is one assembly of each sign; of larger groups the one nearest to the sketch is taken.
    """
    flat = tried.reshape(-1, *tried.shape[2:])
    jacobian = block.equations.jacobian(block.equations.place(flat[reached.ravel()]))
    det, sharp = np.zeros(reached.shape), np.full(reached.shape, -1.0)
    det[reached] = np.linalg.det(jacobian)
    sharp[reached] = reciprocal_condition(jacobian, inverses(jacobian))
    if len(block.links) > DYAD:
        sharp[reached] /= ALIKE + shape.misfits(flat[reached.ravel()], block.links.tolist())
    found = np.full((len(BOTH), *tried.shape[1:]), np.nan)
    each: Indices = np.arange(tried.shape[1])
    for row, sign in zip(found, BOTH, strict=True):
        grade = np.where(np.where(det >= 0.0, 1.0, -1.0) == sign, sharp, -1.0)
        best = np.argmax(grade, axis=0)
        known = grade[best, each] >= 0.0
        row[known] = tried[best, each][known]
    return found
