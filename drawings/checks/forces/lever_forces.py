"""The self-check of what hangs on the lever: its forces at their images, its rods and stand (проверка рычага)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations
from typing import NamedTuple

import numpy as np

from drawings.checks.forces.drawn_lines import DrawnLines
from drawings.checks.forces.laid_scheme import FINE, Arrow, LaidScheme
from drawings.checks.forces.scheme_forces import ASKEW, Floor
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.letters import NEAREST, along
from drawings.checks.standing import stands
from drawings.checks.wrong import Wrong, on
from drawings.measure.measured import MeasuredPoint
from plans.checks.force_bill import ActingCouple, ActingForce, ForceBill
from plans.checks.force_expected import ExpectedForces
from plans.forces.primary import BALANCING, DRIVING
from plans.model.kinetostatics import NOTHING
from plans.model.mechanism import FRAME

PLAN = "lever"
POLE = "p"
SHORT = 0.5  # mm: a shorter line is not drawn
FAR = 4 * 26.0  # mm: a force stands at its image, or further on along its line where others stand: four lengths at most


class LeverForces(NamedTuple):
    """A lever on its sheet, with the forces that hang on it by analysis, and its images by their letters."""

    strokes: FigureStrokes
    points: Sequence[MeasuredPoint]
    bills: Sequence[ForceBill]
    letters: Mapping[str, str]  # of the images of points
    floor: Floor
    vectors: Sequence[tuple[str, str]] = ()  # of the velocity plan, by the names of their ends

    def faults(self) -> Iterator[Wrong]:
        """Hold every image, every rod from the pole, the stand, and every force at its image."""
        laid = self._laid()
        seen = {one.name for one in self.points}
        for point, letter in self.letters.items():
            speed = complex(self._expected.motion.points[point].v[self._expected.k])
            if abs(speed) > 0 and letter not in seen and point not in self._expected.mechanism.links[FRAME].points:
                yield on("missing_on", PLAN, name=letter)
        yield from self._rods(laid)
        arrows, due = list(laid.arrows), list(self._due())
        least = NOTHING * max((abs(image) for _, image in due), default=0.0)
        fit = [
            {one: self._far(force, one) for one in self._fitting(force, laid.on(image), arrows)} for force, image in due
        ]
        found = _matched([[one for one, far in own.items() if far <= NEAREST] for own in fit], {})
        lettered = set(found)
        found = _matched([list(own) for own in fit], found)
        yield from (on("letter", PLAN, name=due[k][0].name) for k in found if k not in lettered)
        for k, (force, image) in enumerate(due):
            if k not in found and abs(force.value) > self.floor.force and abs(image) > least:
                yield on("missing_on", PLAN, name=force.name)
        yield from (on("stranger_on", PLAN, name="→") for one in arrows if one not in found.values())
        yield from self._strays(laid)

    def _strays(self, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold that each line joins images, is of the stand of the pole, or goes with a force or an arm."""
        drawn = DrawnLines(self.strokes)
        spots = [laid.on(0j), *(one.at for one in self.points)]
        ways = [*((one.tip, one.way) for one in laid.arrows), *drawn.arms()]
        own = [drawn.along(*way) for way in ways]
        own += [drawn.joining(spots), *(one.own for one in stands(drawn.segments, spots[0]))]
        yield from drawn.strays(PLAN, np.asarray(np.any([drawn.none, *own], axis=0)))

    def _far(self, force: ActingForce, arrow: Arrow) -> float:
        """Give how far the letter of a force is from an arrow, mm."""
        return self.strokes.far(self.floor.letter(force.name), along(arrow.start, arrow.tip))

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
            for couple in (one for one in bill.couples if not self._paired(one.name)):
                yield from self._halves(couple, bill)
            if bill.group is None and self._expected.mechanism.drive.ram is None:
                driving = bill.driving or self._by_moment(bill)
                yield driving, -1j * bill.speed(driving.link, driving.at)

    def _paired(self, name: str) -> bool:
        """Tell whether a couple is the moment of a pair, or of the drive: neither hangs on the lever."""
        loads = {one.name for one in self._expected.loading.moments}
        return name == BALANCING or (name not in loads and name[2:].replace(",", "").isdigit())

    def _by_moment(self, bill: ForceBill) -> ActingForce:
        """Give the force at the crank's end that has the balancing moment."""
        drive, k = self._expected.mechanism.drive, self._expected.k
        crank = bill.place(drive.end) - bill.place(drive.pivot)
        value = 1j * float(self._expected.found.balancing.moment[k]) / crank.conjugate()
        return ActingForce(DRIVING, drive.link, bill.place(drive.end), value)

    def _halves(self, couple: ActingCouple, bill: ForceBill) -> Iterator[tuple[ActingForce, complex]]:
        """Give both forces of a couple, at the points that its letter names; where it has none, at any two."""
        head = self.floor.letter(couple.name)
        start, end = next((line for line in self._lines(couple.link) if self._lettered(head, line)), ("", ""))
        omega = np.abs(self._expected.motion.links[couple.link].omega)
        turning = bool(omega[self._expected.k] > NOTHING * np.nanmax(omega, initial=0.0))
        if not start and turning and abs(couple.moment) > self.floor.moment:
            yield ActingForce(couple.name, couple.link, 0j, self.floor.force * 2 + abs(couple.moment)), 1 + 0j
        if start:
            arm = bill.place(end) - bill.place(start)
            carrier = self._carrier(couple.link, (start, end), bill)
            for name, value in (
                (end, 1j * couple.moment / arm.conjugate()),
                (start, -1j * couple.moment / arm.conjugate()),
            ):
                place, written = bill.place(name), f"{couple.name}/{start}{end}"
                yield ActingForce(written, couple.link, place, value), -1j * bill.speed(carrier, place)

    def _carrier(self, link: int, line: tuple[str, str], bill: ForceBill) -> int:
        """Give the link that two points are taken of: of those that turn with the couple's, whose images are there."""
        turning, pole = [link], self._laid().on(0j)
        for own in turning:  # links that slide in one another turn alike: the list grows by those that are met
            slides = self._expected.mechanism.slides
            met = [other for one in slides for other in (one.slider, one.owner) if own in (one.slider, one.owner)]
            turning += [one for one in dict.fromkeys(met) if one not in turning and one != FRAME]
        spots = [pole, *(one.at for one in self.points)]
        nearest = min(turning, key=lambda one: self._imaged(one, line, bill, spots))
        return nearest if self._imaged(nearest, line, bill, spots) <= FINE else link

    def _imaged(self, link: int, line: tuple[str, str], bill: ForceBill, spots: Sequence[complex]) -> float:
        """Give how far a line's ends, imaged as points of a link, are from the images that the lever has, mm."""
        ends = [self._laid().on(-1j * bill.speed(link, bill.place(name))) for name in line]
        return max(min(abs(spot - end) for spot in spots) for end in ends)

    def _lettered(self, head: str, line: tuple[str, str]) -> bool:
        return bool(self.strokes.labels.get(read(f"{head}/{''.join(line)}")))

    def _lines(self, link: int) -> Iterator[tuple[str, str]]:
        """Give the pairs of points that a couple of a link may stand at: any two, for a block carries no line."""
        yield from permutations(self._expected.motion.points, 2)

    def _fitting(self, force: ActingForce, spot: complex, arrows: Sequence[Arrow]) -> list[Arrow]:
        """Give the arrows that a force at a place of the paper may be."""
        if not abs(force.value) > 0:
            return []
        way = force.value / abs(force.value)
        held = (one for one in arrows if abs(one.way - way) <= ASKEW and one.aside(spot) <= FINE)
        return [one for one in held if min(abs(end - spot) for end in one.ends(spot)) <= FAR]

    def _rods(self, laid: LaidScheme) -> Iterator[Wrong]:
        """Hold that a line joins each image with the pole or with another one, and that legs run from the pole."""
        pole = laid.on(0j)
        spots = [pole, *(one.at for one in self.points)]
        for one in self.points:
            others = (spot for spot in spots if abs(spot - one.at) > FINE)
            if abs(one.at - pole) > SHORT and not any(self.strokes.joins(one.at, spot, FINE) for spot in others):
                yield on("line", PLAN)
        yield from (on("line_named", PLAN, name=name) for name in self._unjoined(laid))
        if not any(stands(DrawnLines(self.strokes).segments, pole)):
            yield on("stand", PLAN, name=POLE)

    def _unjoined(self, laid: LaidScheme) -> Iterator[str]:
        """Name the vectors of the velocity plan that no line of the turned one is, between images that it has."""
        known = {one.name: one.at for one in self.points} | {POLE: laid.on(0j)}
        for name in self.vectors:
            start, end = (known.get(one) for one in name)
            if start is None or end is None or not abs(end - start) > SHORT:
                continue
            if not self.strokes.joins(start, end, FINE):
                yield " ".join(name)


def _matched(fit: Sequence[Sequence[Arrow]], begun: Mapping[int, Arrow]) -> dict[int, Arrow]:
    """Give each force an arrow of its own of those that fit it, where there is one, beside those that have theirs."""
    owner = {one: k for k, one in begun.items()}

    def take(k: int, tried: set[Arrow]) -> bool:
        for one in fit[k]:
            if one not in tried:
                tried.add(one)
                if one not in owner or take(owner[one], tried):
                    owner[one] = k
                    return True
        return False

    for k in range(len(fit)):
        if k not in owner.values():
            take(k, set())
    return {k: one for one, k in owner.items()}
