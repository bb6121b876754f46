"""The study of the kinematic diagrams: made of the plans, or left out with the reason (кинематические диаграммы)."""

from __future__ import annotations

from collections.abc import Collection
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from plans.diagrams.chords import DIAGRAMS, Chords
from plans.diagrams.course import OutputCourse
from plans.diagrams.form import DiagramsForm
from plans.linkage.study import LinkageStudy
from plans.model.diagrams import MOST, Axis, Diagrams, axis_of, still, unfollowed
from plans.model.motion import Floats
from plans.model.order import ORDERS
from plans.words.words import Message, message

if TYPE_CHECKING:
    from plans.study import Study


class DiagramsStudy:
    """The diagrams of a linkage's output by construction."""

    def __init__(self, linkage: LinkageStudy, wanted: bool) -> None:
        self.linkage, self.wanted = linkage, wanted
        self.made: dict[str, None] = {}

    def construct(self, plans: Collection[str]) -> None:
        """Draw the diagrams, if they are asked for."""
        if DIAGRAMS in plans:
            _ = self.diagrams

    @cached_property
    def axis(self) -> Axis:
        """The positions in the order in which the crank passes them."""
        study = self.linkage
        edges = [edge for barrier in study.barriers for edge in (barrier.start, barrier.end)]
        return axis_of(study.turn.phi, study.sense, study.lost, edges, self.whole)

    @property
    def whole(self) -> bool:
        """Whether the scene divides a whole turn evenly."""
        return isinstance(self.linkage.form.drive.positions, int)

    @cached_property
    def course(self) -> OutputCourse:
        """The output's course, read off the plans."""
        return OutputCourse(self.linkage, self.axis)

    @cached_property
    def chords(self) -> Chords:
        """The curves of v and a by chords."""
        return Chords(self.axis, self.course.positions.s, self.course.omega)

    @property
    def units(self) -> tuple[str, str, str]:
        """The units of the coordinate, its velocity and acceleration."""
        sliding = self.course.travel.sliding
        first, second, third = ((order.point if sliding else order.link).unit for order in ORDERS)
        return first, second, third

    @property
    def counted(self) -> str:
        """From what the output's way is counted: a working stroke, its least value, or an even turn."""
        if self.linkage.extreme_positions is not None:
            return "working"
        return "ahead" if self.course.count.turns else "least"

    @cached_property
    def left_out(self) -> Message | None:
        """Say why there are no diagrams; None where there are some."""
        found = self.unfit or unfollowed(self.axis)
        return found or still(self.course.positions, self.course.count, self.course.omega, self.linkage.output.link)

    @property
    def unfit(self) -> Message | None:
        """See that one scale of time holds for all positions, and that they can be drawn."""
        drive = self.linkage.mechanism.drive
        if not drive.turns:
            return message("diagrams.drive")
        if self.linkage.pace is not None or drive.omega == 0:
            return message("diagrams.paced" if self.linkage.pace else "diagrams.rest")
        return message("diagrams.many", most=MOST) if self.linkage.form.drive.count > MOST else None

    @property
    def shown(self) -> bool:
        """Whether there are diagrams, and the scene wants them."""
        return self.wanted and self.left_out is None

    @cached_property
    def diagrams(self) -> Diagrams | None:
        """The diagrams; None where they are not wanted, or left out."""
        return self.drawn if self.shown else None

    @cached_property
    def drawn(self) -> Diagrams:
        """The diagrams, where they are not left out, wanted or not."""
        self.made.setdefault(DIAGRAMS)
        course, axis, chords = self.course, self.axis, self.chords
        speeds = _where(axis.joined, course.at(axis.middles).v)
        growths = _where(axis.between, course.at(axis.places).even(course.lead))
        return Diagrams(
            by="construction",
            axis=axis,
            count=course.count,
            lead=course.lead,
            at=course.positions,
            speeds=chords.of_speed,
            growths=chords.of_growth,
            true_speeds=speeds,
            true_growths=growths,
        )


def _where(there: np.ndarray, values: Floats) -> Floats:
    return np.asarray(np.where(there, values, np.nan))


def study_of(study: Study) -> DiagramsStudy:
    """Make the study of a scene's diagrams (row of the table of techniques)."""
    return DiagramsStudy(study["linkage"], study.scene.of(DiagramsForm).sheet.diagrams)
