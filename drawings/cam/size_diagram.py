"""The figure of the main sizes: S over S' with its tangents, the region hatched, O, R0, e, L (figures 5.49-5.51)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import TypeAlias

import numpy as np

from drawings.cam.size_marks import offset_seen, region, rulers
from drawings.cam.size_view import NAME, QUANTITY, SizeView
from drawings.kinds.axes import Letter, arrow, placed
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import spaced, text_width
from drawings.lettering.words import Phrase, Slot, joined, telling
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Group, Kind, Line, Polyline, Statement, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.figure import Dimension, Subject, around, explained, heading, point
from drawings.symbols.symbols import HINGE, TICK, fit, hinge, pole
from plans.cam.centre.place import SizeTangent
from plans.model.cam import MM

MARGINS = Margins(3.4, 4.6, 2.0)  # paper around it for letters, in their sizes
LETTERS, MOST = 22.0, 64.0  # it is drawn at least so many letters large, and at most
AXIS = 8.0  # mm that an axis goes past what is drawn on it
DOT, TOUCH = 0.6, 1.1  # mm, radius of a numbered point, and of one that a ruler touches
APART = 1.5  # sizes of a number from one numbered point to the next
BESIDE = 1.0  # mm
OFF, OFF_BELOW = 2.6, 1.4  # letters from the drawing to a dimension; from the region to that of e
LEAST = 3.0  # mm: a shorter distance, but e, is told by the table alone
SHOWN = 0.25  # rad to either side of O: of the arc of L
SUBJECT = Subject(NAME, QUANTITY, None)


def measure(view: SizeView, drafting: Drafting) -> Picture:
    """Measure the room that the diagram needs: its points, the tangents, the region below O."""
    hand = drafting.hand
    title = text_width(Text(0j, _title(view, drafting), hand.title))
    margins = around(MARGINS, hand, AXIS, above=AXIS)
    corners = [*view.box, *(end for tangent in view.sizing.tangents for end in view.ruler(tangent))]
    found = picture(NAME, corners, ("l", "m"), margins, title, LETTERS * hand.letter)
    return explained(found._replace(most=MOST * hand.letter), _lines(view, drafting), hand)


def draw(view: SizeView, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the diagram in its spot: region and construction thin, the curve thick, rulers between, O over all."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, _title(view, drafting), drafting.scale(spot.scale), hand, *_lines(view, drafting))
    drawn, angles = rulers(view, place, drafting)
    sizes = tuple(_sizes(view, place, drafting))
    lines = (
        title,
        *region(view, place, hand),
        *_axes(view, place, hand),
        *_construction(view, place, hand),
        *_curves(view, place, hand),
        *drawn,
        *(stroke for size in sizes for stroke in size.draw(hand)),
        *_lengths(view, place, drafting),
        *_points(view, place, hand),
    )
    letters = (*angles, *_letters(view, place, drafting), *_numbers(view, place, hand))
    return LetteredFigure(NAME, lines, partial(_lettered, sizes, letters, hand))


def _lettered(sizes: Sequence[Dimension], letters: Sequence[Letter], hand: Hand, labels: Labels) -> Iterator[Stroke]:
    """Letter the sizes along their lines, then points and angles, those of small numbers last."""
    for size in sizes:
        yield telling(NAME, labels.along(*size.lines[0], size.letter, hand.number, BESIDE, cmath.phase(size.off)))
    yield from placed(NAME, letters, labels)


def _title(view: SizeView, drafting: Drafting) -> str:
    kind = "flat" if view.cam.flat else view.cam.follower.motion
    return drafting.word(f"cam sizes by {kind}")


def _lines(view: SizeView, drafting: Drafting) -> list[str]:
    """Say what stands dashed where the arc of a rocker's end is replaced by its chord."""
    return drafting.word("cam chord").split("\n") if view.sizing.chord else []


