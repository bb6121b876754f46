"""Random chains of one to five dyads of all kinds, hung on anything before them, measured off a first position."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from math import pi, radians
from random import Random

from plans.model.mechanism import FRAME
from tests.trials.pose import Guide, Pose

KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")
MOST = 5  # groups
SHARPEST = 25.0  # degrees: at which lines cross at first, at least
ROUGH = 0.03  # m: how far a sketched point is off, on links of 0.3 to 2 m
# m: a crank that is to turn fully, as it must for an extreme, is a short one.
CRANKS = {"angle": (0.2, 0.5), "turn": (0.03, 0.1), "list": (0.2, 0.5), "extreme": (0.03, 0.1)}


def chain(chance: Random, starts: Sequence[str] = tuple(CRANKS)) -> str:
    """Draw a scene."""
    pose, phi, how = Pose(), round(chance.uniform(-180, 180), 2), chance.choice(starts)
    frame, crank = pose.link(0.0), pose.link(0.0)
    pose.point(0j, frame, crank)
    pose.point(cmath.rect(chance.uniform(*CRANKS[how]), radians(phi)), crank)
    for _ in range(chance.randint(1, MOST)):
        _Dyad(chance, pose).hang()
    title = f'title = "Chain {" ".join(pose.kinds)}"'
    return "\n".join([title, *pose.tables(), *_sketch(chance, pose), *_drive(chance, phi, how), *_output(chance, pose)])


class _Dyad:
    """A dyad that is being hung on two links of a pose."""

    def __init__(self, chance: Random, pose: Pose) -> None:
        self.chance, self.pose = chance, pose
        self.hosts = chance.sample(range(len(pose.links)), 2)
        self.links = [pose.link(self.turn()), pose.link(self.turn())]
        chance.shuffle(self.links)

    def hang(self) -> None:
        """Draw its kind, hang it, and give its links a point more for others to hang on."""
        kind = self.chance.choice(KINDS)
        self.pose.kinds.append(kind)
        BUILDERS[kind](self)
        for link in self.links:
            if self.chance.random() < 0.5:
                self.further(link)

    def turn(self) -> float:
        return self.chance.uniform(-pi, pi)

    def length(self) -> complex:
        return cmath.rect(self.chance.uniform(0.3, 2.0), self.turn())

    def crossing(self) -> complex:
        """Draw the direction of a line to another that it crosses."""
        return cmath.exp(1j * radians(self.chance.uniform(SHARPEST, 180 - SHARPEST))) * self.chance.choice((1, -1))

    def further(self, link: int, place: complex | None = None) -> str:
        """Mark a further point of a link, now and then by its lengths to the first two."""
        names = self.pose.links[link]
        free = place is None
        origin = self.pose.places[names[0]] if names else 0j
        name = self.pose.point(origin + self.length() if place is None else place, link)
        if free and link != FRAME and len(names) > 2 and self.chance.random() < 0.3 and self._well_off(link, name):
            self.pose.by_lengths.add((link, name))
        return name

    def _well_off(self, link: int, name: str) -> bool:
        first = self.pose.places[self.pose.links[link][0]]
        return abs(((self.pose.places[name] - first) / self.pose.way(link)).imag) > 3 * ROUGH

    def hinge(self, link: int, host: int) -> complex:
        """Hang a link on a host by a hinge: at one of the host's points, or at a new one."""
        taken = [name for name in self.pose.links[host] if name != "O"]  # the drive's hinge is left to the drive
        if taken and self.chance.random() < 0.5:
            name = self.chance.choice(taken)
            self.pose.links[link].append(name)
            return self.pose.places[name]
        return self.pose.places[self.pose.point(self.near(), host, link)]

    def near(self) -> complex:
        return cmath.rect(self.chance.uniform(0.1, 1.5), self.turn())

    def guide(self, one: int, other: int, way: complex, left: complex) -> None:
        """Let two links slide along a line of a direction, at some place; which of them has the line is drawn."""
        links = [one, other]
        self.chance.shuffle(links)
        slider, owner = links if links[0] != FRAME else links[::-1]
        if not self.pose.links[slider]:
            self.further(slider, self.near())
        point = self.chance.choice(self.pose.links[slider])
        if owner == FRAME:
            way = cmath.exp(1j * radians(round(180 / pi * cmath.phase(way), 2)))
            through = left + self.chance.uniform(-1, 1) * way
            self.pose.guides.append(Guide(slider, point, owner, None, through, way))
            return
        shifts = sorted(self.chance.uniform(-1, 1) for _ in range(2))
        ends = left + way * shifts[0], left + way * (shifts[1] + 0.3)
        names = self.further(owner, ends[0]), self.further(owner, ends[1])
        self.pose.guides.append(Guide(slider, point, owner, names))

    def beside(self, pin: complex, way: complex) -> complex:
        """Draw a place for a line beside a pin, or through it."""
        return pin if self.chance.random() < 0.5 else pin - 1j * way * self.chance.uniform(-0.3, 0.3)

    def pinned(self, link: int, host: int, pin: complex, way: complex) -> None:
        """Let a link slide on a host along a line through a pin or beside it."""
        self.guide(link, host, way, self.beside(pin, way))

    def rrr(self) -> None:
        a = self.hinge(self.links[0], self.hosts[0])
        b = a + self.length()
        c = b + (a - b) / abs(a - b) * self.crossing() * self.chance.uniform(0.3, 2.0)
        self.pose.point(c, self.hosts[1], self.links[1])
        self.pose.point(b, *self.links)

    def rrp(self) -> None:
        a = self.hinge(self.links[0], self.hosts[0])
        b = a + self.length()
        self.pose.point(b, *self.links)
        self.pinned(self.links[1], self.hosts[1], b, 1j * (b - a) / abs(b - a) * self.crossing())

    def rpr(self) -> None:
        a = self.hinge(self.links[0], self.hosts[0])
        c = a + self.length()
        self.pose.point(c, self.hosts[1], self.links[1])
        way = (a - c) / abs(a - c)
        if self.chance.random() < 0.5:
            way *= 1j * self.crossing()
            self.pinned(*self.links, a, way)
        else:
            self.guide(*self.links, way, a)

    def prp(self) -> None:
        b, way = self.near(), cmath.exp(1j * self.turn())
        self.pose.point(b, *self.links)
        self.pinned(self.links[0], self.hosts[0], b, way)
        self.pinned(self.links[1], self.hosts[1], b, way * self.crossing())

    def rpp(self) -> None:
        a = self.hinge(self.links[0], self.hosts[0])
        way = cmath.exp(1j * self.turn())
        self.pinned(*self.links, a, way)
        self.guide(self.links[1], self.hosts[1], way * self.crossing(), self.near())


