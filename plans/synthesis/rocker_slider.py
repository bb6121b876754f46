"""A rocker-slider from a similar figure: the stroke tells how much larger it is (theme 6; подобие)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

from geometry.board import Board, Mark, between
from geometry.meet import cross
from plans.model.synthesis.design import EPS, Design
from plans.model.synthesis.positions import TOUCH
from plans.model.synthesis.swings import STILL, RockerSliderTask
from plans.synthesis.chord import SYNTHESIS
from plans.synthesis.drawn import DrawnDesign, DrawnReading, SynthesisFigure
from plans.words.words import because

WEAR = 32.0  # roundings


def drawn(task: RockerSliderTask) -> tuple[DrawnReading, ...]:
    """Draw each reading of a task; axial ones on a board for each side of the rod."""
    if task.angles is None:
        return (_about_as_large(partial(_symmetric, task), task),)
    sides = [(one, sense) for one in task.readings for sense in (1.0, -1.0)]
    return tuple(_about_as_large(partial(_axial, one, sense), one) for one, sense in sides)


def _about_as_large(figure: Callable[[float], DrawnReading], task: RockerSliderTask) -> DrawnReading:
    """Draw by a similar figure as large as the stroke, then by one about as large as was found."""
    trial = figure(task.stroke)
    return figure(float(f"{trial.found[0].design.sizes['l_1']:.0e}")) if trial.found else trial


class _Larger(NamedTuple):
    """The wanted figure and the similar one, by a vector of both: the stroke, or half of it."""

    board: Board
    wanted: Mark
    unit: Mark

    def of(self, name: str, start: Mark, end: Mark) -> Mark:
        """Give the wanted vector of two points of the similar figure."""
        shape = self.board.join(f"{name}:1", start, end)
        return self.board.similar(name, self.wanted, self.unit, shape, why=because("as_stroke"))


def _symmetric(task: RockerSliderTask, rocker: float) -> DrawnReading:
    """Draw the rod leaning to both sides: by so much is the chord of the rocker's end below its top."""
    assert task.ratio is not None and task.pressure is not None  # asked before
    board, why = Board(SYNTHESIS), because("rod_leans", angle=f"{math.degrees(task.pressure):.10g}")
    up, down = (board.given(f"l_2:{k}", cmath.rect(rocker / task.ratio, k * task.pressure), why) for k in (1, -1))
    pivot = board.given("C:1", 0j, because("rocker_pivot"))
    top = board.lay_off("A:1", pivot, board.given("l_1:1", 1j * rocker, because("rocker_square")))
    end = board.lay_off("B:1", top, down)
    low = board.lay_off("E:1", end, board.turn("B_1A_1:1", up, -1.0, because("rod_back")))
    level = board.parallel("E:l", low, board.given("guide", 1 + 0j), because("chord_level"))
    first = board.meet("A_1:1", board.arc("C:o", pivot, rocker, because("rocker_circle")), level, 1.0)
    half = board.given("EA_1", complex(task.stroke / 2), because("half_stroke"))
    larger = _Larger(board, half, board.join("EA_1:1", low, first))
    across = cross(up.point, between(pivot, first)) * task.ratio
    admitted = across > STILL * rocker**2  # else the slider turns back before the rocker does
    slid = board.lay_off("B_1:1", first, up)
    found = (_leaning(larger, pivot, {"A": (top, end), "A_1": (first, slid)}),) if admitted else ()
    return DrawnReading(task.kept, board, found)


def _leaning(larger: _Larger, pivot: Mark, similar: dict[str, tuple[Mark, Mark]]) -> DrawnDesign:
    """Draw the wanted rocker-slider from the middle of the chord on, and read it."""
    board, half = larger.board, larger.wanted
    middle = board.given("E", 0j, because("middle_chord"))
    ends = [board.lay_off(f"A_{k}", middle, board.turn(f"EA_{k}", half, way)) for k, way in ((1, 1.0), (2, -1.0))]
    rocker = larger.of("l_1", pivot, similar["A_1"][0])
    centre = board.lay_off("C", ends[0], board.turn("A_1C", rocker, -1.0))
    rods = {name: larger.of(f"{name}:l_2", *pair) for name, pair in similar.items()}
    top = board.lay_off("A", centre, larger.of("CA", pivot, similar["A"][0]))
    slid = [board.lay_off(f"B_{k}", end, rods["A_1"]) for k, end in enumerate(ends, 1)]
    last = board.lay_off("B", top, rods["A"])
    guide = board.parallel("B:l", slid[0], half, because("guide_level"))
    foot = board.meet("G", guide, board.square("C:n", centre, half))
    offset = board.join("e", centre, foot, because("guide_off"))
    lean = max(abs(cmath.phase(complex(rod.point))) for rod in rods.values())
    marks = (centre, top, last, ends[0], slid[0], ends[1], slid[1], middle, foot)
    places = {one.name: complex(one.point) for one in marks}
    sizes = {**_lengths(l_1=rocker, l_2=rods["A_1"], e=offset), "ψ": _angle(centre, *ends), "α_max": lean}
    sizes["H"] = abs(complex(between(slid[1], slid[0])))
    shown = {"l_1": rocker, "l_2": rods["A_1"], "e": offset}
    figure = SynthesisFigure(
        ("C", "A_1", "B_1"),
        (("C", "A", "B"), ("C", "A_2", "B_2")),
        (("A_1", "A_2"),),
        (("B_1", "B_2"), ("C", "A")),
        frozenset(places) - {"E", "G"},
        frozenset("C"),
        {"B_1": 1 + 0j, "B_2": 1 + 0j, "B": 1 + 0j},
        lengths=(("H", "B_2", "B_1"), ("e", "C", "G"), ("l_1", "C", "A_1"), ("l_2", "A_1", "B_1")),
        angles=(("ψ", "C", "A_1", "A_2"),),
    )
    return DrawnDesign(Design(sizes, places), shown, {"ψ": sizes["l_1"], "α_max": sizes["l_2"]}, figure)


