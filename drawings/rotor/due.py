"""What must stand on the sheets of a rotor, by the analysis alone: polygons, views, tables, notes (лист ротора)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from drawings.checks.expected import NOTES, Expected, by_hand, cells, measured, phrases
from drawings.lettering.rotor_letters import index, lowered
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.analytic.rotor import moment
from plans.model.rotor import Rotor, RotorBalance, permissible
from plans.quantity import EQUILIBRIUM, Comparison, Quantity
from plans.quantity import by_hand as slipping
from plans.rotor.balancing import COUPLES, UNBALANCES, moment_letters, unbalance_letters
from plans.rotor.study import BEARINGS, RotorStudy
from plans.study import Study

ALONG, ACROSS, MASSES, RESULTS = "along", "across", "masses", "results"
FEW, MANY, ARMS = 9, 40, 9  # masses that bear letters; that are told apart; arms that are dimensioned
TURN, DIGITS = 360.0, 5
GRAM_MILLIMETRES = 1e6  # of a kg*m
FAR = 1e-9  # of a place: both roads take it from one radius and one angle


Known = tuple[float, float]  # a value, and how far rounding can have moved it


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's rotor."""
    comparison, drafting = study.comparison("rotor"), drafting_of(study.scene)
    table = _ExpectedRotor(study.of(RotorStudy).rotor, comparison, drafting)
    scales: Mapping[str, float] = next((leaf.metadata["scales"] for leaf in leaves), {})
    slips = slipping(comparison.findings, scales)
    yield from chain(table.polygons(), table.views(), table.masses(), table.results(slips), table.notes())


