"""The rulers of the main sizes on paper: tangents with their angles, those of the chord beside (касательные)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.figures.cam.size_view import SizeView, leaning, lower
from drawings.figures.graphs.part import Letter
from drawings.layout.labels import NEAR
from drawings.layout.place import Place
from drawings.lettering.phrase import Slot, joined
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Line, Polyline, Stroke
from drawings.paper.ties import tied_spot
from drawings.symbols.dashes import fit
from drawings.symbols.hatching import hatching
from plans.cam.centre.bounds import PressureBound
from plans.cam.sizing import Tangent

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
        turns = sorted(cmath.phase(-one) % (2 * math.pi) for one in (self.line, self.way))
        yield Arc(self.corner, self.arm, turns[0], turns[1], hand.other)


def rulers(view: SizeView, place: Place, drafting: Drafting) -> tuple[tuple[Stroke, ...], tuple[Letter, ...]]:
    """Draw the tangents, each with its angle at its upper end, and the chord's thin beside them."""
    lines: list[Stroke] = []
    letters: list[Letter] = []
    taken: list[complex] = []
    for one in view.sizing.tangents:
        past, foot = (place.on(end) for end in view.ruler(one))
        style = drafting.hand.relative if one.binding else drafting.hand.other
        lines.append(Line(past, foot, style))
        angle = _angle(view, one, past, drafting.hand, taken)
        if angle is not None:
            taken.append(angle.middle)
            lines += angle.draw(drafting.hand)
            letters.append(Letter(angle.middle, _told(one, drafting), drafting.hand.number, angle.side, GAP))
        elif not view.cam.rocks:
            letters.append(Letter(past, "45°", drafting.hand.number, 0.0))
    lines += _chord(view, place, drafting.hand)
    return tuple(lines), tuple(letters)


def _angle(view: SizeView, one: Tangent, past: complex, hand: Hand, taken: Sequence[complex]) -> LimitAngle | None:
    """Give the angle of a tangent, its arc where no other one is; none of a tangent at 45 degrees."""
    way, line, arm = leaning(one, view), complex(one.direction.point), ARM * hand.letter
    if way is None:
        return None
    line *= math.copysign(1.0, line.imag) / abs(line)
    ways = (LimitAngle(past, line, way, radius) for radius in (arm, NEARER * arm))
    return max(ways, key=lambda own: min((CROWD, *(abs(own.middle - spot) for spot in taken))))


def _told(one: Tangent, drafting: Drafting) -> str:
    """Write a limit of the pressure angle."""
    assert isinstance(one.bound, PressureBound)
    sign, minus = (-1, "−") if lower(one) else (1, "")
    size = drafting.slot(Slot(f"{minus}α_{one.bound.kind}", sign * math.degrees(one.bound.angle)))
    return joined("", (minus, drafting.letter(f"α_{{{one.bound.kind}}}"), " = ", size, "°"))


def _chord(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the chord of a rocker's arc and the tangents by it, dashed, as far as they meet."""
    chord = view.sizing.chord
    if chord is None:
        return
    start, end = place.on(view.start), place.on(max((complex(one) for one in view.tips), key=lambda one: one.imag))
    yield Line(start, end, fit(hand.path, abs(end - start)))
    centre = place.on(complex(chord.centre.point))
    for one in chord.tangents:
        touched = place.on(complex(one.point.point))
        yield Line(touched, centre, fit(hand.path, abs(centre - touched)))


def region(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Hatch the region that is left to O, and draw its edge where it does not go on beyond what is shown."""
    corners = [*{tied_spot(place.on(one)): one for one in view.region}.values()]  # a sliver has no edge
    if len(corners) < 3:
        return
    yield from hatching([place.on(one) for one in corners], hand)
    for start, end in zip(corners, (*corners[1:], corners[0]), strict=True):
        if not view.ends_at(start, end):
            yield Polyline((place.on(start), place.on(end)), False, hand.drafted)
