"""The strokes of the bar chart of a cyclogram: rows, axis, degrees, bars, words (прямоугольная циклограмма)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise

from drawings.checks.cyclogram.cyclogram_words import DIGITS as ANGLE_DIGITS
from drawings.checks.cyclogram.cyclogram_words import angle, doing, in_style, row_name, setting
from drawings.checks.graphs.figure_strokes import FLUSH
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.letters import along
from drawings.checks.precise import KNOWN, precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.lettering.extent import bounds
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Line, Text
from plans.model.cyclogram import TURN, Row, Span, within

BARS = "bars"
DEGREES = 30  # from one number of the abscissa to the next
CLEAR = 0.8  # mm from letters to lines and others
OVER, ROUGH = 1.6, 0.5  # mm from a bar to its letters; so much more room and they must stand in it
TICKED = 2.5  # mm: so far from an axis at most goes a tick


@dataclass(frozen=True)
class BarStrokes:
    """The bar chart on a sheet, its rows by the analysis, the numbered turns of the main shaft, where it begins."""

    groups: tuple[Group, ...]
    rows: Sequence[Row]
    numbered: Sequence[float]
    measured: Sequence[MeasuredVector]
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(BARS, self.groups)

    @property
    def begin(self) -> float:
        """The turn at which the abscissa begins: at the first position, without positions at φ = 0."""
        return next(iter(self.numbered), 0.0)

    @cached_property
    def mu(self) -> float:
        """The scale, rad/mm."""
        return next((one.scale for one in self.measured), math.nan)

    @cached_property
    def zero(self) -> complex:
        """Where the abscissa begins on paper, mm: the uppermost line of the rows ends a turn further on."""
        lines = [one for one in self.inventory.left(Line) if abs((one.end - one.start).imag) <= FLUSH]
        wide = [one for one in lines if abs(one.end - one.start) > TURN / self.mu + FLUSH]
        right = min((max(one.start.real, one.end.real) for one in wide), default=math.nan)
        foot = min((one.start.imag for one in wide), default=math.nan)
        return complex(right - TURN / self.mu, foot)

    @cached_property
    def left(self) -> float:
        """Where the column of names begins on paper, mm: the lines between the rows do."""
        ruled = (one for one in self.inventory.left(Line) if self._ruled(one))
        return min((min(one.start.real, one.end.real) for one in ruled), default=math.nan)

    def x(self, turned: float) -> float:
        """Give where a turn of the main shaft lies along the abscissa, mm."""
        return self.zero.real + within(turned - self.begin) / self.mu

    def faults(self) -> Iterator[Wrong]:
        """Hold heading, frame, axis, the places of the bars in their rows, their words."""
        own, word = self.inventory, self.drafting.word
        title = word("cyclogram bars")
        own.text(title, on("title", BARS, text=title))
        under = scale_line(self.mu, "φ", "rad", self.drafting)
        own.text(under, on("scale_missing", BARS, text=under))
        levels = self._frame()
        self._axis()
        self._numbers(levels)
        self._bars(levels)
        return own.faults()

    def _frame(self) -> list[float]:
        """Hold the lines between the rows, all alike high, and the uprights; give the heights of the lines from top."""
        own, count = self.inventory, len(self.rows)
        wide = [one for one in own.left(Line) if self._ruled(one)]
        if any(abs(min(one.start.real, one.end.real) - self.left) > FLUSH for one in wide):
            own.wrong.append(on("line", BARS))
        levels = sorted({round(one.start.imag, 6) for one in wide}, reverse=True)
        if len(levels) != count + 1 or len(wide) != count + 1:
            own.wrong.append(on("line", BARS))
            return []
        steps = [one - other for one, other in pairwise(levels)]
        if max(steps) - min(steps) > FLUSH:
            own.wrong.append(on("line", BARS))
        own.every(Line, self._ruled)
        for x in (self.left, self.zero.real, self.zero.real + TURN / self.mu):
            own.line(complex(x, levels[0]), complex(x, levels[-1]), on("line", BARS))
        return levels

    def _ruled(self, one: Line) -> bool:
        right = max(one.start.real, one.end.real)
        end = self.zero.real + TURN / self.mu
        left = min(one.start.real, one.end.real)
        return abs((one.end - one.start).imag) <= FLUSH and abs(right - end) <= FLUSH and left < self.zero.real - FLUSH

    def _axis(self) -> None:
        """Hold the abscissa with its head, and its degrees where φ is so large."""
        own, end = self.inventory, self.zero.real + TURN / self.mu
        tip = own.arrow(self.zero, lambda spot: abs((spot - self.zero).imag) <= FLUSH and spot.real > end,
                        on("axis_line", BARS))  # fmt: skip
        own.take(Text, lambda one: one.plain == "φ, °" and tip is not None and own.beside(one, [tip, complex(
            end, self.zero.imag)]) and bounds(one)[3] < self.zero.imag, on("letter", BARS, name="φ, °"))  # fmt: skip
        told = self._numbered
        for degrees in range(0, 360, DEGREES):
            foot, name = complex(self.x(math.radians(degrees)), self.zero.imag), str(degrees)
            tick = own.take(Line, lambda one, foot=foot: _hangs(one, foot), on("tick", BARS, name=name))  # type: ignore[misc]
            spots = [foot] if tick is None else [min(tick.start, tick.end, key=lambda spot: spot.imag)]
            own.take(
                Text,
                lambda one, name=name, spots=spots: one.plain == name and _under(one, spots) and own.beside(one, spots),  # type: ignore[misc]
                on("letter", BARS, name=name) if degrees % told == 0 else None,
            )

    @property
    def _numbered(self) -> int:
        """From one number of the abscissa to the next, as those of three digits have room."""
        widest = bounds(Text(0j, "330", self.drafting.hand.number, "middle", True))
        room = widest[2] - widest[0] + 2 * CLEAR
        return next((step for step in (30, 60) if math.radians(step) / self.mu >= room), 90)

    def _numbers(self, levels: Sequence[float]) -> None:
        """Hold the ticks and the numbers of the positions over the uppermost line."""
        own, top = self.inventory, levels[0] if levels else math.nan
        places = [self.x(turned) for turned in self.numbered]
        for number, x in enumerate(places):
            spot, name = complex(x, top), str(number)
            own.take(Line, lambda one, spot=spot: ticks(one, spot, 1j), on("tick", BARS, name=name))  # type: ignore[misc]
            own.letter(name, [spot], on("letter", BARS, name=name))
        if self.numbered:
            own.letter("0", [complex(self.zero.real + TURN / self.mu, top)], on("letter", BARS, name="0"))

    def _bars(self, levels: Sequence[float]) -> None:
        """Hold that each line of a span stands in its own row where its span is, and its row's name."""
        own = self.inventory
        for k, row in enumerate(self.rows, 1):
            if not levels:
                return
            low, high = levels[k], levels[k - 1]
            mine = [one for one in self.measured if one.name.startswith(f"{k}.")]
            starts = sorted(within(span.start - self.begin) for span in row.spans)
            for one in mine:
                span, line = self._span(row, one), own.line(one.start, one.end)
                if line is None or not in_style(line, span, self.drafting):
                    own.wrong.append(on("line_named", BARS, name=one.name))
                self._told(span, one, low, high)
                inside = all(low < spot.imag < high for spot in (one.start, one.end))
                x = (one.start.real - self.zero.real) * self.mu
                if not inside or not any(abs(x - start) <= FLUSH * self.mu for start in (0.0, *starts)):
                    own.wrong.append(on("corner_of", BARS, name=one.name))
                own.line(complex(one.start.real, low), complex(one.start.real, high), on("edge", BARS, name=one.name))
            self._named(row_name(row, self.drafting), low, high)
        self._settings()

    def _named(self, name: str, low: float, high: float) -> None:
        """Hold the name of a row: within its field of the column, in some lines, or beside it, led to it."""
        own, field = self.inventory, (self.left, low, self.zero.real, high)
        lines = own.every(Text, lambda one: _inside(bounds(one), field))
        told = " ".join(one.plain for one in sorted(lines, key=lambda one: -one.at.imag))
        if told == name:
            return
        at, wrong = [complex(self.left, (low + high) / 2)], on("letter", BARS, name=name)
        own.take(Text, lambda one: one.plain == name and own.beside(one, at) and not _over(bounds(one), field),
                 wrong)  # fmt: skip

    def _span(self, row: Row, bar: MeasuredVector) -> Span:
        """Give the span whose line a bar is: that which begins there, else the last, which the abscissa cuts."""
        x, begin = (bar.start.real - self.zero.real) * self.mu, self.begin
        own = [one for one in row.spans if abs(within(one.start - begin) - x) <= FLUSH * self.mu]
        return (own or [max(row.spans, key=lambda one: within(one.start - begin))])[0]

    def _told(self, span: Span, bar: MeasuredVector, low: float, high: float) -> None:
        """Hold what is written over the line of a span: what is done, and its angle where it has room."""
        left, right = sorted((bar.start.real, bar.end.real))

        level = max(bar.start.imag, bar.end.imag)

        def over(one: Text) -> bool:
            box, size = bounds(one), self.drafting.hand.number
            wide, tall = right - left - 2 * CLEAR - ROUGH, high - level - OVER - ROUGH
            if box[2] - box[0] <= wide and size <= tall:
                return _inside(box, (left, level, right, high))
            return _inside(box, (left, low, right, high)) or self.inventory.beside(one, along(bar.start, bar.end))

        done = doing(span, self.drafting)
        self.inventory.take(
            Text, lambda one: one.plain == done and over(one), on("letter", BARS, name=f"{bar.name} {done}")
        )
        exact = angle(span, precise(self.drafting))
        self.inventory.take(Text, lambda one: tells(one.plain, exact, (ANGLE_DIGITS,), KNOWN) and over(one))

    def _settings(self) -> None:
        """Hold the dimensions of the setting angles; what they say is read by itself."""
        rows = [row for row in self.rows if row.setting]
        named = {f"set.{k}": setting(row, self.begin, precise(self.drafting)) for k, row in enumerate(rows, 1)}
        for one in self.measured:
            if one.name in named:
                self._setting(one, named[one.name])

    def _setting(self, one: MeasuredVector, told: str) -> None:
        """Hold the dimension of a setting angle with what it says."""
        own, level, wrong = self.inventory, one.start.imag, on("size", BARS, name=one.name)
        own.line(one.start, one.end, wrong)
        left, right = sorted((one.start.real, one.end.real))
        own.take(Text, lambda text: self._on(text, level, told) and _clear(bounds(text), left, right, level), wrong)
        own.heads(one.start, one.end, wrong)
        for end in (one.start, one.end):
            own.take(Line, partial(_leads, end.real, level), wrong)

    def _on(self, text: Text, level: float, told: str) -> bool:
        return abs(text.at.imag - level) < 2 * TICKED and tells(text.plain, told, (ANGLE_DIGITS,), KNOWN)


