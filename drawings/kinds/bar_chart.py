"""The rectangular chart of a cyclogram: a bar a stretch, a row a mechanism (прямоугольная циклограмма)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from drawings.kinds import course
from drawings.kinds.course import Stretch, stretches
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_reach, text_width
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Anchor, Group, Line, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols import trimming
from drawings.symbols.figure import Subject, around, heading
from drawings.symbols.symbols import TICK, arrowhead, fit_dashes
from plans.model.cyclogram import TURN, BarRow, Period, within

NAME, TITLE, TURNED = "bars", "cyclogram bars", "cyclogram turned"
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
    """What the charts show: rows, the numbered positions of the main shaft, if there are any, and its sense."""

    rows: tuple[BarRow, ...]
    sense: int = 1
    numbered: tuple[float, ...] = ()
    begin: float = 0.0  # turn of the main shaft where the abscissa begins

    @property
    def settings(self) -> tuple[BarRow, ...]:
        """The rows with a setting angle."""
        return tuple(row for row in self.rows if row.setting)

    def level(self, row: BarRow) -> int:
        """Give the level of a setting angle: the shortest is nearest to the chart, so none is crossed."""
        sizes = {one: abs(self.at(one.setting or 0.0) - self.at(0.0)) for one in self.settings}
        return 1 + sorted(sizes, key=lambda one: sizes[one]).index(row)

    @property
    def bottom(self) -> float:
        """The ordinate of the abscissa."""
        return -ROW * len(self.rows)

    def at(self, turned: float) -> float:
        """Give the abscissa of a turn of the main shaft, from 0 to less than a whole turn."""
        return within(turned - self.begin)


class Bar(NamedTuple):
    """A stretch on the chart: its name by row and number, the ordinate of its row's lower line."""

    name: str
    foot: float
    stretch: Stretch
    told: bool  # whether it bears its span's angle, which stands once: of a span that is cut, on the longer part

    def height(self, level: float) -> float:
        """Give the ordinate of a level over the row's lower line."""
        return self.foot + LOW + (HIGH - LOW) * level

    @property
    def ends(self) -> tuple[complex, complex]:
        """The true ends of its line."""
        stretch = self.stretch
        return complex(stretch.start, self.height(stretch.low)), complex(stretch.end, self.height(stretch.high))

    @property
    def top(self) -> complex:
        """The true place over its middle where its letters begin."""
        stretch = self.stretch
        return complex((stretch.start + stretch.end) / 2, self.height(max(stretch.low, stretch.high)))


def measure(chart: Chart, drafting: Drafting) -> Picture:
    """Measure the room that it needs."""
    hand = drafting.hand
    corners = (complex(-NAMES, chart.bottom - LEVEL * len(chart.settings)), complex(TURN, 0.0))
    title = text_width(Text(0j, drafting.word(TITLE), hand.title))
    written = OVER + (STEP + 1) * hand.number + BESIDE + TICK  # two lines over a course, under the tick of a position
    least = (TURN + NAMES) * max(_column(chart.rows, drafting) / NAMES, written / (ROW - HIGH))
    margins = around(MARGINS, hand, below=2 * hand.number)
    return picture(NAME, corners, (SYMBOL, UNIT), margins, title, least)._replace(most=LARGER * least)


def draw(chart: Chart, room: Picture, spot: Spot, drafting: Drafting) -> BarFigure:
    """Draw it in its spot, at the left side of its room: right of it stands the letter of the abscissa."""
    place = room.place(*spot)
    place = place._replace(origin=place.origin - (room.margins.side - BESIDE))
    title = heading(spot.box, drafting.word(TITLE), drafting.scale(spot.scale), drafting.hand, drafting.word(TURNED))
    return BarFigure(chart, place, title, drafting)


@dataclass(frozen=True)
class ChartFigure:
    """A chart placed on paper."""

    chart: Chart
    place: Place
    title: Group
    drafting: Drafting

    @property
    def hand(self) -> Hand:
        """The hand that draws."""
        return self.drafting.hand


