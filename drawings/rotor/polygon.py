"""A rotor as it is seen, and its polygons of static moments or of their moments (ротор и его многоугольники)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from drawings.kinds.polygon import RESULT, SIDE, Letters, Polygon, ShownVector, Sizes
from drawings.lettering.lettering import text_reach, text_width
from drawings.lettering.phrase import telling
from drawings.lettering.rotor_letters import INDEX, lowered
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Statement
from drawings.paper.strokes import Group, Line, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead
from plans.model.rotor import Balance, Rotor
from plans.rotor.balancing import COUPLES
from plans.rotor.balancing import Polygon as Construction

CROWD = 40  # masses: of more the table alone tells them apart


def letters_of(drafting: Drafting) -> Letters:
    """Letter vectors and masses; of many each has the number of its mass alone."""
    return Letters(partial(lowered, language=drafting.language), _number)


def _number(name: str) -> str:
    found = INDEX.search(name)
    return found[1] if found is not None and found[1].isdigit() else ""


PAST = 1.5  # mm an extension line goes past the lowest arrow
ABOVE = 0.9  # mm from the dimension line to its number
TALL = 1.6  # sizes of a number with its index, and paper over it
TAIL = 8.0  # mm of a dimension line outside its extension lines, where its arrows stand outside


def dimension(base: float, last: float, level: float, sense: float, text: str, hand: Hand, states: Statement) -> Group:
    """Draw a level dimension from a base, mm, in a sense +1 or -1: where it is short its number is beyond the base."""
    wide = text_width(Text(0j, text, hand.number, "middle", True))
    start, end = complex(base, level), complex(last, level)
    along, tail = complex(sense), TAIL * hand.symbol
    roomy, fits = abs(end - start) >= 2 * ARROW_LENGTH * hand.symbol + 2, abs(end - start) >= room_for(text, hand)
    tips = [(end, start), (start, end)] if roomy else [(start - 2 * tail * along, start), (end + 2 * tail * along, end)]
    shelf = start if roomy and fits else start - (tail + (0.0 if fits else wide + 2)) * along
    line = Line(shelf, end if roomy else end + tail * along, hand.drafted)
    middle = (start + end) / 2 if fits else shelf + (wide / 2 + 1) * along
    above = ABOVE - text_reach(Text(0j, text, hand.number, "middle", True))[0]  # an index hangs below its line
    letters = Text(middle + above * 1j, text, hand.number, "middle", True)
    heads = [head for tip in tips if (head := arrowhead(*tip, hand.symbol)) is not None]
    return Group((stating(states, line, *heads), telling(states.figure, letters)))


def room_for(text: str, hand: Hand) -> float:
    """Give the length of a dimension line over which a text stands, mm."""
    return text_width(Text(0j, text, hand.number, "middle", True)) + 2


def step(hand: Hand) -> float:
    """Give how far one dimension is from the next, mm: an extension line that ends here stays clear of its number."""
    return PAST + ABOVE + TALL * hand.number


def extension(across: float, top: float, bottom: float, hand: Hand) -> Stroke:
    """Draw the extension line of some dimensions down to the lowest of them."""
    return Line(complex(across, top), complex(across, bottom - PAST), hand.drafted)


SLIM = 5  # times as long as it is thick: a rotor of which no radius is known
NOMINAL = 0.8  # of the largest known radius: where a mass without one is drawn


class ShownBody(NamedTuple):
    """A mass or a counterweight: its name, its centre in a plane across the shaft m, its place along it m.

    One whose radius nothing gives stands at its angle alone; a counterweight is `added`.
    """

    name: str
    centre: complex
    place: float
    arm: float  # m, from the last plane of correction
    added: bool
    known: bool

    @property
    def mark(self) -> str:
        """Its letters: m_1."""
        return f"m_{self.name}"


class RotorView(NamedTuple):
    """A rotor to be seen: its bodies, the planes of correction, the bearings; metres."""

    bodies: tuple[ShownBody, ...]
    planes: tuple[tuple[str, float], ...]  # name and place
    bearings: tuple[float, ...]
    turning: float  # the sense in which it turns: 1, -1, or 0 where it is not given

    @property
    def reach(self) -> float:
        """The largest distance of a centre from the axis, m; 1 where no radius is known."""
        return max((abs(one.centre) for one in self.bodies), default=0.0) or 1.0

    @property
    def scaled(self) -> bool:
        """Whether some radius is known, so that the view has a scale."""
        return any(one.known for one in self.bodies)

    @property
    def many(self) -> bool:
        """Whether there are too many masses to letter each."""
        return len(self.bodies) > CROWD

    @property
    def distinct(self) -> tuple[ShownBody, ...]:
        """The bodies that are lettered and measured: of too many masses the counterweights alone."""
        return tuple(one for one in self.bodies if one.added or not self.many)

    @property
    def places(self) -> list[float]:
        """All places along the shaft, m."""
        return [*(one.place for one in self.bodies), *(place for _, place in self.planes), *self.bearings]


def rotor_view(rotor: Rotor, balance: Balance) -> RotorView:
    """Put masses and counterweights where they are; one that vanishes is left out."""
    radii = [one.radius for own in (rotor.masses, balance.corrections) for one in own if one.radius]
    nominal = NOMINAL * max(radii, default=_length(rotor) / SLIM)
    bodies = [_body(rotor, one.name, float(one.angle), one.place, one.radius, nominal) for one in rotor.masses]
    for one in balance.corrections:
        if one.moment.angle is not None:
            name, place = one.plane.name, one.plane.place
            bodies.append(_body(rotor, name, one.moment.angle, place, one.radius, nominal)._replace(added=True))
    planes = tuple((one.name, float(one.place)) for one in rotor.planes)
    turning = 0.0 if rotor.speed is None else math.copysign(1.0, rotor.speed)
    return RotorView(tuple(bodies), planes, tuple(map(float, rotor.bearings)), turning)


def _length(rotor: Rotor) -> float:
    """Give how far along the shaft the rotor reaches, m; 1 of a thin disc."""
    places = [*(one.place for one in rotor.masses), *(one.place for one in rotor.planes), *rotor.bearings]
    return float(max(places) - min(places)) or 1.0


def _body(rotor: Rotor, name: str, angle: float, place: Fraction, radius: float | None, nominal: float) -> ShownBody:
    centre = cmath.rect(radius or nominal, math.radians(angle))
    return ShownBody(name, centre, float(place), rotor.arm(place), False, bool(radius))


SCALES = {COUPLES: ("{mDh}", "kg*m2")}  # letter and unit of the scale
SCALE = ("{mD}", "kg*m")
SIZES = Sizes(14.0, 1.8, 4.7)
SUM = "Σ"  # before the letters of all vectors together, that stand for more than can be told apart


def polygon(construction: Construction, names: frozenset[str], drafting: Drafting) -> Polygon:
    """Read a polygon from its record; `names` are vectors in it that are results themselves."""
    vectors = [
        ShownVector(one.name, RESULT if one.name in names else SIDE, complex(start.point), complex(one.point))
        for one, start in ((side.vector, side.start) for side in construction.sides)
    ]
    plan = construction.board.subject
    if len(vectors) > CROWD:
        vectors = _together(vectors, plan)
    if not construction.closed:
        start = vectors[-1].end if vectors else 0j
        vectors.append(ShownVector(construction.closing.name, RESULT, start, complex(construction.closing.point)))
    title = drafting.word("polygon of moments" if plan == COUPLES else "polygon of static moments")
    scale = SCALES.get(plan, SCALE)
    return Polygon(plan, title, scale, tuple(vectors), construction.closed, letters_of(drafting), SIZES)


def _together(vectors: Sequence[ShownVector], plan: str) -> list[ShownVector]:
    """Draw one vector for all that are no results."""
    results = [one for one in vectors if one.kind == RESULT]
    end = results[0].at if results else vectors[-1].end
    return [ShownVector(sum_letters(plan), SIDE, 0j, end), *results]


def sum_letters(plan: str) -> str:
    """Letter all vectors of a polygon together."""
    return SUM + SCALES.get(plan, SCALE)[0].strip("{}")
