"""Mechanisms generated pose first: a first position is drawn, and the mechanism is measured off it, so it assembles.

A crank and one to four dyads of any kind, each hung on any two links before it, the frame or moving ones. Either link
of a dyad may own its sliding line, every pin may lie beside it, and every block has a direction of its own.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from math import pi, radians

import numpy as np
from hypothesis import strategies as st

from geometry.meet import EPS
from plans.analytic.kinematics import conditions
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Drive, Link, Mechanism, Output, Slide, Way
from plans.model.motion import Floats, Motion
from tests.plans.linkages import DATUM
from tests.plans.studies import study_of

KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")
CROOKED = 0.03  # m: how far a sketch's points are off, on links of 0.3 to 2 m


@dataclass
class Pose:
    """A first position under construction: the frames of the links, the places of points, the sliding pairs."""

    frames: dict[int, tuple[complex, complex]] = field(default_factory=dict)  # origin, and direction of +x
    places: dict[str, complex] = field(default_factory=dict)
    owners: dict[int, list[str]] = field(default_factory=dict)
    slides: list[Slide] = field(default_factory=list)
    kinds: list[tuple[str, tuple[int, int]]] = field(default_factory=list)

    def link(self, turn: float) -> int:
        """Begin a link with a direction of its own; its first point will be its origin."""
        number = len(self.frames)
        self.frames[number] = (0j, cmath.exp(1j * turn))
        self.owners[number] = []
        return number

    def point(self, place: complex, *links: int) -> str:
        """Mark a point of some links: of two of them, a hinge."""
        name = f"P{len(self.places)}"
        self.places[name] = place
        self.join(name, *links)
        return name

    def join(self, name: str, *links: int) -> None:
        for link in links:
            if not self.owners[link] and link != FRAME:
                self.frames[link] = (self.places[name], self.frames[link][1])
            self.owners[link].append(name)

    def slide(self, slider: int, owner: int, line: tuple[complex, complex], shifts: tuple[float, float]) -> None:
        """Let two links slide along a common line; each is given its own point of it."""
        through, way = line
        ways = [
            Way((through + shift * way - origin) / turn, way / turn)
            for shift, (origin, turn) in zip(shifts, (self.frames[slider], self.frames[owner]), strict=True)
        ]
        self.slides.append(Slide(slider, owner, ways[0], ways[1], "", ""))

    def local(self, link: int) -> dict[str, complex]:
        origin, turn = self.frames[link]
        return {name: (self.places[name] - origin) / turn for name in self.owners[link]}


@dataclass(frozen=True)
class Chain:
    """A generated mechanism with its first position: crank angle deg, places of points, directions of links."""

    mechanism: Mechanism
    phi: float
    places: dict[str, complex]
    turns: dict[int, complex]
    kinds: tuple[tuple[str, tuple[int, int]], ...]  # kind and links of every dyad, in the order hung


def numbers(least: float, most: float) -> st.SearchStrategy[float]:
    """Draw numbers of nine decimals: none so small that its square vanishes, which is no matter of mechanisms."""
    return st.floats(least, most).map(lambda number: round(number, 9))


LENGTHS = numbers(0.3, 2.0)
TURNS = numbers(-pi, pi)
OFFSETS = st.just(0.0) | numbers(-0.3, 0.3)
SIGNS = st.sampled_from((1.0, -1.0))


def crossing(draw: st.DrawFn, sharpest: float, least: float) -> complex:
    """Draw the direction of one line to another that it crosses at no less than an angle, degrees."""
    return cmath.exp(1j * radians(draw(numbers(least, sharpest)))) * draw(SIGNS)


@st.composite
def chains(draw: st.DrawFn, most: int = 4, least: float = 25.0) -> Chain:
    """Draw a mechanism of one to `most` dyads whose lines cross at no less than `least` degrees at first."""
    pose = Pose()
    pose.link(0.0)
    crank, phi = pose.link(draw(TURNS)), draw(numbers(-180, 180))
    pivot = pose.point(0j, FRAME, crank)
    end = pose.point(cmath.rect(draw(numbers(0.2, 0.5)), radians(phi)), crank)
    for _ in range(draw(st.integers(1, most))):
        kind = draw(st.sampled_from(KINDS))
        before = len(pose.frames)
        hosts = draw(st.permutations(range(before)))[:2]
        first, second = pose.link(draw(TURNS)), pose.link(draw(TURNS))
        links = (first, second) if draw(st.booleans()) else (second, first)
        BUILDERS[kind](draw, pose, links, (hosts[0], hosts[1]), least)
        pose.kinds.append((kind, (min(links), max(links))))
        for link in links:  # one point more, for others to hang on; a slotted link shows its direction by it
            if draw(st.booleans()) or (kind == "RPR" and link == links[1]):
                pose.point(pose.places[pose.owners[link][0]] + cmath.rect(draw(LENGTHS), draw(TURNS)), link)
    return _measured(draw, pose, crank, (pivot, end), phi)


def _measured(draw: st.DrawFn, pose: Pose, crank: int, ends: tuple[str, str], phi: float) -> Chain:
    links = {number: Link(number, pose.local(number)) for number in pose.frames}
    sketch = {
        name: place + CROOKED * cmath.rect(draw(numbers(0, 1)), draw(TURNS)) if draw(st.booleans()) else place
        for name, place in pose.places.items()
        if name not in links[FRAME].points
    }
    omega, epsilon = draw(SIGNS) * draw(numbers(0.5, 20)), draw(st.just(0.0) | numbers(-50, 50))
    drive = Drive(crank, *ends, omega, epsilon)
    output = Output(max(links), None)
    mechanism = Mechanism("chain", DATUM, links, tuple(pose.slides), drive, sketch, output)
    turns = {number: turn for number, (_, turn) in pose.frames.items()}
    return Chain(mechanism, phi, dict(pose.places), turns, tuple(pose.kinds))


def _near(draw: st.DrawFn) -> complex:
    return cmath.rect(draw(numbers(0.1, 1.5)), draw(TURNS))


def _hinge(draw: st.DrawFn, pose: Pose, link: int, host: int) -> complex:
    """Hang a link on a host by a hinge: at one of the host's points, or at a new one."""
    taken = [name for name in pose.owners[host] if name != "P0"]  # the drive's fixed hinge is left to the drive
    if taken and draw(st.booleans()):
        name = draw(st.sampled_from(taken))
        pose.join(name, link)
        return pose.places[name]
    place = _near(draw)
    pose.point(place, host, link)
    return place


