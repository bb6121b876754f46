"""Reactions and the balancing moment by analysis: equilibrium of all links at once (кинетостатика, принцип Даламбера).

The forces of the joints are the multipliers of the joints' equations: J^T lambda + Q = 0, where Q are the loads,
weights and inertia forces as the poses of the links feel them; the drive's multiplier balances them. No groups here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from plans.analytic.assembly import unbalanced
from plans.analytic.closure import BLUNT, inverses, rank_loss, reciprocal_condition, solutions
from plans.analytic.kinematics import Analysis
from plans.analytic.points import TURN, Constraints, Placement, X, Y, place
from plans.analytic.positions import blocks
from plans.analytic.power import borne
from plans.model.dyad import Pair
from plans.model.kinetostatics import Effort, Kinetostatics, Loading, Reaction, without_forces
from plans.model.machine import FORCE, GEAR, Machine, Transmission
from plans.model.mechanism import FRAME, Drive, Mechanism
from plans.model.motion import DEAD_CENTRE, INDETERMINATE, Complexes, Floats, Gap, Motion


class Action(NamedTuple):
    """A line of action over the positions: a point of it, m, its unit direction, and the shaft's place."""

    r: Complexes
    along: Complexes
    shaft: Complexes


def action(
    transmission: Transmission, mechanism: Mechanism, constraints: Constraints, poses: Floats, sense: Floats
) -> Action | None:
    """Give the line of action of a crank driven by force; None where a moment drives it, and of a slide.

    Teeth press in a sense (+1 to the left), turned from the pitch tangent by the pressure angle towards the shaft.
    """
    drive, points = mechanism.drive, mechanism.links[mechanism.drive.link].points
    if drive.guide is not None:
        return None
    shaft = place(constraints, poses, drive.link, points[drive.pivot])
    if transmission.kind == FORCE:
        end = place(constraints, poses, drive.link, points[drive.end])
        return Action(end, 1j * (end - shaft) / np.abs(end - shaft), shaft)
    if transmission.kind == GEAR:
        towards = np.exp(1j * transmission.at)
        along = 1j * towards * sense * np.exp(1j * sense * transmission.pressure)
        return Action(shaft + transmission.radius * towards, along, shaft)
    return None


def unit_force(constraints: Constraints, poses: Floats, line: Action) -> Floats:
    """Give the generalised force of a unit force along the line on the crank, in place of the drive's equation."""
    row = np.zeros((len(poses), len(constraints.numbers), 3))
    x, y, _ = poses[:, constraints.crank].T
    arm = line.r / constraints.size - (x + 1j * y)
    row[:, constraints.crank, X], row[:, constraints.crank, Y] = line.along.real, line.along.imag
    row[:, constraints.crank, TURN] = (arm.conj() * line.along).imag
    return row[:, 1:].reshape(len(poses), -1)


def balancing(
    mechanism: Mechanism, constraints: Constraints, line: Action | None, poses: Floats, multiplier: Floats
) -> Effort:
    """Read the drive's multiplier, N*m: the moment itself, or the force times `size`; of a slide times its unit."""
    if mechanism.drive.guide is not None:
        return _pushed(mechanism.drive, mechanism, constraints, poses, multiplier)
    if line is None:
        return Effort(multiplier)
    force = multiplier / constraints.size * line.along
    return Effort((np.conj(line.r - line.shaft) * force).imag, force, line.r)


def _pushed(drive: Drive, mechanism: Mechanism, constraints: Constraints, poses: Floats, multiplier: Floats) -> Effort:
    """Give the force along its guide with which a slide is pushed, at the foot of its named point on the line."""
    assert drive.guide is not None  # it is pushed along
    along = drive.guide.way(FRAME).direction
    spot, line = mechanism.links[drive.link].points[drive.end], drive.guide.on_slider
    foot = line.through + line.direction * ((spot - line.through) / line.direction).real
    r = place(constraints, poses, drive.link, foot)
    return Effort(multiplier, np.asarray(multiplier / drive.unit * along), r)


