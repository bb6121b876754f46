"""Marks of a balance by the names that `explain` takes: S, a_S, h_2, Φ, M_Φ, with a prime after; H_3, U_3 (точки)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from geometry.board import Board, Mark, at, behind
from plans.balance import mass_centre, sums
from plans.balance.mass_centre import MAIN, Drawing, VectorChain
from plans.balance.study import BalanceStudy
from plans.explanation import Explanation, NoMark
from plans.linkage import marks as motion
from plans.model.balance.linkage import EPS, ROUNDING
from plans.study import Study
from plans.words.words import Message, message

AFTER = "'"  # behind the letter of what a balanced machine has
STILL = re.compile(r"(U|H|mh)_\d+'?|m_left\w+")  # what is the same in every position
UNITS = {**motion.UNITS, **sums.UNITS, MAIN: "m", **mass_centre.UNITS}
EXAMPLES = ("S", "a_S", "Φ", "M_Φ")


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark: of the mass centre in one position, of what balances the links in all."""
    balance = study.of(BalanceStudy)
    linkage, letter = balance.linkage, name.replace("Phi", "Φ")
    if name in motion.letters(linkage):
        return _none(balance)
    if STILL.fullmatch(letter):
        mark = _on((board for board in _still(balance, letter)), letter.removesuffix(AFTER))
        title = message("explain.name", mark=name)
        return _none(balance) if mark is None else Explanation(title, tuple(behind(mark)), UNITS)
    if letter.endswith(AFTER) and balance.after is None:
        return _none(balance)
    wanted = motion.position_of(linkage, position)
    drawing = balance.drawing(letter.endswith(AFTER), wanted)
    # What the mass centre rests in where no vector of a main point leads to it.
    ends = {"S": drawing.main.end, "a_S": drawing.accelerations.end}
    mark = _on(_boards(drawing), letter.removesuffix(AFTER)) or ends.get(letter.removesuffix(AFTER))
    if mark is None:
        return _none(balance)
    title, zeros = motion.title(linkage, name, wanted), frozenset(_zeros(drawing))
    return Explanation(title, *_steps(behind(mark), study.whole), motion.HOME, zeros)


def _steps(steps: list[Mark], whole: bool) -> tuple[tuple[Mark, ...], Mapping[str, str], tuple[Message, ...]]:
    """Give the steps that are told, the units of their boards, and a note on the plans of the motion, left out."""
    if whole:
        return tuple(steps), UNITS, ()
    left = tuple(step for step in steps if step.subject not in motion.UNITS)
    return left, UNITS, (message("explain.left_out", count=len(steps) - len(left)),)


def _still(balance: BalanceStudy, letter: str) -> Iterator[Board]:
    """Give the boards of the static moments in links: of main points, or of the counterweights."""
    found = balance.points(letter.endswith(AFTER)).sums if letter.startswith("mh") else balance.substitution.sums
    yield from (found.moments, found.masses)


def _boards(drawing: Drawing) -> Iterator[Board]:
    yield from (chain.board for chain in (drawing.main, drawing.polygon, drawing.accelerations, drawing.shaking))


def _on(boards: Iterator[Board], letter: str) -> Mark | None:
    """Find a mark that was drawn from others, but no inertia force of one link: it is the force plan's too."""
    found = next((board[letter] for board in boards if letter in board), None)
    return found if found is not None and found.step.inputs and not re.fullmatch(r"Φ_\d+", letter) else None


def _zeros(drawing: Drawing) -> Iterator[Mark]:
    """Give what closes vectors that close by themselves, and what is turned from it: nothing but rounding."""
    for chain in (drawing.main, drawing.polygon, drawing.accelerations, drawing.shaking):
        if _vanishes(chain):
            yield from (mark for mark in chain.board if mark is chain.end or chain.end in mark.step.inputs)
    if _vanishes(drawing.accelerations):
        yield drawing.force


def _vanishes(chain: VectorChain) -> bool:
    length = sum(abs(at(side.vector.point, 0)) for side in chain.sides)
    return abs(at(chain.end.point, 0)) <= ROUNDING * EPS * length


def _none(balance: BalanceStudy) -> NoMark:
    """Name the marks that there are; a vector of a main point that is nothing is none."""
    weights = [f"U_{link}" for link in balance.substitution.needs]
    names = [*EXAMPLES, *_vectors(balance, after=False), *weights]
    if balance.after is not None:
        names += [f"{name}{AFTER}" for name in (*EXAMPLES, *_vectors(balance, after=True))]
    return NoMark(tuple(names), None, (*EXAMPLES, *weights[:1]))


def _vectors(balance: BalanceStudy, after: bool) -> list[str]:
    return [f"h_{link}" for link, vector in balance.points(after=after).vectors.items() if vector]
