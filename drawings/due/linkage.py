"""What must stand on the sheets of a linkage, by the analysis alone: positions, strokes, values, notes (кинематика)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import TYPE_CHECKING, cast

import numpy as np

from drawings.checks.expected import Expected, by_hand
from drawings.due import diagrams
from drawings.due.vector_plans import VectorPlans
from drawings.layout import value_table
from drawings.layout.table import cell_name
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.statement import Kind
from drawings.paper.strokes import Leaf
from plans.analytic.balance.mass_centre import placed
from plans.checks.compare import MotionComparison
from plans.checks.comparison import Finding
from plans.checks.hand.motion import MotionByHand
from plans.checks.parts import alike
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Link
from plans.model.order import ORDERS, POSITIONS
from plans.study import Study

if TYPE_CHECKING:
    from plans.forces.reading.form import ForceForm

VALUES = "values"  # the table of values
NEAR = 1e-3  # share of a link's length: a mass centre nearer to a named point than this is that point


def due(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's linkage (row of the table of sheets)."""
    own = _Linkage(study["linkage"], study.comparison("linkage"), drafting_of(study.scene), leaves)
    yield from chain(own.points(), own.plans(), own.values())
    if any("diagrams" in leaf.metadata for leaf in leaves):
        yield from diagrams.due(study, leaves)


def mass_centres(study: LinkageStudy) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that no point of the scene is or names: link, and place in its own frame."""
    form, links = cast("ForceForm | None", study.scene.part("forces")), study.mechanism.links
    masses = form.masses.items() if form else ()
    found = {f"S{number}": (number, mass.place(links[number])) for number, mass in masses if number != FRAME}
    known = {name for link in links.values() for name in link.points}
    return {name: own for name, own in found.items() if name not in known and not _on_a_point(links[own[0]], own[1])}


def _on_a_point(link: Link, own: complex) -> bool:
    """Tell whether a mass centre lies on a named point of its link, or nearer to it than is seen."""
    off = [abs(place - own) for place in link.points.values()]
    return min(off) <= NEAR * max(off)


@dataclass(frozen=True)
class _Linkage:
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

    def points(self) -> Iterator[Expected]:
        """Give the points and the mass centres of the position in full lines; one at a gap has no place."""
        k = self.shown
        if k is None:
            return
        fixed, moved = self.study.mechanism.links[FRAME].points, self.comparison.analysis
        slack = {one.name: float(one.allowed[k]) for one in self.comparison.of(POSITIONS.plan)}
        most = 2 * max((one for one in slack.values() if math.isfinite(one)), default=0.0)
        places = {name: (complex(moved.points[name].r[k]), slack[f"r_{name}"]) for name in moved.points if name not in fixed}
        places |= {name: (place, 0.0) for name, place in fixed.items()}
        for name, (link, own) in self.masses.items():
            places[name] = complex(placed(self.study.mechanism, moved, link, own)[k]), most
        for name, (place, allowed) in places.items():
            if not math.isnan(place.real):
                lost = name in fixed  # the one that all places are measured from is no point
                yield Expected(Kind.POINT, POSITIONS.plan, name, place, allowed, k, may_lack=lost)

    def plans(self) -> Iterator[Expected]:
        """Give the vectors of the plans that are shown; of a position that cannot be assembled there are none."""
        gone = {gap.position for gap in self.comparison.construction.gaps}
        for leaf in self.leaves:
            for plan, k in leaf.metadata["vectors"]:
                if k not in gone:
                    yield from self._vectors.rows(plan, k, leaf.metadata["scales"][f"{plan}-{k}"])

    @cached_property
    def _vectors(self) -> VectorPlans:
        return VectorPlans(self.study, self.comparison, self.masses, self.drafting)

    def values(self) -> Iterator[Expected]:
        """Give the cells of the table of values: by plan, by analysis, by hand."""
        positions = sorted({k for leaf in self.leaves for k in leaf.metadata["plans"]})
        if not positions:
            return
        hand = MotionByHand(self.study, self.comparison, self.masses)
        scales = {name: mu for leaf in self.leaves for name, mu in leaf.metadata["scales"].items()}
        errors = hand.on_sheet(positions, scales)
        told = value_table.told(self.comparison, self._vectors.parts, hand.given)
        for same in alike(told, self.study.mechanism, self.masses):
            row, first = value_table.label(same, self.drafting.language), same[0]
            for k in positions:
                names, value = [cell_name(row, column) for column in range(3)], first.analysis[k]
                size = float(abs(value)) if np.iscomplexobj(value) else float(value)
                slack, lost = float(first.allowed[k]), not is_something(first)
                for name in names[:2]:
                    yield Expected(Kind.NUMBER, VALUES, name, size, slack, k, may_lack=lost)
                error = math.nan if math.isnan(size) else errors.get((first.name, k), math.nan)
                yield by_hand(VALUES, names[2], error, first.largest, k)._replace(may_lack=lost)


def is_something(one: Finding) -> bool:
    """Tell whether a finding is more than rounding in some position, by the analysis."""
    most = np.nanmax(np.abs(one.analysis), initial=0.0)
    return bool(most > 2 * np.nanmax(one.allowed, initial=0.0))
