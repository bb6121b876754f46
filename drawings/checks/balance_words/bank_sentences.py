"""What must be told of a bank, sentence by sentence, by the analysis alone (ожидаемые пояснения к блоку)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from drawings.checks.balance_words.main_points import ANGLE
from drawings.checks.balance_words.sentences import TURNS, Sentence, number
from drawings.checks.bank.bank_expected import DOUBTFUL, LEFT, PAPER, WHOLE, WHOLE_MOMENT, Expected
from drawings.checks.precise import KNOWN
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting
from plans.bank.letters import FORCE, MOMENT, STATIC, couple_letters, letters
from plans.model.balance.bank import Compensator, Harmonic

MINUTE = 60  # seconds
MILLIMETRES = 1000


@dataclass(frozen=True)
class BankSentences:
    """The sentences on a bank, with so many digits, written as notes or as lines of a report."""

    expected: Expected
    drafting: Drafting
    digits: int
    written: Callable[[str], str]

    def all(self) -> Iterator[Sentence]:
        """Give all of the notes of a sheet but what they say of both roads."""
        yield from self.given()
        yield from self.sums()
        yield from self.compensators()

    def _say(self, key: str, **parts: object) -> Sentence:
        return Sentence(self.written(self.drafting.word(key, **parts)))

    def _number(self, value: float, slack: float = 0.0) -> str:
        return number(value, slack + KNOWN * abs(value), self.digits)

    def _angle(self, value: complex, slack: float) -> str:
        """Put in a direction in degrees, which rounding may turn."""
        off = math.degrees(slack / abs(value)) + KNOWN
        return number(math.degrees(cmath.phase(value)), off, self.digits, TURNS)

    def members(self) -> Iterator[Sentence]:
        """Tell where each mechanism stands."""
        for one in self.expected.members:
            sizes = {"crank": one.crank, "place": MILLIMETRES * one.place, "axis": one.axis}
            told = {name: self._number(float(size)) for name, size in sizes.items()}
            yield self._say("bank member", name=one.name, **told)

    def given(self) -> Iterator[Sentence]:
        """Tell how all mechanisms stand, how fast the shaft turns, which vectors are shown."""
        members, task = self.expected.members, self.expected.task
        yield self._say("crank angles", angles=self._row(one.crank for one in members))
        if any(one.axis for one in members):
            yield self._say("guide angles", angles=self._row(one.axis for one in members))
        if any(one.place for one in members):
            yield self._say("bank places", places=self._row(MILLIMETRES * one.place for one in members))
        speed = {"n": self._number(task.speed * MINUTE / math.tau), "omega": self._number(task.speed)}
        yield self._say("bank speed" if task.unit is not None else "bank speed of linkage", **speed)
        if task.unit is not None:
            yield self._say("bank unit", ratio=self._number(task.unit.crank / task.unit.rod))
        lasting = [order for order, one in self.expected.analysis.single.items() if not _rests(one)]
        alone = [order for order in lasting if self.expected.alone(order)]
        if alone and alone != lasting:
            yield self._say("some mirror images", orders=", ".join(map(str, alone)))
        else:
            yield self._say("mirror image" if alone else "both senses")

    def _row(self, values: Iterable[Fraction]) -> str:
        return "; ".join(self._number(float(one)) for one in values)

    def sums(self) -> Iterator[Sentence]:
        """Tell what each order comes to, which vanish, which are too slight to be drawn."""
        analysis = self.expected.analysis
        for order, force in analysis.forces.items():
            told = [*self._sums(FORCE, "N", force), *self._whole(force)]
            told += self._sums(MOMENT, "N*m", analysis.moments[order])
            if told:
                yield self._say("order sums", order=order, sums=",  ".join(told))
        yield from self.vanishing()
        yield from self._orders("slight orders", self.expected.slight)
        yield from self._slight()

    def _sums(self, kind: str, unit: str, one: Harmonic) -> Iterator[str]:
        for signed, value in ((one.order, one.ahead), (-one.order, one.back)):
            name = letters(kind, signed)
            if abs(value) > one.slack and not (signed < 0 and self.expected.alone(one.order)):
                size = self._number(abs(value), self.expected.allowed[name])
                angle = self._angle(value, self.expected.allowed[name])
                yield f"{lowered(name)} = {size} {self.drafting.word(unit)}{ANGLE}{angle}°"

    def _whole(self, one: Harmonic) -> Iterator[str]:
        """Tell the largest force of an order: both vectors along one line."""
        pair = [(signed, abs(value)) for signed, value in ((one.order, one.ahead), (-one.order, one.back))]
        kept = [(signed, size) for signed, size in pair if size > one.slack]
        if kept:
            parts = "+".join(f"|{lowered(letters(FORCE, signed))}|" for signed, _ in kept)
            slack = 2 * self.expected.allowed[letters(FORCE, one.order)]
            size = self._number(math.fsum(size for _, size in kept), slack)
            told = {"letter": f"{FORCE}_{{max}}", "sum": parts, "size": size}
            yield self.drafting.word("order largest", unit=self.drafting.word("N"), **told)

    def vanishing(self) -> Iterator[Sentence]:
        """Tell the orders that one mechanism has not, and those that balance one another."""
        analysis = self.expected.analysis
        gone = {order for order, one in analysis.single.items() if _rests(one)}
        yield from self._orders("no order", lambda order: order in gone)
        yield from self._orders("no order force", lambda order: order not in gone and _rests(analysis.forces[order]))
        if any(one.place for one in self.expected.members):
            rest = [order for order, one in analysis.moments.items() if order not in gone and _rests(one)]
            yield from self._orders("no order moment", lambda order: order in rest)
        else:
            yield self._say("one plane of a bank")

    def _orders(self, key: str, holds: Callable[[int], bool]) -> Iterator[Sentence]:
        found = ", ".join(str(order) for order in self.expected.analysis.single if holds(order))
        if found:
            yield self._say(key, orders=found)

    def _slight(self) -> Iterator[Sentence]:
        """Tell the largest over the turn of what is too slight to be drawn; what is hardly there may be left out."""
        rows = ((WHOLE, FORCE, "N"), (LEFT, f"{FORCE}'", "N"), (WHOLE_MOMENT, MOMENT, "N*m"))
        for name, letter, unit in rows:
            if self.expected.faint(name) and self.expected.acts(name, seen=True):
                size = self._number(self.expected.most(name), self.expected.allowed[name])
                sure = self.expected.acts(name, seen=False)
                told = {"letter": letter, "size": size, "unit": self.drafting.word(unit)}
                yield self._say("slight course", **told)._replace(sure=sure)

    def compensators(self) -> Iterator[Sentence]:
        """Tell what is to be put on the shafts of the compensators."""
        for one in self.expected.analysis.compensators:
            if any(self.expected.bodies(one)):
                yield from self._compensator(one)
            else:
                yield self._say("no compensator", order=one.asked.order)

    def _compensator(self, one: Compensator) -> Iterator[Sentence]:
        order, slack = one.asked.order, self.expected.slack_of(one)
        masses = [body for body in self.expected.bodies(one) if not body.coupled]
        square, squared = (order * self.expected.task.speed) ** 2, f"({order}ω)²" if order > 1 else "ω²"
        for body in masses:
            pair = {"letters": letters(STATIC, body.turns), "force": letters(FORCE, body.turns)}
            told = {name: lowered(letter) for name, letter in pair.items()}
            yield self._say("compensator mass", square=squared, moment=self._number(body.moment, slack), **told)
        yield from self._unlike(one, slack)
        couple = 0.0 if self.expected.carried(one) else sum(body.moment for body in masses) * abs(one.asked.offset)
        wide = len(masses) * slack * abs(one.asked.offset)
        if couple:
            yield self._say("compensator couple", residual=self._number(couple * square, wide * square))
        if couple and one.asked.shafts is not None:
            moment = self._number(couple / one.asked.shafts, wide / one.asked.shafts)
            yield self._say("couple mass", letters=lowered(couple_letters(order)), square=squared, moment=moment)

    def _unlike(self, one: Compensator, slack: float) -> Iterator[Sentence]:
        """Tell what two masses of unlike size ask for; where rounding may be all of it nothing may be told."""
        order, more = one.asked.order, one.with_crank - one.against
        if self.expected.carried(one):
            yield self._say("on crank")
            return
        doubtful = abs(more) <= DOUBTFUL * slack
        if not doubtful and abs(more) <= PAPER * max(one.with_crank, one.against):
            return
        pair = {"ahead": lowered(letters(FORCE, order)), "back": lowered(letters(FORCE, -order))}
        yield self._say("unequal vectors", **pair)._replace(sure=not doubtful)
        if order == 1 and one.with_angle is not None and (doubtful or more > 0):
            angle = self._angle(cmath.rect(one.with_crank, one.with_angle), 2 * slack)
            told = {"moment": self._number(more, 2 * slack), "angle": f"{ANGLE}{angle}"}
            yield self._say("better on crank", **told, **pair)._replace(sure=not doubtful)


def _rests(one: Harmonic) -> bool:
    """Tell whether nothing but rounding is left of a harmonic."""
    return max(abs(one.ahead), abs(one.back)) <= one.slack
