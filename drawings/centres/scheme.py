"""A scheme with its instant centres, each on the lines in which it was found; the polygon of links (центры)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from drawings.kinds.vector_plan import SAME
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot
from drawings.lettering.lettering import text_width
from drawings.lettering.words import with_index
from drawings.linkage.pose import Pose, letters, measured, scheme
from drawings.linkage.skeleton import Pairs
from drawings.page.page import Drafting
from drawings.paper.strokes import INK, Circle, Line, Stroke, Text
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import arrowhead, fit_dashes
from plans.centres.centrodes import window
from plans.centres.kennedy import CENTRES, InstantCentre, Kennedy, letter, pairs

MARGINS = Margins(4.5, 4.5, 5.0)
LETTERS = 40.0  # it is drawn at least so many of its letters large
PAST, AWAY, DOT, BESIDE = 5.0, 18.0, 1.1, 2.0  # mm: past a centre, towards one far off, its radius, to its letter


class CentresScheme(NamedTuple):
    """A scheme to be drawn with the centres of its position."""

    bones: Pose
    found: Kennedy
    column: int

    @property
    def name(self) -> str:
        """The name of the figure."""
        return f"kennedy-{self.column}"

    @property
    def near(self) -> list[InstantCentre]:
        """The centres that are drawn in their places; one farther off is shown by the direction to it."""
        middle, most = window(self.bones.points)
        centres = (centre for centre in self.found.found.values() if not centre.infinite)
        return [centre for centre in centres if abs(centre.place - middle) <= most]

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [*self.bones.points, *(centre.place for centre in self.near)]


def measure(shown: CentresScheme, drafting: Drafting) -> Picture:
    """Measure the room of a scheme with its centres."""
    return measured(shown.name, shown.points, _title(shown, drafting), (MARGINS, LETTERS), drafting)


def draw(shown: CentresScheme, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw it in its spot."""
    place, hand = room.place(*spot), drafting.hand
    drawing = _DrawnCentres(shown, Pairs(shown.bones, place, hand), place, drafting)
    title = heading(spot.box, _title(shown, drafting), drafting.scale(spot.scale), hand)
    lines = (title, *drawing.lines(), *scheme(drawing.pairs, drawing.subject), *drawing.marks())
    return LetteredFigure(shown.name, lines, drawing.letters)


def _title(shown: CentresScheme, drafting: Drafting) -> str:
    return drafting.word("centres scheme", position=shown.column)


class _DrawnCentres:
    """A scheme with its centres at its place on paper."""

    def __init__(self, shown: CentresScheme, pairs: Pairs, place: Place, drafting: Drafting) -> None:
        self.shown, self.pairs, self.place, self.drafting = shown, pairs, place, drafting
        self.subject, self.hand = Subject(CENTRES, "r", shown.column), pairs.sheet
        self.near = {centre.pair: place.on(centre.place) for centre in shown.near}

    @cached_property
    def away(self) -> dict[tuple[int, int], tuple[complex, complex]]:
        """Where the directions to the centres far off are drawn: from where to where, one of each."""
        found = {}
        for centre in self.shown.found.found.values():
            spots = [] if centre.pair in self.near else list(self._starts(centre))
            if spots:
                way = centre.place if centre.infinite else self.place.on(centre.place) - spots[0]
                start = max(spots, key=lambda spot: (spot * way.conjugate()).real)
                way = way if centre.infinite else self.place.on(centre.place) - start
                found[centre.pair] = start, start + way / abs(way) * AWAY * self.hand.symbol
        return found

    def _starts(self, centre: InstantCentre) -> Iterator[complex]:
        """Give where a direction may begin: at the block of a slide, or at centres on the lines that lead there."""
        for slide in self.pairs.bones.mechanism.slides if not centre.over else ():
            if {slide.slider, slide.owner} == set(centre.pair):
                yield self.place.on(complex(self.pairs.bones.numbered.blocks(slide)[0]))
        ends = (tuple(sorted((one, over))) for over in centre.over for one in centre.pair)
        yield from (self.near[end] for end in ends if end in self.near)

    def lines(self) -> Iterator[Stroke]:
        """Draw each line of three centres that leads to one, as far as they lie on paper, and directions to others."""
        for centre in self.shown.found.found.values():
            for over in centre.over:
                ends = [tuple(sorted((one, over))) for one in centre.pair]
                spots = [self.near[end] for end in (*ends, centre.pair) if end in self.near]
                first, last = max(
                    ((a, b) for a in spots for b in spots), key=lambda two: abs(two[1] - two[0]), default=(0j, 0j)
                )
                if abs(last - first) > SAME:
                    past = (last - first) / abs(last - first) * PAST * self.hand.symbol
                    yield Line(first - past, last + past, self.hand.drafted)
        for start, end in self.away.values():
            yield Line(start, end, self.hand.drafted)
            if (head := arrowhead(start, end, self.hand.symbol)) is not None:
                yield head

    def marks(self) -> Iterator[Stroke]:
        """Mark the centres that are no hinges."""
        for centre in self.shown.near:
            if centre.over:
                circle = Circle(self.near[centre.pair], DOT * self.hand.symbol, INK)
                yield point(self.subject, letter(centre.pair), centre.place, self.place, circle)

    def letters(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the points with the centres in them, the other centres, and the directions."""
        yield from letters(self.pairs, ((one.place, [letter(one.pair)]) for one in self.shown.near), labels)
        for pair, (start, end) in self.away.items():
            name, infinite = with_index(letter(pair)), self.shown.found.found[pair].infinite
            text = f"{name} → ∞" if infinite else self.drafting.word("centre far", letter=name)
            yield labels.beside(end, text, self.hand.letter, BESIDE, cmath.phase(end - start))


RADIUS, ROUND = 24.0, 3.6  # mm: of the polygon's circle, and of a number's circle
NAME = "polygon"


def polygon(found: Kennedy, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the polygon of links: a vertex a link, a full side a pair, a dashed one a centre that is found."""
    hand, links = drafting.hand, sorted(found.plan.mechanism.links)
    radius, middle = RADIUS * hand.symbol, spot.box.centre - 1j * hand.title
    ways = {link: cmath.rect(1.0, cmath.pi / 2 - 2 * cmath.pi * n / len(links)) for n, link in enumerate(links)}
    known = {pair for pair, centre in found.found.items() if not centre.over}
    small, strokes = ROUND * hand.symbol, list[Stroke]()
    for pair in pairs(links):
        start, end = (middle + radius * ways[link] for link in pair)
        step = (end - start) / abs(end - start) * small
        strokes.append(Line(start + step, end - step, hand.relative if pair in known else hand.path))
    for link, way in ways.items():
        at = middle + radius * way
        strokes += [Circle(at, small, hand.other), Text(at - 0.5j * hand.text * 0.7, str(link), hand.text, "middle")]
    head = heading(spot.box, drafting.word("centres polygon"), " ", hand)
    return LetteredFigure(NAME, (head, *fit_dashes(strokes)), lambda labels: ())


def room(drafting: Drafting) -> Picture:
    """Measure the polygon's room, mm on paper."""
    size = 2 * (RADIUS + ROUND) * drafting.hand.symbol
    title = text_width(Text(0j, drafting.word("centres polygon"), drafting.hand.title))
    side = drafting.hand.text
    margins = Margins(side, side, side + 2.5 * drafting.hand.title)
    return Picture(NAME, size, size, 0j, "l", "mm", margins, title, 0.0, exact=1.0)
