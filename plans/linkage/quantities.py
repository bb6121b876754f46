"""Comparison of the two roads: every quantity by construction and by analysis, and the difference allowed (сравнение).

A difference is judged against the largest vector of its plan, for a true zero has no per cent. The allowed one is
derived: the construction's own error carried from step to step (geometry.precision), and the analytic solver's, whose
linear systems magnify a rounding by the condition of the Jacobian once for every order of derivative.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Reading, Span
from geometry.meet import EPS
from geometry.precision import condition, errors
from plans.analytic.kinematics import Analysis, output_rates
from plans.linkage.assembly import SketchError, margins
from plans.linkage.drafts import Drafts
from plans.linkage.ram import cylinder, length_of, ram_of, ways
from plans.linkage.study import EXTREMES, LinkageStudy
from plans.linkage.sweep import at_angles
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import ACCELERATIONS, ORDERS, POSITIONS, Extremes, Floats, Motion, numbers_of, stroke_rates
from plans.quantity import Comparison, Quantity, gap_numbers, pairs, plain
from plans.study import Study
from plans.words.words import Message, message, placed

SYMBOLS = ("s", "v", "a")
ROUNDINGS = 16.0  # of a distance by two places, each of a few roundings itself


def law(study: LinkageStudy, solved: Motion, kappa: Floats, order: int) -> Iterator[Quantity]:
    """Hold the law of the cylinder that drives against the distance of its points, and what that grows by."""
    ram, stated = ram_of(study.mechanism), stroke_of(study.mechanism, len(solved.phi))
    found, driving = length_of(study.mechanism, solved, order), cylinder(study.mechanism)
    # The crank's angle is known to a rounding of the length over the share of its turning that goes along the cylinder.
    arm = driving.arm
    blunt = np.maximum(arm, found[0]) / driving.lever(solved)
    for k, row in enumerate(found):
        expected = np.where(np.isnan(row), np.nan, stated[k])
        fastest = float(np.abs(stated[1]).max()) ** k / arm ** (k - 1)
        largest = max(float(np.nanmax(np.abs(expected), initial=0.0)), fastest)
        allowed = ROUNDINGS * EPS * (kappa * blunt) ** (k + 1) * largest
        named = ORDERS[k].plan, f"{SYMBOLS[k]}_{ram.foot}{ram.point}", ORDERS[k].point.unit
        yield Quantity.of(named, (expected, row), allowed, largest)


def stroke_of(mechanism: Mechanism, count: int) -> tuple[Floats, Floats, Floats]:
    """Give what a scene says of its cylinder at so many even places of the stroke: length m, m/s, m/s2, (N,) each."""
    ram = ram_of(mechanism)
    lengths = np.linspace(ram.begin, ram.end, count)
    return lengths, *stroke_rates(mechanism.drive, lengths, ram.speed, ram.acceleration)


# A Newton step or a linear solution at rest leaves a few roundings of the largest term in each of its rows.
ANALYSIS = 8.0

# A difference allowed beyond this share of the plan's largest would let a drawn error through: except in positions that
# are named as too near a dead centre it is not, however bad the conditions.
MOST_ALLOWED = 1e-6
MISTAKEN = 1e-3  # of the farthest point: far above what rounding does at a dead centre, where assemblies meet
NOT_GRADED = 600.0  # kappa of a notch of 6 minutes of arc: 0.01 mm in a length moves such a point by 6 mm

EXTREME_NAMES = ("φ_start", "φ_end", "H", "θ")


@dataclass(frozen=True, eq=False, repr=False)
class MotionComparison(Comparison):
    """The motion of a linkage by both roads."""

    construction: Motion
    analysis: Motion
    findings: tuple[Quantity, ...]
    kappa: Floats  # condition of the scaled Jacobian at every position
    road: Analysis  # by which the analysis was made

    @property
    def apart(self) -> Message:
        """Say in what the two roads differ most: in the places themselves, they assemble the mechanism in two ways."""
        if self.foremost.plan == POSITIONS.plan:
            return message("check.assembly", name=self.foremost.name)
        return super().apart


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare(study: LinkageStudy, order: int = 2) -> MotionComparison:
    """Compare construction and analysis over all positions of a study, up to an order of derivative."""
    drawn = study.motion(order)
    road = road_of(study)
    solved = road.motion(study.turn.phi, order)
    kappa = road.conditions(solved)
    drafts = study.drafts()
    findings: list[Quantity] = []
    for k in range(order + 1):
        findings += _points(study, drafts, k, drawn, solved, kappa)
        findings += _links(drafts, k, drawn, solved, kappa)
    if study.mechanism.drive.ram is not None:
        findings += law(study, solved, kappa, order)
    return MotionComparison(drawn, solved, cap(study, findings), kappa, road)


def road_of(study: LinkageStudy) -> Analysis:
    """Take the analytic road of a study's mechanism, at the study's pace."""
    return Analysis(study.mechanism, first=study.first, looks=study.looks.phi, pace=study.pace)


def comparison_of(study: "Study") -> MotionComparison:
    """Compare what a scene asks for of its motion."""
    found = compare(study.of(LinkageStudy), max(numbers_of(study.plans), default=0))
    return compare_extremes(study.of(LinkageStudy), found) if "extremes" in study.plans else found


def notches(study: LinkageStudy, drafts: Drafts | None = None) -> Floats:
    """Give kappa of every group's meeting over the positions, the scene's or others, (groups, positions)."""
    drafts = drafts or study.drafts()
    _, marks = margins(drafts.positions, study.groups, study.sweep.sides)
    count = len(drafts.turn)
    return np.array([np.broadcast_to(condition(mark), count) for mark in marks]).reshape(len(marks), count)


def cap(study: LinkageStudy, findings: Sequence[Quantity], drafts: Drafts | None = None) -> tuple[Quantity, ...]:
    """Allow no more than MOST_ALLOWED of the largest, or of a value larger still, where the construction is sharp."""
    sharp = ~(notches(study, drafts).max(axis=0, initial=1.0) >= NOT_GRADED)
    sizes = (np.fmax(finding.largest, np.abs(finding.analysis)) for finding in findings)  # all but in a jam
    pairs = zip(findings, (np.where(sharp, MOST_ALLOWED * size, np.inf) for size in sizes), strict=True)
    return tuple(finding._replace(allowed=np.minimum(finding.allowed, most)) for finding, most in pairs)


def compare_extremes(study: LinkageStudy, comparison: MotionComparison) -> MotionComparison:
    """Add the output's extreme positions, their crank angles, stroke and overlap, found by both roads."""
    found, theirs = study.extreme_positions, comparison.road.extremes(study.output)
    ours = None if found is None else found.extremes
    extremes = ours or theirs
    if extremes is None:
        return comparison
    values = [np.full(4, np.nan) if road is None else _stated(road) for road in (ours, theirs)]
    size = max(abs(reach) for reach in extremes.reach) if extremes.sliding else np.pi
    largest = np.array([2 * np.pi, 2 * np.pi, max(size, extremes.stroke), 2 * np.pi])
    # An extreme's crank angle is where a velocity is zero: its rounding is the velocity's over the acceleration's.
    allowed = np.minimum(ANALYSIS * EPS * float(np.nanmax(comparison.kappa, initial=1.0)) ** 2, MOST_ALLOWED) * largest
    apart = np.abs(values[0] - values[1])
    apart[:2] = np.abs(np.angle(np.exp(1j * apart[:2])))
    if (apart > allowed).any():
        flat = _flat(study, comparison, extremes)
        allowed[[0, 1, 3]] = np.minimum(allowed[0] * np.append(flat, flat.sum()), MOST_ALLOWED * 2 * np.pi)
    units = ("rad", "rad", "m" if extremes.sliding else "rad", "rad")
    added = tuple(
        Quantity("extremes", *named, values[0][k], values[1][k], apart[k], allowed[k], float(largest[k.start]))
        for k, named in zip(map(slice, range(4), range(1, 5)), zip(EXTREME_NAMES, units, strict=True), strict=True)
    )
    return replace(comparison, findings=comparison.findings + added)


