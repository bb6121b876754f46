"""The figure of Zhukovsky's lever: the turned velocity plan with the forces at the images (рычаг Жуковского)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from drawings.forces.letters import BALANCE, LOAD, PAIR
from drawings.forces.lever_layout import (
    PLAN,
    SYMBOL,
    UNIT,
    LeverTerm,
    Taken,
    arms,
    downward,
    forces,
    reach,
    terms,
)
from drawings.forces.polygon import ZERO
from drawings.kinds.polygon import ShownVector
from drawings.kinds.vector_plan import LEAST, letter_images
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import Segment
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.linkage.vector_plan import diagram
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Circle, Group, Line, LineStyle, Stroke
from drawings.paper.walk import stating
from drawings.symbols.dimension import Arm
from drawings.symbols.figure import Subject, around, heading, heading_width, point
from drawings.symbols.force_arrow import ForceArrow, plain_name
from drawings.symbols.symbols import HINGE, POINT, fixed_hinge
from geometry.board import Mark, at
from plans.forces.cut import ForcePlan
from plans.forces.lever import Lever

QUARTER = -1j  # the plan is turned clockwise
MARGINS = Margins(3.0, 3.0, 3.0)  # paper beyond the forces, in sizes of the letters
LETTERS, EACH = 12.0, 1.6  # a lever is drawn at least so many letters large, and so many for each force that it bears


class Hanging(NamedTuple):
    """What the lever shows at one position: images, the lines between them, and the forces, all turned."""

    column: int
    pole: str
    images: tuple[tuple[str, str, complex], ...]  # name on the velocity plan, its letters, true place
    rods: tuple[tuple[Segment, bool], ...]  # true ends; whether it comes from the pole
    forces: tuple[ShownVector, ...]

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(place for _, _, place in self.images)]


def hanging(plan: ForcePlan, lever: Lever, column: int) -> Hanging:
    """Read the lever from its record, and from that of the velocity plan which lines join its images."""
    base = diagram(plan.velocities, column)
    rods = {(arrow.start, arrow.end): (_turned(arrow.ends), arrow.absolute) for arrow in base.arrows}
    images = {mark.name: (_letters_of(plan, mark), QUARTER * at(mark.point, column)) for mark in base.letters}
    joined = list(rods.values())
    for mark in (*(one.at for one in lever.loads), *(end for pair in lever.pairs for end in pair[1:3]), lever.driven):
        place = at(mark.point, column)
        name = _new(mark.name, place, images)
        if name is not None and mark.name != lever.pole.name:
            images[name] = name, place
            joined.append(((0j, place), True))
    spots = tuple((name, letters, place) for name, (letters, place) in images.items())
    return Hanging(column, lever.pole.name, spots, tuple(joined), tuple(_forces(lever, column)))


def _new(name: str, place: complex, images: Mapping[str, tuple[str, complex]]) -> str | None:
    """Name an image that is not drawn yet: with a prime where another has its letter; None where it is drawn."""
    while name in images and images[name][1] != place:
        name += "'"
    return None if name in images else name


def _letters_of(plan: ForcePlan, image: Mark) -> str:
    """Give all letters of an image, its own first."""
    own = [plan.velocities.letter(name) for name, mark in plan.velocities.letters.items() if mark is image]
    return " ".join(dict.fromkeys((image.name, *own)))


def _turned(ends: tuple[complex, complex]) -> Segment:
    return QUARTER * ends[0], QUARTER * ends[1]


def _forces(lever: Lever, column: int) -> Iterator[ShownVector]:
    """Give the forces that are not zero, the balancing one first; one at the hinge of the lever does nothing there."""
    driven, force = at(lever.driven.point, column), at(lever.force.point, column)
    every = [ShownVector(lever.force.name, BALANCE, driven, force)]
    for one in lever.loads:
        place, force = at(one.at.point, column), at(one.force.point, column)
        every.append(ShownVector(one.name, LOAD, place, force))
    for pair in lever.pairs:
        force = at(pair.force.point, column)
        ends = (pair.end, force), (pair.start, -force)
        every += [ShownVector(pair.force.name, PAIR, at(end.point, column), half) for end, half in ends]
    greatest = max(abs(one.value) for one in every)
    reach = max(abs(one.at) for one in every)
    yield from (one for one in every if abs(one.value) > ZERO * greatest and abs(one.at) > ZERO * reach)


def balance(shown: Hanging, drafting: Drafting) -> tuple[LeverTerm, ...]:
    """Give the terms of the lever's equation of moments."""
    return terms(shown.forces, [(true, letters.split(" ")[0]) for _, letters, true in shown.images], drafting)


