"""The figure of the main sizes: S over S' with its tangents, the region hatched, O, R0, e, L (figures 5.49-5.51)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.figures.cam.size_rulers import rulers
from drawings.figures.cam.size_view import NAME, QUANTITY, SizeView, direction
from drawings.figures.graphs.axes import arrow
from drawings.figures.graphs.part import Letter
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.place import Place
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Group, Line, Polyline, Stroke, Text
from drawings.symbols.dashes import fit
from drawings.symbols.dimension import Dimension
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.hatching import hatching
from drawings.symbols.symbols import HINGE, TICK, hinge, pole

MARGINS = Margins(3.4, 3.0, 2.0)  # paper around it for letters, in their sizes
LETTERS, MOST = 22.0, 44.0  # it is drawn at least so many letters large, and at most
AXIS = 8.0  # mm that an axis goes past what is drawn on it
DOT, TOUCH = 0.6, 1.1  # mm, radius of a numbered point, and of one that a ruler touches
APART = 1.5  # sizes of a number from one numbered point to the next
BESIDE = 1.0  # mm
OFF = 2.6  # letters from the drawing to a dimension
LEAST = 3.0  # mm: a shorter distance is told by the table alone
SUBJECT = Subject(NAME, QUANTITY, None)


@dataclass(frozen=True)
class SizeFigure:
    """The diagram placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    view: SizeView
    place: Place
    lines: tuple[Stroke, ...]
    letters: tuple[Letter, ...]
    sizes: tuple[Dimension, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, its points numbered, its sizes and angles lettered."""
        hand = self.drafting.hand
        sizes = [
            labels.along(*one.lines[0], one.letter, hand.number, BESIDE, cmath.phase(one.off)) for one in self.sizes
        ]
        ranked = sorted(self.letters, key=lambda one: -one.size)
        letters = [labels.beside(one.at, one.text, one.size, one.gap, one.side) for one in ranked]
        return (Group((*self.lines, Group((*sizes, *letters))), NAME),)


def measure(view: SizeView, drafting: Drafting) -> Picture:
    """Measure the room that the diagram needs: its points, the tangents, the region below O."""
    hand = drafting.hand
    title = text_width(Text(0j, _title(view, drafting), hand.title))
    side, below, above = (share * hand.letter for share in MARGINS)
    margins = Margins(side + AXIS, below, above + AXIS + 2 * hand.title + hand.text)
    corners = [*view.box, *(end for one in view.sizing.tangents for end in view.ruler(one))]
    found = picture(NAME, corners, ("l", "m"), margins, title, LETTERS * hand.letter)
    return found._replace(most=MOST * hand.letter)


def draw(view: SizeView, room: Picture, spot: Spot, drafting: Drafting) -> SizeFigure:
    """Draw the diagram in its spot: region and construction thin, the curve thick, rulers between, O over all."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, _title(view, drafting), drafting.scale(spot.scale), hand)
    drawn, angles = rulers(view, place, drafting)
    sizes = tuple(_sizes(view, place, drafting))
    lines = (
        title,
        *(hatching([place.on(one) for one in view.region], hand) if len(view.region) > 2 else ()),
        *_axes(view, place, hand),
        *_construction(view, place, hand),
        *_curves(view, place, hand),
        *drawn,
        *(stroke for one in sizes for stroke in one.draw(hand)),
        *_lengths(view, place, hand),
        *_points(view, place, hand),
    )
    letters = (*angles, *_letters(view, place, drafting), *_numbers(view, place, hand))
    return SizeFigure(view, place, lines, letters, sizes, drafting)


def _title(view: SizeView, drafting: Drafting) -> str:
    kind = "flat" if view.cam.flat else view.cam.follower.motion
    return drafting.word(f"cam sizes by {kind}")


def _axes(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the axes of S and S' through A; of a rocker the arc on which S is laid off, and its pivot's level."""
    low, high = (place.on(one) for one in view.box)
    zero = place.on(0j)
    if not view.cam.rocks:
        yield from arrow(
            complex(zero.real, min(place.on(view.centre).imag, zero.imag)), zero.real + 1j * (high.imag + AXIS), hand
        )
        yield from arrow(complex(low.real - AXIS / 2, zero.imag), complex(high.real + AXIS, zero.imag), hand)
        return
    radius = place.length(view.cam.follower.length or abs(view.centre))
    if len(view.tips):
        ends = sorted(cmath.phase(place.on(one) - zero) % (2 * math.pi) for one in (view.tips[0], _top(view)))
        start, end = ends if ends[1] - ends[0] < math.pi else ends[::-1]
        yield Arc(zero, radius, start, end, hand.other)
        for one in (view.start, _top(view)):
            yield Line(zero, place.on(one), hand.other)
    else:
        away = cmath.phase(view.centre)
        yield Arc(zero, place.length(abs(view.centre)), away - 0.25, away + 0.25, hand.drafted)


def _top(view: SizeView) -> complex:
    """Give K where the follower is highest."""
    return max(view.tips.tolist(), key=lambda one: one.imag)


def _construction(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw K with its tick, and KD."""
    for tip, end in zip(view.tips.tolist(), view.ends.tolist(), strict=True):
        one, other = place.on(tip), place.on(end)
        if abs(other - one) > LEAST / 10:
            yield Line(one, other, hand.drafted)
        across = tip / abs(tip) if view.cam.rocks else 1.0
        yield Line(one - TICK * hand.symbol * across, one + TICK * hand.symbol * across, hand.drafted)


def _curves(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    for curve in view.curves:
        yield Polyline(tuple(place.on(one) for one in curve.tolist()), False, hand.result)


def _points(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the points that can be measured: D of each position, where rulers touch, A or O1, O."""
    for k, end in enumerate(view.ends.tolist()):
        yield point(SUBJECT._replace(position=k), "D", end, place, Circle(place.on(end), DOT * hand.symbol, INK))
    for one in view.sizing.tangents:
        if not (view.cam.flat and view.cam.rocks):
            spot = complex(one.point.point)
            yield point(SUBJECT, one.point.name, spot, place, Circle(place.on(spot), TOUCH * hand.symbol, hand.body))
    chord = view.sizing.chord
    if chord is not None:
        spot = complex(chord.centre.point)
        yield point(SUBJECT, "O'", spot, place, Circle(place.on(spot), TOUCH * hand.symbol, hand.body))
    zero = hinge(place.on(0j), hand)[0] if view.cam.rocks else pole(place.on(0j))
    yield point(SUBJECT, "O_1" if view.cam.rocks else "A", 0j, place, zero, "pole")
    yield point(SUBJECT, "O", view.centre, place, hinge(place.on(view.centre), hand)[0])


def _lengths(view: SizeView, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw R0 from O, and L of a rocker, as vectors that can be measured."""
    centre = place.on(view.centre)
    ends = [] if view.cam.flat else [("R_0", view.start)]
    ends += [("L", 0j)] if view.cam.rocks else []
    for name, end in ends:
        style = hand.relative if name == "R_0" else fit(hand.axis, abs(place.on(end) - centre))
        data = SUBJECT.data("vector", name, end - view.centre, place.scale)
        yield Group((Line(centre, place.on(end), style),), "", data, name)


def _sizes(view: SizeView, place: Place, drafting: Drafting) -> Iterator[Dimension]:
    """Dimension e below O and S0 beside the axis of S; under a flat face R0 and the least radius of curvature."""
    if view.cam.rocks:
        return
    centre, zero, off = place.on(view.centre), place.on(0j), OFF * drafting.hand.letter
    foot = complex(zero.real, centre.imag)
    left = -view.cam.sense
    if view.bent:
        yield from _long("R_0", view.sizing.sizes.base, zero, centre, off + 0j, drafting)
        cut = complex(view.sizing.board["B"].point)
        yield from _long("ρ_{min}", abs(view.centre - cut), place.on(cut), centre, -off + 0j, drafting)
        return
    level = abs(view.centre.imag)
    side = left * (1 if view.sizing.sizes.offset < 0 else -1)
    yield from _long("S_0", level, foot, zero, side * off + 0j, drafting)
    yield from _long("e", abs(view.sizing.sizes.offset), centre, foot, -1j * off, drafting)


def _long(
    letter: str, size: float, start: complex, end: complex, off: complex, drafting: Drafting
) -> Iterator[Dimension]:
    if abs(end - start) >= LEAST:
        yield Dimension(f"{letter} = {drafting.number(1000 * size)}", start, end, off)


def _letters(view: SizeView, place: Place, drafting: Drafting) -> Iterator[Letter]:
    """Letter A or O1, O, the axes, R0 and L."""
    size, number, low = drafting.hand.letter, drafting.hand.number, -math.pi / 2
    gap = BESIDE + HINGE * drafting.hand.symbol
    zero, centre = place.on(0j), place.on(view.centre)
    yield Letter(centre, "O", size, -math.pi / 4, gap)
    yield Letter(zero, "O_1" if view.cam.rocks else "A", size, -math.pi / 4, gap if view.cam.rocks else BESIDE)
    if view.sizing.chord is not None:
        yield Letter(place.on(complex(view.sizing.chord.centre.point)), "O'", size, 0.0, BESIDE + TOUCH)
    if view.cam.rocks:
        lengths = [("L", 0j, view.sizing.sizes.centre)]
        lengths += [] if view.cam.flat else [("R_0", view.start, view.sizing.sizes.base)]
    else:
        box = place.on(view.box[1])
        yield Letter(complex(zero.real, box.imag + AXIS), "S", size, 0.0)
        yield Letter(complex(box.real + AXIS, zero.imag), "S''" if view.bent else "S'", size, math.pi / 2)
        lengths = [] if view.bent else [("R_0", 0j, view.sizing.sizes.base)]
    for letter, end, true in lengths:
        spot = (centre + place.on(end)) / 2
        side = direction(centre, place.on(end)) + (math.pi / 2 if letter == "R_0" else low)
        yield Letter(spot, f"{letter} = {drafting.number(1000 * true)}", number, side)


def _numbers(view: SizeView, place: Place, hand: Hand) -> Iterator[Letter]:
    """Number the points of the diagram outward, those that have room."""
    kept: list[complex] = []
    for k, (tip, end) in enumerate(zip(view.tips.tolist(), view.ends.tolist(), strict=True)):
        spot = place.on(end)
        if abs(end - tip) and all(abs(spot - other) >= APART * hand.number for other in kept):
            kept.append(spot)
            yield Letter(spot, str(k), hand.number, direction(tip, end), BESIDE)
