"""Slotted links: the oscillating one by tangents to the crank circle, the rotating one by its chord (кулисы, M1.7)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from geometry.board import Board, Mark, Span, between
from geometry.meet import cross
from plans.model.synthesis.design import Design, LocusCircle
from plans.model.synthesis.slots import LEVER, WHITWORTH, LeverTask, WhitworthTask, demands
from plans.quantity import Shown
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.drawn import DrawnDesign, DrawnReading, SynthesisFigure, angle
from plans.synthesis.pace import paced
from plans.words.words import because

SIDES = ((1, 1.0), (2, -1.0))  # numbers of the extreme positions: the right one, the left one


def drawn_levers(task: LeverTask) -> tuple[DrawnReading, ...]:
    """Draw each reading of the task of an oscillating slotted link."""
    return tuple(_reading(demands(one, LEVER), _lever(one), one) for one in task.readings)


def drawn_whitworths(task: WhitworthTask) -> tuple[DrawnReading, ...]:
    """Draw each reading of the task of a rotating slotted link."""
    return tuple(_reading(demands(one, WHITWORTH), _whitworth(one), one) for one in task.readings)


def _lever(task: LeverTask) -> Board:
    """Draw the slot in both extreme positions, the crank square to it, and the lever's end."""
    board = Board(SYNTHESIS)
    pivot = board.given("C", 0j, because("lever_pivot"))
    axis = board.parallel("C:y", pivot, board.given("y", 1j))
    if task.frame is not None:
        board.lay_off("O", pivot, board.given("CO", complex(0, task.frame), because("frame_length")))
    for k, side in SIDES:
        slot = _slot(board, task, k, side)
        length = abs(complex(slot.point))
        unit = board.turn(f"C:u_{k}", slot, 1 / length if length else math.nan)  # none: A_1 is C
        line = board.parallel(f"C:l_{k}", pivot, unit)
        if "O" not in board:
            assert task.crank is not None  # else the frame is told
            away = board.turn("O:r", unit, 1j * task.crank, because("crank_away"))
            beside = board.parallel("O:l", board.lay_off("O:s", pivot, away), unit)
            board.meet("O", axis, beside, why=because("pivot_beside"))
        if f"A_{k}" not in board:
            square = board.square(f"O:n_{k}", board["O"], unit, because("pin_square"))
            board.meet(f"A_{k}", line, square, why=because("foot_slot"))
        if task.stroke is not None and f"B_{k}" not in board:
            board.meet(f"B_{k}", line, _half_stroke(board, task.stroke, k, side), why=because("end_stroke"))
        elif task.lever is not None and f"B_{k}" not in board:
            board.lay_off(f"B_{k}", pivot, board.turn(f"CB_{k}", unit, task.lever, because("lever_length")))
    if task.driven and task.pressure is not None:
        arm = abs(complex(between(pivot, board["B_1"])))
        steep = board.lay_off("B", pivot, board.turn("CB", board["y"], arm, because("lever_upright")))
        level = board.square("B_1:x", board["B_1"], board["y"])
        low = board.meet("F", axis, level, why=because("middle_chord"))
        half = board.turn("FG", board.join("FB", low, steep), 0.5, because("half_rise"))
        _ram(board, task.pressure, board.lay_off("G", low, half))
    return board


def _slot(board: Board, task: LeverTask, k: int, side: float) -> Mark:
    """Give the way of the slot in an extreme position: by half of the swing, by the lever's end, or by a tangent."""
    pivot = board["C"]
    if task.overlap is not None:
        half = task.overlap / 2
        why = because("lever_extreme", angle=f"{math.degrees(half):.10g}")
        return board.given(f"C:{k}", complex(side * math.sin(half), math.cos(half)), why)
    if task.stroke is not None and task.lever is not None:
        arc = board.arc(f"C:b_{k}", pivot, task.lever, because("lever_length"))
        end = board.meet(f"B_{k}", _half_stroke(board, task.stroke, k, side), arc, 1.0, because("end_stroke"))
        return board.join(f"CB_{k}", pivot, end)
    assert task.crank is not None  # the readings are such
    if "T" not in board:
        half_frame = board.turn("CT", board.join("C:O", pivot, board["O"]), 0.5)
        board.lay_off("T", pivot, half_frame, because("thales_centre"))
    radius = abs(complex(board["T"].point))
    arcs = board.arc(f"O:c_{k}", board["O"], task.crank), board.arc(f"T:c_{k}", board["T"], radius, because("thales"))
    pin = board.meet(f"A_{k}", *arcs, side, because("tangent_point"))
    return board.join(f"CA_{k}", pivot, pin)