BUILDERS: dict[str, Callable[[_Dyad], None]] = {
    "RRR": _Dyad.rrr, "RRP": _Dyad.rrp, "RPR": _Dyad.rpr, "PRP": _Dyad.prp, "RPP": _Dyad.rpp,
}  # fmt: skip


def _sketch(chance: Random, pose: Pose) -> list[str]:
    """Sketch all moving points, half of them roughly."""
    rows = ["[mechanism.sketch]"]
    for name, place in pose.places.items():
        if name not in pose.links[FRAME]:
            rough = place + cmath.rect(chance.choice((0, ROUGH)) * chance.random(), chance.uniform(-pi, pi))
            rows.append(f"{name} = [{rough.real:.3f}, {rough.imag:.3f}]")
    return rows


def _drive(chance: Random, phi: float, how: str) -> list[str]:
    """Draw speed, sense, acceleration, start and positions."""
    sense = chance.choice((1, -1))
    rows = ["[drive]", "link = 1", f"speed = {sense * chance.uniform(0.5, 20):.2f}"]
    if chance.random() < 0.5:
        rows.append(f"acceleration = {chance.uniform(-50, 50):.1f}")
    if how == "list":
        steps = [round(chance.uniform(1, 30), 1) for _ in range(chance.randint(1, 8))]
        angles = [round(phi + sense * sum(steps[:k]), 2) for k in range(len(steps) + 1)]
        return [*rows, f"positions = {angles}"]
    start = '"extreme"' if how == "extreme" else f"{phi}"
    return [*rows, f"start = {start}", f"positions = {chance.randint(6, 24)}"]


def _output(chance: Random, pose: Pose) -> list[str]:
    """Draw an output link, or a point of one, or leave it to the program."""
    still = {*pose.links[FRAME], *pose.links[1]}
    moving = [name for name in pose.places if name not in still]
    link, point = f"link = {chance.randint(2, len(pose.links) - 1)}", f'point = "{chance.choice(moving)}"'
    wanted = chance.choice(("", link, point))
    return ["[output]", wanted, ""] if wanted else [""]
