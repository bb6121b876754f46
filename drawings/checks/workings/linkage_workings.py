"""The self-check of workings on the sheets of a linkage: lengths laid off, velocities and accelerations read off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from drawings.checks.graphs.figure_strokes import read
from drawings.checks.linkage.laid import mass_centres
from drawings.checks.workings.due_line import DueLine, Quantity, faults, laid_off, scaled
from drawings.checks.wrong import Wrong
from drawings.figures.linkage.vector_plan import LEAST
from drawings.figures.workings.working import LENGTHS, READING
from drawings.lettering.indices import with_index
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from plans.checks.compare import MotionComparison
from plans.checks.comparison import Finding
from plans.checks.parts import findings, spans
from plans.linkage.letters import POLES
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME, Mechanism
from plans.model.order import ORDERS, POSITIONS, Order


def of_linkage(measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: MotionComparison) -> Iterator[Wrong]:
    """Hold the workings of a kinematics sheet, by the plans that they stand beside."""
    drafting = drafting_of(study.scene)
    for group in leaf.groups:
        kind, _, figure = group.name.partition("-")
        mu = leaf.metadata.get("scales", {}).get(figure, 0.0)
        if kind == LENGTHS and figure == POSITIONS.plan:
            links = list(study.mechanism.links)
            yield from faults(group, lengths(study.mechanism, links, mu, drafting), figure, drafting)
        if kind == READING:
            order = next(one for one in ORDERS if one.plan == figure.partition("-")[0])
            k = int(figure.partition("-")[2])
            names = {one.name for one in measured.vectors if (one.plan, one.position) == (order.plan, k)}
            due = _Plan(study, comparison, order, k, mu).lines(names, drafting)
            yield from faults(group, list(due), order.plan, drafting)


def lengths(mechanism: Mechanism, links: Sequence[int], mu: float, drafting: Drafting) -> list[DueLine]:
    """Give the lines by which the lengths of some links are laid off at a scale, m/mm."""
    ends = (pair for link in links for pair in combinations(mechanism.links[link].points.items(), 2))
    return [
        laid_off(read(f"l_{{{first}{last}}}"), _segment(first, last), "l", Quantity(abs(end - start)), mu, drafting)
        for (first, start), (last, end) in ends
        if end != start
    ]


def _segment(start: str, end: str) -> str:
    """Name a segment by the letters of its ends as they are read."""
    return read(with_index(start)) + read(with_index(end))


class _Plan:
    """What is read off the plan of one position, at its scale, by the analysis."""

    def __init__(self, study: LinkageStudy, comparison: MotionComparison, order: Order, k: int, mu: float) -> None:
        self.study, self.comparison, self.order, self.k, self.mu = study, comparison, order, k, mu

    def lines(self, names: set[str], drafting: Drafting) -> Iterator[DueLine]:
        """Give the lines that are due: all points, and the parts whose vectors are drawn, by their names."""
        plan, symbol = self.study.drafts().plan(self.order.number), self.order.point.symbol
        fixed, told = self.study.mechanism.links[FRAME].points, set[str]()
        for one in self.comparison.of(self.order.plan):
            point = one.name.partition("_")[2]
            if one.unit == self.order.point.unit and point not in fixed:
                told.add(one.name)
                yield self._line(one, POLES[self.order.plan], plan.point(point).name, drafting)
        masses = mass_centres(self.study)
        ends = spans(self.study, self.study.drafts(), self.comparison.analysis, masses)
        for one in findings(self.study, self.comparison, masses):
            if one.plan == self.order.plan and one.name not in told:
                start, end = ends[one.name].start.name, ends[one.name].end.name
                due = self._line(one, start, end, drafting)
                own = f"{start} {end}" in names or one.name.startswith(f"{symbol}_S")
                yield due if own else due._replace(none=float("inf"))

    def _line(self, one: Finding, start: str, end: str, drafting: Drafting) -> DueLine:
        quantity = Quantity(abs(complex(one.analysis[self.k])), 2 * float(one.allowed[self.k]), one.unit)
        letter, symbol = read(drafting.letter(with_index(one.name))), self.order.point.symbol
        return scaled(letter, _segment(start, end), symbol, quantity, self.mu, drafting)._replace(none=LEAST * self.mu)
