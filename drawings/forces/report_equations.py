"""The chapters of a note on forces: the equations of the drawn positions, before the tables of all (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from drawings.forces.acting import acting, cut_links
from drawings.forces.arms import Leverage, leverages
from drawings.forces.letters import letter_of
from drawings.forces.lever import PLAN as LEVER
from drawings.linkage.equations import in_position
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups
from drawings.report.formula import DIRECTION, FULL, Formula, display, inline, total
from drawings.report.report import chapter, header, row
from geometry.board import Mark, at
from geometry.meet import cross
from plans.forces.cut import CLOSING, LOAD, REACTION, Couple, CutGroup, ForcePlan, MomentEquation
from plans.forces.lever import Lever
from plans.forces.quantities import ForceComparison
from plans.forces.statics import Statics
from plans.model.motion import FORCES, NOTHING
from plans.study import Study
from plans.words.words import word


@dataclass(frozen=True)
class CutEquations:
    """Writes what a cut gives in one position: `nothing` are the force N and the moment N*m below which there is none.

    `scale` is that of the cut's force plan, N/mm; None where it is not drawn.
    """

    plan: ForcePlan
    column: int
    formula: Formula
    nothing: tuple[float, float]
    usual: tuple[float, float] = (0.0, 0.0)  # N, N*m: below it what is given is none, also beside a jam
    scale: float | None = None

    @property
    def rate(self) -> float:
        """The angular velocity of the crank, rad/s."""
        arm, turning = self.plan.velocities.readings[self.plan.mechanism.drive.link]
        along, across = self.value(arm), self.value(turning)
        return float(cross(along, across)) / abs(along) ** 2

    def value(self, mark: Mark) -> complex:
        """Give a force N, or a moment N*m or W as a real number."""
        return at(mark.point, self.column)

    def lines(self, cut: CutGroup) -> Iterator[str]:
        """Write the equations of moments with what they give, the equation of forces, and the reactions."""
        arms = leverages(self.plan, cut, self.column)
        for equation in cut.equations:
            yield from () if cut.holds(equation) else self._moments(equation, arms, cut)
        # Write the part along a slot, which holds nothing along it.
        for part in (part for support in cut.supports for part in support.parts if part.name.startswith("R^u")):
            size = self._sized(abs(self.value(part)))
            known = rf"-{self.formula.letter('Σ')} {self.formula.letter('F_u')}"
            yield f"- {inline(self.letter(part.name), known, self.formula.quantity(size, 'N'))}"
        yield from self._forces(cut)
        yield from self._reactions(cut)
        for equation in cut.equations:
            yield from self._moments(equation, arms, cut) if cut.holds(equation) else ()
        for shift in acting(self.plan, cut, cut_links(self.plan, cut, self.column), self.column).shifts:
            name, moment, force = (self.letter(shift.name.replace("x", kind, 1)) for kind in "xMR")
            yield f"- {inline(name, f'|{moment}| / {force}', self.formula.quantity(abs(shift.end - shift.start), 'm'))}"

    def given(self, cut: CutGroup) -> Iterator[str]:
        """Write the weights, inertia forces and couples of a cut's links, and its loads."""
        for load in (load for load in cut.loads if load.kind != REACTION):
            size = abs(self.value(load.force))
            size = size if size > self.usual[0] else 0.0
            if size or load.kind != LOAD:
                source = self._source(load.name, load.link, size)
                yield inline(self.letter(load.name), *source, self.formula.quantity(size, "N"))
        for couple in (couple for couple in cut.couples if couple.kind != REACTION):
            value = self._value(couple)
            source = self._source(couple.name, couple.link, value)
            yield inline(self.letter(couple.name), *source, self.formula.quantity(value, "N*m"))

    def letter(self, name: str) -> str:
        """Write a force's name in math."""
        return self.formula.letter(letter_of(name, self.formula.drafting))

    def _source(self, name: str, link: int, value: float) -> Iterator[str]:
        """Write from what a weight, an inertia force or couple comes, in letters and numbers: G_3 = m_3 g."""
        letter, number, machine = self.formula.letter, self.formula.number, self.plan.machine
        body = machine.bodies.get(link)
        if body is None:
            return
        mass, inertia = letter(f"m_{link}"), letter(f"J_{link}")
        sources = {
            f"G_{link}": (f"{mass} g", body.mass, abs(machine.gravity)),
            f"Φ_{link}": (f"{mass} {letter(f'a_{{S_{{{link}}}}}')}", body.mass, value / (body.mass or 1.0)),
            f"M^Φ_{link}": (f"-{inertia} {letter(f'ε_{link}')}", -body.inertia, -value / (body.inertia or 1.0)),
        }
        if name in sources:
            letters, factor, other = sources[name]
            yield letters
            yield rf"{number(factor)} \cdot {self.formula.factor(other)}"

    def _moments(self, equation: MomentEquation, arms: tuple[Leverage, ...], cut: CutGroup) -> Iterator[str]:
        formula, unknown = self.formula, equation.found.name
        armed = [arm for arm in arms if arm.equation is equation]
        about = armed[0].about if armed else equation.about.name
        lever_arm = next((arm for arm in armed if arm.name == unknown), None)
        loads = {load.name: load.force for load in equation.loads}
        acting = {name for name, mark in loads.items() if self._sized(abs(self.value(mark)))}
        others = [arm for arm in armed if arm.name in acting]
        couples = [pair for pair in equation.couples if self._value(pair)]
        letters = [_signed(arm.sense, f"{self.letter(arm.name)} {formula.letter(arm.letter)}") for arm in others]
        letters += [self.letter(couple.name) for couple in couples]
        if not letters:
            return
        found = self.letter(unknown)
        first = found if lever_arm is None else _signed(lever_arm.sense, f"{found} {formula.letter(lever_arm.letter)}")
        yield rf"$$\sum M_{{{about}{cut.sum_of(equation)}}} = {total([first, *letters])} = 0$$"
        sign = -1 if lever_arm is None else -lever_arm.sense
        sizes = {load.name: formula.number(abs(self.value(load.force))) for load in equation.loads}
        products = (rf"{sizes[arm.name]} \cdot {formula.number(arm.length)}" for arm in others)
        numbers = [_signed(sign * arm.sense, product) for arm, product in zip(others, products, strict=True)]
        moments = [sign * self.value(couple.moment).real for couple in couples]
        numbers += [formula.number(value) for value in moments]
        yield f"- {inline(found, self._solved(numbers, lever_arm), self._found(equation))}"

    def _solved(self, numbers: list[str], arm: Leverage | None) -> str:
        whole = total(numbers)
        if arm is None:
            return whole
        return f"({whole}) / {self.formula.number(arm.length)}"

    def _found(self, equation: MomentEquation) -> str:
        if equation.line is None:
            value = self._turned(self.value(equation.found).real)
            return self.formula.quantity(value, "N*m")
        return self.formula.quantity(self._sized(abs(self.value(equation.found))), "N")

    def _forces(self, cut: CutGroup) -> Iterator[str]:
        closers = [side for side in cut.sides if side.kind == CLOSING]
        known = DIRECTION if len(closers) > 1 else 0
        terms = [
            self.formula.vector(letter_of(side.name, self.formula.drafting), known if side.kind == CLOSING else FULL)
            for side in cut.sides
            if side.kind == CLOSING or self._sized(abs(self.value(side.end) - self.value(side.start)))
        ]
        if len(terms) > 1:
            yield f"$${' + '.join(terms)} = 0$$"

    def _reactions(self, cut: CutGroup) -> Iterator[str]:
        formula = self.formula
        for support in cut.reactions:
            size = self._sized(abs(self.value(support.force)))
            measured = []
            if self.scale is not None and size:
                measured = [rf"{formula.number(size / self.scale)} \cdot {formula.number(self.scale)}"]
            yield f"- {inline(self.letter(support.force.name), *measured, formula.quantity(size, 'N'))}"

    def _sized(self, force: float) -> float:
        return force if force > self.nothing[0] else 0.0

    def _value(self, couple: Couple) -> float:
        value = self.value(couple.moment).real
        return self._turned(value) if couple.kind == REACTION or abs(value) <= self.usual[1] else value

    def _turned(self, moment: float) -> float:
        return moment if abs(moment) > self.nothing[1] else 0.0


