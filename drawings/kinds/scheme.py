"""Schemes of mechanisms: links with their pairs, stands, mass centres and numbers in one shown position (схемы)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import NamedTuple

import numpy as np

from drawings.kinds.outlines import Bones, LinkOutline, is_centre, offset_foot, outlines, places
from drawings.layout.ink import LETTERED, padded
from drawings.layout.labels import Labels, free_side
from drawings.layout.parallel_offsets import Segment, nearest
from drawings.layout.picture import Place
from drawings.lettering.lettering import bounds
from drawings.lettering.words import with_index
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Line, Polyline, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols import symbols
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import ARROW_LENGTH, BLOCK, HINGE, MASS, POINT, STONE
from drawings.symbols.trimming import Mask, distinct, trim
from plans.model.mechanism import FRAME, Slide

LEAST = 0.5  # of a symbol's size: smaller hinges are no circles any more
CLEAR = 3.0  # radii of a hinge that the shortest link must be long, so that some of it is seen between two hinges
OVERRUN = 4.0  # mm that a slot reaches past its stone's outermost place
STANDS = {-1j: 0.0, 1 + 0j: 0.6, -1 + 0j: 0.6, 1j: 0.8}  # where a stand may go, and how much it is worse than down
BESIDE = math.cos(math.radians(50))  # a bar within 50 degrees of a stand's axis runs through its legs


@dataclass(frozen=True, eq=False, repr=False)
class Joints:
    """The links of one pose on paper with their pairs, each with its symbol's outline."""

    bones: Bones
    place: Place
    sheet: Hand

    @cached_property
    def hand(self) -> Hand:
        """The sheet's hand, its symbols smaller where the shortest link would be lost between two hinges."""
        lengths = [length for link in self.bones.links for length in self._between(link)]
        room = min(lengths, default=math.inf) / (CLEAR * HINGE * self.sheet.symbol)
        return self.sheet._replace(symbol=self.sheet.symbol * min(max(room, LEAST), 1.0))

    def _between(self, link: int) -> Iterator[float]:
        """Give the distances between the hinges of a link, mm."""
        points = self.bones.mechanism.links[link].points
        hinged = [spot for name, spot in points.items() if name in self.bones.mechanism.hinges]
        return (self.place.length(abs(second - first)) for first, second in combinations(hinged, 2))

    @cached_property
    def named(self) -> dict[str, complex]:
        """The shown places of all named points and mass centres, m."""
        return places(self.bones)

    @cached_property
    def outlines(self) -> list[LinkOutline]:
        """The whole outlines of the links; a slot runs past its stone's outermost places by half a stone and more."""
        more = (STONE[0] / 2 + OVERRUN) * self.hand.symbol * self.place.scale.mu
        reach = {slide: (low - more, high + more) for slide, (low, high) in self.bones.travels.items()}
        return outlines(self.bones, reach)

    @cached_property
    def hinges(self) -> dict[str, tuple[Circle, ...]]:
        """The hinges by their letters, the outer circle first."""
        return {
            name: symbols.hinge(self.place.on(self.named[name]), self.hand, len(links))
            for name, links in self.bones.mechanism.hinges.items()
            if name in self.named
        }

    def radius(self, name: str) -> float:
        """Give the radius of a point's own symbol, mm."""
        if name in self.hinges:
            return self.hinges[name][0].radius
        return (MASS if name in self.centres else POINT) * self.hand.symbol

    def clear(self, name: str) -> float:
        """Give how far from a point letters stand clear of its symbols: of its block, if one is on it."""
        blocked = any(slide.point == name and offset_foot(self.bones, slide) is None for slide, _ in self.blocks)
        return max(self.radius(name), BLOCK[1] / 2 * self.hand.symbol if blocked else 0.0)

    @cached_property
    def blocks(self) -> list[tuple[Slide, Polyline]]:
        """The sliding blocks; of several on one pin all but the frame's are drawn as slots about the pin."""
        drawn: list[tuple[Slide, Polyline]] = []
        for slide in sorted(self.bones.mechanism.slides, key=lambda slide: slide.owner):
            poses, k = self.bones.numbered, self.bones.shown
            at, along = complex(poses.blocks(slide)[k]), complex(poses.line(slide)[k])
            if math.isnan(at.real):
                continue
            pinned = any(other.point == slide.point for other, _ in drawn) and offset_foot(self.bones, slide) is None
            size = BLOCK if slide.owner == FRAME else STONE
            spot = self.place.on(at)
            symbol = symbols.slot(spot, along, self.hand) if pinned else symbols.block(spot, along, self.hand, size)
            drawn.append((slide, symbol))
        return drawn

    @cached_property
    def centres(self) -> dict[str, complex]:
        """The mass centres on paper, by their letters."""
        points, hinges = self.bones.numbered.points, self.bones.mechanism.hinges
        centres = *self.bones.masses, *(name for name in points if is_centre(name) and name not in hinges)
        return {name: self.place.on(self.named[name]) for name in centres if name in self.named}

    @cached_property
    def rounds(self) -> list[Mask]:
        """What no line enters: hinges and mass centres."""
        centres = [Circle(spot, MASS * self.hand.symbol) for spot in self.centres.values()]
        return [*(circles[0] for circles in self.hinges.values()), *centres]

    @property
    def masks(self) -> list[Mask]:
        """What no line of another position enters: all symbols of the shown one."""
        return [*self.rounds, *(block for _, block in self.blocks)]

    def bars(self) -> Iterator[Stroke]:
        """Draw the links of the shown position: they end at their hinges and at the blocks that they slide in.

        Where one lies on another, as a rod on its crank in a dead centre, the line that both have is drawn once.
        """
        yield from distinct(piece for outline in self.outlines for piece in self._pieces(outline))

    def _pieces(self, outline: LinkOutline) -> Iterator[Stroke]:
        blocks = [block for slide, block in self.blocks if outline.link in (slide.slider, slide.owner)]
        lines = (Line(*ends, self.hand.result) for ends in self.placed(outline))
        return trim(lines, [*self.rounds, *blocks])

    def placed(self, outline: LinkOutline) -> Iterator[tuple[complex, complex]]:
        """Give the ends of an outline's bars on paper."""
        for bar in outline.bars:
            start, end = (complex(self.bones.numbered.of(outline.link, spot)[self.bones.shown]) for spot in bar)
            if not math.isnan(start.real):
                yield self.place.on(start), self.place.on(end)

    def corners(self) -> Iterator[Stroke]:
        """Fill the rigid corners of links, and those of a block with its own rod."""
        for outline in self.outlines:
            turn = complex(self.bones.numbered.turns[outline.link][self.bones.shown])
            for corner in outline.corners:
                at = complex(self.bones.numbered.of(outline.link, corner.at)[self.bones.shown])
                if not math.isnan(at.real):
                    spot, first, second = self.place.on(at), corner.first * turn, corner.second * turn
                    fill = symbols.gusset(spot, first, second, self._round(spot), self.hand)
                    yield from [fill] if fill else []
            for slide, block in self.blocks:
                if slide.slider == outline.link:
                    yield from self._joints(outline, block)

    def _round(self, at: complex) -> float:
        """Give the radius of the symbol that stands at a place; 0 where none does."""
        near = (mask.radius for mask in self.rounds if isinstance(mask, Circle) and abs(mask.centre - at) < mask.radius)
        return max(near, default=0.0)

    def _joints(self, outline: LinkOutline, block: Polyline) -> Iterator[Stroke]:
        """Mark where a rod leaves the block that it is one link with."""
        for ends in self.placed(outline):
            for piece in trim([Line(*ends)], [block]):
                assert isinstance(piece, Line)
                for exit_, far in ((piece.start, piece.end), (piece.end, piece.start)):
                    yield from _welded(exit_, far, block, self.hand)

    def stands(self) -> Iterator[Stroke]:
        """Draw the stands of the fixed hinges, each to the side where the fewest links run; in one place one."""
        points = self.bones.mechanism.links[FRAME].points
        fixed = {points[name]: name for name in sorted(points, reverse=True) if name in self.hinges}
        for name in sorted(fixed.values()):
            yield from self.stand(name)

    def stand(self, name: str) -> tuple[Stroke, ...]:
        """Draw the stand of a fixed hinge: its two legs, its base, the hatching."""
        at = self.place.on(self.bones.mechanism.links[FRAME].points[name])
        return symbols.fixed_hinge(at, self.hand, self.radius(name), self._free_side(name))

    def _free_side(self, name: str) -> complex:
        ways = list(self._ways(name))

        def cost(side: complex) -> float:
            crossed = sum((way * side.conjugate()).real > BESIDE for way in ways) / max(len(ways), 1)
            return 2 * crossed + STANDS[side]

        return min(STANDS, key=cost)

    def _ways(self, name: str) -> Iterator[complex]:
        """Give the directions of the bars at a fixed hinge in all positions, those of the shown one as often again."""
        poses, links = self.bones.numbered, self.bones.mechanism.links
        arms = [
            (outline.link, bar[0] + bar[1] - 2 * links[outline.link].points[name])
            for outline in self.outlines
            for bar in outline.bars
            if links[outline.link].points.get(name) in bar
        ]
        runs = [poses.turns[link] * arm / abs(arm) for link, arm in arms]
        slides = (slide for slide in self.bones.mechanism.slides if slide.point == name)
        runs += [side * poses.line(slide) for slide in slides for side in (1, -1)]
        for run in runs:
            known = run[~np.isnan(run)]
            yield from (complex(way) for way in known)
            yield from [complex(run[self.bones.shown])] * len(known)

    def marks(self, subject: Subject, zero: str) -> Iterator[Group]:
        """Draw hinges, mass centres and other named points; all can be measured from the one that is zero."""
        for name, value in self.named.items():
            data = subject.data("pole" if name == zero else "point", name, value, self.place.scale)
            yield Group(self.symbol(name, self.place.on(value)), "", data, name)

    def letters(self, named: Mapping[str, complex], labels: Labels, *marks: complex) -> Iterator[Stroke]:
        """Letter named places, each where the bars at it leave the widest angle free, nearest to it alone."""
        bars, spots = list(self.bars()), {*marks, *map(self.place.on, named.values())}
        for name, value in named.items():
            spot, clear = self.place.on(value), self.clear(name)
            side = free_side(spot, bars, clear + ARROW_LENGTH)
            others = [(far, far) for far in spots if far != spot]
            yield labels.beside(spot, with_index(name), self.sheet.letter, clear + 1.0, side, others)

    def symbol(self, name: str, at: complex, centre: bool = False) -> tuple[Stroke, ...]:
        """Draw a named place on paper: a hinge, a mass centre, or a point that is neither."""
        if name in self.hinges:
            return self.hinges[name]
        if centre or name in self.centres:
            return symbols.mass_centre(at, self.hand)
        return (Circle(at, POINT * self.hand.symbol, INK),)


