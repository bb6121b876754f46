"""What a force sheet writes beside its figures: equations of cuts and of the lever, how forces of masses are found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.forces.acting import acting, cut_links
from drawings.forces.arms import POLE, Leverage, LeverTerm, leverages, statements
from drawings.forces.letters import letter_of
from drawings.forces.lever import UNIT
from drawings.kinds.working import DIGITS as WORKING_DIGITS
from drawings.kinds.working import MASSES, Workings
from drawings.layout.equation import (
    DIRECTION,
    FULL,
    UNKNOWN,
    EquationBlock,
    Term,
    WrittenEquation,
    forces,
    listed,
    moments,
    plain,
)
from drawings.layout.picture import Spot, TextBlock
from drawings.lettering.words import Phrase, Slot, joined
from drawings.page.page import Drafting, Field
from drawings.paper.strokes import Group, Kind, Statement
from drawings.symbols.figure import plain_name
from geometry.board import Mark, at
from plans.forces.cut import CLOSING, INERTIA, REACTION, WEIGHT, CutGroup, ForcePlan, MomentEquation
from plans.forces.drive import BALANCING, DRIVING
from plans.model.motion import NOTHING

DIGITS = 5


class SheetEquations:
    """What a sheet writes beside a cut in one position."""

    def __init__(
        self, plan: ForcePlan, cut: CutGroup, column: int, drafting: Drafting, nothing: tuple[float, float]
    ) -> None:
        self.plan, self.cut, self.column, self.drafting = plan, cut, column, drafting
        self.nothing = nothing  # force N and moment N*m below which there is none
        self.arms = leverages(plan, cut, column)

    def passage(self, name: str) -> EquationBlock:
        """Write arms, equations of moments with what they give, and the equation of forces."""
        turning, holding = (
            [line for each in self.cut.equations if self.cut.holds(each) is late for line in self._moments(each)]
            for late in (False, True)
        )
        lines = *self._given(), *self._slotted(), *turning, *self._forces(), *self._found(), *holding, *self._shifted()
        return EquationBlock(name, lines, self.drafting.hand.text, figure=f"{name}-{self.column}")

    def letter(self, name: str) -> str:
        """Write a force's name as the sheet does."""
        return letter_of(name, self.drafting)

    def statement(self, name: str, value: float, unit: str) -> Phrase:
        """Write what a quantity is: R_34 = 1644.1 N."""
        return _statement(name, self.letter(name), value, unit, self.drafting)

    def _size(self, mark: Mark) -> float:
        return abs(self._value(mark))

    def _value(self, mark: Mark) -> complex:
        value = at(mark.point, self.column)
        return value if abs(value) > self.nothing[mark.is_moment] else 0j

    def _given(self) -> Iterator[WrittenEquation]:
        loads = (load for load in self.cut.loads if load.kind != REACTION and self._size(load.force) > 0)
        given = [self.statement(load.name, self._size(load.force), "N") for load in loads]
        turning = (couple for couple in self.cut.couples if couple.kind != REACTION and self._size(couple.moment) > 0)
        given += [self.statement(couple.name, self._value(couple.moment).real, "N*m") for couple in turning]
        if given:
            yield listed(*given)
        arms = {arm.letter: arm.length for arm in self.arms}
        if arms:
            slots = {letter: self.drafting.slot(Slot(letter, 1000 * arm, DIGITS)) for letter, arm in arms.items()}
            yield _lengths(slots, "mm", self.drafting)

    def _slotted(self) -> Iterator[WrittenEquation]:
        """Tell the part along a slot: what is left of the stone's forces there, since a slot holds nothing along it."""
        for part in (part for support in self.cut.supports for part in support.parts if part.name.startswith("R^u")):
            terms = [self.letter(load.name) for load in self.cut.loads if load.link == self.cut.links[0]]
            left = f"{self.letter(part.name)} = −({' + '.join(terms)})_u,"
            yield plain(left, self.statement(part.name, self._size(part), "N"))

    def _moments(self, equation: MomentEquation) -> Iterator[WrittenEquation]:
        """Write an equation of moments, each force by its arm, and the force or the moment that it gives."""
        unknown = equation.found.name
        armed = [arm for arm in self.arms if arm.equation is equation]
        terms = {arm.name: self._term(arm) for arm in armed if arm.name != unknown}
        for couple in (couple for couple in equation.couples if self._size(couple.moment) > 0):
            sign = "+" if at(couple.moment.point, self.column).real > 0 else "−"
            terms[couple.name] = sign, f"|{self.letter(couple.name)}|"
        force = next((arm for arm in armed if arm.name == unknown), None)
        if equation.line is None:
            value, unit, first = self._value(equation.found).real, "N*m", ("+", self.letter(unknown))
        else:
            value, unit = self._size(equation.found), "N"
            first = ("+", self.letter(unknown)) if force is None else self._term(force)
        given = self.cut.group is None and self.plan.mechanism.drive.ram is not None  # it drives: no moment is left
        if terms:
            every = terms if given else {unknown: first, **terms}
            states = [self._said(equation, name) for name in every]
            where = equation.about.name + self.cut.sum_of(equation)
            yield moments(where, [*every.values()], states=states)
        yield from () if given else (plain(self.statement(unknown, value, unit)),)

    def _said(self, equation: MomentEquation, name: str) -> Statement:
        figure = f"equations-{self.cut.label}-{self.column}"
        return Statement(Kind.LETTER, figure, f"{name} about {equation.about.name} for {equation.found.name}")

    def _term(self, arm: Leverage) -> tuple[str, str]:
        return "+" if arm.sense > 0 else "−", f"{self.letter(arm.name)}·{arm.letter}"

    def _forces(self) -> Iterator[WrittenEquation]:
        closers = [side for side in self.cut.sides if side.kind == CLOSING]
        known = DIRECTION if len(closers) > 1 else UNKNOWN
        terms = [
            Term(self.letter(side.name), known if side.kind == CLOSING else FULL)
            for side in self.cut.sides
            if side.kind == CLOSING or self._visible(side.name)
        ]
        if len(terms) > 1:
            yield forces(terms)

    def _visible(self, name: str) -> bool:
        side = next(side for side in self.cut.sides if side.name == name)
        return abs(at(side.end.point, self.column) - at(side.start.point, self.column)) > self.nothing[0]

    def _found(self) -> Iterator[WrittenEquation]:
        found = [support.force for support in self.cut.reactions]
        if self.cut.group is None and not self.cut.equations and self.plan.drive is not None:
            found.insert(0, self.plan.drive)  # of a slide the polygon gives the driving force too
        yield listed(*(self.statement(force.name, self._size(force), "N") for force in found))

    def _shifted(self) -> Iterator[WrittenEquation]:
        """Tell how far from their sliders' points guides press, where the scheme dimensions it."""
        for shift in acting(self.plan, self.cut, cut_links(self.plan, self.cut, self.column), self.column).shifts:
            name, moment, force = (self.letter(shift.name.replace("x", kind, 1)) for kind in "xMR")
            size = self.drafting.slot(Slot(plain_name(name), 1000 * abs(shift.end - shift.start), DIGITS))
            yield plain(f"{name} = |{moment}|/{force} =", joined(" ", (size, self.drafting.word("mm"))))


