"""The rectangular chart of a cyclogram: a bar a stretch, a row a mechanism (прямоугольная циклограмма)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from drawings.cyclogram import course
from drawings.cyclogram.course import Stretch, stretches
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_reach, text_width
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Stroke, Text
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.figure import Subject, heading
from drawings.symbols.symbols import TICK, arrowhead
from plans.model.cyclogram import TURN, Row, within


def width(rows: Sequence[Row], drafting: Drafting, clear: float) -> float:
    """Give the width, mm, of a column that bears the names, clear of its sides: in two lines what has two words."""
    names = [course.name(row, drafting) for row in rows]
    lines = (one for name in names for one in min(_ways(name), key=lambda way: max(map(len, way))))
    return max(_reach(one, drafting) for one in lines) + 2 * clear


def lines(row: Row, room: complex, step: float, drafting: Drafting) -> tuple[str, ...]:
    """Give the lines of a name in a room, mm wide and high, at a step in sizes of letters; none, if there is none."""
    found = broken(course.name(row, drafting), room.real, lambda text: _reach(text, drafting))
    high = (step * (len(found) - 1) + 1) * drafting.hand.number
    return found if high <= room.imag else ()


def broken(text: str, room: float, wide: Callable[[str], float]) -> tuple[str, ...]:
    """Break a name into two lines at most that have room, as even as may be; nothing if they have none.

    >>> broken("auxiliary mechanism", 12, len), broken("tool", 12, len), broken("mechanism", 8, len)
    (('auxiliary', 'mechanism'), ('tool',), ())
    """
    one, *others = _ways(text)
    best = one if wide(text) <= room else min(others, key=lambda way: max(map(wide, way)), default=one)
    return best if max(map(wide, best)) <= room else ()


def _ways(text: str) -> list[tuple[str, ...]]:
    """Give the ways to break a text, in one line first."""
    parts = text.split(" ")
    return [(text,), *((" ".join(parts[:k]), " ".join(parts[k:])) for k in range(1, len(parts)))]


def _reach(text: str, drafting: Drafting) -> float:
    return text_width(Text(0j, text, drafting.hand.number, "middle", True))


NAME, TITLE = "bars", "cyclogram bars"
ROWS, SETTING = "rows", "set."  # the group of its bars; the names of setting angles begin so
SYMBOL, UNIT = "φ", "rad"
# In radians of the abscissa: a row, where in it the course runs, a level of setting angles.
ROW, LOW, HIGH, LEVEL = 0.46, 0.04, 0.11, 0.2
NAMES = 1.45  # of the turn: the column of names stands left of the rows
MARGINS = Margins(1.85, 2.0, 3.2)  # paper around it in sizes of its letters
LARGER = 2.1  # times as large it is drawn at most: from one standard scale to the next is twice
DEGREES = 30  # from one tick of the abscissa to the next
TOLD = (DEGREES, 2 * DEGREES)  # from one number of it to the next, as the scale has room for them
BESIDE = 0.8  # mm from a line to its letters
OVER = 1.6  # mm from the upper end of a course to its letters
STEP = 1.7  # sizes of the letters from line to line
PAST = 3.0  # mm that the abscissa goes past the turn


class Chart(NamedTuple):
    """What the bar chart shows: its rows, and the numbered positions of the main shaft, if there are any."""

    rows: tuple[Row, ...]
    numbered: tuple[float, ...] = ()
    begin: float = 0.0  # turn of the main shaft where the abscissa begins

    @property
    def settings(self) -> tuple[Row, ...]:
        """The rows with a setting angle."""
        return tuple(row for row in self.rows if row.setting)

    @property
    def bottom(self) -> float:
        """The ordinate of the abscissa."""
        return -ROW * len(self.rows)

    def at(self, turned: float) -> float:
        """Give the abscissa of a turn of the main shaft, from 0 to less than a whole turn."""
        return within(turned - self.begin)


@dataclass(frozen=True)
class BarFigure:
    """The chart placed on paper: its lines, and the letters still to be placed."""

    chart: Chart
    place: Place
    lines: tuple[Group, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole chart, what is too long for its bar lettered beside it."""
        letters = (*self._numbers(labels), *self._long(labels), *self._names(labels))
        return *self.lines, *([Group(letters, f"{NAME}-letters")] if letters else [])

    def _numbers(self, labels: Labels) -> Iterator[Stroke]:
        ends = [self.chart.at(turned) for turned in self.chart.numbered]
        again = [(0, TURN)] if 0.0 in ends[:1] else []  # the turn ends where it begins
        for number, x in (*enumerate(ends), *again):
            spot = self.place.on(complex(x)) + 1j * TICK
            yield labels.beside(spot, str(number), self.drafting.hand.number, BESIDE, math.pi / 2)

    def _long(self, labels: Labels) -> Iterator[Stroke]:
        for _, foot, one in _all(self.chart):
            if not _told(one, self.place, self.drafting):
                spot = complex((one.start + one.end) / 2, foot + (_level(one.low) + _level(one.high)) / 2)
                text, size = course.doing(one.span, self.drafting), self.drafting.hand.number
                yield labels.beside(self.place.on(spot), text, size, BESIDE, math.pi / 2)

    def _names(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the rows whose names have no room in their column."""
        size = self.drafting.hand.number
        for k, row in enumerate(self.chart.rows):
            if not _named(row, self.place, self.drafting):
                spot = self.place.on(complex(-NAMES, -ROW * (k + 0.5)))
                yield labels.beside(spot, course.name(row, self.drafting), size, BESIDE, math.pi)


def measure(chart: Chart, drafting: Drafting) -> Picture:
    """Measure the room that it needs."""
    hand = drafting.hand
    side, below, above = (share * hand.letter for share in MARGINS)
    low = chart.bottom - LEVEL * len(chart.settings)
    corners = (complex(-NAMES, low), complex(TURN, 0.0))
    title = text_width(Text(0j, drafting.word(TITLE), hand.title))
    least = (TURN + NAMES) * max(width(chart.rows, drafting, BESIDE) / NAMES, _written(hand) / (ROW - HIGH))
    margins = Margins(side, below + 2 * hand.number, above + 2 * hand.title + hand.text)
    room = picture(NAME, corners, (SYMBOL, UNIT), margins, title, least)
    return room._replace(most=LARGER * least)


def draw(chart: Chart, room: Picture, spot: Spot, drafting: Drafting) -> BarFigure:
    """Draw it in its spot: heading, rows, abscissa, setting angles."""
    hand = drafting.hand
    place = _beside(room.place(*spot), room.margins.side - BESIDE)
    title = heading(spot.box, drafting.word(TITLE), drafting.scale(spot.scale), hand)
    frame = Group((*_grid(chart, place, hand), *_names(chart, place, drafting), *_axis(chart, place, drafting)))
    bars = Group(tuple(_bars(chart, place, drafting)), ROWS)
    settings = tuple(_settings(chart, place, drafting))
    return BarFigure(chart, place, (Group((title, frame, bars, *settings), NAME),), drafting)


def _beside(place: Place, spare: float) -> Place:
    """Stand it at the left side of its room: nothing stands left of it, right of it the letter of the abscissa."""
    return place._replace(origin=place.origin - spare)


def _written(hand: Hand) -> float:
    """Give the height, mm, of two lines of letters over a course, under the tick of a position."""
    return OVER + (STEP + 1) * hand.number + BESIDE + TICK


def _all(chart: Chart) -> Iterator[tuple[int, float, Stretch]]:
    """Give each stretch with the number of its row from 1, and the ordinate of the row's lower line."""
    for k, row in enumerate(chart.rows):
        for span in row.spans:
            yield from ((k + 1, -ROW * (k + 1), one) for one in stretches(span, chart.begin))


def _level(level: float) -> float:
    """Give the ordinate of a level over the row's lower line."""
    return LOW + (HIGH - LOW) * level


def _wide(text: str, hand: Hand) -> float:
    return text_width(Text(0j, text, hand.number, "middle", True))


def _told(one: Stretch, place: Place, drafting: Drafting) -> tuple[str, ...]:
    """Give the letters that have room over the line of a span, from below: its angle, what is done; or none."""
    room = place.length(one.end - one.start) - 2 * BESIDE
    texts = course.angle(one.span, drafting), course.doing(one.span, drafting)
    angle, doing = (_wide(text, drafting.hand) <= room for text in texts)
    fit = _lines(one, place, drafting.hand)
    return texts if angle and doing and fit > 1 else texts[1:] if doing and fit else ()


def _lines(one: Stretch, place: Place, hand: Hand) -> int:
    """Count the lines of letters that have room over the line of a span in its row: of a small chart not two."""
    room = place.length(ROW - _level(max(one.low, one.high))) - OVER
    return int((room + (STEP - 1) * hand.number) / (STEP * hand.number))


def _grid(chart: Chart, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Rule the rows, and the column of their names."""
    for k in range(len(chart.rows) + 1):
        yield Line(place.on(complex(-NAMES, -ROW * k)), place.on(complex(TURN, -ROW * k)), hand.other)
    for x in (-NAMES, 0.0, TURN):
        yield Line(place.on(complex(x, chart.bottom)), place.on(complex(x)), hand.other)
    for turned in chart.numbered:
        spot = place.on(complex(chart.at(turned)))
        yield Line(spot - 1j * TICK, spot + 1j * TICK, hand.other)


def _names(chart: Chart, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    hand = drafting.hand
    for k, row in enumerate(chart.rows):
        lines = _named(row, place, drafting)
        first = (
            place.on(complex(-NAMES, -ROW * (k + 0.5))) + BESIDE + 0.5j * hand.number * (STEP * (len(lines) - 1) - 1)
        )
        for line, text in enumerate(lines):
            yield Text(first - 1j * line * STEP * hand.number, text, hand.number, "start", True)


def _named(row: Row, place: Place, drafting: Drafting) -> tuple[str, ...]:
    """Give the lines of a row's name in the column; none, if they have no room there."""
    room = complex(place.length(NAMES), place.length(ROW)) - complex(2 * BESIDE, 2 * BESIDE)
    return lines(row, room, STEP, drafting)


def _axis(chart: Chart, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the abscissa with its degrees."""
    hand, start = drafting.hand, place.on(complex(0.0, chart.bottom))
    end = place.on(complex(TURN, chart.bottom)) + PAST
    head = arrowhead(start, end + 2 * PAST, hand.symbol)
    yield Line(start, end + 2 * PAST, hand.other)
    yield from () if head is None else (head,)
    yield Text(end - 1j * (TICK + BESIDE + hand.number), "φ, °", hand.number, "start", True)
    room = _wide("330", hand) + 2 * BESIDE
    told = next((step for step in TOLD if place.length(math.radians(step)) >= room), 3 * DEGREES)
    for degrees in range(0, 360, DEGREES):
        foot = place.on(complex(chart.at(math.radians(degrees)), chart.bottom))
        yield Line(foot - 1j * TICK, foot, hand.other)
        if degrees % told == 0:
            yield Text(foot - 1j * (TICK + BESIDE + hand.number), str(degrees), hand.number, "middle", True)


def _bars(chart: Chart, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the course of each span, its letters over it, and a line where the next one begins."""
    hand, counts = drafting.hand, dict[int, int]()
    for k, foot, one in _all(chart):
        counts[k] = number = counts.get(k, 0) + 1
        edge = place.on(complex(one.start, foot)), place.on(complex(one.start, foot + ROW))
        yield Line(*edge, hand.drafted)
        ends = complex(one.start, foot + _level(one.low)), complex(one.end, foot + _level(one.high))
        told, middle = (
            _told(one, place, drafting),
            complex((one.start + one.end) / 2, foot + _level(max(one.low, one.high))),
        )
        letter = told[0] if told else course.doing(one.span, drafting)
        yield _bar(f"{k}.{number}", ends, letter, one, place, hand)
        for line, text in enumerate(told):
            spot = place.on(middle) + 1j * (OVER + line * STEP * hand.number)
            yield Text(spot, text, hand.number, "middle", True)


def _bar(name: str, ends: tuple[complex, complex], text: str, one: Stretch, place: Place, hand: Hand) -> Group:
    """Draw the line of a span, to be measured."""
    start, end = map(place.on, ends)
    (line,) = fit_dashes([Line(start, end, course.style_of(one.span, hand))])
    data = Subject(NAME, SYMBOL, None).data("vector", name, ends[1] - ends[0], place.scale)
    return Group((line,), "", data, Text(0j, text).plain)


def _settings(chart: Chart, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Dimension the setting angles under the abscissa from where φ is 0, each on a level of its own."""
    hand = drafting.hand
    under = TICK + 2 * BESIDE + hand.number  # the degrees of the abscissa
    down = -1j * (under + hand.number)
    for k, row in enumerate(chart.settings):
        level, zero = chart.bottom - LEVEL * (k + 1), chart.at(0.0)
        ends = complex(zero, level), complex(chart.at(row.setting or 0.0), level)
        data = Subject(NAME, SYMBOL, None).data("vector", f"{SETTING}{k + 1}", ends[1] - ends[0], place.scale)
        start, end = (place.on(one) + down for one in ends)
        text = f"{course.name(row, drafting)}: {_setting(chart, row, drafting)}"
        heads = (arrowhead(start, end, hand.symbol), arrowhead(end, start, hand.symbol))
        yield Group((Line(start, end, hand.drafted),), "", data, Text(0j, text).plain)
        yield from (head for head in heads if head is not None)
        yield _over(start, end, text, hand)
        for x, tip in zip((zero, ends[1].real), (start, end), strict=True):
            yield Line(place.on(complex(x, chart.bottom)) - 1j * under, tip - 1j, hand.drafted)


def _over(start: complex, end: complex, text: str, hand: Hand) -> Text:
    """Write over the middle of a dimension, or where that is too short before it."""
    if _wide(text, hand) + 2 * BESIDE <= abs(end - start):
        own = Text((start + end) / 2, text, hand.number, "middle", True)
        return own._replace(at=own.at + 1j * (BESIDE - text_reach(own)[0]))  # a comma hangs below its line
    left = complex(min(start.real, end.real) - 2 * BESIDE, start.imag - hand.number / 2)
    return Text(left, text, hand.number, "end", True)


def _setting(chart: Chart, row: Row, drafting: Drafting) -> str:
    """Write a setting angle; of one that stands before 0 what it lacks of a whole turn."""
    told, back = course.setting(row, drafting), chart.at(0.0) - chart.at(row.setting or 0.0)
    return told if back <= 0 else f"{told} = 360° − {drafting.number(math.degrees(back), course.DIGITS)}°"
