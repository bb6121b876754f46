"""A double crank as the inversion of a crank-rocker with the same indices: its crank is fixed (обращение, M1.4)."""

from __future__ import annotations

import cmath
import math

from geometry.board import Board, Mark, Span, between
from plans.model.synthesis.design import Design
from plans.model.synthesis.extremes import DoubleCrankTask
from plans.quantity import Shown
from plans.synthesis import rocker
from plans.synthesis.drawn import DrawnDesign, DrawnReading, SynthesisFigure, angle
from plans.words.words import because

KEPT = ("coupler", "swing", "overlap")
TURNED = {"C": "C'", "B_2": "B'"}  # with A_2, which turns into A_1


def drawn(task: DoubleCrankTask) -> tuple[DrawnReading, ...]:
    """Draw the crank-rocker on each circle, and turn its second extreme position until the crank is where it was."""
    return tuple(
        DrawnReading(KEPT, one.board, tuple(_inverted(one.board, made) for made in one.found))
        for one in rocker.drawn(task.inverted)
    )


def _inverted(board: Board, made: DrawnDesign) -> DrawnDesign:
    """Turn the figure about O as A2 turns into A1, and read the double crank off it."""
    before = made.design
    name = next(one for one in ("O", "O'") if one in board and board[one].point == before.places["O"])
    pivot, pins = board[name], [board[f"{name}:A_{k}"] for k in (1, 2)]
    first, second = (board.join(f"{pin.name}:r", pivot, pin) for pin in pins)
    hinge, end = (_turned(board, pivot, board[old], (first, second), new) for old, new in TURNED.items())
    sizes, arms = _read(pivot, pins[0], (board["C"], board["B_1"]), (hinge, end))
    sizes |= {name: size for name, size in before.sizes.items() if name.startswith("μ")}
    places = {**before.places, "C'": complex(hinge.point), "B'": complex(end.point)}
    ways = (board.join(f"{name}:{one.name}:r", pivot, one) for one in (board["C"], hinge))
    shown: dict[str, Shown] = {"l_1": Span(pivot, board["C"]), "l_3": Span(pins[0], board["B_1"]), "l_4": first}
    shown["θ"] = angle(board, f"{name}:θ'", *ways)
    design = Design(sizes, places, before.circles, before.barred, before.merit)
    return DrawnDesign(design, shown, {**made.arms, **arms}, _figure(made.figure), made.within)


def _turned(board: Board, pivot: Mark, mark: Mark, pins: tuple[Mark, Mark], name: str) -> Mark:
    """Turn a place about O as the second place of the crank turns into the first."""
    way = board.join(f"{pivot.name}:{mark.name}:t", pivot, mark)
    there = board.similar(f"{pivot.name}:{name}:t", *pins, way, why=because("crank_fixed"))
    return board.lay_off(f"{pivot.name}:{name}" if name in board else name, pivot, there)


def _read(pivot: Mark, pin: Mark, *ends: tuple[Mark, Mark]) -> tuple[dict[str, float], dict[str, float]]:
    """Read lengths, angles and both ratios of speeds off C, B in line with O and A, and arms m of these."""
    driver = [complex(between(pivot, hinge)) for hinge, _ in ends]
    coupler = [complex(between(hinge, end)) for hinge, end in ends]
    driven, reach = ([abs(complex(between(one, end))) for _, end in ends] for one in (pin, pivot))
    lengths = abs(driver[0]), abs(coupler[0]), driven[0], abs(complex(between(pivot, pin)))
    sizes = {f"l_{k}": length for k, length in enumerate(lengths, 1)}
    sizes["ψ"] = abs(cmath.phase(coupler[1] / driver[1] * driver[0] / coupler[0]))
    sizes["θ"] = math.pi - abs(cmath.phase(driver[1] / driver[0]))
    sizes |= {f"i_{k}": far / arm for k, (far, arm) in enumerate(zip(reach, driven, strict=True), 1)}
    return sizes, {"ψ": sizes["l_2"], "θ": sizes["l_4"], "i_1": reach[0], "i_2": reach[1]}


def _figure(before: SynthesisFigure) -> SynthesisFigure:
    """Show the double crank where O, A, B are in line, and the crank-rocker's second place by thin lines."""
    return before._replace(
        first=("O", "C", "B_1", "A_1"),
        others=(("O", "C'", "B'", "A_1"),),
        lines=(*before.lines, ("O", "A_2"), ("A_2", "B_2"), ("B_2", "C")),
        axes=(("O", "A_1"),),
        hinges=frozenset(("B_1", "C", "B'", "C'")),
        fixed=frozenset(("O", "A_1")),
        lengths=(("l_1", "O", "C"), ("l_2", "C", "B_1")),
        angles=(),
    )
