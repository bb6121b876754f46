"""The self-check of a written rotor sheet: polygons, views, tables, scales against the analysis (проверка листа)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from drawings.checks import reading
from drawings.checks.wrong import Wrong
from drawings.figures.rotor import across, along
from drawings.figures.rotor.letters import MOST
from drawings.figures.rotor.rotor_polygon import sum_letters
from drawings.figures.rotor.rotor_table import DIGITS, MASSES, NOTHING, RESULTS
from drawings.lettering.rotor_letters import index
from drawings.measure.measure import Measured, MeasuredVector
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups, texts
from plans.analytic.rotor import moment
from plans.checks.comparison import Comparison
from plans.model.rotor import Balance, Rotor
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.letters import moment_letters, unbalance_letters
from plans.study import Study

FLAT = 5  # cells of a row without arms, its name among them
FAR = 1e-9  # of a place: both roads take it from one radius and one angle
ASKEW = 0.0051  # degrees: the half of the last digit of an angle of three figures before the point


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a rotor shows against the analysis (row of the table of sheets)."""
    return check(measured, leaf, study["rotor"].rotor, study.comparison("rotor"), drafting_of(study.scene))


def check(measured: Measured, leaf: Leaf, rotor: Rotor, comparison: Comparison, drafting: Drafting) -> Iterator[Wrong]:
    """Hold what a sheet shows against the analysis: the figures that its data name, tables, scales."""
    expected = Expected(rotor, comparison.analysis)
    for plan in leaf.metadata["figures"]:
        if plan in (along.NAME, across.NAME):
            yield from _points(measured, plan, expected)
        else:
            yield from _vectors(measured, plan, expected)
    yield from reading.marked_scales(leaf)
    yield from _results(leaf, comparison)
    yield from _masses(leaf, expected, drafting)


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
        results = {letters(plane.name) for plane in planes} & vectors.keys()
        masses = (value for name, value in vectors.items() if name not in results)
        return {sum_letters(plan): sum(masses), **{name: vectors[name] for name in results}}

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


def _vectors(measured: Measured, plan: str, expected: Expected) -> Iterator[str]:
    """Hold the vectors of a polygon: each that must be there, none that is not, end to end, closed."""
    true = expected.shown(plan)
    seen = {one.name: one for one in measured.vectors if one.plan == plan}
    scale = max((one.scale for one in seen.values()), default=0.0)
    arm = abs(expected.rotor.arm(expected.rotor.planes[0].place)) if plan == COUPLES else 1.0
    slack = expected.slack * arm + 2 * measured.quantum * scale
    for name in seen.keys() - true.keys():
        yield f"{name} on {plan} (the analysis has none)"
    for name, one in seen.items():
        if name in true and not abs(one.value - true[name]) <= slack:
            yield f"{name} on {plan} (against the analysis)"
    yield from (f"{name} on {plan} is missing" for name in true if name not in seen)
    yield from _open(list(seen.values()), plan, slack)


def _open(vectors: list[MeasuredVector], plan: str, slack: float) -> Iterator[str]:
    """Say so where the vectors of a polygon do not close."""
    if abs(sum(one.value for one in vectors)) > len(vectors) * slack:
        yield f"the polygon {plan} does not close"


def _points(measured: Measured, plan: str, expected: Expected) -> Iterator[str]:
    """Hold the masses of a view against the analysis; none that is to be told apart may be missing."""
    true = {f"m_{name}": _seen(plan, centre, place) for name, centre, place in expected.centres()}
    seen = {one.name: one for one in measured.points if one.plan == plan}
    yield from (f"{name} on {plan} (the analysis has none)" for name in seen.keys() - true.keys())
    for name, one in seen.items():
        off = abs(one.value - true.get(name, one.value))
        if not off <= FAR * abs(one.value) + 2 * measured.quantum * one.scale:
            yield f"{name} on {plan} (against the analysis)"
    yield from (f"{name} on {plan} is missing" for name in expected.distinct & true.keys() - seen.keys())


def _seen(plan: str, centre: complex, place: float) -> complex:
    return centre if plan == along.NAME else complex(place, centre.imag)


def _results(leaf: Leaf, comparison: Comparison) -> Iterator[Wrong]:
    """Read the table of results back."""
    named = {reading.plain(one.name): one for one in comparison.findings if one.plan != "equilibrium"}
    for group in _tables(leaf, RESULTS):
        yield from reading.table(group, named, (0,))


def _tables(leaf: Leaf, name: str) -> Iterator[Group]:
    return (one for one in groups(leaf.groups) if one.name.startswith(name))


def _masses(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[str]:
    """Read the table of masses back: static moments, angles and moments are the analysis's to their last digit."""
    names = [one.name for own in (expected.rotor.masses, expected.rotor.planes) for one in own]
    told = {index(name, drafting.language): name for name in names}
    unbalances, couples = expected.vectors(UNBALANCES), expected.vectors(COUPLES)
    for cells in (row for group in _tables(leaf, MASSES) for row in _rows(group)):
        mass = told.get(cells[0])
        if mass is not None:
            value, turned = unbalances.get(unbalance_letters(mass), 0j), couples.get(moment_letters(mass), 0j)
            sizes = [abs(value)] if len(cells) == FLAT else [abs(value), abs(turned)]
            told_sizes = cells[4:] if len(cells) == FLAT else cells[5:]
            pairs = zip(told_sizes, sizes, strict=True)
            wrong = [text for text, true in pairs if not reads(text, true, expected.slack)]
            wrong += [] if _points_so(cells[3], value) else [cells[3]]
            yield from (f"{text} for {mass} in the table of masses" for text in wrong)


def _points_so(text: str, value: complex) -> bool:
    """Tell whether a text is the direction of a vector in degrees, whole turns left aside; of a zero one any is."""
    if text == NOTHING or not value:
        return not value
    off = (_number(text) - math.degrees(math.atan2(value.imag, value.real)) + 180) % 360 - 180
    return abs(off) <= ASKEW


def _rows(group: Group) -> Iterator[list[str]]:
    rows: dict[float, list[Text]] = {}
    for text in texts((group,)):
        rows.setdefault(round(text.at.imag, 3), []).append(text)
    for row in rows.values():
        yield [text.plain for text in sorted(row, key=lambda text: text.at.real)]


def reads(text: str, true: float, slack: float) -> bool:
    """Tell whether a text is a value to the half of the last of its digits, beside what rounding allows.

    >>> reads("0.061813", 0.0618130981, 0.0), reads("0.06182", 0.0618130981, 0.0), reads("0", 0.0, 0.0)
    (True, False, True)
    """
    half = 0.5000001 * 10.0 ** (math.floor(math.log10(true)) + 1 - DIGITS) if true else 0.0
    return abs(_number(text) - true) <= half + slack


def _number(text: str) -> float:
    return float(text.replace("−", "-").replace(",", "."))
