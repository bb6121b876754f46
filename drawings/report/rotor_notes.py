"""What is said of a rotor in words: sums, counterweights, quality, reactions of the bearings (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.lettering.rotor_letters import index, lowered
from drawings.page.drafting import Drafting
from plans.model.balance_quality import grade_of, letters, permissible
from plans.model.rotor import Balance, Correction, Resultant, Rotor
from plans.rotor.bearings import BEARINGS
from plans.rotor.letters import unbalance_letters

GRAM_MILLIMETRES = 1e6  # of a kg*m
ANGLE = "\N{NO-BREAK SPACE}∠\N{NO-BREAK SPACE}"  # between the size of a vector and its direction


class RotorNotes(NamedTuple):
    """The notes on a balanced rotor, with so many digits."""

    rotor: Rotor
    balance: Balance
    drafting: Drafting
    digits: int = 5

    @property
    def all(self) -> tuple[str, ...]:
        """What was unbalanced, what balances it, how well, and what the bearings bear."""
        return *self.sums(), *self.counterweights(), *self.quality(), *self.reactions()

    def sums(self) -> Iterator[str]:
        """Say what was unbalanced, and what one plane leaves so."""
        rotor, balance, word = self.rotor, self.balance, self.drafting.word
        if rotor.dynamic:
            yield word("arms from", plane=rotor.planes[-1].name)
        unbalance, couple = self._vector(balance.unbalance, "kg*m"), self._vector(balance.couple, "kg*m2")
        yield word("sums before", unbalance=unbalance, couple=couple)
        if not rotor.dynamic and not balance.couple.vanishes:
            yield word("static only", couple=self._number(balance.couple.size))

    def counterweights(self) -> Iterator[str]:
        """Say what is to be put in each plane."""
        yield from map(self._counterweight, self.balance.corrections)

    def quality(self) -> Iterator[str]:
        """Say how well the rotor was balanced, and what the asked grade permits."""
        rotor, word, number = self.rotor, self.drafting.word, self.drafting.number
        before = rotor.quality(*self.balance.sizes)
        if before is None or rotor.mass is None or rotor.speed is None:
            return
        told = "quality before of two" if rotor.dynamic else "quality before"
        yield word(told, quality=number(before), grade=grade_name(before, self.drafting))
        if rotor.grade is not None:
            whole = GRAM_MILLIMETRES * permissible(rotor.grade, rotor.mass, rotor.speed)
            grade = {
                "grade": letters(rotor.grade),
                "permissible": number(whole),
                "letters": word("permissible letters"),
            }
            each = {"each": number(whole / len(rotor.planes))}
            yield word("permissible", **grade, **each) if rotor.dynamic else word("permissible in one", **grade)

    def reactions(self) -> Iterator[str]:
        """Say what the bearings bear before and after."""
        balance, word = self.balance, self.drafting.word
        if balance.before and self.rotor.speed is not None:
            speed = self.drafting.number(self.rotor.speed)
            yield word("bearing loads", speed=speed, before=self._borne(balance.before))
            yield word("bearing loads after", after=self._borne(balance.after))

    def _counterweight(self, one: Correction) -> str:
        language, word = self.drafting.language, self.drafting.word
        name, plane = lowered(unbalance_letters(one.plane.name), language), index(one.plane.name, language)
        if one.moment.angle is None:
            return word("no counterweight", letters=name)
        parts = []
        if one.mass is not None:
            parts.append(word("counterweight mass", index=plane, mass=self._number(one.mass)))
        if one.radius is not None:
            parts.append(word("counterweight radius", index=plane, radius=self._number(1000 * one.radius)))
        moment, angle = self._number(one.moment.size), self._number(one.moment.angle)
        said = word("counterweight", letters=name, moment=moment, angle=angle)
        return f"{said};  {',  '.join(parts)}" if parts else said

    def _vector(self, one: Resultant, unit: str) -> str:
        """Write a vector by its size and direction; one that vanishes is 0."""
        size = f"{self._number(one.size)} {self.drafting.word(unit)}"
        return size if one.angle is None else f"{size}{ANGLE}{self._number(one.angle)}°"

    def _borne(self, reactions: Sequence[Resultant]) -> str:
        pairs = zip(BEARINGS, reactions, strict=True)
        return ",  ".join(f"R_{{{name}}} = {self._vector(one, 'N')}" for name, one in pairs)

    def _number(self, value: float) -> str:
        return self.drafting.number(value, self.digits)


def grade_name(quality: float, drafting: Drafting) -> str:
    """Name the finest grade that holds e*omega mm/s."""
    grade = grade_of(quality)
    return drafting.word("no grade") if grade is None else letters(grade)
