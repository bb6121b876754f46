"""Where the way round ends: the singular position of one block of the equations, found to rounding (особые положения).

At a dead centre two assemblies merge and the crank turns back: the crank angle has a maximum along the path of the
mechanism, and the path itself goes on smoothly. At a change point two paths cross. Where guides become parallel, links
that only translate run to infinity.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from plans.analytic.blocks import Block
from plans.analytic.closure import EPS, SQRT_EPS, as_poses, closed, inverses
from plans.analytic.points import Constraints, Placement
from plans.model.motion import CHANGE_POINT, DEAD_CENTRE, PARALLEL_GUIDES, Complexes, Floats

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
        sharp = np.abs(det) / np.sqrt((block.of(jacobian) ** 2).sum(axis=1)).prod(axis=1)
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


SHORTEST = 2.0**-30  # rad, 1e-9: the shortest step of a march
# So near to a change point, rad, that a position is that of the change point: two ways part there by as much, and the
# poses are known to eps over it.
AT_CHANGE = 2.0**-23
BESIDE = 2.0**-20  # rad from a singular position: wider than the square root of UNBORNE, in which sharpness tells
ROUNDS = 24  # Newton squares the error; the rest is for slow beginnings
# Taylor's polynomial from this distance misses by its cube, and the poses there are known to eps over the distance:
# both come to eps^(3/4) at the fourth root of eps.
CLEAR = EPS**0.25
TOUCHING = 4.0  # roundings of a block's perimeter by which its joints may miss each other and yet meet
ALIKE = 64.0  # times as sharp as the bluntest block: a dead centre is blunt from farther away than a change point


class Station(NamedTuple):
    """A closed position: crank angle, poses (links, 3), their two transfer functions, and the state of the blocks."""

    phi: float  # rad, continuous along the march
    poses: Floats
    first: Floats
    second: Floats
    dets: Floats  # determinants of the blocks' Jacobians
    sharp: float  # sharpness of the bluntest block; 1 where all are plainly sharp

    def predict(self, phi: float) -> Floats:
        """Predict the poses at a crank angle close by, rad, by Taylor's polynomial."""
        step = phi - self.phi
        return self.poses + step * (self.first + step / 2.0 * self.second)


class Fold(NamedTuple):
    """A dead centre: the poses there, and how poses and crank angle go on along the path s, which is the march's."""

    poses: Floats
    first: Floats  # by s
    second: Floats
    bend: float  # second derivative of the crank angle by s

    def predict(self, apart: float) -> Floats:
        """Predict the poses where the crank is `apart` rad from the dead centre, on the side from which we came."""
        s = -float(np.sqrt(max(2.0 * apart / self.bend, 0.0)))
        return self.poses + s * (self.first + s / 2.0 * self.second)


class Halt(NamedTuple):
    """Where a march could go no further: the last crank angle reached, where the Jacobian loses rank, rad, and why."""

    reached: float
    singular: float
    reason: str
    sense: float  # of the march
    fold: Fold | None = None
    limit: float = 0.0  # rad beyond a dead centre by which a crank angle is still that of the dead centre
    loose: int | None = None  # the block that has any place there: a slot whose pin lies in its own pivot

    @property
    def blind(self) -> float:
        """Angle rad on either side of the singular position within which the march could not step."""
        return max(abs(self.singular - self.reached), AT_CHANGE if self.reason == CHANGE_POINT else SHORTEST)


class _Loss(NamedTuple):
    """The loss of rank of a block: how the block's input strains its joints, and the poses that are free to move."""

    strain: float  # of unit rows, by a radian of the crank
    share: float  # of the whole input
    faint: float
    free: Floats  # (k,)
    strained: Floats  # (k,)


