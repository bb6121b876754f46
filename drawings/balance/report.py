"""Balancing in the report: tables of masses, centres, counterweights and costs (уравновешивание в отчёте)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from drawings.balance.costs import METRES, NONE, Nothing, cells, degrees, quantities, shape
from drawings.balance.notes import BalanceNotes
from drawings.forces.report import drafting_of_forces, masses_and_loads
from drawings.lettering.words import CENTRE, FORCE, MOMENT, counterweight
from drawings.linkage.report import ROUNDED
from drawings.paper.strokes import Leaf
from drawings.report.formula import DIGITS, Chapters, entry, plain
from drawings.report.report import Report, chapter, header, row, tabled, united
from plans.balance.study import BalanceStudy
from plans.forces.statics import Statics
from plans.model.balance.linkage import Counterweight
from plans.model.motion import NOTHING
from plans.study import Study
from plans.words.words import word

TELLING = frozenset({"forces", "dynamics"})  # techniques that tell masses and loads themselves


def centres(notes: BalanceNotes) -> Iterator[str]:
    """Tell mass centre, main vector and main moment at the positions of the scene, before and after."""
    before, after = notes.balance.before, notes.balance.loaded
    drafting, states = notes.drafting, {"": before} if after is None else {"": before, "'": after}
    heads = ["φ, °"]
    columns: list[Any] = [np.round(np.degrees(notes.balance.before.centre.phi), ROUNDED) % 360]
    for mark, state in states.items():
        heads += [f"{CENTRE}{mark}, m", f"{FORCE}{mark}, N", f"{MOMENT}{mark}, N*m"]
        least = (NOTHING * notes.equations.reach, *notes.balance.before.forces.nothing)
        values = state.centre.r, state.centre.force, state.centre.moment
        columns += [np.where(np.abs(row) <= none, 0, row) for row, none in zip(values, least, strict=True)]
    yield from tabled(united(heads, drafting), columns, drafting.language)


def counterweights(notes: BalanceNotes) -> Iterator[str]:
    """Tell each counterweight: static moment, mass, place, shape and sizes, inertia about its own centre."""
    drafting, language = notes.drafting, notes.drafting.language
    lines = [drafting.word(key) for key in ("counterweight column", "on link", "from", "shape")]
    heads = [*lines[:3], "m·a, kg*m", "m, kg", "a, m", "∠, °", lines[3], "R, m", "b, m", "J, kg*m2"]
    yield from header(united(heads, drafting))
    for weight in notes.balance.counterweights:
        letter = counterweight(weight.link, language).replace("{", "").replace("}", "")
        yield row([letter, str(weight.link), weight.begin, *_sizes(weight, notes)])


def _sizes(weight: Counterweight, notes: BalanceNotes) -> list[str]:
    if not weight.needed:
        return ["0", "0", *(NONE for _ in range(6))]
    drafting, sizes = notes.drafting, (weight.outer, weight.place.thickness, weight.inertia)
    numbers = [abs(weight.moment), weight.mass, weight.distance, degrees(weight, notes.mechanism), *sizes]
    cells = [drafting.number(value, DIGITS) for value in numbers]
    return [*cells[:4], shape(weight, drafting), *cells[4:]]


def costs(notes: BalanceNotes) -> Iterator[str]:
    """Tell what is largest over the turn before and after, and by how many per cent it changes."""
    drafting, before, after = notes.drafting, notes.balance.before, notes.balance.loaded
    keys = ("before column", *(("after column", "change column") if after is not None else ()))
    heading = drafting.word("largest value", count=before.count)
    yield from header([heading, *map(drafting.word, keys)])
    none = Nothing(*before.forces.nothing, NOTHING * notes.equations.reach)
    for quantity in quantities(before, none, drafting, notes.mechanism.drive.pivot, METRES):
        yield row([quantity.name.replace("{", "").replace("}", ""), *cells(quantity, before, after, drafting, DIGITS)])


def headline(study: Study) -> str:
    """Say what is to be put on, and what it costs."""
    notes = notes_of(study)
    return "; ".join(map(plain, (*notes.counterweights(), *notes.price())))


def _concluded(study: Study) -> Iterator[str]:
    """Say what is put on, what that makes of the mass centre, and what it costs, each by itself."""
    notes = notes_of(study)
    found = [*weights(notes)]
    yield from found
    told = () if found else notes.counterweights()
    yield from map(entry, (*told, *notes.balanced(), *notes.left(), *notes.price()))


def weights(notes: BalanceNotes) -> Iterator[str]:
    """Say of each counterweight that is needed how heavy it is, and where it is put."""
    yield from (_weight(weight, notes) for weight in notes.balance.counterweights if weight.needed)


def _weight(weight: Counterweight, notes: BalanceNotes) -> str:
    number, language = partial(notes.drafting.number, digits=DIGITS), notes.drafting.language
    sizes = {"mass": number(weight.mass), "distance": number(weight.distance)}
    places = {"link": weight.link, "begin": weight.begin, "angle": number(degrees(weight, notes.mechanism))}
    return word(language, "report.balance_weight", letter=counterweight(weight.link, language), **sizes, **places)


def notes_of(study: Study) -> BalanceNotes:
    """Give the notes on what the construction finds."""
    made = study.of(BalanceStudy)
    vectors = made.points().vectors, None if made.balance.after is None else made.points(after=True).vectors
    drafting = drafting_of_forces(made.statics)
    return BalanceNotes(made.linkage.mechanism, made.tree, made.machine, made.balance, vectors, drafting)


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell what is balanced, by what, and what it costs."""
    language, notes = study.scene.sheet.language, notes_of(study)
    aim = word(language, f"report.aim_{notes.balance.task.aim}")
    told = () if TELLING & {*study.techniques} else masses_and_loads(study.of(Statics), language)
    return Chapters(
        subject=[*told, chapter(language, "balancing"), aim, *map(entry, notes.main_points())],
        values=[
            *_counterweights(notes),
            chapter(language, "balance_costs"),
            *costs(notes),
            *_shares(notes),
            chapter(language, "mass_centre"),
            *centres(notes),
        ],
        left_out=[word(language, "report.balance_left_out")],
    )


def _counterweights(notes: BalanceNotes) -> Iterator[str]:
    lines = [*notes.counterweights(), *notes.balanced(), *notes.left()]
    if lines:
        yield chapter(notes.drafting.language, "counterweights")
        yield from map(entry, lines)
    if notes.balance.counterweights:
        yield ""
        yield from counterweights(notes)


def _shares(notes: BalanceNotes) -> Iterator[str]:
    shares = notes.balance.shares
    if shares is not None:
        yield chapter(notes.drafting.language, "shares")
        yield from map(entry, notes.choice())
        yield ""
        newtons = notes.drafting.word("N")
        yield from header(["k", f"{FORCE} _max, {newtons}", f"{plain(notes.shaft)} _max, {newtons}"])
        for choice in sorted({*shares.curve, shares.least_force, shares.least_reaction}):
            yield row([notes.drafting.number(value, DIGITS) for value in choice])


REPORT = Report(chapters, headline, conclusion=_concluded)