def _guide(
    draw: st.DrawFn, pose: Pose, links: tuple[int, int], pin: complex, way: complex, left: float | None = None
) -> None:
    """Let two links slide along a line that a pin lies `left` of; which of them slides on which is drawn."""
    left = draw(OFFSETS) if left is None else left
    shifts = draw(st.tuples(numbers(-1, 1), numbers(-1, 1)))
    slider, owner = links if draw(st.booleans()) else links[::-1]
    pose.slide(slider, owner, (pin - 1j * left * way, way), shifts)


def _rrr(draw: st.DrawFn, pose: Pose, links: tuple[int, int], hosts: tuple[int, int], least: float) -> None:
    a = _hinge(draw, pose, links[0], hosts[0])
    b = a + cmath.rect(draw(LENGTHS), draw(TURNS))
    c = b + (a - b) / abs(a - b) * crossing(draw, 180 - least, least) * draw(LENGTHS)
    pose.point(c, hosts[1], links[1])
    pose.point(b, *links)


def _rrp(draw: st.DrawFn, pose: Pose, links: tuple[int, int], hosts: tuple[int, int], least: float) -> None:
    a = _hinge(draw, pose, links[0], hosts[0])
    b = a + cmath.rect(draw(LENGTHS), draw(TURNS))
    pose.point(b, *links)
    way = 1j * (b - a) / abs(b - a) * crossing(draw, 180 - least, least)
    _guide(draw, pose, (links[1], hosts[1]), b, way)


def _rpr(draw: st.DrawFn, pose: Pose, links: tuple[int, int], hosts: tuple[int, int], least: float) -> None:
    a = _hinge(draw, pose, links[0], hosts[0])
    c = a + cmath.rect(draw(LENGTHS), draw(TURNS))
    pose.point(c, hosts[1], links[1])
    way = (a - c) / abs(a - c) * (1.0 if draw(st.booleans()) else 1j * crossing(draw, 180 - least, least))
    _guide(draw, pose, links, a, way)


def _prp(draw: st.DrawFn, pose: Pose, links: tuple[int, int], hosts: tuple[int, int], least: float) -> None:
    b, way = _near(draw), cmath.exp(1j * draw(TURNS))
    pose.point(b, *links)
    _guide(draw, pose, (links[0], hosts[0]), b, way)
    _guide(draw, pose, (links[1], hosts[1]), b, way * crossing(draw, 180 - least, least))


def _rpp(draw: st.DrawFn, pose: Pose, links: tuple[int, int], hosts: tuple[int, int], least: float) -> None:
    a = _hinge(draw, pose, links[0], hosts[0])
    way = cmath.exp(1j * draw(TURNS))
    pose.point(_near(draw), links[1])
    _guide(draw, pose, links, a, way)
    _guide(draw, pose, (links[1], hosts[1]), _near(draw), way * crossing(draw, 180 - least, least), 0.0)


BUILDERS = {"RRR": _rrr, "RRP": _rrp, "RPR": _rpr, "PRP": _prp, "RPP": _rpp}


ROUNDINGS = 16.0  # of the plan's largest, in each of the equations: a dyad draws some ten steps


def studied(chain: Chain, offsets: Sequence[int | str] = (0,)) -> LinkageStudy:
    """Study a chain at some crank angles, degrees from its first position; nothing bars the way to the first itself."""
    study = study_of(chain.mechanism, positions=[Decimal(chain.phi) + Decimal(offset) for offset in offsets])
    if len(offsets) == 1:
        study.__dict__["barriers"] = ()
    return study


def allowed(chain: Chain, motion: Motion, order: int) -> Floats:
    """Bound rounding in positions, velocities or accelerations: the condition magnifies it with every derivative."""
    kappa = conditions(chain.mechanism, motion)
    vectors = [point[order] for point in motion.points.values()]
    largest = np.max([np.abs(vector) for vector in vectors if vector is not None], axis=0)
    return np.asarray(ROUNDINGS * EPS * kappa ** (order + 1) * largest)
