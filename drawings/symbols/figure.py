"""A figure: a plan placed on paper, its strokes measurable, and dimensions on it (фигура листа, размеры)."""

import cmath
import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from drawings.layout.labels import SHARES, Labels, Lines
from drawings.layout.parallel_offsets import nearest
from drawings.layout.picture import Margins, Picture, Place
from drawings.lettering.lettering import text_width
from drawings.page.page import Scale
from drawings.paper.hand import Field, Hand
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import (
    LEAN,
    NO_DATA,
    Circle,
    Group,
    Line,
    LineStyle,
    Polyline,
    Statement,
    Stroke,
    Text,
    numeral,
    stated,
)
from drawings.paper.walk import stating, tied
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead

PLAN_LETTERS = 12.0  # a plan is drawn at least so many of its letters large, and as many as it has: below, they hide it
LINE = 1.6  # from one line below a title to the next, in sizes of their letters


class Subject(NamedTuple):
    """What a figure's marks belong to: the plan's name, its quantity, its position; None is every position."""

    plan: str
    quantity: str
    position: int | None

    def data(self, kind: str, name: str, value: complex, scale: Scale) -> dict[str, str]:
        """Give the data of a mark that can be measured."""
        return {
            "kind": kind,
            "plan": self.plan,
            "quantity": self.quantity,
            "name": name,
            **({"position": str(self.position)} if self.position is not None else {}),
            "value": stated(value),
            "unit": scale.unit,
            "scale": numeral(scale.mu),
        }


def vector(
    subject: Subject, name: str, ends: tuple[complex, complex], place: Place, style: LineStyle, symbol: float = 1.0
) -> Group:
    """Draw a vector between two true ends, full length to the arrow's tip, and say what it is."""
    start, end = place.on(ends[0]), place.on(ends[1])
    head = arrowhead(start, end, symbol)
    strokes = (Line(start, end, style),) if head is None else (Line(start, end, style), head)
    return Group(strokes, "", subject.data("vector", name, ends[1] - ends[0], place.scale), name)


def point(
    subject: Subject, name: str, value: complex, place: Place, circle: Circle, kind: str = "point", title: str = ""
) -> Group:
    """Draw a point or a pole by its circle, and say what it is; its title is its name, or another one."""
    return Group((circle,), "", subject.data(kind, name, value, place.scale), title or name)


def around(sizes: Margins, hand: Hand, side: float = 0.0, below: float = 0.0, above: float = 0.0) -> Margins:
    """Give the paper around a figure, mm: for its letters, in their sizes, for what reaches beyond it, its heading."""
    beside, under, over = (size * hand.letter for size in sizes)
    return Margins(beside + side, under + below, over + above + 2 * hand.title + hand.text)


def heading_width(title: str, hand: Hand) -> float:
    """Give the width of a figure's title, mm, with what slanted letters lean beyond it."""
    return text_width(Text(0j, title, hand.title)) + 2 * LEAN * hand.title


def heading(box: Field, title: str, under: str, hand: Hand, *further: str) -> Group:
    """Write a figure's title and its scale, or what is said instead, at the top of its box; further lines below."""
    at = complex(box.centre.real, box.top - hand.title)
    low = at - 1j * (0.6 * hand.title + hand.text)
    lines = ((low - 1j * k * LINE * hand.text, line) for k, line in enumerate((under, *further)))
    texts = (Text(place, line, hand.text, "middle", True) for place, line in lines)
    return Group((Text(at, title, hand.title, "middle", True), *texts))


def explained(room: Picture, lines: Sequence[str], hand: Hand) -> Picture:
    """Give the room of a figure that has further lines below its title and its scale: they go wherever it goes."""
    wide = (text_width(Text(0j, line, hand.text)) for line in lines)
    above = room.margins.above + LINE * hand.text * len(lines)
    return room._replace(margins=room.margins._replace(above=above), heading=max((room.heading, *wide)))


def plain_name(letter: str) -> str:
    """Name a force or an arm by its letter, without the braces of its index.

    >>> plain_name("R^t_{34}")
    'R^t_34'
    """
    return letter.replace("{", "").replace("}", "")


ROOM = 2.4  # lengths of an arrow that a dimension line is long at least with both within it
PAST = 1.5  # mm that an extension line goes past the dimension line