def end_of(constraints: Constraints, blocks: Sequence[Block], way: Sequence[Station], sense: float) -> Halt:
    """Say why a march ended, and where its singular position lies."""
    last = way[-1]
    block = blocks[_failing(blocks, way)]
    if block.linear:
        return Halt(last.phi, _root(way, _place(block, blocks), 0.0), PARALLEL_GUIDES, sense)
    loss = _loss(constraints, block, last)
    if loss.share <= np.sqrt(loss.faint):
        singular = _crossing(block, blocks, way)
        loose = _place(block, blocks) if _loose(block, last, loss) else None
        return Halt(last.phi, singular, CHANGE_POINT, sense, loose=loose)
    fold = _fold(constraints, last, sense)
    if fold is None:
        return Halt(last.phi, _root(way, _place(block, blocks), 0.0, power=2), DEAD_CENTRE, sense)
    turned = float(constraints.drive.lag(constraints.place(fold.poses[None]), np.array([last.phi]))[0])
    limit = TOUCHING * EPS * _perimeter(block, fold.poses) / _parting(block, loss)
    return Halt(last.phi, last.phi + turned, DEAD_CENTRE, sense, fold, limit)


def _place(block: Block, blocks: Sequence[Block]) -> int:
    return next(k for k, other in enumerate(blocks) if other is block)


def _failing(blocks: Sequence[Block], way: Sequence[Station]) -> int:
    """Tell which block loses its rank: of the bluntest ones, that whose determinant falls fastest."""
    last = way[-1]
    sharp = np.array([sharpness(block, last.poses[None])[0] for block in blocks])
    if len(way) == 1:
        return int(np.argmin(sharp))
    with np.errstate(divide="ignore", invalid="ignore"):
        fall = np.nan_to_num(np.abs(way[-2].dets / last.dets), posinf=np.inf)
    return int(np.argmax(np.where(sharp <= ALIKE * sharp.min(), fall, -1.0)))


def _loss(constraints: Constraints, block: Block, last: Station) -> _Loss:
    """Look at the smallest singular value of a block: an input that strains it makes a dead centre."""
    jacobian = constraints.jacobian(constraints.place(last.poses[None]))
    part = block.of(jacobian)[0]
    left, values, right = np.linalg.svd(part / np.sqrt((part**2).sum(axis=0)))
    rates = last.first[1:].ravel().copy()
    rates[block.columns] = 0.0
    drive = np.zeros(len(jacobian[0]))
    drive[-1] = -1.0
    pushed = (jacobian[0] @ rates + drive)[block.rows]
    strain, whole = abs(float(left[:, -1] @ pushed)), float(np.linalg.norm(pushed))
    return _Loss(strain, strain / whole if whole else 0.0, float(values[-1] / values[0]), right[-1], left[:, -1])


def _parting(block: Block, loss: _Loss) -> float:
    """Tell how fast the joints of a block part beyond its dead centre, by a radian of the crank."""
    hinges, count = block.equations.hinges, len(block.equations.slide_ways[0])
    pushed = np.hypot(loss.strained[:hinges], loss.strained[hinges : 2 * hinges])
    lines = np.abs(loss.strained[2 * hinges + count : 2 * (hinges + count)])
    return loss.strain / float(max(pushed.max(initial=0.0), lines.max(initial=0.0)))


def _perimeter(block: Block, poses: Floats) -> float:
    """Measure round the joints of a block: along its links, and from one joint with other links to the next."""
    equations = block.equations
    at = equations.place(poses[None])
    corners: dict[int, list[complex]] = {link: [] for link in equations.sought.tolist()}
    outer = []
    for joint, links in enumerate(equations.links.T.tolist()):
        off = 0.0 if joint < equations.hinges else complex(at.apart[0, joint])
        for side, link in enumerate(links):
            if link in corners:
                x, y, _ = poses[link]
                corners[link].append(complex(x, y) + complex(at.arms[0, side, joint]) + (off if side else 0.0))
        if not set(links) <= set(corners):
            outer.append(next(corners[link][-1] for link in links if link in corners))
    return float(sum(_extent(places) for places in corners.values()) + _extent(outer))


def _extent(places: Sequence[complex]) -> float:
    return max((abs(place - other) for place in places for other in places), default=0.0)


