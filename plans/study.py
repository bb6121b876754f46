"""A study: a scene with its plans, each made once, when it is first asked for (исследование механизма)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np
import numpy.typing as npt

from geometry.board import Mark, at
from geometry.errors import ConstructionError
from plans import passage
from plans.acceleration import accelerations
from plans.angles import angle, rate
from plans.extreme import Found, extremes, output
from plans.linkage import mechanism_of
from plans.mechanism import FRAME, Mechanism, Output
from plans.motion import Complexes, Floats, Gap, LinkMotion, Motion, PointMotion
from plans.passage import Barrier, Sweep, reached
from plans.plan import Plan
from plans.scene import Scene
from plans.sketch import Assembly, assembly
from plans.structure import Dyad, decompose
from plans.turn import Turn, even, from_direction, listed
from plans.velocity import velocities

BLOCK = 2048  # positions constructed together: arrays of this size stay in the processor's cache
ORDERS = ("positions", "velocities", "accelerations")


class NoExtreme(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """A start at an extreme position was asked of an output link that has none."""


@dataclass(frozen=True)
class Drafts:
    """The plans over some positions of a study: velocities and accelerations are drawn when first asked for."""

    study: Study
    turn: Turn

    @cached_property
    def positions(self) -> Plan:
        """The plan of positions."""
        self.study.made.setdefault("positions")
        return self.study.sweep.drawn(self.turn)

    @cached_property
    def velocities(self) -> Plan:
        """The velocity plan."""
        self.study.made.setdefault("velocities")
        return velocities(self.positions, self.study.groups)

    @cached_property
    def accelerations(self) -> Plan:
        """The acceleration plan."""
        self.study.made.setdefault("accelerations")
        return accelerations(self.velocities, self.study.groups)

    def plan(self, order: int) -> Plan:
        """The plan of an order: 0 positions, 1 velocities, 2 accelerations."""
        return (self.positions, self.velocities, self.accelerations)[order] if order else self.positions


class Study:
    """A scene with its mechanism, groups, assembly, turn and plans; nothing is made before it is asked for."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.made: dict[str, None] = {}  # what was made, in order: the sheet's account of what it left out

    @cached_property
    def mechanism(self) -> Mechanism:
        """The mechanism of the scene."""
        return mechanism_of(self.scene)

    @cached_property
    def groups(self) -> tuple[Dyad, ...]:
        """The Assur groups in solving order."""
        return decompose(self.mechanism)

    @property
    def sense(self) -> int:
        """Sense of rotation: +1 counter-clockwise, -1 clockwise."""
        return -1 if self.mechanism.drive.omega < 0 else 1

    @cached_property
    def assembly(self) -> Assembly:
        """The assembly that the sketch chooses."""
        first = self.scene.drive.first
        start = None if first is None else listed([Fraction(first)])
        return assembly(self.mechanism, self.groups, start, even(Fraction(0), 360, 1))

    @cached_property
    def sweep(self) -> Sweep:
        """The mechanism with its chosen assembly, ready to be drawn at any crank angle."""
        return Sweep(self.mechanism, self.groups, self.assembly.sides)

    @cached_property
    def barriers(self) -> tuple[Barrier, ...]:
        """What bars a full turn of the crank."""
        return self.sweep.barriers()

    @cached_property
    def output(self) -> Output:
        """The output link."""
        return output(self.mechanism, self.groups)

    @cached_property
    def found(self) -> Found | None:
        """The output's extreme positions, None where it has none."""
        self.made.setdefault("extremes")
        return extremes(self.sweep, self.output)

    @cached_property
    def turn(self) -> Turn:
        """All crank positions of the scene."""
        drive = self.scene.drive
        if isinstance(drive.positions, tuple):
            return listed([Fraction(angle) for angle in drive.positions])
        if drive.first is not None:
            return even(Fraction(drive.first), drive.positions, self.sense)
        if self.found is None:
            raise NoExtreme(
                f'{self.scene.file}: drive.start = "extreme", but link {self.output.link} has no extreme position: '
                "it turns fully, or the crank does not. Fix: give the first crank angle in degrees"
            )
        return from_direction(self.found.directions[0], self.found.extremes.phi[0], drive.positions, self.sense)

    @cached_property
    def lost(self) -> npt.NDArray[np.bool_]:
        """Positions that the mechanism does not reach, or in which it cannot be assembled."""
        return ~self.reached(self.turn.phi)

    def reached(self, phi: Floats) -> npt.NDArray[np.bool_]:
        """Tell which crank angles the mechanism reaches from the position that the sketch shows."""
        if self.assembly.phi is None:
            return np.zeros(len(phi), dtype=bool)
        return reached(phi, self.assembly.phi, self.barriers)

    def drafts(self, chosen: slice | Sequence[int] = slice(None)) -> Drafts:
        """Give the plans over some positions; the plans of the same positions are the same."""
        key = repr(chosen)
        if key not in self._drafts:
            self._drafts[key] = Drafts(self, self.turn.part(chosen))
        return self._drafts[key]

    @cached_property
    def _drafts(self) -> dict[str, Drafts]:
        return {}

    def motion(self, order: int = 2) -> Motion:
        """Give the motion by construction: order 0 positions, 1 and velocities, 2 and accelerations."""
        count = len(self.turn)
        if count <= BLOCK:
            return self._gapped(_read(self.drafts(), order), self.lost, 0)
        blocks = [slice(start, start + BLOCK) for start in range(0, count, BLOCK)]
        parts = [
            self._gapped(_read(Drafts(self, self.turn.part(part)), order), self.lost[part], part.start)
            for part in blocks
        ]
        return _whole(parts)

    def _gapped(self, drawn: Motion, lost: npt.NDArray[np.bool_], start: int) -> Motion:
        """Make the positions that are not reached, and what has no value in the rest, named gaps."""
        gaps = [self._gap(start + int(k), float(drawn.phi[k])) for k in np.flatnonzero(lost)]
        for points in drawn.points.values():
            points.r[lost] = np.nan
        for links in drawn.links.values():
            links.angle[lost] = np.nan
        _forget(drawn, lost)
        gaps += self._without_velocity(drawn, lost, start)
        return Motion("construction", drawn.phi, drawn.points, drawn.links, tuple(sorted(gaps, key=_number)))

    def _gap(self, position: int, phi: float) -> Gap:
        """Say why a position is not reached, and what would mend it."""
        plan = self.sweep.plan(np.array([phi]))
        field, marks = passage.margins(plan, self.groups)
        failing = np.flatnonzero(field[:, 0] < 0)
        if failing.size:
            mark = marks[int(failing[0])]
            miss = at(mark.miss if mark.miss is not None else 0.0, 0).real
            return Gap(position, phi, "positions", passage.GAP, mark.name, miss, _reach_advice(mark, miss))
        change = any(barrier.kind == passage.CHANGE for barrier in self.barriers)
        reason = "beyond a change point" if change else "not reachable"
        advice = (
            "the mechanism may go on in two ways there: start the drive beyond the change point, or change a length"
            if change
            else "the crank cannot turn there from the first position: start the drive in that part of the turn"
        )
        return Gap(position, phi, "positions", reason, self._nearest_barrier(), 0.0, advice)

    def _nearest_barrier(self) -> str:
        return self.barriers[0].where if self.barriers else ""

    def _without_velocity(self, drawn: Motion, lost: npt.NDArray[np.bool_], start: int) -> list[Gap]:
        gaps = []
        moving = [motion.v for motion in drawn.points.values() if motion.v is not None]
        if moving:
            none = np.isnan(np.array(moving))
            dead = none.any(axis=0) & ~lost
            letters = [name for name, motion in drawn.points.items() if motion.v is not None]
            names = {int(k): letters[int(np.argmax(none[:, k]))] for k in np.flatnonzero(dead)}
            _forget(drawn, dead)
            for k in np.flatnonzero(dead):
                name = names[int(k)]
                advice = "a group is at its dead centre: its velocities have no one value; take a position beside it"
                phi = float(drawn.phi[k])
                gaps.append(Gap(start + int(k), phi, "velocities", "dead centre", name, 0.0, advice))
        return gaps