def _signed(sense: int, product: str) -> str:
    return product if sense > 0 else f"-{product}"


def lever_equation(lever: Lever, written: CutEquations, mu: float) -> Iterator[str]:
    """Write the moments of all forces about the pole of the turned plan, and the balancing moment that they ask for.

    `mu` is the lever's scale, (m/s)/mm: the moments on paper, N*mm, times the scale are powers, W.
    """
    formula, drive = written.formula, written.plan.mechanism.drive
    language, sigma = formula.drafting.language, formula.letter("Σ")
    powers = _powers(lever, written)
    yield word(language, "report.lever")
    yield from display(rf"{sigma} M_{{p}}(F_{{i}}) + M_{{p}}({formula.letter('P_bal')}) = 0")
    yield from header([word(language, f"table.{head}") for head in ("force", "size", "lever_arm", "lever_moment")])
    forces = {load.name: load.force for load in lever.loads}
    for name, power in powers.items():
        yield _row(name, power / mu, forces.get(name), written)
    whole, omega = _sum(powers), written.rate
    yield row([f"${sigma}$", "", "", f"${formula.number(whole / mu)}$"])
    yield ""
    letters = f"-{formula.letter('μ_v')} {sigma} M_{{p}} / {formula.letter(f'ω_{drive.link}')}"
    product = rf"-{formula.number(mu)} \cdot {formula.factor(whole / mu)} / {formula.factor(omega)}"
    moment = formula.quantity(-whole / omega, "N*m")
    yield f"- {inline(formula.letter('M_bal'), letters, product, moment)}"


