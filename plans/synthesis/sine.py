"""Sine and tangent mechanisms from their strokes: half a stroke is a crank, or is seen under the pressure angle."""

from __future__ import annotations

import cmath
import math

from geometry.board import Board, Span, between
from plans.model.synthesis.design import Design, LocusCircle
from plans.model.synthesis.slots import TANGENT, SineTask, TangentTask, demands
from plans.quantity import Shown
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.drawn import DrawnDesign, DrawnReading, SynthesisFigure, angle
from plans.synthesis.pace import paced
from plans.words.words import because

SHOWN_AT = math.pi / 3  # the crank of a sine mechanism in full lines


def drawn_sines(task: SineTask) -> tuple[DrawnReading, ...]:
    """Draw a sine mechanism: the stroke halved is the crank, whose pin is on the guide at both ends (синусный)."""
    board = Board(SYNTHESIS)
    far = board.given("A_2", complex(-task.stroke / 2), because("guide_end"))
    stroke = board.given("H", complex(task.stroke), because("stroke_given"))
    near, half = board.lay_off("A_1", far, stroke), board.turn("A_2O", stroke, 0.5, because("half_crank"))
    pivot = board.lay_off("O", far, half)
    crank = board.join("OA_1", pivot, near)
    pin = board.lay_off("A", pivot, board.turn("OA", crank, cmath.rect(1.0, SHOWN_AT)))
    guide, slot = board.parallel("O:x", pivot, stroke), board.square("A:y", pin, stroke, because("yoke_square"))
    board.meet("B", guide, slot)
    places = {name: complex(board[name].point) for name in ("O", "A_1", "A_2", "A", "B")}
    length = abs(complex(crank.point))
    sizes = {"l_1": length, "H": abs(complex(between(far, near)))}
    figure = SynthesisFigure(
        first=("O", "A", "B"),
        others=(("O", "A_1"), ("O", "A_2")),
        axes=(("A_2", "A_1"),),
        hinges=frozenset(("O", "A", "A_1", "A_2")),
        fixed=frozenset("O"),
        blocks={"A": 1j, "B": 1 + 0j},
        lengths=(("l_1", "O", "A"), ("H", "A_2", "A_1")),
    )
    design = Design(sizes, places, {"O": LocusCircle(places["O"], length)})
    made = DrawnDesign(design, {"l_1": crank, "H": Span(far, near)}, {}, figure)
    return (paced(DrawnReading(("stroke",), board, (made,)), task.pace),)


def drawn_tangents(task: TangentTask) -> tuple[DrawnReading, ...]:
    """Draw each reading of the task of a tangent mechanism (тангенсный)."""
    return tuple(_tangent(one) for one in task.readings)


def _tangent(task: TangentTask) -> DrawnReading:
    """Draw the guide, the slot of the lever at its end, and O where the slot meets the perpendicular of the guide."""
    board = Board(SYNTHESIS)
    foot, up = board.given("E", 0j, because("foot_guide")), board.given("y", 1j)
    axis, guide = board.square("E:x", foot, up), board.parallel("E:y", foot, up)
    if task.stroke is not None:
        board.lay_off("A_1", foot, board.given("EA_1", 1j * task.stroke * task.share, because("half_stroke")))
    if task.distance is not None:
        board.lay_off("O", foot, board.given("EO", complex(-task.distance), because("guide_distance")))
    if task.pressure is not None:
        why = because("slot_pressure", angle=f"{math.degrees(task.pressure):.10g}")
        slot, along = board.given("O:u", cmath.rect(1.0, task.pressure), why), "A_1" if "A_1" in board else "O"
        line = board.parallel(f"{along}:l", board[along], slot)
        board.meet(*(("O", axis) if along == "A_1" else ("A_1", guide)), line, why=because("slot_meets"))
    lever = board.join("OA_1", board["O"], board["A_1"], because("lever_end"))
    if not task.one_sided:
        board.lay_off("A_2", foot, board.turn("EA_2", board.join("E:A_1", foot, board["A_1"]), -1.0))
    low = "E" if task.one_sided else "A_2"
    places = {name: complex(board[name].point) for name in ("E", "O", "A_1", "A_2") if name in board}
    spans = {"h": Span(board["O"], foot), "H": Span(board[low], board["A_1"])}
    sizes = {name: abs(complex(between(*one))) for name, one in spans.items()}
    sizes["α_max"] = cmath.phase(complex(lever.point))
    figure = SynthesisFigure(
        first=("O", "A_1"),
        others=(("O", low),),
        axes=(("O", "E"), (low, "A_1")),
        hinges=frozenset(("O", "A_1", low)),
        fixed=frozenset("O"),
        blocks={"A_1": cmath.rect(1.0, sizes["α_max"])},
        lengths=(("h", "O", "E"), ("H", low, "A_1")),
        angles=(("α_max", "O", "E", "A_1"),),
    )
    shown: dict[str, Shown] = {**spans, "α_max": angle(board, "α_max", lever, board.join("OE", board["O"], foot))}
    arms = {"α_max": abs(complex(lever.point))}
    return DrawnReading(demands(task, TANGENT), board, (DrawnDesign(Design(sizes, places), shown, arms, figure),))
