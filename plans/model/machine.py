"""The machine: what forces need of a mechanism beside its links: masses, loads, drive, friction (машина).

Values alone, SI: kg, m, N, N*m, rad; places in the links' own frames. Both roads read them.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from plans.model.mechanism import SLOWER, Parting

ALWAYS, WORKING, IDLE = "always", "working stroke", "idle stroke"
# Wherever the output goes as on its working stroke, or back, also on a reversal within a stroke.
FORWARD, BACKWARD = "working direction", "idle direction"
MOMENT, COUPLING, FORCE, GEAR = "moment", "coupling", "force", "gear"


class Body(NamedTuple):
    """A link's mass kg, its moment of inertia about the mass centre kg*m2, and the centre in the link's own frame."""

    link: int
    mass: float
    inertia: float
    centre: complex


class Track(NamedTuple):
    """Whose stroke a load counts: of the output, of a point, or of one from another; and which of the two works.

    That of a point of a link that neither slides on the frame nor swings about it goes `along` a direction.
    """

    point: str = ""  # "": the output
    working: str = SLOWER
    parting: Parting | None = None
    along: complex | None = None


OUTPUT = Track()


class Piston(NamedTuple):
    """What a pressure acts on: the area m2 on its side and on the other, and the force N of what presses against it."""

    area: float
    other: float
    behind: float

    def pressure(self, force: float) -> float:
        """Give the pressure MPa that leaves a force N."""
        return (force + self.behind) / self.area / 1e6


class Diagram(NamedTuple):
    """Sizes of a load N over the stroke of a point: at shares of it that rise from 0 to 1 in the working sense.

    `back` are the sizes on the idle stroke at the same shares; empty where the load rests there or is the same.
    """

    travel: tuple[float, ...]
    sizes: tuple[float, ...]
    back: tuple[float, ...] = ()
    length: float = 0.0  # m, of the stroke that the shares were told of as lengths; 0: as shares


class End(NamedTuple):
    """A point of a link, by its letter and its place in the link's own frame, at which a force acts."""

    link: int
    point: str
    at: complex


class Force(NamedTuple):
    """A load on a point of a link: N along a fixed direction or a line of points, or against the motion of the point.

    One between two links acts along a line that both points lie on, and on the other the opposite way.
    """

    name: str  # as the sheet letters it: "F_us", "F_D"
    link: int
    point: str
    at: complex
    size: float  # N; of a diagram 1
    direction: complex | None  # unit vector; None: along its line, or without one against the motion of the point
    during: str = ALWAYS
    diagram: Diagram | None = None
    overrun: tuple[float, float] = (0.0, 0.0)  # shares of the stroke at its ends in which the load rests
    stroke: Track = OUTPUT
    useful: bool = True  # whether its work is the machine's purpose
    line: tuple[str, str] | None = None  # the points from the first of which to the second it acts
    other: End | None = None  # where it acts back: on its line too
    resists: bool = False  # whether it acts against the motion of its point from the other
    piston: Piston | None = None  # of one that was told in pressures

    @property
    def card(self) -> Piston | None:
        """The piston of an indicator card; none where the load rests at the ends, or turns over with the motion."""
        fixed = (self.direction is not None or self.line is not None) and not self.resists and not any(self.overrun)
        return self.piston if self.diagram is not None and fixed else None

    @property
    def one_sided(self) -> bool:
        """Whether a pressure against the motion takes one side of its piston on both strokes, though a rod is there."""
        turns = self.resists or (self.direction is None and self.line is None)
        both, piston = turns and self.during == ALWAYS and self.diagram is None, self.piston
        return both and piston is not None and piston.area != piston.other


class Moment(NamedTuple):
    """A moment on a link, N*m: constant, or of a size against the link's rotation."""

    name: str
    link: int
    size: float
    against: bool = False
    during: str = ALWAYS
    overrun: tuple[float, float] = (0.0, 0.0)
    stroke: Track = OUTPUT
    useful: bool = True


class Spring(NamedTuple):
    """A spring between points of two links (пружина): stiffness N/m and free length m; it pulls when longer."""

    name: str
    links: tuple[int, int]
    points: tuple[str, str]
    at: tuple[complex, complex]
    stiffness: float
    free: float


class Transmission(NamedTuple):
    """How the crank is driven: by a moment, a coupling, a force at its end square to it, or a gear (figure 6.17)."""

    kind: str = MOMENT
    radius: float = 0.0  # m, of the wheel's pitch circle
    at: float = 0.0  # rad: direction from the shaft to where the pinion meets the wheel
    pressure: float = 0.0  # rad, pressure angle of the teeth


class Rubbing(NamedTuple):
    """Friction of a pair: reduced coefficient, journal radius m of a hinge, length of contact m of a slide (0: any)."""

    coefficient: float
    radius: float = 0.0
    length: float = 0.0


@dataclass(frozen=True)
class Machine:
    """Masses by link, gravity m/s2, loads, springs, drive, and friction by pair ("0-1"), in the order of the scene."""

    bodies: Mapping[int, Body]
    gravity: complex
    forces: tuple[Force, ...]
    moments: tuple[Moment, ...]
    springs: tuple[Spring, ...]
    transmission: Transmission
    friction: Mapping[str, Rubbing]

    @property
    def loads(self) -> tuple[Force | Moment, ...]:
        """The forces, then the moments, that may change over a stroke."""
        return (*self.forces, *self.moments)