def _lengths(**vectors: Mark) -> dict[str, float]:
    return {name: abs(complex(vector.point)) for name, vector in vectors.items()}


def _angle(pivot: Mark, first: Mark, second: Mark) -> float:
    """Measure the angle at a pivot between two points, rad."""
    return abs(cmath.phase(complex(between(pivot, first)) / complex(between(pivot, second))))


def _axial(task: RockerSliderTask, sense: float, rocker: float) -> DrawnReading:
    """Draw a rocker in both its ends, the rod to one side, and measure the slider's way."""
    board = Board(SYNTHESIS)
    return DrawnReading(task.kept, board, tuple(_laid(board, task, sense, rocker)))


def _laid(board: Board, task: RockerSliderTask, sense: float, rocker: float) -> Iterator[DrawnDesign]:
    assert task.angles is not None  # it is axial
    pivot = board.given("C", 0j, because("rocker_pivot"))
    guide = board.parallel("C:l", pivot, board.given("guide", 1 + 0j, because("guide_through")))
    circle = board.arc("C:o", pivot, rocker, because("rocker_unit", length=f"{1000 * rocker:.10g}"))
    top = _rocker(board, circle, "A:1", task.steepest)
    rod = _rod(board, guide, top, task, rocker)
    ends = [_rocker(board, circle, f"A_{k}:1", angle) for k, angle in enumerate(task.angles, 1)]
    slid = [
        board.meet(f"B{end.name[1:]}", guide, board.arc(f"{end.name}:o", end, rod, because("rod_length")), sense)
        for end in (*ends, top)
    ]
    way = complex(between(slid[1], slid[0]))
    sharp = slid[2].sharpness
    if sharp is None or not sharp > TOUCH or not abs(way) >= STILL * rocker:  # too short, or as long as the rocker
        return
    stroke = board.given("H", complex(math.copysign(task.stroke, way.real)), because("stroke_given"))
    larger = _Larger(board, stroke, board.join("H:1", slid[1], slid[0], because("unit_way")))
    rockers = [larger.of(f"CA_{k}", pivot, end) for k, end in enumerate(ends, 1)]
    rods = [larger.of(f"A_{k}B_{k}", *pair) for k, pair in enumerate(zip(ends, slid[:2], strict=True), 1)]
    at = [board.lay_off(f"A_{k}", pivot, one) for k, one in enumerate(rockers, 1)]
    to = [board.lay_off(f"B_{k}", end, one) for k, (end, one) in enumerate(zip(at, rods, strict=True), 1)]
    places = {one.name: complex(one.point) for one in (pivot, at[0], to[0], at[1], to[1])}
    lean = abs(cmath.phase(sense * complex(between(top, slid[2]))))
    sizes = {**_lengths(l_1=rockers[0], l_2=rods[0]), "ψ": _angle(pivot, *at), "α_max": lean}
    sizes["H"] = abs(complex(between(*to)))
    blocks = {"B_1": 1 + 0j, "B_2": 1 + 0j}
    hinges, chains = frozenset(places), (("C", "A_1", "B_1"), ("C", "A_2", "B_2"))
    figure = SynthesisFigure(chains[0], chains[1:], (), (("C", "B_1"), ("C", "B_2")), hinges, frozenset("C"), blocks)
    lengths = ("H", "B_1", "B_2"), ("l_1", "C", "A_1"), ("l_2", "A_1", "B_1")
    figure = figure._replace(lengths=lengths, angles=(("ψ", "C", "A_1", "A_2"),))
    arms = {"ψ": sizes["l_1"], "α_max": sizes["l_2"] * math.cos(lean)}
    lost = WEAR * EPS * (rocker + rod) / (abs(way) * math.cos(lean))  # the way is a difference of these lengths
    within = {name: lost * sizes[name] for name in ("l_1", "l_2")}
    yield DrawnDesign(Design(sizes, places), {"l_1": rockers[0], "l_2": rods[0]}, arms, figure, within)


def _rocker(board: Board, circle: Mark, name: str, angle: float) -> Mark:
    ray = board.given(f"{name}:r", cmath.rect(1.0, angle), because("rocker_at", angle=f"{math.degrees(angle):.10g}"))
    return board.divide(name, circle, ray)


def _rod(board: Board, guide: Mark, top: Mark, task: RockerSliderTask, rocker: float) -> float:
    """Give the length of the rod: by the ratio, or as it leans where the rocker is farthest off."""
    if task.pressure is None:
        assert task.ratio is not None  # asked before
        return rocker / task.ratio
    why = because("rod_leans", angle=f"{math.degrees(task.pressure):.10g}")
    ray = board.parallel("A:b", top, board.given("l_2:r", cmath.rect(1.0, -task.pressure), why))
    return abs(complex(between(top, board.meet("B:p", guide, ray, why=because("rod_to_guide")))))
