"""Kutzbach's plan: triangles of linear velocities and the plan of angular ones, drawn in one gear (картина скоростей).

On the board heights are upright and velocities level, each as the length v tau that it has at a time tau: so a link is
the straight line of its velocities over the heights of its points (линия распределения). Where a link has two known
points its line is drawn, and gives the velocities of its other points. A closed train (замкнутый дифференциал) has no
such link left at some time: then the speed of one is assumed twice, by false position. What one point would have by
two links is a misfit; laid off square to both assumed velocities, its line meets their level in the true one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from geometry.board import Board, Mark
from geometry.errors import DraftError
from plans.model.gears import FRAME, BoxGear, Train, bodies
from plans.scene.faults import TWINS
from plans.words.words import because, message

POINTS = "ABCDEFGKLNPQRSUVWXYZ"  # letters of mesh points: O is an axis, H a carrier, T a brake, M a clutch
AXIS = "O"
LINEAR, ANGULAR = "linear", "angular"  # the plans: m/s, rad/s
LINES = "lines"  # the board of lines of velocities, m; that of angular velocities is named as their plan
DEEPEST = 3  # assumed links within each other: of more closed loops than that no train is built


class TrainPoint(NamedTuple):
    """A point of the train in the plane of its axes: its letter, its height m over the main axis, its links."""

    letter: str
    height: Fraction
    links: tuple[str, ...]
    rack: str = ""  # that meshes there with a wheel of the link
    across: Fraction | None = None  # m, from the axis across of the other link

    @property
    def image(self) -> str:
        """The letter of its velocity."""
        return self.letter.lower()


def spots_of(train: Train) -> tuple[TrainPoint, ...]:
    """Give the axes, then the mesh points, then the centres of planets, each with the links that move as one there."""
    taken = {name[0].translate(TWINS) for name in (*train.links, *train.racks, *train.brakes, *train.clutches)}
    free = [one for one in POINTS if one not in taken] or [*POINTS]
    found, letters = list[TrainPoint](), iter([*free, *(f"{one}{k}" for k in range(1, 10) for one in free)])
    fixed = [link for link in train.links if link not in train.carrier_of and link not in train.crossing]
    for height in dict.fromkeys(train.heights[link] for link in fixed):
        links = tuple(link for link in fixed if train.heights[link] == height)
        found.append(TrainPoint(AXIS if height == 0 else f"{AXIS}{links[0]}", height, (FRAME, *links)))
    for mesh in train.meshes:
        links, at = tuple(train.wheels[name].link for name in mesh), None
        if bevel := train.bevels.get(mesh):
            links, at = (bevel.level.link, bevel.cross.link), bevel.place[0]
        found.append(TrainPoint(next(letters), train.contact(mesh), links, "", at))
    for rack, wheel in train.racks.items():
        found.append(TrainPoint(next(letters), train.rack_height(rack), (train.wheels[wheel].link,), rack))
    for link, carrier in train.carrier_of.items():
        links, at = ((carrier, link), Fraction(0)) if link in train.crossing else ((link, carrier), None)
        found.append(TrainPoint(f"{AXIS}{link}", train.heights[link], links, "", at))
    return tuple(found)


@dataclass
class _KnownMotion:
    """What is known while a plan is drawn: the velocity of each point, the line of each link, where two disagree."""

    velocities: dict[str, Mark]
    lines: dict[str, Mark]
    misfits: list[tuple[str, Mark, Mark]] = field(default_factory=list)


class KutzbachPlan(NamedTuple):
    """The plan of one gear: images of points and lines of links on one board, ends of angular velocities on another.

    `tau` s makes lengths of velocities: the pole of the angular ones is 1/tau rad/s under their line.
    """

    gear: BoxGear
    linear: Board
    angular: Board
    images: Mapping[str, Mark]
    lines: Mapping[str, Mark]
    velocities: Mapping[str, Mark]  # m/s
    speeds: Mapping[str, Mark]  # rad/s
    tau: float
    assumed: tuple[str, ...]
    racks: Mapping[str, Mark]  # upright lines: all points of a rack have the velocity of its mesh point

    @property
    def level_speeds(self) -> Mapping[str, Mark]:
        """The angular velocities of links with level axes, which the plan shows."""
        return {link: mark for link, mark in self.speeds.items() if mark.subject == self.angular.subject}

    @property
    def width(self) -> float:
        """How far apart the images lie, m."""
        across = [0.0, *(complex(mark.point).real for mark in self.images.values())]
        return max(across) - min(across)


class _Drafter:
    """Draws the plan of one gear."""

    def __init__(self, train: Train, gear: BoxGear, tau: float) -> None:
        self.train, self.gear, self.tau = train, gear, tau
        self.board, self.angular = Board(board_of(LINES, gear)), Board(board_of(ANGULAR, gear))
        self.assumed: list[str] = []
        held = [(FRAME, link) for link in gear.held]
        self.body = bodies(train.links, (*train.joined, *gear.locked, *held))
        self.spots = spots_of(train)
        board, size = self.board, max(abs(spot.height) for spot in self.spots)
        self.origin = board.given(AXIS, 0j, because("gear_axis"))
        self.up = board.given("y", complex(0, float(size)), because("gear_up"))
        self.across = board.given("x", complex(float(size), 0), because("gear_across"))
        self.axis = board.parallel("0", self.origin, self.up, because("gear_zero"))
        self.places, self.levels, self.columns = dict[str, Mark](), dict[str, Mark](), dict[str, Mark]()
        for spot in self.spots:
            at = complex(0, float(spot.height))
            place = self.origin if spot.letter == AXIS else board.given(spot.letter, at, because("gear_point"))
            self.places[spot.letter] = place
            self.levels[spot.letter] = board.parallel(f"h_{spot.letter}", place, self.across, because("gear_level"))
            if spot.across is not None:
                aside = board.given(f"x_{spot.letter}", complex(0, float(spot.across)), because("gear_aside"))
                column = board.parallel(f"k_{spot.letter}", aside, self.across, because("gear_level"))
                self.columns[spot.letter] = column

    def of(self, body: str) -> list[TrainPoint]:
        """Give the points of a body, from the lowest, of one that turns across from the leftmost."""
        some = (spot for spot in self.spots if any(self.body[link] == body for link in spot.links))
        return sorted(some, key=partial(self._place, body))

    def _place(self, body: str, spot: TrainPoint) -> Fraction:
        """Give the height m of a point, for a body that turns across how far the point is from its axis."""
        return spot.height if body not in self.train.crossing or spot.across is None else spot.across

    def start(self) -> _KnownMotion:
        """Give what is known of itself: what is held rests, a driving link has the speed that it is given."""
        drawing = _KnownMotion({}, {self.body[FRAME]: self.axis})
        for spot in self.of(self.body[FRAME]):
            drawing.velocities[spot.letter] = self.places[spot.letter]
        for link, speed in self.train.drives:
            if self.body[link] not in drawing.lines:
                self._drive(drawing, link, speed)
        return drawing

    def _drive(self, drawing: _KnownMotion, link: str, speed: float) -> None:
        """Lay off the velocity of a driving link at its farthest point: v = omega r."""
        far, crossing = self.farthest(link), self.train.crossing.get(link)
        arm = crossing[0].arm if crossing else far.height - self.train.heights[link]
        length = speed * float(arm) * self.tau
        vector = self.board.given(f"v_{far.letter}", complex(length, 0), because("gear_drive", link=link))
        self.known(drawing, far, self.board.lay_off(far.image, self.places[far.letter], vector, because("gear_laid")))
        self.run(drawing, "")

    def farthest(self, link: str) -> TrainPoint:
        """Give the point of a body that is farthest from its axis."""
        axis = self.train.heights[link]
        return max(self.of(self.body[link]), key=lambda spot: abs(spot.height - axis))

    def known(self, drawing: _KnownMotion, spot: TrainPoint, mark: Mark) -> None:
        """Put down the velocity of a point, or that another link has it otherwise."""
        if spot.letter in drawing.velocities:
            drawing.misfits.append((spot.letter, drawing.velocities[spot.letter], mark))
        else:
            drawing.velocities[spot.letter] = mark

    def run(self, drawing: _KnownMotion, suffix: str) -> None:
        """Draw the line of each link that has two known points, and read its other points off it."""
        while body := next(self._ready(drawing), ""):
            known = [spot for spot in self.of(body) if spot.letter in drawing.velocities]
            low, high = (self._seen(drawing, body, spot, suffix) for spot in (known[0], known[-1]))
            low = self.origin if len(known) == 1 else low
            name = f"{self._named(body)}{suffix}"
            along = self.board.join(f"{low.name}{high.name}", low, high, because("gear_two", link=self._named(body)))
            line = self.board.parallel(name, low, along, because("gear_line", link=self._named(body)))
            drawing.lines[body] = line
            for spot in self.of(body):
                if spot not in (known[0], known[-1]):
                    why = because("gear_read", link=self._named(body))
                    across = body in self.train.crossing
                    level = (self.columns if across else self.levels)[spot.letter]
                    prime = "'" if across else ""
                    image = self.board.meet(f"{spot.image}{prime}{suffix}", line, level, why=why)
                    if across:
                        image = self._carried(f"{spot.image}{suffix}", image, self.levels[spot.letter])
                    self.known(drawing, spot, image)

    def _seen(self, drawing: _KnownMotion, body: str, spot: TrainPoint, suffix: str) -> Mark:
        """Give the end of a velocity, carried over to where a body that turns across has the point (перенос)."""
        image = drawing.velocities[spot.letter]
        if body not in self.train.crossing:
            return image
        return self._carried(f"{image.name}'{suffix}", image, self.columns[spot.letter])

    def _carried(self, name: str, image: Mark, level: Mark) -> Mark:
        upright = self.board.parallel(f"({name})", image, self.up, because("gear_carried"))
        return self.board.meet(name, upright, level, why=because("gear_carried"))

    def _named(self, body: str) -> str:
        return " = ".join(link for link in self.train.links if self.body[link] == body)

    def _ready(self, drawing: _KnownMotion) -> Iterator[str]:
        for body in dict.fromkeys(self.body.values()):
            if body not in drawing.lines:
                places = {self._place(body, spot) for spot in self.of(body) if spot.letter in drawing.velocities}
                if body in self.train.crossing and body not in self.train.carrier_of:
                    places.add(Fraction(0))
                if len(places) > 1:
                    yield body

    def solve(self, drawing: _KnownMotion, suffix: str = "", depth: int = 0) -> _KnownMotion:
        """Draw all lines; where none can be drawn on, assume the speed of a link, twice, and find the true one."""
        self.run(drawing, suffix)
        left = [link for link in self.train.links if self.body[link] not in drawing.lines]
        left = [link for link in left if link not in self.train.carrier_of]
        left.sort(key=lambda link: link not in self.train.carriers)  # carriers first
        if all(body in drawing.lines for body in self.body.values()):
            return drawing
        if depth < DEEPEST:
            for link in left:
                if (true := self._false_position(drawing, link, suffix, depth)) is not None:
                    self.assumed += [] if depth else [link]
                    drawing.velocities[self.farthest(link).letter] = true
                    return self.solve(drawing, suffix, depth)
        raise DraftError(message("gears.no_plan", links=", ".join(left)))

    def _false_position(self, drawing: _KnownMotion, link: str, suffix: str, depth: int) -> Mark | None:
        """Assume that a link rests, then that it moves as fast as what is fastest; nothing where no misfit tells."""
        spot, tried, ends = self.farthest(link), list[_KnownMotion](), list[Mark]()
        largest = max(abs(complex(mark.point).real) for mark in drawing.velocities.values())
        for k, length in enumerate((0.0, largest), 1):
            mine, trial = f"{suffix}{'°' * k}", _KnownMotion({**drawing.velocities}, {**drawing.lines})
            vector = self.board.given(f"v_{spot.letter}{mine}", complex(length, 0), because("gear_assumed", link=link))
            end = self.board.lay_off(f"{spot.image}{mine}", self.places[spot.letter], vector, because("gear_laid"))
            trial.velocities[spot.letter] = end
            try:
                tried.append(self.solve(trial, mine, depth + 1))
            except DraftError:
                return None
            ends.append(end)
        return self._closed(spot, [one.misfits for one in tried], ends, suffix)

    def _closed(
        self, spot: TrainPoint, misfits: Sequence[Sequence[tuple[str, Mark, Mark]]], ends: Sequence[Mark], suffix: str
    ) -> Mark | None:
        """Lay the misfits off square to the assumed velocities; the line of their ends meets the level in the true."""
        rows = [pair for pair in zip(*misfits, strict=False) if abs(_off(pair[0]) - _off(pair[1])) > 0]
        if not rows:
            return None
        chosen = max(rows, key=lambda pair: abs(_off(pair[0]) - _off(pair[1])))
        tops = []
        for k, ((letter, one, other), end) in enumerate(zip(chosen, ends, strict=True), 1):
            mine = f"{suffix}{'°' * k}"
            misfit = self.board.join(f"Δ_{letter}{mine}", one, other, because("gear_misfit"))
            turned = self.board.turn(f"Δ'_{letter}{mine}", misfit, 1j, because("gear_square"))
            tops.append(self.board.lay_off(f"E{mine}", end, turned, because("gear_square")))
        along = self.board.join(f"EE{suffix}", tops[0], tops[1], because("gear_chord"))
        chord = self.board.parallel(f"e{suffix}", tops[0], along, because("gear_chord"))
        return self.board.meet(f"{spot.image}{suffix}", chord, self.levels[spot.letter], why=because("gear_true"))

    def plan(self) -> KutzbachPlan:
        """Draw the triangles, then through a pole the parallels to the lines of all links."""
        drawing, velocities = self.solve(self.start()), dict[str, Mark]()
        for spot in (spot for spot in self.spots if spot.links[0] != FRAME):
            name, ends = spot.letter, (self.places[spot.letter], drawing.velocities[spot.letter])
            length = self.board.join(f"{name}{spot.image}", *ends, because("gear_span"))
            velocities[name] = self.board.turn(f"v_{name}", length, 1 / self.tau, because("gear_velocity"))
        lines = {link: drawing.lines[self.body[link]] for link in self.train.links}
        images, slides, why = drawing.velocities, [spot for spot in self.spots if spot.rack], because("gear_rack")
        found = images, lines, velocities, self._speeds(lines, images)
        racks = {one.rack: self.board.parallel(one.rack, images[one.letter], self.up, why) for one in slides}
        return KutzbachPlan(self.gear, self.board, self.angular, *found, self.tau, tuple(self.assumed), racks)

    def _relative(self, link: str, lines: Mapping[str, Mark], images: Mapping[str, Mark]) -> Mark:
        """Read the speed of a link that turns across: the velocity of its mesh point over the carrier there, by r."""
        mesh, board = self.train.crossing[link][0], self.board
        spot = next(spot for spot in self.spots if spot.links == (mesh.level.link, link))
        under, carrier = self.places[spot.letter], self.train.carrier_of.get(link)
        if carrier:
            under = board.meet(f"{carrier}_{spot.letter}", lines[carrier], self.levels[spot.letter])
        over = board.join(f"{under.name}{spot.image}", under, images[spot.letter], because("gear_over"))
        return board.turn(f"ω_{link}", over, 1 / (self.tau * float(mesh.arm)), because("gear_omega", link=link))

    def _speeds(self, lines: Mapping[str, Mark], images: Mapping[str, Mark]) -> dict[str, Mark]:
        """Draw the plan of angular velocities: parallels through its pole cut them off from its line."""
        board, speeds, far = self.angular, dict[str, Mark](), 1 / self.tau
        zero = board.given("0", 0j, because("gear_zero_speed"))
        pole = board.given("P", complex(0, -far), because("gear_pole"))
        across = board.given("x", complex(far, 0), because("gear_across"))
        level = board.parallel("h", zero, across, because("gear_base"))
        for link, line in lines.items():
            if link in self.train.crossing:
                speeds[link] = self._relative(link, lines, images)
                continue
            along = board.transfer(f"({link})", line.step.inputs[1], because("gear_slope", link=link))
            ray = board.parallel(f"P{link}", pole, along, because("gear_ray", link=link))
            end = board.meet(link, ray, level, why=because("gear_end"))
            speeds[link] = board.join(f"ω_{link}", zero, end, because("gear_omega", link=link))
        return speeds


def _off(misfit: tuple[str, Mark, Mark]) -> float:
    return complex(misfit[2].point).real - complex(misfit[1].point).real


STEPS = (1.0, 2.0, 5.0, 10.0)


def rounded(value: float) -> float:
    """Round a number down to 1, 2 or 5 times a power of ten.

    >>> rounded(0.013), rounded(70.0)
    (0.01, 50.0)
    """
    digits, power = f"{value:e}".split("e")
    return float(f"{max(step for step in STEPS if step <= float(digits)):g}e{power}")


def board_of(plan: str, gear: BoxGear) -> str:
    """Name the board and the figure of a plan in a gear.

    >>> board_of("linear", BoxGear("II", (), ()))
    'linear-II'
    """
    return f"{plan}-{gear.name}" if gear.name else plan


def plans_of(train: Train) -> tuple[KutzbachPlan, ...]:
    """Draw the plan of each gear: once to see how fast points move, then the widest about as wide as high."""
    heights = [spot.height for spot in spots_of(train)]
    size, first = float(max(heights) - min(heights)), max(abs(speed) for _, speed in train.drives)
    wide = max(_Drafter(train, gear, 1 / first).plan().width for gear in train.gears)
    tau = rounded(size / wide / first)
    return tuple(_Drafter(train, gear, tau).plan() for gear in train.gears)
