"""The kinematic pairs of the shown position: blocks, slots, hinges, stands, mass centres, rigid corners (пары)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import numpy as np

from drawings.layout.picture import Place
from drawings.linkage.outlines import Outline, offset_foot, outlines
from drawings.linkage.skeleton import Bones, Skeletons, is_centre, reference
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Line, Polyline, Stroke
from drawings.symbols import symbols
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import BLOCK, HINGE, MASS, POINT, STONE
from drawings.symbols.trimming import Mask, distinct, trim
from plans.model.mechanism import FRAME, Slide

LEAST = 0.5  # of a symbol's size: smaller hinges are no circles any more
CLEAR = 3.0  # radii of a hinge that the shortest link must be long, so that some of it is seen between two hinges
OVERRUN = 4.0  # mm that a slot reaches past its stone's outermost place
STANDS = {-1j: 0.0, 1 + 0j: 0.6, -1 + 0j: 0.6, 1j: 0.8}  # where a stand may go, and how much it is worse than down
BESIDE = math.cos(math.radians(50))  # a bar within 50 degrees of a stand's axis runs through its legs


@dataclass(frozen=True, eq=False)
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

    def _spot(self, name: str) -> complex | None:
        value = self.bones.spot(name, self.bones.shown)
        return None if math.isnan(value.real) else value

    @cached_property
    def outlines(self) -> list[Outline]:
        """The whole outlines of the links; a slot runs past its stone's outermost places by half a stone and more."""
        more = (STONE[0] / 2 + OVERRUN) * self.hand.symbol * self.place.scale.mu
        reach = {slide: (low - more, high + more) for slide, (low, high) in self.bones.travels.items()}
        return outlines(self.bones, reach)

    @cached_property
    def hinges(self) -> dict[str, tuple[Circle, ...]]:
        """The hinges by their letters, the outer circle first."""
        return {
            name: symbols.hinge(self.place.on(spot), self.hand, len(links))
            for name, links in self.bones.mechanism.hinges.items()
            if (spot := self._spot(name)) is not None
        }

    def radius(self, name: str) -> float:
        """Give the radius of a point's own symbol, mm."""
        sizes = dict.fromkeys(self.centres, MASS * self.hand.symbol) | {
            name: c[0].radius for name, c in self.hinges.items()
        }
        return sizes.get(name, POINT * self.hand.symbol)

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
        poses, k = self.bones.numbered, self.bones.shown
        places = {name: complex(poses.of(*mass)[k]) for name, mass in self.bones.masses.items()}
        named = (name for name in poses.points if is_centre(name) and name not in self.bones.mechanism.hinges)
        places |= {name: self.bones.spot(name, k) for name in named}
        return {name: self.place.on(spot) for name, spot in places.items() if not math.isnan(spot.real)}

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

    def _pieces(self, outline: Outline) -> Iterator[Stroke]:
        own = [block for slide, block in self.blocks if outline.link in (slide.slider, slide.owner)]
        lines = (Line(*ends, self.hand.result) for ends in self.placed(outline))
        return trim(lines, [*self.rounds, *own])

    def placed(self, outline: Outline) -> Iterator[tuple[complex, complex]]:
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
                    radius = self._round(self.place.on(at))
                    fill = symbols.gusset(
                        self.place.on(at), corner.first * turn, corner.second * turn, radius, self.hand
                    )
                    yield from [fill] if fill else []
            for slide, block in self.blocks:
                if slide.slider == outline.link:
                    yield from self._joints(outline, block)

    def _round(self, at: complex) -> float:
        """Give the radius of the symbol that stands at a place; 0 where none does."""
        near = (mask.radius for mask in self.rounds if isinstance(mask, Circle) and abs(mask.centre - at) < mask.radius)
        return max(near, default=0.0)

    def _joints(self, outline: Outline, block: Polyline) -> Iterator[Stroke]:
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
        poses, own = self.bones.numbered, self.bones.mechanism.links
        arms = [
            (outline.link, bar[0] + bar[1] - 2 * own[outline.link].points[name])
            for outline in self.outlines
            for bar in outline.bars
            if own[outline.link].points.get(name) in bar
        ]
        runs = [poses.turns[link] * arm / abs(arm) for link, arm in arms]
        runs += [
            side * poses.line(slide) for slide in self.bones.mechanism.slides if slide.point == name for side in (1, -1)
        ]
        for run in runs:
            known = run[~np.isnan(run)]
            yield from (complex(way) for way in known)
            yield from [complex(run[self.bones.shown])] * len(known)

    def marks(self) -> Iterator[Group]:
        """Draw hinges, mass centres and other named points; all can be measured."""
        bones, subject = self.bones, Subject("positions", "r", self.bones.shown)
        for name in sorted(bones.numbered.points):
            value = self._spot(name)
            if value is not None:
                kind = "pole" if name == reference(bones.mechanism) else "point"
                data = subject.data(kind, name, value, self.place.scale)
                yield Group(self.symbol(name, self.place.on(value)), "", data, name)
        for name in bones.masses:
            if name in self.centres:
                value = complex(bones.numbered.of(*bones.masses[name])[bones.shown])
                data = subject.data("point", name, value, self.place.scale)
                yield Group(symbols.mass_centre(self.centres[name], self.hand), "", data, name)

    def symbol(self, name: str, at: complex, centre: bool = False) -> tuple[Stroke, ...]:
        """Draw a named place on paper: a hinge, a mass centre, or a point that is neither."""
        if name in self.hinges:
            return self.hinges[name]
        if centre or name in self.centres:
            return symbols.mass_centre(at, self.hand)
        return (Circle(at, POINT * self.hand.symbol, INK),)


@dataclass(frozen=True, eq=False)
class Pairs(Joints):
    """The pairs of a mechanism's shown position."""

    bones: Skeletons


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
