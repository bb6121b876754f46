"""A plan: its letters, vectors, and images of links, which give any point by similarity (план, теорема подобия).

In true units: dyads.py and slotted_dyads.py lay it out; its scale is taken on paper (drawings/page/page.py).
"""

from collections.abc import Iterable, Mapping
from copy import copy
from types import MappingProxyType
from typing import NamedTuple, Protocol, TypeAlias, TypeVar, cast

import numpy as np

from geometry.board import Board, Mark, Reading
from geometry.meet import Vectors
from plans.model.mechanism import FRAME, Link, Mechanism
from plans.model.motion import Complexes, Floats
from plans.model.triad import Triad, TriadLead
from plans.scene.scene import Scene
from plans.words.words import because

POLES = {"positions": "datum", "velocities": "p", "accelerations": "π"}
SlidingPair = tuple[int, int]  # a sliding pair by its two links


class PlanLetters:
    """How the plans of a mechanism letter its points, those that lie under them, and ends of normal and Coriolis parts.

    A letter that another point or a pole has gets a prime.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        named = dict.fromkeys(point for link in mechanism.links.values() for point in link.points)
        self._small: dict[str, str] = {}
        # A point that is named by a small letter keeps it, and one with a prime its own: P' is p', so P is p''.
        for point in sorted(named, key=lambda name: (name != name.lower(), -len(name))):
            self._small[point] = apart(point.lower(), {*POLES.values(), *self._small.values()})
        self.points = frozenset(named)
        self._taken = {*POLES.values(), *self._small.values()}
        self.specials: dict[int, SpecialLetters] = {}  # special points, by their basis links
        self.pins: dict[SlidingPair, tuple[str, int]] = {}  # that slide along a guide of a host, by their pairs

    def small(self, point: str) -> str:
        """Write a point's letter small: B as b."""
        return self._small[point] if point in self._small else apart(point.lower(), self._taken)

    def under(self, point: str, link: int) -> str:
        """Name the point of a link that lies under another's, such as a3; a_(3) where a point A3 has that letter."""
        small = self.small(point)
        return f"{small}_({link})" if f"{small}{link}" in self._taken else f"{small}{link}"

    def normal(self, tip: str, about: str = "") -> str:
        """Name the end of the normal part of a tip's acceleration about a point: n_BA, or about one at rest n_B."""
        return apart(f"n_{tip}{about}", self._taken)

    def slides(self, pair: SlidingPair, pin: str, host: int) -> None:
        """Keep the pin whose velocity along its guide on a host a sliding pair gives."""
        self.pins[pair] = pin, host

    def coriolis(self, pin: str, host: int, pair: SlidingPair | None = None) -> str:
        """Name the end of a pin's Coriolis part: k_A; k_A3 over link 3 where the pin has such parts over several.

        What slides there in a later pair, as a yoke's point under the pin does, has a prime: k_A3'.
        """
        several = sum(letter == pin and FRAME not in other for other, (letter, _) in self.pins.items()) > 1
        alike = [other for other, slid in self.pins.items() if slid == (pin, host)]
        primes = "'" * (alike.index(pair) if pair in alike else 0)
        return apart(f"k_{pin}{host}" if several else f"k_{pin}", self._taken) + primes

    def of_link(self, symbol: str, link: int) -> str:
        """Name a point that a link has besides its named ones, such as n3."""
        lettered = {self.small(point) + str(link) for point in self._small}
        return f"{symbol}_({link})" if f"{symbol}{link}" in lettered | self._taken else f"{symbol}{link}"


def apart(letter: str, taken: Iterable[str]) -> str:
    """Give a letter that is not among those taken, with as many primes as it needs.

    >>> apart("p", ["p", "p'"])
    "p''"
    """
    known = set(taken)
    while letter in known:
        letter += "'"
    return letter


NEAR = 1e-3  # share of a link's length: a mass centre nearer to a named point than this is that point
Masses: TypeAlias = Mapping[str, tuple[int, complex]]  # by their letters: link, and place in its own frame
NONE: Masses = MappingProxyType({})


class _Mass(Protocol):
    def place(self, link: Link) -> complex: ...


class _Weighed(Protocol):
    """What a scene says of forces: the masses of its links."""

    masses: Mapping[int, _Mass]


def unnamed(scene: Scene, links: Mapping[int, Link]) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that no point of the scene names, by their letters."""
    taken = {name for link in links.values() for name in link.points}
    form, centres = cast("_Weighed | None", scene.part("forces")), {}
    for number, mass in sorted(form.masses.items()) if form else ():
        places, centre = links[number].points.values(), mass.place(links[number])
        size = max(abs(place - centre) for place in places)
        if number != FRAME and f"S{number}" not in taken and min(abs(p - centre) for p in places) > NEAR * size:
            centres[f"S{number}"] = number, centre
    return centres


class Turning(NamedTuple):
    """A link's tip turns about its start: a velocity, a normal and a tangential part of an acceleration."""

    link: int
    start: str
    tip: str


