"""A crank-rocker from rocker, swing and overlap: the circle that sees the chord, and O on its arc (M1.5)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from geometry.board import Board, Mark, between
from geometry.meet import Sizes, Vectors
from plans.model.motion import Floats
from plans.model.synthesis import CENTRES, TOWARDS, CrankRocker, RockerTask
from plans.synthesis.chord import SYNTHESIS, Chord, Drawn, cross, read
from plans.words.words import because

STATIONS = 361  # of O on an arc, where the best is looked for; then closer about the best of them
CLOSER = 5  # times
PLACED = 7  # decimals of a radian: the place of a largest value is known to the square root of a rounding


class DrawnRocker(NamedTuple):
    """A task drawn: the rocker's pivot, the chord, the circle of one side, and the mechanisms found on it."""

    task: RockerTask
    side: int
    board: Board
    rocker: Mark  # C
    chord: Chord
    locus: Mark
    found: tuple[tuple[Drawn, CrankRocker], ...]


def drawn_rocker(task: RockerTask, side: int) -> DrawnRocker:
    """Draw a task on the circle of one side."""
    board, pivot, chord = _chord(task)
    locus = chord.seen(task.overlap, side, CENTRES[side]) if task.overlap else chord.offset(0.0)
    pivots = (one for one in _pivots(board, task, pivot, locus) if _admits(task, side, pivot, chord, one).all())
    found = tuple((one, _made(task, pivot, one)) for one in (read(chord, each) for each in pivots))
    return DrawnRocker(task, side, board, pivot, chord, locus, found)


def _chord(task: RockerTask) -> tuple[Board, Mark, Chord]:
    """Draw the rocker in both extreme places; O being on the left, B1, farther from it, is on the right."""
    board = Board(SYNTHESIS)
    pivot = board.given("C", 0j, because("rocker_pivot"))
    why = because("rocker_extreme", angle=f"{math.degrees(task.swing):.10g}")
    ends = [complex(sense * task.half, task.height) for sense in (1, -1)]
    far, near = (board.given(f"C{name}", end, why) for name, end in zip(("B_1", "B_2"), ends, strict=True))
    return board, pivot, Chord.between(board, board.lay_off("B_1", pivot, far), board.lay_off("B_2", pivot, near))


def _pivots(board: Board, task: RockerTask, pivot: Mark, locus: Mark) -> Iterator[Mark]:
    """Put O where its frame or its angle has it."""
    if task.frame is None:
        assert task.place is not None  # the best is looked for before
        ray = board.given("O:r", complex(math.cos(task.place), math.sin(task.place)), because("chosen_place"))
        yield board.divide("O", locus, ray, because("pivot_place"))
        return
    arc = board.arc("C:o", pivot, task.frame, because("frame_length"))
    for name, side in (("O", 1.0), ("O'", -1.0)):
        met = board.meet(name, locus, arc, side, because("pivot_loci"))
        if complex(met.point).real < 0:  # the others are mirror images
            yield met


def _admits(task: RockerTask, side: int, pivot: Mark, chord: Chord, at: Mark) -> NDArray[np.bool_]:
    """Tell where O is on the arc that sees theta, and sees B1 and B2 on one side of the line OC."""
    frame, folded = between(at, pivot), np.asarray(between(at, chord.folded))
    ends = [np.sign(cross(frame, between(at, end))) for end in (chord.stretched, chord.folded)]
    beside = np.asarray(ends[0] * ends[1] > 0)
    return beside & np.asarray(side * folded.imag > 0 if task.overlap else folded.real > 0)


def _made(task: RockerTask, pivot: Mark, drawn: Drawn) -> CrankRocker:
    crank, coupler = (float(length) for length in drawn.lengths)
    frame = between(drawn.pivot, pivot)
    least = float(_transmission(pivot.name, drawn, frame, task.rocker))
    return CrankRocker(crank, coupler, task.rocker, abs(complex(frame)), complex(drawn.pivot.point), least)


def _transmission(name: str, drawn: Drawn, frame: Vectors, rocker: float) -> Sizes:
    """Draw the coupler with the crank on the line of the frame, towards C and away, and measure its angle at B."""
    board = Board("transmission")
    length, (crank, coupler) = np.abs(frame), drawn.lengths
    pivot, hinge = board.given("O", 0j), board.given(name, length + 0j)
    angles = []
    for sense in (1, -1):
        pin = board.lay_off(f"A_{sense}", pivot, board.given(f"OA_{sense}", sense * crank + 0j))
        arcs = board.arc(f"A_{sense}B", pin, coupler), board.arc(f"CB_{sense}", hinge, rocker)
        end = board.meet(f"B_{sense}", *arcs, side=1.0)
        angles.append(abs(np.angle(between(pin, end) / between(hinge, end))))
    return np.asarray(np.minimum(angles[0], math.pi - angles[1]))


def best_place(task: RockerTask) -> tuple[int, float] | None:
    """Look on the arcs for O with the largest of all least transmission angles: its side, and its angle at M.

    The arc is divided, then divided again about its best place, and so on; right of the axis all is mirrored.
    """
    best = max(((*_best_on(task, side), side) for side in task.sides), default=(-math.inf, 0.0, 0))
    return (best[2], round(best[1], PLACED)) if best[0] > 0 else None


def _best_on(task: RockerTask, side: int) -> tuple[float, float]:
    least, most = math.pi / 2, 3 * math.pi / 2
    found, place = -math.inf, math.pi
    for _ in range(CLOSER):
        places = np.linspace(least, most, STATIONS)
        values = stations(task, side, places)
        k = int(np.argmax(values))
        found, place = float(values[k]), float(places[k])
        least, most = places[max(k - 2, 0)], places[min(k + 2, STATIONS - 1)]
    return found, place


def stations(task: RockerTask, side: int, places: Floats) -> Floats:
    """Give the least transmission angle rad with O at each of some places; less than 0 where none is admitted."""
    board, pivot, chord = _chord(task)
    locus = chord.seen(task.overlap, side, CENTRES[side])
    at = board.divide("O", locus, board.given("O:r", np.exp(1j * places)))
    with np.errstate(invalid="ignore", divide="ignore"):
        admitted = _admits(task, side, pivot, chord, at)
        least = _transmission(pivot.name, read(chord, at), between(at, pivot), task.rocker)
    return np.where(admitted & np.isfinite(least), least, -1.0)


def rocker_of(task: RockerTask) -> RockerTask | None:
    """Give a task with its free parameter: as it is told, or the best; None where no arc admits O."""
    if task.frame is not None or task.place is not None:
        return task
    best = best_place(task) if task.overlap else None
    return None if best is None else task._replace(side=best[0], place=best[1])


def rockers(task: RockerTask) -> tuple[DrawnRocker, ...]:
    """Draw a task whose free parameter is known on each circle that it may lie on."""
    sides = task.sides if task.overlap else (TOWARDS,)
    return tuple(drawn_rocker(task, side) for side in sides)
