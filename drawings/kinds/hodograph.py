"""The hodograph of a vector over one turn: its pole, the curve of its ends, its numbered positions (годограф)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import Letter, Part
from drawings.kinds.curve_graph import DOTTED, SPARE
from drawings.kinds.graph import DOT, LEAST, dashed, leaps, stretches
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import TOGETHER, coinciding, numbered, text_width
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Polyline, Stroke, Text
from drawings.symbols.figure import Subject, around, heading, plain_name, point, vector
from drawings.symbols.symbols import pole
from plans.model.motion import Complexes

MARGINS = Margins(2.6, 2.0, 2.0)  # paper around it for its letters, in their sizes
LETTERS = 14.0  # it is drawn at least so many of its letters large: its positions are numbered
POLE = "o"


class Hodograph(NamedTuple):
    """A vector over a turn in true units: dense, and at the positions; one of these is shown. NaN is a gap."""

    letter: str  # marked up: "R_{34}"
    symbol: str  # of its scale: F
    unit: str
    values: Complexes
    ends: Complexes
    shown: int
    name: str = ""  # of the figure
    title: str = ""  # where it is not that of a reaction
    step: int = 1  # from one number of its positions to the next: 1, or the crank's angle in degrees

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        values = np.concatenate([[0j], self.values, self.ends])
        return [complex(value) for value in values[~np.isnan(values.real)]]


def measure(shown: Hodograph, drafting: Drafting) -> Picture:
    """Measure the room of a hodograph."""
    scale, title = (shown.symbol, shown.unit), _title(shown, drafting)
    return room_of(shown.name, shown.points, scale, title, LETTERS, drafting.hand)


def room_of(
    name: str, points: Sequence[complex], scale: tuple[str, str], title: str, letters: float, hand: Hand
) -> Picture:
    """Measure the room of hodographs about one pole that are drawn at least so many of their letters large."""
    wide = text_width(Text(0j, title, hand.title))
    return picture(name, points, scale, around(MARGINS, hand), wide, letters * hand.letter)


def draw(shown: Hodograph, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw the hodograph in its spot, with its title and its written scale above it."""
    place, hand = room.place(*spot), drafting.hand
    subject = Subject(room.name, shown.symbol, shown.shown)
    end = complex(shown.ends[shown.shown])
    numbers, points = _lettered(shown, place, hand)
    lines = (
        heading(spot.box, _title(shown, drafting), drafting.scale(spot.scale), hand),
        *_curve(shown, place, hand),
        *arrow(subject, plain_name(shown.letter), end, place, hand),
        pole_of(subject, place),
        *(_point(shown, k, k in numbers, subject, place, hand) for k in points),
    )
    named = () if math.isnan(end.real) else (letter_beside(shown.letter, end, place, hand),)
    told = outward(shown.ends, numbers, place, hand, shown.step)
    return Part(room.name, lines, (pole_letter(place, hand), *named, *told))


def arrow(subject: Subject, name: str, end: complex, place: Place, hand: Hand) -> Iterator[Group]:
    """Draw the vector that is shown, unless it is a gap or a point on paper."""
    if place.length(abs(end)) > LEAST:
        yield vector(subject, name, (0j, end), place, hand.relative, hand.symbol)


def pole_of(subject: Subject, place: Place) -> Group:
    """Draw the pole."""
    return point(subject._replace(position=None), POLE, 0j, place, pole(place.on(0j)), "pole")


def pole_letter(place: Place, hand: Hand) -> Letter:
    """Letter the pole."""
    return Letter(place.on(0j), POLE, hand.letter, -math.pi / 4, 1.6)


def letter_beside(letter: str, end: complex, place: Place, hand: Hand) -> Letter:
    """Letter the vector that is shown beside its middle."""
    return Letter(place.on(end / 2), letter, hand.letter, cmath.phase(1j * (end or 1j)))


def outward(ends: Complexes, numbers: Iterable[int], place: Place, hand: Hand, step: int = 1) -> Iterator[Letter]:
    """Number positions outward from the middle of all; those whose ends fall together have one number, of them all."""
    heart = complex(np.nanmean(ends.real), np.nanmean(ends.imag)) if not np.isnan(ends.real).all() else 0j
    told = sorted(numbers)
    for group in coinciding([place.on(complex(ends[k])) for k in told], TOGETHER * hand.number):
        name, end = ", ".join(str(told[k] * step) for k in group), complex(ends[told[group[0]]])
        yield Letter(place.on(end), name, hand.number, cmath.phase(end - heart) if end != heart else math.pi / 4)


def _point(shown: Hodograph, k: int, lettered: bool, subject: Subject, place: Place, hand: Hand) -> Stroke:
    """Mark the end at a position; one that is numbered can be measured."""
    value = complex(shown.ends[k])
    dot = Circle(place.on(value), DOT * hand.symbol, INK)
    return point(subject._replace(position=k), str(k * shown.step), value, place, dot) if lettered else dot


def _lettered(shown: Hodograph, place: Place, hand: Hand) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Choose the positions that bear their numbers, and those that have their points: as many as have room."""
    spots = [place.on(complex(value)) for value in shown.ends]
    runs = ([place.on(complex(shown.values[k])) for k in run] for run in stretches(shown.values.real))
    length = sum(float(np.abs(np.diff(run)).sum()) for run in runs)
    wide = text_width(Text(0j, str(shown.step * (len(spots) - 1)), hand.number))
    numbers = numbered(spots, length, wide + SPARE * hand.number, (shown.shown,))
    return numbers, numbered(spots, length, DOTTED * DOT * hand.symbol, numbers)


def _title(shown: Hodograph, drafting: Drafting) -> str:
    return shown.title or drafting.word("hodograph", letter=shown.letter)


def _curve(shown: Hodograph, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the curve of the ends: closed where it has no gap, dashed where it jumps."""
    jumps = leaps(shown.values)
    runs = list(stretches(shown.values.real, jumps))
    whole = len(runs) == 1 and len(runs[0]) == len(shown.values)
    places = [place.on(complex(value)) for value in shown.values]
    curves = (Polyline(tuple(places[k] for k in run), whole, hand.result) for run in runs)
    return [*curves, *dashed(places, jumps, hand)]
