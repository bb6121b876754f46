"""The scheme of a train beside the triangles of its velocities, heights on one level (картина линейных скоростей)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from drawings.gears.parts import scheme_parts
from drawings.gears.scheme import BESIDE, TrainScheme
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.gear_letters import link_letters
from drawings.lettering.words import with_index
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.symbols.figure import Subject, around, heading, heading_width, point, vector
from drawings.symbols.symbols import arrowhead, pole
from plans.gears.kutzbach import AXIS, LINEAR, KutzbachPlan, board_of
from plans.model.gears import FRAME

MARGINS = Margins(3.0, 3.0, 2.6)  # paper around it for letters, in their sizes
LETTERS = 24.0  # it is drawn at least so many letters large
BETWEEN = 0.12  # of the height: from the scheme to the triangles
PAST = 0.06  # of the height: how far lines go past their points
RACK = 2.0  # of that: how far the upright line of a rack goes past its mesh point
ALIKE = 1e-6  # of the height: lines so near each other are one
SHORT = 0.6  # mm: a shorter velocity is a point


class ShownLinear(NamedTuple):
    """The triangles of velocities of a gear, with the scheme beside them, or alone."""

    name: str
    title: str
    plan: KutzbachPlan
    scheme: TrainScheme
    schemed: bool

    @property
    def high(self) -> float:
        """The height of all, m."""
        low, top = self.scheme.reach
        return top - low

    @property
    def zero(self) -> float:
        """Where the line of zero velocities stands, m across."""
        beside = self.scheme.right + BETWEEN * self.high if self.schemed else 0.0
        return beside - min(0.0, *(image.real for image in self.images.values()))

    @property
    def images(self) -> dict[str, complex]:
        """The ends of the velocities, as lengths m over the heights."""
        return {name: complex(mark.point) for name, mark in self.plan.images.items()}

    @property
    def lines(self) -> dict[str, tuple[complex, complex]]:
        """The lines of links between their outermost points, a little longer; links of one line share it."""
        found, past = dict[tuple[float, float], tuple[list[str], list[complex]]](), PAST * self.high
        for link in (link for link in self.scheme.train.links if link not in self.scheme.train.crossing):
            ends = [self.images[spot.letter] for spot in self.scheme.spots if link in spot.links]
            speed = complex(self.plan.speeds[link].point).real * self.plan.tau
            foot = ends[-1].real - speed * ends[-1].imag
            key = round(speed / ALIKE) * ALIKE, round(foot / self.high / ALIKE) * ALIKE
            links, spots = found.setdefault(key, ([], []))
            links.append(link)
            spots += ends
        moving = (row for key, row in found.items() if any(key))
        rows = ((", ".join(map(link_letters, some)), sorted(ends, key=lambda end: end.imag)) for some, ends in moving)
        slides = {link_letters(spot.rack): self.images[spot.letter] for spot in self.scheme.spots if spot.rack}
        upright = {name: (end - RACK * 1j * past, end + RACK * 1j * past) for name, end in slides.items()}
        return {name: _longer(ends[0], ends[-1], past) for name, ends in rows} | upright

    @property
    def crossing(self) -> dict[str, tuple[complex, dict[str, complex]]]:
        """The velocities of links that turn across, upright over their points: where they start, and their ends."""
        found, train, (low, top) = dict[str, tuple[complex, dict[str, complex]]](), self.scheme.train, self.scheme.reach
        for link, rows in train.crossing.items() if self.schemed else ():
            spots = [spot for spot in self.scheme.spots if link in spot.links and spot.across is not None]
            axis = self.scheme.axis(link)
            ends = {one.letter: complex(axis + float(one.across or 0), self.images[one.letter].real) for one in spots}
            if link not in train.carrier_of:
                ends[""] = complex(axis)
            speeds, gap = [0.0, *(end.imag for end in ends.values())], BETWEEN * self.high
            start = top + gap - min(speeds) if rows[0].up > 0 else low - gap - max(speeds)
            found[link] = complex(0, start), ends
        return found

    def line_across(self, link: str) -> tuple[complex, complex]:
        """The line of a link that turns across, a little longer."""
        start, ends = self.crossing[link]
        first, last = (pick(ends.values(), key=lambda end: end.real) for pick in (min, max))
        return _longer(start + first, start + last, PAST * self.high)

    @property
    def free_ends(self) -> dict[str, complex]:
        """The end of each line that is farthest from those of all others: there it is named."""
        lines, found = self.lines, dict[str, complex]()
        for name, (low, high) in lines.items():
            others = [end for one, ends in lines.items() if one != name for end in (*ends, 0j)]
            found[name] = max((high, low), key=lambda end: min(abs(end - other) for other in others or [0j]))
        return found

    @property
    def resting(self) -> str:
        """The links that rest, after the frame."""
        lines = self.plan.lines
        return ", ".join((FRAME, *(link_letters(link) for link, line in lines.items() if line.name == FRAME)))


def _longer(start: complex, end: complex, past: float) -> tuple[complex, complex]:
    along = (end - start) / abs(end - start) * past
    return start - along, end + along


def measure(shown: ShownLinear, drafting: Drafting) -> Picture:
    """Measure the room that it needs."""
    hand, (low, top) = drafting.hand, shown.scheme.reach
    past = PAST * shown.high
    ends = [*shown.images.values(), *(end for line in shown.lines.values() for end in line)]
    across = [shown.zero + end.real for end in ends]
    left = shown.scheme.left if shown.schemed else min(across) - past
    corners = [complex(left, min(low, -past)), complex(max(across), top + past)]
    corners += [start + end for start, ends in shown.crossing.values() for end in (*ends.values(), 0j)]
    scales = _scales(shown, Scale(0.002, "l", "m"), drafting)
    title = max(heading_width(shown.title, hand), heading_width(scales, hand) * 0.7)
    return picture(shown.name, corners, ("l", "m"), around(MARGINS, hand), title, LETTERS * hand.letter)


def _velocity(shown: ShownLinear, scale: Scale) -> Scale:
    return Scale(float(f"{scale.mu / shown.plan.tau:.12g}"), "v", "m/s")


def _scales(shown: ShownLinear, scale: Scale, drafting: Drafting) -> str:
    return drafting.scale(_velocity(shown, scale), scale)


def draw(shown: ShownLinear, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the scheme, the levels of its points, the lines of links and the velocities of points."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, shown.title, _scales(shown, spot.scale, drafting), hand)
    scheme = scheme_parts(shown.scheme, place, hand) if shown.schemed else ()
    low, top = shown.scheme.reach
    past = PAST * shown.high
    foot, head = (place.on(complex(shown.zero, y)) for y in (min(low, -past), top + past))
    ends = ((place.on(shown.zero + one), place.on(shown.zero + other)) for one, other in shown.lines.values())
    lines = [Line(one, other, hand.result) for one, other in ends]
    lines.append(Line(foot, head, hand.result))
    arrows = filter(None, (_arrow(shown, name, place, drafting) for name in shown.plan.velocities))
    subject, zero = Subject(board_of(LINEAR, shown.plan.gear), "v", None), pole(place.on(complex(shown.zero)))
    origin = point(subject, AXIS, 0j, Place(zero.centre, 0j, _velocity(shown, spot.scale)), zero, "pole")
    upright = (line for link in shown.crossing for line in _across(shown, link, place, hand))
    drawn = title, *_levels(shown, place, drafting), *scheme, *lines, *upright, origin, *arrows
    return LetteredFigure(shown.name, drawn, partial(_letters, shown, place, drafting))


def _across(shown: ShownLinear, link: str, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the velocities of a link that turns across upright over its points, and its line through their ends."""
    start, ends = shown.crossing[link]
    first, last = (pick(ends.values(), key=lambda end: end.real) for pick in (min, max))
    past, spots = PAST * shown.high, {spot.letter: spot for spot in shown.scheme.spots}
    yield Line(place.on(start + first.real - past), place.on(start + last.real + past), hand.result)
    one, other = shown.line_across(link)
    yield Line(place.on(one), place.on(other), hand.result)
    for letter, end in ends.items():
        foot, tip = place.on(start + end.real), place.on(start + end)
        if letter:
            yield Line(place.on(complex(end.real, float(spots[letter].height))), foot, hand.drafted)
        if abs(tip - foot) > SHORT and (head := arrowhead(foot, tip, hand.symbol)):
            yield from (Line(foot, tip, hand.relative), head)


