"""The self-check of the links on a loading scheme: points, bars, blocks, stands, guides, numbers (проверка звеньев)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from drawings.checks.forces.laid_scheme import FINE, LaidScheme
from drawings.checks.linkage.laid import within
from drawings.checks.linkage.link_bars import hanging
from drawings.checks.linkage.position_marks import is_led
from drawings.checks.wrong import Wrong, on
from drawings.figures.linkage.link_numbers import BESIDE
from drawings.figures.linkage.masses import is_centre
from drawings.figures.linkage.ties import nearest
from drawings.paper.strokes import Circle, Group, Line, Polyline, Text
from drawings.paper.walk import groups
from drawings.symbols.symbols import BLOCK, MASS
from plans.checks.force_bill import ForceBill
from plans.model.mechanism import FRAME, Slide
from plans.model.motion import Floats

HIDDEN = abs(complex(*BLOCK))  # mm of a bar that a block on it may hide
SHORT = 0.5  # mm: a shorter tie is not drawn


class SchemeLinks:
    """The links of a scheme as the analysis places them."""

    def __init__(self, plan: str, bill: ForceBill) -> None:
        self.plan, self.bill = plan, bill
        self.mechanism = bill.expected.mechanism

    @cached_property
    def points(self) -> dict[str, complex]:
        """The true places of the named points of the links, m."""
        names = (name for link in self.bill.links for name in self.mechanism.links[link].points)
        return {name: self.bill.place(name) for name in names}

    def faults(self, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold the points with their letters, the links between them, their numbers, and what they slide on."""
        for name, place in self.points.items():
            if not laid.has(laid.on(place)):
                yield on("differs_on", self.plan, name=name)
            elif not laid.strokes.lettered(name.replace("_", ""), [laid.on(place)]):
                yield on("letter", self.plan, name=name)
        for link in self.bill.links:
            yield from self._bars(link, laid)
            yield from self._number(link, laid)
        yield from self._masses(laid)
        for slide in self.mechanism.slides:
            if slide.slider in self.bill.links:
                yield from self._block(slide, laid)
        if self.bill.group is None and self.mechanism.drive.guide is None:
            yield from self._stand(laid.on(self.bill.place(self.mechanism.drive.pivot)), laid)

    def _bars(self, link: int, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold that lines join all points of a link, whichever of them they go between; a mass centre may be tied."""
        own, hinges = self.mechanism.links[link].points, self.mechanism.hinges
        spots = [laid.on(self.bill.place(name)) for name in own]
        tied = {k for k, name in enumerate(own) if is_centre(name) and name not in hinges and _ends_at(laid, spots[k])}
        ties = [{j for j, other in enumerate(spots) if self._joined(one, other, link, laid)} for one in spots]
        edge = {next((k for k in range(len(own)) if k not in tied), 0)}
        reached = set(edge)
        while edge:
            edge = set[int]().union(*(ties[k] for k in edge)) - reached
            reached |= edge
        yield from (on("line", self.plan) for k in range(len(own)) if k not in reached | tied)

    def _joined(self, start: complex, end: complex, link: int, laid: LaidScheme) -> bool:
        """Tell whether a line goes from one place to another, but for what symbols hide of it."""
        length = abs(end - start)
        if not length > 2 * FINE:
            return length <= 2 * FINE  # a scheme without a place has no length
        one, other = ((ends - start) / (end - start) for ends in laid.ends)
        along = np.maximum(np.abs(one.imag), np.abs(other.imag)) * length <= FINE
        inside = np.clip(np.sort(np.array([one.real, other.real])[:, along], axis=0), 0, 1)
        rounds = (one.radius for one in laid.strokes.circles if _between(start, end, one.centre))
        hidden = 2 * sum(rounds) + HIDDEN * sum(link in (one.slider, one.owner) for one in self.mechanism.slides)
        shown = _union(inside) * length
        return shown >= length - hidden - FINE

    def _number(self, link: int, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold that a link bears its number, beside it or by a leader that ends on it."""
        for group in groups((laid.strokes.group,)):
            match group:
                case Group((Circle() as circle, Text() as text, *_)) if text.plain == str(link):
                    dot = group.strokes[-1]
                    if not is_led(group):
                        continue
                    led = dot if isinstance(dot, Circle) and dot is not circle else None
                    spot, room = (circle.centre, circle.radius + BESIDE) if led is None else (led.centre, 0.0)
                    own = [laid.on(self.bill.place(name)) for name in self.mechanism.links[link].points]
                    if self._apart(link, spot, laid) <= room + HIDDEN / 2 + FINE or (led and within(own, spot)):
                        return
        yield on("link_number", self.plan, name=str(link))

    def _apart(self, link: int, spot: complex, laid: LaidScheme) -> float:
        """Give how far a place on paper is from a link."""
        own = [laid.on(self.bill.place(name)) for name in self.mechanism.links[link].points]
        far = [_nearest(one, other, spot) for one in own for other in own]
        for slide in self.mechanism.slides:
            way, at = self._line(slide, laid)
            if slide.owner == link:
                far.append(at + way * ((spot - at) * way.conjugate()).real)
                start, foot = (laid.on(self.bill.on(link, end)) for end in hanging(self.mechanism, slide))
                far.append(_nearest(start, foot, spot))
            if slide.slider == link:  # a block off its pin has a rod from there
                pin = laid.on(self.bill.place(slide.point))
                far.append(_nearest(pin, at + way * ((pin - at) * way.conjugate()).real, spot))
        return min(abs(one - spot) for one in far)

    def _line(self, slide: Slide, laid: LaidScheme) -> tuple[complex, complex]:
        """Give the unit direction of a slide, and a place on its line on paper."""
        own, way = slide.owner, slide.on_owner
        start, end = self.bill.on(own, way.through), self.bill.on(own, way.through + way.direction)
        return (end - start) / abs(end - start), laid.on(start)

    def _masses(self, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold the mass centres of the links that forces act at, and their ties to the links."""
        for link in self.bill.links:
            body = self.bill.expected.machine.bodies.get(link)
            if body is None or not body.mass:
                continue
            spot = laid.on(self.bill.on(link, body.centre))
            if not laid.has(spot):
                yield on("mass", self.plan, name=f"S{link}")
            elif self._apart(link, spot, laid) > max(MASS, SHORT) and not _ends_at(laid, spot):
                yield on("tie", self.plan, name=f"S{link}")

    def _block(self, slide: Slide, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold a slider's block on its line, its long side along it; and the axis of a guide that was taken away."""
        way, at = self._line(slide, laid)
        pin = laid.on(self.bill.place(slide.point))
        spot = at + way * ((pin - at) * way.conjugate()).real
        half = next((size for one in laid.strokes.chains if (size := _half_block(one, spot, way))), 0.0)
        axes = laid.strokes.through(spot, way, FINE)
        away = slide.owner not in self.bill.links
        if not half or (away and not any(min(abs(one.start - spot), abs(one.end - spot)) > half for one in axes)):
            yield on("guide", self.plan, name=str(slide.slider))

    def _stand(self, pivot: complex, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold the stand of the crank: a base that is square to its axis, and two legs from the hinge to it."""
        hinge = min((one.radius for one in laid.strokes.circles if abs(one.centre - pivot) <= FINE), default=0.0)
        for base in laid.strokes.lines:
            off = abs(abs(base.start - pivot) - abs(base.end - pivot))
            middle = (base.start + base.end) / 2 - pivot
            if off <= FINE and abs(middle) > hinge and _legs(base, pivot, laid) >= 2:
                return
        if FRAME not in self.bill.links:
            yield on("missing_on", self.plan, name=self.mechanism.drive.pivot)


def _nearest(start: complex, end: complex, spot: complex) -> complex:
    """Give the place of a line that is nearest to a place; of one without length its start."""
    return start if start == end else nearest(start, end, spot)


def _between(start: complex, end: complex, spot: complex) -> bool:
    """Tell whether a place is on the line from one place to another."""
    along = (spot - start) / (end - start)
    near = FINE / abs(end - start)
    return abs(along.imag) <= near and -near <= along.real <= 1 + near


def _union(pieces: Floats) -> float:
    """Give the length of what pieces of a line cover together; (2, N) where they begin and end."""
    covered, last = 0.0, 0.0
    for low, high in sorted(pieces.T.tolist()):
        covered += max(high - max(low, last), 0.0)
        last = max(last, high)
    return covered


def _legs(base: Line, pivot: complex, laid: LaidScheme) -> int:
    """Count the lines that run straight from a hinge to a base."""
    run = base.end - base.start
    feet = [(one.start, one.end) for one in laid.strokes.lines if one is not base]
    feet += [(end, start) for start, end in feet]
    return sum(
        abs(((end - base.start) / run).imag) * abs(run) <= FINE
        and 0 <= ((end - base.start) / run).real <= 1
        and abs(((pivot - start) * (end - start).conjugate()).imag) <= FINE * abs(end - start)
        and abs(start - pivot) < abs(end - pivot)
        for start, end in feet
        if start != end
    )


def _ends_at(laid: LaidScheme, spot: complex) -> bool:
    """Tell whether a line ends at a mass centre."""
    return any(min(abs(one.start - spot), abs(one.end - spot)) <= MASS + FINE for one in laid.strokes.lines)


def _half_block(one: Polyline, spot: complex, way: complex) -> float:
    """Give half the length of a closed chain about a place, longer along a direction than across it; 0 of another."""
    if not one.closed or len(one.points) < 4:
        return 0.0
    turned = np.array(one.points) / way
    low, high = complex(turned.real.min(), turned.imag.min()), complex(turned.real.max(), turned.imag.max())
    size, middle = high - low, (low + high) / 2 * way
    return size.real / 2 if abs(middle - spot) <= FINE and size.real > size.imag else 0.0