def _forget(drawn: Motion, positions: npt.NDArray[np.bool_]) -> None:
    """Leave no velocity and no acceleration where the mechanism as a whole has none."""
    for points in drawn.points.values():
        for values in (points.v, points.a):
            if values is not None:
                values[positions] = np.nan
    for links in drawn.links.values():
        for numbers in (links.omega, links.epsilon):
            if numbers is not None:
                numbers[positions] = np.nan


def _number(gap: Gap) -> int:
    return gap.position


def _reach_advice(mark: Mark, miss: float) -> str:
    """Say by how much the loci of a meeting miss each other and which lengths they are."""
    names = " and ".join(locus.name for locus in mark.step.inputs)
    return f"{names} miss each other by {miss:.6g} m: lengthen one of them, or turn the crank less"


def _read(drafts: Drafts, order: int) -> Motion:
    """Read the motion of all named points and links off the plans."""
    mechanism, count = drafts.study.mechanism, len(drafts.turn)
    plans = [drafts.plan(k) for k in range(order + 1)]
    letters = sorted({point for link in mechanism.links.values() for point in link.points})
    points = {letter: PointMotion(*(_spread(plan.point(letter).point, count) for plan in plans)) for letter in letters}
    links = {
        number: LinkMotion(
            _spread_real(angle(plans[0], number), count),
            *(_spread_real(rate(plan, number), count) for plan in plans[1:]),
        )
        for number in sorted(mechanism.links)
        if number != FRAME
    }
    return Motion("construction", drafts.turn.phi, points, links, ())


def _spread(value: object, count: int) -> Complexes:
    return np.array(np.broadcast_to(np.asarray(value, dtype=np.complex128), count))


def _spread_real(value: Floats, count: int) -> Floats:
    return np.array(np.broadcast_to(value, count))


def _whole(parts: Sequence[Motion]) -> Motion:
    """Join the motions of following blocks of positions."""

    def joined(arrays: Sequence[npt.NDArray[np.generic] | None]) -> npt.NDArray[np.generic] | None:
        kept = [array for array in arrays if array is not None]
        return np.concatenate(kept) if kept else None

    points = {
        name: PointMotion(*(joined([getattr(part.points[name], key) for part in parts]) for key in "rva"))  # type: ignore[arg-type]
        for name in parts[0].points
    }
    links = {
        number: LinkMotion(
            *(joined([getattr(p.links[number], key) for p in parts]) for key in ("angle", "omega", "epsilon"))  # type: ignore[arg-type]
        )
        for number in parts[0].links
    }
    phi = np.concatenate([part.phi for part in parts])
    return Motion("construction", phi, points, links, tuple(gap for part in parts for gap in part.gaps))
