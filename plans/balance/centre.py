"""The mass centre by both roads, before and after, and the sums that must vanish (сравнение центров масс).

The main vector is had by four ways: by main points, by the polygon of the inertia forces of all links, by direct sums
of the analysis, and as what the frame must hold where nothing but inertia acts.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Mark
from geometry.precision import errors
from plans.analytic.balance.counterweights import Course, FoundWeights, counterweights, shared, sought, uncertain
from plans.analytic.balance.mass_centre import bodies, sizes, vectors
from plans.analytic.kinetostatics import kinetostatics
from plans.balance.shares import drawing, positions_around
from plans.balance.study import CENTRE, COUNTERWEIGHTS, BalanceStudy
from plans.linkage.drafts import Drafts
from plans.linkage.quantities import MotionComparison, cap, with_analysis
from plans.linkage.study import LinkageStudy
from plans.model.balance.linkage import EPS, NONE, ROUNDING, SHARE, Balance, Counterweight, MassCentre
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats
from plans.quantity import Quantity


class WeightBounds:
    """What rounding allows the counterweights of a study."""

    def __init__(self, study: BalanceStudy, course: Course) -> None:
        self.study, self.mechanism = study, course.mechanism
        self.found = FoundWeights((), {}, {}, {})
        if study.task.aim != NONE:
            wanted = sought(course.mechanism, study.linkage.groups, study.task)
            self.found = counterweights(course.mechanism, course.machine, wanted)

    def slack(self, link: int) -> float:
        """Give how far the static moment kg*m of a link's counterweight may be off, by both roads."""
        need = self.study.substitution.needs.get(link)
        rounding = ROUNDING * EPS * need.size if need else 0.0
        return rounding + self.found.slack.get(link, 0.0) + (self._given if link == self.mechanism.drive.link else 0.0)

    def loose(self, point: str) -> float:
        """Give how far a mass kg that stays at a point may be off."""
        term = self.study.substitution.left.get(point)
        return self.found.loose.get(point, 0.0) + (ROUNDING * EPS * term.size if term else 0.0)

    @property
    def whole(self) -> float:
        """Give how far all static moments together may be off, kg*m."""
        return sum(map(self._off, self.study.balance.counterweights))

    def _off(self, weight: Counterweight) -> float:
        """Give how far one of them may be off: its mass, too, and its centre told from the zero of the link's frame."""
        slack = self.slack(weight.link)
        cancelled = weight.mass * (abs(weight.centre) + abs(weight.origin) - abs(weight.centre - weight.origin))
        return slack + abs(weight.centre) * uncertain(weight, slack) + 2 * EPS * cancelled

    @property
    def _given(self) -> float:
        """How far what a share of the reciprocating mass gives the crank may be off, kg*m."""
        if self.study.task.aim != SHARE:
            return 0.0
        return abs(shared(self.mechanism, {point: self.loose(point) for point in self.found.left}))

    def findings(self, ours: Balance, theirs: Balance) -> Iterator[Quantity]:
        """Compare every counterweight, and every mass that stays."""
        for weight, other in zip(ours.counterweights, theirs.counterweights, strict=True):
            slack, link = self.slack(weight.link), weight.link
            named = COUNTERWEIGHTS, f"U_{link}", "kg*m"
            yield Quantity.of(named, (weight.moment, other.moment), slack, max(abs(weight.moment), slack))
            off = 2 * EPS * weight.mass + uncertain(weight, slack)
            yield Quantity.of((COUNTERWEIGHTS, f"m_cw{link}", "kg"), (weight.mass, other.mass), off, weight.mass)
            if weight.needed and other.needed:
                place = slack / weight.mass + weight.distance * (4 * EPS + uncertain(weight, slack) / weight.mass)
                named, far = (COUNTERWEIGHTS, f"r_cw{link}", "m"), abs(weight.centre) + weight.distance
                yield Quantity.of(named, (weight.centre, other.centre), place, far)
        largest = max((abs(mass) for mass in ours.left.values()), default=0.0)
        for point in dict.fromkeys((*ours.left, *theirs.left)):
            pair = ours.left.get(point, 0j), theirs.left.get(point, 0j)
            yield Quantity.of((COUNTERWEIGHTS, f"m_{point}", "kg"), pair, self.loose(point), largest)


class ComparedPositions(NamedTuple):
    """Some positions of a linkage: the plans there, and the motion by both roads, which is judged elsewhere."""

    study: LinkageStudy
    drafts: Drafts
    motion: MotionComparison

    @property
    def rate(self) -> float:
        """The largest acceleration of a point of a link 1 m from one that rests, 1/s2; NaN where there is none."""
        rows = [np.abs(1j * link.epsilon - link.omega**2) for link in self.motion.analysis.links.values()]
        return float(np.fmax.reduce(rows, axis=None))

    @property
    def size(self) -> float:
        """How far the mechanism reaches from the datum, m."""
        rows = [np.abs(point.r) for point in self.motion.analysis.points.values()]
        return float(np.fmax.reduce(rows, axis=None))

    def allowed(self, drawn: Floats, order: int, largest: float) -> Floats:
        """Add what the analysis needs to what the construction does."""
        return with_analysis(drawn, order, self.motion.kappa, largest)

    def bounds(self, *marks: Mark) -> list[Floats]:
        """Give how far rounding can have moved marks, over the positions."""
        bounds, count = errors(*marks), len(self.motion.kappa)
        return [np.asarray(np.broadcast_to(bounds[mark].place, count)) for mark in marks]

    def capped(self, findings: Iterable[Quantity]) -> tuple[Quantity, ...]:
        """Allow no more than a share of the largest where the construction is sharp."""
        return cap(self.study, list(findings), self.drafts)


