"""A rotor in the report and in the notes of its sheet: balance, quality, reactions (ротор в отчёте)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.lettering.rotor_letters import index, lowered
from drawings.lettering.words import Phrase, Slot, joined
from drawings.page.page import Drafting, drafting_of
from drawings.paper.limits import DECIMALS
from drawings.paper.strokes import Leaf, Line
from drawings.paper.walk import groups
from drawings.report.formula import DIGITS, Chapters, entry, listed, plain
from drawings.report.report import ANGLE, Report, TableSubject, chapter
from plans.model.rotor import Correction, Resultant, Rotor, RotorBalance, grade_of, letters, permissible
from plans.rotor.balancing import UNBALANCES, unbalance_letters
from plans.rotor.study import BEARINGS, RotorStudy
from plans.study import Study
from plans.words.words import word

GRAM_MILLIMETRES = 1e6  # of a kg*m


class RotorNotes(NamedTuple):
    """The notes on a balanced rotor, with so many digits."""

    rotor: Rotor
    balance: RotorBalance
    drafting: Drafting
    digits: int = 5

    @property
    def all(self) -> tuple[str, ...]:
        """What was unbalanced, what balances it, how well, and what the bearings bear."""
        return *self.sums(), *self.counterweights(), *self.quality(), *self.reactions()

    def sums(self) -> Iterator[str]:
        """Say what was unbalanced, and what one plane leaves so."""
        rotor, balance, word, phrase = self.rotor, self.balance, self.drafting.word, self.drafting.phrase
        if rotor.mass is not None and rotor.speed is not None:  # what quality and permissible unbalance rest on
            n, omega = Slot("n", rotor.speed * 30 / math.pi), Slot("ω", rotor.speed)
            yield phrase("rotor given", mass=Slot("m", rotor.mass), n=n, omega=omega)
        yield word("arms from", plane=rotor.planes[-1].name) if rotor.dynamic else word("masses from")
        couple = self._vector("ΣmDh", balance.couple, "kg*m2")
        yield phrase("sums before", unbalance=self._vector("ΣmD", balance.unbalance, "kg*m"), couple=couple)
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
        key = "quality before of two" if rotor.dynamic else "quality before"
        yield phrase(key, quality=Slot("e·ω", before), grade=grade_name(before, self.drafting))
        if rotor.grade is not None:
            whole = GRAM_MILLIMETRES * permissible(rotor.grade, rotor.mass, rotor.speed)
            permissible_letters = word("permissible letters")
            grade = {"grade": letters(rotor.grade), "permissible": Slot("U_per", whole), "letters": permissible_letters}
            each = {"each": Slot("U_per each", whole / len(rotor.planes))}
            yield phrase("permissible", **grade, **each) if rotor.dynamic else phrase("permissible in one", **grade)

    def reactions(self) -> Iterator[str]:
        """Say what the bearings bear before and after."""
        balance, phrase = self.balance, self.drafting.phrase
        if balance.before and self.rotor.speed is not None:
            yield phrase("bearing loads", speed=Slot("ω", self.rotor.speed), before=self._borne(balance.before, ""))
            yield phrase("bearing loads after", after=self._borne(balance.after, "'"))

    def _counterweight(self, body: Correction) -> str:
        language, phrase = self.drafting.language, self.drafting.phrase
        letters = unbalance_letters(body.plane.name)
        name, plane = lowered(letters, language), index(body.plane.name, language)
        if body.moment.angle is None:
            return phrase("no counterweight", letters=name)
        parts = []
        if body.mass is not None:
            parts.append(phrase("counterweight mass", index=plane, mass=self._slot(f"m_{body.plane.name}", body.mass)))
        if body.radius is not None:
            far = self._slot(f"D_{body.plane.name}", 1000 * body.radius)
            parts.append(phrase("counterweight radius", index=plane, radius=far))
        moment, angle = self._slot(letters, body.moment.size), self._slot(f"φ {letters}", body.moment.angle)
        said = phrase("counterweight", letters=name, moment=moment, angle=angle)
        return joined(";  ", (said, joined(",  ", parts))) if parts else said

    def _vector(self, name: str, load: Resultant, unit: str) -> Phrase:
        """Write a vector by its size and direction; one that vanishes is 0."""
        slot = self.drafting.slot
        size = joined(" ", (slot(self._slot(name, load.size)), self.drafting.word(unit)))
        return size if load.angle is None else joined("", (size, ANGLE, slot(self._slot(f"φ {name}", load.angle)), "°"))

    def _borne(self, reactions: Sequence[Resultant], prime: str) -> Phrase:
        pairs = zip(BEARINGS, reactions, strict=True)
        parts = (joined("", (f"R_{{{name}}} = ", self._vector(f"R_{name}{prime}", load, "N"))) for name, load in pairs)
        return joined(",  ", parts)

    def _slot(self, quantity: str, value: float) -> Slot:
        return Slot(quantity, value, self.digits)


def grade_name(quality: float, drafting: Drafting) -> str:
    """Name the finest grade that holds e*omega mm/s."""
    grade = grade_of(quality)
    return drafting.word("no grade") if grade is None else letters(grade)


def subject(study: Study) -> TableSubject:
    """Tell a rotor in a few words, for the gallery's page."""
    rotor = study.of(RotorStudy).rotor
    planes = "two planes" if rotor.dynamic else "one plane"
    grade = f", {letters(rotor.grade)}" if rotor.grade else ""
    how = "dynamic" if rotor.dynamic else "static"
    structure = f"rotor, {len(rotor.masses)} unbalanced masses"
    sentence = f"A {structure}, balanced in {planes} by vector polygons ({how} balancing{grade})."
    return TableSubject(structure, f"{how}, {planes}", sentence)


