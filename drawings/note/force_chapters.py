"""The chapters of a note on forces: the equations of the drawn positions, before the tables of all (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from drawings.figures.forces.lever_layout import PLAN as LEVER
from drawings.note.cut_equations import CutEquations, ForceValues
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.walk import groups
from drawings.report.chapters import Chapters
from drawings.report.forces import force_report
from drawings.report.formula import Formula, display, inline
from drawings.report.linkage.equations_chapter import in_position
from drawings.report.markdown import chapter, header, row
from geometry.board import Mark
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import Cut
from plans.forces.lever import Lever
from plans.forces.statics import Statics
from plans.model.kinetostatics import NOTHING
from plans.study import Study
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf


def lever_equation(lever: Lever, written: CutEquations, mu: float) -> Iterator[str]:
    """Write the moments of all forces about the pole of the turned plan, and the balancing moment that they ask for.

    `mu` is the lever's scale, (m/s)/mm: the moments on paper, N*mm, times the scale are powers, W.
    """
    formula, drive = written.formula, written.values.plan.mechanism.drive
    language, sigma = formula.drafting.language, formula.letter("Σ")
    powers = _powers(lever, written)
    yield word(language, "report.lever")
    yield from display(rf"{sigma} M_{{p}}(F_{{i}}) + M_{{p}}({formula.letter('P_bal')}) = 0")
    yield from header([word(language, f"table.{head}") for head in ("force", "size", "lever_arm", "lever_moment")])
    forces = {one.name: one.force for one in lever.loads}
    for name, power in powers.items():
        yield _row(name, power / mu, forces.get(name), written)
    whole, omega = _sum(powers), written.values.rate
    yield row([f"${sigma}$", "", "", f"${formula.number(whole / mu)}$"])
    yield ""
    letters = f"-{formula.letter('μ_v')} {sigma} M_{{p}} / {formula.letter(f'ω_{drive.link}')}"
    product = rf"-{formula.number(mu)} \cdot {formula.factor(whole / mu)} / {formula.factor(omega)}"
    moment = formula.quantity(-whole / omega, "N*m")
    yield f"- {inline(formula.letter('M_bal'), letters, product, moment)}"


def _powers(lever: Lever, written: CutEquations) -> dict[str, float]:
    """Give the powers of all forces and couples, W; one of a moment on the shaft that is none is none either."""
    powers = {name: written.values.power(name, mark) for name, mark in lever.moments}
    least = written.nothing[1] * abs(written.values.rate)
    return {name: power if abs(power) > least else 0.0 for name, power in powers.items()}


def _sum(powers: Mapping[str, float]) -> float:
    """Add powers up; what is but rounding of the largest is none."""
    whole = sum(powers.values())
    return whole if abs(whole) > NOTHING * max(map(abs, powers.values())) else 0.0


def _row(name: str, moment: float, force: Mark | None, written: CutEquations) -> str:
    """Write a force with its arm, mm; a couple has its moment alone."""
    formula = written.formula
    size = 0.0 if force is None else abs(written.values.force(name, force))
    cells = ["", ""]
    if size > written.nothing[0]:
        cells = [f"${formula.number(size)}$", f"${formula.number(abs(moment) / size)}$"]
    return row([f"${written.letter(name)}$", *cells, f"${formula.number(moment)}$"])


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


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the forces of a linkage."""
    own = force_report.chapters(study, leaves)
    told = equations(study["forces"], study.comparison("forces"), drawn_scales(leaves))
    return own._replace(values=[*told, *own.values])