def kinetostatics(
    road: Analysis, machine: Machine, motion: Motion, loading: Loading, pairs: tuple[Pair, ...]
) -> Kinetostatics:
    """Find the reactions of the pairs and the balancing moment at all positions of a motion of order 2."""
    mechanism, constraints, poses = road.mechanism, road.constraints, road.poses(motion)
    masses = borne(mechanism, machine, motion)
    loads = Loading(loading.forces + masses.forces, loading.moments + masses.moments)
    reduced = _generalised(constraints, poses, loads)

    def balanced(sense: Floats) -> tuple[Action | None, Floats, dict[int, str]]:
        line = action(machine.transmission, mechanism, constraints, poses, sense)
        return line, *_balance(constraints, poses, reduced, line and unit_force(constraints, poses, line))

    sense = np.full(len(poses), -1.0 if mechanism.drive.omega < 0.0 else 1.0)
    line, multipliers, singular = balanced(sense)
    pulled = multipliers[:, -1] < 0.0
    if machine.transmission.kind == GEAR and pulled.any():  # a tooth cannot: the other flank bears, and pushes
        line, multipliers, singular = balanced(np.where(pulled, -sense, sense))
    multipliers[[gap.position for gap in motion.gaps]] = np.nan  # where velocities are not borne, neither are forces
    forces = _Forces(mechanism, constraints, motion, poses, multipliers, constraints.place(poses))
    found = _hinge_reactions(forces, pairs) | _sliding(forces, pairs)
    return Kinetostatics(
        by="analysis",
        phi=motion.phi,
        reactions={pair.key: found[pair.key] for pair in pairs},
        balancing=balancing(mechanism, constraints, line, poses, multipliers[:, -1]),
        gaps=_gaps(motion, singular | _lost(constraints, poses, motion)),
    )


class _Forces(NamedTuple):
    """What the joints bear: multipliers N*m, (N, rows), of the equations laid out at the poses."""

    mechanism: Mechanism
    constraints: Constraints
    motion: Motion
    poses: Floats
    multipliers: Floats
    at: Placement


def _generalised(constraints: Constraints, poses: Floats, loading: Loading) -> Floats:
    """Reduce loads to the origins of their links: forces times `size` and moments, N*m, (N, 3 n)."""
    reduced = np.zeros_like(poses)
    for load in loading.forces:
        on = constraints.numbers.index(load.link)
        reduced[:, on, X] += constraints.size * load.force.real
        reduced[:, on, Y] += constraints.size * load.force.imag
        reduced[:, on, TURN] += (np.conj(load.at * np.exp(1j * poses[:, on, TURN])) * load.force).imag
    for twist in loading.moments:
        reduced[:, constraints.numbers.index(twist.link), TURN] += twist.moment
    return reduced[:, 1:].reshape(len(poses), -1)


def _balance(
    constraints: Constraints, poses: Floats, loads: Floats, drive: Floats | None
) -> tuple[Floats, dict[int, str]]:
    """Solve the equations of equilibrium; name the positions without an answer, and why."""
    multipliers = np.full((len(poses), len(constraints.pattern)), np.nan)
    singular: dict[int, str] = {}
    known = np.flatnonzero(np.isfinite(poses).all(axis=(1, 2)))
    for block in blocks(len(known)):
        here = known[block]
        matrices = constraints.jacobian(constraints.place(poses[here]))
        if drive is not None:
            matrices[:, -1] = drive[here]
        found = multipliers[here] = solutions(matrices.transpose(0, 2, 1), -loads[here])
        none = np.flatnonzero(~np.isfinite(found).all(axis=1))
        singular |= {int(here[k]): DEAD_CENTRE if rank_loss(matrices[k])[1] else INDETERMINATE for k in none}
    return multipliers, singular