class Slotted(NamedTuple):
    """A pin in the slot of a link that turns about a pivot: the link's point under it, slip, Coriolis, normal part."""

    link: int
    pivot: str
    pin: str


class Sliding(NamedTuple):
    """A pin that slides along a guide of a link that moves: its slip, Coriolis and relative part over that link.

    `pair` names the sliding pair by its two links; a `held` pin is that of the stone, and its host's point slips.
    """

    pair: tuple[int, int]
    host: int
    pin: str
    held: bool = False


class SpecialPoint(NamedTuple):
    """The special point of a triad, where the lines of two leads meet, as a point of the basis link."""

    triad: Triad


class SpecialLetters(NamedTuple):
    """How a special point is lettered, and which lead of its triad it leaves out."""

    name: str
    out: int


def special_name(pair: Iterable[TriadLead], points: Iterable[str]) -> str:
    """Letter the special point of two leads by their links: S23, with a prime where a point has that letter."""
    first, second = pair
    return apart(f"S{first.link}{second.link}", points)


Vector: TypeAlias = Turning | Slotted | Sliding | SpecialPoint

Key = TypeVar("Key")


class Image(NamedTuple):
    """A link on a plan: the image of one of its points and of one of its vectors; no arm: the link does not turn.

    `at` is the point and `span` the vector in the link's own frame; they are the same on all plans of one position.
    """

    origin: Mark
    arm: Mark | None
    at: complex
    span: complex


class Plan:
    """A plan of positions, velocities or accelerations; `below` are the plans that it rests on."""

    def __init__(self, subject: str, mechanism: Mechanism, below: "tuple[Plan, ...]" = ()) -> None:
        self.board = Board(subject)
        self.mechanism = mechanism
        self.below = below
        self.images: dict[int, Image] = {}
        self.letters: dict[str, Mark] = {}
        self.placed: dict[tuple[int, complex, str], Mark] = {}  # images of places of links, by the letter they got
        self.readings: dict[int, Reading] = {}
        self.units: dict[tuple[int, int], Mark | None] = {}  # sliding line of (slider, owner): image of its direction
        self.slips: dict[tuple[int, int], Mark] = {}  # velocity of the pin along that line
        self.reaches: dict[tuple[int, int], Mark] = {}  # vector from the pivot of a slotted group to its pin
        self.written: PlanLetters = below[0].written if below else PlanLetters(mechanism)
        self.pole = self.board.given(POLES[subject], 0j, _POLE_WHY[subject])

    @property
    def positions(self) -> "Plan":
        """The plan of positions that this one rests on, or is."""
        return self.below[0] if self.below else self

    @property
    def velocities(self) -> "Plan":
        """The velocity plan that an acceleration plan rests on."""
        return self.below[1]

    def arm(self, link: int) -> Mark:
        """Give a link's vector on the plan of positions, where every link has one."""
        arm = self.positions.images[link].arm
        assert arm is not None  # a vector's image is missing only where a link does not turn
        return arm

    def trial(self) -> "Plan":
        """Give a copy to try an assembly on; the board is shared, what is known of links and points is not."""
        other = copy(self)
        other.images, other.letters, other.placed = dict(self.images), dict(self.letters), dict(self.placed)
        other.units, other.readings = dict(self.units), dict(self.readings)
        return other

    def redraw(self, board: Board, made: Mapping[Mark, Mark], below: "tuple[Plan, ...]") -> "Plan":
        """Give this plan as it is on another board, whose marks are named by those of this one."""

        def images(known: Mapping[Key, Mark]) -> dict[Key, Mark]:
            return {key: made[mark] for key, mark in known.items()}

        other = copy(self)
        other.board, other.below, other.pole = board, below, made[self.pole]
        other.letters, other.slips, other.reaches = images(self.letters), images(self.slips), images(self.reaches)
        other.placed = {key: made[mark] for key, mark in self.placed.items() if mark in made}  # others may come later
        other.units = {key: mark and made[mark] for key, mark in self.units.items()}
        other.images = {
            link: image._replace(origin=made[image.origin], arm=image.arm and made[image.arm])
            for link, image in self.images.items()
        }
        readings = self.readings.items()
        other.readings = {link: Reading(made[reading.arm], made[reading.turning]) for link, reading in readings}
        return other

    def letter(self, point: str) -> str:
        """Write a point as this plan does: B on the plan of positions, b on the others."""
        return self.written.small(point) if self.below else point

    def name(self, point: str, mark: Mark) -> Mark:
        """Keep a mark as the image of a named point."""
        self.letters[point] = mark
        return mark

    def point(self, point: str) -> Mark:
        """Give the image of a named point, drawn by similarity where it is not drawn yet."""
        return self.letters[point] if point in self.letters else self.name(point, self._construct(point))

    def _construct(self, point: str) -> Mark:
        if point in self.mechanism.links[FRAME].points:
            if self.below:
                return self.pole
            return self.board.given(point, self.mechanism.links[FRAME].points[point], because("fixed"))
        link = min(n for n in self.images if point in self.mechanism.links[n].points)
        return self.place(link, self.mechanism.links[link].points[point], self.letter(point))

    def place(self, link: int, local: complex, name: str) -> Mark:
        """Give the image of a point of a link by its place in the link's own frame; once placed it is used again."""
        known = self.placed.get((link, local, name))
        return known or self.placed.setdefault((link, local, name), self._place(link, local, name))

    def _place(self, link: int, local: complex, name: str) -> Mark:
        if link == FRAME:
            return self.pole if self.below else self.board.given(name, local, because("fixed"))
        image = self.images[link]
        if image.arm is None or local == image.at:
            return image.origin
        vector = self.vector(link, local - image.at, f"{image.origin.name}{name}")
        assert vector is not None  # an image with an arm has vectors
        return self.board.lay_off(name, image.origin, vector, because("similar", point=name, link=link))

    def vector(self, link: int, local: complex, name: str) -> Mark | None:
        """Give the image of a vector of a link; None where the link does not turn."""
        if link == FRAME:
            return None if self.below else self.board.given(name, local, because("frame_direction"))
        image = self.images[link]
        if image.arm is None or local == image.span:
            return image.arm
        return self.board.turn(name, image.arm, local / image.span, because("similar_figure", link=link))

    def transport(self, link: int, point: Mark, name: str) -> Mark:
        """Give the image of the point of a link that lies under a point of the plan of positions (переносное)."""
        image = self.images.get(link)
        if link == FRAME or image is None:
            return self.pole
        base = self.positions.images[link]
        if image.arm is None or base.arm is None or point is base.origin:
            return image.origin
        reach = self.positions.board.join(f"{base.origin.name}{point.name}", base.origin, point)
        why = because("turns", link=link)
        carried = self.board.similar(f"{image.origin.name}{name}", image.arm, base.arm, reach, why=why)
        return self.board.lay_off(name, image.origin, carried, because("under", link=link, point=point.name))

    def carry(self, mark: Mark) -> Mark:
        """Carry a vector of a plan below to this one with the set square; once carried it is used again."""
        if mark.name in self.board and self.board[mark.name].step.inputs == (mark,):
            return self.board[mark.name]
        return self.board.transfer(mark.name, mark, because("transfer", plan=mark.subject))


