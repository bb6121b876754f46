"""Velocity and acceleration plans as figures, each to a scale of its own; a plan that is not there (планы)."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import combinations
from typing import NamedTuple, TypeAlias

import numpy as np

from drawings.kinds.vector_plan import LEAST, directions, letter_images
from drawings.kinds.working import DIGITS, LENGTHS, READING, ScaleFactor, Workings, at_scale
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, StillFigure, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.words import runs, with_index
from drawings.linkage.coriolis import LaidPart, QuarterTurn, draw_nearby, is_relative, letter_parts, quarter_turn
from drawings.page.page import Drafting, Field, Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Kind, Line, LineStyle, Statement, Stroke, Text
from drawings.symbols.figure import PLAN_LETTERS, Subject, around, heading, point, vector
from drawings.symbols.symbols import ARROW_LENGTH, pole
from geometry.board import Line as Direction
from geometry.board import Mark, at, behind
from plans.linkage.parts import spans
from plans.linkage.plan import Plan, unnamed
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import Mechanism
from plans.model.motion import NOTHING, ORDERS, Motion


def measure_missing(why: str, name: str, drafting: Drafting) -> Picture:
    """Measure the room of the sentence."""
    size = drafting.hand.text
    return picture(name, [0j], ("v", "m/s"), Margins(size, size, size), text_width(Text(0j, why, size)))


def draw_missing(why: str, name: str, spot: Spot, drafting: Drafting) -> StillFigure:
    """Write the sentence in the middle of its spot, under the name of the plan."""
    return StillFigure((Group((Text(spot.box.centre, why, drafting.hand.text, "middle", True),), name),))


def remarks(plans: Sequence[Picture], spots: Mapping[str, Spot], drafting: Drafting) -> Iterator[str]:
    """Say of each order which plans are enlarged, and how large they would be at the common scale, mm."""
    for order in ORDERS[1:]:
        of_order = {int(plan.name.rsplit("-", 1)[1]): plan for plan in plans if plan.name.startswith(order.plan)}
        shown = {k: plan for k, plan in sorted(of_order.items()) if max(plan.wide, plan.high) and plan.name in spots}
        scales = {k: spots[plan.name].scale for k, plan in shown.items()}
        common = max(scales.values(), key=lambda scale: scale.mu, default=None)
        enlarged = {k: plan.extent(common) for k, plan in shown.items() if common and scales[k] != common}
        if common and enlarged:
            yield drafting.word(
                f"own scale {order.plan}", positions=runs(enlarged), scale=drafting.scale(common),
                sizes=" … ".join(dict.fromkeys(f"{end(enlarged.values()):.0f}" for end in (min, max))),
            )  # fmt: skip


MARGINS = Margins(2.6, 2.0, 2.0)  # paper around a plan for its letters, in their sizes
NONE: Mapping[str, tuple[int, complex]] = {}
EACH = 1.6  # of its letters for each image: a plan is drawn at least so large
SAME = 1e-6  # of a vector: two constructions of one point differ by rounding, a ten-thousandth of a mm on no sheet
VECTOR = {order.plan: order.point for order in ORDERS}  # what the vectors of a plan are


class PlanArrow(NamedTuple):
    """A vector of a plan between two marks, in true units."""

    start: Mark
    end: Mark
    ends: tuple[complex, complex]
    absolute: bool

    @property
    def name(self) -> str:
        """The vector by the letters of its ends, such as pb or ab."""
        return f"{self.start.name} {self.end.name}"


class VectorDiagram(NamedTuple):
    """What one position of a plan shows: vectors, lines of known direction, and the letters at its points."""

    plan: Plan
    column: int  # place of the position among the constructed ones
    arrows: tuple[PlanArrow, ...]
    rays: tuple[tuple[complex, complex], ...]  # true ends of lines of known direction: from its start to the meeting
    letters: tuple[Mark, ...]
    turned: tuple[QuarterTurn, ...]  # the Coriolis parts' directions
    centres: Mapping[str, Mark]  # images of mass centres that no point names, by their letters
    sides: tuple[tuple[complex, complex], ...]  # of the similar figures by which they are placed
    parts: Mapping[tuple[Mark, Mark], tuple[str, ...]] = {}  # letters of relative vectors and of parts, by their ends

    @property
    def name(self) -> str:
        """The name of the figure."""
        return f"{self.plan.board.subject}-{self.column}"

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        ends = [end for arrow in self.arrows for end in arrow.ends]
        return [0j, *ends, *(end for line in (*self.rays, *self.sides) for end in line)]

    @property
    def is_whole(self) -> bool:
        """Whether its position has all of it: at a dead centre there may be no acceleration."""
        return bool(np.isfinite(self.points).all())

    @property
    def images(self) -> list[complex]:
        """The places of images, but for the pole, each once: those at rest need no room there, nor several in one."""
        near, found = SAME * max((abs(end) for end in self.points), default=0.0), list[complex]()
        for end in (end for arrow in self.arrows for end in arrow.ends):
            if all(abs(end - other) > near for other in (0j, *found)):
                found.append(end)
        return found


Diagrams: TypeAlias = Mapping[tuple[str, int], VectorDiagram]


def diagrams(study: LinkageStudy, analysis: Motion, positions: Sequence[int]) -> Diagrams:
    """Give what each plan of velocities and accelerations of some positions shows, by its name and position."""
    drafts, masses = study.drafts(), unnamed(study.scene, study.mechanism.links)
    found = defaultdict[tuple[Mark, Mark], tuple[str, ...]](tuple)
    for name, span in spans(study, drafts, analysis).items():
        found[span.start, span.end] += (name,)
    plans = [(order, k, drafts.plan(order.number)) for order in ORDERS[1:] for k in positions]
    return {(order.plan, k): diagram(plan, k, masses)._replace(parts=found) for order, k, plan in plans}


def diagram(plan: Plan, column: int, masses: Mapping[str, tuple[int, complex]] = NONE) -> VectorDiagram:
    """Read a figure from a plan's record: what the named points and the links' rates rest on is drawn, no more.

    Of the mass centres of links, each by its letter with its link and place there, the images are drawn by similarity.
    """
    centres = {name: plan.place(*mass, plan.letter(name)) for name, mass in masses.items()}
    lettered = set(plan.letters.values())
    unnamed = dict.fromkeys(m for m in centres.values() if m not in lettered)  # in order: a set of marks has none
    turning = [*(reading.turning for reading in plan.readings.values()), *plan.slips.values()]
    needed = [mark for mark in behind(*plan.letters.values(), *unnamed, *turning) if mark.subject == plan.board.subject]
    images = [mark for mark in needed if mark.rays and mark is not plan.pole]
    arrows: dict[tuple[Mark, Mark], PlanArrow] = {}
    for mark in images:
        for start, _ in mark.rays if mark not in unnamed else ():
            if start.rays or start is plan.pole:
                arrows.setdefault((start, mark), _arrow(plan, start, mark, column))
    for mark in images:
        if mark.step.op == "meet" or mark in plan.letters.values() or mark in unnamed:
            arrows.setdefault((plan.pole, mark), _arrow(plan, plan.pole, mark, column))
    for start, end in (mark.step.inputs for mark in turning if mark.step.op == "join"):
        if end.step.op == "lay_off" and start is not plan.pole:  # a point that similarity gives
            arrows.setdefault((start, end), _arrow(plan, start, end, column))
    rays = tuple(ray for mark in needed if mark.step.op == "meet" for ray in _rays(mark, column))
    rules = tuple(rule for mark in needed if (rule := quarter_turn(mark, column)) is not None)
    sides = tuple(s for name, mass in masses.items() for s in _sides(plan, mass[0], centres[name], arrows, column))
    return VectorDiagram(plan, column, _once(arrows.values()), rays, tuple(images), rules, centres, sides)


def _once(arrows: Iterable[PlanArrow]) -> tuple[PlanArrow, ...]:
    """Give each arrow once: the point of a link under a pin is found again for each pair that the pin has there."""
    kept: dict[str, list[PlanArrow]] = {}
    for arrow in arrows:
        alike = kept.setdefault(arrow.name, [])
        if not any(abs(arrow.ends[1] - other.ends[1]) <= SAME * abs(arrow.ends[1]) for other in alike):
            alike.append(arrow)
    return tuple(arrow for alike in kept.values() for arrow in alike)


def _sides(
    plan: Plan, link: int, centre: Mark, drawn: Collection[tuple[Mark, Mark]], column: int
) -> Iterator[tuple[complex, complex]]:
    """Give the sides of the similar figure of a link by which a mass centre is placed, where no arrow shows them."""
    image = plan.images[link]
    if image.arm is None or centre is image.origin or image.arm.step.inputs in drawn:
        return
    start, end = at(image.origin.point, column), at(centre.point, column)
    yield start, end
    if image.arm.step.op == "join":  # of a link that a slot directs the arm is a unit, and ends at no image
        yield end, start + at(image.arm.point, column)


def _arrow(plan: Plan, start: Mark, end: Mark, column: int) -> PlanArrow:
    return PlanArrow(start, end, (at(start.point, column), at(end.point, column)), start is plan.pole)


def _rays(mark: Mark, column: int) -> list[tuple[complex, complex]]:
    lines = [line.value for line in mark.step.inputs if isinstance(line.value, Direction)]
    return [(at(line.through, column), at(mark.point, column)) for line in lines]


def measure(shown: VectorDiagram, drafting: Drafting) -> Picture:
    """Measure the room that a plan needs: its points, letters around them, its heading above."""
    kind, hand = shown.plan.board.subject, drafting.hand
    title = text_width(Text(0j, drafting.word(kind, position=shown.column), hand.title))
    least = hand.letter * max(PLAN_LETTERS, EACH * len(shown.images))
    scale = VECTOR[kind].symbol, VECTOR[kind].unit
    return picture(shown.name, shown.points, scale, around(MARGINS, hand), title, least)


def draw(shown: VectorDiagram, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the plan in its spot, with its title and its written scale above it."""
    kind, place, hand = shown.plan.board.subject, room.place(*spot), drafting.hand
    subject = Subject(kind, VECTOR[kind].symbol, shown.column)
    under = drafting.scale(spot.scale) if any(shown.points) else drafting.word("at rest")
    title = heading(spot.box, drafting.word(shown.plan.board.subject, position=shown.column), under, hand)
    sides = (Line(place.on(start), place.on(end), hand.drafted) for start, end in shown.sides)
    lines = Group((*directions(shown.rays, place, hand), *(s for s in sides if abs(s.end - s.start) >= LEAST)))
    named = dict.fromkeys(shown.arrows)
    long = (arrow for arrow in named if place.length(abs(arrow.ends[1] - arrow.ends[0])) >= LEAST)
    arrows = [vector(subject, arrow.name, arrow.ends, place, _style(shown, arrow, hand)) for arrow in long]
    dot = point(subject, shown.plan.pole.name, 0j, place, pole(place.on(0j)), "pole")
    strokes = (title, *([lines] if lines.strokes else []), *arrows, dot)
    return LetteredFigure(shown.name, strokes, partial(_letter, shown, place, spot.box, drafting), False)


