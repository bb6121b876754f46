"""The kinematic diagrams: made of the plans, or left out with the reason (кинематические диаграммы)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from geometry.board import Board
from geometry.calculus import Derivative, derivative_by_chords
from geometry.strips import ordinates
from plans.linkage.drafts import Drafts
from plans.linkage.primary import CrankPositions
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import at_angles
from plans.linkage.travel import OutputTravel
from plans.model.diagrams import MOST, TURN, Axis, Count, Diagrams, OutputRates, axis_of, still, unfollowed
from plans.model.motion import ORDERS, Floats
from plans.scene import fields as f
from plans.scene.scene import TechniqueForm
from plans.scene.tables import Table, key, table
from plans.words.calculus import REASONS
from plans.words.words import Message, message


class DiagramsTable(Table):
    """Of the sheet whether it shows the diagrams."""

    diagrams: bool = key(
        f.FLAG,
        True,
        meaning="Whether the kinematics sheet shows S(φ), v(φ), a(φ) of the output (кинематические диаграммы) and the "
        "table of them.",
    )


class DiagramsForm(TechniqueForm):
    """What a scene says of the diagrams."""

    sheet: DiagramsTable = key(table(DiagramsTable), DiagramsTable(), meaning="What of the output's course is shown.")


NODES = 720  # of the axis at least: between two of them no link turns half round


class OutputCourse:
    """The output of a study over the axis of its diagrams, by construction."""

    def __init__(self, study: LinkageStudy, axis: Axis) -> None:
        self.study, self.axis = study, axis
        self.travel = OutputTravel(study.sweep, study.output)
        drive = study.mechanism.drive
        self.omega = abs(drive.omega)
        self.lead = drive.epsilon / drive.omega if drive.omega else 0.0

    @cached_property
    def positions(self) -> OutputRates:
        """The course at the positions of the axis, read off the plans that are there, (M,)."""
        motion = self.study.motion()
        chosen = list(self.axis.numbers)
        return self._counted(self.axis.turned, [row[chosen] for row in self.travel.rows(motion)])

    def at(self, turned: Floats) -> OutputRates:
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

    def _counted(self, turned: Floats, rows: Sequence[Floats]) -> OutputRates:
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


DIAGRAMS = "diagrams"
SPEED, GROWTH = "v", "a"  # the names of the curves on the board


@dataclass(frozen=True, eq=False, repr=False)
class ChordCurves:
    """The curves of v and a drawn by chords over an axis, from S at its positions; the crank turns with omega > 0.

    Abscissas are crank angles, rad, and the pole distance is the angle of a second, omega: the ordinates are v and a.
    """

    axis: Axis
    s: Floats  # (M,)
    omega: float

    @cached_property
    def board(self) -> Board:
        """The board that they are drawn on."""
        return Board(DIAGRAMS)

    @cached_property
    def speeds(self) -> tuple[Derivative, ...]:
        """The curve of v, one for each run of positions."""
        return tuple(self._speeds())

    def _speeds(self) -> Iterator[Derivative]:
        for number, run in enumerate(self.axis.runs, 1):
            name = _named(SPEED, number)
            yield derivative_by_chords(self.board, name, self.axis.turned[run], self.s[run], self.omega, why=REASONS)

    @cached_property
    def growths(self) -> tuple[Derivative | None, ...]:
        """The curve of a, one for each run; None where the run has one chord alone."""
        return tuple(self._growth(k, run) for k, run in enumerate(self.axis.runs))

    def _growth(self, k: int, run: slice) -> Derivative | None:
        x, v = self.speeds[k].middles, ordinates(self.speeds[k].points)
        if self.axis.closed:  # what the turn began with goes on beyond its end
            x, v = np.append(x, x[0] + TURN), np.append(v, v[0])
        if len(x) < 2:
            return None
        return derivative_by_chords(self.board, _named(GROWTH, k + 1), x, v, self.omega, why=REASONS)

    @property
    def of_speed(self) -> Floats:
        """v over the middles of the parts, (M - 1,); NaN where no chord is drawn."""
        values = np.full(len(self.axis.turned) - 1, np.nan)
        for run, drawn in zip(self.axis.runs, self.speeds, strict=True):
            values[run.start : run.stop - 1] = ordinates(drawn.points)
        return values

    @property
    def of_growth(self) -> Floats:
        """a over the places of the axis, (M,); NaN where no chord is drawn."""
        values = np.full(len(self.axis.turned), np.nan)
        for run, drawn in zip(self.axis.runs, self.growths, strict=True):
            if drawn is not None:
                heights = ordinates(drawn.points)
                values[run.start + 1 : run.start + 1 + len(heights)] = heights
        if self.axis.closed:
            values[0] = values[-1]
        return values


def _named(letter: str, number: int) -> str:
    return letter if number == 1 else f"{letter}_{number}"


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
    def chords(self) -> ChordCurves:
        """The curves of v and a by chords."""
        return ChordCurves(self.axis, self.course.positions.s, self.course.omega)

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
