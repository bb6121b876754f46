"""The self-check of a rotor's notes: each number that they give a letter (проверка пояснений)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from drawings.checks.reading import NOTES, reads
from drawings.checks.rotor.rotor_tables import Cell, direction, found_mass, named, radius
from drawings.checks.wrong import Wrong, within
from drawings.lettering.rotor_letters import index
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts
from drawings.report.rotor_notes import ANGLE, GRAM_MILLIMETRES
from plans.checks.comparison import Comparison
from plans.model.balance_quality import permissible
from plans.model.rotor import Balance, Rotor
from plans.rotor.letters import unbalance_letters

DIGITS, FEWER = 5, 4  # of vectors and counterweights; of speeds and of what a grade permits
_NUMBER = r"[−\d.,]*\d"
_GAP = "\0"  # stands for a number of a phrase


class Told(NamedTuple):
    """What a note must say: a letter, its size, its direction if it has one, and whether it may be left out."""

    name: str
    size: Cell
    digits: int = DIGITS
    angle: Cell | None = None
    optional: bool = False

    def holds(self, value: str, angle: str | None) -> bool:
        """Tell whether a note says it."""
        if self.size.true is None or not reads(value, self.size.true, self.size.slack, self.digits):
            return False
        return angle is None or (self.angle is not None and self.angle.holds(angle))


def notes(leaf: Leaf, rotor: Rotor, comparison: Comparison, drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes of the first sheet back: each letter in its turn, none left out."""
    if not leaf.metadata["notes"]:
        return
    told = " ".join(text.plain for group in leaf.groups if group.name == NOTES for text in texts((group,)))
    due = list(_expected(rotor, comparison, drafting))
    for found in _told(drafting).finditer(told):
        one = next((one for one in due if one.name == found["name"]), None)
        if one is None:
            yield within("stranger_in", NOTES, text=found[0])
            continue
        due.remove(one)
        if not one.holds(found["value"], found["angle"]) or (found["angle"] is None and _pointed(one)):
            yield within("in", NOTES, text=found[0])
    yield from (within("missing_from", NOTES, name=one.name) for one in due if not one.optional)


def _told(drafting: Drafting) -> re.Pattern[str]:
    """Read a letter with its size and, as the phrase of a counterweight or a vector tells it, its direction."""
    _, before, after = drafting.word("counterweight", letters="", moment=_GAP, angle=_GAP).split(_GAP)
    turned = rf"(?:{_spaced(before)}|\s\S+{_spaced(ANGLE)})(?P<angle>{_NUMBER}){_spaced(after)}"
    return re.compile(rf"(?P<name>[^\s=;,]+)\s=\s(?P<value>{_NUMBER})(?:{turned})?")


def _spaced(text: str) -> str:
    """Give the pattern of a text in which any space may be a line's end."""
    return re.sub(r"\s", r"\\s", "".join(one if one.isspace() else re.escape(one) for one in text))


def _pointed(one: Told) -> bool:
    """Tell whether a vector has a direction that must be told."""
    return one.angle is not None and one.angle.true is not None


def _expected(rotor: Rotor, comparison: Comparison, drafting: Drafting) -> Iterator[Told]:
    """Give all that the notes must say, in their order."""
    analysis: Balance = comparison.analysis
    for name, one in named(comparison, drafting.language).items():
        value, slack = complex(one.analysis[0]), float(one.allowed[0])
        size = Cell(0.0 if abs(value) <= slack else abs(value), slack)
        yield Told(name.rstrip("'"), size, angle=direction(value, slack))
        if one.name == "ΣmDh" and not rotor.dynamic:
            yield Told(name, size, optional=abs(value) <= slack)
    slacks = {one.name: float(one.allowed[0]) for one in comparison.findings}
    for found in analysis.corrections:
        letters, lost = index(found.plane.name, drafting.language), found.moment.angle is None
        slack = slacks[unbalance_letters(found.plane.name)]
        far = radius(found, 1000 * slack)
        for letter, cell in (("m", found_mass(found, slack)), ("D", far._replace(true=1000 * (far.true or 0.0)))):
            given = found.mass if letter == "m" else found.radius
            if given is not None:
                yield Told(Text(0j, f"{letter}_{{{letters}}}").plain, cell, optional=lost)
    yield from _graded(rotor, analysis, drafting)


def _graded(rotor: Rotor, analysis: Balance, drafting: Drafting) -> Iterator[Told]:
    quality = rotor.quality(*analysis.sizes)
    if quality is not None and rotor.mass is not None and rotor.speed is not None:
        slack = rotor.quality(*(one.moment.slack for one in analysis.corrections)) or 0.0
        yield Told("e·ω", Cell(quality, 2 * slack), FEWER)
        if rotor.grade is not None:
            whole = GRAM_MILLIMETRES * permissible(rotor.grade, rotor.mass, rotor.speed)
            yield Told(Text(0j, drafting.word("permissible letters")).plain, Cell(whole), FEWER)
    if analysis.before and rotor.speed is not None:
        yield Told("ω", Cell(rotor.speed), FEWER)
