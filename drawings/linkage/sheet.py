"""The sheets of a linkage: of its kinematics, and of its positions alone (листы рычажного механизма)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, Final

from drawings.diagrams import rows, scales
from drawings.diagrams.report import diagram_notes, output_table
from drawings.kinds.working import Workings
from drawings.layout import value_table
from drawings.layout.contents import Panel
from drawings.layout.picture import Picture, Spot
from drawings.layout.table import RuledTable
from drawings.linkage import positions, vector_plan
from drawings.linkage.due import expected
from drawings.linkage.notes import notes
from drawings.linkage.positions import facts_of, force_positions, of_linkage, plans, position, shown_positions
from drawings.linkage.skeleton import Skeletons, skeletons
from drawings.linkage.vector_plan import Diagrams, diagrams, draw_missing, link_working, plan_working
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf, SheetError
from drawings.sheets.kind import FRAME, GRAPH, PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, captions, exhibit
from plans.diagrams.study import DiagramsStudy
from plans.linkage.parts import MotionByHand, alike
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.motion import ORDERS, POSITIONS, VELOCITIES
from plans.study import Study


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the kinematics sheets of a scene."""
    return sheets(study.of(LinkageStudy), study.of(MotionComparison), study.of(DiagramsStudy), _loaded(study))


def sheets(
    study: LinkageStudy, comparison: MotionComparison, output: DiagramsStudy | None = None, beside: tuple[int, ...] = ()
) -> tuple[Leaf, ...]:
    """Lay out the kinematics sheets; of the positions `beside` the same set has force sheets."""
    return lay_out(study.scene, [_KinematicsSheet(study, comparison, output, beside).draft])


def _loaded(study: Study) -> tuple[int, ...]:
    """Give the positions whose forces the set draws: their inertia forces are taken from the plans of these."""
    if "forces" not in study.scene.sheets:
        return ()
    from plans.forces.quantities import ForceComparison  # noqa: PLC0415  (only a scene with force sheets needs them)
    from plans.forces.statics import Statics  # noqa: PLC0415

    try:
        return force_positions(study.of(Statics), study.of(ForceComparison))
    except SheetError:
        return ()  # the force sheets say why there are none