def _axes(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the axes of S and S' through A; of a rocker what S is laid off along."""
    if view.cam.rocks:
        yield from _beside_face(view, place, hand) if view.faced else _arc(view, place, hand)
        return
    low, high, zero = (place.on(corner) for corner in (*view.box, 0j))
    foot = complex(zero.real, min(place.on(view.centre).imag, zero.imag))
    yield from arrow(foot, complex(zero.real, high.imag + AXIS), hand)
    yield from arrow(complex(low.real - AXIS / 2, zero.imag), complex(high.real + AXIS, zero.imag), hand)


def _arc(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the arc of a rocker's end, and the arm at both ends of it."""
    zero = place.on(0j)
    start, end = (place.on(tip) - zero for tip in (view.start, _top(view)))
    low, high = (start, end) if view.cam.rising > 0 else (end, start)
    yield Arc(zero, abs(start), cmath.phase(low), cmath.phase(high), hand.other)
    for arm in (start, end):
        yield Line(zero, zero + arm, hand.other)


def _beside_face(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw a piece of the arc of L, and the face of a rocker at the start."""
    away = cmath.phase(view.centre)
    yield Arc(place.on(0j), place.length(abs(view.centre)), away - SHOWN, away + SHOWN, hand.drafted)
    root, end, _ = (place.on(spot) for spot in view.face)
    yield Line(root, end, hand.result)


def _top(view: SizeView) -> complex:
    """Give K where the follower is highest."""
    return max((complex(tip) for tip in view.tips), key=lambda spot: spot.imag)


def _construction(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw K with its tick, and KD."""
    for tip, end in zip(view.tips.tolist(), view.ends.tolist(), strict=True):
        start, other = place.on(tip), place.on(end)
        if abs(other - start) > LEAST / 10:
            yield Line(start, other, hand.drafted)
        across = tip / abs(tip) if view.cam.rocks else 1 + 0j
        yield Line(start - TICK * hand.symbol * across, start + TICK * hand.symbol * across, hand.drafted)


def _curves(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    curves = (Polyline(tuple(place.on(spot) for spot in curve.tolist()), False, hand.result) for curve in view.curves)
    yield from (stating(Statement(Kind.CURVE, NAME, "D"), *curves),) if view.curves else ()


def _points(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the points that can be measured: D of each position, where rulers touch, A or O1, O."""
    numbered = _numbered(view, place, hand)
    for k, end in enumerate(view.ends.tolist()):
        dot = Circle(place.on(end), DOT * hand.symbol, INK)
        subject = SUBJECT._replace(position=k)
        yield point(subject, "D", end, place, dot, title=str(k)) if k in numbered else dot
    for tangent in _touched(view, place):
        spot = complex(tangent.point.point)
        yield point(SUBJECT, tangent.point.name, spot, place, Circle(place.on(spot), TOUCH * hand.symbol, hand.body))
    chord = view.sizing.chord
    if chord is not None:
        spot = complex(chord.centre.point)
        yield point(SUBJECT, "O'", spot, place, Circle(place.on(spot), TOUCH * hand.symbol, hand.body))
    zero = hinge(place.on(0j), hand)[0] if view.cam.rocks else pole(place.on(0j))
    yield point(SUBJECT, "O_1" if view.cam.rocks else "A", 0j, place, zero, "pole")
    yield point(SUBJECT, "O", view.centre, place, hinge(place.on(view.centre), hand)[0])


def _lengths(view: SizeView, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Draw R0 from O, and L of a rocker, as vectors that can be measured."""
    centre, hand = place.on(view.centre), drafting.hand
    for name, end, text in _reaches(view, drafting):
        style = hand.relative if name == "R_0" else fit(hand.axis, abs(place.on(end) - centre))
        data = SUBJECT.data("vector", name, end - view.centre, place.scale)
        yield Group((Line(centre, place.on(end), style),), "", data, text)


def _reaches(view: SizeView, drafting: Drafting) -> Iterator[tuple[str, complex, str]]:
    """Give what reaches from O: its name, its end, its letter with the value."""
    sizes = view.sizing.sizes
    if not view.bent:
        end = view.face[2] if view.faced else view.start
        yield "R_0", end, _equation("R_0", sizes.base, drafting)
    if view.cam.rocks:
        yield "L", 0j, _equation("L", sizes.centre, drafting)


def _sizes(view: SizeView, place: Place, drafting: Drafting) -> Iterator[Dimension]:
    """Dimension e below O and S0 beside the axis of S; under a flat face R0, the least radius, h of a rocker."""
    centre, zero, off = place.on(view.centre), place.on(0j), OFF * drafting.hand.letter
    if view.cam.rocks:
        if view.faced and view.cam.follower.face:
            root, end, _ = (place.on(spot) for spot in view.face)
            back = (root - end) / abs(root - end) * off
            yield _dimension("h", view.cam.follower.face, (zero, root), back, place, drafting)
        return
    foot = complex(zero.real, centre.imag)
    left = -view.cam.sense
    if view.bent:
        yield from _long("R_0", view.sizing.sizes.base, (zero, centre), off + 0j, place, drafting)
        cut = complex(view.sizing.board["B"].point)
        yield from _long("ρ_{min}", (cut - view.centre).imag, (place.on(cut), centre), -off + 0j, place, drafting)
        return
    level = abs(view.centre.imag)
    side = left * (1 if view.sizing.sizes.offset < 0 else -1)
    yield from _long("S_0", level, (foot, zero), side * off + 0j, place, drafting)
    below = OFF_BELOW * drafting.hand.letter + place.length(view.centre.imag - view.box[0].imag)
    sizes = view.sizing.sizes
    if offset_seen(sizes):
        yield _dimension("e", sizes.offset, (centre, foot), -1j * below, place, drafting)


Ends: TypeAlias = tuple[complex, complex]


def _long(letter: str, size: float, ends: Ends, off: complex, place: Place, drafting: Drafting) -> Iterator[Dimension]:
    if abs(ends[1] - ends[0]) >= LEAST:
        yield _dimension(letter, size, ends, off, place, drafting)


def _dimension(letter: str, size: float, ends: Ends, off: complex, place: Place, drafting: Drafting) -> Dimension:
    said = Statement(Kind.LENGTH, NAME, letter, scale=place.scale.mu)
    return Dimension(_equation(letter, size, drafting), *ends, off, said)


def _equation(letter: str, size: float, drafting: Drafting) -> Phrase:
    return joined(" = ", (letter, drafting.slot(Slot(letter, MM * size))))


def _letters(view: SizeView, place: Place, drafting: Drafting) -> Iterator[Letter]:
    """Letter A or O1, O, the axes, R0 and L."""
    size, number = drafting.hand.letter, drafting.hand.number
    gap = BESIDE + HINGE * drafting.hand.symbol
    zero, centre = place.on(0j), place.on(view.centre)
    chord = view.sizing.chord
    beside = complex(1, -1) if chord is None else view.centre - complex(chord.centre.point)
    yield Letter(centre, "O", size, cmath.phase(beside), gap)
    yield Letter(zero, "O_1" if view.cam.rocks else "A", size, -math.pi / 4, gap if view.cam.rocks else BESIDE)
    if chord is not None:
        yield Letter(place.on(complex(chord.centre.point)), "O'", size, cmath.phase(-beside), BESIDE + TOUCH)
    yield from _arm(view, place, drafting) if view.cam.rocks else _named(view, place, drafting)
    for name, end, text in _reaches(view, drafting):
        side = cmath.phase(place.on(end) - centre) + (math.pi / 2 if name == "R_0" else -math.pi / 2)
        yield Letter((centre + place.on(end)) / 2, text, number, side)


def _named(view: SizeView, place: Place, drafting: Drafting) -> Iterator[Letter]:
    """Name the axes at their ends."""
    size, zero, high = drafting.hand.letter, place.on(0j), place.on(view.box[1])
    yield Letter(complex(zero.real, high.imag + AXIS), "S", size, 0.0)
    yield Letter(complex(high.real + AXIS, zero.imag), "S''" if view.bent else "S'", size, math.pi / 2)


def _arm(view: SizeView, place: Place, drafting: Drafting) -> Iterator[Letter]:
    """Letter the start of the rocker's arc, and its arm."""
    if len(view.tips):
        hand, text = drafting.hand, _equation("l", abs(view.start), drafting)
        yield Letter(place.on(view.start), "A", hand.letter, math.pi / 2 * (1 - view.cam.rising), BESIDE)
        yield Letter((place.on(0j) + place.on(_top(view))) / 2, text, hand.number, math.pi / 2)


def _numbers(view: SizeView, place: Place, hand: Hand) -> Iterator[Letter]:
    """Number the points of the diagram outward, and letter those that rulers touch."""
    for k in _numbered(view, place, hand):
        side = cmath.phase(complex(view.ends[k] - view.tips[k]))
        yield Letter(place.on(complex(view.ends[k])), str(k), hand.number, side, BESIDE)
    for tangent in _touched(view, place):
        spot = complex(tangent.point.point)
        yield Letter(place.on(spot), tangent.point.name, hand.number, cmath.phase(spot - view.centre), BESIDE + TOUCH)


def _numbered(view: SizeView, place: Place, hand: Hand) -> tuple[int, ...]:
    """Give the positions whose numbers have room."""
    moved = [k for k, apart in enumerate(np.abs(view.ends - view.tips).tolist()) if tied(place.length(apart))]
    return spaced([place.on(end) for end in view.ends.tolist()], APART * hand.number, moved)


def _touched(view: SizeView, place: Place) -> Iterator[SizeTangent]:
    """Give the tangents that touch the diagram elsewhere than at A; of a rocker all."""
    for tangent in () if view.faced else view.sizing.tangents:
        if view.cam.rocks or place.length(abs(complex(tangent.point.point))) >= LEAST:
            yield tangent