def scene_stretch(study: LinkageStudy, motion: MotionComparison) -> ComparedPositions:
    """Give the positions of the scene, over which the motion is compared."""
    return ComparedPositions(study, study.drafts(), motion)


def turn_stretch(study: LinkageStudy, motion: MotionComparison) -> ComparedPositions:
    """Give even positions of a turn; of a crank that cannot turn fully they are the scene's."""
    around = positions_around(study)
    if around is study.turn:
        return scene_stretch(study, motion)
    drafts = Drafts(study, around)
    solved = motion.road.around(drafts.turn.phi)
    kappa = motion.road.conditions(solved)
    both = replace(motion, construction=drafts.motion(2), analysis=solved, findings=(), kappa=kappa)
    return ComparedPositions(study, drafts, both)


PLACE, ACCELERATION = 0, 2  # orders of motion
FORCES = 3  # the reactions magnify rounding once more


class Centre:
    """A mass centre by both roads over some positions, before or after, with what rounding allows it."""

    def __init__(self, study: BalanceStudy, stretch: ComparedPositions, after: bool, weights: WeightBounds) -> None:
        self.study, self.stretch, self.after, self.weights = study, stretch, after, weights
        self.points = points = study.points(after)
        self.drawing = made = drawing(points, stretch.drafts)
        self.mass = points.mass
        added = study.balance.counterweights if after else ()
        self.solid = bodies(study.machine, added)
        static, force, turning = sizes(study.linkage.mechanism, self.solid, stretch.motion.analysis)
        # Where all masses rest in hinges of the frame the main-point vectors turn all the same, and cancel.
        force = force or sum(term.size for term in points.moments.values()) * stretch.rate
        self.sizes = static, force, turning or force * stretch.size
        # How far the static moments themselves may be off: those of main points, and those of counterweights.
        self.given = sum(ROUNDING * EPS * term.size for term in points.moments.values())
        self.given += weights.whole if after else 0.0
        marks = made.centre, made.accelerations.end, made.moment, made.place, made.force, made.shaking.end
        self.place, self.bent, self.turning, self.summed, self.force, self.forces = stretch.bounds(*marks)

    @property
    def mark(self) -> str:
        """A prime after the names of what is after."""
        return "'" if self.after else ""

    @property
    def placed(self) -> Floats:
        """How far the place of the mass centre may be off, m."""
        static = self.sizes[0] / self.mass
        return self.stretch.allowed(self.place + self.given / self.mass, PLACE, static)

    @property
    def shaken(self) -> Floats:
        """How far the main vector may be off, N."""
        drawn = self.mass * self.bent + self.given * self.stretch.rate + 4 * EPS * self.sizes[1]
        return self.stretch.allowed(drawn, ACCELERATION, self.sizes[1])

    @property
    def rocked(self) -> Floats:
        """How far the main moment may be off, N*m."""
        drawn = self.turning + self.given * self.stretch.rate * self.stretch.size
        return self.stretch.allowed(drawn, ACCELERATION, self.sizes[2])

    def findings(self, plan: str, ours: MassCentre, theirs: MassCentre) -> Iterator[Quantity]:
        """Compare place, main vector and main moment."""
        yield Quantity.of((plan, f"r_S{self.mark}", "m"), (ours.r, theirs.r), self.placed, self.sizes[0] / self.mass)
        yield Quantity.of((plan, f"Φ{self.mark}", "N"), (ours.force, theirs.force), self.shaken, self.sizes[1])
        yield Quantity.of((plan, f"M_Φ{self.mark}", "N*m"), (ours.moment, theirs.moment), self.rocked, self.sizes[2])

    def polygons(self, theirs: MassCentre) -> Iterator[Quantity]:
        """Compare the polygons of static moments and of inertia forces."""
        place, force = self.row(self.drawing.place, theirs.r), self.row(self.drawing.shaking.end, theirs.force)
        static = self.sizes[0] / self.mass
        allowed = self.stretch.allowed(self.summed + self.given / self.mass, PLACE, static)
        yield Quantity.of((CENTRE, f"Σmr/m{self.mark}", "m"), (place, theirs.r), allowed, static)
        drawn = self.forces + self.given * self.stretch.rate
        allowed = self.stretch.allowed(drawn, ACCELERATION, self.sizes[1])
        yield Quantity.of((CENTRE, f"ΣΦ{self.mark}", "N"), (force, theirs.force), allowed, self.sizes[1])

    def vectors(self) -> Iterator[Quantity]:
        """Compare the vectors of main points with sums over the paths from each mass to the frame."""
        theirs, terms = vectors(self.solid, self.points.tree.stems), self.points.moments
        for link, ours in self.points.vectors.items():
            size = terms[link].size / self.mass
            slack = 2 * ROUNDING * EPS * size + (self.weights.whole / self.mass if self.after else 0.0)
            pair = np.array([ours]), np.array([theirs[link]])
            yield Quantity.of((CENTRE, f"h_{link}{self.mark}", "m"), pair, np.array([slack]), size)

    def row(self, mark: Any, like: Complexes) -> Complexes:
        """Give a mark over the positions; where there is no place there is none of it."""
        return np.where(np.isnan(like), np.nan, np.broadcast_to(mark.point, len(like)))