def headline(study: Study) -> str:
    """Say what is to be put on the rotor."""
    return "; ".join(map(plain, _notes(study).counterweights()))


def _concluded(study: Study) -> Iterator[str]:
    """Say what is to be put on the rotor, and how well it then is balanced."""
    notes = _notes(study)
    yield from map(entry, (*notes.counterweights(), *notes.quality()))


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell a rotor, its counterweights, its quality and its bearings."""
    drafting, comparison = drafting_of(study.scene), study.comparison("rotor")
    rotor, notes = study.of(RotorStudy).rotor, _notes(study)
    off = residuals(comparison.analysis, [leaf for group in leaves.values() for leaf in group])
    residual = _residual(rotor, comparison.analysis, off, drafting)
    return Chapters(
        subject=listed(chapter(drafting.language, "rotor").lstrip(), [*_masses(rotor, drafting), *notes.sums()]),
        values=listed(chapter(drafting.language, "counterweights"), notes.counterweights()),
        conditions=[
            *listed(chapter(drafting.language, "quality"), [*notes.quality(), *residual]),
            *listed(chapter(drafting.language, "bearings"), notes.reactions()),
        ],
        left_out=[word(drafting.language, "report.rotor_left_out")],
    )


def residuals(analysis: RotorBalance, leaves: Sequence[Leaf]) -> dict[str, float]:
    """Give how far each counterweight's static moment kg*m, drawn to the file's last decimal, is off the analysis's."""
    planes = {unbalance_letters(correction.plane.name): correction.plane.name for correction in analysis.corrections}
    true = dict(zip(planes.values(), analysis.moments, strict=True))
    read = dict.fromkeys(true, 0j)
    for group in groups(group for leaf in leaves for group in leaf.groups):
        line = group.strokes[0] if group.strokes else None
        name = planes.get(group.data.get("name", "")) if group.data.get("plan") == UNBALANCES else None
        if name is not None and isinstance(line, Line):
            read[name] = (_written(line.end) - _written(line.start)) * float(group.data["scale"])
    return {name: abs(read[name] - value) for name, value in true.items()}


def _written(place: complex) -> complex:
    """Give a place, mm, as a pen writes it."""
    return complex(round(place.real, DECIMALS), round(place.imag, DECIMALS))


def _residual(rotor: Rotor, analysis: RotorBalance, residual: Mapping[str, float], drafting: Drafting) -> Iterator[str]:
    language = drafting.language
    for name, off in residual.items():
        letters, amount = lowered(unbalance_letters(name), language), drafting.number(GRAM_MILLIMETRES * off, 3)
        yield word(language, "report.plane_residual", letters=letters, residual=amount)
    quality = rotor.quality(*residual.values())
    if quality is None:
        return
    amount, of_two = drafting.number(quality, 3), "_of_two" if rotor.dynamic else ""
    if not rotor.dynamic and not analysis.couple.vanishes:  # a grade is of the whole rotor
        yield word(drafting.language, "report.resultant_quality", quality=amount)
    else:
        grade = grade_name(quality, drafting)
        yield word(drafting.language, f"report.residual_quality{of_two}", quality=amount, grade=grade)


def _masses(rotor: Rotor, drafting: Drafting) -> Iterator[str]:
    for mass in rotor.masses:
        numbers = {"moment": mass.moment, "angle": float(mass.angle), "arm": 1000 * rotor.arm(mass.place)}
        texts = {name: drafting.number(value, DIGITS) for name, value in numbers.items()}
        yield word(drafting.language, "report.mass", name=mass.name, **texts)


def _notes(study: Study) -> RotorNotes:
    rotor = study.of(RotorStudy)
    return RotorNotes(rotor.rotor, rotor.balance, drafting_of(study.scene), DIGITS)


REPORT = Report(chapters, headline, subject=subject, conclusion=_concluded)
