"""A double crank as the inversion of a crank-rocker with the same indices: its crank is fixed (обращение, M1.4)."""

from __future__ import annotations

import cmath
import math

from geometry.board import Board, Mark, Span, between
from plans.model.synthesis.design import Design
from plans.model.synthesis.extremes import DoubleCrankTask
from plans.quantity import Shown
from plans.synthesis import rocker
from plans.synthesis.drawn import Drawn, DrawnReading, angle
from plans.words.words import because

KEPT = ("coupler", "swing", "overlap")
TURNED = {"C": "C'", "B_2": "B'"}  # with A_2, which turns into A_1


def drawn(task: DoubleCrankTask) -> tuple[DrawnReading, ...]:
    """Draw the crank-rocker on each circle, and turn its second extreme position until the crank is where it was."""
    return tuple(
        DrawnReading(KEPT, one.board, tuple(_inverted(one.board, made) for made in one.found))
        for one in rocker.drawn(task.inverted)
    )


def _inverted(board: Board, made: Drawn) -> Drawn:
    """Turn the figure about O as A2 turns into A1, and read the double crank off it."""
    before = made.design
    name = next(one for one in ("O", "O'") if one in board and board[one].point == before.places["O"])
    pivot, pins = board[name], [board[f"{name}:A_{k}"] for k in (1, 2)]
    fixed, crank = (board.join(f"{name}{pin.name}:r", pivot, pin) for pin in pins)

    def turned(old: str, new: str) -> Mark:
        way = board.join(f"{name}:{old}r", pivot, board[old])
        there = board.similar(f"{name}:{new}r", fixed, crank, way, why=because("crank_fixed"))
        return board.lay_off(f"{name}:{new}", pivot, there)

    hinge, end = (turned(old, new) for old, new in TURNED.items())
    far, coupler = complex(between(pivot, board["C"])), complex(between(board["C"], board["B_1"]))
    driven = [complex(between(pins[0], one)) for one in (board["B_1"], end)]
    reach = [complex(between(pivot, one)) for one in (board["B_1"], end)]
    there = complex(between(pivot, hinge)), complex(between(hinge, end))
    quick = abs(cmath.phase(there[0] / far))
    sizes = {"l_1": abs(far), "l_2": abs(coupler), "l_3": abs(driven[0]), "l_4": abs(complex(fixed.point))}
    sizes |= {"ψ": abs(cmath.phase(there[1] / there[0] * far / coupler)), "θ": math.pi - quick}
    sizes |= {name: size for name, size in before.sizes.items() if name.startswith("μ")}
    sizes |= {f"i_{k}": abs(reach[k - 1]) / abs(driven[k - 1]) for k in (1, 2)}
    places = {**before.places, "C'": complex(hinge.point), "B'": complex(end.point)}
    shown: dict[str, Shown] = {"l_1": Span(pivot, board["C"]), "l_3": Span(pins[0], board["B_1"]), "l_4": fixed}
    shown["θ"] = angle(
        board, f"{name}:θ'", *(board.join(f"{name}:{one.name}r", pivot, one) for one in (board["C"], hinge))
    )
    arms = {**made.arms, "ψ": sizes["l_2"], "θ": sizes["l_4"], "i_1": abs(reach[0]), "i_2": abs(reach[1])}
    design = Design(sizes, places, before.circles, before.barred, before.merit)
    old = (("O", "A_2"), ("A_2", "B_2"), ("B_2", "C"))
    figure = made.figure._replace(
        first=("O", "C", "B_1", "A_1"),
        others=(("O", "C'", "B'", "A_1"),),
        lines=(*made.figure.lines, *old),
        axes=(("O", "A_1"),),
        hinges=frozenset(("B_1", "C", "B'", "C'")),
        fixed=frozenset(("O", "A_1")),
        lengths=(("l_1", "O", "C"), ("l_2", "C", "B_1")),
        angles=(),
    )
    return Drawn(design, shown, arms, figure, made.within)
