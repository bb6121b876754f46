"""The scheme of a train in the plane of its axes, radii to scale: half outlines as GOST 2.770-68 has them (схема)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Final

from drawings.gears.routing import ARM, BRAKE, DISC, HELD, INPUT, OUTPUT, PLATE, RIM, SUN, Post, Routing, held
from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.lettering.words import with_index
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Polyline, Stroke
from drawings.symbols.symbols import arrowhead, fit, ground
from plans.gears.kutzbach import TrainPoint
from plans.model.gears import FRAME, ToothedWheel, Train

STEP = 0.11  # of the height of the train: from one place across to the next
CLOSE: Final = 0.22  # steps between the plates of a clutch
FACE, BORNE = 0.32, 0.8  # steps, half of the width of a wheel, and of an axle that stands in two bearings
# Millimetres, by the factor of the hand: half the gap between two faces, half a hub, half the cross of a wheel that is
# fixed on its shaft, a bearing and its distance from the shaft, a shoe of a brake, an arrow at the end of a shaft.
MESHED, HUB, CROSS, BEARING, OFF, SHOE, ARROW = 0.5, 1.5, 1.1, 6.0, 1.1, 4.0, 9.0
BESIDE = 0.8  # mm from a line to its letter


@dataclass(frozen=True)
class TrainScheme:
    """A train whose parts stand in their places across; `left` is where the first of them stands, m."""

    train: Train
    routing: Routing
    spots: tuple[TrainPoint, ...]

    @cached_property
    def across(self) -> Mapping[float, float]:
        """Where each place across stands, m from the first: plates of a clutch are near each other."""
        plates = {(post.name, post.x) for post in self.routing.posts if post.kind == PLATE}
        places = sorted({*self.routing.columns.values(), *(post.x for post in self.routing.posts)})
        found, at, step = {places[0]: 0.0}, 0.0, STEP * self.routing.size
        for one, other in pairwise(places):
            near = any((name, one) in plates and (name, other) in plates for name in self.train.clutches)
            at += step * (CLOSE if near else 1.0)
            found[other] = at
        return found

    @property
    def right(self) -> float:
        """The last place across, m."""
        return max(self.across.values())

    @property
    def whole(self) -> bool:
        """Whether the wheels of the main axis are drawn on both sides of it too: no planet is there."""
        return not self.train.carriers

    @property
    def reach(self) -> tuple[float, float]:
        """The least and the largest height m that it takes."""
        wheels = self.train.wheels.values()
        tops = [self.routing.outside(w) if w.internal else self._height(w) + float(w.radius) for w in wheels]
        slides = [self.back(rack) for rack in self.train.racks]
        lows = [self._height(w) - float(w.radius) for w in wheels if self.both(w)]
        return min(0.0, *lows, *slides, *map(float, self.train.heights.values())), max(*tops, *slides)

    def back(self, rack: str) -> float:
        """Give the height m of the back of a rack, where its guide is."""
        return float(self.train.rack_height(rack)) + self.train.rack_side(rack) * RIM * self.routing.size

    def _height(self, wheel: ToothedWheel) -> float:
        return float(self.train.heights[wheel.link])

    def both(self, wheel: ToothedWheel) -> bool:
        """Tell whether a wheel is drawn on both sides of its axis."""
        under = any(name == wheel.name and self.train.rack_side(rack) < 0 for rack, name in self.train.racks.items())
        return not wheel.internal and (
            under or self.whole or wheel.link in self.train.carrier_of or self._height(wheel) != 0
        )

    def at(self, x: float, y: float) -> complex:
        """Give a true place from the place across and the height."""
        return complex(self.across[x], y)

    def contact(self, spot: TrainPoint) -> complex:
        """Give where a point of the train is in the scheme: a mesh in its column, a planet's centre at its wheel."""
        if spot.rack:
            return self.at(self.routing.columns[self.train.racks[spot.rack]], float(spot.height))
        names = [w.name for w in self.train.wheels.values() if w.link in spot.links]
        for mesh in self.train.meshes:
            if {*mesh} <= {*names} and self.train.contact(mesh) == spot.height:
                return self.at(self.routing.columns[mesh[0]], float(spot.height))
        return self.at(max(self.routing.columns[name] for name in names), float(spot.height))

    def beyond(self, spot: TrainPoint) -> complex:
        """Give where the level of a point begins: past the faces of a mesh, at the end of an axle, of the scheme."""
        if spot.links[0] == FRAME and not spot.height:
            return complex(self.right, 0.0)
        if spot.links[0] in self.train.carrier_of and spot.links[1] == self.train.carrier_of[spot.links[0]]:
            return self.at(self.routing.axle(spot.links[0]).right, float(spot.height))
        past = BORNE if spot.links[0] == FRAME else FACE
        return self.contact(spot) + past * STEP * self.routing.size

    def draw(self, place: Place, hand: Hand) -> Iterator[Stroke]:
        """Draw axes, shafts, then what stands on them."""
        pen = _SchemePen(self, place, hand)
        yield from pen.axes()
        for rod in self.routing.rods():
            if rod.right > rod.left:
                yield Line(pen.on(rod.left, rod.y), pen.on(rod.right, rod.y), hand.result)
        for post in self.routing.posts:
            yield from pen.post(post)
        for wheel in self.train.wheels.values():
            if wheel.internal:
                yield from pen.ring(wheel)
            elif wheel.link in self.train.carrier_of:
                yield from pen.planet(wheel)
        for link in self.train.carrier_of:
            yield from pen.hub(link)
        for rack in self.train.racks:
            yield from pen.rack(rack)
        for body in dict.fromkeys(self.train.body_of.values()):
            yield from pen.idle(body)

    def letters(self, place: Place, hand: Hand, labels: Labels) -> Iterator[Stroke]:
        """Letter wheels, carriers, brakes and clutches."""
        size, columns, seen = hand.number, self.routing.columns, set[str]()
        for wheel in self.train.wheels.values():
            y, r = self._height(wheel), float(wheel.radius)
            outside = self.routing.outside(wheel) - 0.03 * self.routing.size
            spot = self.at(columns[wheel.name], outside if wheel.internal else y + r * 0.55)
            yield labels.beside(place.on(spot), wheel.name, size, BESIDE, math.pi)
        for rack in self.train.racks:
            back = self.at(columns[self.train.racks[rack]], self.back(rack)) + (FACE + CLOSE) * STEP * self.routing.size
            yield labels.beside(place.on(back), rack, size, BESIDE, 0.0)
        for post in self.routing.posts:
            if post.kind in (ARM, BRAKE, PLATE) and post.name not in seen:
                seen.add(post.name)
                low = self.routing.level(post.body)
                y = low + (post.top - low) * (0.5 if post.kind == ARM else 1.0)
                up = 0.0 if post.kind == ARM else math.pi / 2
                yield labels.beside(place.on(self.at(post.x, y)), with_index(post.name), size, BESIDE + 0.7, up)
        for name, link in held(self.train):
            if name and name not in seen:
                ring = self.routing.rings(self.train.body_of[link])[0]
                top = place.on(self.at(columns[ring.name], self.routing.outside(ring))) + 1j * SHOE * hand.symbol
                yield labels.beside(top, with_index(name), size, 2.5 * hand.symbol, 0.0)


