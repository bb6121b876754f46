"""The hodograph of a vector over one turn: its pole, the curve of its ends, its numbered positions (годограф)."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.kinds.curve_graph import DOTTED, SPARE
from drawings.kinds.graph import stretches
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.extent import numbered
from drawings.lettering.lettering import text_width
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Polyline, Stroke, Text
from drawings.symbols.figure import Subject, heading, point, vector
from drawings.symbols.force_arrow import plain_name
from drawings.symbols.symbols import pole
from plans.model.motion import Complexes

MARGINS = Margins(2.6, 2.0, 2.0)  # paper around it for its letters, in their sizes
LETTERS = 14.0  # it is drawn at least so many of its letters large: its positions are numbered
DOT = 0.7  # mm, radius of a position's point
POLE = "o"
LEAST = 0.05  # mm: a shorter vector is a point


class Hodograph(NamedTuple):
    """A vector over a turn in true units: dense, and at the positions; one of these is shown. NaN is a gap."""

    letter: str  # marked up: "R_{34}"
    symbol: str  # of its scale: F
    unit: str
    values: Complexes
    ends: Complexes
    shown: int
    title: str = ""  # where it is not that of a reaction

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        values = np.concatenate([[0j], self.values, self.ends])
        return [complex(value) for value in values[~np.isnan(values.real)]]


def measure(shown: Hodograph, name: str, drafting: Drafting) -> Picture:
    """Measure the room of a hodograph."""
    hand = drafting.hand
    side, below, above = (size * hand.letter for size in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    heading = text_width(Text(0j, _title(shown, drafting), hand.title))
    return picture(name, shown.points, (shown.symbol, shown.unit), margins, heading, LETTERS * hand.letter)


@dataclass(frozen=True)
class HodographFigure:
    """A hodograph placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: Hodograph
    name: str
    place: Place
    lines: tuple[Stroke, ...]
    numbers: tuple[int, ...]  # the positions that bear one
    hand: Hand

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure: the pole and the shown vector lettered, the positions numbered outward."""
        hand, ends = self.hand, self.shown.ends
        letters = [labels.beside(self.place.on(0j), POLE, hand.letter, 1.6, -math.pi / 4)]
        end = complex(ends[self.shown.shown])
        if not math.isnan(end.real):
            middle = self.place.on(end / 2)
            letters.append(labels.beside(middle, self.shown.letter, hand.letter, 1.2, cmath.phase(1j * (end or 1j))))
        heart = complex(np.nanmean(ends.real), np.nanmean(ends.imag)) if not np.isnan(ends.real).all() else 0j
        for k in self.numbers:
            spot, away = self.place.on(complex(ends[k])), complex(ends[k]) - heart
            side = cmath.phase(away) if away else math.pi / 4
            letters.append(labels.beside(spot, str(k), hand.number, 1.2, side))
        return (Group((*self.lines, Group(tuple(letters))), self.name),)


def draw(shown: Hodograph, room: Picture, spot: Spot, drafting: Drafting) -> HodographFigure:
    """Draw the hodograph in its spot, with its title and its written scale above it."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, _title(shown, drafting), drafting.scale(spot.scale), hand)
    lines: list[Stroke] = [title, *_curve(shown, place, hand)]
    end = complex(shown.ends[shown.shown])
    subject = Subject(room.name, shown.symbol, shown.shown)
    if not math.isnan(end.real) and place.length(abs(end)) > LEAST:
        lines.append(vector(subject, plain_name(shown.letter), (0j, end), place, hand.relative, hand.symbol))
    every = subject._replace(position=None)
    lines.append(point(every, POLE, 0j, place, pole(place.on(0j)), "pole"))
    numbers, points = _told(shown, place, hand)
    for k in points:
        value = complex(shown.ends[k])
        dot = Circle(place.on(value), DOT * hand.symbol, INK)
        lines.append(point(subject._replace(position=k), str(k), value, place, dot) if k in numbers else dot)
    return HodographFigure(shown, room.name, place, tuple(lines), numbers, hand)


def _told(shown: Hodograph, place: Place, hand: Hand) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Choose the positions that bear their numbers, and those that have their points: as many as have room."""
    spots = [place.on(complex(value)) for value in shown.ends]
    length = sum(_length([place.on(complex(shown.values[k])) for k in run]) for run in stretches(shown.values.real))
    wide = text_width(Text(0j, str(len(spots) - 1), hand.number))
    numbers = numbered(spots, length, wide + SPARE * hand.number, (shown.shown,))
    return numbers, numbered(spots, length, DOTTED * DOT * hand.symbol, numbers)


def _length(places: list[complex]) -> float:
    return float(np.abs(np.diff(places)).sum())


def _title(shown: Hodograph, drafting: Drafting) -> str:
    return shown.title or drafting.word("hodograph", letter=shown.letter)


def _curve(shown: Hodograph, place: Place, hand: Hand) -> list[Stroke]:
    """Draw the curve of the ends: closed where it has no gap."""
    runs = list(stretches(shown.values.real))
    whole = len(runs) == 1 and len(runs[0]) == len(shown.values)
    return [Polyline(tuple(place.on(complex(shown.values[k])) for k in run), whole, hand.result) for run in runs]