def _half_stroke(board: Board, stroke: float, k: int, side: float) -> Mark:
    """Draw the line square to the stroke through its end."""
    away = board.given(f"H_{k}", complex(side * stroke / 2), because("half_stroke"))
    return board.parallel(f"H:{k}", board.lay_off(f"E_{k}", board["C"], away), board["y"])


def _whitworth(task: WhitworthTask) -> Board:
    """Draw the crank in both dead places of the ram, its pins on the guide through C."""
    board = Board(SYNTHESIS)
    pivot, way = board.given("O", 0j, because("crank_pivot")), board.given("x", 1 + 0j)
    axis = board.square("O:y", pivot, way)
    if task.frame is not None:
        board.lay_off("C", pivot, board.given("OC", complex(0, -task.frame), because("frame_length")))
        guide = board.parallel("C:x", board["C"], way, because("guide_through"))
    for k, side in SIDES:
        if task.overlap is None:
            assert task.crank is not None and task.frame is not None  # two of the three are kept
            arc = board.arc(f"O:c_{k}", pivot, task.crank)
            board.meet(f"A_{k}", guide, arc, side, because("pin_guide"))
            continue
        quick = (math.pi - task.overlap) / 2
        why = because("crank_extreme", angle=f"{math.degrees(quick):.10g}")
        ray = board.given(f"O:{k}", complex(side * math.sin(quick), -math.cos(quick)), why)
        if task.crank is not None:
            board.lay_off(f"A_{k}", pivot, board.turn(f"OA_{k}", ray, task.crank))
        else:
            board.meet(f"A_{k}", guide, board.parallel(f"O:l_{k}", pivot, ray), why=because("pin_guide"))
    if task.frame is None:
        chord = board.join("A_2A_1", board["A_2"], board["A_1"], because("guide_pins"))
        board.meet("C", axis, board.parallel("C:x", board["A_1"], chord), why=because("lever_guide"))
    if task.stroke is not None:
        for k, side in SIDES:
            half = board.given(f"CB_{k}", complex(side * task.stroke / 2), because("half_stroke"))
            board.lay_off(f"B_{k}", board["C"], half)
        if task.pressure is not None:
            board.lay_off("B", board["C"], board.turn("CB", board["CB_1"], 1j, because("lever_upright")))
            _ram(board, task.pressure, board["C"])
    return board


def _ram(board: Board, pressure: float, level: Mark) -> None:
    """Draw the rod from the highest place of the lever's end at the pressure angle, and the ram's extreme places."""
    why = because("rod_pressure", angle=f"{math.degrees(pressure):.10g}")
    line = board.parallel("B:l", board["B"], board.given("B:u", cmath.rect(1.0, -pressure), why))
    guide = board.parallel("D:x", level, board.given("D:u", 1 + 0j), because("guide_ram"))
    end = board.meet("D", line, guide, why=because("end_rod"))
    rod = abs(complex(between(board["B"], end)))
    for k, _ in SIDES:
        board.meet(f"D_{k}", guide, board.arc(f"B_{k}:r", board[f"B_{k}"], rod), 1.0, because("extreme_place"))


def _reading(kept: tuple[str, ...], board: Board, task: LeverTask | WhitworthTask) -> DrawnReading:
    """Read the mechanism off its board, if its lines have met as those of a mechanism do."""
    found = (_read(board, task),) if task.overlap != 0 and _admits(board, task) else ()
    return paced(DrawnReading(kept, board, found), task.pace)


def _admits(board: Board, task: LeverTask | WhitworthTask) -> bool:
    """Tell whether the pins are beside the axis and beyond C, and the rod not yet in line with the lever."""
    pin, pivot = complex(board["A_1"].point), complex(board["C"].point)
    if isinstance(task, WhitworthTask):
        return pin.real > 0 and pivot.imag < 0
    whole = "D_1" not in board or bool(cross(_way(board, "B_1", "D_1"), _way(board, "C", "B_1")) > 0)
    return pin.real > 0 and pin.imag > 0 and whole


