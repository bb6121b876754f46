"""Labels that find a free place near what they name, or lead to one (обозначения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import product
from typing import TypeAlias

from drawings.layout.ink import CLEAR, LETTERED, Ink, padded
from drawings.layout.parallel_offsets import Segment, crossing, merging, nearest
from drawings.lettering.lettering import bounds, text_reach
from drawings.paper.strokes import Box, Group, Line, LineStyle, Stroke, Text
from drawings.paper.walk import tied, tied_spot

WELL_CLEAR = 0.7  # mm around a label beside a line, where another main line may run along it
DIRECTIONS = 16
NEAR = (0.0, 0.7, 1.6)  # mm a label may stand further off than its nearest place, without a leader
LED = (*range(4, 16, 2), *range(16, 40, 3), *range(40, 160, 6))  # mm from a point to a label that a leader leads to
LEAD_DIRECTIONS = 64  # none of them but every 16th along a crank divided by 12, 24 or 36
TURNED = 0.12  # cost of a direction, in mm of distance a step away from the preferred one
SHARES = (0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2, 0.9, 0.1)  # of a line, from its start, where its label may stand
WORD = 0.5  # sizes of a letter between two words
STRAY = 4.0  # cost of a place that is nearer to what another label names, in mm of distance: more than any turn
OTHER = 40.0  # cost of what another label names, or its leader, that a leader crosses, in mm of its length
CROSSED = 0.05  # cost of a line that a leader crosses, in mm of its length a cell
MEETING = 2.0  # mm from the end of a leader at its label to another leader: a number is not much larger
ACROSS, MERGED = 3.0, 8.0  # mm of ink at a leader across a line; what each mm beyond costs: it runs along a line
BACK, ASTRAIGHT = 4.0, math.radians(15)  # mm from one leader's start to another's; their bend there, to be two lines
Spots: TypeAlias = Sequence[complex]
Lines: TypeAlias = Sequence[Segment]  # a point is one of no length


class Labels:
    """Labels of one sheet: each takes the freest place around its point and is inked in at once.

    A label covers no line and no other label. Where there is no room beside its point, a thin leader leads to it
    (линия-выноска); it may cross lines, but no label.
    """

    def __init__(self, ink: Ink, leader: LineStyle, slanted: bool = True) -> None:
        self.ink, self._leader, self._slanted = ink, leader, slanted
        self._leaders: list[Segment] = []

    def beside(
        self, point: complex, content: str, size: float, gap: float, prefer: float = math.pi / 4,
        others: Lines = (), further: Spots = (),
    ) -> Stroke:  # fmt: skip
        """Place a label `gap` mm beside a point or `further` ones, near a direction, rad, no nearer to `others`."""
        label = self.free(point, content, size, gap, prefer, others, further)
        if label is None:  # there is no free place on the whole sheet; a letter is needed all the same
            label = self._written(self._near(point, self._parts(content, size), gap, prefer), content, size)
        return label

    def free(
        self, point: complex, content: str, size: float, gap: float, prefer: float,
        others: Lines = (), further: Spots = (), ring: float = 0.0,
    ) -> Stroke | None:  # fmt: skip
        """Place a label beside a point, a `ring` further off, or at a leader's end, or nowhere if there is no place."""
        box, *_ = parts = self._parts(content, size)
        spots, bare = (point, *further), list[complex]()
        # What a number, a list or a letter with its unit keeps from letters on its line: it would be read on with them.
        space = WORD * size if content[:1].isdigit() or ", " in content else 0.0
        for spot in spots:
            near = self._near(spot, parts, gap + ring, prefer, others, space)
            if not self.ink.under(padded(box, near)):
                bare.append(near)
                away = (near + complex(box[0] + box[2], box[1] + box[3]) / 2 - spot) * cmath.rect(1.0, -prefer)
                astray = _strays(parts, near, spot, spot, others) or self._joins(box, near, space)
                if not (astray or (ring and abs(away.imag) > away.real)):  # beside its way a ring tells nothing
                    return self._written(near, content, size)
        off = 0.0 if further else 0.7 * gap  # from a line a leader leads at once
        lines, back = (*others, *self._leaders), 0.0 if off or not others else BACK
        tries: list[tuple[Lines, float]] = [(lines, back), (lines, 0.0), *([] if bare else [((), 0.0)])]
        led = next((led for near in tries if (led := self._led(spots, box, gap, off, prefer, *near))), None)
        if led is not None:
            self._leaders.append((led[0], _nearest(box, led[2], led[0], 0.0)))
            return self._written(led[2], content, size, Line(*led[:2], self._leader))
        return self._written(bare[0], content, size) if bare else None

    def _written(self, corner: complex, content: str, size: float, leader: Line | None = None) -> Stroke:
        """Ink a label in, with its leader."""
        text = Text(corner, content, size, "start", self._slanted)
        label = text if leader is None else Group((leader, text))
        self.ink.draw([label])
        return label

    def close(self, point: complex, content: str, size: float, gap: float, prefer: float) -> Stroke | None:
        """Place a label beside a point, or nowhere if there is no free place there: no leader leads to it."""
        parts = self._parts(content, size)
        near = self._near(point, parts, gap, prefer)
        return None if self.ink.under(padded(parts[0], near)) else self.free(point, content, size, gap, prefer)

    def along(
        self, start: complex, end: complex, content: str, size: float, gap: float, prefer: float, others: Lines = ()
    ) -> Stroke:
        """Place a label `gap` mm beside a line, near its middle or else a point of it, no nearer to `others`."""
        box, *_ = parts = self._parts(content, size)
        across = 1j * (end - start) / abs(end - start)
        if tied((across * cmath.rect(1.0, -prefer)).real) < 0:
            across = -across
        half = complex(box[2] - box[0], box[3] - box[1]) / 2
        reach = gap + abs(half.real * across.real) + abs(half.imag * across.imag)  # from the line to the box's middle
        for share in SHARES:
            for side in (across, -across):
                corner = start + share * (end - start) + reach * side - half - complex(*box[:2])
                if not (self.ink.under(padded(box, corner, WELL_CLEAR)) or _strays(parts, corner, start, end, others)):
                    return self._written(corner, content, size)
        further = [start + share * (end - start) for share in (SHARES[3:] if others else SHARES[:1])]
        return self.beside((start + end) / 2, content, size, gap, cmath.phase(across), others, further)

    def _parts(self, content: str, size: float) -> list[Box]:
        """Give the boxes of a label: around the whole, then around what stands on the line, and each index, alone."""
        text = Text(0j, content, size, "start", self._slanted)
        ends = [bounds(text)[0], *(bounds(text._replace(content=text.runs[: k + 1]))[2] for k in range(len(text.runs)))]
        reaches = (text_reach(text._replace(content=(run,))) for run in text.runs)
        return [bounds(text), *((a, low, b, high) for a, b, (low, high) in zip(ends, ends[1:], reaches, strict=False))]

    def _near(
        self, point: complex, parts: Sequence[Box], gap: float, prefer: float, others: Lines = (), space: float = 0.0
    ) -> complex:
        """Find the freest place beside a point; one that covers nothing is taken before any other."""
        best, cheapest, box = point, math.inf, parts[0]
        for reach in NEAR:
            if cheapest <= 0.8 * reach:
                break  # no place further off can be better
            for off, angle in _fan(prefer, DIRECTIONS):
                least = TURNED * off + 0.8 * reach
                if cheapest <= least:
                    break
                corner = _touching(point, box, gap + reach, angle)
                cost = self.ink.under(padded(box, corner)) + least
                if cost < cheapest:
                    cost += STRAY * (_strays(parts, corner, point, point, others) or self._joins(box, corner, space))
                if cost < cheapest:
                    best, cheapest = corner, cost
        return best

    def _joins(self, box: Box, corner: complex, space: float) -> bool:
        """Tell whether letters stand within `space` mm of a shifted label on its line: both would be read as one."""
        left, bottom, right, top = padded(box, corner, 0.0)
        return space > 0 and self.ink.under((left - space, bottom, right + space, top)) >= LETTERED

    def _led(
        self, spots: Spots, box: Box, gap: float, off: float, prefer: float, others: Lines = (), back: float = 0.0
    ) -> tuple[complex, complex, complex] | None:
        """Find a free place further off, and the leader to it, `back` from those before, `off` a point to its edge."""
        best, cheapest = None, math.inf
        clear = (0.7 * gap, others), (back, self._leaders)
        beginning = cache(
            lambda at: any(tied(abs(at - nearest(*line, at))) < by for by, near in clear for line in near)
        )
        for reach, spot in product(LED, spots):
            if cheapest <= reach:
                break
            for step, angle in _fan(prefer, LEAD_DIRECTIONS):
                if cheapest <= reach + 1.5 * TURNED * step:
                    break
                corner = _touching(spot, box, reach, angle)
                if self.ink.under(padded(box, corner)):
                    continue
                start = spot + cmath.rect(off, angle)
                if beginning(start):
                    continue
                end, letter = (_nearest(box, corner, start, by) for by in (CLEAR, 0.0))
                cost = reach + 1.5 * TURNED * step + OTHER * sum(_crosses((start, letter), far, gap) for far in others)
                cost += OTHER * any(_meeting((start, letter), leader) for leader in self._leaders)
                if cost >= cheapest:
                    continue
                crossed, run = self.ink.along(start, end)
                cost += CROSSED * crossed + MERGED * max(run - ACROSS, 0.0)
                if crossed < LETTERED and cost < cheapest:
                    cost += OTHER * self.ink.passed(start, end, gap)
                    cost += STRAY * any(_within(box, corner, other, gap + NEAR[-1]) for other in others)
                    if cost < cheapest and not any(_in_line((start, end), leader) for leader in self._leaders):
                        best, cheapest = (start, end, corner), cost
        return best


