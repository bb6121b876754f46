"""The chapter of a note on forces: the equations of each cut and the lever, by positions (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from drawings.figures.forces.lever_layout import PLAN as LEVER
from drawings.note.cut_equations import CutEquations, ForceValues
from drawings.note.lever_equation import lever_equation
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.walk import groups
from drawings.report.formula import Formula
from drawings.report.linkage.equations_chapter import in_position
from drawings.report.markdown import chapter
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import Cut
from plans.forces.statics import Statics
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

POLYGON = "forces-"  # before the links of a cut: the name of its force plan
Scales = Mapping[int, Mapping[str, float]]  # of force plans and levers by their names, by position


def drawn_scales(leaves: Mapping[str, Sequence[Leaf]]) -> dict[int, dict[str, float]]:
    """Give the scales of the force plans and levers of the force sheets, by position."""
    found: dict[int, dict[str, float]] = {}
    for leaf in (leaf for own in leaves.values() for leaf in own if "position" in leaf.metadata):
        own = found.setdefault(int(leaf.metadata["position"]), {})
        for mark in groups(leaf.groups):
            plan = mark.data.get("plan", "")
            if plan == LEVER or plan.startswith(POLYGON):
                own[plan] = float(mark.data["scale"])
    return found


def equations(
    statics: Statics,
    comparison: ForceComparison,
    scales: Scales,
    drafting: Drafting | None = None,
) -> Iterator[str]:
    """Write the equations of forces in the positions of the force sheets."""
    language, plans = statics.study.language, statics.drafts().plans
    formula = Formula(drafting or drafting_of_forces(statics))
    if scales:
        yield chapter(language, "force_equations")
        yield word(language, "report.underlines")
    for k, own in sorted(scales.items()):
        told = ForceValues(plans.plan, k)
        force, moment = (float(one.min()) for one in comparison.construction.nothing_over)
        written = CutEquations(told, formula, comparison.construction.nothing_at(k), (force, moment))
        yield in_position(statics.study, k).removesuffix("\n")
        for cut in plans.plan.cuts:
            yield from _cut(cut, replace(written, scale=own.get(f"{POLYGON}{cut.label}")))
        if plans.lever is not None and LEVER in own and plans.plan.mechanism.drive.turns:
            yield from lever_equation(plans.lever, written, own[LEVER])


def drafting_of_forces(statics: Statics) -> Drafting:
    """Letter reactions as the sheets do."""
    return drafting_of(statics.study.scene)._replace(reactions=statics.form.sheet.reactions)


def _cut(cut: Cut, written: CutEquations) -> Iterator[str]:
    """Write a cut: what is given of it, then its equations, each on a line of its own."""
    language = written.formula.drafting.language
    yield word(language, "report.cut" if cut.group is not None else "report.primary_cut", links=cut.label)
    yield from (f"- {line}" for line in written.given(cut))
    for line in written.lines(cut):
        yield f"\n{line}\n" if line.startswith("$$") else line
