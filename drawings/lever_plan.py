"""The figure of Zhukovsky's lever: the turned velocity plan with the forces at the images (рычаг Жуковского)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from drawings.arms import Arm
from drawings.figure import Place, Subject, heading, point
from drawings.force_arrow import ForceArrow, marked
from drawings.force_letters import REACTION, lettered
from drawings.force_polygon import ZERO
from drawings.force_words import letter as letter_of
from drawings.hand import Hand
from drawings.lanes import Segment, merging
from drawings.layout import Labels
from drawings.picture import Margins, Picture, Spot, picture
from drawings.strokes import Circle, Group, Line, LineStyle, Stroke, Text, text_width
from drawings.symbols import ARROW_LENGTH, HINGE, POINT, fixed_hinge
from drawings.vector_plan import LEAST, diagram, written
from drawings.words import word
from geometry.board import Mark, at
from plans.force import ForcePlan
from plans.lever import Lever

PLAN, SYMBOL, UNIT = "lever", "v", "m/s"
QUARTER = -1j  # the plan is turned clockwise
LONGEST, SHORTEST = 26.0, 13.0  # mm, to the factor of the hand's symbols: the greatest force, and one that is nothing
AFTER = 2.0  # mm between two forces that follow one another on one line of action
MARGINS = Margins(3.0, 3.0, 3.0)  # paper beyond the forces, in sizes of the letters
LETTERS = 12.0  # a lever is drawn at least so many of its letters large
ROOM = 1.2  # lengths of an arrowhead: a shorter arm is left to the eye
ARMS, TELLING = 5, 0.02  # arms shown at the most, and the share of the greatest moment that is worth one
BESIDE = 1.6  # mm from an image to its letter
SAME = 0.5  # mm: images nearer than this share a letter
# What speaks against a place of a force: that it runs along another, that it is away from its image, along a rod: 1.
ON_FORCE, AWAY = 4, 2
STANDS = 12  # directions tried for the stand of the pole
LOAD, PAIR, BALANCE = "load", "pair", "balance"


class Push(NamedTuple):
    """A force on the lever: its name, what it is, the true place of its image m/s, its value N, its moment W."""

    name: str
    kind: str  # load; pair: half of a couple; balance: what the drive gives
    at: complex
    force: complex
    moment: float


class Hanging(NamedTuple):
    """What the lever shows at one position: images, the lines between them, and the forces, all turned."""

    column: int
    pole: str
    images: tuple[tuple[str, str, complex], ...]  # name on the velocity plan, its letters, true place
    rods: tuple[tuple[Segment, bool], ...]  # true ends; whether it comes from the pole
    pushes: tuple[Push, ...]

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(place for _, _, place in self.images)]


def hanging(plan: ForcePlan, lever: Lever, column: int) -> Hanging:
    """Read the lever from its record, and from that of the velocity plan which lines join its images."""
    base = diagram(plan.velocities, column)
    rods = {(arrow.start, arrow.end): (_turned(arrow.ends), arrow.absolute) for arrow in base.arrows}
    images = {mark.name: (_letters(plan, mark), QUARTER * at(mark.point, column)) for mark in base.letters}
    joined = list(rods.values())
    for mark in (*(one.at for one in lever.hung), *(end for pair in lever.pairs for end in pair[1:3]), lever.driven):
        if mark.name not in images and mark.name != lever.pole.name:
            place = at(mark.point, column)
            images[mark.name] = mark.name, place
            joined.append(((0j, place), True))
    told = tuple((name, letters, place) for name, (letters, place) in images.items())
    return Hanging(column, lever.pole.name, told, tuple(joined), tuple(_pushes(lever, column)))


def _letters(plan: ForcePlan, image: Mark) -> str:
    """Give all letters of an image, its own first."""
    own = [plan.velocities.letter(name) for name, mark in plan.velocities.letters.items() if mark is image]
    return " ".join(dict.fromkeys((image.name, *own)))


def _turned(ends: tuple[complex, complex]) -> Segment:
    return QUARTER * ends[0], QUARTER * ends[1]


def _pushes(lever: Lever, column: int) -> Iterator[Push]:
    """Give the forces that are not zero, the balancing one first; one at the hinge of the lever does nothing there."""
    driven, force = at(lever.driven.point, column), at(lever.force.point, column)
    every = [Push(lever.force.name, BALANCE, driven, force, (driven.conjugate() * force).imag)]
    for one in lever.hung:
        place, force = at(one.at.point, column), at(one.force.point, column)
        every.append(Push(one.name, LOAD, place, force, at(one.moment.point, column).real))
    for pair in lever.pairs:
        force, moment = at(pair.force.point, column), at(pair.moment.point, column).real
        ends = (pair.end, force), (pair.start, -force)
        every += [Push(pair.force.name, PAIR, at(end.point, column), half, moment) for end, half in ends]
    greatest = max(abs(one.force) for one in every)
    reach = max(abs(one.at) for one in every)
    yield from (one for one in every if abs(one.force) > ZERO * greatest and abs(one.at) > ZERO * reach)


class Reach(NamedTuple):
    """The arm of a force about the pole: its force, its true length m/s, and its letter.

    The letter is h_1 where it is drawn, pd where it is a line of the plan itself, and none where neither is so.
    """

    force: str
    length: float
    letter: str


@dataclass(frozen=True)
class Figure:
    """A lever placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: Hanging
    place: Place
    lines: tuple[Stroke, ...]
    forces: tuple[ForceArrow, ...]
    arms: tuple[Arm, ...]  # those that are drawn
    reaches: tuple[Reach, ...]  # of the balancing force and all loads
    hand: Hand

    def lettered(self, labels: Labels) -> Group:
        """Give the whole figure: letters of its images, its forces and their arms."""
        letters = [*self._images(labels), *(force.lettered(labels, self.hand) for force in self.forces)]
        letters += [arm.lettered(labels, self.hand) for arm in self.arms]
        return Group((*self.lines, Group(tuple(letters))), f"{PLAN}-{self.shown.column}")

    def _images(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the pole and every image once; images that fall on one place share it."""
        names: dict[complex, list[str]] = {self.place.on(0j): [self.shown.pole]}
        for _, letters, true in self.shown.images:
            spot = self.place.on(true)
            same = next((known for known in names if abs(known - spot) < SAME), spot)
            own = names.setdefault(same, [])
            own += [letter for letter in letters.split(" ") if letter not in own]
        middle = sum(names, 0j) / len(names)
        for spot, own in names.items():
            prefer = cmath.phase(spot - middle) if abs(spot - middle) > SAME else math.pi / 4
            gap = BESIDE if spot != self.place.on(0j) else HINGE * self.hand.symbol + 1.0
            yield labels.beside(spot, ", ".join(map(written, own)), self.hand.number, gap, prefer)


def measured(shown: Hanging, name: str, hand: Hand, language: str) -> Picture:
    """Measure the room that a lever needs: its images, the forces and letters around them, its heading."""
    title = text_width(Text(0j, _title(shown, language), hand.title))
    side, below, above = (size * hand.letter + LONGEST * hand.symbol for size in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    return picture(name, shown.points, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)


def figure(
    shown: Hanging, measure: Picture, spot: Spot, scale: str, hand: Hand, language: str, reactions: str = REACTION
) -> Figure:
    """Draw the lever in its spot: the turned plan on its hinge, the forces not to scale, arms of the greatest."""
    place = measure.placed(*spot)
    subject = Subject(PLAN, SYMBOL, shown.column)
    rods = [(Line(place.on(start), place.on(end), _style(thin, hand))) for (start, end), thin in shown.rods]
    rods = [rod for rod in rods if abs(rod.end - rod.start) >= LEAST]
    taken = Taken([(rod.start, rod.end) for rod in rods], [])
    forces = _placed(shown, place, taken, hand, (language, reactions))
    reaches = _arms(shown, place, taken, language)
    arms = tuple(arm for _, arm in reaches if arm is not None)
    drawn = [force.drawn(hand) for force in forces]
    circle = Circle(place.on(0j), HINGE * hand.symbol, hand.body)
    stand = fixed_hinge(place.on(0j), hand, HINGE * hand.symbol, _downward(rods, forces, place.on(0j)))
    dots = [point(subject, name, true, place, _dot(place.on(true), hand)) for name, _, true in shown.images]
    lines = (
        heading(spot.box, _title(shown, language), scale, hand),
        *([Group(tuple(stroke for arm in arms for stroke in arm.drawn(hand)))] if arms else []),
        Group((*rods, *stand)), *drawn, *dots,
        point(subject, shown.pole, 0j, place, circle, "pole"),
    )  # fmt: skip
    return Figure(shown, place, lines, tuple(forces), arms, tuple(reach for reach, _ in reaches), hand)


def _style(thin: bool, hand: Hand) -> LineStyle:
    return hand.other if thin else hand.relative


def _dot(at: complex, hand: Hand) -> Circle:
    return Circle(at, POINT * hand.symbol, LineStyle(hand.thin, fill="#ffffff"))


class Taken(NamedTuple):
    """Lines on paper that a force should not run along: the rods of the lever, and the forces drawn before."""

    rods: list[Segment]
    forces: list[Segment]


def _placed(shown: Hanging, place: Place, taken: Taken, hand: Hand, letters: tuple[str, str]) -> list[ForceArrow]:
    """Place the forces, the greatest first: each from its image or to it, where it runs along no other line."""
    greatest = max((abs(one.force) for one in shown.pushes), default=1.0)
    placed = []
    for one in sorted(shown.pushes, key=lambda one: -abs(one.force)):
        length = (SHORTEST + (LONGEST - SHORTEST) * abs(one.force) / greatest) * hand.symbol
        arrow = _beside(lettered(one.name, *letters), one.force, place.on(one.at), length, taken)
        taken.forces.append((arrow.start, arrow.tip))
        placed.append(arrow)
    return placed


def _beside(letter: str, force: complex, image: complex, length: float, taken: Taken) -> ForceArrow:
    """Draw a force from its image or to it; where both run along others, further on along its line of action."""
    along, step = force / abs(force), length + AFTER
    tries = [marked(letter, force, image, length), marked(letter, force, image, length, ending=True)]
    tries += [marked(letter, force, image + along * step * k, length, ending=k < 0) for k in (1, -1, 2, -2)]

    def cost(arrow: ForceArrow) -> int:
        ends = arrow.start, arrow.tip
        over = ON_FORCE * sum(merging(ends, other) for other in taken.forces)
        return over + any(merging(ends, rod) for rod in taken.rods) + AWAY * (abs(arrow.at - image) > SAME)

    return min(tries, key=cost)


def _arms(shown: Hanging, place: Place, taken: Taken, language: str) -> list[tuple[Reach, Arm | None]]:
    """Give all arms, drawing those of the greatest moments that run along nothing else, numbered as they are hung."""
    loads = [one for one in shown.pushes if one.kind != PAIR]
    greatest = max((abs(one.moment) for one in loads), default=0.0)
    lines, drawn, own = [*taken.rods, *taken.forces], set[str](), {}
    for one in sorted(loads, key=lambda one: -abs(one.moment)):
        arm = Arm("", place.on(0j), place.on(one.at), one.force / abs(one.force))
        if abs(arm.foot - arm.at) < SAME:
            own[one.name] = _ray(shown, one)
        elif len(drawn) < ARMS and abs(one.moment) > TELLING * greatest and arm.length > ROOM * ARROW_LENGTH:
            ends, action = (arm.about, arm.foot), (arm.at, arm.foot)
            if not any(merging(ends, other) for other in lines) and not any(merging(action, rod) for rod in taken.rods):
                drawn.add(one.name)
                lines.append(ends)
    numbers = iter(range(1, ARMS + 1))
    found: list[tuple[Reach, Arm | None]] = []
    for one in loads:
        index = "bal" if one.kind == BALANCE else str(next(numbers)) if one.name in drawn else ""
        letter = letter_of(language, f"h_{{{index}}}") if one.name in drawn else own.get(one.name, "")
        arm = Arm(letter, place.on(0j), place.on(one.at), one.force / abs(one.force))
        found.append((Reach(one.name, arm.length * place.scale.mu, letter), arm if one.name in drawn else None))
    return found


def _ray(shown: Hanging, one: Push) -> str:
    """Give the letters of the line from the pole to a force's image: the arm of a force that is square to it."""
    _, letters, _ = min(shown.images, key=lambda image: abs(image[2] - one.at))
    return shown.pole + written(letters.split(" ")[0])


def _downward(rods: list[Line], forces: list[ForceArrow], pole: complex) -> complex:
    """Turn the stand of the pole to where no line leaves it; downward if it can be."""
    ways = [rod.end - pole for rod in rods if abs(rod.start - pole) < SAME and abs(rod.end - pole) > SAME]
    ways += [arrow.tip - pole for arrow in forces if abs(arrow.at - pole) < SAME]
    turns = sorted(
        (2 * math.pi * k / STANDS for k in range(STANDS)), key=lambda turn: abs(math.remainder(turn, 2 * math.pi))
    )

    def clear(turn: float) -> float:
        stand = -1j * cmath.rect(1.0, turn)
        return min((abs(cmath.phase(way / stand)) for way in ways), default=math.pi)

    free = [turn for turn in turns if clear(turn) > math.pi / 4]
    return -1j * cmath.rect(1.0, free[0] if free else max(turns, key=clear))


def _title(shown: Hanging, language: str) -> str:
    return f"{word(language, 'lever')}, {word(language, 'position', position=shown.column)}"
