"""Primary links: positions of a crank or a pushed slider, plans that start from them (начальные звенья)."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

import numpy as np
import numpy.typing as npt

from geometry.board import Reading
from plans.linkage import leads
from plans.linkage.plan import Image, Plan, Turning, Vector, heading
from plans.model.mechanism import CRANK, FRAME, SLIDER, Mechanism, Slide
from plans.model.motion import Complexes, Floats, Pace, Rates, rates_at
from plans.scene.units import within
from plans.words.words import Message, because

_INT64 = 2**62  # numerators of whole turns stay exact below this


@dataclass(frozen=True, eq=False, repr=False)
class CrankPositions:
    """Crank positions: angles phi, rad, that go on from each other, and the crank's unit directions."""

    phi: Floats
    directions: Complexes
    rates: Rates | None = None  # of the crank in each of them; None: those of its drive in all

    def __len__(self) -> int:
        return len(self.phi)

    @cached_property
    def headings(self) -> Floats:
        """The crank angles reduced to (-pi, pi]."""
        return heading(self.directions)

    def part(self, chosen: slice | Sequence[int]) -> CrankPositions:
        """Give some of the positions, in the order asked for."""
        rates = None if self.rates is None else self.rates.part(chosen)
        part = CrankPositions(self.phi[chosen], self.directions[chosen], rates)
        part.__dict__["headings"] = self.headings[chosen]  # reduced once for the whole turn
        return part

    @property
    def times(self) -> Floats | float:
        """The time that each of even positions takes, in that of the first."""
        return 1.0 if self.rates is None else self.rates.times

    def paced(self, pace: Pace | None) -> CrankPositions:
        """Give the same positions, passed at another pace; None: at that of the drive."""
        return self if pace is None else replace(self, rates=rates_at(pace, self.phi))


def even(start: Fraction, count: int, sense: int) -> CrankPositions:
    """Divide a turn into `count` equal steps from `start` degrees, in the sense +1 or -1 of rotation.

    >>> even(Fraction(0), 4, +1).directions.tolist()
    [(1+0j), 1j, (-1+0j), -1j]
    """
    start = within(start)
    denominator = start.denominator * count
    first, step = start.numerator * count, sense * 360 * start.denominator
    phi = np.radians(float(start)) + sense * (2 * np.pi / count) * np.arange(count)
    if abs(first) + 720 * denominator < _INT64:
        return CrankPositions(phi, directions(first + step * np.arange(count, dtype=np.int64), denominator))
    return from_direction(complex(directions_of([start])[0]), float(np.radians(float(start))), count, sense)


def divided(begin: Fraction, end: Fraction, steps: int, unit: float) -> CrankPositions:
    """Divide the stroke of a slide, m, into equal steps: one position more than steps, in units of `unit` m.

    >>> divided(Fraction(1, 10), Fraction(5, 10), 4, 2.0).phi.tolist()
    [0.05, 0.1, 0.15, 0.2, 0.25]
    """
    ways = [begin + (end - begin) * k / steps for k in range(steps + 1)]
    phi = np.array([float(way) for way in ways]) / unit
    return CrankPositions(phi, np.exp(1j * phi))


def listed(angles: Sequence[Fraction]) -> CrankPositions:
    """Take crank angles in degrees as the scene lists them, less the whole turns that they have in common.

    Of a list that spans more than a turn each angle is taken within one.

    >>> np.degrees(listed([Fraction(3950), Fraction(3970)]).phi).round(9).tolist()
    [350.0, 370.0]
    """
    least = min(angles, key=abs, default=Fraction(0))
    wide = max(angles, default=least) - min(angles, default=least) > 360
    near = [within(angle) if wide else angle - least + within(least) for angle in angles]
    return CrankPositions(np.radians(np.array([float(angle) for angle in near])), directions_of(near))


def from_direction(first: complex, phi: float, count: int, sense: int) -> CrankPositions:
    """Divide a turn from a crank direction that a construction has found."""
    whole = even(Fraction(0), count, sense)
    return CrankPositions(phi + whole.phi, first * whole.directions)


