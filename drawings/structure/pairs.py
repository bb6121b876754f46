"""Pairs of a structure on paper: hinges, slides, spherical and cylindrical pairs, contacts (пары; GOST 2.770)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from drawings.kinds.outlines import LinkOutline
from drawings.kinds.scheme import Joints
from drawings.paper.strokes import INK, TURN, Arc, Circle, Line, Polyline, Stroke
from drawings.structure.links import ShownLinks
from drawings.symbols import symbols
from drawings.symbols.symbols import BLOCK, fit
from drawings.symbols.trimming import Mask, trim
from plans.model.mechanism import FRAME
from plans.model.structure import CONTACT, CYLINDRICAL, SLIDING, SPHERICAL, TURNING, Joint

CUP, OPEN, CLEAR = 3.2, math.radians(85), math.radians(15)  # mm, radius of a cup; rad that it reaches, is clear
SLEEVE, ROD = (7.0, 4.4), 6.5  # mm, length and width of a cylindrical pair's sleeve; half its rod
DOT = 0.6  # mm, radius of the middle of a sleeve
SLANT = cmath.rect(1.0, math.pi / 4)  # an axis across the plane is seen aslant
GUIDE, GROUND = 14.0, 20.0  # mm of a guide's axis on either side of its block; of the ground beside it


@dataclass(frozen=True, eq=False, repr=False)
class StructurePairs(Joints):
    """The pairs of some links of a structure at their place on paper."""

    bones: ShownLinks

    @cached_property
    def kinds(self) -> Mapping[str, Joint]:
        """The joints that turn and are no hinges, by their letters; a hinge of several links may have one such."""
        special = (SPHERICAL, CYLINDRICAL)
        return {joint.letter: joint for joint in self.bones.joints if joint.nature == TURNING and joint.kind in special}

    def radius(self, name: str) -> float:
        """Give the radius of a point's own symbol, mm."""
        size = {SPHERICAL: CUP, CYLINDRICAL: abs(complex(*SLEEVE)) / 2}
        joint = self.kinds.get(name)
        return super().radius(name) if joint is None else size[joint.kind] * self.hand.symbol

    @cached_property
    def rounds(self) -> list[Mask]:
        """What no line enters: the sleeve of a cylindrical pair in place of its hinge."""
        circles = [circles[0] for name, circles in self.hinges.items() if name not in self.sleeves]
        return [*circles, *self.sleeves.values()]

    @cached_property
    def sleeves(self) -> Mapping[str, Polyline]:
        """The sleeves of cylindrical pairs, turned aslant to where the fewest bars are."""
        found = [(name, self.place.on(joint.at)) for name, joint in self.kinds.items() if joint.kind == CYLINDRICAL]
        return {name: symbols.block(spot, self._slant(name), self.hand, SLEEVE) for name, spot in found}

    def _slant(self, name: str) -> complex:
        """Give the direction in which the axis of a cylindrical pair is seen: aslant, away from the bars at it."""
        at = self.kinds[name].at
        bars = [bar for outline in self.outlines for bar in outline.bars if at in bar]
        ways = [(bar[0] + bar[1] - 2 * at) / abs(bar[0] + bar[1] - 2 * at) for bar in bars]
        along = {
            way: max((abs((way * bar.conjugate()).real) for bar in ways), default=0.0) for way in (SLANT, 1j * SLANT)
        }
        return min(along, key=lambda way: along[way])

    def _pieces(self, outline: LinkOutline) -> Iterator[Stroke]:
        balls = (one for one in self.kinds.values() if one.kind == SPHERICAL and outline.link == one.links[-1])
        cups = [Circle(self.place.on(joint.at), CUP * self.hand.symbol) for joint in balls]
        yield from trim(super()._pieces(outline), cups)

    def symbol(self, name: str, at: complex, centre: bool = False) -> tuple[Stroke, ...]:
        """Draw a named place on paper: a ball in its cup, a rod in its sleeve, or what it is."""
        joint = self.kinds.get(name)
        if joint is None:
            return super().symbol(name, at, centre)
        if joint.kind == SPHERICAL:
            way = self._cupped(joint)
            cup = Arc(at, CUP * self.hand.symbol, way - OPEN, way + OPEN, self.hand.result)
            return (*self.hinges[name][:1], cup)
        reach = ROD * self.hand.symbol * self._slant(name)
        rods = trim([Line(at - reach, at + reach, self.hand.result)], [self.sleeves[name]])
        dot = Circle(at, DOT * self.hand.symbol, INK)  # its middle is what is measured
        return dot, self.sleeves[name]._replace(style=self.hand.result), *rods

    def _cupped(self, joint: Joint) -> float:
        """Give the direction of the cup: on the side of the joint's last link, and open to the other's bar."""
        other, own = (self._way(link, joint.at) for link in (joint.links[0], joint.links[-1]))
        apart = cmath.phase(own / other)
        return cmath.phase(own) + math.copysign(max(0.0, min(OPEN + CLEAR - abs(apart), OPEN - CLEAR)), apart)

    def _way(self, link: int, at: complex) -> complex:
        """Give the direction in which a link leaves a place; that of a stand, or of a block alone, is down."""
        spots = [spot for spot in self.bones.mechanism.links[link].points.values() if spot != at]
        return sum(spots) / len(spots) - at if spots and link != FRAME else -1j

    def guides(self) -> Iterator[Stroke]:
        """Draw what slides are guided by: the axis of a guide on the frame or on a host that is not shown."""
        grounded = {joint.name for joint in self.bones.joints if FRAME in joint.links and joint.nature == SLIDING}
        for joint in (joint for joint in self.bones.joints if joint.name in grounded):
            spot, more = self.place.on(joint.at), GUIDE * self.hand.symbol * joint.along
            block = symbols.block(spot, joint.along, self.hand)
            style = self.hand.result if joint.kind == CYLINDRICAL else fit(self.hand.axis, 2 * abs(more))
            yield from trim([Line(spot - more, spot + more, style)], [block])

    def grounds(self) -> Iterator[Stroke]:
        """Draw the ground of the guides, on the side where fewer links are; a rod that guides is held at its ends."""
        for joint in (joint for joint in self.bones.joints if FRAME in joint.links and joint.nature == SLIDING):
            spot, along = self.place.on(joint.at), joint.along
            if joint.kind == CYLINDRICAL:
                for end in (1, -1):
                    tip = spot + end * GUIDE * self.hand.symbol * along
                    half = 1j * along * BLOCK[1] / 2 * self.hand.symbol
                    yield from symbols.ground(tip - half, tip + half, end * along, self.hand)
                continue
            offs = [((other - joint.at) * along.conjugate()).imag for other in self.bones.points]
            side = -1j * along if max(offs) + min(offs) >= 0 else 1j * along
            foot, half = spot + side * BLOCK[1] / 2 * self.hand.symbol, along * GROUND / 2 * self.hand.symbol
            yield from symbols.ground(foot - half, foot + half, side, self.hand)

    def contacts(self) -> Iterator[Stroke]:
        """Draw the curves that touch in a contact by their circles of curvature; a flat side is a line."""
        for joint in (joint for joint in self.bones.joints if joint.nature == CONTACT):
            at = self.place.on(joint.at)
            for centre in joint.centres:
                middle = self.place.on(centre.at)
                rim = Arc(middle, abs(at - middle), 0.0, TURN, self.hand.result)
                yield from trim([rim], self.rounds)
            if len(joint.centres) == 1:
                run = 1j * joint.along * GUIDE * self.hand.symbol
                yield Line(at - run, at + run, self.hand.result)