@dataclass(frozen=True, eq=False, repr=False)
class _KinematicsSheet:
    """What a set of kinematics sheets is drawn from; nothing is made that the scene's sheets do not need."""

    study: LinkageStudy
    comparison: MotionComparison
    output: DiagramsStudy | None  # None: neither the output's diagrams nor their table are shown
    beside: tuple[int, ...] = ()

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.study.scene)

    @property
    def draft(self) -> Draft:
        """Title, figures, table and notes of the sheets."""
        words = notes(self.study, self.comparison, self.drafting.language)
        if self.output is not None:
            words += diagram_notes(self.output, self.drafting)
        title = self.drafting.word("sheet title")
        figures: tuple[Exhibit, ...] = (*shown_positions(self.bones, self.drafting), *self._plans(), *self._diagrams())
        shows: tuple[Exhibit | Caption, ...] = (*figures, *captions(self._workings()))
        course = (output_table(self.output, self.drafting),) if self.output and self.output.shown else ()
        tables, remarks = (*self._values(), *course), self._remarks if self._common else None
        facts, later = self._facts, lambda scales: self.by_hand.on_sheet(self.positions, scales)
        return Draft("kinematics", title, shows, tables, tuple(words), facts, later=later, remarks=remarks)

    @property
    def _common(self) -> bool:
        return self.study.scene.sheet.scales == "common"

    @cached_property
    def shown(self) -> int:
        return position(self.study, self.comparison.construction, self.beside)

    @cached_property
    def positions(self) -> tuple[int, ...]:
        """The positions whose plans are drawn."""
        return plans(self.study, self.comparison, self.shown, self.beside)

    @cached_property
    def bones(self) -> Skeletons:
        return skeletons(self.study, self.comparison.construction, self.shown)

    def _plans(self) -> list[Exhibit]:
        """The plans of each position, which stand together."""
        return [self._plan(order.plan, k) for order in ORDERS[1:] for k in self.positions]

    def _plan(self, subject: str, k: int) -> Exhibit:
        """A plan, or in its place why it is not drawn."""
        name, shown = f"{subject}-{k}", self._shown_plans[subject, k]
        if not self._is_whole(subject, k):
            gap = next((g for g in self.comparison.construction.gaps if g.position == k), None)
            reason = self.drafting.word(gap.reason) if gap else ""
            plan = self.drafting.word(f"{subject} plan")
            why = self.drafting.word("no plan", plan=plan, position=k, reason=reason)
            absent = vector_plan.measure_missing(why, name, self.drafting)
            return Exhibit(Panel(absent, together=str(k)), partial(draw_missing, why, name, drafting=self.drafting))
        return exhibit(vector_plan, shown, self.drafting, together=str(k), scale=subject if self._common else "")

    def _workings(self) -> Iterator[Workings]:
        """How the plans are laid off and read: beside them, where paper would stay bare."""
        mechanism = self.study.mechanism
        yield link_working(mechanism, list(mechanism.links), POSITIONS.plan, self.drafting)
        for subject, k in ((order.plan, k) for order in ORDERS[1:] for k in self.positions):
            if self._is_whole(subject, k):
                yield plan_working(self._shown_plans[subject, k], f"{subject}-{k}", self.drafting)
        if self.output is not None and self.output.shown:
            yield scales.working(self.output, self.drafting)

    def _is_whole(self, subject: str, k: int) -> bool:
        return not self.study.lost[k] and self._shown_plans[subject, k].is_whole

    def _diagrams(self) -> list[Exhibit]:
        """The output's diagrams, one under another."""
        if self.output is None or not self.output.shown:
            return []
        room = rows.measure(self.output, self.drafting)
        return [Exhibit(Panel(room), partial(rows.draw, self.output, drafting=self.drafting))]

    @cached_property
    def _shown_plans(self) -> Diagrams:
        return diagrams(self.study, self.comparison.analysis, self.positions)

    def _remarks(self, spots: Mapping[str, Spot]) -> tuple[str, ...]:
        """Say why a plan has another scale than the others of its kind."""
        plans = (exhibit.panel.item for exhibit in self._plans())
        return tuple(vector_plan.remarks([plan for plan in plans if isinstance(plan, Picture)], spots, self.drafting))

    def _values(self) -> tuple[RuledTable, ...]:
        """The table of values, if there is anything to tell."""
        if not self.positions:
            return ()
        by_hand, masses = self.by_hand, self.bones.masses
        findings = value_table.listed(self.comparison, by_hand.parts, by_hand.given)
        same = alike(findings, self.study.mechanism, masses)
        lines = value_table.rows(same, self.positions, self.drafting.language)
        return (value_table.table(lines, self.positions, self.drafting),) if lines else ()

    @cached_property
    def by_hand(self) -> MotionByHand:
        return MotionByHand(self.study, self.comparison, self.bones.masses)

    def _facts(self, names: Collection[str]) -> dict[str, Any]:
        return {
            **facts_of(self.study, self.shown, names),
            "diagrams": rows.NAME in names,
            "plans": [k for k in self.positions if f"{VELOCITIES.plan}-{k}" in names],
            "vectors": [
                (order.plan, k) for k in self.positions for order in ORDERS[1:] if f"{order.plan}-{k}" in names
            ],
        }


LENGTHS: Final = {"positions": "length"}
MOTION: Final = {"velocities-": "velocity", "accelerations-": "acceleration", "diagrams": "angle"}
SHOWN: Final = {"positions": FRAME}
COURSES = ("diagrams-travel", "diagrams-velocity", "diagrams-acceleration")
FORM: Final = {**SHOWN, "velocities-": PLAN, "accelerations-": PLAN, **dict.fromkeys(COURSES, GRAPH)}
SHEETS: Final = {
    "kinematics": SheetKind(
        leaves, expected, {**LENGTHS, **MOTION}, of_linkage, figures=FORM, tables=("values", "output")
    ),
    "positions": SheetKind(positions.leaves, expected, LENGTHS, of_linkage, figures=SHOWN),
}
