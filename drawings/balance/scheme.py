"""The scheme of balancing: mass centres, main-point vectors in lanes beside links, counterweights (рис. 8.6, 8.9)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.kinds.graph import stretches
from drawings.kinds.outlines import outlines, places
from drawings.kinds.polygon import LaidVector, ShownVector, carriers, letters
from drawings.kinds.scheme import link_numbers, ties
from drawings.layout.ink import Ink
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import APART, Segment, merging, offset
from drawings.layout.picture import Margins, Picture, Place, Spot, picture, traced
from drawings.lettering.words import CENTRE, counterweight, lowered
from drawings.linkage.guides import frame_slides, grounds, travel, turnings
from drawings.linkage.skeleton import Pairs, Skeletons
from drawings.linkage.trajectories import STILL, length
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import INK, Arc, Circle, Group, Line, LineStyle, Polyline, Stroke
from drawings.symbols.figure import Subject, around, heading, heading_width, plain_name
from drawings.symbols.symbols import MASS, POINT, cross, fit_dashes, mass_centre
from drawings.symbols.trimming import trim
from plans.model.balance.linkage import DISC, Counterweight
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes

BEFORE, AFTER = "before", "after"
ALONE = "alone"  # state of a linkage whose main points are not asked
SCHEME = "scheme-"  # before a state: the name of its scheme
CORNERS = 36  # points that stand for the rim of a counterweight


@dataclass(frozen=True)
class PlacedWeight:
    """A counterweight at its link in the shown position, m from the datum."""

    weight: Counterweight
    begin: complex  # where its link begins
    centre: complex

    @property
    def direction(self) -> complex:
        """The unit direction from its link's beginning to it."""
        return (self.centre - self.begin) / abs(self.centre - self.begin)

    @property
    def is_disc(self) -> bool:
        """Whether it is a disc about its centre, not a sector about its link's beginning."""
        return self.weight.place.shape == DISC

    @property
    def rim(self) -> list[complex]:
        """Points along its rim; of a sector the tip comes first."""
        radius, half = self.weight.outer, self.weight.place.half_angle
        if self.is_disc:
            return [self.centre + cmath.rect(radius, 2 * math.pi * k / CORNERS) for k in range(CORNERS)]
        turns = (half * (2 * k / CORNERS - 1) for k in range(CORNERS + 1))
        return [self.begin, *(self.begin + self.direction * cmath.rect(radius, turn) for turn in turns)]


@dataclass(frozen=True, eq=False)
class BalanceScheme:
    """The scheme before or after balancing in the shown position of a linkage."""

    state: str
    bones: Skeletons
    chain: tuple[ShownVector, ...]  # main-point vectors laid end to end from the datum, m
    paths: Mapping[str, Complexes]  # of the common mass centre over the turn, m, by state: its own comes last
    weights: tuple[PlacedWeight, ...] = ()
    whole: bool = True  # whether the crank turns fully: else the paths are known at the positions alone

    @property
    def name(self) -> str:
        """The name of its figure."""
        return SCHEME + self.state

    @property
    def centre(self) -> complex:
        """The common mass centre in the shown position."""
        return self.chain[-1].end if self.chain else 0j

    @property
    def shown(self) -> int:
        """The shown position."""
        return self.bones.shown

    @cached_property
    def named(self) -> dict[str, complex]:
        """The places of all named points and mass centres."""
        return places(self.bones)

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [spot for line in self.lines for spot in line]

    @cached_property
    def lines(self) -> list[list[complex]]:
        """All that the figure must hold, in true lines from point to point."""
        runs = (path[~np.isnan(path.real)].tolist() for path in self.paths.values())
        return [
            *([spot] for spot in (0j, *self.named.values(), self.centre)),
            *map(list, self._links()),
            *([vector.at, vector.end] for vector in self.chain),
            *(run for run in runs if run),
            *(weight.rim for weight in self.weights),
        ]

    def _links(self) -> Iterator[tuple[complex, complex]]:
        """Give all bars, slots as long as their stones' travel, and the frame's guides, by their ends."""
        numbered, k = self.bones.numbered, self.shown
        bars = [(outline.link, bar) for outline in outlines(self.bones, self.bones.travels) for bar in outline.bars]
        ends = [tuple(complex(numbered.of(link, spot)[k]) for spot in bar) for link, bar in bars]
        for slide, reach in self.bones.travels.items():
            if slide.owner == FRAME:
                ends.append(tuple(slide.on_owner.through + along * slide.on_owner.direction for along in reach))
        yield from ((start, other) for start, other in ends if not (math.isnan(start.real) or math.isnan(other.real)))


