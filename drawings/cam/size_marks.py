"""Arcs of the phases round a profile, and the marks of the main sizes (фазовые углы и размеры)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

from drawings.cam.inversion import ProfileRings, beyond, highest
from drawings.cam.notes import phase_letter
from drawings.cam.profile_view import NAME, QUANTITY, ProfileView
from drawings.cam.profile_view import NAME as PROFILE
from drawings.cam.size_view import SizeView, leaning, lower
from drawings.kinds.axes import Letter
from drawings.layout.labels import NEAR, Labels
from drawings.layout.picture import Place
from drawings.lettering.words import Slot, joined, telling
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, TURN, Arc, Circle, Group, Kind, Line, Polyline, Statement, Stroke
from drawings.paper.walk import stating, tied_spot
from drawings.symbols.figure import Dimension, Subject, arrows
from drawings.symbols.symbols import TurnArrow, arrowhead, fit, hatching
from plans.cam.centre.bounds import PressureBound
from plans.cam.centre.place import SizeTangent
from plans.model.cam import DWELL, MM, Phase
from plans.model.cam_motion import CamSizes, Extreme

PAST = 1.5  # mm that an axis goes past the arc that ends at it
BESIDE = 1.2  # mm from an arc to its letter


class AngleArc(NamedTuple):
    """The arc of an angle on paper, with the name and the letter of that."""

    name: str
    letter: str
    arc: TurnArrow

    def draw(self, hand: Hand) -> Iterator[Stroke]:
        """Draw it, an arrow at either end."""
        yield stating(Statement(Kind.ANGLE, PROFILE, self.name), *self.arc.angle(hand))

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it beyond its middle."""
        spot, away = self.arc.middle
        return telling(PROFILE, labels.beside(spot, self.letter, hand.number, BESIDE, away))


def phase_arcs(view: ProfileView, rings: ProfileRings, drafting: Drafting) -> tuple[AngleArc, ...]:
    """Give the arcs of the phases: they run against the cam's motion, as the frame is turned."""
    arcs = []
    for number, phase in enumerate(() if view.cam.translates else view.cam.phases):
        start = cmath.phase(rings.crossing(phase.start, rings.phases))
        text, sweep = phase_letter(view.cam, number, drafting), -view.cam.sense * min(phase.angle, TURN)
        arcs.append(AngleArc(f"φ_{number}", text, TurnArrow(rings.place.on(0j), rings.phases, start, sweep)))
    return tuple(arcs)


def bounds(view: ProfileView, rings: ProfileRings, hand: Hand) -> Iterator[Stroke]:
    """Draw the axes at which phases begin as far as the arcs between them."""
    zero = rings.place.on(0j)
    for phase in view.cam.phases:
        ends = (rings.crossing(phase.start, radius) for radius in (rings.ends, rings.phases + PAST * hand.symbol))
        start, end = (zero + off for off in ends)
        yield Line(start, end, hand.drafted)


def travels(view: ProfileView, rings: ProfileRings, drafting: Drafting) -> tuple[Dimension, ...]:
    """Give the dimensions of the phases of a cam that translates, above its follower's guide."""
    if not view.cam.translates:
        return ()
    hand = drafting.hand
    off = 1j * (beyond(hand) + 2 * hand.number)
    said = partial(Statement, Kind.LENGTH, PROFILE, scale=rings.place.scale.mu)
    return tuple(
        Dimension(phase_letter(view.cam, number, drafting), *_over(view, rings, phase), off, said(f"φ_{number}"))
        for number, phase in enumerate(view.cam.phases)
    )


def _over(view: ProfileView, rings: ProfileRings, phase: Phase) -> tuple[complex, complex]:
    """Give the ends of the axes at which a phase of a cam that translates begins and ends, mm."""
    level = highest(view, rings.place, rings.hand)
    start, end = (rings.place.on(view.back(0j, turned)).real for turned in (phase.start, phase.end))
    return complex(start, level), complex(end, level)


GAP = 1.2  # mm from an arc to its letter
ARM = 3.6  # letters: radius of the arc of an angle
NEARER = 0.5  # of that: where two angles would have their arcs on one place, and their letters
CROWD = 2 * (GAP + NEAR[-1])  # mm between the middles of two arcs: no letter beside one is as near to the other
OVER = 1.2  # of the radius: how far the line goes from which the angle is counted


class LimitAngle(NamedTuple):
    """The angle at which a tangent leans from the way of K, both produced to its upper end (угол давления)."""

    corner: complex  # the upper end of the tangent, mm
    line: complex  # upward along the tangent, and along the way of K; of length 1
    way: complex
    arm: float  # radius of its arc, mm

    @property
    def middle(self) -> complex:
        """The middle of its arc."""
        return self.corner + cmath.rect(self.arm, self.side)

    @property
    def side(self) -> float:
        """The direction of the middle from the corner, rad."""
        return cmath.phase(-(self.line + self.way))

    def draw(self, hand: Hand) -> Iterator[Stroke]:
        """Draw the way of K beyond the tangent's upper end, and the arc."""
        yield Line(self.corner, self.corner - OVER * self.arm * self.way, hand.drafted)
        turns = sorted(cmath.phase(-ray) % (2 * math.pi) for ray in (self.line, self.way))
        yield Arc(self.corner, self.arm, turns[0], turns[1], hand.other)


