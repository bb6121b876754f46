"""The parts of a train's scheme on paper: shafts, wheels, carriers, what holds them, as GOST 2.770-68 has them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from drawings.gears.routing import ARM, BRAKE, DISC, HELD, INPUT, OUTPUT, SUN, Post, Routing, held
from drawings.gears.scheme import FACE, SHOE, STEP, TrainScheme
from drawings.kinds.axes import arrow
from drawings.layout.picture import Place
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Polyline, Stroke
from drawings.symbols.symbols import fit, ground
from plans.model.gears import BevelMesh, ToothedWheel, Train

# Millimetres, by the factor of the hand: half the gap between two faces, half a hub, half the cross of a wheel that is
# fixed on its shaft, a bearing and its distance from the shaft, an arrow at the end of a shaft.
MESHED, HUB, CROSS, BEARING, OFF, ARROW = 0.5, 1.5, 1.1, 6.0, 1.1, 9.0


def scheme_parts(scheme: TrainScheme, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw axes, shafts, then what stands on them."""
    pen = _SchemePen(scheme, place, hand)
    yield from pen.axes()
    for rod in scheme.routing.rods():
        if rod.right > rod.left:
            yield Line(pen.on(rod.left, rod.y), pen.on(rod.right, rod.y), hand.result)
    for post in scheme.routing.posts:
        yield from pen.post(post)
    for wheel in scheme.train.wheels.values():
        if wheel.internal:
            yield from pen.ring(wheel)
        elif wheel.link in scheme.train.carrier_of and not wheel.side:
            yield from pen.planet(wheel)
    for link in scheme.train.carrier_of:
        yield from pen.hub(link) if link not in scheme.train.crossing else ()
    for link in scheme.train.crossing:
        yield from pen.across(link)
    for rack in scheme.train.racks:
        yield from pen.rack(rack)
    for body in dict.fromkeys(scheme.train.body_of.values()):
        yield from pen.idle(body)


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
                (start, end), past = (self.on(pick(some), float(height)) for pick in (min, max)), 2.2 * self._face
            yield Line(start - past, end + past, fit(self.hand.axis, abs(end - start) + 2 * past))
        for link, rows in self.train.crossing.items():
            x, heights = self.routing.columns[rows[0].cross.name], self.train.heights
            start, end = (self.on(x, float(heights[one])) for one in (rows[0].level.link, link))
            yield Line(start, end, fit(self.hand.axis, abs(end - start)))

    def _fixed(self, link: str) -> bool:
        return link not in self.train.carrier_of

    def post(self, post: Post) -> Iterator[Stroke]:
        """Draw a post with what is at its end."""
        hand, foot, top = self.hand, self.on(post.x, self.routing.level(post.body)), self.on(post.x, post.top)
        if post.kind == ARM and post.body in self.routing.roofs:  # down to the lowest wheel of its planet
            links = self.train.carriers[post.name]
            low = min(row.place[1] for link in links for row in self.train.crossing[link])
            foot = self.on(post.x, float(self.train.heights[post.name] + low)) - 1.5j * self._face
        if post.kind == SUN:
            yield from self._sun(self.train.wheels[post.name], foot)
        elif post.kind in (INPUT, OUTPUT):
            yield from self._end(post, foot)
        else:
            yield Line(foot, top, hand.result)
            yield from self._shoes(top) if post.kind == BRAKE else self._ground(top) if post.kind == HELD else ()

    def _sun(self, wheel: ToothedWheel, foot: complex) -> Iterator[Stroke]:
        centre = self.on(self.routing.columns[wheel.name], float(self.train.heights[wheel.link]))
        both, along = self.scheme.both(wheel), 1 + 0j
        if row := next((row for row in self.train.bevels.values() if row.level == wheel), None):
            along = complex(_edge(row).real, abs(_edge(row).imag))
        reach = self.place.length(float(wheel.radius)) - MESHED * self.hand.symbol / abs(along.real)
        yield Line(centre - 1j * reach if both and foot == centre else foot, centre + 1j * reach, self.hand.result)
        if both and foot != centre:  # another shaft passes through it
            under = 2 * centre - foot
            yield Line(under, centre - 1j * reach, self.hand.result)
            yield from (Line(at - self._face, at + self._face, self.hand.result) for at in (foot, under))
        for side in (1, -1) if both else (1,):
            yield self._bar(centre + 1j * side * reach, along if side > 0 else along.conjugate())
        yield from self._cross(foot)

    def idle(self, body: str) -> Iterator[Stroke]:
        """Draw the axle of wheels that nothing else holds, in bearings at both ends."""
        posts = [post for post in self.routing.posts if post.body == body]
        if posts and all(post.kind == SUN for post in posts):
            y, half = self.routing.level(body), 2.0 * self._face
            start, end = (self.on(pick(post.x for post in posts), y) for pick in (min, max))
            yield Line(start - half, end + half, self.hand.result)
            yield from (part for at in (start - half, end + half) for part in self._bearing(at))

    def _bar(self, middle: complex, along: complex = 1 + 0j) -> Line:
        return Line(middle - along * self._face, middle + along * self._face, self.hand.result)

    def across(self, link: str) -> Iterator[Stroke]:
        """Draw bevel wheels whose axis is across: on a shaft with its end, or on the arm of their carrier."""
        rows, hand, free = self.train.crossing[link], self.hand, link in self.train.carrier_of
        feet = []
        for row in {row.cross.name: row for row in rows}.values():
            y = float(self.train.heights[row.level.link] + row.place[1])
            middle, edge = self.on(self.routing.columns[row.cross.name], y), _edge(row)
            reach = self.place.length(float(row.cross.radius)) - MESHED * hand.symbol / abs(edge.imag)
            feet.append(middle)
            for side in (1, -1):
                yield Line(middle + side * HUB * hand.symbol * free, middle + side * reach, hand.result)
                along = edge if side * edge.real > 0 else -edge.conjugate()
                yield self._bar(middle + side * reach, along)
        low, high = (pick(feet, key=lambda foot: foot.imag) for pick in (min, max))
        if free:
            half, ends = HUB * hand.symbol, (low - 1j * self._face, high + 1j * self._face)
            yield from (Line(ends[0] + way * half, ends[1] + way * half, hand.result) for way in (1, -1))
            return
        yield from self._cross(low)
        end = self.on(self.routing.columns[rows[0].cross.name], self.scheme.end(link))
        yield Line(low, end, hand.result)
        along, beside = 1j * BEARING / 2 * hand.symbol, OFF * hand.symbol
        for way in (1, -1):
            middle = (low + end) / 2 + way * beside
            yield from ground(middle - along, middle + along, complex(way), hand)
        outward = 1j * rows[0].up * ARROW * hand.symbol
        yield from arrow(*((end, end + outward) if link == self.train.output else (end + outward, end)), hand)

    def _cross(self, at: complex) -> Iterator[Stroke]:
        """Draw that a wheel is fixed on its shaft."""
        arm = CROSS * self.hand.symbol
        yield from (Line(at - arm * way, at + arm * way, self.hand.other) for way in (1 + 1j, 1 - 1j))

    def _end(self, post: Post, foot: complex) -> Iterator[Stroke]:
        """Draw the end of a driving or driven shaft: its bearing, and an arrow into the train or out of it."""
        inward = 1.0 if self.scheme.across[post.x] < self.scheme.right / 2 else -1.0
        yield from self._bearing(foot + inward * BEARING * self.hand.symbol)
        end = foot - inward * ARROW * self.hand.symbol
        yield from arrow(*((end, foot) if post.kind == INPUT else (foot, end)), self.hand)

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
        some, y, half = self.routing.across(link), float(self.train.heights[link]), HUB * self.hand.symbol
        start, end = self.on(min(some), y) - self._face, self.on(max(some), y) + self._face
        yield from (Line(start + way * half, end + way * half, self.hand.result) for way in (1j, -1j))
        if min(some) == max(some):
            yield Line(start, end, self.hand.result)

    def ring(self, wheel: ToothedWheel) -> Iterator[Stroke]:
        """Draw a ring: its face inside, its side up to its outside, there what holds it."""
        x, hand = self.routing.columns[wheel.name], self.hand
        face = self.on(x, float(self.train.heights[wheel.link] + wheel.radius)) + 1j * MESHED * hand.symbol
        outside, body = self.on(x, self.routing.outside(wheel)), self.train.body_of[wheel.link]
        disc = any(post.body == body and post.kind == DISC for post in self.routing.posts)
        top = self.on(x, self.routing.bar(body)) if disc or len(self.routing.rings(body)) > 1 else outside
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
        high = top + 1j * (SHOE + OFF) * self.hand.symbol
        for name in (name for name, link in held(self.train) if self.train.body_of[link] == body):
            yield from (Line(top, high, self.hand.result), *self._shoes(high)) if name else self._ground(top)


def _edge(row: BevelMesh) -> complex:
    """Give the direction of the common edge of two cones, from the apex."""
    edge = complex(*map(float, row.place))
    return edge / abs(edge)