class BarFigure(ChartFigure):
    """The bar chart placed on paper."""

    @cached_property
    def lines(self) -> tuple[Group, ...]:
        """All that is drawn before any letter is placed: heading, rows, abscissa, bars, setting angles."""
        frame = Group((*self._grid(), *self._column(), *self._axis()))
        bars = Group(tuple(stroke for bar in self._bars() for stroke in self._bar(bar)), ROWS)
        settings = tuple(self._settings())
        masks = [trimming.around(one, BESIDE / 2) for one in settings if isinstance(one, Text)]
        return (Group((self.title, frame, bars, *trimming.trim(settings, masks)), NAME),)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole chart, what is too long for its bar lettered beside it."""
        letters = (*self._numbers(labels), *self._long(labels), *self._outside(labels))
        return *self.lines, *([Group(letters, f"{NAME}-letters")] if letters else [])

    def _on(self, x: float, y: float = 0.0) -> complex:
        return self.place.on(complex(x, y))

    def _text(self, at: complex, text: str, anchor: Anchor = "middle") -> Text:
        return Text(at, text, self.hand.number, anchor, True)

    def _bars(self) -> Iterator[Bar]:
        """Give the stretches of all rows."""
        for k, row in enumerate(self.chart.rows, 1):
            bars = ((stretch, told) for span in row.spans for stretch, told in _told_once(span, self.chart.begin))
            yield from (Bar(f"{k}.{number}", -ROW * k, *bar) for number, bar in enumerate(bars, 1))

    def _grid(self) -> Iterator[Stroke]:
        """Rule the rows, and the column of their names."""
        for k in range(len(self.chart.rows) + 1):
            yield Line(self._on(-NAMES, -ROW * k), self._on(TURN, -ROW * k), self.hand.other)
        for x in (-NAMES, 0.0, TURN):
            yield Line(self._on(x, self.chart.bottom), self._on(x), self.hand.other)
        for turned in self.chart.numbered:
            spot = self._on(self.chart.at(turned))
            yield Line(spot - 1j * TICK, spot + 1j * TICK, self.hand.other)

    def _column(self) -> Iterator[Stroke]:
        """Write the names of the rows in their column."""
        size = self.hand.number
        for k, row in enumerate(self.chart.rows):
            lines = self._named(row)
            first = self._on(-NAMES, -ROW * (k + 0.5)) + BESIDE + 0.5j * size * (STEP * (len(lines) - 1) - 1)
            yield from (self._text(first - 1j * n * STEP * size, text, "start") for n, text in enumerate(lines))

    def _named(self, row: BarRow) -> tuple[str, ...]:
        """Give the lines of a row's name in the column; none, if they have no room there."""
        wide, high = (self.place.length(side) - 2 * BESIDE for side in (NAMES, ROW))
        found = broken(course.name(row, self.drafting), wide, self._wide)
        return found if (STEP * (len(found) - 1) + 1) * self.hand.number <= high else ()

    def _wide(self, text: str) -> float:
        return _reach(text, self.hand)

    def _axis(self) -> Iterator[Stroke]:
        """Draw the abscissa with its degrees."""
        hand, bottom = self.hand, self.chart.bottom
        start, end = self._on(0.0, bottom), self._on(TURN, bottom) + PAST
        head, under = arrowhead(start, end + 2 * PAST, hand.symbol), 1j * (TICK + BESIDE + hand.number)
        yield Line(start, end + 2 * PAST, hand.other)
        yield from () if head is None else (head,)
        yield self._text(end - under, "φ, °", "start")
        room = self._wide("330") + 2 * BESIDE
        every = next((step for step in TOLD if self.place.length(math.radians(step)) >= room), 3 * DEGREES)
        for degrees in range(0, 360, DEGREES):
            foot = self._on(self.chart.at(math.radians(degrees)), bottom)
            yield Line(foot - 1j * TICK, foot, hand.other)
            if degrees % every == 0:
                yield self._text(foot - under, str(degrees))

    def _bar(self, bar: Bar) -> Iterator[Stroke]:
        """Draw a line where a stretch begins, its course, which can be measured, and its letters over that."""
        stretch, ends, words = bar.stretch, bar.ends, self._label(bar)
        yield Line(self._on(stretch.start, bar.foot), self._on(stretch.start, bar.foot + ROW), self.hand.drafted)
        start, end = map(self.place.on, ends)
        line = fit_dashes([Line(start, end, course.style_of(stretch.span, self.hand))])
        data = Subject(NAME, SYMBOL, None).data("vector", bar.name, ends[1] - ends[0], self.place.scale)
        letter = words[0] if words else self._whole(bar) if self._lettered(bar) else ""
        yield Group(tuple(line), "", data, Text(0j, letter).plain)
        for k, text in enumerate(words):
            label = self._text(self.place.on(bar.top) + 1j * k * STEP * self.hand.number, text)
            yield label._replace(at=label.at + 1j * max(OVER, BESIDE - text_reach(label)[0]))  # an index hangs low

    def _label(self, bar: Bar) -> tuple[str, ...]:
        """Give the letters that have room over the line of a stretch, from below: its angle, what is done; or none."""
        stretch = bar.stretch
        room = self.place.length(stretch.end - stretch.start) - 2 * BESIDE
        doing = course.doing(stretch.span, self.drafting)
        two, one = (course.angle(stretch.span, self.drafting), doing), (self._whole(bar),)
        # of a small chart two lines have no room in a row
        high = self.place.length(bar.foot + ROW - bar.top.imag) - OVER
        fit = int((high + (STEP - 1) * self.hand.number) / (STEP * self.hand.number))
        # a phase has its letter and its angle in a line, as a dimension has
        ways = ((one, two) if stretch.span.label else (two, one)) if bar.told else (one,)
        return next((way for way in ways if len(way) <= fit and max(map(self._wide, way)) <= room), ())

    def _lettered(self, bar: Bar) -> bool:
        """Whether it bears letters: a part of a cut span that is hardly seen has none beside the longer one."""
        start, end = map(self.place.on, bar.ends)
        return bar.told or abs(end - start) > SEEN

    def _whole(self, bar: Bar) -> str:
        """Write in a line what is done in a stretch, with its angle where that is told here."""
        write = course.label if bar.told else course.doing
        return write(bar.stretch.span, self.drafting)

    def _settings(self) -> Iterator[Stroke]:
        """Dimension the setting angles under the abscissa from where φ is 0, each on a level of its own."""
        hand, chart, zero = self.hand, self.chart, self.chart.at(0.0)
        under = TICK + 2 * BESIDE + hand.number  # the degrees of the abscissa
        for k, row in enumerate(chart.settings, 1):
            low = chart.bottom - LEVEL * chart.level(row)
            ends = tuple(complex(x, low) for x in (zero, chart.at(row.setting or 0.0)))
            data = Subject(NAME, SYMBOL, None).data("vector", f"{SETTING}{k}", ends[1] - ends[0], self.place.scale)
            start, end = (self.place.on(spot) - 1j * (under + hand.number) for spot in ends)
            told = self._over(row, start, end)
            heads = (arrowhead(start, end, hand.symbol), arrowhead(end, start, hand.symbol))
            yield Group((Line(start, end, hand.drafted),), "", data, told.plain)
            yield from (head for head in heads if head is not None)
            yield told
            for spot, tip in zip(ends, (start, end), strict=True):
                yield Line(self._on(spot.real, chart.bottom) - 1j * under, tip - 1j, hand.drafted)

    def _over(self, row: BarRow, start: complex, end: complex) -> Text:
        """Write over the middle of a dimension whose angle it is; where that is too short before it, or past it."""
        first, last = sorted((start.real, end.real))
        before, past = first - self._on(-NAMES).real, self._on(TURN).real + PAST - last
        full, named, bare = self._told(row)
        foot = start.imag - self.hand.number / 2
        for text in (full, named, bare):
            wide = self._wide(text) + 2 * BESIDE
            if wide <= last - first:
                label = self._text((start + end) / 2, text)
                # A comma hangs below its line
                return label._replace(at=label.at + 1j * (BESIDE - text_reach(label)[0]))
            if text != full and wide <= before:
                return self._text(complex(first - 2 * BESIDE, foot), text, "end")
            if text != full and wide <= past:
                break
        return self._text(complex(last + 2 * BESIDE, foot), text, "start")

    def _told(self, row: BarRow) -> tuple[str, str, str]:
        """Write whose setting angle it is: in words, with the name, alone; of one before 0 what it lacks of a turn."""
        setting, back = row.setting or 0.0, self.chart.at(0.0) - self.chart.at(row.setting or 0.0)
        lack = f"360° − {course.degrees(back, self.drafting)} = " if back > 0 else ""
        angle = f"{lack}{course.degrees(within(setting), self.drafting)}"
        text = self.drafting.word("cyclogram setting", angle=angle)
        name = course.name(row, self.drafting)
        return self.drafting.word("cyclogram set angle", name=name, angle=text), f"{name}: {text}", text

    def _numbers(self, labels: Labels) -> Iterator[Stroke]:
        """Number the positions; a turn ends where it begins."""
        ends = [self.chart.at(turned) for turned in self.chart.numbered]
        for number, x in (*enumerate(ends), *([(0, TURN)] if 0.0 in ends[:1] else [])):
            spot = self._on(x) + 1j * TICK
            yield labels.beside(spot, str(number), self.hand.number, BESIDE, math.pi / 2)

    def _long(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the bars whose letters have no room over them."""
        for bar in self._bars():
            if self._lettered(bar) and not self._label(bar):
                text, spot = self._whole(bar), self.place.on(sum(bar.ends) / 2)
                yield labels.beside(spot, text, self.hand.number, BESIDE, math.pi / 2)

    def _outside(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the rows whose names have no room in their column."""
        for k, row in enumerate(self.chart.rows):
            if not self._named(row):
                spot, name = self._on(-NAMES, -ROW * (k + 0.5)), course.name(row, self.drafting)
                yield labels.beside(spot, name, self.hand.number, BESIDE, math.pi)


def _told_once(span: Period, begin: float) -> list[tuple[Stretch, bool]]:
    """Cut a span where the chart begins, and say which part bears its angle: the longest."""
    parts = stretches(span, begin)
    longest = max(parts, key=lambda part: tied(part.end - part.start))
    return [(part, part is longest) for part in parts]


def _column(rows: Sequence[BarRow], drafting: Drafting) -> float:
    """Give the width, mm, of the column that bears the names: in two lines what has two words."""
    names = [course.name(row, drafting) for row in rows]
    lines = (line for name in names for line in min(_ways(name), key=lambda way: max(map(len, way))))
    return max(_reach(line, drafting.hand) for line in lines) + 2 * BESIDE


def broken(text: str, room: float, wide: Callable[[str], float]) -> tuple[str, ...]:
    """Break a name into two lines at most that have room, as even as may be; nothing if they have none.

    >>> broken("auxiliary mechanism", 12, len), broken("tool", 12, len), broken("mechanism", 8, len)
    (('auxiliary', 'mechanism'), ('tool',), ())
    """
    whole, *others = _ways(text)
    best = whole if wide(text) <= room else min(others, key=lambda way: max(map(wide, way)), default=whole)
    return best if max(map(wide, best)) <= room else ()


def _ways(text: str) -> list[tuple[str, ...]]:
    """Give the ways to break a text, in one line first."""
    parts = text.split(" ")
    return [(text,), *((" ".join(parts[:k]), " ".join(parts[k:])) for k in range(1, len(parts)))]


def _reach(text: str, hand: Hand) -> float:
    return text_width(Text(0j, text, hand.number, "middle", True))
