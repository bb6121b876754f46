"""What must be said of a rotor by the analysis, sentence for sentence, on its sheet and in its report (предложения)."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from drawings.checks import reading
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.precise import precise
from drawings.checks.wrong import Wrong
from drawings.lettering.rotor_letters import index, lowered
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from plans.model.balance_quality import grade_of, letters, permissible
from plans.model.rotor import Balance, Correction, Resultant, Rotor
from plans.rotor.letters import unbalance_letters
from plans.words.words import message, word

if TYPE_CHECKING:
    from drawings.checks.precise import Precise

ENDS = "A", "B"
FEW, ON_SHEET, IN_REPORT = 4, 5, 10  # digits: of speeds and qualities; of vectors and counterweights
SHARE, TURNED = 1e-9, 1e-6  # of a number, and degrees: what both roads may differ by
GRAM_MILLIMETRES, HALF_TURN = 1e6, 180.0
_NUMBER = re.compile(r"[−-]?\d+(?:[.,]\d+)?")


class RotorSentences(NamedTuple):
    """A rotor, what balances it by the analysis, and the words of its sheet."""

    rotor: Rotor
    balance: Balance
    drafting: Drafting

    def all(self) -> Iterator[str]:
        """Give every sentence of the notes in its turn."""
        yield from (*self.sums(), *self.counterweights(), *self.quality(), *self.reactions())

    def sums(self) -> Iterator[str]:
        """Say what is unbalanced, and what one plane leaves so."""
        rotor, balance, say = self.rotor, self.balance, self.drafting.word
        if rotor.dynamic:
            yield say("arms from", plane=rotor.planes[-1].name)
        couple = self._vector(balance.couple, "kg*m2")
        yield say("sums before", unbalance=self._vector(balance.unbalance, "kg*m"), couple=couple)
        if not rotor.dynamic and not balance.couple.vanishes:
            yield say("static only", couple=self._number(abs(balance.couple.value)))

    def counterweights(self) -> Iterator[str]:
        """Say what is put in each plane."""
        yield from map(self._counterweight, self.balance.corrections)

    def reactions(self) -> Iterator[str]:
        """Say what the bearings bear."""
        balance, say = self.balance, self.drafting.word
        if balance.before and self.rotor.speed is not None:
            speed = self._number(self.rotor.speed)
            yield say("bearing loads", speed=speed, before=self._borne(balance.before))
            yield say("bearing loads after", after=self._borne(balance.after))

    @property
    def settled(self) -> bool:
        """Whether no vector is so small that rounding alone tells whether it is there."""
        own = self.balance
        vectors = [own.unbalance, own.couple, *(one.moment for one in own.corrections), *own.before, *own.after]
        moments = [abs(one.value) for one in (own.unbalance, *(one.moment for one in own.corrections))]
        lost = any(0 < one <= sys.float_info.epsilon * max(moments) for one in moments)  # beside the largest
        return not lost and not any(0 < abs(one.value) <= 1e3 * one.slack and not one.vanishes for one in vectors)

    def _number(self, value: float) -> str:
        return self._exact.number(value)

    @property
    def _exact(self) -> Precise:
        return precise(self.drafting)

    def _vector(self, one: Resultant, unit: str) -> str:
        """Write a vector by its size and direction; of one that vanishes there is neither."""
        if one.vanishes:
            return f"0 {self.drafting.word(unit)}"
        angle = self._number(math.degrees(math.atan2(one.value.imag, one.value.real)))
        return f"{self._number(abs(one.value))} {self.drafting.word(unit)}\u00a0∠\u00a0{angle}°"

    def _counterweight(self, one: Correction) -> str:
        language, say, name = self.drafting.language, self.drafting.word, one.plane.name
        own, plane = lowered(unbalance_letters(name), language), index(name, language)
        if one.moment.vanishes:
            return say("no counterweight", letters=own)
        angle = self._number(math.degrees(math.atan2(one.moment.value.imag, one.moment.value.real)))
        told = say("counterweight", letters=own, moment=self._number(abs(one.moment.value)), angle=angle)
        parts = []
        if one.mass is not None:
            parts.append(say("counterweight mass", index=plane, mass=self._number(one.mass)))
        if one.radius is not None:
            parts.append(say("counterweight radius", index=plane, radius=self._number(1000 * one.radius)))
        return f"{told};  {',  '.join(parts)}" if parts else told

    def quality(self) -> Iterator[str]:
        """Say how well it was balanced, by a grade, and what the grade that is asked for permits."""
        rotor, say = self.rotor, self.drafting.word
        before = rotor.quality(*self.balance.sizes)
        if before is None or rotor.mass is None or rotor.speed is None:
            return
        found, key = grade_of(before), "quality before of two" if rotor.dynamic else "quality before"
        name = say("no grade") if found is None else letters(found)
        yield say(key, quality=self._number(before), grade=name)
        if rotor.grade is not None:
            whole = GRAM_MILLIMETRES * permissible(rotor.grade, rotor.mass, rotor.speed)
            told = {"grade": letters(rotor.grade), "permissible": self._number(whole)}
            told["letters"] = say("permissible letters")
            half = {"each": self._number(whole / 2)} if rotor.dynamic else {}
            yield say("permissible" if rotor.dynamic else "permissible in one", **told, **half)

    def _borne(self, reactions: Sequence[Resultant]) -> str:
        pairs = zip(ENDS, reactions, strict=True)
        return ",  ".join(f"R_{{{name}}} = {self._vector(one, 'N')}" for name, one in pairs)

    def masses(self) -> Iterator[str]:
        """Tell each mass with its arm, mm, as the report does."""
        for one in self.rotor.masses:
            numbers = {"moment": one.moment, "angle": float(one.angle), "arm": 1000 * self.rotor.arm(one.place)}
            told = {name: self._number(value) for name, value in numbers.items()}
            yield word(self.drafting.language, "report.mass", name=one.name, **told)


def notes(leaf: Leaf, rotor: Rotor, balance: Balance, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the notes of a sheet that has them: these sentences come first, in this order."""
    seen, own = _spaced(reading.notes(leaf)), RotorSentences(rotor, balance, drafting)
    if seen and own.settled:
        true = _spaced(" ".join(map(read, own.all())))
        first = re.match(re.escape(_NUMBER.sub("#", true)).replace("\\#", "#").replace("#", _NUMBER.pattern), seen)
        if first is None or not tells(first[0], true, ON_SHEET):
            yield message("wrong.notes")


def tells(text: str, true: str, digits: int) -> bool:
    """Tell whether a text says what another one does with all digits, in words alike, each number to its last digit."""
    if _NUMBER.sub("#", text) != _NUMBER.sub("#", true):
        return False
    pairs = zip(_NUMBER.finditer(text), _NUMBER.finditer(true), strict=True)
    return all(_holds(one[0], other[0], true[other.end() : other.end() + 1] == "°", digits) for one, other in pairs)


def _holds(one: str, other: str, degrees: bool, digits: int) -> bool:
    value = float(other.replace("−", "-").replace(",", "."))
    slack = TURNED if degrees else SHARE * abs(value)
    turned = [value, -value] if degrees and abs(abs(value) - HALF_TURN) <= slack else [value]
    return one == other or any(reading.reads(one, true, slack, count) for true in turned for count in (digits, FEW))


def _spaced(text: str) -> str:
    return " ".join(text.split())
