"""The rulers of the main sizes on paper: tangents with their angles, those of the chord beside (касательные)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from drawings.figures.cam.size_view import SizeView, leaning, lower
from drawings.figures.graphs.part import Letter
from drawings.layout.place import Place
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Line, Polyline, Stroke
from drawings.symbols.dashes import fit
from drawings.symbols.hatching import hatching
from plans.cam.sizing import Tangent

ARM = 3.6  # letters: radius of the arc of an angle
OVER = 1.2  # of that: how far the line goes from which the angle is counted


def rulers(view: SizeView, place: Place, drafting: Drafting) -> tuple[tuple[Stroke, ...], tuple[Letter, ...]]:
    """Draw the tangents, each with its angle at its upper end, and the chord's thin beside them."""
    lines: list[Stroke] = []
    letters: list[Letter] = []
    for one in view.sizing.tangents:
        past, foot = (place.on(end) for end in view.ruler(one))
        style = drafting.hand.relative if one.binding else drafting.hand.other
        lines.append(Line(past, foot, style))
        lines += _angle(view, one, past, drafting.hand)
        letters += _lettered(view, one, past, drafting)
    lines += _chord(view, place, drafting.hand)
    return tuple(lines), tuple(letters)


def _angle(view: SizeView, one: Tangent, past: complex, hand: Hand) -> Iterator[Stroke]:
    """Draw the angle between a tangent and the way of K, produced beyond the tangent's upper end."""
    found = leaning(one, view)
    if found is None:
        return
    (_, way), arm = found, ARM * hand.letter
    line = complex(one.direction.point)
    line *= math.copysign(1.0, line.imag) / abs(line)
    yield Line(past, past - OVER * arm * way, hand.drafted)
    turns = sorted((cmath.phase(-line) % (2 * math.pi), cmath.phase(-way) % (2 * math.pi)))
    yield Arc(past, arm, turns[0], turns[1], hand.other)


def _lettered(view: SizeView, one: Tangent, past: complex, drafting: Drafting) -> Iterator[Letter]:
    """Letter the angle beyond its arc."""
    found = leaning(one, view)
    size, arm = drafting.hand.number, ARM * drafting.hand.letter
    if found is None:
        if not view.cam.rocks:
            yield Letter(past, "45°", size, 0.0)
        return
    angle, way = found
    line = complex(one.direction.point)
    line *= math.copysign(1.0, line.imag) / abs(line)
    middle = -(line + way) / abs(line + way)
    text = drafting.letter(f"α_{{{one.bound.kind}}}") if hasattr(one.bound, "kind") else "α"
    sign = -1 if lower(one) else 1
    told = f"{'−' if sign < 0 else ''}{text} = {drafting.number(sign * math.degrees(angle))}°"
    yield Letter(past + arm * middle, told, size, cmath.phase(middle))


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
    corners = view.region
    if len(corners) < 3:
        return
    yield from hatching([place.on(one) for one in corners], hand)
    for start, end in zip(corners, (*corners[1:], corners[0]), strict=True):
        if not view.ends_at(start, end):
            yield Polyline((place.on(start), place.on(end)), False, hand.drafted)
