"""A study: a scene with its plans, each made once, when it is first asked for (исследование механизма)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np
import numpy.typing as npt

from geometry.errors import ConstructionError
from plans import gaps, passage
from plans.acceleration import accelerations
from plans.angles import angle, rate
from plans.extreme import Found, extremes, output
from plans.linkage import mechanism_of
from plans.mechanism import FRAME, Mechanism, Output, StructureError
from plans.motion import Complexes, Floats, Gap, LinkMotion, Motion, PointMotion
from plans.passage import Barrier, Sweep
from plans.plan import Plan
from plans.scene import Scene
from plans.sketch import Assembly, SketchError, assembly
from plans.structure import Dyad, decompose
from plans.turn import Turn, even, from_direction, listed
from plans.velocity import velocities

BLOCK = 2048  # positions constructed together: arrays of this size stay in the processor's cache


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
        match order:
            case 0:
                return self.positions
            case 1:
                return self.velocities
        return self.accelerations


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
        try:
            return decompose(self.mechanism)
        except StructureError as error:
            raise StructureError(f"{self._at('links')}: {error}", error.links, error.found, error.needed) from None

    def _at(self, table: str) -> str:
        """Say where a table of the mechanism stands in the scene's file."""
        there = table == "links" or bool(self.scene.mechanism.sketch)
        line, column = self.scene.place(("mechanism", table) if there else ("mechanism",))
        return f"{self.scene.file}:{line}:{column}: mechanism.{table}"

    @property
    def sense(self) -> int:
        """Sense of rotation: +1 counter-clockwise, -1 clockwise."""
        return -1 if self.mechanism.drive.omega < 0 else 1

    @cached_property
    def assembly(self) -> Assembly:
        """The assembly that the sketch chooses."""
        first = self.scene.drive.first
        start = None if first is None else listed([Fraction(first)])
        try:
            return assembly(self.mechanism, self.groups, start, even(Fraction(0), 360, 1))
        except SketchError as error:
            raise SketchError(f"{self._at('sketch')}: {error}", error.points) from None

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
            raise NoExtreme(f"{self.scene.file}:{self.scene.place(('drive', 'start'))[0]}: {self._no_extreme()}")
        return from_direction(self.found.directions[0], self.found.extremes.phi[0], drive.positions, self.sense)

    def _no_extreme(self) -> str:
        why = "it turns fully or stands still"
        if self.barriers:
            barrier = self.barriers[0]
            edges = f"{np.degrees(barrier.start):.2f} to {np.degrees(barrier.end):.2f} degrees"
            why = f"the crank does not turn fully ({barrier.kind} at {barrier.where}, {edges})"
        return (
            f'drive.start = "extreme", but output link {self.output.link} has no extreme position: {why}. '
            "Fix: give the first crank angle in degrees, or name another [output]"
        )

    @cached_property
    def lost(self) -> npt.NDArray[np.bool_]:
        """Positions that the mechanism does not reach, or in which it has no one place."""
        return np.concatenate([self._lost(drafts) for drafts in self._blocks()])

    def _lost(self, drafts: Drafts) -> npt.NDArray[np.bool_]:
        if self.assembly.phi is None:
            return np.ones(len(drafts.turn), dtype=bool)
        return gaps.lost(self.sweep, drafts.positions, drafts.turn, self.assembly.phi, self.barriers)

    def _blocks(self) -> Iterator[Drafts]:
        """Give the plans block by block: those of a sheet are one block, and are kept."""
        count = len(self.turn)
        if count <= BLOCK:
            yield self.drafts()
        else:
            yield from (Drafts(self, self.turn.part(slice(k, k + BLOCK))) for k in range(0, count, BLOCK))

    def reached(self, phi: Floats) -> npt.NDArray[np.bool_]:
        """Tell which crank angles the mechanism reaches from the position that the sketch shows."""
        if self.assembly.phi is None:
            return np.zeros(len(phi), dtype=bool)
        return gaps.reached(phi, self.assembly.phi, self.barriers)

    @cached_property
    def span(self) -> tuple[float, float]:
        """Crank angles, rad, between which the drive turns: a whole turn, or what listed angles span."""
        if isinstance(self.scene.drive.positions, int):
            return 0.0, 2 * np.pi
        return float(self.turn.phi.min()), float(self.turn.phi.max())

    @cached_property
    def met(self) -> tuple[Barrier, ...]:
        """The barriers within the span of the drive."""
        low, high = self.span
        edges = ((b, (b.start - low) % (2 * np.pi), (b.end - low) % (2 * np.pi)) for b in self.barriers)
        return tuple(b for b, start, end in edges if min(start, end) <= high - low)

    @cached_property
    def nodes(self) -> Floats:
        """Crank angles, rad, close to each other, over the part of the drive's span that the mechanism reaches."""
        low, high = self.span
        phi = np.linspace(low, high, passage.NODES + 1)
        return phi[self.reached(phi)]

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
        parts, start = [], 0
        for drafts in self._blocks():
            parts.append(self._gapped(_read(drafts, order), self._lost(drafts), start))
            start += len(drafts.turn)
        return parts[0] if len(parts) == 1 else _whole(parts)

    def _gapped(self, drawn: Motion, lost: npt.NDArray[np.bool_], start: int) -> Motion:
        """Make the positions that are not reached, and what has no value in the rest, named gaps."""
        named = [self._gap(start + int(k)) for k in np.flatnonzero(lost)]
        for points in drawn.points.values():
            points.r[lost] = np.nan
        for links in drawn.links.values():
            links.angle[lost] = np.nan
        gaps.forget(drawn, lost)
        named += gaps.without_velocity(drawn, lost, self.barriers, start)
        return Motion("construction", drawn.phi, drawn.points, drawn.links, tuple(sorted(named, key=_number)))

    def _gap(self, position: int) -> Gap:
        turn = self.turn.part([position])
        return gaps.of_position(self.sweep, turn, position, self.assembly.phi, self.barriers)


def _number(gap: Gap) -> int:
    return gap.position


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