def _lost(constraints: Constraints, poses: Floats, motion: Motion) -> dict[int, str]:
    """Give the gaps of the velocities where the equations lose rank, and why there are no forces."""
    reasons = {gap.position: without_forces(gap) for gap in motion.gaps if np.isfinite(poses[gap.position]).all()}
    matrices = constraints.jacobian(constraints.place(poses[list(reasons)]))
    blunt = reciprocal_condition(matrices, inverses(matrices)) <= BLUNT
    return {k: reasons[k] for k, faint in zip(reasons, blunt, strict=True) if faint}


def _gaps(motion: Motion, singular: dict[int, str]) -> tuple[Gap, ...]:
    """Name the singular positions, and carry over those of the motion that are lost for other reasons."""
    found = [gap for gap in motion.gaps if gap.position not in singular]
    found += [unbalanced(k, float(motion.phi[k]), reason) for k, reason in singular.items()]
    return tuple(sorted(found, key=lambda gap: gap.position))


def _hinge_reactions(forces: _Forces, pairs: Sequence[Pair]) -> dict[str, Reaction]:
    """Read the reactions of all hinges: the equations tie all links of a hinge to one of them, x rows before y rows."""
    found: dict[str, Reaction] = {}
    hinges, row = forces.constraints.hinges, 0
    for point, links in forces.mechanism.hinges.items():
        rows = slice(row, row + len(links) - 1)
        row = rows.stop
        x, y = forces.multipliers[:, :hinges][:, rows].T, forces.multipliers[:, hinges : 2 * hinges][:, rows].T
        first, others = forces.constraints.links[:, rows]
        tied = [forces.constraints.numbers[place] for place in (first[0], *others)]
        on_first = (x + 1j * y) / forces.constraints.size
        on_links = dict(zip(tied, (on_first.sum(axis=0), *-on_first), strict=True))
        r = forces.motion.points[point].r
        for pair, force in _peel([pair for pair in pairs if pair.joint == point], on_links):
            found[pair.key] = Reaction(pair.giver, pair.taker, point, r, force)
    return found


def _peel(tree: list[Pair], on_links: dict[int, Complexes]) -> list[tuple[Pair, Complexes]]:
    """Share the forces of a pin on its links out to its pairs, a tree of links, from its leaves inward."""
    shared = []
    while tree:
        ends = [end for pair in tree for end in (pair.giver, pair.taker)]
        pair, leaf = next((p, end) for p in tree for end in (p.taker, p.giver) if ends.count(end) == 1)
        other, force = pair.giver + pair.taker - leaf, on_links[leaf]
        shared.append((pair, force if leaf == pair.taker else -force))
        on_links = {**on_links, other: on_links[other] + force}
        tree = [left for left in tree if left is not pair]
    return shared


def _sliding(forces: _Forces, pairs: Sequence[Pair]) -> dict[str, Reaction]:
    """Read the reactions of all slides: a force across the line, and a moment, told at the slider's point."""
    constraints, slides = forces.constraints, forces.mechanism.slides
    count, found = len(slides), {}
    for pair in pairs:
        if isinstance(pair.joint, str):
            continue
        k = slides.index(pair.joint)
        turning, across = (forces.multipliers[:, 2 * constraints.hinges + row] for row in (k, count + k))
        along = forces.at.ways[:, 1, k]
        force, r = across / constraints.size * 1j * along, forces.motion.points[pair.point].r
        # The multipliers are those on the slider, at the point of its line that its equation is written for.
        x, y, _ = forces.poses[:, constraints.links[0, constraints.hinges + k]].T
        foot = constraints.size * (x + 1j * y + forces.at.arms[:, 0, constraints.hinges + k])
        moment = ((foot - r).conj() * force).imag - turning
        sign = 1.0 if pair.taker == pair.joint.slider else -1.0
        found[pair.key] = Reaction(pair.giver, pair.taker, pair.point, r, sign * force, sign * moment, along)
    return found