def placed_weight(weight: Counterweight, bones: Skeletons) -> PlacedWeight:
    """Place a counterweight on its link in the shown position."""
    ends = (complex(bones.numbered.of(weight.link, spot)[bones.shown]) for spot in (weight.origin, weight.centre))
    return PlacedWeight(weight, *ends)


MOST = 4  # lanes on either side that are tried


def lanes(segments: Sequence[Segment], bars: Sequence[Segment], toward: complex, apart: float) -> list[complex]:
    """Give the shift of each vector, mm, that keeps it off bars and off those before it; most have none.

    The nearest free lane is taken, of two the one on the side of a place `toward` which they go.

    >>> lanes([(0j, 50 + 0j)], [(0j, 90 + 0j)], 50 + 20j, 3.0)
    [3j]
    """
    kept, shifts = list(bars), list[complex]()
    for segment in segments:
        free = (shift for shift in _shifts(segment, toward, apart) if _clear(offset(segment, shift), kept))
        shifts.append(next(free, 0j))
        kept.append(offset(segment, shifts[-1]))
    return shifts


def _clear(segment: Segment, kept: Sequence[Segment]) -> bool:
    return not any(merging(segment, other) for other in kept)


def _shifts(segment: Segment, toward: complex, apart: float) -> Iterator[complex]:
    start, end = segment
    across = 1j * (end - start) / abs(end - start)
    side = across if ((toward - (start + end) / 2) * across.conjugate()).real >= 0 else -across
    yield 0j
    for step in range(1, MOST + 1):
        yield from (step * apart * side, -step * apart * side)


SYMBOL, UNIT = "l", "m"
MARGINS = Margins(3.5, 3.2, 2.6)  # paper around it for its letters and stands, in their sizes
PAST = 11.0  # mm of a guide's axis past its block's outermost places: within the margins, clear of the heading
LETTERS = 22.0  # it is drawn at least so many of its letters large
PATH, RIM = "path-", "rim-"  # before a state, before a link: how names of groups of lines end


