"""The self-check of a written rotor sheet: polygons, views, tables, scales against the analysis (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from drawings.checks import reading
from drawings.checks.documents_old import title_block, together
from drawings.checks.linkage import accord, by_hand
from drawings.checks.rotor import rotor_polygons, rotor_sentences, rotor_tables, rotor_told, view_across, view_along
from drawings.checks.workings import machine_workings
from drawings.checks.workings.due_line import DueLine, Quantity
from drawings.checks.wrong import Wrong, on
from drawings.figures.rotor import across, along
from drawings.figures.rotor.letters import MOST
from drawings.figures.rotor.rotor_polygon import sum_letters
from drawings.figures.rotor.rotor_table import RESULTS
from drawings.figures.workings.working import SEGMENTS
from drawings.lettering.rotor_letters import lowered
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from geometry import draughtsman, hand_error
from plans.analytic.rotor import moment
from plans.checks.comparison import Comparison
from plans.checks.hand.rotor import rotor_by_hand
from plans.model.rotor import Balance, Rotor
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.letters import moment_letters, unbalance_letters
from plans.rotor.study import RotorStudy
from plans.study import Study

SYMBOLS = {COUPLES: "mDh", UNBALANCES: "mD"}  # of the scales of the polygons
FAR = 1e-9  # of a place: both roads take it from one radius and one angle


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a rotor shows against the analysis (row of the table of sheets)."""
    drafting = drafting_of(study.scene)
    # Polygons and views have a scale each: the title block has no ratio.
    yield from title_block.faults(leaf, study.scene, "rotor", drafting.word("rotor sheet title"), "")
    yield from check(measured, leaf, study["rotor"], study.comparison("rotor"), drafting)


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """See that views, polygons, the table of masses, that of results and the notes stand on the sheets, each once."""
    leaves, rotor, comparison = [leaf for _, leaf in sheets], study["rotor"].rotor, study.comparison("rotor")
    drafting = drafting_of(study.scene)
    thin = not rotor.bearings and len({float(one.place) for own in (rotor.masses, rotor.planes) for one in own}) == 1
    views = (along.NAME,) if thin else (across.NAME, along.NAME)
    yield from together.figures(leaves, (*((COUPLES,) if rotor.dynamic else ()), UNBALANCES, *views))
    yield from together.table(leaves, rotor_tables.MASSES, rotor_tables.names(rotor, comparison, drafting))
    yield from together.notes(leaves)


def check(
    measured: Measured, leaf: Leaf, study: RotorStudy, comparison: Comparison, drafting: Drafting
) -> Iterator[Wrong]:
    """Hold what a sheet shows against the analysis: the figures that its data name, tables, scales."""
    rotor = study.rotor
    expected = Expected(rotor, comparison.analysis)
    for plan in leaf.metadata["figures"]:
        if plan in (along.NAME, across.NAME):
            yield from _points(measured, plan, expected)
            view = view_along.along if plan == along.NAME else view_across.across
            yield from view(leaf, plan, rotor, comparison.analysis, drafting)
        else:
            yield from _vectors(measured, plan, expected)
            own = [one for one in measured.vectors if one.plan == plan]
            sides, closed = expected.shown(plan), expected.closed(plan)
            yield from rotor_polygons.polygon(leaf, plan, sides, closed, own, drafting, expected.loose(plan))
    yield from machine_workings.held(leaf, dict(_workings(measured, leaf, expected, drafting)), drafting)
    yield from reading.marked_scales(leaf)
    yield from rotor_tables.results(leaf, comparison, drafting)
    yield from _by_hand(measured, leaf, study, comparison, drafting)
    yield from rotor_tables.masses(leaf, rotor, comparison, drafting)
    yield from rotor_told.notes(leaf, rotor, comparison, drafting)
    yield from rotor_sentences.notes(leaf, rotor, comparison.analysis, drafting)


def _workings(
    measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting
) -> Iterator[tuple[str, list[DueLine]]]:
    """Give what must be told of the vectors of each polygon laid off."""
    for plan, symbol in SYMBOLS.items():
        mu = next((one.scale for one in measured.vectors if one.plan == plan), 0.0)
        if plan in leaf.metadata["figures"] and mu:
            slack, letters = expected.loose(plan), drafting.language
            own = {lowered(name, letters): Quantity(abs(one), slack) for name, one in expected.shown(plan).items()}
            due = machine_workings.segments(own, symbol, mu, drafting)
            yield machine_workings.named(SEGMENTS, plan), [one._replace(none=slack / mu) for one in due]


def _by_hand(
    measured: Measured, leaf: Leaf, study: RotorStudy, comparison: Comparison, drafting: Drafting
) -> Iterator[Wrong]:
    """Hold what a hand may be out in the polygons, and the scales that this is reckoned with."""
    due = {name: one for name, one in rotor_tables.named(comparison, drafting.language).items() if one.largest > 0}
    both = (rotor_by_hand(study, leaf.metadata["scales"], slopes) for slopes in (hand_error.slopes, draughtsman.slopes))
    yield from by_hand.wrong_results(leaf, RESULTS, due, by_hand.Told(*both), drafting.language)
    yield from by_hand.wrong_scales(measured, leaf, (COUPLES, UNBALANCES))
    yield from accord.apart(leaf, list(due.values()), drafting.language)