def _welded(exit_: complex, far: complex, block: Polyline, hand: Hand) -> Iterator[Stroke]:
    """Fill both corners of a rod with the side of the block that it leaves."""
    rod = (far - exit_) / abs(far - exit_)
    for k, corner in enumerate(block.points):
        side = block.points[(k + 1) % len(block.points)] - corner
        length = abs(side)
        off = (exit_ - corner) * side.conjugate() / length
        if abs(off.imag) < 1e-6 and 0 < off.real < length:
            for way in (side / length, -side / length):
                fill = symbols.gusset(exit_, rod, way, 0.0, hand)
                yield from [fill] if fill and cmath.phase(way / rod) else []


def ties(joints: Joints) -> Iterator[Line]:
    """Tie each mass centre that its link's lines do not reach to the nearest place of the link."""
    for name, spot in joints.centres.items():
        foot = min(_feet(joints, _link(joints, name), spot), key=lambda foot: abs(foot - spot))
        if abs(foot - spot) > MASS * joints.hand.symbol:
            yield Line(foot, spot, joints.hand.other)


def _link(joints: Joints, name: str) -> int:
    masses, links = joints.bones.masses, joints.bones.mechanism.links
    return masses[name][0] if name in masses else next(n for n in sorted(links) if name in links[n].points)


