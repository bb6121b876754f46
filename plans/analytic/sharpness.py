"""How sharply a block of joints meets: the sine of the angle at which its links cross (острота засечки).

A length that is one unit out moves some joint of the block by up to 1/sine; at a dead centre by any amount.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.analytic.blocks import Block
from plans.analytic.closure import SQRT_EPS, inverses
from plans.analytic.placement import Placement
from plans.model.motion import Complexes, Floats

# Less sharp than this, two assemblies of a block lie hardly farther apart than the rounding of their poses, eps over
# the sharpness: a march cannot tell them from each other.
MERGED = 4.0 * SQRT_EPS
# A determinant of this share of what its columns could make (Hadamard) or more is that of a sharp block.
PLAIN = 1e-5
DOUBTFUL = 1e-3  # less sharp than this, a dead centre may be as near as 1e-6 rad


def least(blocks: Sequence[Block], jacobian: Floats, poses: Floats) -> Floats:
    """Give the sharpness of the bluntest block at N poses, (N,); above PLAIN it is a bound from below."""
    return least_of(blocks, determinants(blocks, jacobian), jacobian, poses)


def determinants(blocks: Sequence[Block], jacobian: Floats) -> Floats:
    """Give the determinants of all blocks at N positions, (blocks, N)."""
    return np.array([np.linalg.det(block.of(jacobian)) for block in blocks])


def least_of(blocks: Sequence[Block], dets: Floats, jacobian: Floats, poses: Floats) -> Floats:
    """Give the sharpness of the bluntest block, (N,), from the determinants of all blocks, (blocks, N)."""
    found = np.ones(len(poses))
    for block, det in zip(blocks, dets, strict=True):
        own = block.of(jacobian)
        sharp = np.abs(det) / np.sqrt((own**2).sum(axis=1)).prod(axis=1)
        doubtful = np.flatnonzero(sharp < PLAIN)
        if doubtful.size:
            sharp[doubtful] = sharpness(block, poses[doubtful])
        found = np.minimum(found, sharp)
    return found


def sharpness(block: Block, poses: Floats) -> Floats:
    """Give the sharpness of a block at N poses, (N,): 1 is a square crossing, 0 a dead centre."""
    equations = block.equations
    at = equations.place(poses)
    moved = _displacements(block, at, inverses(equations.jacobian(at)))
    hinges, slides = equations.hinges, len(equations.slide_ways[0])
    along, up = moved[:, :, :hinges], moved[:, :, hinges : 2 * hinges]
    lines = np.abs(moved[:, :, 2 * hinges + slides : 2 * (hinges + slides)]) ** 2
    # A hinge may be out in any direction: the longest axis of the ellipse that a joint goes round then.
    mean = (np.abs(along) ** 2 + np.abs(up) ** 2) / 2.0
    skew = np.hypot((np.abs(along) ** 2 - np.abs(up) ** 2) / 2.0, (along * up.conj()).real)
    most = np.maximum(_largest(mean + skew), _largest(lines))
    with np.errstate(divide="ignore"):
        return np.asarray(np.minimum(np.where(most > 0.0, 1.0 / np.sqrt(most), 0.0), 1.0))


def _largest(squares: Floats) -> Floats:
    return np.asarray(squares.max(axis=(1, 2), initial=0.0))


def _displacements(block: Block, at: Placement, inverse: Floats) -> Complexes:
    """Tell how joints move, as points of either link, where an equation is one unit out: (N, joints, equations)."""
    equations, found = block.equations, []
    places = {link: 3 * k for k, link in enumerate(equations.sought.tolist())}
    for side in (0, 1):
        for joint, link in enumerate(equations.links[side].tolist()):
            if link not in places:
                continue
            arm = at.arms[:, side, joint].copy()
            if side == 1 and joint >= equations.hinges:
                arm += at.apart[:, joint]  # the owner's point that lies under the slider's
            k = places[link]
            found.append(inverse[:, k] + 1j * inverse[:, k + 1] + 1j * arm[:, None] * inverse[:, k + 2])
    return np.array(found).swapaxes(0, 1)