@dataclass(frozen=True)
class _ExpectedRotor:
    """A rotor balanced by the analysis."""

    rotor: Rotor
    comparison: Comparison
    drafting: Drafting

    @property
    def balance(self) -> RotorBalance:
        found: RotorBalance = self.comparison.analysis
        return found

    @cached_property
    def slack(self) -> float:
        """How far rounding can have moved a static moment, kg*m."""
        return max(correction.moment.slack for correction in self.balance.corrections)

    def polygons(self) -> Iterator[Expected]:
        """Give the sides of the polygons; one that rounding may hide or make is doubtful."""
        for plan in (COUPLES, UNBALANCES) if self.rotor.dynamic else (UNBALANCES,):
            slack = self.slack * (abs(self.rotor.arm(self.rotor.planes[0].place)) if plan == COUPLES else 1.0)
            for name, value in self._shown(plan).items():
                yield Expected(Kind.VECTOR, plan, name, value, slack, may_lack=abs(value) <= slack)

    def _vectors(self, plan: str) -> Mapping[str, complex]:
        """Give the vectors of a polygon that are not zero, kg*m or kg*m2."""
        letters = moment_letters if plan == COUPLES else unbalance_letters
        placed = [(mass.name, moment(mass), mass.place) for mass in self.rotor.masses]
        added = zip(self.balance.corrections, self.balance.moments, strict=True)
        placed += [(correction.plane.name, value, correction.plane.place) for correction, value in added]
        arms = {name: self.rotor.arm(place) if plan == COUPLES else 1.0 for name, _, place in placed}
        return {letters(name): value * arms[name] for name, value, _ in placed if value * arms[name]}

    def _shown(self, plan: str) -> Mapping[str, complex]:
        """Give the vectors that a polygon shows: of more than can be told apart one for all masses."""
        vectors, planes = self._vectors(plan), self.rotor.planes
        letters = moment_letters if plan == COUPLES else unbalance_letters
        if len(vectors.keys() - {letters(planes[0 if plan == COUPLES else -1].name)}) <= MANY:
            return vectors
        results = [name for plane in planes if (name := letters(plane.name)) in vectors]
        masses = sum(value for name, value in vectors.items() if name not in results)
        return {"ΣmDh" if plan == COUPLES else "ΣmD": masses, **{name: vectors[name] for name in results}}

    def views(self) -> Iterator[Expected]:
        """Give the places of the bodies, the arms, and the sense of turning."""
        rotor = self.rotor
        bodies = [*self._bodies()]
        places = {float(part.place) for parts in (rotor.masses, rotor.planes) for part in parts}
        thin = not rotor.bearings and len(places) == 1
        crowd = len(rotor.masses) + sum(bool(correction.moment.size) for correction in self.balance.corrections) > MANY
        for name, centre, place, added in bodies:
            if added or not crowd:
                centres = {ALONG: centre} if thin else {ALONG: centre, ACROSS: complex(place, centre.imag)}
                slack = self.slack / abs(self._moment(name)) if added else 0.0
                for view, at in centres.items():
                    yield Expected(Kind.POINT, view, f"m_{name}", at, (FAR + slack) * abs(at), may_lack=slack > 1)
        if rotor.speed is not None:
            yield Expected(Kind.DIRECTION, ALONG, "ω", math.copysign(1.0, rotor.speed))
        yield from () if thin else self._arms()

    def _moment(self, name: str) -> complex:
        moments = zip(self.balance.corrections, self.balance.moments, strict=True)
        return next(value for correction, value in moments if correction.plane.name == name)

    def _bodies(self) -> Iterator[tuple[str, complex, float, bool]]:
        """Give name, centre and place m of every body whose radius is known, and whether it is a counterweight."""
        for mass in self.rotor.masses:
            if mass.radius is not None:
                yield mass.name, moment(mass._replace(moment=mass.radius)), float(mass.place), False
        for found in self.balance.corrections:
            if found.radius is not None and found.moment.size:
                centre = found.radius * found.moment.value / found.moment.size
                yield found.plane.name, centre, float(found.plane.place), True

    def _arms(self) -> Iterator[Expected]:
        """Give the arms that are dimensioned, each once, millimetres of the machine."""
        arms: dict[float, str] = {}
        for mass in self.rotor.masses:
            arms.setdefault(self.rotor.arm(mass.place), mass.name)
        for found in self.balance.corrections[:-1]:
            arms.setdefault(self.rotor.arm(found.plane.place), found.plane.name)
        arms = {arm: name for arm, name in arms.items() if arm}
        for arm, name in arms.items() if len(arms) <= ARMS else ():
            doubtful = any(not weight.moment.size > weight.moment.slack for weight in self.balance.corrections)
            row = Expected(Kind.LENGTH, ACROSS, f"h_{name}", abs(arm), may_lack=doubtful)
            yield from measured(row, 1000 * abs(arm), digits=4)

        for name, place in zip(BEARINGS, self.rotor.bearings, strict=False):
            far = abs(self.rotor.arm(place))
            bearing = Expected(Kind.LENGTH, ACROSS, f"bearing {name}", far, may_lack=not far)
            yield from measured(bearing, 1000 * far, digits=4)

    def masses(self) -> Iterator[Expected]:
        """Give the cells of the table of masses: mass, radius, angle, arm, static moment, its moment."""
        rotor = self.rotor
        flat = not any(rotor.arm(part.place) for parts in (rotor.masses, rotor.planes) for part in parts)
        for body in rotor.masses:
            mass, far = (None if size is None else (size, 0.0) for size in (body.mass, body.radius))
            angle = float(body.angle), 0.0
            yield from self._line(body.name, mass, far, angle, rotor.arm(body.place), (body.moment, 0.0), flat)
        for found in self.balance.corrections:
            name, slack, value = index(found.plane.name, self.drafting.language), self.slack, found.moment
            mass = None if found.mass is None else (found.mass, slack / (found.plane.radius or math.inf))
            far = None if found.radius is None else (found.radius, slack / (found.plane.mass or math.inf))
            angle = (value.angle or 0.0, math.degrees(slack / value.size) if value.size > slack else math.inf)
            yield from self._line(name, mass, far, angle, rotor.arm(found.plane.place), (value.size, slack), flat)

    def _line(
        self, name: str, mass: Known | None, far: Known | None, angle: Known, arm: float, size: Known, flat: bool
    ) -> Iterator[Expected]:
        radius = None if far is None else (1000 * far[0], 1000 * far[1])
        turned = (size[0] * arm, size[1] * abs(arm))
        last = [size] if flat else [(1000 * arm, 0.0), size, turned]
        yield from cells(MASSES, name, [mass, radius, (*angle, TURN), *last], digits=DIGITS)

    def results(self, slips: Mapping[tuple[str, int], float]) -> Iterator[Expected]:
        """Give the cells of the table of results: by plan, by analysis, drawing error."""
        for finding in self._findings():
            if finding.largest > 0:
                head, _, prime = finding.name.partition("'")
                row = f"{lowered(head, self.drafting.language)}{chr(39) if finding.name.endswith(chr(39)) else prime}"
                size = float(abs(finding.analysis[0])), float(finding.allowed[0])
                values = size, size, by_hand(slips.get((finding.name, 0), math.nan), finding.largest)
                yield from cells(RESULTS, f"{row}, {self.drafting.word(finding.unit)}", values, digits=DIGITS)

    def _findings(self) -> Iterator[Quantity]:
        return (finding for finding in self.comparison.findings if finding.plan != EQUILIBRIUM)

    def notes(self) -> Iterator[Expected]:
        """Give the numbers of the notes, by the names of their quantities; of what vanishes they may lack."""
        for finding in self._findings():
            value, slack = complex(finding.analysis[0]), float(finding.allowed[0])
            lost = finding.name == "ΣmDh" or finding.plan not in (COUPLES, UNBALANCES) or not abs(value) > slack
            yield Expected(Kind.PHRASE, NOTES, finding.name, abs(value), slack, digits=DIGITS, may_lack=lost)
            turned = math.degrees(slack / abs(value)) if abs(value) > slack else math.inf
            angle = math.degrees(math.atan2(value.imag, value.real))
            row = Expected(Kind.PHRASE, NOTES, f"φ {finding.name}", angle, turned, digits=DIGITS)
            yield row._replace(may_lack=lost, period=TURN)
        for found in self.balance.corrections:
            slack, lost = self.slack, not found.moment.size > self.slack
            sizes = (("m", found.mass, 1.0, found.plane.radius), ("D", found.radius, 1000.0, found.plane.mass))
            figures = (
                (f"{letter}_{found.plane.name}", unit * size, unit * slack / (other or math.inf))
                for letter, size, unit, other in sizes
                if size is not None
            )
            yield from phrases(NOTES, figures, DIGITS, lost)
        yield from self._quality()

    def _quality(self) -> Iterator[Expected]:
        rotor = self.rotor
        quality = rotor.quality(*self.balance.sizes)
        if rotor.speed is not None:
            lost = quality is None and not self.balance.before
            yield Expected(Kind.PHRASE, NOTES, "ω", rotor.speed, digits=4, may_lack=lost)
        if quality is None or rotor.mass is None or rotor.speed is None:
            return
        slack = rotor.quality(*(correction.moment.slack for correction in self.balance.corrections)) or 0.0
        given = (("m", rotor.mass, 0.0), ("n", rotor.speed * 30 / math.pi, 0.0), ("e·ω", quality, 2 * slack))
        yield from phrases(NOTES, given, 4)
        if rotor.grade is not None:
            whole = GRAM_MILLIMETRES * permissible(rotor.grade, rotor.mass, rotor.speed)
            yield from phrases(NOTES, [("U_per", whole, 0.0)], 4)
            yield from phrases(NOTES, [("U_per each", whole / len(rotor.planes), 0.0)], 4, may_lack=True)
