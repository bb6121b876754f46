"""The figure of Zhukovsky's lever: the turned velocity plan with the forces at the images (рычаг Жуковского)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations, pairwise
from typing import NamedTuple

from drawings.forces.arms import ON_LINE, OUTSIDE, LeverTerm, aside, leverages, terms, within
from drawings.forces.letters import BALANCE, LOAD, PAIR, letter_of
from drawings.forces.polygon import ZERO
from drawings.kinds.polygon import ShownVector
from drawings.kinds.vector_plan import LEAST, letter_images
from drawings.layout.contents import EVEN
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import APART, Segment, crossing, merging, nearest
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.linkage.vector_plan import diagram
from drawings.page.page import Drafting, Field, drafting_of
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Kind, Line, LineStyle, Statement, Stroke
from drawings.paper.walk import stating, tied, tied_spot
from drawings.symbols.couples import ForceArrow, letter_each, not_to_scale
from drawings.symbols.figure import LEAST as LEAST_ARM
from drawings.symbols.figure import Arm, Subject, around, heading, heading_width, plain_name, point, to_scale
from drawings.symbols.symbols import HINGE, POINT, STAND, fixed_hinge
from geometry.board import Mark, at
from plans.forces.cut import ForcePlan
from plans.forces.force_template import ForcePlans
from plans.forces.lever import Lever
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.motion import NOTHING
from plans.study import Study

PLAN, SYMBOL, UNIT = "lever", "v", "m/s"
DETAIL = "detail-lever"  # the name of the enlarged detail of what acts about its pole
LONGEST, SHORTEST = 26.0, 13.0  # mm, to the factor of the hand's symbols: the greatest force, and one that is nothing
AFTER = 4.0  # mm between two forces that follow one another on one line of action: further than heads that meet
# What speaks against a place of a force: that it is off its image, or led past another; that it touches another force.
AWAY, TOUCHING = 2, 2
STANDS = 12  # directions tried for the stand of the pole
BOTH, PARALLEL = 2, 0.1  # of forces on one line through an image one comes and one goes; parallel to 3 degrees
SAME = 0.5  # mm: places nearer than this are one


class Taken(NamedTuple):
    """Lines on paper that a force should not run along: the rods of the lever, and the forces drawn before."""

    rods: list[Segment]
    forces: list[Segment]
    box: Field  # of the figure


def placed_forces(pushes: Sequence[ShownVector], place: Place, taken: Taken, drafting: Drafting) -> list[ForceArrow]:
    """Place the forces, the greatest first: each from its image or to it, where it runs along no other line."""
    greatest = max((abs(push.value) for push in pushes), default=1.0)
    arrows = []
    for push in sorted(pushes, key=lambda push: -tied(abs(push.value) / greatest)):
        length = (SHORTEST + (LONGEST - SHORTEST) * abs(push.value) / greatest) * drafting.hand.symbol
        arrow = _beside(letter_of(push.name, drafting), push.value, place.on(push.at), length, taken)
        taken.forces.append((arrow.start, arrow.tip))
        arrows.append(arrow)
    return arrows


def _beside(letter: str, force: complex, image: complex, length: float, taken: Taken) -> ForceArrow:
    """Draw a force from its image or to it; where both run along others, led from it further on its line of action."""
    along = force / abs(force)
    ends = ((end - image) / along for line in taken.forces for end in line)
    steps = sorted({tied(abs(end.real)) + AFTER for end in ends if abs(end.imag) < SAME} | {length + AFTER})
    tries = [not_to_scale(letter, force, image, length), not_to_scale(letter, force, image, length, ending=True)]
    ways = (sign * step * along for step in steps for sign in (1, -1))
    slid = (not_to_scale(letter, force, image + way, length, (way / along).real < 0) for way in ways)
    tries += [arrow._replace(lead=image) for arrow in slid]

    def cost(arrow: ForceArrow) -> int:
        run = arrow.start, arrow.tip
        over = ON_LINE * sum(merging(run, other) for other in taken.forces)
        over += TOUCHING * sum(_touching(run, other) for other in taken.forces)
        over += OUTSIDE * (not within(arrow.free, taken.box))
        others = {spot for rod in taken.rods for spot in rod if abs(spot - image) > SAME}
        passed = any(abs(spot - nearest(image, arrow.at, spot)) < APART for spot in others)
        hidden = sum(abs(spot - nearest(*run, spot)) < POINT for spot in others)  # under the marks of other images
        return over + any(merging(run, rod) for rod in taken.rods) + AWAY * ((arrow.lead is not None) + passed + hidden)

    return min(tries, key=cost)


def _touching(line: Segment, other: Segment) -> bool:
    """Tell whether two forces cross, or one comes to the other's end so near that their arrowheads meet."""
    apart = (abs(end - nearest(*a, end)) for a, b in ((line, other), (other, line)) for end in b)
    return crossing(line, other) or any(SAME < far < APART for far in apart)


