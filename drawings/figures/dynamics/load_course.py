"""The course of a load over its stroke: its corners on the way out and back, as a load diagram shows it (нагрузка)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.forces.loading import size_of, working_of
from plans.forces.stroke import Stroke, asks
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING, Force, Machine, Moment, Track
from plans.model.motion import Motion

Branch: TypeAlias = tuple[complex, ...]  # corners: way m or degrees + load N or N*m * i, in the order of the motion

STRAIGHT = 1e-3  # of the products whose difference is the bend: less than what a table of a diagram rounds away


class LoadCourse(NamedTuple):
    """A load over its stroke: how long that is, m or degrees, and the load on the working and on the idle stroke.

    A load against the motion is positive on the working stroke and negative on the idle one, any other one positive
    in its own direction. A stroke on which it rests has no branch.
    """

    name: str
    turning: bool  # whether the stroke is that of a link that swings
    couple: bool  # whether the load is a moment
    length: float
    overrun: tuple[float, float]
    out: Branch
    back: Branch
    places: tuple[complex, ...] = ()  # way + load * i in each position of a scene, NaN at gaps; those of `back` below
    returning: tuple[int, ...] = ()  # the positions of the idle stroke
    shown: tuple[int, ...] = ()  # those that always bear their numbers

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest load, zero among them."""
        sizes = [corner.imag for corner in (*self.out, *self.back)]
        return min(0.0, *sizes), max(0.0, *sizes)

    @property
    def corners(self) -> tuple[complex, ...]:
        """The ends of branches and their bends where the load is not zero, each once: out, then back."""
        return tuple(dict.fromkeys(corner for corner in (*_bends(self.out), *_bends(self.back)) if corner.imag))


def _bends(branch: Branch) -> Iterator[complex]:
    """Give both ends of a branch, and the corners at which it does not go straight on."""
    for k, corner in enumerate(branch):
        if k in (0, len(branch) - 1):
            yield corner
            continue
        before, after = corner - branch[k - 1], branch[k + 1] - corner
        across, along = (before.conjugate() * after).imag, abs(before.real * after.imag) + abs(before.imag * after.real)
        if abs(across) > STRAIGHT * along or (before.conjugate() * after).real < 0:
            yield corner


def courses(machine: Machine, strokes: Mapping[Track, Stroke], motion: Motion | None = None) -> Iterator[LoadCourse]:
    """Give the course of every load that changes over a stroke, with its places at the positions of a motion."""
    for load in machine.loads:
        if asks(load):
            bare = course(load, strokes[load.stroke])
            yield bare if motion is None else _placed(bare, load, strokes, motion)


def _placed(bare: LoadCourse, load: Force | Moment, strokes: Mapping[Track, Stroke], motion: Motion) -> LoadCourse:
    """Give where a load is on its course in each position of a motion."""
    stroke = strokes[load.stroke]
    back = ~working_of(load, stroke, motion)
    sense = np.where(back & _opposing(load), -1.0, 1.0)
    places = bare.length * stroke.share(motion) + 1j * (sense * size_of(load, motion, strokes) + 0.0)
    return bare._replace(places=tuple(places.tolist()), returning=tuple(np.flatnonzero(back).tolist()))


def course(load: Force | Moment, stroke: Stroke) -> LoadCourse:
    """Give the course of a load over its stroke."""
    low, high = stroke.reach
    length = abs(high - low) if stroke.sliding else math.degrees(abs(high - low))
    out = tuple(_corners(load, length, False)) if load.during in (ALWAYS, WORKING, FORWARD) else ()
    back = tuple(reversed([*_corners(load, length, True)])) if load.during in (ALWAYS, IDLE, BACKWARD) else ()
    return LoadCourse(load.name, not stroke.sliding, isinstance(load, Moment), length, load.overrun, out, back)


def _corners(load: Force | Moment, length: float, idle: bool) -> Iterator[complex]:
    """Give the corners of a branch from the beginning of the working stroke on, with the jumps at the overruns."""
    begin, end = load.overrun[0], 1 - load.overrun[1]
    sense = -1.0 if idle and _opposing(load) else 1.0
    if begin > 0:
        yield from (0j, complex(length * begin))
    travel = load.diagram.travel if isinstance(load, Force) and load.diagram is not None else ()
    for share in sorted({begin, end, *(place for place in travel if begin < place < end)}):
        yield complex(length * share, sense * _size(load, share, idle) + 0.0)
    if end < 1:
        yield from (complex(length * end), complex(length))


def _opposing(load: Force | Moment) -> bool:
    """Tell whether a load turns over with the motion."""
    if isinstance(load, Moment):
        return load.against
    return load.resists or (load.direction is None and load.line is None)


def _size(load: Force | Moment, share: float, idle: bool) -> float:
    if isinstance(load, Moment) or load.diagram is None:
        return load.size
    travel, there, back, _ = load.diagram
    return load.size * float(np.interp(share, travel, back or there if idle else there))