def _statement(name: str, letter: str, value: float, unit: str, drafting: Drafting) -> Phrase:
    return joined("", (f"{letter} = ", drafting.slot(Slot(name, value, DIGITS)), f" {drafting.word(unit)}"))


def _lengths(arms: Mapping[str, str], unit: str, drafting: Drafting) -> WrittenEquation:
    *parts, last = (joined(" = ", pair) for pair in arms.items())
    return listed(*parts, joined(" ", (last, drafting.word(unit))))


NAME = "equations-lever"
ARM = 4  # digits of an arm
WIDEST = "0,08888"  # of an arm before it is known how large the lever is drawn


class LeverEquation(NamedTuple):
    """What is written beside a lever: its terms, and the balancing moment N*m, where a moment drives."""

    told: tuple[LeverTerm, ...]
    moment: float | None
    drafting: Drafting
    column: int = 0

    def block(self) -> TextBlock:
        """Measure it with the widest numbers, for the scale of the lever is not known yet."""
        return self._passage(None).block()

    def write(self, box: Field, spot: Spot | None = None) -> Group:
        """Write it with the arms in mm at the lever's scale; without a lever on its sheet, in true units."""
        mu, unit = (1.0, UNIT) if spot is None else (spot.scale.mu, "mm")
        return self._passage(mu, unit).write(box, self.drafting.hand)

    def _passage(self, mu: float | None, unit: str = "mm") -> EquationBlock:
        lengths, slot = dict(statements(self.told)), self.drafting.slot
        arms = {arm: WIDEST if mu is None else slot(Slot(arm, size / mu, ARM)) for arm, size in lengths.items()}
        figure = f"{NAME}-{self.column}"
        said = [Statement(Kind.LETTER, figure, term.letter) for term in self.told]
        letters = moments(POLE, [term.written for term in self.told], states=said)
        lines = (_lengths(arms, unit, self.drafting), letters, self._numbers(arms), *self._found())
        return EquationBlock(NAME, lines, self.drafting.hand.text, figure=figure)

    def _numbers(self, arms: dict[str, str]) -> WrittenEquation:
        sizes = [self.drafting.slot(Slot(term.letter, term.size, DIGITS)) for term in self.told]
        products = (joined("·", (size, arms[term.arm])) for term, size in zip(self.told, sizes, strict=True))
        return moments(POLE, [(term.written[0], product) for term, product in zip(self.told, products, strict=True)])

    def _found(self) -> Iterator[WrittenEquation]:
        drafting, driving = self.drafting, [term for term in self.told if term.force == DRIVING]
        parts = [_statement(term.letter, term.letter, term.size, "N", drafting) for term in driving]
        if self.moment is not None:
            letter = letter_of(BALANCING, drafting)
            parts.append(_statement(letter, letter, self.moment, "N*m", drafting))
        yield listed(*parts)


