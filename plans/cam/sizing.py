"""What the construction of the main sizes leaves: record, touches, centre (определение основных размеров)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.cam.centre.bounds import Bound, PressureBound, Touch
from plans.model.cam import Cam, Limits
from plans.model.cam_motion import Sizes
from plans.model.motion import Floats

RATIO = "1"  # the unit of what has none
UNITS = {  # whether the follower rocks and whether the cam translates
    (False, False): ("m", "m/rad", "m/rad2"),
    (False, True): ("m", RATIO, "1/m"),
    (True, False): ("rad", RATIO, "1/rad"),
    (True, True): ("rad", "rad/m", "rad/m2"),
}


def dimensions(cam: Cam) -> tuple[str, str, str]:
    """Give the units of S, S' and S''."""
    return UNITS[cam.rocks, cam.translates]


SIZES = "sizes"  # the board: m


class Tangent(NamedTuple):
    """A ruler's touch on the board: the point that it touches, its direction, its line; whether O lies on it."""

    bound: Bound
    touch: Touch
    point: Mark
    direction: Mark
    line: Mark
    binding: bool

    @property
    def angle(self) -> float | None:
        """The limit of the pressure angle that it is drawn at, signed, rad; None of a line of convexity."""
        return self.bound.side * self.bound.angle if isinstance(self.bound, PressureBound) else None


class Chord(NamedTuple):
    """The book's construction on the chord of a rocker's arc: its two tangents, its centre, how far that is off."""

    tangents: tuple[Tangent, ...]
    centre: Mark
    error: Mark


@dataclass(frozen=True)
class Sizing:
    """The main sizes of a cam with the construction that gave them.

    The diagram has its own origin: the start A of a follower that translates, the pivot O1 of one that rocks. `centre`
    is O in it. K and D are of the numbered positions, (N,) each; None where the diagram is another or has no points.
    A cam that translates has no sizes: `longer` tells how many times its phases would have to be longer for the limits.
    """

    cam: Cam
    limits: Limits
    sizes: Sizes
    board: Board
    turned: Floats  # of the numbered positions, rad
    origin: Mark | None = None
    start: Mark | None = None  # K0
    tip: Mark | None = None  # K
    end: Mark | None = None  # D; of a flat face S'' across from S
    centre: Mark | None = None
    tangents: tuple[Tangent, ...] = ()
    bounds: tuple[Bound, ...] = ()
    chord: Chord | None = None
    longer: float = 1.0

    @property
    def boards(self) -> tuple[Board, ...]:
        """The boards in the order of drawing."""
        return (self.board,)

    @property
    def binding(self) -> Iterator[Tangent]:
        """The tangents that O lies on."""
        return (one for one in self.tangents if one.binding)