def _letter(shown: VectorDiagram, place: Place, box: Field, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Letter the images and parts; off all letters draw beside the plan how its Coriolis parts are directed."""
    hand = drafting.hand
    yield Group(tuple(letter_images(_images(shown, place), hand.letter, labels)))
    lines = [(place.on(arrow.ends[0]), place.on(arrow.ends[1])) for arrow in shown.arrows]
    parts = letter_parts(_parts(shown, place, drafting), lines, labels, hand, shown.name)
    yield from (parts,) if parts.strokes else ()
    for rule in shown.turned:
        told = rule._replace(letter=drafting.letter(with_index(_coriolis(shown, rule.letter))))
        nearby = draw_nearby(told, box, labels.ink, hand) if place.length(rule.size) >= LEAST else None
        yield from () if nearby is None else (nearby,)


def _coriolis(shown: VectorDiagram, name: str) -> str:
    """Name a Coriolis part as the vector of the plan that it is: a^k_A3A for a^k_A."""
    image = name.removeprefix("a^")
    letters = (letter for (_, end), names in shown.parts.items() if end.name == image for letter in names)
    return next((letter for letter in letters if letter.startswith("a^k_")), name)


def _parts(shown: VectorDiagram, place: Place, drafting: Drafting) -> Iterator[LaidPart]:
    """Lay the parts that have letters and are long enough to bear them."""
    for arrow in shown.arrows:
        names = shown.parts.get((arrow.start, arrow.end), ())
        for name in (letter for letter in names if is_relative(letter, arrow.name)):
            said = Statement(Kind.LETTER, shown.plan.board.subject, f"{arrow.name} {name}", shown.column)
            letter = drafting.letter(with_index(name))
            part = LaidPart(place.on(arrow.ends[0]), place.on(arrow.ends[1]), letter, said)
            least = text_width(Text(0j, letter, drafting.hand.number, "start", True))
            yield from (part,) if part.length >= least + ARROW_LENGTH * drafting.hand.symbol else ()


def _style(shown: VectorDiagram, arrow: PlanArrow, hand: Hand) -> LineStyle:
    """Give the line of a vector: main from the pole, thinner to mass centres and between points, thin for parts."""
    if arrow.absolute and arrow.end not in shown.centres.values():
        return hand.result
    return hand.relative if arrow.absolute or arrow.end.step.op == "meet" else LineStyle(hand.thin)


def _images(shown: VectorDiagram, place: Place) -> Iterator[tuple[complex, list[str]]]:
    """Give the pole and every image with its letters; mass centres that rest are at the pole."""
    plan = shown.plan
    resting = [plan.letter(name) for name, mark in shown.centres.items() if mark is plan.pole]
    yield place.on(0j), [plan.pole.name, *resting]
    points = (*plan.letters.items(), *shown.centres.items())
    for mark in shown.letters:
        letters = [plan.letter(name) for name, image in points if image is mark]
        yield place.on(at(mark.point, shown.column)), [mark.name, *letters]


def link_working(mechanism: Mechanism, links: Sequence[int], name: str, drafting: Drafting) -> Workings:
    """Write beside a figure how long some links are drawn on it."""
    lines = at_scale(lambda scale: list(_link_lines(mechanism, links, scale, drafting)))
    return Workings(LENGTHS, name, lines, drafting)


def _link_lines(
    mechanism: Mechanism, links: Sequence[int], scale: Scale | None, drafting: Drafting
) -> Iterator[tuple[str, ...]]:
    factor = ScaleFactor(scale, "l", drafting)
    for link in links:
        for (first, start), (last, end) in combinations(mechanism.links[link].points.items(), 2):
            size, ends = abs(end - start), with_index(first) + with_index(last)
            if size > 0:
                drawn, paper = factor.drawn(f"l_{{{first}{last}}}"), f"{factor.length(size)} {drafting.word('mm')}"
                yield f"{ends} = {drawn}", factor.of_true(size), paper


def plan_working(shown: VectorDiagram, name: str, drafting: Drafting) -> Workings:
    """Write beside a plan how each of its vectors is read."""
    return Workings(READING, name, at_scale(lambda scale: list(_plan_lines(shown, scale, drafting))), drafting)


def _plan_lines(shown: VectorDiagram, scale: Scale | None, drafting: Drafting) -> Iterator[tuple[str, ...]]:
    point = VECTOR[shown.plan.board.subject]
    factor, largest = ScaleFactor(scale, point.symbol, drafting), max(map(abs, shown.points))
    for arrow in shown.arrows:
        size = abs(arrow.ends[1] - arrow.ends[0])
        if size <= NOTHING * largest:
            continue
        segment = with_index(arrow.start.name) + with_index(arrow.end.name)
        for letter in _letters_of(shown, arrow, point.symbol):
            amount = f"{drafting.number(size, DIGITS)} {drafting.word(point.unit)}"
            yield f"{drafting.letter(with_index(letter))} = {factor.true(segment)}", factor.of_drawn(size), amount


def _letters_of(shown: VectorDiagram, arrow: PlanArrow, symbol: str) -> Iterator[str]:
    """Give all that a vector is: the velocities of the points whose image is its end, and parts."""
    points = (*shown.plan.letters.items(), *shown.centres.items()) if arrow.absolute else ()
    names = [f"{symbol}_{name}" for name, image in points if image is arrow.end]
    yield from dict.fromkeys((*names, *shown.parts.get((arrow.start, arrow.end), ())))
