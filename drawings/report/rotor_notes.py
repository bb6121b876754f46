"""What is said of a rotor in words: sums, counterweights, quality, reactions of the bearings (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.lettering.phrase import Phrase, Slot, joined
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
        rotor, balance, word, phrase = self.rotor, self.balance, self.drafting.word, self.drafting.phrase
        if rotor.dynamic:
            yield word("arms from", plane=rotor.planes[-1].name)
        unbalance, couple = (
            self._vector("ΣmD", balance.unbalance, "kg*m"),
            self._vector("ΣmDh", balance.couple, "kg*m2"),
        )
        yield phrase("sums before", unbalance=unbalance, couple=couple)
        if not rotor.dynamic and not balance.couple.vanishes:
            yield phrase("static only", couple=self._slot("ΣmDh", balance.couple.size))

    def counterweights(self) -> Iterator[str]:
        """Say what is to be put in each plane."""
        yield from map(self._counterweight, self.balance.corrections)

    def quality(self) -> Iterator[str]:
        """Say how well the rotor was balanced, and what the asked grade permits."""
        rotor, word, phrase = self.rotor, self.drafting.word, self.drafting.phrase
        before = rotor.quality(*self.balance.sizes)
        if before is None or rotor.mass is None or rotor.speed is None:
            return
        told = "quality before of two" if rotor.dynamic else "quality before"
        yield phrase(told, quality=Slot("e·ω", before), grade=grade_name(before, self.drafting))
        if rotor.grade is not None:
            whole = GRAM_MILLIMETRES * permissible(rotor.grade, rotor.mass, rotor.speed)
            grade = {
                "grade": letters(rotor.grade),
                "permissible": Slot("U_per", whole),
                "letters": word("permissible letters"),
            }
            each = {"each": Slot("U_per each", whole / len(rotor.planes))}
            yield phrase("permissible", **grade, **each) if rotor.dynamic else phrase("permissible in one", **grade)

    def reactions(self) -> Iterator[str]:
        """Say what the bearings bear before and after."""
        balance, phrase = self.balance, self.drafting.phrase
        if balance.before and self.rotor.speed is not None:
            yield phrase("bearing loads", speed=Slot("ω", self.rotor.speed), before=self._borne(balance.before, ""))
            yield phrase("bearing loads after", after=self._borne(balance.after, "'"))

    def _counterweight(self, one: Correction) -> str:
        language, phrase = self.drafting.language, self.drafting.phrase
        own = unbalance_letters(one.plane.name)
        name, plane = lowered(own, language), index(one.plane.name, language)
        if one.moment.angle is None:
            return phrase("no counterweight", letters=name)
        parts = []
        if one.mass is not None:
            parts.append(phrase("counterweight mass", index=plane, mass=self._slot(f"m_{one.plane.name}", one.mass)))
        if one.radius is not None:
            far = self._slot(f"D_{one.plane.name}", 1000 * one.radius)
            parts.append(phrase("counterweight radius", index=plane, radius=far))
        moment, angle = self._slot(own, one.moment.size), self._slot(f"φ {own}", one.moment.angle)
        said = phrase("counterweight", letters=name, moment=moment, angle=angle)
        return joined(";  ", (said, joined(",  ", parts))) if parts else said

    def _vector(self, name: str, one: Resultant, unit: str) -> Phrase:
        """Write a vector by its size and direction; one that vanishes is 0."""
        slot = self.drafting.slot
        size = joined(" ", (slot(self._slot(name, one.size)), self.drafting.word(unit)))
        return size if one.angle is None else joined("", (size, ANGLE, slot(self._slot(f"φ {name}", one.angle)), "°"))

    def _borne(self, reactions: Sequence[Resultant], prime: str) -> Phrase:
        pairs = zip(BEARINGS, reactions, strict=True)
        told = (joined("", (f"R_{{{name}}} = ", self._vector(f"R_{name}{prime}", one, "N"))) for name, one in pairs)
        return joined(",  ", told)

    def _slot(self, quantity: str, value: float) -> Slot:
        return Slot(quantity, value, self.digits)


def grade_name(quality: float, drafting: Drafting) -> str:
    """Name the finest grade that holds e*omega mm/s."""
    grade = grade_of(quality)
    return drafting.word("no grade") if grade is None else letters(grade)