def placed_arms(terms: Sequence[LeverTerm], place: Place, taken: Taken, subject: Subject, hand: Hand) -> list[Arm]:
    """Draw the arms of forces, the longest last: each square to its force, aside where it would run along others."""
    pole, scale = place.on(0j), place.scale
    every = (to_scale(t.arm, pole, place.on(t.at), t.direction, scale, subject) for t in terms)
    kept = sorted((arm for arm in every if arm.length >= LEAST_ARM), key=lambda arm: tied(arm.length))
    return aside(kept, [*taken.rods, *taken.forces], taken.box, hand)


def _downward(lines: list[Segment], arms: list[Segment], pole: complex, hand: Hand) -> complex:
    """Turn the stand of the pole to where no line runs, or but arms; downward if it can be."""
    depth = STAND[0] * hand.symbol
    turns = sorted((math.remainder(math.tau * k / STANDS, math.tau) for k in range(STANDS)), key=abs)

    def clear(turn: float, lines: list[Segment]) -> float:
        foot = pole - 1j * depth * cmath.rect(1.0, turn)
        return min((abs(foot - nearest(*line, foot)) for line in lines if line[0] != line[1]), default=math.inf)

    for about in ([*lines, *arms], lines):
        free = [turn for turn in turns if clear(turn, about) > (STAND[1] + STAND[2]) * hand.symbol]
        if free:
            return -1j * cmath.rect(1.0, free[0])
    return -1j * cmath.rect(1.0, max(turns, key=lambda turn: clear(turn, [*lines, *arms])))


QUARTER = -1j  # the plan is turned clockwise
MARGINS = Margins(3.0, 3.0, 3.0)  # paper beyond the forces, in sizes of the letters
LETTERS, EACH = 12.0, 1.6  # a lever is drawn at least so many letters large, and so many for each force that it bears

ROOMY, LARGER = 4.0, 2.0  # times the least distance of its images at which a lever is roomy; weight of a crowded one
# Shares of a lever: what acts so near to its pole may have a detail, and has one where images are so near one another.
INNER, TIGHT = 1 / 3, 1 / 30
AROUND, STUB, BESIDE = 2.5, 0.25, 1.0  # mm from a detail to its circle, on to its letter; how far rods are followed


class Hanging(NamedTuple):
    """What the lever shows at one position: images, the lines between them, and the forces, all turned."""

    column: int
    pole: str
    images: tuple[tuple[str, str, complex], ...]  # name on the velocity plan, its letters, true place
    rods: tuple[tuple[Segment, bool], ...]  # true ends; whether it comes from the pole
    forces: tuple[ShownVector, ...]
    near: float = 0.0  # what acts no further from the pole stands in a detail
    letter: str = ""  # of that
    part: bool = False  # whether it is that

    @property
    def plan(self) -> str:
        """The name of the plan that its marks belong to."""
        return DETAIL if self.part else PLAN

    def has(self, place: complex) -> bool:
        """Tell whether it shows what acts at an image: it, or its detail, does."""
        return (abs(place) <= self.near) is self.part

    @property
    def pushes(self) -> list[ShownVector]:
        """The forces that it shows."""
        return [force for force in self.forces if self.has(force.at)]

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        circle = (self.near * way for way in (1, 1j, -1, -1j) if not self.part)
        return [*circle, *(place for _, _, place in self.images), *(end for rod, _ in self.rods for end in rod)]


