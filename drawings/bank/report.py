"""A bank in the report and in the notes of its sheet: sums by order, compensators (блок механизмов в отчёте)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from drawings.balance.report import notes_of, weights
from drawings.forces.report import mass_table
from drawings.lettering.words import lowered_bank
from drawings.linkage.notes import assembly, lengths
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.formula import DIGITS, Chapters, listed, plain
from drawings.report.report import ANGLE, Report, TableSubject, chapter, header, row
from plans.bank.harmonics import FORCE, MOMENT, STATIC, couple_letters, letters
from plans.bank.study import BankStudy
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.balance.bank import BankBalance, Compensator, Harmonic
from plans.model.motion import Complexes
from plans.study import Study
from plans.words.words import word

# Of the largest order of one mechanism: where that is drawn 100 mm long, what is less is shorter than 0.1 mm, and no
# line is so thin. A figure of it at a scale of its own would look like those that matter.
SLIGHT = 1e-3
MADE = 1e-3  # m: a mass nearer to its shaft is not set by any workshop


def largest(balance: BankBalance) -> float:
    """Give the largest force of an order of one mechanism, N."""
    return max(harmonic.size for harmonic in balance.single.values())


def slight_order(balance: BankBalance, order: int) -> bool:
    """Tell whether an order that is there is too slight to be drawn; one that is to be compensated is not."""
    size = max(balance.single[order].size, balance.forces[order].size)
    asked = any(compensator.asked.order == order for compensator in balance.compensators)
    return not asked and 0.0 < size < SLIGHT * largest(balance)


def slight_force(balance: BankBalance) -> bool:
    """Tell whether the force of a bank without compensators is more than rounding, but too slight to be drawn."""
    most = _most(balance.force)
    return not _answered(balance) and balance.force_slack < most < SLIGHT * largest(balance)


def slight_left(balance: BankBalance) -> bool:
    """Tell whether the compensators leave more than rounding, but too little to be drawn."""
    most = _most(balance.left)
    return _answered(balance) and balance.left_slack < most < SLIGHT * largest(balance)


def slight_moment(balance: BankBalance) -> bool:
    """Tell whether the moment is more than rounding, but slight beside one mechanism's at the farthest place."""
    arm = max(abs(float(member.place)) for member in balance.task.members)
    return balance.moment_slack < _most(balance.moment) < SLIGHT * largest(balance) * arm


def _answered(balance: BankBalance) -> bool:
    return any(compensator.masses for compensator in balance.compensators)


def _most(values: Complexes) -> float:
    return float(np.abs(values).max())


RPM = 30 / math.pi  # of a rad/s
HALF_TURN = 180.0  # degrees
EYE = 1e-6  # of a vector: what is less cannot be drawn, a written place of 100 mm being rounded to 1e-4 mm


def mirrored(balance: BankBalance, order: int) -> bool:
    """Tell whether what turns against the crank is, to the eye, the mirror image in the guide of what turns with it."""
    single = balance.single[order]
    flat = all(member.axis % 180 == 0 for member in balance.task.members)
    apart = abs(single.back - single.ahead.conjugate())
    return flat and apart <= max(EYE * abs(single.ahead), single.slack)


def linkage_of(study: Study) -> tuple[str, ...]:
    """Tell lengths, masses and counterweights of a bank's linkage; of one told by its sizes nothing."""
    if study.of(BankStudy).task.unit is not None:
        return ()
    language = study.scene.sheet.language
    told = [*mass_table(study.of(Statics).machine, language)]
    told += weights(notes_of(study)) if study.scene.has(("balance",)) else ()
    linkage = study.of(LinkageStudy)
    given = (*lengths(linkage, language), *assembly(linkage.mechanism.sketch, language))
    return *given, *(line.removeprefix("- ") for line in told)


def crank_of(study: Study) -> float:
    """Give the length m of the cranks of a scene's bank."""
    bank = study.of(BankStudy)
    if bank.task.unit is not None:
        return float(bank.task.unit.crank)
    mechanism = study.of(LinkageStudy).mechanism
    drive = mechanism.drive
    points = mechanism.links[drive.link].points
    return float(abs(points[drive.end] - points[drive.pivot]))


def straight(values: Complexes, among: Complexes) -> bool:
    """Tell whether vectors keep to the line of the reference guide, to the eye that sees others beside them."""
    return bool(np.abs(values.imag).max() <= EYE * np.abs(among).max())


def direction(value: complex, slack: float) -> float:
    """Give the direction of a vector in degrees; one that rounding alone keeps from a quarter turn is whole.

    >>> direction(-1 - 1e-17j, 1e-15), direction(1 + 1j, 1e-15)
    (180.0, 45.0)
    """
    angle = math.degrees(cmath.phase(value))
    quarter = 90.0 * round(angle / 90.0)
    found = quarter if abs(angle - quarter) <= math.degrees(slack / abs(value)) else angle
    return HALF_TURN if found == -HALF_TURN else found + 0.0


def squared(order: int) -> str:
    """Write the square of the speed of a compensator's shaft.

    >>> squared(1), squared(2)
    ('ω²', '(2ω)²')
    """
    return f"({order}ω)²" if order > 1 else "ω²"


