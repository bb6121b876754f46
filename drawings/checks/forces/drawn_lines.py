"""The lines of a force sheet's figure that bear no mark: each must have its reason (линии фигуры без обозначения)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.forces.laid_scheme import FINE
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.letters import leaders
from drawings.checks.linkage.laid_poses import Flags, Segments
from drawings.checks.linkage.position_marks import is_led
from drawings.checks.wrong import Wrong, on
from drawings.paper.strokes import Group, Line
from drawings.paper.walk import groups

MARKED = ("force", "vector", "coupling")  # kinds of marks whose own lines other checks hold
NUMBER = 4  # strokes of a link's number that has a leader


@dataclass(frozen=True)
class DrawnLines:
    """The lines of a figure that are neither leaders nor of a mark."""

    strokes: FigureStrokes

    @cached_property
    def lines(self) -> list[Line]:
        """The lines themselves."""
        group = self.strokes.group
        gone = {id(line) for line, _ in leaders((group,))}
        for one in groups((group,)):
            if one.data.get("kind") in MARKED or (len(one.strokes) == NUMBER and is_led(one)):
                gone |= {id(line) for line in one.strokes}
        return [one for one in self.strokes.lines if id(one) not in gone]

    @cached_property
    def segments(self) -> Segments:
        """Their ends."""
        return Segments.of((one.start, one.end) for one in self.lines)

    @property
    def none(self) -> Flags:
        """Tell of each line that it has no reason."""
        return np.zeros(len(self.lines), dtype=bool)

    def along(self, spot: complex, way: complex | None = None, near: float = FINE) -> Flags:
        """Tell which lines go through a place if they go on and on, in a direction or against it, or in any."""
        run = self.segments.ends - self.segments.starts
        unit = run / np.maximum(np.abs(run), FINE)
        through = np.abs(((spot - self.segments.starts) * unit.conj()).imag) <= near
        if way is None:
            return np.asarray(through)
        return np.asarray(through & (np.abs((run * np.conj(way / abs(way))).imag) <= 2 * FINE))

    def joining(self, spots: Iterable[complex]) -> Flags:
        """Tell which lines go from one of some places to another of them."""
        places = np.array([*spots], dtype=complex)
        ends = (np.abs(one[:, None] - places).min(axis=1, initial=np.inf) <= FINE for one in self.segments)
        return np.asarray(np.logical_and(*ends))

    def dimensions(self) -> Flags:
        """Tell which lines have an arrowhead at both ends, or run along one that has, outside."""
        headed = self.joining(one.points[0] for one in self.strokes.heads if len(one.points) == 3)
        own = [one for one, is_headed in zip(self.lines, headed, strict=True) if is_headed]
        return np.asarray(np.any([headed, *(self.along(one.start, one.end - one.start) for one in own)], axis=0))

    def arms(self) -> Iterator[tuple[complex, complex]]:
        """Give the lines square to arms at both of their ends: a place on each, its direction."""
        for arm in groups((self.strokes.group,)):
            match arm:
                case Group((Line(start, end), *_)) if arm.data.get("kind") == "vector" and abs(end - start) > FINE:
                    yield from ((spot, 1j * (end - start)) for spot in (start, end))

    def strays(self, plan: str, known: Flags) -> Iterator[Wrong]:
        """Tell of the first line that has no reason."""
        for k in np.flatnonzero(~known)[:1]:
            middle = (self.lines[k].start + self.lines[k].end) / 2
            yield on("stray", plan, x=f"{middle.real:.1f}", y=f"{middle.imag:.1f}")
