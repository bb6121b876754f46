"""The mechanism: links with their points, hinges, slides, the drive, mobility (подвижность), the working stroke.

Lengths are metres, angles radians, vectors complex numbers x + iy. Every coordinate of the frame is measured from the
datum, the drive's fixed hinge, so that a mechanism far from the origin of the scene loses nothing.
"""

import cmath
import math
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import NamedTuple

from geometry.branch import Side
from geometry.errors import DraftError
from plans.words.words import message

FRAME = 0
CRANK, SLIDER = "crank", "slider"  # kinds of primary link: a crank on the frame, a slider on it that is pushed along
# What may carry a linkage through its change points: another one beside it, set at another angle, or its inertia.
SLOWER, FASTER = "slower", "faster"  # the working stroke, by the time that it takes
PARALLEL, INERTIA = "parallel", "inertia"
THROUGH = (PARALLEL, INERTIA)
# What a stroke may be named by: the time that it takes, where its point goes, how its link turns, what its two points
# do to their distance.
WAYS = {"right": 1 + 0j, "left": -1 + 0j, "up": 1j, "down": -1j}
TURNS = {"counter-clockwise": 1, "clockwise": -1}
PARTINGS = {"apart": 1, "together": -1}
AGAINST = "against"  # the direction of a load along which a point of a coupler counts
STROKES = (SLOWER, FASTER, *WAYS, *TURNS, *PARTINGS)
# A stroke goes another way than is asked for where so small a share of it goes that way: square to it but for rounding.
SQUARE = 1e-7
LEANING = math.sin(math.radians(90 / 8))  # of a stroke: what goes less of it that way is not told to lean


class StructureError(DraftError, ValueError):
    """Links that form no crank with dyads; `found` and `needed` name the mobility where that is the fault."""

    def __init__(self, message: object, links: tuple[int, ...] = (), found: int | None = None, needed: int = 1) -> None:
        super().__init__(message)
        self.links, self.found, self.needed = links, found, needed


class Link(NamedTuple):
    """A link (звено) and its points in its own frame: first point at 0, second on +x; link 0 is the frame (стойка)."""

    number: int
    points: Mapping[str, complex]


class Way(NamedTuple):
    """A directed line fixed in a link: a point of it and its unit direction, both in the link's own frame."""

    through: complex
    direction: complex


class Slide(NamedTuple):
    """A sliding pair (поступательная пара): a line of the slider and a line of the owner that stay the same line."""

    slider: int
    owner: int
    on_slider: Way
    on_owner: Way
    point: str  # the slider's point that the scene names; it lies `offset` to the left of `on_owner` as drawn
    label: str  # the line as the scene names it: "CB", or "" for a line of the frame given by a point and an angle

    def way(self, link: int) -> Way:
        """Give the common line as a line of one of its two links."""
        return self.on_slider if link == self.slider else self.on_owner


class Passage(NamedTuple):
    """A linkage as the sketch of it chooses, and how far it moves while a cylinder in it only grows, or only shortens.

    `sides` are those of its groups; `home` is the crank angle rad of the sketch, `low`, `high` are those of its ends.
    """

    sides: tuple[Side, ...]
    home: float
    low: float
    high: float


class Ram(NamedTuple):
    """A cylinder (гидроцилиндр) between a foot and a point, whose length m is the drive's law.

    It goes from one length to another at a speed m/s and an acceleration m/s2 of their distance. Where the foot is a
    fixed point and the point the crank's, `side` is +1 if the crank's hinge lies to the left of the way from one to the
    other. Any other cylinder is between `links`, and has a `passage` where the linkage can be assembled.
    """

    foot: str
    point: str
    begin: float
    end: float
    speed: float
    acceleration: float
    side: float
    links: tuple[int, int] | None = None  # of the foot and of the point, where the crank's triangle does not hold it
    passage: Passage | None = None