def hanging(plan: ForcePlan, lever: Lever, column: int) -> Hanging:
    """Read the lever from its record, and from that of the velocity plan which lines join its images."""
    base = diagram(plan.velocities, column)
    rods = {
        (arrow.start, arrow.end): ((QUARTER * arrow.ends[0], QUARTER * arrow.ends[1]), arrow.absolute)
        for arrow in base.arrows
    }
    images = {mark.name: (_letters_of(plan, mark), QUARTER * at(mark.point, column)) for mark in base.letters}
    joined = list(rods.values())
    for mark in (*(load.at for load in lever.loads), *(end for pair in lever.pairs for end in pair[1:3]), lever.driven):
        place = at(mark.point, column)
        name = _new(mark.name, place, images)
        if name is not None and mark.name != lever.pole.name:
            images[name] = name, place
            joined.append(((0j, place), True))
    spots = tuple((name, letters, place) for name, (letters, place) in images.items())
    return Hanging(column, lever.pole.name, spots, tuple(joined), tuple(_hung_forces(lever, column)))


def figures(shown: Hanging, letter: str) -> tuple[Hanging, ...]:
    """Give the lever, and with it the detail of what acts about its pole, where that is too near one another on it."""
    whole = max(map(abs, shown.points)) or 1.0
    shares = {force.at: tied(abs(force.at) / whole) for force in shown.forces}
    gaps = [(tied(b / a), a) for a, b in pairwise(sorted({*shares.values()})) if a <= INNER]
    inner = [spot for spot, share in shares.items() if gaps and share <= max(gaps)[1]]
    spots = {tied_spot(spot) for spot in (0j, *inner)}
    apart = [abs(spot - other) for spot, other in combinations(spots, 2)]
    if not letter or len(spots) <= BOTH or tied(min(apart) / whole) >= TIGHT:
        return (shown,)
    near = max(map(abs, inner)) * (1 + NOTHING)
    images = tuple(image for image in shown.images if abs(image[2]) <= near)
    rods = tuple((_cut(rod, near), thin) for rod, thin in shown.rods if min(map(abs, rod)) <= near)
    shown = shown._replace(near=near, letter=letter)
    return shown, shown._replace(images=images, rods=rods, part=True)


def _cut(rod: Segment, near: float) -> Segment:
    start, end = sorted(rod, key=abs)
    share = STUB * near / abs(end - start) if abs(end) > near else 1.0
    return start, start + (end - start) * min(share, 1.0)


def _new(name: str, place: complex, images: Mapping[str, tuple[str, complex]]) -> str | None:
    """Name an image that is not drawn yet: with a prime where another has its letter; None where it is drawn."""
    near = NOTHING * max((abs(there) for _, there in images.values()), default=0.0)
    while name in images and not abs(images[name][1] - place) <= near:
        name += "'"
    return None if name in images else name


def _letters_of(plan: ForcePlan, image: Mark) -> str:
    letters = [plan.velocities.letter(name) for name, mark in plan.velocities.letters.items() if mark is image]
    return " ".join(dict.fromkeys((image.name, *letters)))