def _inside(box: tuple[float, float, float, float], field: tuple[float, float, float, float]) -> bool:
    """Tell whether a box lies within a field: left, bottom, right, top."""
    return box[0] >= field[0] and box[1] >= field[1] and box[2] <= field[2] and box[3] <= field[3]


def _under(one: Text, spots: Sequence[complex]) -> bool:
    """Tell whether a text hangs under each of some places."""
    return all(bounds(one)[3] <= spot.imag for spot in spots)


def _clear(box: tuple[float, float, float, float], left: float, right: float, level: float) -> bool:
    """Tell whether a box stands over a dimension, between its ends, or before it."""
    return box[2] <= left or (box[0] >= left and box[2] <= right and box[1] >= level)


def _over(box: tuple[float, float, float, float], field: tuple[float, float, float, float]) -> bool:
    """Tell whether a box lies over some of a field."""
    return box[0] < field[2] and field[0] < box[2] and box[1] < field[3] and field[1] < box[3]


def _hangs(one: Line, foot: complex) -> bool:
    """Tell whether a line is a tick that hangs down from a place."""
    ends = (one.start, one.end)
    return min(abs(end - foot) for end in ends) <= FLUSH and any(
        abs((end - foot).real) <= FLUSH and -TICKED < (end - foot).imag < 0 for end in ends
    )


def ticks(one: Line, spot: complex, way: complex) -> bool:
    """Tell whether a line is a tick through a place."""
    half = (one.end - one.start) / 2 / way
    middle = abs((one.start + one.end) / 2 - spot) <= FLUSH
    return middle and abs(half.imag) <= FLUSH and FLUSH < abs(half) < TICKED


def _leads(x: float, level: float, line: Line) -> bool:
    """Tell whether an upright line leads down to a level, a little past it."""
    low = min(line.start.imag, line.end.imag)
    upright = max(abs(end.real - x) for end in (line.start, line.end)) <= FLUSH
    return upright and level - TICKED < low < level < max(line.start.imag, line.end.imag)