def _flat(study: LinkageStudy, comparison: MotionComparison, extremes: Extremes) -> Floats:
    """Tell how many times less the output's acceleration is in each extreme than its greatest velocity tells."""
    road, solved, omega = comparison.road, comparison.analysis, abs(study.mechanism.drive.omega)
    there = road.around(np.append(solved.phi[0], extremes.phi))
    speeds, rises = (output_rates(study.mechanism, study.output, motion) for motion in (solved, there))
    return np.asarray(np.maximum(1.0, omega * np.nanmax(np.abs(speeds[1])) / np.abs(rises[2][1:])))


def _stated(found: Extremes) -> Floats:
    return np.array([*found.phi, found.stroke, found.overlap])


def _points(
    study: LinkageStudy, drafts: Drafts, order: int, drawn: Motion, solved: Motion, kappa: Floats
) -> Iterator[Quantity]:
    names = [name for name in drawn.points if name not in study.mechanism.links[FRAME].points]
    pairs = [(drawn.points[n][order], solved.points[n][order]) for n in names]
    largest = largest_of([np.abs(ours) for ours, _ in pairs])
    plan, letters = drafts.plan(order), ORDERS[order]
    marks = [plan.point(name) for name in names]
    bounds = errors(*marks)
    for name, mark, (ours, theirs) in zip(names, marks, pairs, strict=True):
        allowed = with_analysis(bounds[mark].place, order, kappa, largest)
        shown = Span(plan.pole, mark) if order else mark
        named = letters.plan, f"{letters.point.symbol}_{name}", letters.point.unit
        yield Quantity.of(named, (ours, theirs), allowed, largest, shown)