def free_side(spot: complex, lines: Iterable[Stroke], near: float) -> float:
    """Give the middle of the widest angle that the lines ending near a spot leave free; π/4 where none ends."""
    turns = sorted(
        cmath.phase(tied_spot(far - spot))
        for line in lines
        if isinstance(line, Line)
        for end, far in ((line.start, line.end), (line.end, line.start))
        if tied(abs(end - spot) - near) < 0
    )
    if not turns:
        return math.pi / 4
    gaps = [(b - a, a) for a, b in zip(turns, [*turns[1:], turns[0] + 2 * math.pi], strict=True)]
    wide, start = max(gaps, key=lambda gap: tied(gap[0]))
    return start + wide / 2


def _fan(prefer: float, count: int) -> Iterator[tuple[int, float]]:
    """Give directions to all sides, the preferred one first, with how many steps each is off it."""
    for turn in range(count):
        off = (turn + 1) // 2
        yield off, prefer + (off if turn % 2 else -off) * 2 * math.pi / count


def _touching(point: complex, box: Box, gap: float, angle: float) -> complex:
    """Shift a box so that its edge or corner is `gap` mm from a point, in some direction: a corner on the diagonals."""
    left, bottom, right, top = box
    half = complex(right - left, top - bottom) / 2
    direction = cmath.rect(1.0, angle)
    spread = direction / max(abs(direction.real), abs(direction.imag))
    centre = point + gap * direction + complex(half.real * spread.real, half.imag * spread.imag)
    return centre - half - complex(left, bottom)


