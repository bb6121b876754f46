"""The layout of compensators at phi = 0, to scale: two shafts against each other, the couple's (компенсатор)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.words import lowered_bank
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Kind, Line, LineStyle, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Dimension, Subject, around, heading, point
from drawings.symbols.symbols import HINGE, POINT, TurnArrow, fit, hinge
from plans.bank.harmonics import letters, roman
from plans.model.balance.bank import Compensator

SYMBOL, UNIT, QUANTITY = "l", "m", "r"
MARGINS = Margins(4.6, 5.0, 3.0)  # paper around it for letters, in their sizes
LETTERS, MOST = 14.0, 36.4  # it is drawn at least so many letters large, and at most
BODY = 2.4  # mm, radius of a mass
BESIDE = 1.0  # mm from a mass to its letter
OFF = 7.0  # mm from what is dimensioned to its line
TURN = (math.radians(200), math.radians(70))  # start and sweep of the arrow on a shaft


def _letters(
    shown: CompensatorLayout, place: Place, sizes: Sequence[Dimension], hand: Hand, labels: Labels
) -> Iterator[Stroke]:
    """Letter the crank's shaft, each mass outward, each shaft with the speed at which it turns, the sizes."""
    yield labels.beside(place.on(0j), "O", hand.letter, BESIDE + HINGE * hand.symbol, -math.pi / 4)
    for weight in shown.weights():
        spot, gap = place.on(weight.shaft + weight.arm), BODY * hand.symbol + BESIDE
        yield labels.beside(spot, lowered_bank(weight.name), hand.letter, gap, cmath.phase(weight.arm))
    middle = TURN[0] + TURN[1] / 2
    for weight in shown.weights():
        spot = place.on(weight.shaft) + cmath.rect(arrow_radius(shown, place), middle)
        yield labels.beside(spot, speed(weight.turns), hand.number, BESIDE, middle)
    for size in sizes:
        yield labels.along(*size.lines[0], size.letter, hand.number, BESIDE, cmath.phase(size.off))


def arrow_radius(shown: CompensatorLayout, place: Place) -> float:
    """Give the radius of the arrow on a shaft, mm."""
    return 0.55 * place.length(shown.gear)


