"""The self-check of what hangs on the lever: its forces at their images, its rods and stand (проверка рычага)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks.forces.laid_scheme import FINE, Arrow, LaidScheme
from drawings.checks.forces.scheme_forces import ASKEW, Floor
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.labelled import NEAREST
from drawings.checks.wrong import Wrong, on
from drawings.measure.measured import MeasuredPoint
from plans.checks.force_bill import ActingForce, ForceBill
from plans.checks.force_expected import ExpectedForces
from plans.model.mechanism import FRAME

PLAN = "lever"
FAR = 4 * 26.0  # mm: a force stands at its image, or further on along its line where others stand: four lengths at most


class LeverForces(NamedTuple):
    """A lever on its sheet, with the forces that hang on it by analysis, and its images by their letters."""

    strokes: FigureStrokes
    points: Sequence[MeasuredPoint]
    bills: Sequence[ForceBill]
    letters: Mapping[str, str]  # of the images of points
    floor: Floor

    def faults(self) -> Iterator[Wrong]:
        """Hold every image, every rod from the pole, the stand, and every force at its image."""
        laid = self._laid()
        seen = {one.name for one in self.points}
        for point, letter in self.letters.items():
            speed = complex(self._expected.motion.points[point].v[self._expected.k])
            if abs(speed) > 0 and letter not in seen and point not in self._expected.mechanism.links[FRAME].points:
                yield on("missing_on", PLAN, name=letter)
        yield from self._rods(laid)
        arrows = list(laid.arrows)
        for force, image in self._due():
            one = self._arrow(force, laid.on(image), arrows)
            if one is not None:
                arrows.remove(one)
                if self.strokes.far(self.floor.letter(force.name), one.ends(laid.on(image))[1:]) > NEAREST:
                    yield on("letter", PLAN, name=force.name)
            elif abs(force.value) > self.floor.force and abs(image) > 0:
                yield on("missing_on", PLAN, name=force.name)
        if len(arrows) > 2 * sum(len(bill.couples) for bill in self.bills) + 1:
            yield on("stranger_on", PLAN, name="→")

    @property
    def _expected(self) -> ExpectedForces:
        return self.bills[0].expected

    def _laid(self) -> LaidScheme:
        """Place the lever on paper by its pole."""
        one = self.points[0]
        return LaidScheme(self.strokes, one.at - one.value / one.scale, one.scale)

    def _due(self) -> Iterator[tuple[ActingForce, complex]]:
        """Give the forces of the machine, but for reactions, with the turned velocities of their places, m/s."""
        for bill in self.bills:
            for force in bill.known:
                if not force.name.startswith("R_"):
                    yield force, -1j * bill.speed(force.link, force.at)

    def _arrow(self, force: ActingForce, spot: complex, arrows: Sequence[Arrow]) -> Arrow | None:
        if not abs(force.value) > 0:
            return None
        way = force.value / abs(force.value)
        fit = [
            one
            for one in arrows
            if abs(one.way - way) <= ASKEW
            and one.aside(spot) <= FINE
            and min(abs(end - spot) for end in one.ends(spot)) <= FAR
        ]
        letter = self.floor.letter(force.name)
        return min(fit, key=lambda one: self.strokes.far(letter, one.ends(spot)[1:]), default=None)

    def _rods(self, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold that a line ends at each image, and that legs run from the pole to a stand."""
        pole = laid.on(0j)
        for one in self.points:
            own = (line for line in self.strokes.lines if min(abs(line.start - one.at), abs(line.end - one.at)) <= FINE)
            if abs(one.at - pole) > NEAREST and not any(abs(line.end - line.start) > FINE for line in own):
                yield on("line", PLAN)
        radius = max((one.radius for one in self.strokes.circles if abs(one.centre - pole) <= FINE), default=0.0)
        ends = [end for line in self.strokes.lines for end in (line.start, line.end)]
        if sum(abs(abs(end - pole) - radius) <= FINE for end in ends) < 2:
            yield on("missing_on", PLAN, name="p")
