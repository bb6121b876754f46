"""The scheme of a train in the plane of its axes, radii to scale: half outlines as GOST 2.770-68 has them (схема)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Final

import numpy as np

from drawings.gears.routing import ARM, BRAKE, PLATE, RIM, STUB, Routing, held
from drawings.layout.labels import Labels
from drawings.layout.picture import Place
from drawings.lettering.words import with_index
from drawings.paper.hand import Hand
from drawings.paper.strokes import Stroke
from plans.gears.kutzbach import TrainPoint
from plans.model.gears import ACROSS, FRAME, ToothedWheel, Train

STEP = 0.11  # of the height of the train: from one place across to the next
FACE = 0.32  # steps, half of the width of a wheel
CLOSE: Final = 0.22  # steps between the plates of a clutch
BORNE = 0.8  # steps, half of an axle that stands in two bearings
SHOE = 4.0  # mm by the factor of the hand: a shoe of a brake
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
        pins = self._pins(found)
        if not pins:
            return found
        places, moves = [found[x] for x in sorted(pins)], [pins[x] - found[x] for x in sorted(pins)]
        return {x: at + float(np.interp(at, places, moves)) for x, at in found.items()}

    def _pins(self, found: Mapping[float, float]) -> Mapping[float, float]:
        """Give where bevel wheels stand about their apexes, true lengths m."""
        pins, columns = dict[float, float](), self.routing.columns
        for rows in sorted(self.train.crossing.values(), key=lambda rows: columns[rows[0].cross.name]):
            off = {columns[row.level.name]: float(row.place[0]) for row in rows} | {columns[rows[0].cross.name]: 0.0}
            first, last = min(off), max(pins, default=min(found))
            start = pins.get(last, found[last]) + found[first] - found[last] - off[first]
            pins |= {x: start + aside for x, aside in off.items()}
        return pins

    @property
    def right(self) -> float:
        """The last place across, m, or the right of a bevel wheel beyond that."""
        return max(*self.across.values(), *(middle + r for middle, r in self._crowns))

    @property
    def left(self) -> float:
        """The first place across, m, or the left of a bevel wheel before that."""
        return min(*self.across.values(), *(middle - r for middle, r in self._crowns))

    @property
    def _crowns(self) -> list[tuple[float, float]]:
        """The axes of bevel wheels of axes across, m, and their radii."""
        return [(self.axis(row.cross.link), float(row.cross.radius)) for row in self.train.bevels.values()]

    @property
    def whole(self) -> bool:
        """Whether the wheels of the main axis are drawn on both sides of it too: no planet is there."""
        return not self.train.carriers

    @property
    def reach(self) -> tuple[float, float]:
        """The least and the largest height m that it takes."""
        wheels = self.train.wheels.values()
        tops = [self.routing.outside(w) if w.internal else self.top(w) for w in wheels]
        slides = [*map(self.back, self.train.racks), *(post.top for post in self.routing.posts if post.kind == ARM)]
        slides += [self.end(link) for link in self.train.crossing if link not in self.train.carrier_of]
        lows = [self._height(w) - float(w.radius) for w in wheels if self.both(w)]
        return min(0.0, *lows, *slides, *map(float, self.train.heights.values())), max(*tops, *slides)

    def top(self, wheel: ToothedWheel) -> float:
        """Give the height m of the top of a wheel."""
        return self._height(wheel) + float(wheel.radius) * (wheel.link not in self.train.crossing)

    def axis(self, link: str) -> float:
        """Give where an axis across stands, m from the first place."""
        return self.across[self.routing.columns[self.train.crossing[link][0].cross.name]]

    def end(self, link: str) -> float:
        """Give the height m of the end of a shaft across."""
        return float(self.train.heights[link]) + 1.5 * STUB * self.routing.size * self.train.crossing[link][0].up

    def back(self, rack: str) -> float:
        """Give the height m of the back of a rack, where its guide is."""
        return float(self.train.rack_height(rack)) + self.train.rack_side(rack) * RIM * self.routing.size

    def _height(self, wheel: ToothedWheel) -> float:
        return float(self.train.heights[wheel.link])

    def both(self, wheel: ToothedWheel) -> bool:
        """Tell whether a wheel is drawn on both sides of its axis."""
        if wheel.side in ACROSS:
            return False
        under = [row.up < 0 for row in self.train.bevels.values() if row.level == wheel]
        under += [self.train.rack_side(rack) < 0 for rack, name in self.train.racks.items() if name == wheel.name]
        alone = self.whole or wheel.link in self.train.carrier_of or self._height(wheel) != 0
        return not wheel.internal and (alone or any(under))

    def at(self, x: float, y: float) -> complex:
        """Give a true place from the place across and the height."""
        return complex(self.across[x], y)

    def contact(self, spot: TrainPoint) -> complex:
        """Give where a point of the train is in the scheme: a mesh in its column, a planet's centre at its wheel."""
        if spot.rack:
            return self.at(self.routing.columns[self.train.racks[spot.rack]], float(spot.height))
        columns = {w.name: self.routing.columns[w.name] for w in self.train.wheels.values() if w.link in spot.links}
        for mesh in self.train.meshes:
            if {*mesh} <= {*columns} and self.train.contact(mesh) == spot.height:
                bevel = self.train.bevels.get(mesh)
                return self.at(columns[bevel.level.name if bevel else mesh[0]], float(spot.height))
        return self.at(max(columns.values()), float(spot.height))

    def beyond(self, spot: TrainPoint) -> complex:
        """Give where the level of a point begins: past the faces of a mesh, at the end of an axle, of the scheme."""
        if spot.links[0] == FRAME and not spot.height:
            return complex(self.right, 0.0)
        if spot.links[0] in self.train.carrier_of and spot.links[1] == self.train.carrier_of[spot.links[0]]:
            return self.at(self.routing.axle(spot.links[0]).right, float(spot.height))
        past = BORNE if spot.links[0] == FRAME else FACE
        return self.contact(spot) + past * STEP * self.routing.size

    def letters(self, place: Place, hand: Hand, labels: Labels) -> Iterator[Stroke]:
        """Letter wheels, carriers, brakes and clutches."""
        size, columns, seen = hand.number, self.routing.columns, set[str]()
        for wheel in self.train.wheels.values():
            y, r = self._height(wheel), float(wheel.radius)
            if wheel.side in ACROSS:
                row = next(row for row in self.train.crossing[wheel.link] if row.cross == wheel)
                spot = self.at(columns[wheel.name], float(self._height(row.level) + row.place[1])) + 0.45 * r
                yield labels.beside(place.on(spot), wheel.name, size, BESIDE, row.up * math.pi / 2)
                continue
            outside = self.routing.outside(wheel) - 0.03 * self.routing.size
            spot = self.at(columns[wheel.name], outside if wheel.internal else y + r * 0.55)
            yield labels.beside(place.on(spot), wheel.name, size, BESIDE, math.pi)
        for rack in self.train.racks:
            back = self.at(columns[self.train.racks[rack]], self.back(rack)) + (FACE + CLOSE) * STEP * self.routing.size
            yield labels.beside(place.on(back), rack, size, BESIDE, 0.0)
        for post in self.routing.posts:
            if post.kind in (ARM, BRAKE, PLATE) and post.name not in seen:
                seen.add(post.name)
                y, up = post.top, math.pi / 2
                if post.kind == ARM:
                    y, up = (y + self.routing.roofs.get(post.body, self.routing.level(post.body))) / 2, 0.0
                yield labels.beside(place.on(self.at(post.x, y)), with_index(post.name), size, BESIDE + 0.7, up)
        for name, link in held(self.train):
            if name and name not in seen:
                ring = self.routing.rings(self.train.body_of[link])[0]
                top = place.on(self.at(columns[ring.name], self.routing.outside(ring))) + 1j * SHOE * hand.symbol
                yield labels.beside(top, with_index(name), size, 2.5 * hand.symbol, 0.0)
