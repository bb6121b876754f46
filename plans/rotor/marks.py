"""Marks of a rotor by the names that `explain` takes: m_1D_1, m_1D_1h_1, m_ID_I, R_A, R_A' after the correction."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from geometry.board import Mark, behind
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.rotor.balancing import COUPLES, UNBALANCES, moment_letters, unbalance_letters
from plans.rotor.study import BEARINGS, REACTIONS, RotorStudy
from plans.study import Study
from plans.words.words import languages, message, written

REACTION_LETTERS = frozenset(f"R_{bearing}{prime}" for bearing in BEARINGS for prime in ("", "'"))
UNITS = {COUPLES: "kg*m2", UNBALANCES: "kg*m", REACTIONS: "N"}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark, by its letters in any language; a rotor is the same in every position.

    A mass, m_1 or m_I, is told by its static moment.
    """
    rotor = study.of(RotorStudy)
    index = name.removeprefix("m_")
    mark = _find(rotor, name) or _find(rotor, f"m_{index}D_{index}")
    if mark is None:
        return _no_mark(rotor, name, study.scene.sheet.language)
    if position:
        raise UnknownMark(message("mark.no_position", mark=name, position=position))
    steps = tuple(behind(mark))
    return Explanation(message("explain.name", mark=name), steps, UNITS, zeros=frozenset(_zeros(rotor, steps)))


def _find(rotor: RotorStudy, name: str) -> Mark | None:
    return next((mark for mark in _marks(rotor) if name in {written(mark.name, each) for each in languages()}), None)


def _marks(rotor: RotorStudy) -> Iterator[Mark]:
    """Give all marks but the poles."""
    return (mark for board in rotor.boards for mark in board if mark.name != "0")


def _zeros(rotor: RotorStudy, steps: Sequence[Mark]) -> Iterator[Mark]:
    """Give the marks that vanish, with the corners that then fall on the pole and what is turned from them."""
    vanishing = {mark for mark, slack in _closings(rotor) if abs(complex(mark.point)) <= slack}
    yield from vanishing
    yield from (mark.step.inputs[0] for mark in vanishing if mark.step.op == "join")
    yield from (mark for mark in steps if mark.step.op == "turn" and mark.step.inputs[0] in vanishing)


def _closings(rotor: RotorStudy) -> Iterator[tuple[Mark, float]]:
    """Give what closes a sum, and how far rounding can have moved it."""
    drawing = rotor.drawing
    yield from ((polygon.closing, polygon.slack) for polygon in (drawing.moments, drawing.forces))
    yield from ((placed.mark, placed.slack) for placed in (drawing.unbalance, *drawing.corrections))
    for found in rotor.reactions:
        yield from zip(found.marks, found.slacks, strict=True)


def _no_mark(rotor: RotorStudy, name: str, language: str) -> NoMark:
    """Name the marks that there are, and what a reaction needs that is not among them."""
    names = tuple(written(mark.name, language) for mark in _marks(rotor))
    if name in REACTION_LETTERS:
        return NoMark(names, message("mark.no_reactions"), ())
    wanted = ", ".join(written(name, language) for name in _wanted(rotor))
    examples = tuple(mark.name for found in rotor.reactions for mark in found.marks[:1])
    return NoMark(names, message("mark.marks", marks=wanted), examples)


def _wanted(rotor: RotorStudy) -> list[str]:
    """Name the static moment and the moment of the first mass, and the static moments of the corrections."""
    first = rotor.rotor.masses[0].name
    planes = (unbalance_letters(plane.name) for plane in rotor.rotor.planes)
    return [unbalance_letters(first), moment_letters(first), *planes]
