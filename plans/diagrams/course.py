"""The output's course read off the plans at any crank angles: S or psi, v, a, counted as the diagrams do (перемещение).

S is counted from where the working stroke begins, in its sense; without such a stroke from the least at the positions.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from plans.linkage.assembly_limits import at_angles
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.drafts import Drafts
from plans.linkage.study import LinkageStudy
from plans.linkage.travel import Travel
from plans.model.diagrams import TURN, Axis, Count, Course
from plans.model.motion import Floats

NODES = 720  # of the axis at least: between two of them no link turns half round


class OutputCourse:
    """The output of a study over the axis of its diagrams, by construction."""

    def __init__(self, study: LinkageStudy, axis: Axis) -> None:
        self.study, self.axis = study, axis
        self.travel = Travel(study.sweep, study.output)
        drive = study.mechanism.drive
        self.omega = abs(drive.omega)
        self.lead = drive.epsilon / drive.omega if drive.omega else 0.0

    @cached_property
    def positions(self) -> Course:
        """The course at the positions of the axis, read off the plans that are there, (M,)."""
        motion = self.study.motion()
        chosen = list(self.axis.numbers)
        return self._counted(self.axis.turned, [row[chosen] for row in self.travel.rows(motion)])

    def at(self, turned: Floats) -> Course:
        """Give the course at angles of the axis that are reached, (N,); NaN where there is none."""
        drafts = Drafts(self.study, self._turn(turned))
        s, *rates = self.travel.rows(drafts.motion(2))
        gone = drafts.lost | drafts.unborne | np.isnan(turned)
        return self._counted(turned, [s, *(np.where(gone, np.nan, row) for row in rates)])

    @cached_property
    def count(self) -> Count:
        """How the output's way is counted."""
        found, (_, along) = self.study.extreme_positions, self._path
        if found is not None:
            first, last = found.extremes.reach
            sense, off = (1.0 if last > first else -1.0), 0.0
            if not self.travel.sliding:  # the path is counted from anywhere: bring it over the swing
                middle = (float(along.max()) + float(along.min())) / 2
                off = TURN * round((middle - (first + last) / 2) / TURN)
            return Count(first + off, sense)
        turns = round(float(along[-1] - along[0]) / TURN) if self.axis.closed and not self.travel.sliding else 0
        raw = self._unwrapped(self.axis.turned, self.travel.rows(self.study.motion(0))[0][list(self.axis.numbers)])
        if turns:
            return Count(float(np.mean((raw - turns * self.axis.turned)[:-1])), 1.0, turns)
        return Count(float(np.nanmin(raw)))

    def _counted(self, turned: Floats, rows: Sequence[Floats]) -> Course:
        return self.count.course(turned, (self._unwrapped(turned, rows[0]), *rows[1:]), self.omega)

    def _turn(self, turned: Floats) -> CrankPositions:
        """Give the crank at angles of the axis; at an angle that is none, where the axis begins."""
        return at_angles(self.axis.start + self.study.sense * np.nan_to_num(turned))

    def _unwrapped(self, turned: Floats, along: Floats) -> Floats:
        """Bring an angle to the branch that it has on the way there."""
        if self.travel.sliding:
            return along
        near = np.interp(turned, *self._path)
        return np.asarray(near + np.angle(np.exp(1j * (along - near))))

    @cached_property
    def _path(self) -> tuple[Floats, Floats]:
        """The coordinate close to each other over all that the crank passes, an angle unwrapped."""
        nodes = self.axis.fine(NODES)
        along = self.travel.rows(self.study.sweep.motion(self._turn(nodes), 0))[0]
        return nodes, along if self.travel.sliding else np.unwrap(along)