@dataclass(frozen=True)
class _SchemePen:
    """Draws the parts of a scheme on paper."""

    scheme: TrainScheme
    place: Place
    hand: Hand

    @property
    def train(self) -> Train:
        return self.scheme.train

    @property
    def routing(self) -> Routing:
        return self.scheme.routing

    def on(self, x: float, y: float) -> complex:
        """Give the place on paper of a place across and a height."""
        return self.place.on(self.scheme.at(x, y))

    @property
    def _face(self) -> float:
        return self.place.length(FACE * STEP * self.routing.size)

    def axes(self) -> Iterator[Stroke]:
        """Draw the fixed axes."""
        past = 4.0 * self.hand.symbol
        ends = (min(self.scheme.across), max(self.scheme.across))
        for height in dict.fromkeys(self.train.heights[link] for link in self.train.links if self._fixed(link)):
            start, end = (self.on(x, float(height)) for x in ends)
            if height:
                wheels = (w for w in self.train.wheels.values() if self._fixed(w.link))
                some = [self.routing.columns[w.name] for w in wheels if self.train.heights[w.link] == height]
                start, end = self.on(min(some), float(height)), self.on(max(some), float(height))
                past = 2.2 * self._face
            yield Line(start - past, end + past, fit(self.hand.axis, abs(end - start) + 2 * past))

    def _fixed(self, link: str) -> bool:
        return link not in self.train.carrier_of

    def post(self, post: Post) -> Iterator[Stroke]:
        """Draw a post with what is at its end."""
        hand, foot, top = self.hand, self.on(post.x, self.routing.level(post.body)), self.on(post.x, post.top)
        match post.kind:
            case _ if post.kind == SUN:
                yield from self._sun(self.train.wheels[post.name], foot)
            case _ if post.kind in (INPUT, OUTPUT):
                yield from self._end(post, foot)
            case _ if post.kind == BRAKE:
                yield Line(foot, top, hand.result)
                yield from self._shoes(top)
            case _ if post.kind == HELD:
                yield Line(foot, top, hand.result)
                yield from self._ground(top)
            case _:
                yield Line(foot, top, hand.result)

    def _sun(self, wheel: ToothedWheel, foot: complex) -> Iterator[Stroke]:
        reach = self.place.length(float(wheel.radius)) - MESHED * self.hand.symbol
        centre = self.on(self.routing.columns[wheel.name], float(self.train.heights[wheel.link]))
        both = self.scheme.both(wheel)
        yield Line(centre - 1j * reach if both else foot, centre + 1j * reach, self.hand.result)
        yield from (self._bar(centre + 1j * side * reach) for side in ((1, -1) if both else (1,)))
        yield from self._cross(foot)

    def idle(self, body: str) -> Iterator[Stroke]:
        """Draw the axle of wheels that nothing else holds, in bearings at both ends."""
        posts = [post for post in self.routing.posts if post.body == body]
        if posts and all(post.kind == SUN for post in posts):
            y, half = self.routing.level(body), 2.0 * self._face
            start, end = (self.on(pick(post.x for post in posts), y) for pick in (min, max))
            yield Line(start - half, end + half, self.hand.result)
            yield from (part for at in (start - half, end + half) for part in self._bearing(at))

    def _bar(self, middle: complex) -> Line:
        return Line(middle - self._face, middle + self._face, self.hand.result)

    def _cross(self, at: complex) -> Iterator[Stroke]:
        """Draw that a wheel is fixed on its shaft."""
        arm = CROSS * self.hand.symbol
        yield from (Line(at - arm * way, at + arm * way, self.hand.other) for way in (1 + 1j, 1 - 1j))

    def _end(self, post: Post, foot: complex) -> Iterator[Stroke]:
        """Draw the end of a driving or driven shaft: its bearing, and an arrow into the train or out of it."""
        inward = 1.0 if self.scheme.across[post.x] < self.scheme.right / 2 else -1.0
        yield from self._bearing(foot + inward * BEARING * self.hand.symbol)
        end = foot - inward * ARROW * self.hand.symbol
        tail, tip = (end, foot) if post.kind == INPUT else (foot, end)
        head = arrowhead(tail, tip, self.hand.symbol)
        yield Line(tail, tip, self.hand.other)
        yield from (head,) if head is not None else ()

    def _bearing(self, at: complex) -> Iterator[Stroke]:
        half, low = BEARING / 2 * self.hand.symbol, 1j * OFF * self.hand.symbol
        yield from ground(at - half - low, at + half - low, -1j, self.hand)

    def _ground(self, at: complex) -> Iterator[Stroke]:
        half = 0.75 * BEARING * self.hand.symbol
        yield from ground(at - half, at + half, 1j, self.hand)

    def _shoes(self, top: complex) -> Iterator[Stroke]:
        """Draw the shoes of a brake at both sides of what it holds."""
        high, off = SHOE * self.hand.symbol, OFF * self.hand.symbol
        for side in (-1.0, 1.0):
            foot = top + side * off
            yield from ground(foot - 1j * high, foot, complex(side), self.hand)

    def planet(self, wheel: ToothedWheel) -> Iterator[Stroke]:
        """Draw a wheel of a planet at both sides of its hub."""
        centre = self.on(self.routing.columns[wheel.name], float(self.train.heights[wheel.link]))
        reach = self.place.length(float(wheel.radius)) - MESHED * self.hand.symbol
        for way in (1j, -1j):
            yield Line(centre + way * HUB * self.hand.symbol, centre + way * reach, self.hand.result)
            yield self._bar(centre + way * reach)

    def hub(self, link: str) -> Iterator[Stroke]:
        """Draw the hub of a planet, which turns on its axle."""
        some = [self.routing.columns[w.name] for w in self.train.wheels.values() if w.link == link]
        y, half = float(self.train.heights[link]), HUB * self.hand.symbol
        start, end = self.on(min(some), y) - self._face, self.on(max(some), y) + self._face
        yield from (Line(start + way * half, end + way * half, self.hand.result) for way in (1j, -1j))
        if min(some) == max(some):
            yield Line(start, end, self.hand.result)

    def ring(self, wheel: ToothedWheel) -> Iterator[Stroke]:
        """Draw a ring: its face inside, its side up to its outside, there what holds it."""
        x, hand = self.routing.columns[wheel.name], self.hand
        face = self.on(x, float(self.train.heights[wheel.link] + wheel.radius)) + 1j * MESHED * hand.symbol
        outside, body = self.on(x, self.routing.outside(wheel)), self.train.body_of[wheel.link]
        joined = any(post.body == body and post.kind == DISC for post in self.routing.posts)
        joined = joined or len(self.routing.rings(body)) > 1
        top = self.on(x, self.routing.bar(body)) if joined else outside
        yield self._bar(face)
        yield Line(face, top, hand.result)
        if wheel is self.routing.rings(body)[0]:
            yield from self._held(body, top)

    def rack(self, rack: str) -> Iterator[Stroke]:
        """Draw a rack from its end: its face at that of its wheel, its body, its guide at the back."""
        side, x = self.train.rack_side(rack), self.routing.columns[self.train.racks[rack]]
        face = self.on(x, float(self.train.rack_height(rack))) + 1j * side * MESHED * self.hand.symbol
        back = self.on(x, self.scheme.back(rack))
        corners = tuple(at + way * self._face for at, way in ((face, -1), (face, 1), (back, 1), (back, -1)))
        yield Polyline(corners, True, self.hand.result)
        guide, half = back + 1j * side * OFF * self.hand.symbol, 1.6 * self._face
        yield from ground(guide - half, guide + half, 1j * side, self.hand)

    def _held(self, body: str, top: complex) -> Iterator[Stroke]:
        for name, link in held(self.train):
            if self.train.body_of[link] == body and name:
                yield Line(top, top + 1j * (SHOE + OFF) * self.hand.symbol, self.hand.result)
                yield from self._shoes(top + 1j * (SHOE + OFF) * self.hand.symbol)
            elif self.train.body_of[link] == body:
                yield from self._ground(top)