class BankNotes(NamedTuple):
    """The notes on a bank, with so many digits."""

    balance: BankBalance
    drafting: Drafting
    linkage: tuple[str, ...] = ()  # lengths and masses of a linkage of the bank
    digits: int = 5

    @property
    def all(self) -> tuple[str, ...]:
        """What is given, what each order comes to, what vanishes, and what compensates."""
        return *self.given(), *self.sums(), *self.vanishing(), *self.slight(), *self.compensators()

    def given(self) -> Iterator[str]:
        """Say how fast the shaft turns, and of a slider-crank what its rod is to its crank."""
        task, word = self.balance.task, self.drafting.word
        counted = "bank speed" if task.unit is not None else "bank speed of linkage"
        members = self.balance.task.members
        yield self.drafting.word("crank angles", angles=self._row(member.crank for member in members))
        if any(member.axis for member in members):
            yield self.drafting.word("guide angles", angles=self._row(member.axis for member in members))
        if any(member.place for member in members):
            yield self.drafting.word("bank places", places=self._row(1000 * member.place for member in members))
        yield word(counted, n=self._number(task.speed * RPM), omega=self._number(task.speed))
        if task.unit is not None:
            unit = task.unit
            sizes = {"crank": unit.crank, "rod": unit.rod}
            told = {name: self._number(1000 * float(size)) for name, size in sizes.items()}
            told |= {name: self._number(float(getattr(unit, name))) for name in ("rotating", "reciprocating")}
            yield word("bank unit", ratio=self._number(unit.ratio), **told)
        yield from self.linkage
        yield self._senses()

    def _senses(self) -> str:
        """Say of which orders the vectors against the crank are shown, and of which they are mirror images."""
        orders = [order for order, harmonic in self.balance.single.items() if not harmonic.vanishes]
        alone = [order for order in orders if mirrored(self.balance, order)]
        if alone and alone != orders:
            return self.drafting.word("some mirror images", orders=", ".join(map(str, alone)))
        return self.drafting.word("mirror image" if alone else "both senses")

    def _row(self, values: Iterable[Fraction]) -> str:
        return "; ".join(self._number(float(value)) for value in values)

    def sums(self) -> Iterator[str]:
        """Say what the polygons of each order come to at phi = 0."""
        for order in self.balance.forces:
            lines = [*self._sums(FORCE, self.balance.forces[order]), *self._sums(MOMENT, self.balance.moments[order])]
            if lines:
                yield self.drafting.word("order sums", order=order, sums=",  ".join(lines))

    def _sums(self, kind: str, harmonic: Harmonic) -> Iterator[str]:
        unit = self.drafting.word("N" if kind == FORCE else "N*m")
        alone = mirrored(self.balance, harmonic.order)
        for sense, value in ((1, harmonic.ahead),) if alone else ((1, harmonic.ahead), (-1, harmonic.back)):
            if abs(value) > harmonic.slack:
                angle = self._number(direction(value, harmonic.slack))
                size = f"{self._number(abs(value))} {unit}{ANGLE}{angle}°"
                yield f"{lowered_bank(letters(kind, sense * harmonic.order))} = {size}"
        yield from self._largest(harmonic, unit) if kind == FORCE else ()

    def _largest(self, harmonic: Harmonic, unit: str) -> Iterator[str]:
        """Say what both vectors come to together where they point alike: the force that the table tells."""
        pairs = ((harmonic.order, harmonic.ahead), (-harmonic.order, harmonic.back))
        summed = "+".join(
            f"|{lowered_bank(letters(FORCE, signed))}|" for signed, value in pairs if abs(value) > harmonic.slack
        )
        if summed:
            parts = {"letter": f"{FORCE}_{{max}}", "sum": summed, "size": self._number(harmonic.size)}
            yield self.drafting.word("order largest", unit=unit, **parts)

    def vanishing(self) -> Iterator[str]:
        """Say which orders one mechanism has none of, and of which forces and moments are balanced by one another."""
        single, forces, moments = self.balance.single, self.balance.forces, self.balance.moments
        yield from self._orders("no order", lambda order: single[order].vanishes)
        yield from self._orders("no order force", lambda order: not single[order].vanishes and forces[order].vanishes)
        if any(member.place for member in self.balance.task.members):
            holds = [order for order in single if not single[order].vanishes and moments[order].vanishes]
            yield from self._orders("no order moment", holds.__contains__)
        else:
            yield self.drafting.word("one plane of a bank")

    def slight(self) -> Iterator[str]:
        """Say what is not drawn, being too slight: orders, and the largest force and moment over the turn."""
        balance = self.balance
        yield from self._orders("slight orders", lambda order: slight_order(balance, order))
        rows = (
            (slight_force, FORCE, "N", balance.force),
            (slight_left, f"{FORCE}'", "N", balance.left),
            (slight_moment, MOMENT, "N*m", balance.moment),
        )
        for holds, letter, unit, values in rows:
            if holds(balance):
                size = self._number(float(np.abs(values).max()))
                yield self.drafting.word("slight course", letter=letter, size=size, unit=self.drafting.word(unit))

    def _orders(self, key: str, holds: Callable[[int], bool]) -> Iterator[str]:
        found = ", ".join(str(order) for order in self.balance.single if holds(order))
        if found:
            yield self.drafting.word(key, orders=found)

    def compensators(self) -> Iterator[str]:
        """Say what is to be put on the shafts of the compensators, and what their offset leaves."""
        for compensator in self.balance.compensators:
            yield from self._compensator(compensator)

    def _compensator(self, compensator: Compensator) -> Iterator[str]:
        asked, word, number = compensator.asked, self.drafting.word, self._number
        order, square = asked.order, squared(asked.order)
        if not compensator.masses:
            yield word("no compensator", order=order)
            return
        for signed, moment, _ in compensator.masses:
            parts = {"force": lowered_bank(letters(FORCE, signed)), "square": square, "moment": number(moment)}
            yield word("compensator mass", letters=lowered_bank(letters(STATIC, signed)), **parts)
        least = min(moment for _, moment, _ in compensator.masses)
        if asked.mass is not None and 0 < least < MADE * asked.mass:
            yield word("compensator slight", radius=number(1000 * least / asked.mass), mass=number(least / MADE))
        yield from self._unequal(compensator)
        if asked.offset and compensator.residual:
            yield word("compensator couple", residual=number(compensator.residual))
        if asked.shafts is not None and compensator.couple:
            parts = {"square": square, "moment": number(compensator.couple)}
            yield word("couple mass", letters=lowered_bank(couple_letters(order)), **parts)

    def _unequal(self, compensator: Compensator) -> Iterator[str]:
        """Say what two vectors of unlike size ask for: the crank itself carries what turns with it alone."""
        order, word = compensator.asked.order, self.drafting.word
        slack = self.balance.forces[order].slack / (order * self.balance.task.speed) ** 2
        if compensator.on_crank:
            yield word("on crank")
        elif abs(compensator.with_crank - compensator.against) > max(
            EYE * max(compensator.with_crank, compensator.against), slack
        ):
            pair = {"ahead": lowered_bank(letters(FORCE, order)), "back": lowered_bank(letters(FORCE, -order))}
            yield word("unequal vectors", **pair)
            if order == 1 and compensator.with_angle is not None and compensator.with_crank > compensator.against:
                angle = direction(cmath.rect(compensator.with_crank, compensator.with_angle), slack)
                moment = self._number(compensator.with_crank - compensator.against)
                yield word("better on crank", moment=moment, angle=f"{ANGLE}{self._number(angle)}", **pair)

    def _number(self, value: float) -> str:
        return self.drafting.number(value, self.digits)