def _links(drafts: Drafts, order: int, drawn: Motion, solved: Motion, kappa: Floats) -> Iterator[Quantity]:
    letters = ORDERS[order]
    pairs = {n: (drawn.links[n][order], solved.links[n][order]) for n in drawn.links}
    most = largest_of([np.abs(ours) for ours, _ in pairs.values()])
    largest = np.pi if order == 0 else max(most, _slowest(drawn, order))
    for number, (ours, theirs) in pairs.items():
        allowed = with_analysis(_turn_bound(drafts, order, number), order, kappa, largest)
        named, read = (letters.plan, f"{letters.link.symbol}_{number}", letters.link.unit), drafts.plan(order).readings
        quantity = Quantity.of(named, (ours, theirs), allowed, largest, read.get(number))
        yield quantity if order else quantity._replace(difference=np.abs(np.angle(np.exp(1j * (ours - theirs)))))


def _slowest(drawn: Motion, order: int) -> float:
    """Give the rate at which the plan's largest vector turns the mechanism's whole size: less is no large rate.

    Links that only translate have rates that are truly zero, and no per cent of themselves.
    """
    places = np.array([motion.r for motion in drawn.points.values()])
    size = largest_of([np.abs(places - places[0])])
    return largest_of([np.abs(motion[order]) for motion in drawn.points.values()]) / size if size > 0 else 0.0


def _turn_bound(drafts: Drafts, order: int, number: int) -> Floats:
    """Bound the error of an angle or a rate read from a vector: the vector's own error over the arm's length."""
    plan = drafts.plan(order)
    if order == 0:
        arm = plan.arm(number)
        return np.asarray(errors(arm)[arm].place / np.abs(np.asarray(arm.point)) + 2 * EPS)
    if number not in plan.readings:
        return np.zeros(1)
    return read_bound(plan.readings[number])


def read_bound(read: Reading) -> Floats:
    """Bound the error of a rate or a ratio: of the vector that it is read from, and of the arm."""
    bounds, (arm, turning) = errors(*read), read
    size, part = np.abs(np.asarray(arm.point)), np.abs(np.asarray(turning.point))
    return np.asarray((bounds[turning].place + part / size * bounds[arm].place) / size + 4 * EPS * part / size)


def with_analysis(drawn: Floats, order: int, kappa: Floats, largest: float) -> Floats:
    """Add the analytic road's share: kappa once for the position and once more for every derivative."""
    return np.asarray(drawn + ANALYSIS * EPS * kappa ** (order + 1) * largest)


def largest_of(sizes: Sequence[Floats]) -> float:
    """Give the largest of some sizes over all positions, gaps left out."""
    return max([float(np.nanmax(size)) for size in sizes if np.isfinite(size).any()], default=0.0)


