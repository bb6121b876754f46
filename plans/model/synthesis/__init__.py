"""What a mechanism must do, and the lengths that do it, whichever road found them (кинематический синтез).

Values alone, SI: m, rad. A rocker turns about C = 0, its middle position straight up; of a slider the middle of the
stroke is 0, its guide the x axis, and the crank's pivot O lies left of it, not above the guide.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from typing import Final, NamedTuple

from plans.model.motion import Gap

EPS: Final = 2.0**-52
CONSTRUCTION, ANALYSIS = "construction", "analysis"
QUARTER: Final = math.pi / 2
TOWARDS, BEYOND = 1, -1  # the centre M of the circle on the rocker's side of the chord, or beyond it
CENTRES: Final = {TOWARDS: "M", BEYOND: "M'"}  # of the circles, by their sides


def overlap_of(ratio: float) -> float:
    """Give the overlap angle rad of a coefficient of mean speeds K.

    >>> round(math.degrees(overlap_of(1.5)), 6)
    36.0
    """
    return math.pi * (ratio - 1) / (ratio + 1)


class RockerTask(NamedTuple):
    """A crank-rocker is wanted: length of its rocker m, swing psi and overlap theta rad (угол перекрытия).

    One parameter is free: the frame m, or the angle rad at M of the ray to O; without either the least transmission
    angle is to be largest. Either is asked of one circle of the two, by its side.
    """

    rocker: float
    swing: float
    overlap: float
    frame: float | None = None
    place: float | None = None
    side: int | None = None

    @property
    def half(self) -> float:
        """Half of the chord between the extreme places of the rocker's end, m."""
        return self.rocker * math.sin(self.swing / 2)

    @property
    def height(self) -> float:
        """The distance of the chord from C, m."""
        return self.rocker * math.cos(self.swing / 2)

    @property
    def sides(self) -> tuple[int, ...]:
        """The circles that O may lie on."""
        return (TOWARDS, BEYOND) if self.side is None else (self.side,)


def circle(task: RockerTask, side: int) -> tuple[float, float]:
    """Give the radius of a circle that sees the chord under theta, and its centre on the axis of C, m."""
    return task.half / math.sin(task.overlap), task.height - side * task.half / math.tan(task.overlap)


def start_of_arc(task: RockerTask, side: int) -> float:
    """Give the angle rad at M of B2, where the arc begins."""
    return (side * QUARTER + side * task.overlap) % math.tau


def end_of_arc(task: RockerTask, side: int) -> float | None:
    """Give the angle rad at M where the admissible arc left of the axis ends, which begins at B2; None: none of it is.

    There the circle meets one of the lines CB1, CB2, at a distance from C by the power of C.
    """
    radius, middle = circle(task, side)
    if side < 0 and task.swing / 2 + task.overlap >= QUARTER:
        return None
    reach = (middle**2 - radius**2) / task.rocker  # along CB2, or back along CB1
    end = cmath.rect(reach, QUARTER + math.copysign(task.swing / 2, reach))
    return cmath.phase(end - complex(0, middle)) % math.tau


class SliderTask(NamedTuple):
    """A slider-crank is wanted: its stroke m, and of offset m, overlap rad, ratio l2/l1, pressure angle rad some."""

    stroke: float
    offset: float | None = None
    overlap: float | None = None
    ratio: float | None = None
    pressure: float | None = None

    @property
    def demands(self) -> tuple[str, ...]:
        """The demands beside the stroke, by their names.

        >>> SliderTask(0.12, 0.03, ratio=5.0).demands
        ('offset', 'ratio')
        """
        return tuple(name for name in DEMANDS if getattr(self, name) is not None)

    def only(self, *demands: str) -> SliderTask:
        """Give the task with these demands alone."""
        return SliderTask(self.stroke, **{name: getattr(self, name) for name in demands})


DEMANDS: Final = SliderTask._fields[1:]


@dataclass(frozen=True)
class CrankRocker:
    """A crank-rocker: its lengths m, its pivot O from C, and its least transmission angle rad (угол передачи)."""

    crank: float
    coupler: float
    rocker: float
    frame: float
    pivot: complex
    transmission: float

    @property
    def lengths(self) -> tuple[float, float, float, float]:
        """The lengths l1, l2, l3, l4, m."""
        return self.crank, self.coupler, self.rocker, self.frame

    @property
    def margin(self) -> float:
        """By how much the shortest and the longest link are longer than the others, m: below 0 the crank turns."""
        return min(self.lengths) + max(self.lengths) - (sum(self.lengths) - min(self.lengths) - max(self.lengths))


@dataclass(frozen=True)
class SliderCrank:
    """A slider-crank: crank, rod and offset m."""

    crank: float
    rod: float
    offset: float

    @property
    def ratio(self) -> float:
        """The ratio l2/l1."""
        return self.rod / self.crank

    @property
    def pressures(self) -> tuple[float, float]:
        """The least and the largest signed pressure angle, rad (угол давления)."""
        return math.asin((self.offset - self.crank) / self.rod), math.asin((self.offset + self.crank) / self.rod)

    @property
    def overlap(self) -> float:
        """The overlap angle rad that it has."""
        near, far = self.rod - self.crank, self.rod + self.crank
        return math.asin(self.offset / near) - math.asin(self.offset / far)

    @property
    def stroke(self) -> float:
        """The stroke m that it has."""
        near, far = self.rod - self.crank, self.rod + self.crank
        return math.sqrt(far**2 - self.offset**2) - math.sqrt(near**2 - self.offset**2)


class Reading(NamedTuple):
    """One reading of a task (толкование): the demands that are kept, and every mechanism that meets them."""

    kept: tuple[str, ...]
    found: tuple[CrankRocker | SliderCrank, ...]


@dataclass(frozen=True)
class Synthesis:
    """What one road found: the readings of a task, the first of which is drawn."""

    by: str
    readings: tuple[Reading, ...]

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """Nothing: a task that no mechanism meets is refused before."""
        return ()


def readings_of(task: SliderTask) -> tuple[SliderTask, ...]:
    """Give the tasks that a task may mean: two demands fix the mechanism, and one does with no offset.

    >>> [one.demands for one in readings_of(SliderTask(0.12, 0.03, 0.113, 5.0))]
    [('overlap', 'ratio'), ('offset', 'overlap'), ('offset', 'ratio')]
    """
    names = task.demands
    if len(names) <= PAIR:
        return (task,)
    pairs = [(first, last) for k, first in enumerate(names) for last in names[k + 1 :]]
    return tuple(task.only(*pair) for pair in sorted(pairs, key=lambda pair: "offset" in pair))


PAIR: Final = 2
