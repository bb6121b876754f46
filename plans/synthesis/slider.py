"""A slider-crank from its stroke: each demand is a locus of O beside the chord, and O where two loci meet (M1.6)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from geometry.board import Board, Mark, between
from plans.model.synthesis import SliderCrank, SliderTask
from plans.synthesis.chord import SYNTHESIS, Chord, Drawn, read
from plans.words.words import because


class DrawnSlider(NamedTuple):
    """One reading of a task drawn: the chord, the loci, and the mechanisms that they meet in."""

    task: SliderTask
    board: Board
    loci: tuple[Mark, ...]
    found: tuple[tuple[Drawn, SliderCrank], ...]


def drawn_slider(task: SliderTask) -> DrawnSlider:
    """Draw one reading of a task."""
    board = Board(SYNTHESIS)
    if task.pressure is not None:
        return _similar(board, task)
    folded = board.given("B_2", complex(-task.stroke / 2, 0.0), because("guide_end"))
    along = board.given("H", complex(task.stroke, 0.0), because("stroke_given"))
    chord = Chord.between(board, board.lay_off("B_1", folded, along), folded)
    loci = tuple(_loci(chord, task))
    first, second = loci
    drawn = [read(chord, pivot) for pivot in _met(board, first, second) if _admits(chord, pivot)]
    made = sorted(((_slider(chord, one), one) for one in drawn), key=lambda pair: -pair[0].crank)
    return DrawnSlider(task, board, loci, tuple((one, found) for found, one in made))


def _loci(chord: Chord, task: SliderTask) -> Iterator[Mark]:
    """Give the loci of O; no offset and no overlap are one demand: O on the line of the chord."""
    if task.overlap:
        yield chord.seen(task.overlap, 1)
    if task.ratio is not None:
        yield chord.proportioned(task.ratio)
    if task.offset or not task.overlap:
        yield chord.offset(task.offset or 0.0)


def _met(board: Board, first: Mark, second: Mark) -> Iterator[Mark]:
    for name, side in (("O", -1.0), ("O'", 1.0)):
        yield board.meet(name, first, second, side, because("pivot_loci"))


def _admits(chord: Chord, pivot: Mark) -> bool:
    """Tell whether O is before the chord, not above it: over it B1 and B2 are of two assemblies."""
    from_folded = complex(between(pivot, chord.folded))
    return from_folded.real > 0 and from_folded.imag >= 0  # no meeting is not a number, and no more than anything


def _slider(chord: Chord, drawn: Drawn) -> SliderCrank:
    crank, rod = (float(length) for length in drawn.lengths)
    return SliderCrank(crank, rod, float(complex(between(drawn.pivot, chord.middle)).imag))


def _similar(board: Board, task: SliderTask) -> DrawnSlider:
    """Draw a mechanism of the crank 1 that has ratio and pressure angle, and measure how much larger the stroke is."""
    assert task.pressure is not None  # asked before
    sine = math.sin(task.pressure)
    ratio = 1 / sine if task.ratio is None else task.ratio
    crank = board.given("l_1:1", 1 + 0j, because("unit_crank"))
    pivot = board.given("O:1", 0j)
    rod = board.turn("l_2:1", crank, ratio, because("times_ratio", ratio=f"{ratio:.10g}"))
    height = 0.0 if task.ratio is None else ratio * sine - 1
    away = board.turn("e:1", crank, 1j * height, because("offset_pressure"))
    guide = board.parallel("e:l", board.lay_off("E:1", pivot, away), crank, because("offset_line"))
    places = [_end(board, pivot, guide, crank, rod, sense) for sense in (1, -1)]
    stroke = board.join("H:1", places[1], places[0], because("unit_stroke"))
    scale = task.stroke / abs(complex(stroke.point))
    why = because("times_stroke", times=f"{scale:.10g}")
    crank, rod, away = (board.turn(one.name.removesuffix(":1"), one, scale, why) for one in (crank, rod, away))
    made = SliderCrank(*(abs(complex(one.point)) for one in (crank, rod, away)))
    found = ((Drawn(pivot, crank, rod), made),) if height >= 0 else ()
    return DrawnSlider(task, board, (guide,), found)


def _end(board: Board, pivot: Mark, guide: Mark, crank: Mark, rod: Mark, sense: int) -> Mark:
    reach = abs(complex(rod.point)) + sense * abs(complex(crank.point))
    arc = board.arc(f"O:{sense}", pivot, reach, because("extreme_reach"))
    return board.meet("B_1:1" if sense > 0 else "B_2:1", guide, arc, 1.0, because("extreme_place"))