@dataclass(frozen=True)
class Expected:
    """What the analysis alone says that a rotor's sheet must show."""

    rotor: Rotor
    balance: Balance

    @cached_property
    def slack(self) -> float:
        """How far rounding can have moved a static moment, kg*m."""
        return max(one.moment.slack for one in self.balance.corrections)

    def vectors(self, plan: str) -> Mapping[str, complex]:
        """Give the vectors of a polygon that are not zero, kg*m or kg*m2."""
        letters = moment_letters if plan == COUPLES else unbalance_letters
        placed = [(one.name, moment(one), one.place) for one in self.rotor.masses]
        added = zip(self.balance.corrections, self.balance.moments, strict=True)
        placed += [(one.plane.name, value, one.plane.place) for one, value in added]
        arms = {name: self.rotor.arm(place) if plan == COUPLES else 1.0 for name, _, place in placed}
        return {letters(name): value * arms[name] for name, value, _ in placed if value * arms[name]}

    def shown(self, plan: str) -> Mapping[str, complex]:
        """Give the vectors that a polygon shows: of more than can be told apart one for all masses."""
        vectors, planes = self.vectors(plan), self.rotor.planes
        letters = moment_letters if plan == COUPLES else unbalance_letters
        closing = letters(planes[0 if plan == COUPLES else -1].name)
        if len(vectors.keys() - {closing}) <= MOST:
            return vectors
        results = [name for plane in planes if (name := letters(plane.name)) in vectors]
        masses = (value for name, value in vectors.items() if name not in results)
        return {sum_letters(plan): sum(masses), **{name: vectors[name] for name in results}}

    def closed(self, plan: str) -> bool:
        """Tell whether the given vectors of a polygon close by themselves."""
        whole = self.balance.couple if plan == COUPLES else self.balance.corrections[-1].moment
        return whole.vanishes

    def loose(self, plan: str) -> float:
        """Give how far rounding can have moved a corner of a polygon, kg*m or kg*m2."""
        arm = abs(self.rotor.arm(self.rotor.planes[0].place)) if plan == COUPLES else 1.0
        slack = self.balance.corrections[0].moment.slack if plan == COUPLES else self.slack
        return slack * arm

    @property
    def distinct(self) -> frozenset[str]:
        """Name what the views tell apart: counterweights, and masses if there are not too many."""
        added = [one.plane.name for one in self.balance.corrections if one.moment.size]
        masses = [one.name for one in self.rotor.masses]
        return frozenset(f"m_{name}" for name in (added if len(masses) + len(added) > MOST else [*masses, *added]))

    def centres(self) -> Iterator[tuple[str, complex, float]]:
        """Give name, centre and place m of every mass and counterweight whose radius is known."""
        for one in self.rotor.masses:
            if one.radius is not None:
                turned = one._replace(moment=one.radius)
                yield one.name, moment(turned), float(one.place)
        for found in self.balance.corrections:
            if found.radius is not None and found.moment.size:
                unit = found.moment.value / abs(found.moment.value)
                yield found.plane.name, found.radius * unit, float(found.plane.place)


def _vectors(measured: Measured, plan: str, expected: Expected) -> Iterator[Wrong]:
    """Hold the vectors of a polygon: each that must be there, none that is not, end to end, closed."""
    true = expected.shown(plan)
    seen = {one.name: one for one in measured.vectors if one.plan == plan}
    scale = max((one.scale for one in seen.values()), default=0.0)
    arm = abs(expected.rotor.arm(expected.rotor.planes[0].place)) if plan == COUPLES else 1.0
    slack = expected.slack * arm + 2 * measured.quantum * scale
    for name in seen.keys() - true.keys():
        if not abs(seen[name].value) <= slack:
            yield on("stranger_on", plan, name=name)
    for name, one in seen.items():
        if name in true and not abs(one.value - true[name]) <= slack:
            yield on("differs_on", plan, name=name)
    lost = (name for name in true.keys() - seen.keys() if not abs(true[name]) <= slack)
    yield from (on("missing_on", plan, name=name) for name in lost)
    yield from _open(list(seen.values()), plan, slack)


def _open(vectors: list[MeasuredVector], plan: str, slack: float) -> Iterator[Wrong]:
    """Say so where the vectors of a polygon do not close."""
    if abs(sum(one.value for one in vectors)) > len(vectors) * slack:
        yield on("open", plan)


def _points(measured: Measured, plan: str, expected: Expected) -> Iterator[Wrong]:
    """Hold the masses of a view against the analysis; none that is to be told apart may be missing."""
    true = {f"m_{name}": _seen(plan, centre, place) for name, centre, place in expected.centres()}
    seen = {one.name: one for one in measured.points if one.plan == plan}
    yield from (on("stranger_on", plan, name=name) for name in seen.keys() - true.keys())
    for name, one in seen.items():
        off = abs(one.value - true.get(name, one.value))
        if not off <= FAR * abs(one.value) + 2 * measured.quantum * one.scale:
            yield on("differs_on", plan, name=name)
    yield from (on("missing_on", plan, name=name) for name in expected.distinct & true.keys() - seen.keys())


def _seen(plan: str, centre: complex, place: float) -> complex:
    return centre if plan == along.NAME else complex(place, centre.imag)