def measure(shown: CompensatorLayout, drafting: Drafting) -> Picture:
    """Measure the room that the layout needs."""
    hand = drafting.hand
    title = text_width(Text(0j, title_of(shown, drafting), hand.title))
    margins = around(MARGINS, hand, *(OFF * hand.symbol,) * 3)
    found = picture(shown.name, list(shown.points()), (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    return found._replace(most=MOST * hand.letter)


def title_of(shown: CompensatorLayout, drafting: Drafting) -> str:
    """Give the title of a layout."""
    if shown.found.on_crank:
        return drafting.word("counterweight on crank")
    return drafting.word("compensator of order", order=shown.found.asked.order)


def draw(shown: CompensatorLayout, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the layout in its spot: guide and line of the compensators, gears, shafts, masses, sizes."""
    place, hand = room.place(*spot), drafting.hand
    under = drafting.scale(spot.scale) + ("" if shown.known else f";  {drafting.word('arms nominal')}")
    title = heading(spot.box, title_of(shown, drafting), under, hand)
    sizes = tuple(_sizes(shown, place, drafting))
    lines: list[Stroke] = [title, *_axes(shown, place, hand)]
    lines += [stroke for weight in shown.weights() for stroke in _gear(shown, weight, place, hand)]
    lines += [_mass(shown, weight, place, hand) for weight in shown.weights()]
    lines += [stroke for size in sizes for stroke in size.draw(hand)]
    (circle,) = hinge(place.on(0j), hand)
    lines.append(point(Subject(shown.name, QUANTITY, None), "O", 0j, place, circle, "pole"))
    return LetteredFigure(shown.name, tuple(lines), partial(_letters, shown, place, sizes, hand))


def _axes(shown: CompensatorLayout, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the line of the force through the shaft of the crank, and that of the compensators beside it."""
    far = place.length((1 if shown.found.on_crank else 2 + UNDER) * shown.gear) * shown.line
    up = (HINGE + 4) * hand.symbol * shown.line
    offset = place.on(shown.offset * shown.across)
    for start in [place.on(0j)] + ([offset] if abs(offset - place.on(0j)) > POINT else []):
        yield Line(start - far, start + up, fit(hand.axis, abs(far) + abs(up)))


def _gear(shown: CompensatorLayout, weight: ShaftMass, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw a shaft with its gear and the sense in which it turns; the couple's shafts have no gears of their own."""
    centre, (start, sweep), sense = place.on(weight.shaft), TURN, math.copysign(1.0, weight.turns * shown.sense)
    if weight.geared and not shown.found.on_crank:
        radius = place.length(shown.gear)
        yield Circle(centre, radius, fit(hand.axis, math.tau * radius, True))
    begin = start if sense > 0 else start + sweep
    yield from TurnArrow(centre, arrow_radius(shown, place), begin, sense * sweep).draw(hand)
    yield Circle(centre, POINT * hand.symbol, LineStyle(hand.main, fill="#ffffff"))


def _mass(shown: CompensatorLayout, weight: ShaftMass, place: Place, hand: Hand) -> Group:
    """Draw a mass on its arm; it can be measured where its radius is known."""
    known = shown.known and weight.geared
    ends = place.on(weight.shaft), place.on(weight.shaft + weight.arm)
    dashed = fit(hand.result._replace(dash=hand.dashed), abs(ends[1] - ends[0]))
    way = Kind.VECTOR, shown.name, weight.name, None, place.scale.mu
    line = Line(*ends, hand.result if known else dashed)
    arm: Stroke = stating(Statement(*way), line) if known else line
    circle, subject = Circle(ends[1], BODY * hand.symbol, INK), Subject(shown.name, QUANTITY, None)
    if not known:
        return Group((arm, Group((circle,), "", {}, weight.name)))
    body = point(subject, weight.name, weight.shaft + weight.arm, place, circle)
    return Group((arm, body._replace(title=lowered_bank(weight.name))))


def _sizes(shown: CompensatorLayout, place: Place, drafting: Drafting) -> Iterator[Dimension]:
    """Dimension the offset of the compensators' line, and the distance of the couple's shafts."""
    asked, off = shown.found.asked, OFF * drafting.hand.symbol
    if shown.offset:
        up = (off + HINGE * drafting.hand.symbol) * shown.line
        text = f"z = {drafting.number(1000 * shown.offset)}"
        yield Dimension(text, place.on(0j), place.on(shown.offset * shown.across), up)
    shafts = [place.on(weight.shaft) for weight in shown.weights() if not weight.geared]
    if shafts and asked.shafts:
        aside = -(place.length(SHARE * shown.gear) + off) * shown.across
        first, last = shafts
        yield Dimension(f"L = {drafting.number(1000 * asked.shafts)}", first, last, aside)


COMPENSATOR = "compensator"  # the names of the figures, before the order
MASS, COUPLED = "m", "m_M,"  # letters of the masses, and of those that make a couple
ROUND, SHARE = 1.25, 0.8  # a gear's radius in that of its mass; where that cannot be drawn, the mass's in the gear's
OF_OFFSET, OF_SHAFTS = 0.5, 0.15  # a gear's radius in offset and distance of shafts at the least
NOMINAL = 0.1  # m, radius of a gear where nothing gives a size
SMALL = 0.4  # of a gear's radius: a mass nearer to its shaft would cover it
UNDER = 1.6  # radii of a gear from the crank's shaft down to the gears of the compensator
PAIR = 2
NEAR = 1e-9  # of a unit direction


def speed(turns: int) -> str:
    """Write the speed of a shaft in that of the crank.

    >>> speed(1), speed(-2)
    ('ω', '−2ω')
    """
    return ("" if turns > 0 else "−") + (f"{abs(turns)}ω" if abs(turns) > 1 else "ω")


class ShaftMass(NamedTuple):
    """A mass of a compensator: its letter, its shaft and its place from that one, m, and how fast it turns."""

    name: str
    shaft: complex
    arm: complex
    turns: int  # times as fast as the crank, against it with a minus
    geared: bool  # with the other one; a mass of the couple's compensator is not


class CompensatorLayout(NamedTuple):
    """The compensators of one order as the sheet shows them, m from the shaft of the crank."""

    found: Compensator
    turn: complex  # direction of the reference guide on the sheet
    sense: float  # of the crank's rotation, its sign

    @property
    def name(self) -> str:
        """The name of the figure."""
        return f"{COMPENSATOR}-{self.found.asked.order}"

    @property
    def line(self) -> complex:
        """The line of the largest force of the order, from the shaft to where the guide goes."""
        angles = self.found.with_angle, self.found.against_angle
        if angles[0] is None or angles[1] is None:  # the force of one mass goes round
            return self.turn
        along = cmath.rect(1.0, (angles[0] + angles[1]) / 2)
        back = along.real < -NEAR or (along.real < NEAR and along.imag < 0)
        return self.turn * (-along if back else along)

    @property
    def across(self) -> complex:
        """The direction of a positive offset: to the left of the line."""
        return 1j * self.line

    @property
    def paired(self) -> bool:
        """Whether two masses are needed: one alone stands on the line itself."""
        return self.found.with_angle is not None and self.found.against_angle is not None

    @property
    def radii(self) -> tuple[float, float]:
        """The radii m of the masses that turn with the crank and against it; 0 where no mass is given."""
        mass = self.found.asked.mass
        return (self.found.with_crank / mass, self.found.against / mass) if mass else (0.0, 0.0)

    @property
    def known(self) -> bool:
        """Whether the radii of the masses are to scale: they are given, and none is too small."""
        return min((radius for radius in self.radii if radius), default=0.0) > SMALL * self.gear

    @property
    def offset(self) -> float:
        """The distance m of the line of the compensators from the crank's shaft, on which a counterweight is."""
        return 0.0 if self.found.on_crank else self.found.asked.offset

    @property
    def gear(self) -> float:
        """The radius m of the gears as they are drawn."""
        shafts = (self.found.asked.shafts if self.found.couple_angle is not None else None) or 0.0
        least = max(abs(self.offset) * OF_OFFSET, shafts * OF_SHAFTS)
        return max(max(self.radii) * ROUND, least) or NOMINAL

    @property
    def middle(self) -> complex:
        """The middle between the two shafts, on the line of the compensators; the crank's shaft of a counterweight."""
        return 0j if self.found.on_crank else self.offset * self.across - (1 + UNDER) * self.gear * self.line

    def weights(self) -> Iterator[ShaftMass]:
        """Give the masses that are needed, at phi = 0: the one that turns with the crank on the left."""
        order, found = self.found.asked.order, self.found
        angles = (found.with_angle, found.against_angle)
        for radius, angle, sense in zip(self.radii, angles, (1, -1), strict=True):
            if angle is not None:
                arm = cmath.rect(radius if self.known else SHARE * self.gear, angle) * self.turn
                shaft = self.middle + (sense * self.gear * self.across if self.paired else 0j)
                yield ShaftMass(letters(MASS, sense * order), shaft, arm, sense * order, True)
        yield from self._couple()

    def _couple(self) -> Iterator[ShaftMass]:
        """Give the masses of the couple's compensator, the one farther along the line first."""
        angle, shafts, order = self.found.couple_angle, self.found.asked.shafts, self.found.asked.order
        if angle is not None and shafts:
            beside = self.middle - (PAIR + ROUND) * PAIR * self.gear * self.across
            for side, prime in ((1, ""), (-1, "'")):
                arm = side * cmath.rect(SHARE * self.gear, angle) * self.turn
                yield ShaftMass(
                    f"{COUPLED}{roman(order)}{prime}", beside + side * shafts / 2 * self.line, arm, order, False
                )

    def points(self) -> Iterator[complex]:
        """Give all true points that the figure must hold."""
        yield 0j
        for weight in self.weights():
            yield from (weight.shaft + side * self.gear for side in (1, -1, 1j, -1j))
