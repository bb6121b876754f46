"""The view of a cam's main sizes, and their table: by construction, by analysis, drawing error (основные размеры)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import COLUMNS, value_row
from drawings.page.page import Drafting
from geometry.board import Line as Ruler
from geometry.board import Mark
from plans.cam.centre.bounds import PressureBound, SlopeDiagram, sampled, stretches
from plans.cam.centre.place import SizeTangent, Sizing
from plans.cam.numbers import Result
from plans.model.cam import RETURN, RISE, Cam
from plans.model.cam_motion import Points
from plans.quantity import Quantity

NAME, QUANTITY = "sizes", "l"
DEPTH = 0.3  # of the diagram's height: how far the region is shown below O
SIDE = 0.25  # of the distance of centres: how far a rocker's face and the region under it are shown past O
PAST = 0.12  # of the diagram's height: how far a tangent goes past the point that it touches


@dataclass(frozen=True)
class SizeView:
    """The construction of the main sizes, in its own frame: from A, or from O1 of a rocker."""

    sizing: Sizing

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.sizing.cam

    @property
    def bent(self) -> bool:
        """Whether S is drawn over S'', as under a flat face that translates."""
        return self.cam.flat and not self.cam.rocks

    @property
    def centre(self) -> complex:
        """O."""
        return _spot(self.sizing.centre)

    @property
    def start(self) -> complex:
        """A; of a rocker K0, and under its face O1."""
        return _spot(self.sizing.start)

    @property
    def tips(self) -> Points:
        """K of the numbered positions, (N,); none under the face of a rocker."""
        return _spots(self.sizing.tip)

    @property
    def ends(self) -> Points:
        """D of the numbered positions, (N,)."""
        return _spots(self.sizing.end)

    @cached_property
    def curves(self) -> tuple[Points, ...]:
        """The diagram densely, a row a smooth stretch; none under the face of a rocker."""
        if self.faced:
            return ()
        diagram = SlopeDiagram(self.cam)
        motions = [sampled(stretch)[1] for stretch in stretches(self.cam, (RISE, RETURN))]
        if self.bent:
            return tuple(np.asarray(motion.bend + 1j * motion.s) for motion in motions)
        return tuple(diagram.end(motion) for motion in motions)

    @property
    def faced(self) -> bool:
        """Whether it is under the face of a rocker."""
        return self.cam.flat and self.cam.rocks

    @property
    def face(self) -> tuple[complex, complex, complex]:
        """The face of a rocker at the start: its ends, and the foot on it of the perpendicular from O."""
        arm = self.cam.rising * complex(SlopeDiagram(self.cam).leaning(np.zeros(1))[0])
        up = 1j * self.cam.rising * arm
        root = self.cam.follower.face * up
        foot = self.centre + self.sizing.sizes.base * up
        return root, foot + SIDE * (foot - root), foot

    @property
    def points(self) -> list[complex]:
        """All that must be on the paper, but the ends of the tangents."""
        spots = [self.centre, self.start, *self.tips.tolist(), *self.ends.tolist()]
        spots += [0j] if self.cam.rocks else []
        spots += [*self.face, self.centre + SIDE * abs(self.centre)] if self.faced else []
        spots += [spot for curve in self.curves for spot in curve.tolist()]
        chord = self.sizing.chord
        return spots + ([_spot(chord.centre)] if chord else [])

    @cached_property
    def box(self) -> tuple[complex, complex]:
        """The corners of what is shown, with room below O for the region."""
        xs, ys = [spot.real for spot in self.points], [spot.imag for spot in self.points]
        spare = DEPTH * max(max(ys) - min(ys), max(xs) - min(xs))
        low = self.centre.imag - (spare if self.shaded else spare / 4)
        return complex(min(xs), min(*ys, low)), complex(max(xs), max(ys) + spare / 4)

    @property
    def shaded(self) -> bool:
        """Whether limits leave a region to be shown."""
        return bool(self.sizing.bounds) and not self.bent

    @cached_property
    def region(self) -> tuple[complex, ...]:
        """The corners of the part of the region that is shown."""
        if not self.shaded:
            return ()
        low, high = self.box
        outline = [low, complex(high.real, low.imag), high, complex(low.real, high.imag)]
        for bound in self.sizing.bounds:
            for stretch in bound.along:
                lines = bound.lines(sampled(stretch)[1])
                for normal, reach in zip(lines.normals.tolist(), lines.bounds.tolist(), strict=True):
                    outline = cut(outline, normal, reach)
        return tuple(outline)

    def ends_at(self, start: complex, end: complex) -> bool:
        """Tell whether an edge of the region lies where no more of it is shown."""
        low, high = self.box
        levels = ((start.real, end.real, low.real, high.real), (start.imag, end.imag, low.imag, high.imag))
        return any(begin == end and begin in sides for begin, end, *sides in levels)

    def ruler(self, tangent: SizeTangent) -> tuple[complex, complex]:
        """Give the ends of a tangent: past the point that it touches, and down to the region's end."""
        touched, line = _spot(tangent.point), tangent.line.value
        assert isinstance(line, Ruler)
        along = complex(line.direction)
        along *= math.copysign(1.0, along.imag) / abs(along)
        low, high = self.box
        past = touched + PAST * (high.imag - low.imag) * along
        level = low.imag if tangent.binding and not self.bent else min(self.centre.imag, touched.imag)
        foot = touched + (level - touched.imag) / along.imag * along
        aside = (high.real - low.real) / 4  # it goes no farther past the box
        edge = min(max(foot.real, low.real - aside), high.real + aside)
        return past, foot if edge == foot.real else foot + (edge - foot.real) / along.real * along


