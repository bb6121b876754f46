"""The strokes of the circular chart: rings, rays, arcs, sense, letters (круговая циклограмма)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

from drawings.checks.cyclogram.cyclogram_bars import ticks
from drawings.checks.cyclogram.cyclogram_words import DIGITS as ANGLE_DIGITS
from drawings.checks.cyclogram.cyclogram_words import label, row_name
from drawings.checks.cyclogram.due_rows import THIN
from drawings.checks.graphs.figure_strokes import FLUSH
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.precise import KNOWN, precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.lettering.extent import bounds
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Arc, Circle, Fill, Group, Line, Text
from plans.model.cyclogram import TURN, Row, Span

CIRCLE = "circle"
TICKED = 2.5  # mm: so far from a circle at most goes a tick
SQUARE = 0.05  # rad that the middle of a text's box may turn it off its ring: letters are not alike on both sides


@dataclass(frozen=True)
class RingStrokes:
    """The circular chart on a sheet, its rows by the analysis, the numbered turns, the sense of rotation."""

    groups: tuple[Group, ...]
    rows: Sequence[Row]
    numbered: Sequence[float]
    sense: int
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(CIRCLE, self.groups)

    def faults(self) -> Iterator[Wrong]:
        """Hold circles, rays, arcs in their rings, ticks, the sense of rotation."""
        own, word = self.inventory, self.drafting.word
        for key in ("cyclogram circle", "cyclogram counted"):
            own.text(word(key), on("title", CIRCLE, text=word(key)))
        circles = sorted(own.left(Circle), key=lambda one: one.radius)
        apart = max((abs(one.centre - circles[0].centre) for one in circles), default=0.0)
        if len(circles) != len(self.rows) + 1 or apart > FLUSH:
            yield on("circle", CIRCLE, name="φ")
            return
        own.every(Circle, lambda one: True)
        self._rings(circles)
        yield from own.faults()

    def _rings(self, circles: Sequence[Circle]) -> None:
        own, centre, radii = self.inventory, circles[0].centre, [one.radius for one in circles]
        steps = [high - low for low, high in pairwise(radii)]
        if max(steps) - min(steps) > FLUSH:
            own.wrong.append(on("circle", CIRCLE, name="φ"))
        own.line(centre, centre + radii[0], on("axis_line", CIRCLE))
        arrow = own.take(Arc, lambda one: abs(one.centre - centre) <= FLUSH and one.radius < radii[0],
                         on("sense", CIRCLE, name="ω"))  # fmt: skip
        if arrow is not None:
            self._sense(arrow)
        for number, turned in enumerate(self.numbered):
            ray, name = cmath.rect(1.0, self.sense * turned), str(number)
            spot = centre + radii[-1] * ray
            own.take(Line, lambda one, spot=spot, ray=ray: ticks(one, spot, ray), on("tick", CIRCLE, name=name))  # type: ignore[misc]
            own.letter(name, [spot + ray], on("letter", CIRCLE, name=name))
        for k, row in enumerate(self.rows):
            low, high = radii[len(self.rows) - 1 - k], radii[len(self.rows) - k]
            for span in row.spans:
                self._span(centre, (low, high), span, f"ring-{k}")
        for k, row in enumerate(self.rows):
            low, high = radii[len(self.rows) - 1 - k], radii[len(self.rows) - k]
            self._named(centre, (low, high), row)

    def _named(self, centre: complex, ring: tuple[float, float], row: Row) -> None:
        """Hold the name of a ring within it or beside its beginning, and what is done in each of its spans."""
        own, name, middle = self.inventory, row_name(row, self.drafting), sum(ring) / 2
        first = centre + cmath.rect(middle, self.sense * row.spans[0].start)

        def there(one: Text, start: float, end: float) -> bool:
            left, bottom, right, top = bounds(one)
            spot = complex(left + right, bottom + top) / 2 - centre
            gone = (self.sense * cmath.phase(spot) - start) % TURN
            half = centre + cmath.rect(middle, self.sense * (start + end) / 2)
            if one.rotation:
                return gone <= end - start and _follows(one, centre, ring, self.sense * (start + end) / 2, end - start)
            return (ring[0] < abs(spot) < ring[1] and gone <= end - start) or own.beside(one, [half])

        for span in row.spans:
            exact = label(span, precise(self.drafting))
            own.take(
                Text,
                lambda one, exact=exact, span=span: (
                    tells(one.plain, exact, (ANGLE_DIGITS,), KNOWN)  # type: ignore[misc]
                    and there(one, span.start, span.end)
                ),
                on("letter", CIRCLE, name=label(span, self.drafting)),
            )
        own.take(
            Text,
            lambda one: one.plain == name and (there(one, 0.0, TURN) or own.beside(one, [first])),
            on("letter", CIRCLE, name=name),
        )

    def _sense(self, arrow: Arc) -> None:
        """Hold that the head of the arrow of rotation is at the end that its sense leads to."""
        self.inventory.letter("ω", [arrow.at(0.5)], on("letter", CIRCLE, name="ω"))
        tip = arrow.at(1.0 if self.sense > 0 else 0.0)
        way = self.sense * 1j * (tip - arrow.centre)
        self.inventory.take(
            Fill,
            lambda one: abs(sum(one.points[1:]) / 2 - tip) <= TICKED and ((one.points[0] - tip) / way).real > 0,
            on("sense", CIRCLE, name="ω"),
        )

    def _span(self, centre: complex, ring: tuple[float, float], span: Span, name: str) -> None:
        """Hold the line where a span begins, across its ring, and the arc of the span, main or thin, within it."""
        start, end = self.sense * span.start, self.sense * span.end
        wide = self.drafting.hand.construction if span.kind in (*THIN, "rest") else self.drafting.hand.main
        own, wrong, ray = self.inventory, on("differs_on", CIRCLE, name=name), cmath.rect(1.0, start)
        own.line(centre + ring[0] * ray, centre + ring[1] * ray, wrong)
        low, high = sorted((start, end))
        own.take(
            Arc,
            lambda one: (
                abs(one.centre - centre) <= FLUSH
                and ring[0] < one.radius < ring[1]
                and (one.style.width, one.style.dash) == (wide, ())
                and max(_apart(one.start_angle, low), _apart(one.end_angle, high)) * ring[1] <= FLUSH
            ),
            wrong,
        )


def _apart(one: float, other: float) -> float:
    return abs(math.remainder(one - other, math.tau))


def _follows(one: Text, centre: complex, ring: tuple[float, float], middle: float, wide: float) -> bool:
    """Tell whether a text follows its ring, upright, between the ends of a span so wide about its middle, rad."""
    way, box = cmath.rect(1.0, math.radians(one.rotation)), bounds(replace(one, rotation=0.0))
    corners = [one.at + (complex(x, y) - one.at) * way - centre for x in box[::2] for y in box[1::2]]
    spot = sum(corners) / len(corners)
    along = abs((way / spot).real) * abs(spot) <= SQUARE and way.real >= -SQUARE
    held = all(abs(cmath.phase(one / cmath.rect(1.0, middle))) <= wide / 2 for one in corners)
    return along and held and all(ring[0] < abs(one) < ring[1] for one in corners)
