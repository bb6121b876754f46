"""Marks of a rotor by the names that `explain` takes: m_1D_1, m_1D_1h_1, m_ID_I, R_A, R_A' after the correction."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry.board import Board, behind
from plans.explanation import Explanation, NoMark
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.bearings import REACTIONS
from plans.rotor.letters import moment_letters, unbalance_letters
from plans.words.words import message

if TYPE_CHECKING:
    from plans.rotor.study import RotorStudy
    from plans.study import Study

UNITS = {COUPLES: "kg*m2", UNBALANCES: "kg*m", REACTIONS: "N"}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark; a rotor has no positions, and each is the same."""
    rotor: RotorStudy = study["rotor"]
    mark = next((board[name] for board in rotor.boards if name in board and name != "0"), None)
    if mark is None:
        return NoMark(_names(rotor.boards), message("mark.marks", marks=", ".join(_wanted(rotor))), ("R_A", "R_A'"))
    return Explanation(message("explain.name", mark=name), tuple(behind(mark)), UNITS)


def _names(boards: tuple[Board, ...]) -> tuple[str, ...]:
    return tuple(mark.name for board in boards for mark in board if mark.name != "0")


def _wanted(rotor: RotorStudy) -> list[str]:
    """Name the static moment and the moment of the first mass, and the static moments of the corrections."""
    first = rotor.rotor.masses[0].name
    planes = (unbalance_letters(plane.name) for plane in rotor.rotor.planes)
    return [unbalance_letters(first), moment_letters(first), *planes]
