"""A task of synthesis by both roads: the sizes of each mechanism beside closed forms (величины синтеза)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import zip_longest
from typing import Any

import numpy as np

from geometry.board import Board, behind
from plans.analytic.synthesis import analysed, region_of
from plans.explanation import Explanation, NoMark, explained_by
from plans.model.synthesis.design import ANALYSIS, EPS, Design, Synthesis, TaskReading, unit_of
from plans.quantity import Comparison, Numbers, Quantity, pairs
from plans.study import Study
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.drawn import DrawnDesign
from plans.synthesis.study import SynthesisStudy

NEAR = 1e-8  # rad, of a largest value; its place is known to the root of it
FIRST = "a"  # letters the first mechanism
WEAR = 32.0  # roundings of what is read off several lines


def compare_synthesis(study: SynthesisStudy) -> Comparison:
    """Put every mechanism of every reading by both roads beside each other."""
    theirs = analysed(study.task)
    findings = [
        finding
        for number, (drawn, known) in enumerate(zip(study.drawn, theirs.readings, strict=True))
        for k, (made, other) in enumerate(_taken_first(drawn.found, known.found, study.synthesis.readings[number]))
        for finding in _findings(drawn.board, made, other, suffix(number, k))
    ]
    return Comparison(study.synthesis, theirs, (*findings, *_best(study, theirs)))


def _taken_first(
    drawn: Sequence[DrawnDesign], known: Sequence[Design], reading: TaskReading
) -> list[tuple[DrawnDesign | None, Design | None]]:
    """Put the mechanisms of a reading by both roads beside each other, that which is shown before the others."""
    pairs = [*zip_longest(drawn, known)]
    best = reading.best if reading.found else 0
    return [*pairs[best : best + 1], *pairs[:best], *pairs[best + 1 :]]


def _best(study: SynthesisStudy, theirs: Synthesis) -> Iterator[Quantity]:
    """Compare the best place of a pivot on its arc, and its value there."""
    if not any(reading.found for reading in theirs.readings) or (ours := study.region) is None:
        return
    known, value = region_of(study.task, theirs.chosen), next(iter(ours.curves))
    others = (math.nan, math.nan) if known is None else known.best
    names = {"γ_best": math.sqrt(NEAR), f"{value[0]}_best": NEAR}
    for (name, near), mine, other in zip(names.items(), ours.best, others, strict=True):
        yield Quantity.of((SYNTHESIS, name, unit_of(name)), (mine, other), near)


def suffix(number: int, place: int) -> str:
    """Tell the mechanisms of a task apart: the first has none, those of other constructions a letter.

    >>> suffix(0, 0), suffix(0, 1), suffix(1, 0)
    ('', "'", ',b')
    """
    return "'" * place + (f",{letter_of(number)}" if number else "")


def apart(name: str) -> tuple[str, str]:
    """Tell a size's letter from that of its mechanism, of which the first has no suffix.

    >>> apart("l_1"), apart("l_1'"), apart("e',b")
    (('l_1', 'a'), ('l_1', "a'"), ('e', "b'"))
    """
    whole, _, construction = name.partition(",")
    letter = whole.rstrip("'")
    return letter, (construction or FIRST) + whole[len(letter) :]


def letter_of(number: int) -> str:
    """Letter a construction of a task.

    >>> letter_of(0), letter_of(2)
    ('a', 'c')
    """
    return chr(ord("a") + number)


def _findings(board: Board, made: DrawnDesign | None, known: Design | None, after: str) -> Iterator[Quantity]:
    """Compare every size; one that a road alone has is not a number by the other."""
    ours: Mapping[str, float] = {} if made is None else made.design.sizes
    theirs: Mapping[str, float] = {} if known is None else known.sizes
    slack = 0.0 if made is None else _slack(board, made)
    for name in ours | theirs:  # type: ignore[operator]
        pair, shown = (ours.get(name, math.nan), theirs.get(name, math.nan)), None
        if made is not None:
            shown = made.shown.get(name)
        allowed = slack if made is None else _allowed(name, made, slack)
        yield Quantity.of((SYNTHESIS, f"{name}{after}", unit_of(name)), pair, allowed, shown=shown)


def _allowed(name: str, made: DrawnDesign, slack: float) -> float:
    """Give how far rounding may move a size: a length, an angle over its arm, a rate or a ratio by its share."""
    arm = made.arms.get(name, next(iter(made.design.sizes.values())))
    turned = WEAR * EPS + slack / arm
    off = {"m": slack, "rad": turned}.get(unit_of(name), abs(made.design.sizes[name]) * turned)
    return off + made.within.get(name, 0.0)


def _slack(board: Board, made: DrawnDesign) -> float:
    """Give how far rounding may move a length, m: more where loci meet flatly."""
    marks = [mark for one in made.shown.values() for mark in Quantity.of(("", "", ""), (0, 0), 0, shown=one).marks]
    met = (mark.meeting for mark in behind(*marks) if mark.meeting is not None)
    sharp = min((float(np.abs(np.asarray(one.sharpness))) for one in met), default=1.0)
    reach = max(abs(complex(mark.point)) for mark in board if not isinstance(mark.value, tuple))
    return WEAR * EPS * (reach + next(iter(made.design.sizes.values()))) / sharp


def numbers(study: Study, by: str) -> Numbers:
    """Give by a road every mechanism of every reading as plain data."""
    ours = study.of(SynthesisStudy)
    found = analysed(ours.task) if by == ANALYSIS else ours.synthesis
    rows = [
        {"demands": list(reading.kept), "mechanisms": [told(one) for one in reading.found]}
        for reading in found.readings
    ]
    return Numbers({"scene": study.scene.heading(), "by": by, SYNTHESIS: rows})


def told(made: Design) -> dict[str, Any]:
    """Give a mechanism as plain data, SI: its sizes and the places of its construction by their letters."""
    places = dict(zip(made.places, pairs(np.array([*made.places.values()])), strict=True))
    return {**made.sizes, "places": places}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark: places and lengths are metres."""
    found = explained_by(study.comparison(SYNTHESIS).findings, position, name)
    return found._replace(units={SYNTHESIS: "m"}) if isinstance(found, Explanation) else found