def cut(outline: Sequence[complex], normal: complex, reach: float) -> list[complex]:
    """Cut off what of a convex outline is beyond a line.

    >>> cut([0j, 2 + 0j, 2 + 2j, 2j], 1 + 0j, 1.0)
    [0j, (1+0j), (1+2j), 2j]
    """
    beyond = [(normal.conjugate() * corner).real - reach for corner in outline]
    kept = []
    for k, end in enumerate(outline):
        start, first, last = outline[k - 1], beyond[k - 1], beyond[k]
        if (first > 0) != (last > 0):
            kept.append(start + (end - start) * (first / (first - last)))
        if last <= 0:
            kept.append(end)
    return kept


def leaning(tangent: SizeTangent, view: SizeView) -> complex | None:
    """Give the direction from which the angle of a tangent is counted; None of one at 45 degrees."""
    if not isinstance(tangent.bound, PressureBound):
        return None
    diagram = SlopeDiagram(view.cam)
    return 1j * complex(diagram.leaning(tangent.touch.instant.s)[0])


def lower(tangent: SizeTangent) -> bool:
    """Tell whether a tangent is at the limit below 0 of a rise, which is held to both of its limits then."""
    bound = tangent.bound
    return isinstance(bound, PressureBound) and bound.kind == RISE and bound.side < 0


def _spot(mark: Mark | None) -> complex:
    return 0j if mark is None else complex(mark.point)


def _spots(mark: Mark | None) -> Points:
    return np.zeros(0, dtype=complex) if mark is None else np.asarray(mark.point, dtype=np.complex128)


NOTHING = "—"


def sizes(ours: Sequence[Result], exact: Sequence[Result], by_hand: bool, drafting: Drafting) -> RuledTable:
    """Tell what both roads found, and what a hand may be out; of what is given that it is.

    Without `by_hand` nothing is read off a construction in which a hand might err.
    """
    heads = tuple(drafting.word(key) for key in (COLUMNS if by_hand else COLUMNS[:-1]))
    lines = [_line(result, true, drafting) for result, true in zip(ours, exact, strict=True)]
    lines = [line._replace(cells=line.cells[: len(heads)]) for line in lines]
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=NAME, least=6)


def title(result: Result, drafting: Drafting) -> str:
    """Write the name of a row."""
    letter = drafting.letter(result.letter)
    named = drafting.word(result.where, letter=letter) if result.where else letter
    return f"{named}, {drafting.word(result.unit)}" if result.unit else named


def _line(result: Result, exact: Result, drafting: Drafting) -> TableRow:
    name = title(result, drafting)
    largest = abs(exact.value) or 1.0
    finding = Quantity.of((NAME, result.letter, result.unit), (result.value, exact.value), 0.0, largest)
    line = value_row(finding, name, (0,), drafting.language)
    if result.given:
        return TableRow(name, (line.cells[0], drafting.word("cam given"), NOTHING))
    return line._replace(cells=(*line.cells[:-1], NOTHING)) if result.where else line
