"""Strokes (ходы): which part of the turn works and which runs idle, and the share of the way that a point has gone."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from plans.model.machine import ALWAYS, OUTPUT, Force, Machine, Moment, Track, frame_way
from plans.model.mechanism import FRAME, Mechanism, Output, Parting, StructureError, Way
from plans.model.motion import Extremes, Floats, Motion
from plans.words.words import Message, message

TURN = 2 * np.pi
# Up to kappa = 600 positions are graded, and the two roads agree in what a velocity is or where one is zero to
# 8 eps kappa2 of the largest, of an angle to that share of a turn (plans.quantity): less is zero, or the same.
KAPPA = 600.0
FIT = 0.01  # share of a stroke that a diagram's lengths may differ by: as exactly as strokes are read off drawings
ROUNDING = 8 * 2.0**-52 * KAPPA**2


class Stroke(NamedTuple):
    """The working and the idle stroke of an output over a turn of the crank (рабочий и холостой ход)."""

    begin: float  # rad: crank where the working stroke begins
    end: float  # rad: crank where it ends and the idle stroke begins
    sense: int  # of the crank's rotation: +1 counter-clockwise
    reach: tuple[float, float]  # output coordinate there: m along the guide, or rad of the link's +x axis
    link: int
    point: str = ""  # that slides
    way: Way | None = None  # the line of the frame that it slides along; None: the link swings, or parts
    parting: Parting | None = None  # from what the point is away

    @property
    def angles(self) -> tuple[float, float]:
        """The crank's angles rad over the working and over the idle stroke."""
        work = float(np.mod(self.sense * (self.end - self.begin), TURN))
        return work, TURN - work

    @property
    def output(self) -> Output:
        """What has the stroke."""
        return Output(self.link, self.point or None, parting=self.parting)

    @property
    def sliding(self) -> bool:
        """Whether the output slides, on the frame or away from another point."""
        return self.way is not None or self.parting is not None

    def working(self, phi: Floats) -> npt.NDArray[np.bool_]:
        """Tell the crank angles of the working stroke; the extreme position from which it begins is of it.

        >>> Stroke(0.5, 4.0, 1, (0.0, 0.1), 3).working(np.array([0.5 - 1e-12, 1.0, 4.0, 6.0, 7.0])).tolist()
        [True, True, False, False, True]
        """
        slack = ROUNDING * TURN
        work = np.mod(self.sense * (self.end - self.begin), TURN)
        return np.asarray(np.mod(self.sense * (phi - self.begin) + slack, TURN) < work)

    def share(self, motion: Motion) -> Floats:
        """Give the share of the stroke between the place and that where the working stroke begins, NaN at gaps."""
        low, high = self.reach
        middle = (low + high) / 2
        if self.parting is not None:
            beyond = _apart(self.parting, self.point, motion) - middle
        elif self.way is None:
            beyond = motion.links[self.link].angle - middle
            beyond -= TURN * np.round(beyond / TURN)
        else:
            r = motion.points[self.point].r - self.way.through
            beyond = (self.way.direction.conjugate() * r).real - middle
        return np.asarray(np.minimum(np.maximum(beyond / (high - low) + 0.5, 0.0), 1.0))


class NoStroke(StructureError):  # noqa: N818  (the exception tree's own word)
    """A load that changes over the stroke of a link or a point which has no two extreme positions."""

    def __init__(self, load: str, thing: Message) -> None:
        super().__init__(message("stroke.none", load=load, thing=thing))
        self.load, self.thing = load, thing


def _apart(parting: Parting, point: str, motion: Motion) -> Floats:
    """Give how far m a point is from another along their line; NaN at gaps."""
    start, end = (motion.points[name].r for name in parting.line)
    along = (end - start).conj()
    with np.errstate(invalid="ignore"):  # a gap is NaN
        away = (along * (motion.points[point].r - motion.points[parting.other].r)).real / np.abs(along)
    return np.asarray(away)


class OtherStroke(StructureError):  # noqa: N818  (the exception tree's own word)
    """A diagram over lengths of another stroke than that of what it counts; `load` is the force that it is of."""

    def __init__(self, load: Force, why: Message) -> None:
        super().__init__(why)
        self.load = load


def asks(load: Force | Moment) -> bool:
    """Tell whether a load changes over a stroke."""
    changes = load.during != ALWAYS or load.overrun != (0.0, 0.0)
    return changes or (isinstance(load, Force) and load.diagram is not None)


def strokes(
    machine: Machine, mechanism: Mechanism, output: Output, extremes: Callable[[Output], Extremes | None]
) -> dict[Track, Stroke]:
    """Find the strokes that loads ask for; `extremes` is that of either road."""
    found: dict[Track, Stroke] = {}
    for load in machine.loads:
        if asks(load) and load.stroke not in found:
            shown = counted(mechanism, load, output)
            reached = extremes(shown) if shown else None
            if shown is None or reached is None or not (reached.sliding or reached.stroke < TURN):
                raise NoStroke(load.name, _thing(load.stroke, output))
            found[load.stroke] = _stroke(mechanism, shown, reached)
        if asks(load):
            _check_length(load, found[load.stroke], _thing(load.stroke, output))
    return found


def _check_length(load: Force | Moment, stroke: Stroke, thing: Message) -> None:
    """See that a diagram over lengths is as long as the stroke."""
    if not isinstance(load, Force) or load.diagram is None or not load.diagram.length:
        return
    if not stroke.sliding:
        raise OtherStroke(load, message("stroke.swings", load=load.name, thing=thing))
    length, whole = load.diagram.length, abs(stroke.reach[1] - stroke.reach[0])
    if abs(whole - length) > FIT * whole:
        told, reached, off = (f"{1000 * size:.5g}" for size in (length, whole, abs(whole - length)))
        parts = {"load": load.name, "thing": thing, "length": told, "stroke": reached, "off": off}
        longer = length > whole
        raise OtherStroke(load, message("stroke.longer", **parts) if longer else message("stroke.shorter", **parts))


def counted(mechanism: Mechanism, load: Force | Moment, output: Output) -> Output | None:
    """Give the output whose stroke a load counts; None where its point has none."""
    track = load.stroke
    if track == OUTPUT:
        return output
    if track.parting is not None:
        return Output(load.link, track.point, track.working, track.parting)
    shown = output_at(mechanism, track.point)
    return shown and shown._replace(working=track.working)


def _thing(track: Track, output: Output) -> Message:
    """Name what has a stroke, or none."""
    if track.parting is not None:
        return message("place.points", first=track.parting.other, second=track.point)
    return message("place.point", point=track.point) if track.point else message("place.link", link=output.link)


def output_at(mechanism: Mechanism, point: str) -> Output | None:
    """Give the link whose stroke is that of a point: one that slides on the frame, else swings about it; or none."""
    links = [link for link in sorted(mechanism.links) if link != FRAME and point in mechanism.links[link].points]
    sliding = [link for link in links if frame_way(mechanism, link)]
    fixed = mechanism.links[FRAME].points
    hung = [link for link in links if not fixed.keys().isdisjoint(mechanism.links[link].points)]
    return next((Output(link, point) for link in (*sliding, *hung)), None)


def _stroke(mechanism: Mechanism, shown: Output, reached: Extremes) -> Stroke:
    sense = -1 if mechanism.drive.omega < 0 else 1
    point, way = (shown.parting is None and frame_way(mechanism, shown.link)) or ("", None)
    return Stroke(*reached.phi, sense, reached.reach, shown.link, shown.point or point, way, shown.parting)