class Dimension(NamedTuple):
    """A distance dimensioned beside it: its letter, its ends, and the way to its line, mm."""

    letter: str
    start: complex
    end: complex
    off: complex
    states: Statement | None = None

    @property
    def length(self) -> float:
        """The distance on paper, mm."""
        return abs(self.end - self.start)

    @property
    def middle(self) -> complex:
        """The middle of its line: beside it stands the letter."""
        return (self.start + self.end) / 2 + self.off

    @property
    def lines(self) -> tuple[tuple[complex, complex], ...]:
        """The dimension line, then the two extension lines."""
        past = self.off * (1 + PAST / abs(self.off))
        ends = ((end, end + past) for end in (self.start, self.end))
        return (self.start + self.off, self.end + self.off), *ends

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw its lines, its arrows within or, where there is no room, outside."""
        line, *others = arrows(*self.lines[0], hand)
        extensions = (Line(*ends, hand.drafted) for ends in self.lines[1:])
        drawn = line, *extensions, *others
        return drawn if self.states is None else (stating(self.states, *drawn),)


def roomy(length: float, hand: Hand) -> bool:
    """Tell whether both arrows of a dimension have room within it."""
    return tied(length - ROOM * ARROW_LENGTH * hand.symbol) > 0


def arrows(start: complex, end: complex, hand: Hand) -> tuple[Stroke, ...]:
    """Draw a dimension line with arrows at both ends: within or, where there is no room, outside."""
    along = (end - start) / abs(end - start) * ARROW_LENGTH * hand.symbol
    tails = (end, start) if roomy(abs(end - start), hand) else (start - 2 * along, end + 2 * along)
    heads = (arrowhead(tail, tip, hand.symbol) for tail, tip in zip(tails, (start, end), strict=True))
    outer = () if tails[0] == end else (Line(tails[0], tails[1], hand.drafted),)
    return Line(start, end, hand.drafted), *outer, *(head for head in heads if head is not None)


BEYOND = 4.0  # mm that a line of action is drawn past the foot of the perpendicular
SQUARE = 2.5  # side of the mark of a right angle
LEAST = 0.5  # mm: a shorter arm is a point on paper
BESIDE = 1.0  # mm from the perpendicular to its letter
STATIONS = 7  # places along an arm where its letter may stand: none near its ends, where arms meet


class Arm(NamedTuple):
    """The arm of a force about a point: places on paper, and the unit direction of the force."""

    letter: str
    about: complex
    at: complex  # a place on the line of action: where the force acts, or the end of its arrow
    direction: complex
    data: Mapping[str, str] = NO_DATA  # of a measurable one
    aside: float = 0.0  # mm along the force: where lines run on the perpendicular it is dimensioned beside them

    @property
    def ends(self) -> tuple[complex, complex]:
        """The ends of the line that is dimensioned: on the perpendicular or aside of it."""
        return self.about + self.aside * self.direction, self.foot + self.aside * self.direction

    @property
    def foot(self) -> complex:
        """The foot of the perpendicular on the line of action."""
        return self.at + self.direction * ((self.about - self.at) * self.direction.conjugate()).real

    @property
    def length(self) -> float:
        """Length on paper, mm."""
        return abs(self.foot - self.about)

    def reach(self, hand: Hand) -> tuple[complex, complex]:
        """Give the ends of the line that is dimensioned, or of the arrows outside it where they have no room within."""
        (start, end), length = self.ends, self.length
        tail = 0j if not length or roomy(length, hand) else 2 * (end - start) / length * ARROW_LENGTH * hand.symbol
        return start - tail, end + tail

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw the perpendicular, the line of action as far as its foot, and the mark of the right angle."""
        group = Group(arrows(*self.ends, hand), "", self.data, self.letter)
        return self._action(hand), *self._extension(hand), *self._square(hand), group

    def _extension(self, hand: Hand) -> tuple[Line, ...]:
        """Draw the line from the point of moments to a perpendicular that is dimensioned aside."""
        past = math.copysign(BEYOND / 2 * hand.symbol, self.aside)
        return (
            (Line(self.about, self.about + (self.aside + past) * self.direction, hand.drafted),) if self.aside else ()
        )

    def _action(self, hand: Hand) -> Line:
        """Draw the line of action from the force's point to a little past the foot, or past what stands aside of it."""
        end = self.ends[1]
        along = end - self.at
        ahead = along / abs(along) if abs(along) > QUANTUM else self.direction
        return Line(self.at, end + ahead * BEYOND * hand.symbol, hand.drafted)

    def _square(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw the mark of the right angle, on the side of the force's point."""
        side = SQUARE * hand.symbol
        if self.length < 2 * side:
            return ()
        foot = self.ends[1]
        back = self.at - foot
        along = (back / abs(back) if abs(back) > LEAST else self.direction) * side
        across = (self.about - self.foot) / self.length * side
        return (Polyline((foot + along, foot + along + across, foot + across), False, hand.drafted),)

    def letter_beside(self, labels: Labels, hand: Hand, others: Lines = ()) -> Stroke:
        """Letter it beside its middle, or as near to that as it can, or the further arrow of those that stand outside.

        The letter is no nearer to `others`; where one runs so near above that it would be between both, it is below.
        """
        start, end = self.ends
        along = [start + share * (end - start) for share in SHARES[:STATIONS]]
        first, *further = along if roomy(self.length, hand) else [(end + self.reach(hand)[1]) / 2]
        across = 1j * (self.foot - self.about)
        above = -across if tied(across.imag) < 0 else across  # as on any dimension line
        over, under = (first + way * hand.letter / (abs(way) or 1.0) for way in (above, -above))
        bare, other = (min((abs(nearest(*o, at) - at) for o in others), default=math.inf) for at in (over, under))
        if tied(bare - min(other, hand.letter)) < 0:
            above = -above
        return labels.beside(first, self.letter, hand.letter, BESIDE, cmath.phase(above), others, further)


def to_scale(letter: str, about: complex, at: complex, direction: complex, scale: Scale, subject: Subject) -> Arm:
    """Give an arm on a scheme drawn to scale, measurable: the vector from the point to the line of action."""
    arm = Arm(letter, about, at, direction / abs(direction))
    return arm._replace(data=subject.data("vector", plain_name(letter), (arm.foot - about) * scale.mu, scale))