def rulers(view: SizeView, place: Place, drafting: Drafting) -> tuple[tuple[Stroke, ...], tuple[Letter, ...]]:
    """Draw the tangents, each with its angle at its upper end, and the chord's thin beside them."""
    lines: list[Stroke] = []
    letters: list[Letter] = []
    taken: list[complex] = []
    for tangent in view.sizing.tangents:
        past, foot = (place.on(end) for end in view.ruler(tangent))
        style = drafting.hand.relative if tangent.binding else drafting.hand.other
        lines.append(Line(past, foot, style))
        angle = _angle(view, tangent, past, drafting.hand, taken)
        if angle is not None:
            taken.append(angle.middle)
            lines += angle.draw(drafting.hand)
            assert isinstance(tangent.bound, PressureBound)
            sign, minus = (-1, "−") if lower(tangent) else (1, "")
            size = drafting.slot(Slot(f"{minus}α_{tangent.bound.kind}", sign * math.degrees(tangent.bound.angle)))
            text = joined("", (minus, drafting.letter(f"α_{{{tangent.bound.kind}}}"), " = ", size, "°"))
            letters.append(Letter(angle.middle, text, drafting.hand.number, angle.side, GAP))
        elif not view.cam.rocks:
            letters.append(Letter(past, "45°", drafting.hand.number, 0.0))
    lines += _chord(view, place, drafting.hand)
    return tuple(lines), tuple(letters)


def _angle(
    view: SizeView, tangent: SizeTangent, past: complex, hand: Hand, taken: Sequence[complex]
) -> LimitAngle | None:
    """Give the angle of a tangent, its arc where no other one is; none of a tangent at 45 degrees."""
    way, line, arm = leaning(tangent, view), complex(tangent.direction.point), ARM * hand.letter
    if way is None:
        return None
    line *= math.copysign(1.0, line.imag) / abs(line)
    ways = (LimitAngle(past, line, way, radius) for radius in (arm, NEARER * arm))
    return max(ways, key=lambda angle: min((CROWD, *(abs(angle.middle - spot) for spot in taken))))