_POLE_WHY = {
    "positions": because("drive_hinge"),
    "velocities": because("velocity_pole"),
    "accelerations": because("acceleration_pole"),
}

RUN = 40  # positions whose angles are measured from the middle one, where they are close to it

CLOSE = 1 / 64  # tangent of an angle whose series may leave out t9/9: less than a rounding


def heading(vector: Vectors, span: complex = 1 + 0j) -> Floats:
    """Give the direction of a link's own +x axis, rad in (-pi, pi], from one of its vectors that is `span` there."""
    vectors = np.asarray(vector if span.imag == 0 < span.real else vector / span)
    # The first run tells most often enough that the others are not close either.
    close = (
        vectors.size >= RUN
        and vectors.size % RUN == 0
        and abs(vectors[RUN // 2] - vectors[0]) <= CLOSE * abs(vectors[0])
    )
    found = _close(vectors.reshape(-1, RUN)) if close else None
    return _turned(vectors) if found is None else found


def _turned(vectors: Complexes) -> Floats:
    turned = np.arctan2(vectors.imag, vectors.real)
    least = np.minimum.reduce(turned, None, initial=np.inf)
    return turned if least > -np.pi else np.where(turned <= -np.pi, np.pi, turned)


def _close(runs: Complexes) -> Floats | None:
    """Measure runs of vectors close to each other, each from the middle of its run; None where one is not close.

    An arctangent costs as much as a meeting; of a small tangent t it is t - t3/3 + t5/5 - t7/7 to the last digit.
    """
    middle = runs[:, RUN // 2, None]
    from_middle = np.conjugate(middle) * runs
    tangent = from_middle.imag / from_middle.real
    if not (np.abs(tangent).max() <= CLOSE and from_middle.real.min() > 0):
        return None
    square = tangent * tangent
    angle = square * (-1 / 7)
    for share in (1 / 5, -1 / 3):
        angle += share
        angle *= square
    angle *= tangent
    angle += tangent
    angles = _turned(middle)
    angle += angles
    if np.abs(angles).max() > np.pi - CLOSE:
        angle -= np.where(angle > np.pi, 2 * np.pi, 0.0)
        angle += np.where(angle <= -np.pi, 2 * np.pi, 0.0)
    return angle.ravel()


def angle(plan: Plan, link: int) -> Floats:
    """Read off the plan of positions the direction of a link's own +x axis, rad in (-pi, pi]."""
    return np.zeros(1) if link == FRAME else heading(plan.arm(link).point, plan.images[link].span)


def rate(plan: Plan, link: int) -> Floats:
    """Read off a velocity or acceleration plan a link's omega rad/s or epsilon rad/s2: Im(t/AB) (0.1).

    t is the part of the plan's relative vector that is square to the link; a link that does not turn has none.
    """
    if link not in plan.readings:
        return np.zeros(1)
    reading = plan.readings[link]
    return np.imag(reading.turning.point / reading.arm.point)
