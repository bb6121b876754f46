"""Marks of the diagrams by the names that `explain` takes: dS/dt of a chord, dv/dt of two (точки диаграмм)."""

from __future__ import annotations

import numpy as np

from geometry.board import Mark, behind
from geometry.calculus import Derivative
from plans.diagrams.study import DIAGRAMS, DiagramsStudy
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.linkage import marks as motion
from plans.model.motion import Floats
from plans.study import Study
from plans.words.words import Message, message

SPEED, GROWTH = "dS/dt", "dv/dt"
TURNING = {"dψ/dt": SPEED, "dω/dt": GROWTH}  # as an output that turns is lettered
UNITS = {DIAGRAMS: ""}  # abscissas are angles, ordinates what is drawn over them


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind v by the chord from a position to the next, or behind a by the chords on both its sides."""
    diagrams = study.of(DiagramsStudy)
    asked = TURNING.get(name, name)
    if asked not in (SPEED, GROWTH):
        return NoMark((SPEED, GROWTH), None, () if diagrams.unfit else (SPEED,))
    if diagrams.left_out is not None:
        raise UnknownMark(message("mark.undrawn", mark=name, why=diagrams.left_out))
    wanted = motion.position_of(diagrams.linkage, position)
    found = diagrams.drawn
    edge = found.axis.numbers.index(wanted) if wanted in found.axis.numbers else -1
    values = (found.speeds, found.true_speeds) if asked == SPEED else (found.growths, found.true_growths)
    if not 0 <= edge < len(values[0]) or np.isnan(values[0][edge]):
        raise UnknownMark(message("mark.chord", mark=name, position=wanted))
    drawn, at = _curve(diagrams, edge, asked)
    where = found.axis.middles[edge] if asked == SPEED else found.axis.places[edge]
    steps = tuple(behind(*_ends(diagrams, edge, asked), drawn.points[at]))
    unit = diagrams.units[1 if asked == SPEED else 2]
    note = _note(name, (float(values[0][edge]), float(values[1][edge])), values[1], float(where), unit)
    return Explanation(motion.title(diagrams.linkage, name, wanted), steps, UNITS, (note,), DIAGRAMS)


def _curve(diagrams: DiagramsStudy, edge: int, asked: str) -> tuple[Derivative, int]:
    """Find the curve that a value stands on, and which of its points it is."""
    axis = diagrams.axis
    for run, speeds, growths in zip(axis.runs, diagrams.chords.speeds, diagrams.chords.growths, strict=True):
        if run.start <= edge < run.stop:
            if asked == SPEED or growths is None:
                return speeds, edge - run.start
            return growths, (edge - run.start - 1) % len(growths.points)
    raise AssertionError  # a value that is there stands on a curve


def _ends(diagrams: DiagramsStudy, edge: int, asked: str) -> tuple[Mark, ...]:
    """Give the two values of v whose chord tells a; v is told by what the plan of positions gives."""
    if asked == SPEED:
        return ()
    found = (_curve(diagrams, part % len(diagrams.axis.joined), SPEED) for part in (edge - 1, edge))
    return tuple(drawn.points[at] for drawn, at in found)


def _note(name: str, pair: tuple[float, float], exact: Floats, where: float, unit: str) -> Message:
    """Say what the chord gives, over which angle, and what is exact there."""
    value, true = pair
    off = 100 * abs(value - true) / float(np.nanmax(np.abs(exact)))
    parts = {"value": f"{value + 0.0:.10g}", "true": f"{true + 0.0:.10g}", "off": f"{off:.3g}"}
    return message("explain.chord", mark=name, unit=unit, angle=f"{np.degrees(where):.4f}", **parts)