def _hung_forces(lever: Lever, column: int) -> Iterator[ShownVector]:
    """Give the forces that are not zero, the balancing one first; one at the hinge of the lever does nothing there."""
    driven, force = at(lever.driven.point, column), at(lever.force.point, column)
    every = [ShownVector(lever.force.name, BALANCE, driven, force)]
    for load in lever.loads:
        place, force = at(load.at.point, column), at(load.force.point, column)
        every.append(ShownVector(load.name, LOAD, place, force))
    for pair in lever.pairs:
        force = at(pair.force.point, column)
        ends = (pair.end, force), (pair.start, -force)
        every += [ShownVector(pair.force.name, PAIR, at(end.point, column), half) for end, half in ends]
    greatest = max(abs(force.value) for force in every)
    furthest = max(abs(force.at) for force in every)
    yield from (force for force in every if abs(force.value) > ZERO * greatest and abs(force.at) > ZERO * furthest)


def balance(shown: Hanging, drafting: Drafting) -> tuple[LeverTerm, ...]:
    """Give the terms of the lever's equation of moments."""
    return terms(shown.forces, [(true, letters.split(" ")[0]) for _, letters, true in shown.images], drafting)


def weight(shown: Hanging) -> float:
    """Tell how many times as large as other figures a lever wants to be: where its forces act near one another."""
    spots = {tied_spot(spot) for spot in (0j, *(force.at for force in shown.forces))}
    apart = [abs(spot - other) for spot, other in combinations(spots, 2)] or [1.0]
    return min(max(max(apart) / min(apart) / ROOMY, EVEN), LARGER)


def measure(shown: Hanging, drafting: Drafting) -> Picture:
    """Measure the room that a lever needs: its images, the forces and letters around them, its heading."""
    hand = drafting.hand
    # Forces reach one of their length from their images, or two where many share a line there.
    lines = [(tied_spot(push.at), push.direction**2) for push in shown.pushes]
    shared = (sum(at == image and abs(way - line) < PARALLEL for image, way in lines) for at, line in lines)
    reach = LONGEST + (SHORTEST + AFTER if max(shared, default=0) > BOTH else 0.0)
    margins = around(MARGINS, hand, *(reach * hand.symbol,) * 3)
    least = hand.letter * max(LETTERS, EACH * len(lines))
    title = heading_width(_title(shown, drafting), hand)
    return picture(shown.plan, [*shown.points, *_feet(shown, drafting)], (SYMBOL, UNIT), margins, title, least)


def _armed(shown: Hanging, drafting: Drafting) -> list[LeverTerm]:
    return [term for term in balance(shown, drafting) if term.dimensioned and shown.has(term.at)]


def _feet(shown: Hanging, drafting: Drafting) -> Iterator[complex]:
    for term in _armed(shown, drafting):
        across = 1j * term.direction / abs(term.direction)
        yield across * (term.at * across.conjugate()).real