def _strays(parts: Sequence[Box], corner: complex, start: complex, end: complex, others: Lines) -> bool:
    """Tell whether a shifted label is nearer to another line than to its own."""
    own = min(_off(box, corner, (start, end)) for box in parts[1:]) if others else 0.0
    return any(_within(box, corner, other, own) for box in parts[1:] for other in others)


def _in_line(leader: Segment, other: Segment) -> bool:
    """Tell whether two leaders are read as one: they run together, or begin back to back at marks that nearly touch."""
    (start, end), (first, last) = leader, other
    if abs(start - first) < BACK and abs(cmath.phase((end - start) / ((first - last) or 1.0))) < ASTRAIGHT:
        return True
    return merging(leader, (2 * first - last, last))


def _meeting(leader: Segment, other: Segment) -> bool:
    """Tell whether two leaders come so near each other at a label that it is either's."""
    return min(abs(leader[1] - nearest(*other, leader[1])), abs(other[1] - nearest(*leader, other[1]))) < MEETING


def _crosses(leader: Segment, other: Segment, gap: float) -> bool:
    """Tell whether a leader crosses another line, or goes from where it begins towards another point that is near."""
    near = abs((spot := other[0]) - nearest(*leader, spot))
    return crossing(leader, other) if spot != other[1] else tied(near - min(2 * gap, abs(spot - leader[0]))) < 0


def _within(box: Box, corner: complex, line: Segment, far: float) -> bool:
    """Tell whether a line is nearer than `far` mm to a shifted box: most are not even to the circle around it."""
    left, bottom, right, top = padded(box, corner, 0.0)
    centre, radius = complex(left + right, bottom + top) / 2, abs(complex(right - left, top - bottom)) / 2
    return abs(centre - nearest(*line, centre)) - radius < far and _off(box, corner, line) < far


def _off(box: Box, corner: complex, line: Segment) -> float:
    """Give how far a line is from a shifted box that it does not cross, mm."""
    left, bottom, right, top = padded(box, corner, 0.0)
    corners = (complex(x, y) for x in (left, right) for y in (bottom, top))
    pairs = [(spot, nearest(*line, spot)) for spot in corners] if line[0] != line[1] else []
    pairs += [(end, _nearest(box, corner, end, 0.0)) for end in line]
    return tied(min(abs(spot - other) for spot, other in pairs))


def _nearest(box: Box, shift: complex, point: complex, by: float = CLEAR) -> complex:
    """Give the point of a shifted box, a little widened, that is nearest to some point."""
    left, bottom, right, top = padded(box, shift, by)
    return complex(min(max(point.real, left), right), min(max(point.imag, bottom), top))