ORDER_HEADS = ("one force", "bank force", "force left", "bank moment")


def subject(study: Study) -> TableSubject:
    """Tell a bank in a few words, for the gallery's page."""
    task = study.of(BankStudy).task
    kind = "linkages" if task.unit is None else "slider-cranks"
    count, orders = len(task.members), ", ".join(str(asked.order) for asked in task.asked)
    structure = f"bank of {count} {kind}"
    output = f"compensators of order {orders}" if orders else "no compensators"
    return TableSubject(structure, output, f"A {structure} on one shaft; {output}.")


def headline(study: Study) -> str:
    """Say what compensates the forces of the bank, or else which orders vanish by themselves."""
    notes = _notes(study)
    return "; ".join(map(plain, [*notes.compensators()] or [*notes.vanishing()]))


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell a bank, its orders and its compensators."""
    drafting, notes = drafting_of(study.scene), _notes(study)
    language = drafting.language
    return Chapters(
        subject=listed(chapter(language, "bank").lstrip(), [*notes.given()]),
        values=[chapter(language, "bank_orders"), *_orders(study.of(BankStudy).balance, drafting)],
        conditions=[
            *listed(chapter(language, "bank_sums"), [*notes.sums(), *notes.vanishing(), *notes.slight()]),
            *listed(chapter(language, "bank_compensators"), [*notes.compensators()]),
        ],
        left_out=[word(language, "report.bank_left_out")],
    )


def order_rows(balance: BankBalance, drafting: Drafting, digits: int) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Tell of each order the largest force of one mechanism, of the bank, what is left of it, and the moment."""
    answered = {compensator.asked.order for compensator in balance.compensators}
    for order, single in balance.single.items():
        force = balance.forces[order].size
        sizes = single.size, force, 0.0 if order in answered else force, balance.moments[order].size
        yield str(order), tuple(drafting.number(size, digits) for size in sizes)


def _orders(balance: BankBalance, drafting: Drafting) -> list[str]:
    rows = (row([order, *cells]) for order, cells in order_rows(balance, drafting, DIGITS))
    return [*header([plain(drafting.word(head)) for head in ("order", *ORDER_HEADS)]), *rows]


def _notes(study: Study) -> BankNotes:
    return BankNotes(study.of(BankStudy).balance, drafting_of(study.scene), linkage_of(study), DIGITS)


REPORT = Report(chapters, headline, subject=subject)
