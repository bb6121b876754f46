"""What is drawn of a construction of synthesis, read from its record, true places in metres (что показано)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from drawings.synthesis.due import NAME, POINTS
from geometry.board import Arc, Board, Mark
from plans.model.motion import Complexes
from plans.model.synthesis import CENTRES, CrankRocker, RockerTask, SliderCrank, end_of_arc, start_of_arc
from plans.synthesis.chord import Drawn
from plans.synthesis.quantities import letter_of
from plans.synthesis.rocker import DrawnRocker
from plans.synthesis.slider import DrawnSlider
from plans.synthesis.study import SynthesisStudy


class ShownSynthesis(NamedTuple):
    """A construction with one mechanism of it, in both extreme positions: the first is drawn in full."""

    name: str
    letter: str  # of the reading of the task, where there are several
    points: Mapping[str, complex]
    drafted: tuple[tuple[complex, complex], ...]  # lines of the construction
    axes: tuple[tuple[complex, complex], ...]
    circles: Mapping[str, Complexes]
    barred: tuple[Complexes, ...]  # arcs on which no O is admitted
    first: tuple[complex, ...]  # the mechanism, from O, with crank and coupler stretched
    second: tuple[complex, ...]  # with the crank folded back
    sliding: bool

    @property
    def known(self) -> list[complex]:
        """All places that the figure must hold."""
        ends = (end for line in (*self.drafted, *self.axes) for end in line)
        curves = (complex(spot) for curve in self.circles.values() for spot in curve[::6])
        return [*self.points.values(), *ends, *curves, *self.first, *self.second]


def shown(study: SynthesisStudy) -> tuple[ShownSynthesis, ...]:
    """Show each construction that gives a mechanism; of several mechanisms the one that is preferred."""
    found = [one for one in study.drawn if one.found]
    names = [NAME if not k else f"{NAME}-{k + 1}" for k in range(len(found))]
    letters = [letter_of(study.drawn.index(one)) if len(found) > 1 else "" for one in found]
    return tuple(_shown(name, one)._replace(letter=at) for name, one, at in zip(names, found, letters, strict=True))


def _shown(name: str, drawn: DrawnRocker | DrawnSlider) -> ShownSynthesis:
    if isinstance(drawn, DrawnRocker):
        marks, made = max(drawn.found, key=lambda pair: pair[1].transmission)
        return _rocker(name, drawn, marks, made)
    marks, slider = drawn.found[0]
    return _similar(name, drawn, slider) if drawn.task.pressure is not None else _slider(name, drawn, marks, slider)


def _point(board: Board, name: str) -> complex:
    return complex(board[name].point)


def _circle(mark: Mark, start: float = 0.0, sweep: float = math.tau) -> Complexes:
    assert isinstance(mark.value, Arc)  # a locus that is a circle
    ways = np.exp(1j * np.linspace(start, start + sweep, POINTS))
    return np.asarray(complex(np.asarray(mark.value.centre)) + float(np.asarray(mark.value.radius)) * ways)


def _ends(pivot: complex, made: CrankRocker | SliderCrank, first: complex, second: complex) -> tuple[complex, complex]:
    """Give A1 and A2: the crank beyond O where it is folded back."""
    return tuple(
        pivot + sense * made.crank * (end - pivot) / abs(end - pivot) for sense, end in ((1, first), (-1, second))
    )  # type: ignore[return-value]


def _rocker(name: str, drawn: DrawnRocker, marks: Drawn, made: CrankRocker) -> ShownSynthesis:
    board, task, letter = drawn.board, drawn.task, CENTRES[drawn.side]
    b1, b2, pivot = _point(board, "B_1"), _point(board, "B_2"), complex(marks.pivot.point)
    a1, a2 = _ends(pivot, made, b1, b2)
    points = {"O": pivot, "C": 0j, "B_1": b1, "B_2": b2, "A_1": a1, "A_2": a2}
    drafted, circles, barred = [(b1, b2), (pivot, b2)], dict[str, Complexes](), tuple[Complexes, ...]()
    if task.overlap:
        points[letter] = _point(board, letter)
        drafted += [(b1, points[letter]), (b2, points[letter])]
        start = start_of_arc(task, drawn.side)
        circles["seen"] = _circle(drawn.locus, start, drawn.side * (math.tau - 2 * task.overlap))
        barred = _barred(task, drawn, start)
        drafted += [(end, complex(barred[0][k])) for k, end in ((0, b1), (-1, b2))] if drawn.side > 0 else []
    return ShownSynthesis(
        name,
        "",
        points,
        tuple(drafted),
        ((0j, pivot),),
        circles,
        barred,
        (pivot, a1, b1, 0j),
        (pivot, a2, b2, 0j),
        False,
    )


def _barred(task: RockerTask, drawn: DrawnRocker, start: float) -> tuple[Complexes, ...]:
    """Give the arc between the lines CB1 and CB2 produced."""
    end = end_of_arc(task, drawn.side)
    assert end is not None  # a mechanism is on the arc
    way = (end - start + math.pi) % math.tau - math.pi if drawn.side < 0 else end - start
    sweep = math.tau - 2 * task.overlap if drawn.side > 0 else -(math.tau - 2 * task.overlap)
    return (_circle(drawn.locus, start + way, sweep - 2 * way),)


def _slider(name: str, drawn: DrawnSlider, marks: Drawn, made: SliderCrank) -> ShownSynthesis:
    board, pivot = drawn.board, complex(marks.pivot.point)
    b1, b2 = _point(board, "B_1"), _point(board, "B_2")
    a1, a2 = _ends(pivot, made, b1, b2)
    points = {"E": 0j, "O": pivot, "B_1": b1, "B_2": b2, "A_1": a1, "A_2": a2}
    points |= {each: _point(board, each) for each in ("M", "N", "D_1", "D_2") if each in board}
    drafted, circles, barred = [(pivot, b2)], dict[str, Complexes](), tuple[Complexes, ...]()
    if "M" in points:
        drafted += [(b1, points["M"]), (b2, points["M"])]
        theta = drawn.task.overlap
        assert theta is not None  # there is a circle that sees the chord
        circles["seen"] = _circle(board["M:o"], math.pi / 2 + theta, math.tau - 2 * theta)
        barred = (_circle(board["M:o"], -math.pi / 2 - theta, 2 * theta),)
    if "N" in points:
        circles["ratio"] = _circle(board["N:o"])
    if "e:l" in board and made.offset:
        drafted.append((pivot, complex(b1.real, pivot.imag)))
    axis = (complex(min(pivot.real, b2.real), 0.0), b1)
    return ShownSynthesis(
        name, "", points, tuple(drafted), (axis,), circles, barred, (pivot, a1, b1), (pivot, a2, b2), True
    )


def _similar(name: str, drawn: DrawnSlider, made: SliderCrank) -> ShownSynthesis:
    """Show the similar mechanism as large as its stroke asks: its crank is 1."""
    b1, b2 = (made.crank * _point(drawn.board, f"{each}:1") for each in ("B_1", "B_2"))
    a1, a2 = _ends(0j, made, b1, b2)
    steep = complex(0, -made.crank)  # the crank square to the guide, where the rod leans most
    there = steep + cmath.rect(made.rod, made.pressures[1])
    points = {"O": 0j, "B_1": b1, "B_2": b2, "A_1": a1, "A_2": a2, "A": steep, "B": there}
    lines = ((0j, b2), (0j, steep), (steep, there))
    return ShownSynthesis(
        name, "", points, lines, ((complex(0, b1.imag), b1),), {}, (), (0j, a1, b1), (0j, a2, b2), True
    )
