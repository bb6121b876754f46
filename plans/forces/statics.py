"""The statics of a study: its force plans over all positions, each made once, when asked for (кинетостатика)."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from plans.forces.drive import balancing_quantity, joined, push, with_cylinder, without
from plans.forces.force_template import ForceDrawing, ForcePattern, ForcePlans
from plans.forces.loading import ROUNDING, NoStroke, OtherStroke, OutputStroke, asks, counted, loading, strokes
from plans.forces.reading.form import ForceForm
from plans.forces.reading.inventory import machine_of
from plans.linkage.drafts import Drafts, near_edge
from plans.linkage.motion_plans import PlanTemplate
from plans.linkage.study import BLOCK, LinkageStudy, obstruction
from plans.linkage.sweep import RedrawnPlans, at_angles
from plans.linkage.travel import ExtremePositions, extremes
from plans.model.dyad import Pair, pairs
from plans.model.kinetostatics import Friction, Kinetostatics, Loading, without_forces
from plans.model.machine import IDLE, WORKING, Diagram, Force, Machine, Moment, Track
from plans.model.mechanism import NoWorkingStroke, Output, StructureError, frame_way
from plans.model.motion import (
    CHANGE_POINT,
    DEAD_CENTRE,
    FORCES,
    INDETERMINATE,
    VELOCITIES,
    Complexes,
    Extremes,
    Floats,
    Gap,
    Motion,
)
from plans.scene.faults import SceneError, dotted
from plans.scene.scene import Scene
from plans.words.words import Message, message, placed


def off_their_lines(machine: Machine, motion: Motion) -> Iterator[tuple[int, Force]]:
    """Give the forces between two links that are off the line they are told to act along, each with its number."""
    places = [np.nanmax(np.abs(point.r), initial=0.0) for point in motion.points.values()]
    for index, force in enumerate(machine.forces):
        if told_line(force) and _off(force, motion) > ROUNDING * max(places):
            yield index, force


def check_lines(scene: Scene, machine: Machine, motion: Callable[[int], Motion]) -> None:
    """See that forces between two links act along lines that their points lie on; `motion` makes that of an order."""
    if not any(map(told_line, machine.forces)):
        return
    off = list(off_their_lines(machine, motion(0)))
    if off:
        paths = [(("loads", "forces", index, "direction"), "".join(force.line or ())) for index, force in off]
        raise SceneError(scene.fault(path, "off_line", line=line) for path, line in paths)


def told_line(force: Force) -> bool:
    """Tell whether a force between two links acts along a line of other points than its own."""
    if force.other is None or force.line is None:
        return False
    return {*force.line} != {force.point, force.other.point}


def _off(force: Force, motion: Motion) -> float:
    """Give how far m the line is from either point of a force, at the position where it is farthest."""
    assert force.line is not None  # it is told
    assert force.other is not None

    def place(point: str) -> Complexes:
        return motion.points[point].r

    start, end = map(place, force.line)
    way = (end - start).conj()
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
        across = [((place(point) - start) * way).imag / np.abs(way) for point in (force.point, force.other.point)]
    return float(np.nanmax(np.abs(across), initial=0.0))


CONSTANT = Diagram((0.0, 1.0), (1.0, 1.0))  # over a stroke, there and back
Reached: TypeAlias = Callable[[Output], Extremes | None]
ADVICE = {INDETERMINATE: message("gap.indeterminate"), DEAD_CENTRE: message("gap.no_force")}


class ForceDrafts:
    """The force plans over some positions of a study, over the plans of its motion there."""

    def __init__(self, statics: Statics, drafts: Drafts) -> None:
        self.statics, self.drafts = statics, drafts

    @cached_property
    def _below(self) -> tuple[PlanTemplate | RedrawnPlans, list[Any]]:
        return self.drafts.follow(2)

    @cached_property
    def _followed(self) -> tuple[ForcePattern | ForceDrawing, Any]:
        _, numbers = self._below
        found = self.statics.pattern
        return found, found.follow(numbers, self.loading)

    @cached_property
    def motion(self) -> Motion:
        """The motion at these positions, reached or not."""
        pattern, numbers = self._below
        return pattern.read(numbers, self.drafts.turn)

    @cached_property
    def loading(self) -> Loading:
        """The loads at these positions."""
        return self.statics.loading(self.motion)

    @cached_property
    def plans(self) -> ForcePlans:
        """The force plan and the lever, their marks made."""
        pattern, numbers = self._followed
        return pattern.plans_of(numbers)

    def read(self) -> tuple[Kinetostatics, npt.NDArray[np.bool_]]:
        """Read the forces off the plans; tell where they have no answer."""
        pattern, numbers = self._followed
        turn = self.drafts.turn
        found = pattern.read(numbers, turn.phi)
        return found, pattern.singular(numbers, len(turn))


class Statics:
    """The forces of a study; nothing is made before it is asked for."""

    def __init__(self, study: LinkageStudy) -> None:
        self.study = study
        self.form = study.scene.of(ForceForm)
        self.made: dict[str, None] = {}  # what was made, in order

    def bearing(self, machine: Machine) -> Statics:
        """Study the same positions of a machine with other masses, or loads."""
        other = Statics(self.study)
        vars(other)["machine"] = machine
        return other

    def construct(self, plans: Collection[str]) -> None:
        """Find the forces at all positions of the scene."""
        if "forces" in plans:
            _ = self.forces

    @cached_property
    def machine(self) -> Machine:
        """Masses, loads, drive and friction of the scene."""
        scene = self.study.scene
        machine = machine_of(scene, self.study.mechanism)
        borne = any(body.mass or body.inertia for body in machine.bodies.values())
        if not (borne or machine.forces or machine.moments or machine.springs):
            raise SceneError([scene.fault(("sheets",), "nothing_acts")])
        check_lines(scene, machine, self.study.motion)
        return machine

    @cached_property
    def pairs(self) -> tuple[Pair, ...]:
        """The lower pairs of the mechanism, in solving order."""
        return pairs(self.study.mechanism, self.study.groups)

    @cached_property
    def strokes(self) -> Mapping[Track, OutputStroke]:
        """The strokes over which loads change, by construction."""
        return self.over(self._extremes)

    def level(self, extremes: Reached | None = None) -> tuple[Machine, dict[Track, OutputStroke]]:
        """Give the constant forces against the motion of sliders alone, as over their strokes, by either road."""
        sliding = (load for load in self.machine.forces if frame_way(self.study.mechanism, load.link))
        against = (load for load in sliding if not asks(load) and load.direction is None and load.line is None)
        forces = tuple(load._replace(diagram=CONSTANT, stroke=Track(load.point)) for load in against)
        machine = replace(self.machine, forces=forces, moments=())
        return machine, self.over(extremes or self._extremes, machine)

    def over(self, extremes: Reached, machine: Machine | None = None) -> dict[Track, OutputStroke]:
        """Find the strokes over which loads change by the extreme positions of either road."""
        study = self.study
        try:
            return strokes(machine or self.machine, study.mechanism, study.output, extremes)
        except NoStroke as error:
            why = error.args[0]
            if study.barriers and study.mechanism.drive.turns:
                why = message("stroke.barred", load=error.load, thing=error.thing, why=obstruction(study.sweep))
            raise self._refused(why) from None
        except OtherStroke as error:
            index = self.machine.forces.index(error.load)
            raise self._refused(error.args[0], "forces", index, "diagram", "travel") from None
        except NoWorkingStroke as error:
            raise self._refused(error.args[0]) from None

    def _refused(self, why: Message, *at: str | int) -> StructureError:
        """Say what is wrong with the loads of the scene, or with a part of them."""
        scene, path = self.study.scene, ("loads", *at)
        line, column = scene.place(path)
        return StructureError(placed(f"{scene.file}:{line}:{column}: {dotted(path)}", why))

    def _extremes(self, output: Output) -> Extremes | None:
        found = self.reached(output)
        return None if found is None else found.extremes

    def reached(self, output: Output) -> ExtremePositions | None:
        """Find the extreme positions of an output by construction, with all its rests."""
        return self.study.extreme_positions if output == self.study.output else extremes(self.study.sweep, output)

    @property
    def reversals(self) -> Iterator[tuple[Force | Moment, tuple[float, ...]]]:
        """The loads of one stroke alone whose output reverses within a stroke, and the crank angles of its rests."""
        for load in self.machine.loads:
            shown = counted(self.study.mechanism, load, self.study.output) if load.during in (WORKING, IDLE) else None
            found = self.reached(shown) if shown else None
            if found is not None and len(found.rests) > 2:
                yield load, found.rests

    def loading(self, motion: Motion) -> Loading:
        """Give the loads at the positions of a motion."""
        return self.loading_over(motion, self.strokes)

    def loading_over(self, motion: Motion, strokes: Mapping[Track, OutputStroke]) -> Loading:
        """Give the loads at the positions of a motion of either road, with the strokes that it finds."""
        return with_cylinder(self.study.mechanism, self.machine, motion, loading(self.machine, motion, strokes))

    def given(
        self, forces: Kinetostatics, motion: Motion, strokes: Mapping[Track, OutputStroke] | None = None
    ) -> Floats:
        """Give what is told of the drive over the positions: the moment of a crank, the force of a slide or a cylinder.

        See `balancing_quantity`; the strokes are those that the road of the motion finds.
        """
        mechanism, machine = self.study.mechanism, self.machine
        if mechanism.drive.ram is None:
            return balancing_quantity(mechanism.drive).share * forces.balancing.moment
        loads = loading(machine, motion, self.strokes if strokes is None else strokes)
        return np.where(np.isnan(forces.balancing.moment), np.nan, push(mechanism, machine, motion, loads))

    @cached_property
    def pattern(self) -> ForcePattern | ForceDrawing:
        """The force plan drawn at one position, to be followed at all."""
        self.made.setdefault("forces")
        drafts = self.study.drafts([0])
        pattern, _ = drafts.follow(2)
        if isinstance(pattern, RedrawnPlans):
            return ForceDrawing(self.study.groups, self.machine)
        return ForcePattern(pattern, self.study.groups, self.machine, self.loading(drafts.motion(2)))

    def drafts(self, chosen: slice | Sequence[int] = slice(None)) -> ForceDrafts:
        """Give the force plans over some positions; those of the same positions are the same."""
        key = repr(chosen)
        if key not in self._drafts:
            self._drafts[key] = ForceDrafts(self, self.study.drafts(chosen))
        return self._drafts[key]

    @cached_property
    def _drafts(self) -> dict[str, ForceDrafts]:
        return {}

    def around(self, steps: int) -> Kinetostatics:
        """Give the forces over a whole turn from the first position on, in even steps; NaN where there are none.

        Of a drive over a stroke they are those over the stroke.
        """
        drafts = self._around(steps)
        found, none = ForceDrafts(self, drafts).read()
        return without(found, none | drafts.lost)

    def given_around(self, steps: int, forces: Kinetostatics) -> Floats:
        """Give what is told of the drive where `around` gives the forces."""
        return self.given(forces, self._around(steps).motion(2))

    def _around(self, steps: int) -> Drafts:
        study = self.study
        first, last = study.turn.phi[0], study.turn.phi[-1]
        whole = study.sense * 2 * np.pi if study.mechanism.drive.turns else last - first
        phi = first + whole * np.arange(steps + 1) / steps
        return Drafts(study, at_angles(phi).paced(study.pace))

    @cached_property
    def forces(self) -> Kinetostatics:
        """All reactions and the balancing moment over all positions, what has none left out and named."""
        found, free = [], True
        for part in self.parts():
            found.append(part.read())
            free = free and part.drafts.free
        whole, none = joined([forces for forces, _ in found]), np.concatenate([singular for _, singular in found])
        if free and not none.any():
            return whole
        gaps, lost = self.study.motion(2).gaps, np.zeros(len(whole.phi), dtype=bool)
        lost[[gap.position for gap in gaps]] = True
        none &= ~lost
        still = [self._gap(gap.position, without_forces(gap), gap.where) for gap in gaps if gap.plan == VELOCITIES.plan]
        where = message("place.force_plan")
        named = [*gaps, *still, *(self._gap(k, self._reason(k), where) for k in np.flatnonzero(none).tolist())]
        return replace(without(whole, lost | none), gaps=tuple(sorted(named, key=lambda gap: gap.position)))

    def parts(self) -> Iterator[ForceDrafts]:
        """Give the force plans over all positions, in blocks where these are more than those of a sheet."""
        if len(self.study.turn) <= BLOCK:
            yield self.drafts()
        else:  # one block after another is made and read, and none is kept
            yield from (ForceDrafts(self, drafts) for drafts, _ in self.study.blocks())

    @property
    def friction(self) -> Friction | None:
        """What friction takes, by construction; None where the scene gives no coefficients."""
        return self.losses if self.machine.friction else None

    @cached_property
    def losses(self) -> Friction:
        """What friction takes, by construction; nothing where the scene gives no coefficients."""
        from plans.forces.friction import friction  # noqa: PLC0415  (only a scene with friction pays for it)

        study, motion = self.study, self.study.motion(2)
        loads = self.loading(motion)
        return friction(study.mechanism, study.groups, self.machine, motion, loads, self.forces, study.turn.times)

    def _reason(self, position: int) -> str:
        """Say why a position that has velocities has no forces."""
        changes = [b for b in (*self.study.barriers, *self.study.passed) if b.kind == CHANGE_POINT]
        near = near_edge(self.study.turn.phi[[position]], changes, (CHANGE_POINT,)).any()
        return INDETERMINATE if near else DEAD_CENTRE

    def _gap(self, position: int, reason: str, where: str | Message) -> Gap:
        """Name a position that can be assembled, but has no forces."""
        return Gap(position, float(self.study.turn.phi[position]), FORCES, reason, where, 0.0, ADVICE[reason])