class Centres:
    """The mass centre before and after, over the positions of the scene."""

    def __init__(
        self, study: BalanceStudy, stretch: ComparedPositions, ours: Balance, theirs: Balance, weights: WeightBounds
    ) -> None:
        self.study, self.stretch, self.ours, self.theirs, self.weights = study, stretch, ours, theirs, weights

    def findings(self) -> Iterator[Quantity]:
        """Compare both, and hold them against what the frame must bear."""
        for state, other in ((self.ours.before, self.theirs.before), (self.ours.after, self.theirs.after)):
            if state is not None and other is not None:
                after = state is self.ours.after
                centre = Centre(self.study, self.stretch, after, self.weights)
                found = *centre.findings(CENTRE, state.centre, other.centre), *centre.polygons(other.centre)
                yield from centre.vectors()
                yield from self.stretch.capped((*found, *self._held(centre, state.centre)))
                if after:
                    yield from self.stretch.capped([self._still(centre, state.centre)])

    def _held(self, centre: Centre, ours: MassCentre) -> Iterator[Quantity]:
        """Compare the main vector and moment with what the frame holds where inertia alone acts."""
        machine = self.study.loaded if centre.after else self.study.machine
        alone = replace(machine, gravity=0j, forces=(), moments=(), springs=())
        motion, pairs = self.stretch.motion, self.study.statics.pairs
        held = kinetostatics(motion.road, alone, motion.analysis, Loading((), ()), pairs)
        force, moment = frame_holds(held)
        size = max(held.largest, centre.sizes[1])
        allowed = self.stretch.allowed(centre.shaken, FORCES, size)
        yield _judged(CENTRE, f"ΣR_0{centre.mark}", "N", (ours.force, force), allowed, size)
        allowed = self.stretch.allowed(centre.rocked, FORCES, size * self.stretch.size)
        largest = max(centre.sizes[2], size * self.stretch.size)
        yield _judged(CENTRE, f"ΣM_0{centre.mark}", "N*m", (ours.moment, moment), allowed, largest)

    def _still(self, centre: Centre, ours: MassCentre) -> Quantity:
        """Hold what must rest: the mass centre, but for what is left at sliders and the share that the crank bears."""
        motion, left = self.stretch.motion.construction, self.ours.left
        moving = centre.row(centre.drawing.polygon.end, ours.r) - sum(
            mass * motion.points[point].r for point, mass in left.items()
        )
        # What the crank bears of the masses at sliders, kg*m in its frame
        share = self.study.share
        mechanism = self.study.linkage.mechanism
        borne = 0j if share is None else share * shared(mechanism, dict(self.theirs.left))
        moving = moving + borne * np.exp(1j * motion.links[mechanism.drive.link].angle)
        rest = moving - next((place for place in moving if np.isfinite(place)), np.nan)
        loose = sum(self.weights.loose(point) for point in left) * self.stretch.size
        kept = sum(map(abs, left.values())) * self.stretch.size
        drawn = centre.mass * centre.placed + loose + self.stretch.allowed(np.zeros(1), PLACE, kept)
        allowed = drawn + float(np.fmax.reduce(drawn))
        return Quantity.vanishing(f"S{centre.mark}", "kg*m", np.abs(rest), allowed, centre.sizes[0])


def frame_holds(forces: Kinetostatics) -> tuple[Complexes, Floats]:
    """Sum what the links do to the frame, and its moment about the datum; what drives the crank has its reaction there.

    It is the main vector and the main moment of the inertia forces, where nothing else acts.
    """
    rows = [reaction for reaction in forces.reactions.values() if FRAME in (reaction.giver, reaction.taker)]
    force = np.zeros(len(forces.phi), dtype=np.complex128)
    moment = np.array(-forces.balancing.moment)
    if forces.balancing.force is not None:
        force = force - forces.balancing.force
    for row in rows:
        sign = -1.0 if row.giver == FRAME else 1.0
        force = force + sign * row.force
        moment = moment + sign * ((row.r.conj() * row.force).imag + (0.0 if row.moment is None else row.moment))
    return force, moment


def _judged(plan: str, name: str, unit: str, pair: tuple[Any, Any], allowed: Floats, largest: float) -> Quantity:
    ours, theirs = pair
    theirs = np.where(np.isnan(theirs), ours, theirs)
    return Quantity.of((plan, name, unit), (np.where(np.isnan(ours), theirs, ours), theirs), allowed, largest)