def directions_of(angles: Sequence[Fraction]) -> Complexes:
    """Give unit directions of angles in degrees, each reduced exactly."""
    reduced = [angle % 360 for angle in angles]
    octants = np.array([int(angle // 45) for angle in reduced], dtype=np.int64)
    rest = [angle % 45 if octant % 2 == 0 else 45 - angle % 45 for angle, octant in zip(reduced, octants, strict=True)]
    return _in_octants(octants, np.array([float(angle) for angle in rest]))


def directions(numerators: npt.NDArray[np.int64], denominator: int) -> Complexes:
    """Give unit directions of the angles numerators/denominator degrees.

    Reduction to the first octant is exact, so quarter turns are exactly 1, 1j, -1, -1j and dead centres are hit.
    """
    eighth = 45 * denominator
    octants, rest = np.divmod(numerators % (8 * eighth), eighth)
    rest = np.where(octants % 2 == 0, rest, eighth - rest)
    return _in_octants(octants, rest / denominator)


def _in_octants(octants: npt.NDArray[np.int64], degrees: Floats) -> Complexes:
    """CrankPositions angles of the first octant, measured from its nearer axis, into directions of all eight."""
    angle = degrees * (np.pi / 180)
    near, off = np.cos(angle), np.sin(angle)
    swapped = (octants % 4 == 1) | (octants % 4 == 2)
    x, y = np.where(swapped, off, near), np.where(swapped, near, off)
    return np.where((octants >= 2) & (octants <= 5), -x, x) + 1j * np.where(octants >= 4, -y, y)


class Primary(ABC):
    """The constructions of one kind of primary link, on which the first group hangs."""

    free: str  # the given mark that takes another value in each position

    @abstractmethod
    def values(self, mechanism: Mechanism, turn: CrankPositions) -> Complexes:
        """Give the values of that mark, (N,)."""

    @abstractmethod
    def ends(self, mechanism: Mechanism, turn: CrankPositions) -> Complexes:
        """Give the places of its end, (N,) m, known where nothing is assembled too."""

    @abstractmethod
    def positions(self, mechanism: Mechanism, turn: CrankPositions) -> Plan:
        """Start the plan of positions."""

    @abstractmethod
    def velocities(self, plan: Plan, rates: Rates) -> None:
        """Start the velocity plan."""

    @abstractmethod
    def accelerations(self, plan: Plan, rates: Rates) -> None:
        """Start the acceleration plan."""

    @abstractmethod
    def vectors(self, mechanism: Mechanism) -> Iterable[Vector]:
        """Tell the vectors that its plans must have, beside those of its points."""


class Crank(Primary):
    """The crank on the frame: the primary link that a hinge of the frame carries, and its plans (кривошип)."""

    free = "φ"

    def values(self, mechanism: Mechanism, turn: CrankPositions) -> Complexes:
        """Give its directions, (N,)."""
        return turn.directions

    def ends(self, mechanism: Mechanism, turn: CrankPositions) -> Complexes:
        """Give the places of its end, (N,) m."""
        drive = mechanism.drive
        points = mechanism.links[drive.link].points
        arm = abs(points[drive.end] - points[drive.pivot])
        return np.asarray(mechanism.links[FRAME].points[drive.pivot] + arm * turn.directions)

    def positions(self, mechanism: Mechanism, turn: CrankPositions) -> Plan:
        """Start a plan of positions: the fixed hinge, the crank circle and the crank's end at every angle."""
        plan = Plan("positions", mechanism)
        drive, points = mechanism.drive, mechanism.links[mechanism.drive.link].points
        pivot = plan.point(drive.pivot)
        lead = points[drive.end] - points[drive.pivot]
        circle = plan.board.arc(f"{drive.pivot}{drive.end}", pivot, abs(lead), because("crank_circle"))
        angles = plan.board.given(self.free, turn.directions, because("crank_directions"))
        end = plan.name(drive.end, plan.board.divide(drive.end, circle, angles, because("divided")))
        arm = plan.board.join(f"{drive.pivot}{drive.end}", pivot, end, because("link", link=drive.link))
        plan.images[drive.link] = Image(pivot, arm, points[drive.pivot], lead)
        return plan

    def velocities(self, plan: Plan, rates: Rates) -> None:
        """Lay off from the pole the velocity of the crank's end, square to the crank."""
        drive = plan.mechanism.drive
        base, arm = plan.positions.images[drive.link], plan.carry(plan.arm(drive.link))
        part = plan.board.turn(f"v_{drive.end}", arm, 1j * rates.omega, because("crank_velocity"))
        tip = plan.board.lay_off(plan.letter(drive.end), plan.pole, part, because("crank_end_velocity"))
        end = plan.name(drive.end, tip)
        relative = plan.board.join(f"{plan.pole.name}{end.name}", plan.pole, end)
        plan.images[drive.link] = Image(plan.pole, relative, base.at, base.span)
        plan.readings[drive.link] = Reading(arm, relative)

    def accelerations(self, plan: Plan, rates: Rates) -> None:
        """Lay off from the pole the normal and the tangential acceleration of the crank's end."""
        drive = plan.mechanism.drive
        base = plan.positions.images[drive.link]
        normal = leads.normal(plan, drive.link, plan.pole, (drive.pivot, drive.end))
        arm = leads.arm(plan, drive.link)
        why = because("crank_tangential") if np.any(rates.epsilon) else because("even")
        part = plan.board.turn(f"a^t_{drive.end}", arm, 1j * rates.epsilon, why)
        tip = plan.board.lay_off(plan.letter(drive.end), normal, part, because("crank_end_acceleration"))
        end = plan.name(drive.end, tip)
        whole = plan.board.join(f"{plan.pole.name}{end.name}", plan.pole, end)
        plan.images[drive.link] = Image(plan.pole, whole, base.at, base.span)
        plan.readings[drive.link] = Reading(arm, part)

    def vectors(self, mechanism: Mechanism) -> Iterable[Vector]:
        """Tell the vectors of its plans: its end turns about its fixed hinge."""
        yield Turning(mechanism.drive.link, mechanism.drive.pivot, mechanism.drive.end)


class Slider(Primary):
    """A slider that is pushed along the frame: a ram, the rod of a cylinder that stands still (ползун)."""

    free = "s"

    def values(self, mechanism: Mechanism, turn: CrankPositions) -> Complexes:
        """Give its ways along the guide, (N,) m, as vectors; the circle of all ways is cut half a turn from nothing."""
        ways = mechanism.drive.unit * (turn.phi - 2 * np.pi * np.round(turn.phi / (2 * np.pi)))
        return np.asarray(ways * pushed(mechanism).way(FRAME).direction)

    def ends(self, mechanism: Mechanism, turn: CrankPositions) -> Complexes:
        """Give the places of its point, (N,) m."""
        slide = pushed(mechanism)
        on, line = slide.on_slider, slide.way(FRAME)
        left = ((mechanism.links[slide.slider].points[slide.point] - on.through) / on.direction).imag
        return np.asarray(line.through + 1j * left * line.direction + self.values(mechanism, turn))

    def positions(self, mechanism: Mechanism, turn: CrankPositions) -> Plan:
        """Start a plan of positions: the guide, and the way of the slider's point laid off on it in every position."""
        plan, slide = Plan("positions", mechanism), pushed(mechanism)
        board, way = plan.board, slide.way(FRAME)
        along, link = leads.direction(plan, slide, FRAME), mechanism.drive.link
        start = plan.place(FRAME, way.through, f"K{link}")
        left = leads.offset(plan, slide, link, slide.point)
        if left:
            step = board.turn(f"h{link}", along, 1j * left, because("offset"))
            start = board.lay_off(f"K{link}'", start, step, because("line_offset"))
        ways = board.given(self.free, self.values(mechanism, turn), because("stroke_ways"))
        end = plan.name(slide.point, board.lay_off(slide.point, start, ways, because("stroke_divided")))
        pin = mechanism.links[link].points[slide.point]
        plan.images[link] = Image(end, along, pin, slide.way(link).direction)
        return plan

    def velocities(self, plan: Plan, rates: Rates) -> None:
        """Lay off from the pole the velocity of the slider, along its leads."""
        unit = plan.mechanism.drive.unit
        _pushed_on(plan, "v", unit * np.asarray(rates.omega), (because("stroke_speed"), because("slider_velocity")))

    def accelerations(self, plan: Plan, rates: Rates) -> None:
        """Lay off from the pole the acceleration of the slider, along its leads."""
        unit = plan.mechanism.drive.unit
        why = because("stroke_acceleration") if np.any(rates.epsilon) else because("even_stroke")
        _pushed_on(plan, "a", unit * np.asarray(rates.epsilon), (why, because("slider_acceleration")))

    def vectors(self, mechanism: Mechanism) -> Iterable[Vector]:
        """Tell no vectors of its plans beside those of its points: it does not turn."""
        yield from ()


PRIMARIES: Mapping[str, Primary] = {CRANK: Crank(), SLIDER: Slider()}


def pushed(mechanism: Mechanism) -> Slide:
    """Give the slide that is pushed along."""
    slide = mechanism.drive.guide
    assert slide is not None  # it is of the kind of primary link
    return slide


def _pushed_on(plan: Plan, symbol: str, size: Floats, why: tuple[Message, Message]) -> None:
    """Lay off from the pole what the drive gives the slider, which does not turn."""
    slide, base = pushed(plan.mechanism), plan.positions.images[plan.mechanism.drive.link]
    along = plan.carry(leads.direction(plan, slide, FRAME))
    by = size.astype(complex) if size.ndim else complex(size)
    part = plan.board.turn(f"{symbol}_{slide.point}", along, by, why[0])
    end = plan.name(slide.point, plan.board.lay_off(plan.letter(slide.point), plan.pole, part, why[1]))
    plan.images[plan.mechanism.drive.link] = Image(end, None, base.at, base.span)