def _feet(joints: Joints, link: int, spot: complex) -> Iterator[complex]:
    """Give the nearest place of each bar of a link; of a link of one point alone its point."""
    outline = next(drawn for drawn in joints.outlines if drawn.link == link)
    bars = [(start, end) for start, end in joints.placed(outline) if start != end]
    yield from (nearest(start, end, spot) for start, end in bars)
    if not bars:
        numbered, k = joints.bones.numbered, joints.bones.shown
        spots = (numbered.of(link, place)[k] for place in numbered.links[link].points.values())
        yield from (joints.place.on(complex(spot)) for spot in spots)


SHARES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.22, 0.78)  # where along a bar its number may stand
OFFS = (0.6, 2.0, 4.0, 7.0, 11.0, 16.0, 22.0, 30.0, 40.0, 55.0)  # mm between a bar and the circle
LED = 2.0  # mm: from further off a leader leads to the link
APART = 1.0  # mm that a number without a leader must be further from any other link than from its own
DOT = 0.5  # mm, radius of the dot that a leader ends with on its link
ROUND = 0.85  # radius of the circle, in sizes of its number: of two digits it is wider
DIRECTIONS = 16


class NumberPlace(NamedTuple):
    """A place for a number: the middle of its circle, the place of the link that it is for, mm between them."""

    middle: complex
    foot: complex
    off: float


