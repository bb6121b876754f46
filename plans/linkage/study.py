"""A study: a scene with its plans, each made once, when it is first asked for (исследование механизма)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from operator import attrgetter
from typing import Any

import numpy as np
import numpy.typing as npt

from geometry.errors import ConstructionError, DraftError
from plans.linkage import ram
from plans.linkage.assembly import Assembly, Barrier, SketchError, assembly, margins
from plans.linkage.drafts import Drafts, forget, gaps_of, reached, without_velocity
from plans.linkage.dyads import KINDS
from plans.linkage.primary import CrankPositions, even, from_direction, listed
from plans.linkage.reading.form import LinkageForm
from plans.linkage.reading.linkage import mechanism_of
from plans.linkage.sweep import FAN, NODES, Sweep, at_angles
from plans.linkage.travel import ExtremePositions, extremes, output
from plans.model.decomposition import decompose
from plans.model.dyad import Assur
from plans.model.mechanism import FRAME, Mechanism, NoWorkingStroke, Output, StructureError
from plans.model.motion import (
    CHANGE_POINT,
    OUT_OF_REACH,
    PLANS,
    Flags,
    Floats,
    Motion,
    Pace,
    Rates,
    numbers_of,
    rates_at,
    steady,
)
from plans.scene.scene import Scene
from plans.words.words import Message, message, placed


def obstruction(sweep: Sweep) -> Message:
    """Say what first bars the turn, at which crank angles, and what would mend it where the loci miss the most."""
    barrier = sweep.barriers[0]
    parts: dict[str, object] = {"reason": barrier.kind, "where": barrier.where}
    if barrier.end - barrier.start < 2 * np.pi:
        parts |= {name: f"{np.degrees(edge):.2f}" for name, edge in (("low", barrier.start), ("high", barrier.end))}
    key = "barrier.turn" if "low" in parts else "barrier.nowhere"
    if barrier.kind == CHANGE_POINT:
        return message(f"{key}_advice", **parts, advice=message("barrier.change_point"))
    if barrier.kind != OUT_OF_REACH:
        return message(key, **parts)
    return message(f"{key}_advice", **parts, advice=_mending(sweep, barrier))


def _mending(sweep: Sweep, barrier: Barrier) -> Message:
    phi = np.linspace(barrier.start, barrier.end, FAN)
    _, marks = margins(sweep.plan(phi), sweep.groups, sweep.sides)
    worst = int(np.nanargmax(np.broadcast_to(np.asarray(marks[barrier.group].miss, dtype=float), FAN)))
    return gaps_of(sweep, at_angles(phi[worst : worst + 1]), [0], None, ())[0].advice


def no_extreme(sweep: Sweep, link: int, assembled: bool) -> Message:
    """Say why an output link has no extreme positions."""
    if not assembled or (sweep.barred and sweep.barriers[0].kind == CHANGE_POINT):
        return message("extreme.unassembled", why=obstruction(sweep))
    why = obstruction(sweep) if sweep.barred else message("extreme.turns")
    return message("extreme.none", link=link, why=why)


BLOCK = 8000  # positions constructed together: enough to hide the calls, few enough for the processor's cache

# The C library hands memory back to the system, to ask for it again at every block, until it has once seen a piece of
# this size come and go (32 MiB is the most it heeds); nothing is ever written in it.
np.empty(2**25 - 2**16, dtype=np.int8)

EXTREMES = "extremes"
ALL = (EXTREMES, *PLANS)


class NoExtreme(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """A start at an extreme position was asked of an output link that has none."""


class LinkageStudy:
    """A scene with its mechanism, groups, assembly, turn and plans; nothing is made before it is asked for."""

    def __init__(self, scene: Scene, plans: Collection[str] = ALL, pace: Pace | None = None) -> None:
        self.scene, self._pace = scene, pace  # None: the drive moves as the scene says
        self.plans = plans  # what is asked for, by its name
        self.form = scene.of(LinkageForm)
        self.made: dict[str, None] = {}  # what was made, in order: the sheet's account of what it left out

    def paced(self, pace: Pace | None) -> LinkageStudy:
        """Study the same positions passed at another pace; what no rate enters is not made again."""
        other = LinkageStudy(self.scene, self.plans, pace)
        kept = ("mechanism", "groups", "assembly", "sweep", "extreme_positions")
        vars(other).update({name: vars(self)[name] for name in kept if name in vars(self)})
        return other

    def at(self, turn: CrankPositions) -> LinkageStudy:
        """Study the same mechanism in other positions than those of its scene."""
        _ = self.sweep  # its assembly is that of the scene's own positions
        other = self.paced(self.pace)
        vars(other)["turn"] = turn
        return other

    def construct(self, plans: Collection[str]) -> None:
        """Make the plans that are asked for, at all positions of the scene."""
        if EXTREMES in plans:
            _ = self.extreme_positions
        self.drafts().plan(max(numbers_of(plans), default=0))

    @cached_property
    def mechanism(self) -> Mechanism:
        """The mechanism of the scene."""
        return mechanism_of(self.scene)

    @cached_property
    def groups(self) -> tuple[Assur, ...]:
        """The Assur groups in solving order."""
        try:
            groups = decompose(self.mechanism)
        except StructureError as error:
            raise StructureError(self._at("links", error), error.links, error.found, error.needed) from None
        if self.mechanism.through and any(KINDS[group.kind].branched for group in groups):
            line, column = self.scene.place(("mechanism", "through"))
            where = f"{self.scene.file}:{line}:{column}: mechanism.through"
            raise StructureError(placed(where, message("structure.through")))
        return groups

    def _at(self, table: str, error: DraftError) -> Message:
        """Say of a table of the mechanism, where it stands in the scene's file, what is wrong."""
        there = table == "links" or bool(self.form.mechanism.sketch)
        line, column = self.scene.place(("mechanism", table) if there else ("mechanism",))
        return placed(f"{self.scene.file}:{line}:{column}: mechanism.{table}", error.args[0])

    @property
    def language(self) -> str:
        """The language of the scene's sheets and messages."""
        return self.scene.sheet.language

    @property
    def sense(self) -> int:
        """Sense of rotation: +1 counter-clockwise, -1 clockwise."""
        return -1 if self.mechanism.drive.omega < 0 else 1

    @property
    def pace(self) -> Pace | None:
        """The rates of the drive at its coordinate: another technique's, or a stroke's own; None: steady ones."""
        return ram.pace(self.mechanism) if self._pace is None else self._pace

    @property
    def rates(self) -> Rates:
        """The rates of the drive, steady or over the positions."""
        return steady(self.mechanism.drive) if self.pace is None else rates_at(self.pace, self.turn.phi)

    @cached_property
    def assembly(self) -> Assembly:
        """The assembly that the sketch chooses."""
        start = None
        if self.first:
            first = Fraction(self.form.drive.first or 0)
            start = listed([first]) if self.mechanism.drive.turns else self.turn.part([0])
        try:
            return assembly(self.mechanism, self.groups, start, self.looks)
        except SketchError as error:
            raise SketchError(self._at("sketch", error), error.points) from None

    @cached_property
    def astray(self) -> dict[str, float]:
        """Points that the sketch shows farther from their places than any of their links is long, and how far, m."""
        if self.assembly.phi is None:
            return {}
        phi, found = np.array([self.assembly.phi]), {}
        plan = self.sweep.positions(CrankPositions(phi, np.exp(1j * phi)))
        for name, shown in self.mechanism.sketch.items():
            bodies = [link.points for link in self.mechanism.links.values() if name in link.points]
            off = abs(complex(np.ravel(plan.point(name).point)[0]) - shown)
            if off > max(abs(at - body[name]) for body in bodies for at in body.values()) > 0:
                found[name] = off
        return found

    @property
    def first(self) -> bool:
        """Whether the sketch shows the first position: not one still to be found, by an extreme or by a length."""
        ram = self.mechanism.drive.ram
        return self.form.drive.first is not None and (ram is None or ram.links is None)

    @cached_property
    def looks(self) -> CrankPositions:
        """Where the mechanism that the sketch shows is sought if it is not at the first position: at whole degrees.

        Of a scene with as many positions at most also at all of them: one may be assembled where no whole degree is.
        """
        table, turns = self.form.drive, self.mechanism.drive.turns or not self.first
        degrees = even(Fraction(0), 360, 1) if turns else ram.positions(self.mechanism, table.stroke, 360)
        if not self.first or len(self.turn) > len(degrees):
            return degrees
        phi = np.concatenate((degrees.phi, self.turn.phi))
        return CrankPositions(phi, np.concatenate((degrees.directions, self.turn.directions)))

    @cached_property
    def sweep(self) -> Sweep:
        """The mechanism with its chosen assembly, ready to be drawn at any crank angle."""
        sweep = Sweep(self.mechanism, self.groups, self.assembly.sides, self.assembly.phi or 0.0)
        return sweep.through() if self.mechanism.through and self.assembly.phi is not None else sweep

    @cached_property
    def barriers(self) -> tuple[Barrier, ...]:
        """What bars a full turn of the crank."""
        return self.sweep.barred

    @cached_property
    def passed(self) -> tuple[Barrier, ...]:
        """The change points that the linkage is carried through; it has no one velocity in them."""
        return tuple(barrier for barrier in self.sweep.barriers if self.sweep.passes(barrier))

    @cached_property
    def output(self) -> Output:
        """The output link."""
        return output(self.mechanism, self.groups)

    @property
    def coupler_point(self) -> str | None:
        """The output's point, if no hinge holds its link to the frame: it goes as the link does not (точка шатуна)."""
        out, links = self.output, self.mechanism.links
        return out.point if links[FRAME].points.keys().isdisjoint(links[out.link].points) else None

    @cached_property
    def extreme_positions(self) -> ExtremePositions | None:
        """The output's extreme positions, None where it has none."""
        self.made.setdefault(EXTREMES)
        try:
            return extremes(self.sweep, self.output)
        except NoWorkingStroke as error:
            line, column = self.scene.place(("output", "working"))
            where = f"{self.scene.file}:{line}:{column}: output.working"
            raise StructureError(placed(where, error.args[0])) from None

    @property
    def travel(self) -> ExtremePositions | None:
        """The output's extreme positions where they are asked for; None also where it has none."""
        return self.extreme_positions if EXTREMES in self.plans else None

    @cached_property
    def turn(self) -> CrankPositions:
        """All crank positions of the scene, and the rates that the crank has in them."""
        return self._turn().paced(self.pace)

    def _turn(self) -> CrankPositions:
        drive = self.form.drive
        if not self.mechanism.drive.turns:
            _ = self.first or self.assembly  # without one assembly no length is that of a position
            return ram.positions(self.mechanism, drive.stroke, drive.count - 1)
        if isinstance(drive.positions, tuple):
            return listed([Fraction(angle) for angle in drive.positions])
        if drive.first is not None:
            return even(Fraction(drive.first), drive.positions, self.sense)
        if self.extreme_positions is None:
            line, _ = self.scene.place(("drive", "start"))
            why = no_extreme(self.sweep, self.output.link, self.assembly.phi is not None)
            raise NoExtreme(placed(f"{self.scene.file}:{line}", why))
        return from_direction(
            self.extreme_positions.directions[0], self.extreme_positions.extremes.phi[0], drive.positions, self.sense
        )

    @cached_property
    def lost(self) -> npt.NDArray[np.bool_]:
        """Positions that the mechanism does not reach, or in which it has no one place."""
        if len(self.turn) <= BLOCK:
            return self.drafts().lost
        return np.concatenate([drafts.lost for drafts, _ in self.blocks()])

    def blocks(self) -> Iterator[tuple[Drafts, slice]]:
        """Give plans block by block, where the positions are more than those of a sheet; they are not kept."""
        for start in range(0, len(self.turn), BLOCK):
            part = slice(start, start + BLOCK)
            yield Drafts(self, self.turn.part(part)), part

    def reached(self, phi: Floats) -> npt.NDArray[np.bool_]:
        """Tell which crank angles the mechanism reaches from the position that the sketch shows."""
        if self.assembly.phi is None:
            return np.zeros(len(phi), dtype=bool)
        return reached(phi, self.assembly.phi, self.barriers)

    @cached_property
    def span(self) -> tuple[float, float]:
        """Crank angles, rad, between which the drive turns: a whole turn, or what listed angles span."""
        if isinstance(self.form.drive.positions, int) and self.mechanism.drive.turns:
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
        phi = np.linspace(low, high, NODES + 1)
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
        if len(self.turn) <= BLOCK:
            drafts = self.drafts()
            drawn = drafts.motion(order)
            return drawn if drafts.free else self._with_gaps(drawn, drafts.lost, drafts.unborne, drafts.clear)
        whole, lost, clear = self._table(order), np.zeros(len(self.turn), dtype=bool), True
        blunt = lost.copy()
        for drafts, part in self.blocks():
            whole.fill(drafts.motion(order), part)
            lost[part], blunt[part] = drafts.lost, drafts.unborne
            clear = clear and drafts.clear
        return self._with_gaps(whole, lost, blunt, clear)

    def _table(self, order: int) -> Motion:
        """Rule the table of a long motion; what is the same at all positions takes no room."""
        phi, first = self.turn.phi, Drafts(self, self.turn.part([0])).motion(order)

        def room(row: npt.NDArray[Any]) -> npt.NDArray[Any]:
            return np.empty(phi.shape, row.dtype) if row.flags.writeable else np.broadcast_to(row[:1], phi.shape)

        return first.made(phi, room)

    def _with_gaps(self, drawn: Motion, lost: Flags, blunt: Flags, clear: bool) -> Motion:
        """Make the positions that are not reached, and what has no value in the rest, named gaps."""
        if clear and not (lost | blunt).any():
            return drawn
        drawn = drawn.own()
        gone = np.flatnonzero(lost).tolist()
        named = gaps_of(self.sweep, self.turn.part(gone), gone, self.assembly.phi, self.barriers)
        for points in drawn.points.values():
            points.r[lost] = np.nan
        for links in drawn.links.values():
            links.angle[lost] = np.nan
        forget(drawn, lost)
        named += without_velocity(drawn, lost, blunt, (*self.barriers, *self.passed))
        return drawn._replace(gaps=tuple(sorted(named, key=attrgetter("position"))))
