"""The figure of a polygon of static moments or of their moments: vectors end to end, and what closes them."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_reach, text_width
from drawings.lettering.phrase import telling
from drawings.lettering.rotor_letters import INDEX, lowered
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.statement import Statement
from drawings.paper.strokes import LEAN, Group, Line, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.polygon import LaidVector, ShownVector, carriers, ends, lay, letters, margins
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead, pole
from plans.model.rotor import Balance, Rotor
from plans.rotor.balancing import COUPLES
from plans.rotor.balancing import Polygon as Construction

FEW, CROWD = 9, 40  # masses: of more each is numbered alone; of more still the table alone tells them apart


def letter(name: str, count: int, drafting: Drafting) -> str:
    """Letter one of so many vectors: with its letters, or of many masses by the number of its mass alone."""
    number = INDEX.search(name)
    if count > FEW and number is not None and number[1].isdigit():
        return number[1]
    return lowered(name, drafting.language)


def size(text: str, drafting: Drafting) -> float:
    """Give the size of a letter, mm: numbers alone are smaller."""
    return drafting.hand.number if text.isdigit() else drafting.hand.letter


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


SYMBOLS = {COUPLES: ("{mDh}", "kg*m2")}  # letter and unit of the scale
SYMBOL = ("{mD}", "kg*m")
MARGINS = Margins(4.0, 2.4, 2.4)  # paper around a polygon for its letters, in their sizes
LETTERS, EACH = 14.0, 1.8  # a polygon is drawn at least so many letters large, and so many for each of its vectors
ROOM = 4.7 + 1.9j  # width + 1j * height of a letter between two lanes, in its sizes, with what it keeps clear of them
SIDE, RESULT = "side", "result"  # what a vector is: given, or found
SUM = "Σ"  # before the letters of all vectors together, that stand for more than can be told apart


class RotorPolygon(NamedTuple):
    """What a polygon shows: the vectors in the order of laying, the closing one last if there is one."""

    plan: str  # the board: "couples" or "unbalances"
    vectors: tuple[ShownVector, ...]
    closed: bool  # by itself, so that no vector closes it

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(end for one in self.vectors for end in (one.at, one.end))]

    @property
    def subject(self) -> Subject:
        """What its marks belong to."""
        return Subject(self.plan, self.symbol[0].strip("{}"), None)

    @property
    def symbol(self) -> tuple[str, str]:
        """The letter of its scale, and its unit."""
        return SYMBOLS.get(self.plan, SYMBOL)

    def faint(self, mu: float) -> tuple[str, ...]:
        """Name the vectors that are not to be seen at a scale: a sheet lists them beside."""
        return tuple(one.name for one in self.vectors if abs(one.value) < SEEN * mu)


def polygon(construction: Construction, names: frozenset[str] = frozenset()) -> RotorPolygon:
    """Read a polygon from its record; `names` are vectors in it that are results themselves."""
    vectors = [
        ShownVector(one.name, RESULT if one.name in names else SIDE, complex(start.point), complex(one.point))
        for one, start in ((side.vector, side.start) for side in construction.sides)
    ]
    if len(vectors) > CROWD:
        vectors = _together(vectors, construction.board.subject)
    if not construction.closed:
        start = vectors[-1].end if vectors else 0j
        vectors.append(ShownVector(construction.closing.name, RESULT, start, complex(construction.closing.point)))
    return RotorPolygon(construction.board.subject, tuple(vectors), construction.closed)


def _together(vectors: Sequence[ShownVector], plan: str) -> list[ShownVector]:
    """Draw one vector for all that are no results."""
    results = [one for one in vectors if one.kind == RESULT]
    end = results[0].at if results else vectors[-1].end
    return [ShownVector(sum_letters(plan), SIDE, 0j, end), *results]


def sum_letters(plan: str) -> str:
    """Letter all vectors of a polygon together."""
    return SUM + SYMBOLS.get(plan, SYMBOL)[0].strip("{}")


@dataclass(frozen=True)
class RotorPolygonFigure:
    """A polygon placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: RotorPolygon
    place: Place
    lines: tuple[Stroke, ...]
    arrows: tuple[LaidVector, ...]  # those that are lettered
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure with the letter of each vector beside it, the shortest served first."""
        zero = labels.beside(self.place.on(0j), "0", self.drafting.hand.letter, 1.6, -math.pi / 4)
        beside = letters(self.arrows, self._mark, labels)
        return (Group((*self.lines, Group((zero, *beside))), self.shown.plan),)

    def _mark(self, name: str) -> tuple[str, float]:
        text = letter(name, len(self.shown.vectors), self.drafting)
        return text, size(text, self.drafting)


def measure(shown: RotorPolygon, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs: its points, letters around them, lanes beside a flat one, its heading."""
    hand = drafting.hand
    title = text_width(Text(0j, _title(shown, drafting), hand.title)) + 2 * LEAN * hand.title
    least = hand.letter * max(LETTERS, EACH * min(len(shown.vectors), FEW))
    return picture(shown.plan, shown.points, shown.symbol, margins(shown.points, MARGINS, hand), title, least)


def draw(shown: RotorPolygon, room: Picture, spot: Spot, drafting: Drafting) -> RotorPolygonFigure:
    """Draw the polygon in its spot: results in main lines, the others thinner, title and scale above."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, _title(shown, drafting), _under(shown, spot, drafting), hand)
    zero = point(shown.subject, "0", 0j, place, pole(place.on(0j)), "pole")
    order = sorted(shown.vectors, key=lambda one: (one.kind != RESULT, -tied(place.length(abs(one.value)))))
    seen = [one for one in order if tied(place.length(abs(one.value))) >= SEEN]
    arrows = lay(seen, place, spot.box, ROOM, hand)
    short = (LaidVector(one, ends(one, place)) for one in order if one not in seen)
    thin = carriers(arrows, place, hand)
    sides = (_side(shown, one, place, drafting) for one in (*reversed(arrows), *short))
    return RotorPolygonFigure(shown, place, (title, *thin, *sides, zero), arrows, drafting)


def _side(shown: RotorPolygon, one: LaidVector, place: Place, drafting: Drafting) -> Group:
    hand, vector = drafting.hand, one.vector
    style = hand.result if vector.kind == RESULT else hand.relative
    text = letter(vector.name, len(shown.vectors), drafting)
    return one.draw(shown.subject, text, place, style, hand.symbol)


def _title(shown: RotorPolygon, drafting: Drafting) -> str:
    return drafting.word("polygon of moments" if shown.plan == COUPLES else "polygon of static moments")


def _under(shown: RotorPolygon, spot: Spot, drafting: Drafting) -> str:
    """Write the scale; of a polygon that closes by itself that it does, and what is too short to bear a letter."""
    if not shown.vectors:
        return drafting.word("no vectors")
    parts = [drafting.scale(spot.scale)]
    parts += [drafting.word("closes by itself")] if shown.closed else []
    faint = ", ".join(lowered(name, drafting.language) for name in shown.faint(spot.scale.mu))
    parts += [drafting.word("unlettered", names=faint)] if faint else []
    return ";  ".join(parts)
