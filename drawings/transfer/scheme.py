"""The scheme of a mechanism in one position with the turned velocity plan on it (схема с повёрнутым планом)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

from drawings.kinds.vector_plan import LEAST
from drawings.kinds.working import READING, ScaleFactor, Workings, at_scale
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot
from drawings.lettering.transfer_letters import markup
from drawings.lettering.words import with_index
from drawings.linkage.pose import Pose, letters, measured, scheme
from drawings.linkage.skeleton import Pairs
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Group, Line, Polyline, Stroke
from drawings.symbols.figure import SQUARE, Subject, heading, vector
from drawings.transfer.angles import EqualAngle, equal_angles, right_angles
from geometry.board import Mark, at, behind
from plans.transfer.study import TransferFunctions
from plans.transfer.turned import TRANSFER, TurnedPlan

MARGINS = Margins(3.5, 3.5, 3.5)
LETTERS = 26.0  # it is drawn at least so many of its letters large
BEYOND = 6.0  # mm that a line of known direction is drawn past its meeting
SHORT = 0.02  # of the mechanism: on shorter sides no mark of an angle is drawn
RADIUS, APART, PAST = 9.0, 1.6, 3.0  # mm: of the arc of an angle, between two arcs, of a side past the arc


class TurnedScheme(NamedTuple):
    """A scheme to be drawn with the turned plan of its position; the plan's column is the position's number."""

    bones: Pose
    plan: TurnedPlan
    column: int

    @property
    def name(self) -> str:
        """The name of the figure."""
        return f"turned-{self.column}"

    @property
    def images(self) -> list[Mark]:
        """The images but for the pole: all that the named points and the ratios rest on."""
        turning = (reading.turning for reading in self.plan.readings.values())
        found = behind(*self.plan.images.values(), *turning)
        return [mark for mark in found if mark.subject == TRANSFER and mark.rays]

    def on(self, mark: Mark) -> complex:
        """Give the place of an image in the position, m."""
        return at(mark.point, self.column)

    @property
    def vectors(self) -> list[tuple[Mark, Mark]]:
        """The vectors by their ends: each image from the pole, and from the image that it was found from."""
        pole = self.plan.pole
        kept = {mark for mark in self.images if mark.step.op == "meet" or mark in self.plan.images.values()}
        found = [(pole, mark) for mark in self.images if mark in kept]
        found += [(start, mark) for mark in self.images for start, _ in mark.rays if start.rays]
        return list(dict.fromkeys(found))

    @property
    def equal(self) -> list[EqualAngle]:
        """The angles of the plan that are those of the scheme."""
        points = {name: self.bones.spot(name, 0) for name in self.bones.numbered.points}
        return list(equal_angles(self.plan, points, self.column, SHORT * self.bones.reach))

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [*self.bones.points, *(self.on(mark) for mark in self.images)]


def measure(shown: TurnedScheme, drafting: Drafting) -> Picture:
    """Measure the room of a scheme with its plan."""
    return measured(shown.name, shown.points, _title(shown, drafting), (MARGINS, LETTERS), drafting)


def draw(shown: TurnedScheme, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw it in its spot."""
    place, hand, subject = room.place(*spot), drafting.hand, Subject(TRANSFER, "r", shown.column)
    pairs, angles = Pairs(shown.bones, place, hand), list(_angles(shown, place, hand))
    title = heading(spot.box, _title(shown, drafting), drafting.scale(spot.scale), hand)
    plan = (*_rays(shown, place, hand), *_vectors(shown, subject, place, hand))
    lines = (title, *scheme(pairs, subject, angles), *plan)
    return LetteredFigure(shown.name, lines, partial(_letters, shown, pairs))


def _title(shown: TurnedScheme, drafting: Drafting) -> str:
    return drafting.word("turned plan", position=shown.column)


def _rays(shown: TurnedScheme, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the lines in whose meetings images were found, a little past these."""
    for mark in shown.images:
        for line in mark.step.inputs if mark.step.op == "meet" else ():
            start, end = place.on(shown.on(line.step.inputs[0])), place.on(shown.on(mark))
            if abs(end - start) >= LEAST:
                yield Line(start, end + (end - start) / abs(end - start) * BEYOND * hand.symbol, hand.drafted)


def _vectors(shown: TurnedScheme, subject: Subject, place: Place, hand: Hand) -> Iterator[Group]:
    for start, end in shown.vectors:
        ends = shown.on(start), shown.on(end)
        if place.length(abs(ends[1] - ends[0])) >= LEAST:
            style = hand.result if start is shown.plan.pole else hand.relative
            yield vector(subject, f"{start.name} {end.name}", ends, place, style)


def _angles(shown: TurnedScheme, place: Place, hand: Hand) -> Iterator[Stroke]:
    for vertex, ways in right_angles(shown.images, shown.column, SHORT * shown.bones.reach):
        spot, (first, second) = place.on(vertex), (way * SQUARE * hand.symbol for way in ways)
        yield Polyline((spot + first, spot + first + second, spot + second), False, hand.drafted)
    for count, equal in enumerate(shown.equal, 1):
        yield from _equal(equal, count, place, hand)


def _equal(equal: EqualAngle, count: int, place: Place, hand: Hand) -> Iterator[Stroke]:
    radii = [(RADIUS + APART * k) * hand.symbol for k in range(count)]
    for vertex, ways in ((equal.image, equal.on_plan), (equal.point, equal.on_scheme)):
        spot, turn = place.on(vertex), cmath.phase(ways[1] / ways[0])
        start = cmath.phase(ways[0] if turn > 0 else ways[1])
        yield from (Arc(spot, radius, start, start + abs(turn), hand.drafted) for radius in radii)
    spot, reach = place.on(equal.point), radii[-1] + PAST * hand.symbol
    yield from (Line(spot, spot + reach * way, hand.drafted) for way in equal.on_scheme)


def _letters(shown: TurnedScheme, pairs: Pairs, labels: Labels) -> Iterator[Stroke]:
    names: dict[Mark, list[str]] = {mark: [mark.name] for mark in shown.images}
    for point, mark in shown.plan.images.items():
        names.get(mark, []).append(shown.plan.letters[point])
    return letters(pairs, ((shown.on(mark), texts) for mark, texts in names.items()), labels)


def working(shown: TurnedScheme, told: Sequence[TransferFunctions], drafting: Drafting) -> Workings:
    """Write beside a scheme how its transfer functions are read off."""
    lines = at_scale(lambda scale: [_line(shown, of, ScaleFactor(scale, "l", drafting)) for of in told])
    return Workings(READING, shown.name, lines, drafting)


def _line(shown: TurnedScheme, of: TransferFunctions, factor: ScaleFactor) -> tuple[str, ...]:
    start, end = of.shown(shown.plan)
    value, size = at(of.read(shown.plan), shown.column).real, factor.length(abs(shown.on(end)))
    sign, number = "−" if value < 0 else "", factor.drafting.number(value)
    letter = f"{markup(of.names[0])} = {sign}"
    if isinstance(of.of, int):
        segments = ("".join(with_index(mark.name) for mark in part.step.inputs) for part in (end, start))
        return letter + "/".join(segments), f"{sign}{size}/{factor.length(abs(shown.on(start)))}", number
    segment = with_index(start.name) + with_index(end.name)
    drawn = f"{sign}{factor.of_drawn(abs(shown.on(end)))}"
    return letter + factor.true(segment), drawn, f"{number} {factor.drafting.word(of.unit)}"