def _loose(block: Block, last: Station, loss: _Loss) -> bool:
    """Tell whether a block may move on while the crank stands: its joints stay closed to the second order too."""
    rates = np.zeros_like(last.poses)[None]
    scaled = loss.free / np.sqrt((block.of_own(last.poses) ** 2).sum(axis=0))
    rates.reshape(1, -1)[:, block.equations.columns] = scaled / np.abs(scaled).max()
    bent = block.equations.convective(block.equations.place(last.poses[None]), rates)[0, : len(loss.strained)]
    return bool(abs(float(loss.strained @ bent)) <= SQRT_EPS)


def _root(way: Sequence[Station], place: int, least: float, power: int = 1) -> float:
    """Carry a block's determinant on to zero from the last two stations, `least` rad and more before the end."""
    last = way[-1]
    clear = [s for s in way if abs(s.phi - last.phi) >= least][-2:] if least else way[-2:]
    if len(clear) < 2:
        return last.phi
    before, after = clear
    fall = (before.dets[place] / after.dets[place]) ** power - 1.0
    return float(after.phi + ((after.phi - before.phi) / fall if fall > 0.0 else 0.0))


def _crossing(block: Block, blocks: Sequence[Block], way: Sequence[Station]) -> float:
    """Find a change point from stations clear of it: beside it the poses themselves are not known well."""
    place, last = _place(block, blocks), way[-1]
    clear = [s for s in way if abs(s.phi - last.phi) >= CLEAR / 4][-3:]
    if len(clear) < 3:
        return _root(way, place, 0.0)
    phi, det = np.array([s.phi for s in clear]), np.array([s.dets[place] for s in clear])
    if len(set(det.tolist())) < len(det):
        return last.phi
    # The angle as a polynomial of the determinant, at zero (inverse interpolation).
    shares = [np.prod([det[j] / (det[j] - det[i]) for j in range(3) if j != i]) for i in range(3)]
    return float(np.dot(shares, phi))


def _fold(constraints: Constraints, last: Station, sense: float) -> Fold | None:
    """Follow the path of the mechanism, not the crank, to where the crank angle has its maximum."""
    along = sense * last.first[1:].ravel()
    along /= np.linalg.norm(along)
    poses = last.poses
    step = np.inf
    for _ in range(ROUNDS):
        try:
            poses, rates, bends = _on_path(constraints, poses, along)
        except np.linalg.LinAlgError:
            return None
        at = constraints.place(poses[None])
        row = constraints.jacobian(at)[0, -1]
        quadratic = constraints.convective(at, as_poses(rates[None]))[0, -1]
        rate, bend = float(row @ rates), float(row @ bends + quadratic)
        if not bend * sense < 0.0:
            return None
        before, step = step, -rate / bend
        fine = abs(step) <= SQRT_EPS
        if fine and abs(step) >= abs(before) / 2.0:
            break
        poses = poses + _pose(step * (rates + step / 2.0 * bends))
    if not closed(constraints, poses[None], constraints.drive.coordinate(constraints.place(poses[None])))[0]:
        return None
    return Fold(poses, _pose(rates), _pose(bends), bend)


def _on_path(constraints: Constraints, poses: Floats, along: Floats) -> tuple[Floats, Floats, Floats]:
    """Close poses square to a direction, and differentiate them by the way along it, twice."""
    phi = np.zeros(1)  # the drive's equation gives way to the direction
    for _ in range(3):
        at = constraints.place(poses[None])
        matrix, miss = constraints.jacobian(at)[0], constraints.residual(at, phi)[0]
        matrix[-1], miss[-1] = along, 0.0
        poses = poses - _pose(np.linalg.solve(matrix, miss))
    at = constraints.place(poses[None])
    matrix = constraints.jacobian(at)[0]
    matrix[-1] = along
    unit = np.zeros(len(matrix))
    unit[-1] = 1.0
    rates = np.linalg.solve(matrix, unit)
    bent = constraints.convective(at, as_poses(rates[None]))[0]
    bent[-1] = 0.0
    return poses, rates, -np.linalg.solve(matrix, bent)


def _pose(column: Floats) -> Floats:
    return np.asarray(as_poses(column[None])[0])