@dataclass(frozen=True, eq=False)
class SchemeFigure:
    """A scheme placed on paper: its lines, and the letters still to be placed among those of all figures."""

    shown: BalanceScheme
    pairs: Pairs
    box: Spot
    drafting: Drafting

    @property
    def place(self) -> Place:
        """Where it lies on paper."""
        return self.pairs.place

    @property
    def subject(self) -> Subject:
        """What its marks belong to."""
        return Subject(self.shown.name, SYMBOL, self.shown.shown)

    @cached_property
    def lines(self) -> tuple[Stroke, ...]:
        """All its lines, from the thinnest to the pairs, the vectors over them."""
        ink = Ink()
        body, stands = list(self.pairs.bars()), list(self.pairs.stands())
        blocks = [block for _, block in self.pairs.blocks]
        ink.draw([*body, *blocks, *stands])
        under = [*self._axes(), *ties(self.pairs), *self._holders()]
        title = title_of(self.shown, self.drafting)
        return (
            heading(self.box.box, title, self.drafting.scale(self.box.scale), self._hand),
            *self._paths(),
            *fit_dashes(trim(under, self.pairs.masks)),
            *(self._outline(weight) for weight in self.shown.weights),
            *grounds(self.pairs, ink),
            *(*blocks, *body, *self.pairs.corners(), *stands),
            *(part for turning in turnings(self.pairs) for part in turning.strokes(self.pairs)),
            *self._marks(),
            *carriers(self.arrows, self.place, self._hand),
            *(self._arrow(arrow) for arrow in self.arrows),
            *self._centre(),
        )

    @property
    def _hand(self) -> Hand:
        return self.drafting.hand

    def _paths(self) -> Iterator[Group]:
        """Draw the path of the common mass centre: its own in a main line, the other thin; or its points alone."""
        for state, path in self.shown.paths.items():
            style = self._hand.result if state == self.shown.state else self._hand.other
            strokes = self._line(path, style) if self.shown.whole else self._dots(path, style)
            yield Group(tuple(strokes), f"{self.shown.name}-{PATH}{state}")

    def _line(self, path: Complexes, style: LineStyle) -> Iterator[Stroke]:
        runs = ([self.place.on(complex(path[k])) for k in run] for run in stretches(path.real))
        lines = [Polyline(tuple(spots), False, style) for spots in runs if length(np.array(spots)) > STILL]
        yield from fit_dashes(trim(lines, self.pairs.masks))

    def _dots(self, path: Complexes, style: LineStyle) -> Iterator[Stroke]:
        known = path[~np.isnan(path.real)].tolist()
        yield from (Circle(self.place.on(spot), style.width, INK) for spot in known)

    def _axes(self) -> Iterator[Stroke]:
        for slide in frame_slides(self.shown.bones):
            yield Line(*travel(self.shown.bones, slide, self.place, self.pairs.hand, PAST), self._hand.axis)

    def _holders(self) -> Iterator[Stroke]:
        for weight in self.shown.weights:
            if weight.is_disc:
                yield Line(self.place.on(weight.begin), self.place.on(weight.centre), self._hand.result)

    def _outline(self, weight: PlacedWeight) -> Group:
        return Group(tuple(trim(self._rim(weight), self.pairs.masks)), f"{self.shown.name}-{RIM}{weight.weight.link}")

    def _rim(self, weight: PlacedWeight) -> Iterator[Stroke]:
        """Draw a counterweight to scale: a disc about its centre, a sector about its link's beginning."""
        style, radius = self._hand.relative, self.place.length(weight.weight.outer)
        if weight.is_disc:
            yield Arc(self.place.on(weight.centre), radius, 0.0, 2 * math.pi, style)
            return
        tip, turn, half = self.place.on(weight.begin), cmath.phase(weight.direction), weight.weight.place.half_angle
        yield Arc(tip, radius, turn - half, turn + half, style)
        yield from (Line(tip, tip + cmath.rect(radius, end), style) for end in (turn - half, turn + half))

    def _marks(self) -> Iterator[Group]:
        """Draw hinges, mass centres, other points, and the centres of counterweights; all can be measured."""
        hand, scale = self.pairs.hand, self.place.scale
        yield from self.pairs.marks(self.subject, self.shown.bones.mechanism.drive.pivot)
        for weight in self.shown.weights:
            at, letter = self.place.on(weight.centre), counterweight(weight.weight.link, self.drafting.language)
            data = self.subject.data("point", plain_name(counterweight(weight.weight.link, "en")), weight.centre, scale)
            yield Group((Circle(at, POINT * hand.symbol, INK), *cross(at, hand)), "", data, letter)

    @cached_property
    def arrows(self) -> tuple[LaidVector, ...]:
        """The main-point vectors that are long enough to be seen, in lanes where they would lie on links."""
        vectors = [vector for vector in self.shown.chain if self.place.length(abs(vector.value)) >= SEEN]
        bars = [(line.start, line.end) for line in self.pairs.bars() if isinstance(line, Line)]
        segments: list[Segment] = [(self.place.on(vector.at), self.place.on(vector.end)) for vector in vectors]
        shifts = lanes(segments, bars, self.place.on(self.shown.centre), APART * self._hand.symbol)
        placed = zip(vectors, segments, shifts, strict=True)
        return tuple(LaidVector(vector, offset(line, shift), shift) for vector, line, shift in placed)

    def _arrow(self, vector: LaidVector) -> Group:
        return vector.draw(self.subject, lowered(vector.vector.name), self.place, self._hand.result, self._hand)

    def _centre(self) -> Iterator[Group]:
        if self.shown.state == ALONE:
            return
        at, value = self.place.on(self.shown.centre), self.shown.centre
        data = self.subject.data("point", CENTRE, value, self.place.scale)
        yield Group(mass_centre(at, self._hand), "", data, CENTRE)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, its vectors, points and links lettered."""
        hand = self._hand
        found = [*letters(self.arrows, self._vector_letter, labels), *self._points(labels), *self._weights(labels)]
        senses = ((turning.letter, *turning.middle) for turning in turnings(self.pairs))
        found += [labels.beside(at, letter, hand.letter, 1.5, away) for letter, at, away in senses]
        found += link_numbers(self.pairs, self.shown.bones.links, labels, hand)
        return (Group((*self.lines, Group(tuple(found))), self.shown.name),)

    def _vector_letter(self, name: str) -> tuple[str, float]:
        return lowered(name), self._hand.letter

    def _points(self, labels: Labels) -> Iterator[Stroke]:
        hand, marks = self._hand, [] if self.shown.state == ALONE else [self.place.on(self.shown.centre)]
        for spot in marks:
            yield labels.beside(spot, CENTRE, hand.letter, MASS * hand.symbol + 0.8)
        yield from self.pairs.letters(self.shown.named, labels, *marks)

    def _weights(self, labels: Labels) -> Iterator[Stroke]:
        for weight in self.shown.weights:
            rim = self.place.on(weight.centre)
            letter = counterweight(weight.weight.link, self.drafting.language)
            yield labels.beside(rim, letter, self._hand.letter, 2.2, cmath.phase(weight.direction))


def title_of(shown: BalanceScheme, drafting: Drafting) -> str:
    """Give the title of a scheme; beside figures over the turn, with numbers of their own, by the crank's angle."""
    place = drafting.word("position", position=shown.shown)
    if shown.state == ALONE:
        sense = -1 if shown.bones.mechanism.drive.omega < 0 else 1
        place = f"φ = {drafting.number(sense * math.degrees(shown.bones.study.turn.phi[shown.shown]) % 360)}°"
    return f"{drafting.word(f'scheme {shown.state}')}, {place}"


def measure(shown: BalanceScheme, points: Sequence[complex], drafting: Drafting) -> Picture:
    """Measure the room of a scheme: of its points, letters around them, its heading above.

    Beside others, of whose `points` it is drawn with its own, it is as high above its links as they all ask, so that
    links lie alike under level headings; and it is read at the scale at which these are.
    """
    hand = drafting.hand
    margins, title = around(MARGINS, hand), heading_width(title_of(shown, drafting), hand)
    subject, least = (SYMBOL, UNIT), LETTERS * hand.letter
    every = picture(shown.name, points, subject, margins, title, least)
    highest = max(shown.points, key=lambda point: point.imag).real
    top = complex(highest, max(point.imag for point in points))
    held = [*shown.points, top]
    alone = picture(shown.name, held, subject, margins, title)
    smaller = max(alone.wide, alone.high) / max(every.wide, every.high)
    return alone._replace(least=least * smaller, bands=traced(shown.lines, held))


def draw(shown: BalanceScheme, room: Picture, spot: Spot, drafting: Drafting) -> SchemeFigure:
    """Draw the scheme in its spot, with its title and its written scale above it."""
    return SchemeFigure(shown, Pairs(shown.bones, room.place(*spot), drafting.hand), spot, drafting)