def _powers(lever: Lever, written: CutEquations) -> dict[str, float]:
    powers = {name: written.value(mark).real for name, mark in lever.moments}
    least = written.nothing[1] * abs(written.rate)
    return {name: power if abs(power) > least else 0.0 for name, power in powers.items()}


def _sum(powers: Mapping[str, float]) -> float:
    whole = sum(powers.values())
    return whole if abs(whole) > NOTHING * max(map(abs, powers.values())) else 0.0


def _row(name: str, moment: float, force: Mark | None, written: CutEquations) -> str:
    formula = written.formula
    size = 0.0 if force is None else abs(written.value(force))
    cells = ["", ""]
    if size > written.nothing[0]:
        cells = [f"${formula.number(size)}$", f"${formula.number(abs(moment) / size)}$"]
    return row([f"${written.letter(name)}$", *cells, f"${formula.number(moment)}$"])


POLYGON = "forces-"  # before the links of a cut: the name of its force plan
Scales = Mapping[int, Mapping[str, float]]  # of force plans and levers by their names, by position


def drawn_scales(leaves: Mapping[str, Sequence[Leaf]]) -> dict[int, dict[str, float]]:
    """Give the scales of the force plans and levers of the force sheets, by position."""
    found: dict[int, dict[str, float]] = {}
    for leaf in (leaf for sheets in leaves.values() for leaf in sheets if "position" in leaf.metadata):
        scales = found.setdefault(int(leaf.metadata["position"]), {})
        for mark in groups(leaf.groups):
            plan = mark.data.get("plan", "")
            if plan == LEVER or plan.startswith(POLYGON):
                scales[plan] = float(mark.data["scale"])
    return found


def equations(statics: Statics, comparison: ForceComparison, drafting: Drafting, scales: Scales) -> Iterator[str]:
    """Write the equations of forces in the positions of the force sheets."""
    language, plans = statics.study.language, statics.drafts().plans
    formula = Formula(drafting)
    if scales:
        yield chapter(language, "force_equations")
        yield word(language, "report.underlines")
    for k, drawn in sorted(scales.items()):
        force, moment = (float(row.min()) for row in comparison.construction.nothing_over)
        written = CutEquations(plans.plan, k, formula, comparison.construction.nothing_at(k), (force, moment))
        yield in_position(statics.study, k).removesuffix("\n")
        for cut in plans.plan.cuts:
            yield from _cut(cut, replace(written, scale=drawn.get(f"{POLYGON}{cut.label}")))
        if plans.lever is not None and LEVER in drawn and plans.plan.mechanism.drive.turns:
            yield from lever_equation(plans.lever, written, drawn[LEVER])


def equations_of(study: Study, mark: Mark, position: int) -> Iterator[str]:
    """Write the equations of the cut that gives a reaction, a part of one, or what balances the drive."""
    if mark.subject != FORCES:
        return
    statics = study.of(Statics)
    plans, nothing = statics.drafts([position]).plans, study.of(ForceComparison).construction.nothing_at(position)
    drafting = drafting_of(study.scene)._replace(reactions=statics.form.sheet.reactions)
    written = CutEquations(plans.plan, 0, Formula(drafting), nothing)
    for cut in plans.plan.cuts:
        given = {part.name for support in cut.supports for part in support.parts}
        given |= {support.force.name for support in cut.reactions} | {e.found.name for e in cut.equations}
        if mark.name in given:
            yield from (line.strip("$") for line in written.lines(cut) if line.startswith("$$"))
            return


def _cut(cut: CutGroup, written: CutEquations) -> Iterator[str]:
    language = written.formula.drafting.language
    yield word(language, "report.cut" if cut.group is not None else "report.primary_cut", links=cut.label)
    yield from (f"- {line}" for line in written.given(cut))
    for line in written.lines(cut):
        yield f"\n{line}\n" if line.startswith("$$") else line