def measure(shown: Hanging, drafting: Drafting) -> Picture:
    """Measure the room that a lever needs: its images, the forces and letters around them, its heading."""
    hand = drafting.hand
    margins = around(MARGINS, hand, *(reach(shown.forces) * hand.symbol,) * 3)
    least = hand.letter * max(LETTERS, EACH * len(shown.forces))
    title = heading_width(_title(shown, drafting), hand)
    return picture(PLAN, [*shown.points, *_feet(shown, drafting)], (SYMBOL, UNIT), margins, title, least)


def _feet(shown: Hanging, drafting: Drafting) -> Iterator[complex]:
    """Give the feet of the arms that are dimensioned, in true units."""
    for one in balance(shown, drafting):
        if one.dimensioned:
            across = 1j * one.direction / abs(one.direction)
            yield across * (one.at * across.conjugate()).real


def draw(shown: Hanging, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the lever in its spot: the turned plan on its hinge, the forces not to scale, arms of the greatest."""
    place, hand = room.place(*spot), drafting.hand
    subject = Subject(PLAN, SYMBOL, shown.column)
    rods = [(Line(place.on(start), place.on(end), _style(thin, hand))) for (start, end), thin in shown.rods]
    rods = [rod for rod in rods if abs(rod.end - rod.start) >= LEAST]
    taken = Taken([(rod.start, rod.end) for rod in rods], [], spot.box)
    arrows = forces(shown.forces, place, taken, drafting)
    kept = arms(balance(shown, drafting), place, taken, shown.column)
    circle = Circle(place.on(0j), HINGE * hand.symbol, hand.body)
    stand = fixed_hinge(
        place.on(0j), hand, HINGE * hand.symbol, downward([*taken.rods, *taken.forces], place.on(0j), hand)
    )
    dots = [point(subject, name, true, place, _dot(place.on(true), hand)) for name, _, true in shown.images]
    lines = (
        heading(spot.box, _title(shown, drafting), drafting.scale(spot.scale), hand),
        *([Group(tuple(stroke for arm in kept for stroke in arm.draw(hand)))] if kept else []),
        Group((*rods, *stand)), *_drawn(arrows, subject, hand), *dots,
        point(subject, shown.pole, 0j, place, circle, "pole"),
    )  # fmt: skip
    return LetteredFigure(f"{PLAN}-{shown.column}", lines, partial(_letters, shown, place, (*arrows, *kept), hand))


def _letters(
    shown: Hanging, place: Place, marks: Iterable[ForceArrow | Arm], hand: Hand, labels: Labels
) -> Iterator[Stroke]:
    """Letter the pole and its images, then the forces and their arms."""
    images = [(0j, shown.pole), *((true, letters) for _, letters, true in shown.images)]
    spots = ((place.on(true), letters.split(" ")) for true, letters in images)
    yield from letter_images(spots, hand.number, labels, HINGE * hand.symbol + 1.0)
    yield from (one.letter_beside(labels, hand) for one in marks)


def _drawn(arrows: Sequence[ForceArrow], subject: Subject, hand: Hand) -> Iterator[Stroke]:
    """Draw the forces, each as what it states; the second of a couple is the first turned round."""
    seen = set[str]()
    for one in arrows:
        name = plain_name(one.letter)
        said = f"−{name}" if name in seen else name
        seen.add(name)
        yield stating(Statement(Kind.DIRECTION, PLAN, said, subject.position), one.draw(hand))


def _style(thin: bool, hand: Hand) -> LineStyle:
    return hand.other if thin else hand.relative


def _dot(at: complex, hand: Hand) -> Circle:
    return Circle(at, POINT * hand.symbol, LineStyle(hand.thin, fill="#ffffff"))


def _title(shown: Hanging, drafting: Drafting) -> str:
    return f"{drafting.word('lever')}, {drafting.word('position', position=shown.column)}"
