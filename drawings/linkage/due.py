"""What must stand on the sheets of a linkage, by the analysis alone: positions, strokes, values, notes (кинематика)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

import numpy as np

from drawings.checks.expected import NOTES, Expected, by_hand, by_roads, measured, phrases
from drawings.checks.hold import stated_keys
from drawings.diagrams import due as diagrams
from drawings.layout import value_table
from drawings.lettering.words import letter
from drawings.linkage.due_plans import VectorPlans
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf, Text
from plans.analytic.points import placed
from plans.linkage.parts import MotionByHand, alike
from plans.linkage.plan import unnamed
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import EXTREMES, LinkageStudy
from plans.linkage.sweep import interval
from plans.linkage.travel import other_sliders
from plans.model.mechanism import FRAME, Output, output_way
from plans.model.motion import ORDERS, POSITIONS, Extremes
from plans.model.triad import Triad
from plans.quantity import Quantity
from plans.study import Study
from plans.words.words import word

VALUES = "values"  # the table of values
TURNED = 1e-3  # rad: the resolution of the paper over an arrow


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's linkage."""
    linkage = _ExpectedMotion(study.of(LinkageStudy), study.of(MotionComparison), drafting_of(study.scene), leaves)
    yield from chain(linkage.positions(), linkage.plans(), linkage.values(), linkage.notes())
    if any("diagrams" in leaf.metadata for leaf in leaves):
        yield from diagrams.expected(study, leaves)


def measures(study: LinkageStudy, comparison: MotionComparison, drafting: Drafting) -> Iterator[Expected]:
    """Give the sense of the drive and the strokes that any plan of positions of a linkage may show."""
    linkage = _ExpectedMotion(study, comparison, drafting, ())
    yield from chain(linkage.senses(0), linkage.strokes())