def link_numbers(
    joints: Joints, links: list[int], labels: Labels, hand: Hand, parts: Sequence[Joints] = ()
) -> Iterator[Group]:
    """Number the links where all figures leave room, no number nearer to another link, of other `parts` either."""
    for link in links:
        rows = [(part, line) for part in parts or (joints,) for line in part.outlines]
        others = [bar for part, line in rows if (part, line.link) != (joints, link) for bar in part.placed(line)]
        spots = [spot for spot in _spots(joints, link, hand) if not cmath.isnan(spot.middle)]
        yield from (_number(str(link), spots, labels, hand, others),) if spots else ()


def frame_number(joints: Joints, labels: Labels, hand: Hand) -> Iterator[Stroke]:
    """Number the frame beside the stand of the drive's hinge, or of the first that has one."""
    fixed_points, drive = joints.bones.mechanism.links[FRAME].points, joints.bones.mechanism.drive
    hinges = sorted((name for name in fixed_points if name in joints.hinges), key=lambda name: name != drive.pivot)
    if hinges:
        bases = [line for line in joints.stand(hinges[0]) if isinstance(line, Line)]
        spots = [spot for line in bases[2:3] for spot in _around((line.start + line.end) / 2, FRAME, 0.0, hand)]
        yield _number(str(FRAME), spots, labels, hand)


def _spots(joints: Joints, link: int, hand: Hand) -> Iterator[NumberPlace]:
    """Give the places beside a link, the nearest first; beside a block where the link is no more than one."""
    radius = _radius(str(link), hand)
    lines = [bar for outline in joints.outlines if outline.link == link for bar in joints.placed(outline)]
    bars = [bar for bar in lines if abs(bar[1] - bar[0]) > 4 * radius]
    if not bars:
        clear = 0.0 if lines else abs(complex(*BLOCK)) / 2 * joints.hand.symbol
        yield from _around(_middle(joints, link), link, clear, hand)
    for off in OFFS if bars else ():
        for share in SHARES:
            for start, end in bars:
                across, foot = 1j * (end - start) / abs(end - start), start + share * (end - start)
                yield from (NumberPlace(foot + side * across * (radius + off), foot, off) for side in (1, -1))


def _around(foot: complex, link: int, clear: float, hand: Hand) -> Iterator[NumberPlace]:
    """Give the places round a spot that is kept clear so far."""
    for off in OFFS:
        reach = clear + _radius(str(link), hand) + off
        turns = (2 * math.pi * (k + 0.5) / DIRECTIONS for k in range(DIRECTIONS))
        yield from (NumberPlace(foot + cmath.rect(reach, turn), foot, off) for turn in turns)


def _middle(joints: Joints, link: int) -> complex:
    bones = joints.bones
    spots = bones.mechanism.links[link].points.values()
    places = [joints.place.on(complex(bones.numbered.of(link, spot)[bones.shown])) for spot in spots]
    return sum(places) / len(places)


def _radius(content: str, hand: Hand) -> float:
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    return max(ROUND * hand.text, abs(complex(right - left, top - bottom)) / 2 + 0.15 * hand.text)


def _number(
    content: str, spots: list[NumberPlace], labels: Labels, hand: Hand, others: Sequence[Segment] = ()
) -> Group:
    """Draw a number in its circle at the first free place, with a leader where that is not beside its link alone."""
    radius = _radius(content, hand)

    def covered(spot: NumberPlace) -> int:
        if spot.off > LED:
            through = labels.ink.along(spot.middle, spot.foot)[0] // LETTERED
        else:
            far = radius + spot.off + APART
            through = LETTERED * any(tied(abs(spot.middle - nearest(*bar, spot.middle)) - far) < 0 for bar in others)
        return labels.ink.under(padded((0.0, 0.0, 0.0, 0.0), spot.middle, radius + 0.4)) + through

    spot = next((spot for spot in spots if not covered(spot)), None) or min(spots, key=covered)
    left, bottom, right, top = bounds(Text(0j, content, hand.text, "middle"))
    text = Text(spot.middle - complex(left + right, bottom + top) / 2, content, hand.text, "middle")
    led = _leader(spot, radius, hand) if spot.off > LED else ()
    group = Group((Circle(spot.middle, radius, hand.other), text, *led), "", {}, content)
    labels.ink.draw([group])
    return group


def _leader(spot: NumberPlace, radius: float, hand: Hand) -> tuple[Stroke, ...]:
    """Lead from a circle's rim to a dot on its link."""
    rim = spot.middle + (spot.foot - spot.middle) / abs(spot.foot - spot.middle) * radius
    return Line(rim, spot.foot, hand.drafted), Circle(spot.foot, DOT * hand.symbol, INK)
