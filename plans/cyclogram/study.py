"""The study of a cyclogram: the characteristic positions of the main mechanism, made once (циклограмма)."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property

import numpy as np

from geometry.board import Board
from plans.cam.reading.cams import cams_of
from plans.cyclogram.reading import task_of
from plans.cyclogram.stations import Stations
from plans.forces.loading import output_at
from plans.linkage.primary import CrankPositions
from plans.linkage.study import LinkageStudy, obstruction
from plans.linkage.travel import ExtremePositions, extremes
from plans.model.cam import Cam
from plans.model.cyclogram import BEGIN, END, TURN, Along, Cyclogram, CyclogramTask, Window
from plans.model.mechanism import Output, StructureError
from plans.scene.faults import Path
from plans.scene.scene import Scene
from plans.words.words import Message, message, placed

CYCLOGRAM = "cyclogram"
TWICE = 2  # an output that reverses more often has no one working stroke to come back over


class NoCyclogram(StructureError):  # noqa: N818  (the exception tree's own word)
    """A tool that does not go there and back once in a turn, or an overrun that leaves nothing of its stroke."""


class CyclogramStudy:
    """The main mechanism of a machine in its characteristic positions."""

    def __init__(self, scene: Scene, linkage: LinkageStudy) -> None:
        self.scene, self.linkage = scene, linkage
        self.task: CyclogramTask = task_of(scene)
        self.made: set[str] = set()

    def construct(self, plans: Collection[str]) -> None:
        """Find the characteristic positions, if they are asked for."""
        if CYCLOGRAM in plans:
            _ = self.cyclogram

    @cached_property
    def output(self) -> Output:
        """The link that bears the tool: the output, unless the scene names a point of another."""
        output, name = self.linkage.output, self.task.point
        if not name:
            return output
        if name in self.linkage.mechanism.links[output.link].points:
            return output._replace(point=name)
        shown = output_at(self.linkage.mechanism, name)
        assert shown is not None  # the survey has seen to it
        return shown

    @cached_property
    def reached(self) -> ExtremePositions:
        """The extreme positions of the tool."""
        linkage = self.linkage
        found = linkage.extreme_positions if self.output == linkage.output else extremes(linkage.sweep, self.output)
        if found is None:
            why = obstruction(linkage.sweep) if linkage.barriers else message("extreme.turns")
            raise self._refused((CYCLOGRAM,), message("cyclogram.no_extreme", link=self.output.link, why=why))
        if len(found.rests) > TWICE:
            raise self._refused((CYCLOGRAM,), message("cyclogram.reverses", count=len(found.rests)))
        self._check(found)
        return found

    @cached_property
    def stations(self) -> Stations:
        """The way from the tool back to the crank."""
        return Stations(self.linkage.sweep, self.output, self.reached, self.task)

    @cached_property
    def cyclogram(self) -> Cyclogram:
        """The characteristic positions."""
        self.made.add(CYCLOGRAM)
        return self.stations.cyclogram

    @cached_property
    def pictured(self) -> LinkageStudy:
        """The linkage in its characteristic positions, to be drawn as those of a scene are."""
        turned = np.array([position.turned for position in self.cyclogram.positions])
        phi = np.asarray(self.cyclogram.sense * (turned[0] + (turned - turned[0]) % TURN))  # each goes on from the last
        linkage, found = self.linkage, self.cyclogram
        other = LinkageStudy(linkage.scene, linkage.plans)
        drive = linkage.form.drive.changed(positions=len(found.positions))
        other.form = linkage.form.changed(drive=drive)
        directions = np.exp(1j * phi)
        for role, exact in zip((BEGIN, END), self.reached.directions, strict=True):
            directions[found.number(role)] = exact
        replaced = {"output": self.output, "extreme_positions": self.reached, "turn": CrankPositions(phi, directions)}
        kept = {name: getattr(linkage, name) for name in ("mechanism", "groups", "assembly", "sweep")}
        vars(other).update(replaced | kept)
        return other

    @property
    def window(self) -> Window:
        """When an auxiliary mechanism may move: the tool is off the work."""
        return self.cyclogram.window

    @cached_property
    def cams(self) -> tuple[Cam, ...]:
        """The cams on the main shaft, if the scene has some; they may take their angles from the window."""
        return cams_of(self.scene, self.window) if self.scene.has(("cam",)) else ()

    @property
    def boards(self) -> tuple[Board, ...]:
        """The boards of the notches."""
        plans = (self.stations.plan, self.stations.watching)
        return tuple(plan.board for plan in plans if plan is not None)

    def _check(self, found: ExtremePositions) -> None:
        """See that what the scene gives of the stroke lies on it."""
        places: list[tuple[Path, Along]] = [(("overrun",), along) for along in self.task.overrun]
        places += [(("breaks", k), along) for k, along in enumerate(self.task.breaks)]
        stroke, sliding = found.extremes.stroke, found.extremes.sliding
        for path, along in places:
            if along.length and not sliding:
                raise self._refused((CYCLOGRAM, *path), message("cyclogram.swings", link=self.output.link))
            if not along.share(stroke) < 1:
                size, whole = (f"{1000 * length:.5g}" for length in (along.size, stroke))
                raise self._refused((CYCLOGRAM, *path), message("cyclogram.beyond", size=size, stroke=whole))
        if sum(along.share(stroke) for along in self.task.overrun) >= 1:
            raise self._refused((CYCLOGRAM, "overrun"), message("cyclogram.no_work", stroke=f"{1000 * stroke:.5g}"))

    def _refused(self, path: Path, why: Message) -> NoCyclogram:
        line, column = self.scene.place(path)
        where = f"{self.scene.file}:{line}:{column}: {'.'.join(map(str, path[:2]))}"
        return NoCyclogram(placed(where, why))