def _levels(shown: ShownLinear, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Carry each height over from the last of its points in the scheme to the triangles."""
    for height in dict.fromkeys(spot.height for spot in shown.scheme.spots):
        spots = [spot for spot in shown.scheme.spots if spot.height == height]
        start = max(shown.scheme.beyond(spot).real for spot in spots) if shown.schemed else _left(shown)
        end = shown.zero + max(0.0, *(shown.images[spot.letter].real for spot in spots))
        first, last = (place.on(complex(x, float(height))) for x in (start, end))
        yield Line(first, last, drafting.hand.drafted)


def _left(shown: ShownLinear) -> float:
    return shown.zero + min(0.0, *(image.real for image in shown.images.values())) - PAST * shown.high


def _arrow(shown: ShownLinear, name: str, place: Place, drafting: Drafting) -> Stroke | None:
    """Draw the velocity of a point from the line of zero velocities to its image."""
    image, scale = shown.images[name], _velocity(shown, place.scale)
    speed = complex(shown.plan.velocities[name].point)
    if abs(speed) / scale.mu < SHORT:
        return None
    here = Place(place.on(complex(shown.zero, image.imag)), 0j, scale)
    subject, hand = Subject(board_of(LINEAR, shown.plan.gear), "v", None), drafting.hand
    drawn = vector(subject, f"v_{name}", (0j, speed), here, hand.relative, hand.symbol)
    return drawn._replace(title=with_index(name.lower()))


def _letters(shown: ShownLinear, place: Place, drafting: Drafting, labels: Labels) -> Iterator[Stroke]:
    """Letter the train, its points, their images, the lines of links."""
    hand = drafting.hand
    if shown.schemed:
        yield from shown.scheme.letters(place, hand, labels)
    for spot in shown.scheme.spots:
        fixed, image = spot.links[0] == FRAME, shown.images[spot.letter]
        if not spot.height and (fixed or not shown.schemed):
            at, way = complex(shown.zero), -2.6
        elif shown.schemed:
            at, way = shown.scheme.contact(spot), -0.8 if fixed else -0.6 if spot.rack else 0.6
        else:
            at, way = complex(_left(shown), float(spot.height)), math.pi
        yield labels.beside(place.on(at), with_index(spot.letter), hand.letter, BESIDE, way)
        if not fixed:
            way = -0.6 if image.real > 0 else math.pi - 0.6  # what rests or goes back has its letter on that side
            yield labels.beside(place.on(shown.zero + image), with_index(spot.image), hand.letter, BESIDE, way)
    for name, end in shown.free_ends.items():
        up = math.pi / 2 if end == shown.lines[name][1] else -math.pi / 2
        yield labels.beside(place.on(shown.zero + end), name, hand.number, BESIDE, up)
    for link, (start, ends) in shown.crossing.items():
        for letter, end in ends.items():
            if letter:
                at = place.on(start + end)
                yield labels.beside(at, f"{with_index(letter.lower())}′", hand.letter, BESIDE, -0.6)
        base = place.on(start + max(end.real for end in ends.values()) + PAST * shown.high)
        yield labels.beside(base, FRAME, hand.number, BESIDE, 0.0)
        first, last = shown.line_across(link)
        end = max((last, first), key=lambda end: abs((end - start).imag))
        yield labels.beside(place.on(end), link_letters(link), hand.number, BESIDE, 0.8 if end == last else 2.3)
    top = place.on(complex(shown.zero, shown.scheme.reach[1] + PAST * shown.high))
    yield labels.beside(top, shown.resting, hand.number, BESIDE, math.pi / 2)
