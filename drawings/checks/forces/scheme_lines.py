"""The self-check of all lines of a loading scheme: stands with their hatching, corners, and no line beside (линии)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from functools import cached_property

import numpy as np

from drawings.checks.forces.drawn_lines import DrawnLines
from drawings.checks.forces.laid_scheme import FINE, LaidScheme
from drawings.checks.linkage.filled_corners import centred, corners_of
from drawings.checks.linkage.laid_poses import Flags
from drawings.checks.linkage.link_bars import hanging
from drawings.checks.rigid_corners import Corners
from drawings.checks.standing import Stand, stands
from drawings.checks.wrong import Wrong, on
from drawings.figures.linkage.masses import is_centre
from drawings.paper.strokes import Circle, Fill, Polyline
from drawings.symbols.symbols import DOUBLE, HINGE
from plans.checks.force_bill import ForceBill
from plans.model.machine import GEAR
from plans.model.mechanism import FRAME, Slide


class SchemeLines:
    """The lines of a scheme, each by what of the analysis it shows."""

    def __init__(self, plan: str, laid: LaidScheme, bill: ForceBill) -> None:
        self.plan, self.laid, self.bill = plan, laid, bill
        self.mechanism = bill.expected.mechanism

    def faults(self) -> Iterator[Wrong]:
        """Hold the stands, the corners, and that each line has its reason."""
        for name, spot in self._fixed:
            if not self._stands(spot):
                yield on("stand", self.plan, name=name)
        if self._corners().missing():
            yield on("rigid", self.plan)
        yield from self._drawn.strays(self.plan, self._known())

    @cached_property
    def _drawn(self) -> DrawnLines:
        return DrawnLines(self.laid.strokes)

    @cached_property
    def _fixed(self) -> list[tuple[str, complex]]:
        """The points that the frame holds, on paper: the pivot of the crank, the far ends of springs drawn whole."""
        drive, own = self.mechanism.drive, [name for link in self.bill.links for name in self._points(link)]
        found = [drive.pivot] if self.bill.group is None and drive.guide is None else []
        for spring in self.bill.expected.machine.springs:
            for k in (0, 1):
                moving, far = spring.links[k] in self.bill.links, spring.points[1 - k]
                if moving and spring.links[k] != FRAME == spring.links[1 - k] and far not in own:
                    found += [far] if self._reaches(self.laid.on(self.bill.place(far))) else []
        return [(name, self.laid.on(self.bill.place(name))) for name in dict.fromkeys(found)]

    def _points(self, link: int) -> dict[str, complex]:
        return dict(self.mechanism.links[link].points)

    def _reaches(self, spot: complex) -> bool:
        """Tell whether a spring is drawn as far as a place: a long one is not."""
        open_ = [one.points for one in self.laid.strokes.chains if not one.closed]
        return any(min(abs(one[0] - spot), abs(one[-1] - spot)) <= FINE for one in open_)

    def _stands(self, spot: complex) -> list[Stand]:
        return list(stands(self._drawn.segments, spot))

    def _corners(self) -> Corners:
        """Give the rigid corners of the links."""
        rings = list(self._rings())
        chains = [one for one in self.laid.strokes.chains if one.closed]
        slides = [one for one in self.mechanism.slides if one.slider in self.bill.links]
        blocks: dict[Slide, list[Polyline]] = {one: [] for one in self.mechanism.slides}
        blocks |= {one: [own for own in chains if centred(own, self._block(one))] for one in slides}
        due = [
            one
            for link in self.bill.links
            if link != FRAME
            for one in corners_of(self.mechanism, link, self._on, blocks)
        ]
        return Corners(due, list(self.laid.strokes.of(Fill)), rings, self._size(rings))

    def _rings(self) -> Iterator[Circle]:
        """Give the circles that corners begin beyond, those of mass centres with them."""
        return (one for one in self.laid.strokes.circles if one.style.width > 0 and one.style.fill != "none")

    def _size(self, rings: list[Circle]) -> float:
        """Give the factor of the sizes of symbols, by a hinge."""
        for name in (name for link in self.bill.links for name in self._points(link) if not is_centre(name)):
            spot = self.laid.on(self.bill.place(name))
            own = [one.radius for one in rings if abs(one.centre - spot) <= FINE]
            if name in self.mechanism.hinges and own:
                within = DOUBLE[1] / DOUBLE[0] * max(own)  # of a hinge of three; a mass centre is larger
                return max(own) / (DOUBLE[0] if min(own) <= within + FINE else HINGE)
        return 1.0

    def _on(self, link: int, own: complex) -> complex:
        return self.laid.on(self.bill.on(link, own))

    def _line(self, slide: Slide) -> tuple[complex, complex]:
        """Give a place on a slide's line on paper, and its unit direction."""
        own, way = slide.owner, slide.on_owner
        start, end = (self.bill.on(own, way.through + k * way.direction) for k in (0, 1))
        return self.laid.on(start), (end - start) / abs(end - start)

    def _block(self, slide: Slide) -> complex:
        at, way = self._line(slide)
        pin = self.laid.on(self.bill.place(slide.point))
        return at + way * ((pin - at) * way.conjugate()).real

    def _known(self) -> Flags:
        """Tell of each line whether it lies along what the analysis has, or belongs to a stand or a dimension."""
        drawn = self._drawn
        own = [drawn.along(spot, way) for spot, way in self._ways()]
        own += [stand.own for _, spot in self._fixed for stand in self._stands(spot)]
        own += [drawn.along(spot) for spot in self._held()]
        return np.asarray(np.any([drawn.none, drawn.dimensions(), *own], axis=0))

    def _ways(self) -> Iterator[tuple[complex, complex]]:
        """Give the lines of links, guides, arrows and arms: a place on each, its direction."""
        for link in self.bill.links:
            spots = [self.laid.on(self.bill.place(name)) for name in self._points(link)]
            yield from ((one, other - one) for one in spots for other in spots if abs(other - one) > FINE)
        for slide in self.mechanism.slides:
            if {slide.owner, slide.slider} & set(self.bill.links):
                at, way = self._line(slide)
                pin, block = self.laid.on(self.bill.place(slide.point)), self._block(slide)
                yield from ((at, way), (pin, 1j * way), (block, 1j * way))
                if slide.owner in self.bill.links and slide.owner != FRAME:
                    start, foot = (self._on(slide.owner, spot) for spot in hanging(self.mechanism, slide))
                    yield from [(start, foot - start)] if abs(foot - start) > FINE else []
        yield from ((one.tip, one.way) for one in self.laid.arrows)
        yield from self._drawn.arms()

    def _held(self) -> Iterator[complex]:
        """Give the places through which ties to mass centres run, and the lines of a wheel's drive."""
        for link in self.bill.links:
            body = self.bill.expected.machine.bodies.get(link)
            yield from [] if body is None else [self._on(link, body.centre)]
            yield from (self.laid.on(self.bill.place(name)) for name in self._points(link) if is_centre(name))
        how = self.bill.expected.machine.transmission
        if self.bill.group is None and how.kind == GEAR:
            shaft = self.bill.place(self.mechanism.drive.pivot)
            yield self.laid.on(shaft + cmath.rect(how.radius, how.at))
