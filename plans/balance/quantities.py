"""A balanced linkage by both roads: centres, counterweights, costs; as numbers (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np

from plans.analytic.balance.balance import balance, weighing
from plans.analytic.balance.counterweights import Course, uncertain
from plans.analytic.balance.mass_centre import bodies, vectors
from plans.analytic.kinematics import Analysis
from plans.balance.centre import Centre, Centres, ComparedPositions, WeightBounds, scene_stretch, turn_stretch
from plans.balance.shares import positions_around
from plans.balance.study import CENTRE, COSTS, COUNTERWEIGHTS, BalanceStudy
from plans.forces.cut import indices
from plans.forces.loading import loading
from plans.forces.quantities import ForceFindings
from plans.forces.statics import ForceDrafts, Statics
from plans.linkage.quantities import MotionComparison, MotionNumbers, compare
from plans.linkage.study import LinkageStudy
from plans.model.balance.linkage import ANALYSIS, EPS, Balance, Choice, Counterweight, MassCentre, Shares, State
from plans.model.mechanism import FRAME
from plans.model.motion import ACCELERATIONS, Floats, Motion
from plans.quantity import Comparison, Numbers, Quantity, gap_numbers, pairs, plain
from plans.study import Study


class Costs:
    """The machine before and after by both roads, over a turn."""

    def __init__(
        self,
        study: BalanceStudy,
        course: Course,
        stretch: ComparedPositions,
        roads: tuple[Balance, Balance],
        weights: WeightBounds,
    ) -> None:
        self.study, self.course, self.stretch, self.weights = study, course, stretch, weights
        self.ours, self.theirs = roads

    def findings(self) -> Iterator[Quantity]:
        """Compare all of it."""
        for after in (False, True):
            state, other = self._states(after)
            if state is not None and other is not None:
                found = *self.centre(after).findings(COSTS, state.around, other.around), *self._forces(after)
                yield from self.stretch.capped(found)

    def _states(self, after: bool) -> tuple[State | None, State | None]:
        return (self.ours.after, self.theirs.after) if after else (self.ours.before, self.theirs.before)

    def centre(self, after: bool) -> Centre:
        """Give the mass centre over the turn."""
        return self._centres[after]

    @cached_property
    def _centres(self) -> dict[bool, Centre]:
        stages = (False, True) if self.ours.after is not None else (False,)
        return {after: Centre(self.study, self.stretch, after, self.weights) for after in stages}

    def forces(self, after: bool) -> ForceFindings:
        """Give the forces over the turn by both roads, with what rounding allows the construction."""
        state, other = self._states(after)
        assert state is not None and other is not None  # asked before
        statics: Statics = self.study.loaded_statics if after else self.study.statics
        plans = ForceDrafts(statics, self.stretch.drafts).plans
        _, force, moment = self.centre(after).sizes  # a counterweight far out has a large moment of inertia forces
        borne = max(force, moment / self.stretch.size)
        return ForceFindings(statics, self.stretch.motion, state.forces, other.forces, plans, borne)

    def _forces(self, after: bool) -> Iterator[Quantity]:
        """Compare reactions and what the drive gives; what the counterweights are off, the reactions magnify."""
        both, mark = self.forces(after), "'" if after else ""
        off = self.given * self.stretch.motion.kappa if after else np.zeros(1)
        for quantity in (*both.reactions(), *both.balancing(self.course.loading)):
            arm = both.size if quantity.unit == "N*m" else 1.0
            letters, space, way = quantity.name.partition(" ")
            name = f"{letters}{mark}{space}{way}"
            yield quantity._replace(plan=COSTS, name=name, allowed=np.asarray(quantity.allowed + off * arm))

    @property
    def given(self) -> float:
        """How far the inertia and weight of the counterweights may be off, N."""
        off = [uncertain(weight, self.weights.slack(weight.link)) for weight in self.ours.counterweights]
        return self.weights.whole * self.stretch.rate + abs(self.course.machine.gravity) * sum(off)

    def allowed(self, after: bool, index: str) -> tuple[Floats, Floats]:
        """Give how far main vector and the reaction of a pair, by its index, may be off over the turn, N."""
        found = {reaction.name: reaction.allowed for reaction in self.forces(after).reactions()}
        off = self.given * self.stretch.motion.kappa if after else np.zeros(1)
        return self.centre(after).shaken, np.asarray(found[f"R_{index}"] + off)


HALVINGS = 60  # of an interval of shares, down to rounding


def share_findings(costs: Costs) -> Iterator[Quantity]:
    """Compare the curves of the largest shaking force and the largest reaction of the shaft, and both best shares."""
    ours, theirs = costs.ours.shares, costs.theirs.shares
    if ours is None or theirs is None:
        return
    shaft = indices(FRAME, costs.course.mechanism.drive.link)
    allowed = [float(np.fmax.reduce(row)) for row in _allowed(costs, shaft)]
    weighed = weighing(costs.course, costs.weights.found)
    yield from _of(("force", "Φ"), weighed.force, allowed[0], ours, theirs)
    yield from _of(("reaction", f"R_{shaft}"), weighed.reaction, allowed[1], ours, theirs)


def _allowed(costs: Costs, shaft: str) -> list[Floats]:
    """Take for every share what is allowed before or after, whichever is more."""
    rows = [costs.allowed(after, shaft) for after in (False, True)]
    return [np.maximum(*both) for both in zip(*rows, strict=True)]


def _of(
    named: tuple[str, str], largest: Callable[[float], float], off: float, ours: Shares, theirs: Shares
) -> Iterator[Quantity]:
    name, letters = named
    curve = (ours.curve, theirs.curve)
    yield _finding(f"{letters}(k)", "N", [[getattr(choice, name) for choice in row] for row in curve], off)
    best: Sequence[Choice] = [getattr(road, f"least_{name}") for road in (ours, theirs)]
    yield _finding(f"min {letters}(k)", "N", [[getattr(choice, name)] for choice in best], off)
    # The share may be as far from the best one as what is largest differs by no more than rounding.
    share = best[1].share
    level = largest(share) + 2 * off
    width = max(_reach(largest, share, end, level) for end in (0.0, 1.0)) + 4 * EPS
    yield _finding(f"k {letters}", "1", [[choice.share] for choice in best], width)


def _reach(largest: Callable[[float], float], share: float, end: float, level: float) -> float:
    """Halve the way from the best share to an end down to where the largest rises above a level."""
    if largest(end) <= level:
        return abs(end - share)
    near, far = share, end
    for _ in range(HALVINGS):
        middle = (near + far) / 2
        near, far = (middle, far) if largest(middle) <= level else (near, middle)
    return abs(far - share)


def _finding(name: str, unit: str, rows: Sequence[Sequence[float]], allowed: float) -> Quantity:
    ours, theirs = (np.array(row) for row in rows)
    return Quantity.of((COSTS, name, unit), (ours, theirs), allowed, float(np.fmax.reduce(np.abs(ours))))


@dataclass(frozen=True)
class BalanceComparison(Comparison):
    """A balance by both roads, over the motion by both."""

    construction: Balance
    analysis: Balance
    findings: tuple[Quantity, ...]
    motion: MotionComparison = field(kw_only=True)


def comparison_of(study: Study) -> BalanceComparison:
    """Compare both roads of a scene's balance."""
    motion = study.of(MotionComparison)
    if motion.analysis.order < ACCELERATIONS.number:  # a bank asks for the balance and shows none of its motion
        motion = compare(study.of(LinkageStudy), ACCELERATIONS.number)
    return compare_balance(study.of(BalanceStudy), motion)


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare_balance(study: BalanceStudy, motion: MotionComparison) -> BalanceComparison:
    """Balance a mechanism by analysis too, and put every quantity beside that of the construction.

    Of a share that is sought both roads tell their own, and go on with that of the construction.
    """
    ours, scene, turn = study.balance, scene_stretch(study.linkage, motion), turn_stretch(study.linkage, motion)
    course = course_of(study, motion.road, motion.analysis, turn.motion.analysis)
    theirs = balance(course, study.task, study.linkage.groups, study.share)
    weights = WeightBounds(study, course)
    found = [*Centres(study, scene, ours, theirs, weights).findings()]
    found += weights.findings(ours, theirs)
    costs = Costs(study, course, turn, (ours, theirs), weights)
    found += [*costs.findings(), *share_findings(costs)]
    return BalanceComparison(ours, theirs, tuple(found), motion=motion)