def of_plans(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give the vectors of the plans of velocities and accelerations that any sheets show."""
    return _ExpectedMotion(study.of(LinkageStudy), study.of(MotionComparison), drafting_of(study.scene), leaves).plans()


def mass_centres(study: LinkageStudy) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that no point of the scene is or names: link, and place in its own frame."""
    return unnamed(study.scene, study.mechanism.links)


@dataclass(frozen=True, eq=False, repr=False)
class _ExpectedMotion:
    """A motion by the analysis, and the sheets that show it."""

    study: LinkageStudy
    comparison: MotionComparison
    drafting: Drafting
    leaves: Sequence[Leaf]

    @cached_property
    def masses(self) -> dict[str, tuple[int, complex]]:
        return mass_centres(self.study)

    @cached_property
    def shown(self) -> int | None:
        """The position in full lines."""
        return next((k for leaf in self.leaves if (k := leaf.metadata["shown"]) is not None), None)

    def positions(self) -> Iterator[Expected]:
        """Give what the plan of positions shows."""
        if self.shown is not None:
            yield from chain(self.points(self.shown), self.senses(self.shown), self.strokes())

    def points(self, k: int) -> Iterator[Expected]:
        """Give the points and the mass centres of the position in full lines; one at a gap has no place."""
        fixed, moved = self.study.mechanism.links[FRAME].points, self.comparison.analysis
        slack = {finding.name: float(finding.allowed[k]) for finding in self.comparison.of(POSITIONS.plan)}
        most = 2 * max((finding for finding in slack.values() if math.isfinite(finding)), default=0.0)
        moving = (name for name in moved.points if name not in fixed)
        places = {name: (complex(moved.points[name].r[k]), slack[f"r_{name}"]) for name in moving}
        places |= {name: (place, 0.0) for name, place in fixed.items()}
        for name, (link, local) in self.masses.items():
            places[name] = complex(placed(self.study.mechanism, moved, link, local)[k]), most
        for triad in (group for group in self.study.groups if isinstance(group, Triad)):
            special = self._vectors.special(triad)
            if special is not None:
                yield Expected(
                    Kind.POINT, POSITIONS.plan, special.name, complex(special.place[k]), most, k, may_lack=True
                )
        for name, (place, allowed) in places.items():
            if not math.isnan(place.real):
                lost = name in fixed  # the one that all places are measured from is no point
                yield Expected(Kind.POINT, POSITIONS.plan, name, place, allowed, k, may_lack=lost)

    def senses(self, k: int) -> Iterator[Expected]:
        """Give the senses of the rates of the primary link: about its pivot, or along its guide."""
        drive, rates = self.study.mechanism.drive, self.comparison.road.rates(self.study.turn.phi)
        names, way = ("va", drive.guide.way(FRAME).direction) if drive.guide is not None else ("ωε", 1 + 0j)
        end = drive.guide.point if drive.guide is not None else drive.link
        for symbol, rate in zip(names, rates.at(k), strict=True):
            if rate:
                sense = math.copysign(1.0, rate) * way
                yield Expected(Kind.DIRECTION, POSITIONS.plan, f"{symbol}_{end}", sense, TURNED)

    def strokes(self) -> Iterator[Expected]:
        """Give strokes of sliders, the swing of a rocker, the crank's angles over both, where long enough."""
        out, found = self.study.output, self.extremes
        for slide in other_sliders(self.study.mechanism, out) if EXTREMES in self.study.plans else ():
            extremes = self.comparison.road.extremes(Output(slide.slider, slide.point))
            yield from self._stroke(f"H_{slide.point}", extremes) if extremes is not None else ()
        if found is None:
            return
        if (counted := output_way(self.study.mechanism, out)) is not None:
            yield from chain(*(self._stroke(name, found) for name in ("H", f"H_{counted[0]}")))
        yield from self._arc("ψ", found.stroke)
        for index, arc in zip(("index.work", "index.idle"), found.angles, strict=True):
            yield from self._arc(f"φ_{{{word(self.study.language, index)}}}", arc)

    @cached_property
    def extremes(self) -> Extremes | None:
        """The extreme positions of the output, where they are asked for."""
        return None if self.study.travel is None else self.comparison.road.extremes(self.study.output)

    def _slack(self, name: str) -> float:
        """How far rounding can have moved a stroke or the crank's angle there."""
        return next((float(f.allowed[0]) for f in self.comparison.of("extremes") if f.name == name), 0.0)

    def _stroke(self, name: str, found: Extremes) -> Iterator[Expected]:
        slack = self._slack("H")
        row = Expected(Kind.LENGTH, POSITIONS.plan, name, found.stroke, slack, may_lack=True)
        yield from measured(row, 1000 * found.stroke)

    def _arc(self, name: str, arc: float) -> Iterator[Expected]:
        slack = 2 * self._slack("H" if name == "ψ" else "θ")
        yield Expected(Kind.ANGLE, POSITIONS.plan, name, abs(arc), slack + TURNED, may_lack=True)
        yield Expected(Kind.PHRASE, POSITIONS.plan, name, math.degrees(abs(arc)), math.degrees(slack), may_lack=True)

    def notes(self) -> Iterator[Expected]:
        """Give the results that notes and report tell: stroke, time ratio, pressure angles."""
        if (found := self.extremes) is not None:
            slack, turned = self._slack("H"), self._slack("θ")
            size, unit = ("H", 1000.0) if found.sliding else ("ψ", math.degrees(1))
            rests = 0 if self.study.travel is None else len(self.study.travel.rests)
            yield from phrases(NOTES, [(size, unit * found.stroke, unit * slack)])
            named = f"{size}, {'m' if found.sliding else 'rad'}"
            yield from phrases(NOTES, [(named, found.stroke, slack)], may_lack=True)
            ratio = 2 * math.pi / (math.pi - found.overlap) ** 2 if found.overlap < math.pi else math.inf
            figures = ("θ", math.degrees(found.overlap), math.degrees(turned)), ("K", found.ratio, ratio * turned)
            yield from phrases(NOTES, figures, may_lack=rests > 2)
        for group in self.study.groups:
            pressure = interval(self.study.sweep, group, self.study.nodes)
            angles = ("low", pressure.low), ("high", pressure.high)
            rows = ((f"{name} {group.label}", math.degrees(angle), 0.0) for name, angle in angles)
            yield from phrases(NOTES, rows, may_lack=True)

    def plans(self) -> Iterator[Expected]:
        """Give the vectors of the plans that are shown; of a position that cannot be assembled there are none."""
        gone = {gap.position for gap in self.comparison.construction.gaps}
        for leaf in self.leaves:
            for plan, k in leaf.metadata["vectors"]:
                if k not in gone:
                    yield from self._vectors.rows(plan, k, leaf.metadata["scales"][f"{plan}-{k}"])

    @cached_property
    def _vectors(self) -> VectorPlans:
        keys = frozenset(chain(*map(stated_keys, self.leaves)))
        return VectorPlans(self.study, self.comparison, self.masses, self.drafting, keys)

    def values(self) -> Iterator[Expected]:
        """Give the cells of the table of values: by plan and by analysis, drawing error."""
        positions = sorted({k for leaf in self.leaves for k in leaf.metadata["plans"]})
        if not positions:
            return
        keys = frozenset(chain(*map(stated_keys, self.leaves)))
        hand = MotionByHand(self.study, self.comparison, self.masses)
        scales = {name: mu for leaf in self.leaves for name, mu in leaf.metadata["scales"].items()}
        errors = hand.on_sheet(positions, scales)
        findings = value_table.listed(self.comparison, self._vectors.parts, hand.given)
        for same in alike(findings, self.study.mechanism, self.masses):
            row, first = value_table.label(same, self.drafting.language), same[0]
            most = np.nanmax(np.abs(first.analysis), initial=0.0)
            lost = bool(most <= 2 * np.nanmax(first.allowed, initial=0.0))  # no more than rounding anywhere
            for k in positions:
                value = first.analysis[k]
                size = float(abs(value) if np.iscomplexobj(value) else value), float(first.allowed[k])
                error = math.nan if math.isnan(size[0]) else errors.get((first.name, k), math.nan)
                yield from by_roads(VALUES, row, size, by_hand(error, first.largest), k, keys, lost)


def named(findings: Sequence[Quantity], language: str) -> dict[str, Quantity]:
    """Give findings of velocities and accelerations by their letters as they are read."""
    plans = [order.plan for order in ORDERS[1:]]
    names = ((finding.name.partition("_"), finding) for finding in findings if finding.plan in plans)
    marked = ((f"{symbol}_{{{index}}}", finding) for (symbol, _, index), finding in names)
    return {Text(0j, letter(language, markup)).plain: finding for markup, finding in marked}