def draw(shown: Hanging, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the lever in its spot: the turned plan on its hinge, the forces not to scale, arms of the greatest."""
    place, hand = room.place(*spot), drafting.hand
    subject = Subject(shown.plan, SYMBOL, shown.column)
    drawn = ((place.on(start), place.on(end), thin) for (start, end), thin in shown.rods)
    rods = [Line(a, b, hand.other if thin else hand.relative) for a, b, thin in drawn if abs(b - a) >= LEAST]
    taken = Taken([(rod.start, rod.end) for rod in rods], [], spot.box)
    arrows = placed_forces(shown.pushes, place, taken, drafting)
    circle = Circle(place.on(0j), HINGE * hand.symbol, hand.body)
    kept = placed_arms(_armed(shown, drafting), place, taken, subject, hand)
    arms = [ends for arm in kept for ends in (arm.reach(hand), (arm.about, arm.ends[0]), (arm.at, arm.ends[1]))]
    downward = _downward([*taken.rods, *taken.forces], arms, place.on(0j), hand)
    stand = fixed_hinge(place.on(0j), hand, HINGE * hand.symbol, downward)
    told = [drafting.word("lever arms")] if not shown.part and balance(shown, drafting) else []
    under = ";  ".join((drafting.scale(spot.scale), *told))
    mark = Circle(0j, POINT * hand.symbol, LineStyle(hand.thin, fill="#ffffff"))
    spots = ((name, true, mark._replace(centre=place.on(true))) for name, _, true in shown.images)
    dots = [point(subject, name, true, place, dot) for name, true, dot in spots]
    lines = (
        heading(spot.box, _title(shown, drafting), under, hand),
        *([Group(tuple(stroke for arm in kept for stroke in arm.draw(hand)))] if kept else []),
        Group((*rods, *stand)), *_drawn(arrows, shown, drafting), *dots,
        point(subject, shown.pole, 0j, place, circle, "pole"),
        *(Group((rim,), "", {"kind": "detail", "name": shown.letter}) for rim in _rims(shown, place, hand)),
    )  # fmt: skip
    name = f"{shown.plan}-{shown.column}"
    return LetteredFigure(name, lines, partial(_letters, shown, place, arrows, kept, rods, hand))


def _rims(shown: Hanging, place: Place, hand: Hand) -> Iterator[Circle]:
    if shown.near and not shown.part:
        yield Circle(place.on(0j), place.length(shown.near) + AROUND * hand.symbol, hand.drafted)


def _letters(
    shown: Hanging, place: Place, arrows: Sequence[ForceArrow], arms: Sequence[Arm], rods: Sequence[Line], hand: Hand,
    labels: Labels,
) -> Iterator[Stroke]:  # fmt: skip
    images = [(0j, shown.pole), *((true, letters) for _, letters, true in shown.images)]
    spots = ((place.on(true), letters.split(" ")) for true, letters in images)
    yield from letter_images(spots, hand.number, labels, HINGE * hand.symbol + 1.0)
    yield from letter_each(arms, labels, hand, (*arrows, *rods))
    yield from letter_each(arrows, labels, hand)
    for rim in _rims(shown, place, hand):
        yield labels.beside(rim.centre, shown.letter, hand.letter, rim.radius + BESIDE)


def _drawn(arrows: Sequence[ForceArrow], shown: Hanging, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the forces, each as what it states, and lines that lead to them; the second of a couple is turned round."""
    hand = drafting.hand
    yield from (Line(arrow.lead, arrow.at, hand.drafted) for arrow in arrows if arrow.lead is not None)
    first = {letter_of(force.name, drafting): force.direction for force in reversed(shown.forces)}
    for arrow in arrows:
        turned = (arrow.direction * first[arrow.letter].conjugate()).real < 0
        name = f"−{plain_name(arrow.letter)}" if turned else plain_name(arrow.letter)
        yield stating(Statement(Kind.DIRECTION, shown.plan, name, shown.column), arrow.draw(hand))


def _title(shown: Hanging, drafting: Drafting) -> str:
    if shown.part:
        return drafting.word("detail", letter=shown.letter)
    return f"{drafting.word('lever')}, {drafting.word('position', position=shown.column)}"


BARE = str.maketrans("′", "'", "{}")


def of_arm(study: Study, position: int, letter: str) -> str:
    """Name the moment that an arm h_2 gives on the record, or the force that is found by it, p(F_us); "" if none is."""
    if not letter.startswith("h") or not 0 <= position < len(study.of(LinkageStudy).turn):
        return ""
    plans: ForcePlans = study.of(Statics).drafts([position]).plans
    return next((name for arm, name in _lettered_arms(study, plans) if arm.translate(BARE) == letter), "")


def _lettered_arms(study: Study, plans: ForcePlans) -> Iterator[tuple[str, str]]:
    for cut in plans.plan.cuts:
        for arm in leverages(plans.plan, cut, 0):
            moment = f"{arm.about}({arm.name})"
            yield arm.letter, moment if moment in plans.plan.board else arm.name
    if plans.lever is not None:
        for term in balance(hanging(plans.plan, plans.lever, 0), drafting_of(study.scene)):
            moment = f"{plans.lever.pole.name}({term.force.partition('/')[0]})"
            yield term.arm, moment if moment in plans.lever.board else term.force