def _chord(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the chord of a rocker's arc and the tangents by it, dashed, as far as they meet."""
    chord = view.sizing.chord
    if chord is None:
        return
    start, end = place.on(view.start), place.on(max((complex(tip) for tip in view.tips), key=lambda spot: spot.imag))
    yield Line(start, end, fit(hand.path, abs(end - start)))
    centre = place.on(complex(chord.centre.point))
    for tangent in chord.tangents:
        touched = place.on(complex(tangent.point.point))
        yield Line(touched, centre, fit(hand.path, abs(centre - touched)))


def region(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Hatch the region that is left to O, and draw its edge where it does not go on beyond what is shown."""
    corners = [*{tied_spot(place.on(corner)): corner for corner in view.region}.values()]  # a sliver has no edge
    if len(corners) < 3:
        return
    yield from hatching([place.on(corner) for corner in corners], hand)
    for start, end in zip(corners, (*corners[1:], corners[0]), strict=True):
        if not view.ends_at(start, end):
            yield Polyline((place.on(start), place.on(end)), False, hand.drafted)


OFFSET = 0.55  # of the room under the follower: where the offset is dimensioned
LEAST = 4.0  # mm: a shorter size, but the offset, is told by the table alone
ROUNDED = 1e-9  # of R0: a smaller offset is one of rounding
SHOWN = math.radians(35)  # half the arc of the circle through three points
NEARBY = math.radians(5)  # of the cam's turn: from the sharpest place to the other two points
LARGE = 4.0  # letters by which a circle of curvature may be larger than the cam
DIGITS = 4
INITIAL = 0.45  # of the arm: where the initial angle is shown
ROOM = 16.0  # mm: a shorter least radius has no room for its letter


class SizeMark(NamedTuple):
    """A size on paper: its name, its letters with the value, its ends, its true value as a vector, m."""

    name: str
    letter: str
    start: complex
    end: complex
    value: complex
    both: bool = False  # whether it has arrows at both ends

    def draw(self, place: Place, hand: Hand) -> Group:
        """Draw its line with its arrows; it can be measured."""
        data = Subject(NAME, QUANTITY, None).data("vector", self.name, self.value, place.scale)
        if self.both:
            line, *others = arrows(self.start, self.end, hand)
            return Group((line, *others), "", data, self.letter)
        head = arrowhead(self.start, self.end, hand.symbol)
        line = Line(self.start, self.end, hand.drafted)
        return Group((line,) if head is None else (line, head), "", data, self.letter)


def size_marks(view: ProfileView, place: Place, drafting: Drafting) -> tuple[SizeMark, ...]:
    """Give the sizes that are long enough on paper to bear a letter."""
    every = (*_main(view, place, drafting), *_sharpest(view, place, drafting))
    return tuple(mark for mark in every if mark.both or abs(mark.end - mark.start) >= LEAST)


def _main(view: ProfileView, place: Place, drafting: Drafting) -> Iterator[SizeMark]:
    sizes = view.found.sizes
    if view.cam.translates:
        return
    ray = cmath.rect(sizes.base, view.quiet)
    if place.length(sizes.base) >= ROOM * drafting.hand.symbol:
        yield _mark("R_0", 0j, ray, sizes.base, place, drafting)
    if offset_seen(sizes):
        level = 1j * _level(view)
        yield _mark("e", level, level + view.axis, sizes.offset, place, drafting)._replace(both=True)
    if sizes.pivot:
        yield _mark("L", 0j, sizes.pivot, abs(sizes.pivot), place, drafting)


def offset_seen(sizes: CamSizes) -> bool:
    """Tell whether there is an offset, which is dimensioned however short it is: not one left by rounding."""
    return abs(sizes.offset) > ROUNDED * sizes.base


def _level(view: ProfileView) -> float:
    """Give the level over O at which the offset is dimensioned, m."""
    return OFFSET * max(view.found.sizes.base - view.found.roller, 0.0)


def _sharpest(view: ProfileView, place: Place, drafting: Drafting) -> Iterator[SizeMark]:
    """Give the least radius of curvature of the pitch curve, from the centre to the curve."""
    sharpest = view.found.sharpest
    if sharpest is not None and _visible(view, sharpest, place, drafting.hand):
        spot, normal = view.at(sharpest.turned)
        yield _mark("ρ_min", spot - sharpest.value * normal, spot, sharpest.value, place, drafting)


def _visible(view: ProfileView, extreme: Extreme, place: Place, hand: Hand) -> bool:
    """Tell whether a circle of the least radius is drawn: none of a dwell, a hollow, a cusp, or larger than the cam."""
    turns = extreme.turned, extreme.turned + view.cam.turn  # a dwell that ends the turn ends where it begins
    still = any(phase.kind == DWELL and phase.start <= turn <= phase.end for phase in view.cam.phases for turn in turns)
    return not still and LEAST <= place.length(extreme.value) < place.length(view.reach) + LARGE * hand.letter


def centre_letters(view: ProfileView, place: Place, hand: Hand) -> Iterator[Letter]:
    """Letter the centre of the circle of the least radius."""
    sharpest = view.found.sharpest
    if sharpest is not None and _visible(view, sharpest, place, hand):
        spot, normal = view.at(sharpest.turned)
        yield Letter(place.on(spot - sharpest.value * normal), "C", hand.letter, cmath.phase(-normal), BESIDE)


def _mark(name: str, start: complex, end: complex, size: float, place: Place, drafting: Drafting) -> SizeMark:
    text = joined(" = ", (name.replace("_min", "_{min}"), drafting.slot(Slot(name, MM * size, DIGITS))))
    return SizeMark(name, text, place.on(start), place.on(end), end - start)


def thin(view: ProfileView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw what the sizes stand by: the line of centres' axis, the level of the offset, the circle by three points."""
    if offset_seen(view.found.sizes) and not view.cam.translates:
        top = place.on(1j * _level(view))
        yield Line(place.on(0j), top + 2j * hand.symbol, hand.drafted)
    sharpest = view.found.sharpest
    if sharpest is not None and _visible(view, sharpest, place, hand):
        yield from _circle(view, sharpest.turned, sharpest.value, place, hand)


def _circle(view: ProfileView, turned: float, radius: float, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the circle through three points of the sharpest stretch, as much of it as shows how it lies."""
    spot, normal = view.at(turned)
    centre, size, turn = place.on(spot - radius * normal), place.length(radius), cmath.phase(normal)
    yield Arc(centre, size, turn - SHOWN, turn + SHOWN, fit(hand.extreme, 2 * SHOWN * size))
    near = NEARBY * (view.cam.turn / (2 * math.pi))
    for off in (-near, 0.0, near):
        at, _ = view.at((turned + off) % view.cam.turn)
        yield Circle(place.on(at), 0.5 * hand.symbol, INK)
    yield Circle(centre, 0.5 * hand.symbol, INK)


def rocking(view: ProfileView, place: Place, drafting: Drafting) -> Iterator[AngleArc]:
    """Give the initial angle of a rocker, from the line of centres to its arm: where the cam begins with S = 0."""
    if view.cam.rocks and not (view.cam.flat or view.cam.translates or view.found.contour.travel.s[0]):
        pivot, tip = place.on(view.found.sizes.pivot), place.on(complex(view.curve.tip[0]))
        start, end = cmath.phase(place.on(0j) - pivot), cmath.phase(tip - pivot)
        off = cmath.phase(cmath.rect(1.0, end - start))
        text = joined("", ("ψ_0 = ", drafting.slot(Slot("ψ_0", math.degrees(abs(off)), DIGITS)), "°"))
        yield AngleArc("ψ_0", text, TurnArrow(pivot, INITIAL * abs(tip - pivot), start, off))
