"""A rotor in the report: what was unbalanced, what balances it, how well as drawn, its bearings (ротор в отчёте)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from drawings.lettering.rotor_letters import lowered
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.limits import DECIMALS
from drawings.paper.strokes import Line
from drawings.paper.walk import groups
from drawings.report.formula import Chapters
from drawings.report.markdown import chapter
from drawings.report.rotor_notes import GRAM_MILLIMETRES, RotorNotes, grade_name
from drawings.report.run_tables import listed, plain
from drawings.report.table import Subject
from plans.model.balance_quality import letters
from plans.model.rotor import Balance, Rotor
from plans.rotor.balancing import UNBALANCES
from plans.rotor.letters import unbalance_letters
from plans.study import Study
from plans.words.words import word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS = 10


def subject(study: Study) -> Subject:
    """Tell a rotor in a few words, for the gallery's page."""
    rotor = study["rotor"].rotor
    planes = "two planes" if rotor.dynamic else "one plane"
    grade = f", {letters(rotor.grade)}" if rotor.grade else ""
    how = "dynamic" if rotor.dynamic else "static"
    structure = f"rotor, {len(rotor.masses)} unbalanced masses"
    sentence = f"A {structure}, balanced in {planes} by vector polygons ({how} balancing{grade})."
    return Subject(structure, f"{how}, {planes}", sentence)


def headline(study: Study) -> str:
    """Say what is to be put on the rotor."""
    return "; ".join(map(plain, _notes(study).counterweights()))


def remarks(study: Study) -> list[str]:
    """Find nothing that is not whole: every rotor can be balanced."""
    return []


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell a rotor, its counterweights, its quality and its bearings."""
    drafting, comparison = drafting_of(study.scene), study.comparison("rotor")
    rotor, notes = study["rotor"].rotor, _notes(study)
    off = residuals(comparison.analysis, [leaf for own in leaves.values() for leaf in own])
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


def residuals(analysis: Balance, leaves: Sequence[Leaf]) -> dict[str, float]:
    """Give how far each counterweight's static moment kg*m, drawn to the file's last decimal, is off the analysis's."""
    planes = {unbalance_letters(one.plane.name): one.plane.name for one in analysis.corrections}
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


def _residual(rotor: Rotor, analysis: Balance, residual: Mapping[str, float], drafting: Drafting) -> Iterator[str]:
    language = drafting.language
    for name, off in residual.items():
        own, told = lowered(unbalance_letters(name), language), drafting.number(GRAM_MILLIMETRES * off, 3)
        yield word(language, "report.plane_residual", letters=own, residual=told)
    quality = rotor.quality(*residual.values())
    if quality is None:
        return
    told, of_two = drafting.number(quality, 3), "_of_two" if rotor.dynamic else ""
    if not rotor.dynamic and not analysis.couple.vanishes:  # a grade is of the whole rotor
        yield word(drafting.language, "report.resultant_quality", quality=told)
    else:
        grade = grade_name(quality, drafting)
        yield word(drafting.language, f"report.residual_quality{of_two}", quality=told, grade=grade)


def _masses(rotor: Rotor, drafting: Drafting) -> Iterator[str]:
    for one in rotor.masses:
        numbers = {"moment": one.moment, "angle": float(one.angle), "arm": 1000 * rotor.arm(one.place)}
        told = {name: drafting.number(value, DIGITS) for name, value in numbers.items()}
        yield word(drafting.language, "report.mass", name=one.name, **told)


def _notes(study: Study) -> RotorNotes:
    rotor = study["rotor"]
    return RotorNotes(rotor.rotor, rotor.balance, drafting_of(study.scene), DIGITS)