def _way(board: Board, start: str, end: str) -> complex:
    return complex(between(board[start], board[end]))


def _read(board: Board, task: LeverTask | WhitworthTask) -> DrawnDesign:
    ends = "D" if "D" in board else "B"
    spans = {
        "l_1": ("O", "A_1"),
        "l_0": ("C", "O"),
        "l_3": ("C", "B_1"),
        "l_4": ("B", "D"),
        "H": (f"{ends}_2", f"{ends}_1"),
    }
    shown: dict[str, Shown] = {
        letter: Span(board[start], board[end]) for letter, (start, end) in spans.items() if end in board
    }
    sizes = {letter: abs(_way(board, *spans[letter])) for letter in shown}
    arms = {"θ": sizes["l_1"], "ψ": abs(_way(board, "C", "A_1")), "α_max": sizes.get("l_4", 0.0)}
    apart = cmath.phase(_way(board, "O", "A_1") / _way(board, "O", "A_2")) % math.tau  # over the quick arc, below O
    overlap = math.pi - apart
    sizes["θ"] = overlap
    shown["θ"] = angle(
        board, "θ", board.join("OA_1:r", board["O"], board["A_1"]), board.join("OA_2:r", board["O"], board["A_2"])
    )
    if isinstance(task, LeverTask):
        sizes["ψ"] = cmath.phase(_way(board, "C", "A_2") / _way(board, "C", "A_1"))
        shown["ψ"] = angle(
            board, "ψ", board.join("CA_1:r", board["C"], board["A_1"]), board.join("CA_2:r", board["C"], board["A_2"])
        )
    sizes["K"] = (math.pi + overlap) / (math.pi - overlap)
    if "D" in board:
        sizes["α_max"] = -cmath.phase(_way(board, "B", "D"))
        shown["α_max"] = angle(board, "α_max", board.join("BD:r", board["B"], board["D"]), board["D:u"])
    places = {name: complex(board[name].point) for name in PLACES if name in board}
    circles = {"O": LocusCircle(places["O"], sizes["l_1"])}
    if "T" in places:
        circles["T"] = LocusCircle(places["T"], abs(places["T"]))
    return DrawnDesign(Design(sizes, places, circles), shown, arms, _figure(places, isinstance(task, LeverTask)))


PLACES = ("O", "C", "A_1", "A_2", "B_1", "B_2", "B", "D", "D_1", "D_2", "T")


def _figure(places: Mapping[str, complex], swings: bool) -> SynthesisFigure:
    """Show the right extreme position in full, the left one by dashes, the rod where it leans most by thin lines."""
    first, second = (tuple(f"{name}_{k}" for name in "BD" if f"{name}_{k}" in places) for k, _ in SIDES)
    slot = (places["A_1"] - places["C"]) / abs(places["A_1"] - places["C"])
    ram, end = "D" in places, "B_1" if first else "A_1"
    # Of what lies on one line the longer is drawn, or dashes would fill each other's gaps.
    beyond = bool(first) and abs(places["B_1"] - places["C"]) > abs(places["A_1"] - places["C"])
    others = (("O", "A_2"), ("C", *second)) if beyond else (("O", "A_2", "C"), second)
    lengths = (("l_1", "O", "A_1"), ("l_0", "C", "O"), ("l_3", "C", "B_1"), ("l_4", "B", "D"), ("H", "B_2", "B_1"))
    return SynthesisFigure(
        first=("O", "A_1", "C", *first),
        others=tuple(chain for chain in others if len(chain) > 1),
        lines=(("B", "D"),) if ram else (),
        axes=(("C", "B" if ram else "O"), ("D_2", "D_1") if ram else ("A_2" if not first else "B_2", end)),
        hinges=frozenset(places) - {"T"},
        fixed=frozenset("OC"),
        blocks={"A_1": slot, **({"D_1": 1 + 0j} if ram else {})},
        lengths=tuple(one for one in lengths if one[2] in places and (swings or one[0] != "l_3")),
        angles=((("ψ", "C", "A_1", "A_2"),) if swings else ())
        + ((("α_max", "D", "B", "D_2" if swings else "C"),) if ram else ()),
    )