def course_of(study: BalanceStudy, road: Analysis, motion: Motion, turn: Motion) -> Course:
    """Give the course by analysis of a mechanism: its loads over the turn, with the strokes that the analysis finds."""
    statics = study.statics
    loads = loading(statics.machine, turn, statics.over(road.extremes))
    return Course(road, study.machine, statics.pairs, motion, turn, loads)


Vectors: TypeAlias = tuple[Mapping[int, complex], Mapping[int, complex] | None]  # of main points before, after: m


def numbers(study: Study, by: str) -> Numbers:
    """Balance the mechanism of a scene by a road, over its motion by the same."""
    below = study.numbers("linkage", by)
    assert isinstance(below, MotionNumbers)
    balanced = study.of(BalanceStudy)
    found, (before, after) = _analysed(balanced, below) if by == ANALYSIS else _constructed(balanced)
    data: dict[str, Any] = {"aim": found.task.aim}
    if CENTRE in study.plans:
        data["mass_centre"] = _centre(found.before.centre, before, below.datum)
    if COUNTERWEIGHTS in study.plans and found.after is not None:
        data["counterweights"] = [_weight(weight) for weight in found.counterweights]
        data["left"] = {point: _vector(mass) for point, mass in found.left.items()}
        data["balanced_centre"] = _centre(found.after.centre, after or {}, below.datum)
    if COSTS in study.plans:
        data["before"] = _state(found.before)
        data |= {} if found.after is None else {"after": _state(found.after)}
        data |= {} if found.shares is None else {"shares": _shares(found.shares)}
    data |= {"gaps": [gap_numbers(gap) for gap in found.gaps]} if found.gaps else {}
    return Numbers({"scene": study.scene.heading(), "by": found.by, "balance": data}, bool(found.gaps))