def forces_of_masses(plan: ForcePlan, links: Sequence[int], position: int, name: str, drafting: Drafting) -> Workings:
    """Write beside a figure how weights, inertia forces and inertia couples of some links are found."""
    lines = list(_lines(plan, links, position, drafting))
    return Workings(MASSES, name, lambda spot: lines, drafting)


def _lines(plan: ForcePlan, links: Sequence[int], position: int, drafting: Drafting) -> Iterator[tuple[str, ...]]:
    loads, couples = plan.acting(*links)
    forces = [load for load in loads if load.kind in (WEIGHT, INERTIA)]
    largest = max((abs(at(load.force.point, position)) for load in forces), default=0.0)
    for load in forces:
        k, size = load.link, abs(at(load.force.point, position))
        if size > NOTHING * largest:
            by = "g" if load.kind == WEIGHT else f"a_{{S{k}}}"
            yield _line(load.name, (f"m_{{{k}}}", by), plan.machine.bodies[k].mass, (size, "N"), drafting)
    for couple in couples:
        k, size = couple.link, abs(at(couple.moment.point, position).real)
        if couple.kind == INERTIA and size > 0:
            factors = f"J_{{S{k}}}", f"ε_{{{k}}}"
            yield _line(couple.name, factors, plan.machine.bodies[k].inertia, (size, "N*m"), drafting)


def _line(
    name: str, factors: tuple[str, str], mass: float, found: tuple[float, str], drafting: Drafting
) -> tuple[str, ...]:
    size, unit = found
    first, second, whole = (drafting.number(number, WORKING_DIGITS) for number in (mass, size / mass, size))
    left = f"{letter_of(name, drafting)} = {'·'.join(factors)}"
    return left, f"{first}·{second}", f"{whole} {drafting.word(unit)}"