class MotionNumbers(NamedTuple):
    """The motion of a linkage by one road, its extremes where they are told, and the orders that are."""

    title: str
    datum: complex
    motion: Motion
    extremes: Extremes | None
    orders: Sequence[int]
    road: Analysis | None = None  # by which it was found, if not by construction
    ways: Floats | None = None  # m: of a drive over a stroke, its way or its length

    @property
    def flawed(self) -> bool:
        """Whether some position has no numbers."""
        return bool(self.motion.gaps)

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        result: dict[str, Any] = {
            "scene": self.title,
            "by": self.motion.by,
            "phi": plain(self.motion.phi),
            **({} if self.ways is None else {"s": plain(self.ways)}),
            "gaps": [gap_numbers(gap) for gap in self.motion.gaps],
            "points": self._points(),
            "links": self._links(),
        }
        return result if self.extremes is None else result | {"extremes": _extremes(self.extremes)}

    def _points(self) -> dict[str, Any]:
        points = sorted(self.motion.points.items())
        places = [(k, ORDERS[k].point.key, self.datum if k == 0 else 0) for k in self.orders]
        return {name: {key: pairs(point[k] + place) for k, key, place in places} for name, point in points}

    def _links(self) -> dict[str, Any]:
        links = sorted(self.motion.links.items())
        return {str(number): {ORDERS[k].link.key: plain(link[k]) for k in self.orders} for number, link in links}


def _extremes(extremes: Extremes) -> dict[str, Any]:
    """Give the extremes; angles of a link begin within half a turn of its +x axis, whichever road found them."""
    turns = 0.0 if extremes.sliding else 2 * np.pi * np.round(extremes.reach[0] / (2 * np.pi))
    places = {"phi": list(extremes.phi), "reach": [float(angle - turns) for angle in extremes.reach]}
    return places | {key: getattr(extremes, key) for key in ("stroke", "overlap", "ratio", "faster")}


def numbers(study: "Study", by: str) -> MotionNumbers:
    """Find the motion of a scene by a road: what is asked for of it, and what the forces rest on."""
    linkage = study.of(LinkageStudy)
    orders = numbers_of(study.plans)
    order = ACCELERATIONS.number if any("linkage" in row.needs for row in study.rows) else max(orders, default=0)
    datum = complex(*(float(x) for x in linkage.mechanism.datum))
    with_ends = linkage.form.drive.first is None or (study.chosen and EXTREMES in study.plans)
    found = (solved if by == "analysis" else _constructed)(linkage, order, with_ends)
    _see_one_assembly(linkage, found[0])
    way = ways(linkage.mechanism, found[0].phi)
    return MotionNumbers(study.scene.heading(), datum, found[0], found[1], orders, found[2], way)


def _see_one_assembly(study: LinkageStudy, motion: Motion) -> None:
    """See that the other road assembles the mechanism alike at the first position: both begin at the sketch."""
    phi = motion.phi[:1]
    by_hand = study.sweep.motion(at_angles(phi), 0) if motion.by == "analysis" else None
    other = by_hand or road_of(study).motion(phi, 0)
    apart = {name: float(np.abs(point.r[0] - other.points[name].r[0])) for name, point in motion.points.items()}
    name = max(apart, key=lambda name: np.nan_to_num(apart[name]))
    if apart[name] > MISTAKEN * max(abs(complex(point.r[0])) for point in motion.points.values()):
        line, column = study.scene.place(("mechanism", "sketch"))
        raise SketchError(placed(f"{study.scene.file}:{line}:{column}", message("sketch.two_ways", name=name)), (name,))


def _constructed(study: LinkageStudy, order: int, with_ends: bool) -> tuple[Motion, Extremes | None, None]:
    motion = study.motion(order)
    found = study.extreme_positions if with_ends else None
    return motion, found.extremes if found else None, None


def solved(study: LinkageStudy, order: int, with_ends: bool) -> tuple[Motion, Extremes | None, Analysis]:
    """Solve by analysis alone: a start at an extreme is found by analysis too."""
    road = road_of(study)
    extremes = road.extremes(study.output) if with_ends or not road.first else None
    if extremes is None or road.first:  # of a start at an extreme that is none the turn says why
        return road.motion(study.turn.phi, order), extremes, road
    count = study.form.drive.count
    phi = extremes.phi[0] + study.sense * 2 * np.pi * np.arange(count) / count
    return road.motion(phi, order), extremes, road