def _constructed(study: BalanceStudy) -> tuple[Balance, Vectors]:
    after = study.points(after=True).vectors if study.balance.after is not None else None
    return study.balance, (study.points().vectors, after)


def _analysed(study: BalanceStudy, below: MotionNumbers) -> tuple[Balance, Vectors]:
    """Balance by analysis alone, over a turn from its own first position on; what cannot be is refused as ever."""
    _ = study.counterweights  # least squares would tell the nearest instead
    road, motion = below.road, below.motion
    assert road is not None  # the motion was found by analysis too
    turned = positions_around(study.linkage).phi - study.linkage.turn.phi[0]
    course = course_of(study, road, motion, road.around(motion.phi[0] + turned))
    found = balance(course, study.task, study.linkage.groups)
    stems, machine = study.tree.stems, study.machine
    before = vectors(bodies(machine), stems)
    return found, (before, None if found.after is None else vectors(bodies(machine, found.counterweights), stems))


def _centre(centre: MassCentre, vectors: Mapping[int, complex], datum: complex) -> dict[str, Any]:
    """Give the mass centre over the positions; the vectors h of the links are in their own frames.

    The main moment of the inertia forces is about the shaft.
    """
    moved = {"mass": centre.mass, "r": pairs(centre.r + datum), "a": pairs(centre.a), "force": pairs(centre.force)}
    by_link = {str(link): _vector(h) for link, h in sorted(vectors.items())}
    return {**moved, "moment": plain(centre.moment), "vectors": by_link}


def _weight(weight: Counterweight) -> dict[str, Any]:
    moment = _vector(weight.moment)
    data: dict[str, Any] = {"on": weight.link, "mass": weight.mass, "moment": moment, "begin": weight.begin}
    if not weight.needed:
        return data
    sizes = {"shape": weight.place.shape, "outer": weight.outer, "inertia": weight.inertia}
    return data | {"centre": _vector(weight.centre), "distance": weight.distance} | sizes


def _state(state: State) -> dict[str, Any]:
    """Give what is largest over a turn; null of a mechanism that reaches no position."""
    inertia = {"path": _known(state.path), "force": _known(state.shaking), "moment": _known(state.rocking)}
    reactions = {key: _known(largest) for key, largest in state.reactions.items()}
    return {**inertia, "reactions": reactions, "balancing": _known(state.balancing)}


def _shares(found: Shares) -> dict[str, Any]:
    least = {"least_force": _choice(found.least_force), "least_reaction": _choice(found.least_reaction)}
    return {"curve": [_choice(choice) for choice in found.curve], **least}


def _choice(choice: Choice) -> dict[str, float | None]:
    return {"share": choice.share, "force": _known(choice.force), "reaction": _known(choice.reaction)}


def _known(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _vector(value: complex) -> list[float]:
    return [value.real + 0.0, value.imag + 0.0]
