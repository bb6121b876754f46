"""Marks of a rotor by the names that `explain` takes: m_1D_1, m_1D_1h_1, m_ID_I, R_A, R_A' after the correction."""

from __future__ import annotations

from geometry.board import Board, Mark
from plans.rotor.study import RotorStudy


def boards(study: RotorStudy) -> tuple[Board, ...]:
    """Give the boards of a rotor in the order of drawing."""
    drawing, (before, _) = study.drawing, study.reactions
    return (*drawing.boards, *((before.board,) if before.board else ()))


def find(study: RotorStudy, name: str) -> Mark | None:
    """Find a mark; nothing where no board has it."""
    return next((board[name] for board in boards(study) if name in board), None)