class Drive(NamedTuple):
    """The drive (привод): the crank's number, fixed hinge, far end, angular velocity rad/s and acceleration rad/s2.

    Of a slide that is pushed along the coordinate is its way in units of `unit` m, as if a wheel of that radius rolled
    on it: `omega` and `epsilon` are that wheel's, `pivot` and `end` the slide's named point.
    """

    link: int
    pivot: str
    end: str
    omega: float
    epsilon: float
    kind: str = CRANK  # of primary link
    guide: Slide | None = None  # the slide that is pushed along
    unit: float = 1.0  # m; of a crank a radian
    ram: Ram | None = None  # the cylinder that turns the crank
    law: tuple[tuple[float, float], ...] = ()  # over a stroke: places m that rise, speeds m/s there; none: one speed

    @property
    def pushed(self) -> bool:
        """Whether a slide is pushed along."""
        return self.guide is not None

    @property
    def turns(self) -> bool:
        """Whether its coordinate comes round: that of a slide, or of a crank that a cylinder drives, does not."""
        return self.guide is None and self.ram is None


class Parting(NamedTuple):
    """How far a point is from another along a line of two points, from the first of which to the second it counts."""

    other: str
    line: tuple[str, str]


class Output(NamedTuple):
    """The output link (выходное звено) and, where it slides or was asked for, the point that shows its motion."""

    link: int
    point: str | None
    working: str = SLOWER  # which of its strokes is the working one
    parting: Parting | None = None  # from what its point is away, where that counts and not its motion on the frame
    along: complex | None = None  # the direction in which the way of its point counts, where no guide gives it

    @property
    def course(self) -> float:
        """The angle of that direction in degrees from +x, 0 of none."""
        return math.degrees(cmath.phase(self.along or 1)) % 360


@dataclass(frozen=True)
class Mechanism:
    """A planar linkage as the scene describes it; `links` holds the frame as link 0."""

    title: str
    datum: tuple[Decimal, Decimal]  # m: the scene's coordinates of the drive's fixed hinge
    links: Mapping[int, Link]
    slides: tuple[Slide, ...]
    drive: Drive
    sketch: Mapping[str, complex]  # rough places, measured from the datum
    output: Output | None  # None: the last link on the frame of the last group
    through: str | None = None  # what carries the links through change points: PARALLEL, INERTIA; None: nothing
    working: str = SLOWER  # the working stroke, where the scene names no output

    @cached_property
    def hinges(self) -> dict[str, tuple[int, ...]]:
        """Points named by two or more links, with those links in order of number: hinges (вращательные пары)."""
        owners: dict[str, list[int]] = {}
        for number in sorted(self.links):
            for point in self.links[number].points:
                owners.setdefault(point, []).append(number)
        return {point: tuple(links) for point, links in owners.items() if len(links) > 1}

    @cached_property
    def cylinder(self) -> tuple[str, ...]:
        """The foot and the point of the cylinder that drives; empty where two links are its barrel and its rod."""
        ends = (self.drive.ram.foot, self.drive.ram.point) if self.drive.ram else ()
        pairs = ([self.links[link].points for link in (s.slider, s.owner)] for s in self.slides if s.owner != FRAME)
        drawn = any(all(map(lambda end, link: end in link, ends[::way], pair)) for pair in pairs for way in (1, -1))
        return () if drawn else ends

    @cached_property
    def turning_with(self) -> dict[int, int]:
        """Each link with the least number of those that turn as it does, for slides join them; 0: it never turns."""
        least = {number: number for number in self.links}
        for slide in self.slides:
            keep, other = sorted((least[slide.slider], least[slide.owner]))
            least = {link: keep if group == other else group for link, group in least.items()}
        return least

    @cached_property
    def lower_pairs(self) -> int:
        """Number p1 of lower pairs; a hinge of k links counts k - 1 times."""
        return sum(len(links) - 1 for links in self.hinges.values()) + len(self.slides)

    @property
    def moving_links(self) -> int:
        """Number n of moving links."""
        return len(self.links) - 1

    @property
    def mobility(self) -> int:
        """Degree of mobility by Chebyshev's formula W = 3n - 2 p1 (степень подвижности; book section 6.4.4)."""
        return 3 * self.moving_links - 2 * self.lower_pairs

    def link_of(self, point: str) -> int:
        """Give the lowest-numbered link that owns a point."""
        return min(number for number, link in self.links.items() if point in link.points)


