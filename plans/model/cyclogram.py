"""The cyclogram of a machine (циклограмма): characteristic positions of its main mechanism, and rows over the turn.

Values alone, SI and radians. The turn φ of the main shaft is counted from the x axis in the sense of its rotation.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from plans.model.mechanism import Output, Way
from plans.model.motion import Gap

TURN = 2 * math.pi
CONSTRUCTION, ANALYSIS = "construction", "analysis"
# What a characteristic position is: both extremes, the tool's way into and out of the work, a change of the load, an
# extreme of the pressure angle, the tool on its way back over an end of the work.
BEGIN, ENTRY, BREAK, EXIT, END, PRESSURE, BACK, LEAVE = (
    "begin",
    "entry",
    "break",
    "exit",
    "end",
    "pressure",
    "back",
    "leave",
)
# An extreme of the pressure angle so near the end of a stroke, rad, is that extreme position: half a degree, less than
# can be told apart on a sheet.
BESIDE = math.radians(0.5)
# An angle that is so little short of a whole turn, rad, is none: the turns that it is a difference of were found as
# zeros of a speed, each to far more than nine digits, and no sheet shows the tenth.
SLIVER = 1e-9


class Along(NamedTuple):
    """A place or a way along the stroke from where the working stroke begins: a share of it, or a length m."""

    size: float
    length: bool = False

    def share(self, stroke: float) -> float:
        """Give it as a share of a stroke m."""
        return self.size / stroke if self.length else self.size


class CyclogramTask(NamedTuple):
    """What is asked for: the point of the tool, the overrun at both ends of its stroke, where the load changes."""

    point: str  # "": that of the output
    overrun: tuple[Along, Along]
    breaks: tuple[Along, ...] = ()


class Stop(NamedTuple):
    """A place of the tool that is asked for: its role, its share of the stroke, and whether on the way back."""

    role: str
    share: float
    back: bool = False


class Watched(NamedTuple):
    """The two links whose pressure angle is watched: their hinge, and where each of them is hung.

    A rod on a guide of the frame is hung once: instead of the second hinge it has the guide's line.
    """

    links: tuple[int, int]
    pin: str
    hung: tuple[str, str]
    way: Way | None = None


class Position(NamedTuple):
    """A characteristic position (характерное положение): its role, the turn of the main shaft, where the tool is.

    `share` is of the stroke, `place` the tool's coordinate: m along its guide, or rad; `angle` is the pressure angle
    rad where that is extreme. `condition` is how many times a share of the stroke moves a share of the turn there.
    """

    role: str
    turned: float  # rad, from 0 to a whole turn
    share: float
    place: float
    back: bool = False
    angle: float | None = None
    condition: float = 1.0
    slack: float = 0.0  # rad: how far rounding can have moved the turn
    notched: bool = True  # whether it was found by notches from the tool, not by trial on the travel


class Window(NamedTuple):
    """A part of the turn of the main shaft in which an auxiliary mechanism may move: rad, the end after the start."""

    start: float
    end: float

    @property
    def angle(self) -> float:
        """How long it is, rad: of a cam the phase of rise (фазовый угол удаления)."""
        return self.end - self.start

    @property
    def rest(self) -> float:
        """What is left of the turn, rad."""
        return TURN - self.angle


@dataclass(frozen=True)
class Cyclogram:
    """The characteristic positions of a main mechanism by one road, in the order of the turn from the first extreme."""

    by: str
    output: Output
    sense: int  # of the main shaft: +1 counter-clockwise
    stroke: float  # H m, or the swing rad
    sliding: bool
    overlap: float  # rad
    positions: tuple[Position, ...] = field(default=())

    def of(self, role: str) -> tuple[Position, ...]:
        """Give the positions of a role."""
        return tuple(position for position in self.positions if position.role == role)

    def number(self, role: str) -> int:
        """Give the number of the first position of a role."""
        return next(k for k, position in enumerate(self.positions) if position.role == role)

    @property
    def window(self) -> Window:
        """When the tool is off the work: about the beginning of the working stroke, or else about its end."""
        ends = (LEAVE, ENTRY) if self.of(LEAVE) else (EXIT, BACK)
        start, end = (self.of(role)[0].turned for role in ends)
        return Window(start, start + (end - start) % TURN)

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """It has no gaps: what cannot be found is refused."""
        return ()


class Period(NamedTuple):
    """A part of a row: from one turn of the main shaft to another, rad, the end after the start; what is done then."""

    start: float
    end: float
    kind: str
    label: str = ""


class BarRow(NamedTuple):
    """A mechanism over the turn of the main shaft: its name, what it does then, and its setting angle rad, if any."""

    name: str
    spans: tuple[Period, ...]
    setting: float | None = None


def within(turned: float) -> float:
    """Take whole turns off an angle: from 0 to less than a whole turn, by more than a sliver."""
    found = turned % TURN
    return 0.0 if TURN - found <= SLIVER else found


def pieces(span: Period, begin: float = 0.0) -> Iterator[Period]:
    """Cut a span where a turn from `begin` starts anew; its parts are counted from there, 0 to a whole turn.

    >>> [(round(one.start, 3), round(one.end, 3)) for one in pieces(Period(6.0, 7.0, "rise"))]
    [(6.0, 6.283), (0.0, 0.717)]
    """
    start = within(span.start - begin)
    end = start + (span.end - span.start)
    yield span._replace(start=start, end=min(end, TURN))
    if end > TURN + SLIVER:
        yield span._replace(start=0.0, end=end - TURN)
