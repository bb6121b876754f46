"""Closing the loops: Newton's method for all joints at once, and the transfer functions of the closed poses.

Every function works on N positions together; poses are those of `constraints`.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from plans.analytic.points import TURN, Constraints
from plans.model.motion import Floats

Flags = npt.NDArray[np.bool_]

EPS = float(np.finfo(np.float64).eps)
# Newton squares the error: a correction of sqrt(eps) leaves eps. And at a Jacobian whose smallest singular value is
# sqrt(eps), a pose is known to eps / sqrt(eps), so that the velocity found from it has no true digit left.
SQRT_EPS = EPS**0.5
# A rounding of the crank angle moves the reactions near a dead centre by eps over the square of the sharpness: less
# sharp than this leaves not a quarter of their digits true, and it is for the forces too that a position is given up.
BLUNT = EPS**0.375
NEWTON_ROUNDS = 12  # from one true digit four rounds make sixteen; the rest is for slow beginnings
DAMPED_ROUNDS = 60
NEAR = 0.1  # of the mechanism's size: where misses no faster fall than to this, no assembly is near
HALVINGS = 8
ROUNDINGS = 64.0  # of the farthest coordinate: what a dozen products and sums leave of a joint that is closed


def solutions(matrices: Floats, right: Floats) -> Floats:
    """Solve N linear systems (N, k, k), (N, k); NaN where a matrix is exactly singular."""
    try:
        return np.asarray(np.linalg.solve(matrices, right[..., None])[..., 0])
    except np.linalg.LinAlgError:
        det = np.linalg.det(matrices)
        regular = np.isfinite(det) & (det != 0.0)
        found = np.full_like(right, np.nan)
        found[regular] = np.linalg.solve(matrices[regular], right[regular][..., None])[..., 0]
        return found


def inverses(matrices: Floats) -> Floats:
    """Invert N matrices (N, k, k); zero where a matrix is exactly singular."""
    try:
        return np.asarray(np.linalg.inv(matrices))
    except np.linalg.LinAlgError:
        det = np.linalg.det(matrices)
        regular = np.isfinite(det) & (det != 0.0)
        found = np.zeros_like(matrices)
        found[regular] = np.linalg.inv(matrices[regular])
        return found


def reciprocal_condition(matrices: Floats, inverse: Floats) -> Floats:
    """Give the reciprocal condition (Frobenius) of N matrices with columns of unit length; 0 where one is singular."""
    lengths = np.sqrt((matrices**2).sum(axis=1))
    norms = np.sqrt(((lengths[:, :, None] * inverse) ** 2).sum(axis=(1, 2)))
    sharp = np.zeros(len(norms))
    np.divide(1.0, np.sqrt(lengths.shape[1]) * norms, out=sharp, where=norms != 0.0)
    return sharp


def rank_loss(jacobian: Floats) -> tuple[float, bool]:
    """Tell how faint the smallest singular value of a Jacobian is beside its largest, and whether the drive is in it.

    The rank loss puts a condition on the right sides. The share of the drive in it is of order 1 at a dead centre,
    where the crank cannot move; at a change point it is as faint as the singular value itself.
    """
    left, values, _ = np.linalg.svd(jacobian / np.sqrt((jacobian**2).sum(axis=0)))
    faint = float(values[-1] / values[0])
    return faint, bool(abs(left[-1, -1]) > np.sqrt(faint))


def as_poses(columns: Floats) -> Floats:
    """Give rows of unknowns (N, 3 n) the shape of poses, (N, links, 3), with the frame at rest."""
    still = np.zeros((len(columns), 1, 3))
    return np.concatenate((still, columns.reshape(len(columns), columns.shape[1] // 3, 3)), axis=1)


def close(constraints: Constraints, poses: Floats, phi: Floats, tolerance: float = EPS) -> tuple[Floats, Flags]:
    """Close near-closed poses to rounding level; tell for each position whether Newton's method got there.

    A `tolerance` above eps, in units of the constraints and rad, ends the corrections as soon as what is left is less.
    """
    poses, last, reached = poses.copy(), np.zeros(len(poses)), np.zeros(len(poses), dtype=bool)
    busy = np.arange(len(poses))
    with np.errstate(over="ignore", invalid="ignore"):
        for rounds in range(NEWTON_ROUNDS):
            at = constraints.place(poses[busy])
            step = solutions(constraints.jacobian(at), constraints.residual(at, phi[busy]))
            poses[busy] = constraints.moved(poses[busy], -step)
            size = np.abs(step).max(axis=1) / far(poses[busy])
            # What Newton's law leaves after two corrections; before the second, nothing is known of it.
            left = size * (size / last[busy]) ** 2 if rounds else size
            # The law holds near a solution only; far from any, two corrections may happen to look like it.
            reached[busy] = (size <= SQRT_EPS) | ((left <= tolerance) & (last[busy] <= 1.0))
            more = (left > tolerance) & ((size < last[busy]) | (rounds == 0))
            last[busy] = size
            busy = busy[more]
            if not busy.size:
                break
        return poses, reached & closed(constraints, poses, phi, tolerance)


def closed(constraints: Constraints, poses: Floats, phi: Floats, tolerance: float = EPS) -> Flags:
    """Tell whether the joints are closed but for rounding: corrections that shrink may run away all the same."""
    miss = np.abs(constraints.residual(constraints.place(poses), phi)).max(axis=1, initial=0.0)
    return np.asarray(miss <= ROUNDINGS * tolerance * far(poses))


def far(poses: Floats) -> Floats:
    """Give the farthest coordinate of every pose, at least 1: a pin that runs to infinity has its roundings with it."""
    return np.asarray(np.maximum(np.abs(poses[:, :, :TURN]).max(axis=(1, 2), initial=1.0), 1.0))


def close_singular(constraints: Constraints, poses: Floats, phi: Floats) -> Floats:
    """Close poses at singular positions, leaving alone the direction in which the links are free to move."""
    at = constraints.place(poses)
    jacobian, miss = constraints.jacobian(at), constraints.residual(at, phi)
    return constraints.moved(poses, -(np.linalg.pinv(jacobian, rcond=SQRT_EPS) @ miss[..., None])[..., 0])


def settle(constraints: Constraints, poses: Floats, phi: Floats) -> tuple[Floats, Flags]:
    """Bring rough poses together by damped Gauss-Newton (Levenberg), then close them; tell where that succeeded."""
    poses = poses.copy()
    miss = constraints.residual(constraints.place(poses), phi)
    busy = np.arange(len(poses))
    for left in reversed(range(DAMPED_ROUNDS)):
        size = np.linalg.norm(miss[busy], axis=1)
        busy, size = busy[size > SQRT_EPS], size[size > SQRT_EPS]
        if not busy.size:
            break
        jacobian = constraints.jacobian(constraints.place(poses[busy]))
        across = jacobian.transpose(0, 2, 1)
        # Damping by the square of the miss keeps the step finite at singular poses; it fades as Newton's law takes on.
        damping = (size**2)[:, None, None] * np.eye(jacobian.shape[1])
        step = solutions(across @ jacobian + damping, -(across @ miss[busy][..., None])[..., 0])
        poses[busy], miss[busy] = _descend(constraints, poses[busy], phi[busy], step, size)
        share = np.linalg.norm(miss[busy], axis=1) / size  # where it is 1, they are as near as they come
        busy = busy[(share < 1.0 - SQRT_EPS) & (size * share**left < NEAR)]
    return close(constraints, poses, phi)


def transfer(constraints: Constraints, poses: Floats, order: int) -> tuple[Floats, ...]:
    """Differentiate closed poses by the crank angle `order` times: first and second transfer functions."""
    at = constraints.place(poses)
    if not order:
        return ()
    jacobian = constraints.jacobian(at)
    unit = np.zeros(jacobian.shape[:2])
    unit[:, -1] = 1.0  # the drive is the last equation
    first = constraints.drive.stated(as_poses(_refine(jacobian, unit)), 1.0)
    if order == 1:
        return (first,)
    return first, constraints.drive.stated(as_poses(_refine(jacobian, -constraints.convective(at, first))), 0.0)


def _refine(jacobian: Floats, right: Floats) -> Floats:
    """Solve N linear systems, and once more for what their rounding left."""
    found = solutions(jacobian, right)
    return found + solutions(jacobian, right - (jacobian @ found[..., None])[..., 0])


def _descend(constraints: Constraints, poses: Floats, phi: Floats, step: Floats, size: Floats) -> tuple[Floats, Floats]:
    """Go along the step by the first of 1, 1/2, 1/4, ... of it that lessens the miss."""
    whole, share = step if np.isfinite(step).all() else np.nan_to_num(step), np.ones(len(poses))
    moved = constraints.moved(poses, whole)
    miss = constraints.residual(constraints.place(moved), phi)
    worse = np.flatnonzero(np.linalg.norm(miss, axis=1) >= size)
    for _ in range(HALVINGS):
        if not worse.size:
            break
        share[worse] *= 0.5
        moved[worse] = constraints.moved(poses[worse], share[worse, None] * whole[worse])
        miss[worse] = constraints.residual(constraints.place(moved[worse]), phi[worse])
        worse = worse[np.linalg.norm(miss[worse], axis=1) >= size[worse]]
    return moved, miss