class NoWorkingStroke(StructureError):  # noqa: N818  (the exception tree's own word)
    """A working stroke that is named by a way which the output does not go."""

    def __init__(self, output: Output) -> None:
        super().__init__(message("structure.working", working=output.working, link=output.link))
        self.output = output


def by_time(output: Output) -> bool:
    """Tell whether the working stroke is named by the time that it takes."""
    return output.working in (SLOWER, FASTER)


def works(mechanism: Mechanism, output: Output, begin: float, end: float) -> bool:
    """Tell whether the stroke from a coordinate to another is the working one, of the two that are named by their way.

    Coordinates are those of Extremes.reach; a stroke that goes neither that way nor back raises NoWorkingStroke.
    """
    gone, whole = _progress(mechanism, output, begin, end)
    if not abs(gone) > SQUARE * whole:
        raise NoWorkingStroke(output)
    return gone > 0


def ways(mechanism: Mechanism, output: Output, begin: float, end: float) -> tuple[str, ...]:
    """Name the way of a stroke from a coordinate to another, by the names of working strokes, the plainest first.

    Of a slide that leans both its ways are named, unless it goes but an eighth of a right angle or less in one of them.
    """
    found = []
    for name in (*TURNS, *PARTINGS, *WAYS):
        gone, whole = _progress(mechanism, output._replace(working=name), begin, end)
        found += [name] if gone > LEANING * whole else []
    return tuple(found)


def frame_way(mechanism: Mechanism, link: int) -> tuple[str, Way] | None:
    """Give the point and the line by which a link slides on the frame."""
    slides = (slide for slide in mechanism.slides if {slide.slider, slide.owner} == {link, FRAME})
    return next(((slide.point, slide.way(FRAME)) for slide in slides), None)


def output_way(mechanism: Mechanism, output: Output) -> tuple[str, Way] | None:
    """Give the point of an output that counts and its line: of a guide, or in the direction told; None: it swings."""
    if output.along is not None:
        return output.point or "", Way(0j, output.along)
    found = frame_way(mechanism, output.link)
    return found and (output.point or found[0], found[1])


def _progress(mechanism: Mechanism, output: Output, begin: float, end: float) -> tuple[float, float]:
    """Give how far an output goes in the way that names its working stroke, and how far at all; 0 where it does not."""
    whole, name = end - begin, output.working
    slide = output_way(mechanism, output)
    if output.parting is not None:
        return PARTINGS.get(name, 0) * whole, abs(whole)
    if name == AGAINST:
        return -whole, abs(whole)
    if name in TURNS:
        return (0.0 if slide else TURNS[name] * whole), abs(whole)
    if name not in WAYS:
        return 0.0, abs(whole)
    went = slide[1].direction * whole if slide else _swing(mechanism, output, begin, end)
    return (WAYS[name].conjugate() * went).real, abs(went)


def _swing(mechanism: Mechanism, output: Output, begin: float, end: float) -> complex:
    """Give how a point of a link goes that swings about a fixed point; nothing of another."""
    points, fixed = mechanism.links[output.link].points, mechanism.links[FRAME].points
    pivot = next((place for name, place in points.items() if name in fixed), None)
    if pivot is None or output.point is None:
        return 0j
    arm = points[output.point] - pivot
    return arm * (cmath.rect(1.0, end) - cmath.rect(1.0, begin))
