"""An involute pair by both roads: what is measured on the drawing beside the formulas (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from geometry.board import Reading, Span, behind
from plans.analytic.involute import flank, foot, solve
from plans.explanation import Explanation, NoMark, explained_by
from plans.involute.action import MESH, slack
from plans.involute.flanks import Flanks
from plans.involute.generation import GENERATION
from plans.involute.study import POINTS, InvoluteStudy
from plans.model.involute import EPS, PairSizes, WheelSizes
from plans.quantity import Comparison, Quantity, Shown
from plans.words.words import because, message

if TYPE_CHECKING:
    from plans.study import Study

WEAR = 8.0  # roundings more of what is measured by several lines


def compare_pair(study: InvoluteStudy) -> Comparison:
    """Measure a pair on its drawing, and put every size beside that by formulas."""
    both = _ComparedPair(study, study.sizes, solve(study.pair))
    return Comparison(both.ours, both.theirs, (*both.pair(), *both.wheels(), *both.generated(), *both.left()))


class _ComparedPair(NamedTuple):
    """A pair by both roads."""

    study: InvoluteStudy
    ours: PairSizes
    theirs: PairSizes

    @property
    def slack(self) -> float:
        """How far rounding may move a place, m."""
        return WEAR * slack(self.study.pair, self.theirs.angle)

    def _of(self, name: str, unit: str, pair: tuple[float, float], off: float, shown: Shown | None = None) -> Quantity:
        return Quantity.of((MESH, name, unit), pair, off, shown=shown)

    def pair(self) -> Iterator[Quantity]:
        """Compare what both wheels have in common."""
        ours, theirs, action = self.ours, self.theirs, self.study.action
        turned = self.slack / (theirs.distance * math.sin(theirs.angle))
        centres = action.board["a_w"]
        along = action.board.turn("α_w:a", centres, complex(action.way.point) / complex(centres.point))
        yield self._of("α_w", "rad", (ours.angle, theirs.angle), turned, Reading(along, action.way))
        yield self._of("a_w", "m", (ours.distance, theirs.distance), self.slack, Span(*action.centres))
        yield self._of("g_α", "m", (ours.active, theirs.active), self.slack, Span(*action.active))
        over = 1 / self.study.pair.rack.base_pitch
        part = action.board.turn("ε_α", action.board.join("B_1B_2", *action.active), over, because("involute_ratio"))
        yield self._of("ε_α", "1", (ours.ratio, theirs.ratio), self.slack * over, part)

    def wheels(self) -> Iterator[Quantity]:
        """Compare the sizes of each wheel."""
        for flanks, ours, theirs in zip(self.study.flanks, self.ours.wheels, self.theirs.wheels, strict=True):
            n, ends = flanks.wheel.number, {"span": Span(*flanks.span)}
            ends |= {"chord": Span(*flanks.chord)} if flanks.has_chord else {}
            for letter, name, times in SIZES:
                values = times * getattr(ours, name), times * getattr(theirs, name)
                if not math.isnan(values[1]):
                    yield self._of(f"{letter}{n}", "m", values, times * self.slack, ends.get(name))
            strings = self.study.action.feet[n - 1]
            share = self.slack * (1 / strings + 1 / abs(strings - self.theirs.distance * math.sin(self.theirs.angle)))
            off = abs(1 - theirs.sliding) * share
            yield self._of(f"λ_B{n}", "1", (ours.sliding, theirs.sliding), off, self.study.action.slid(n - 1))

    def generated(self) -> Iterator[Quantity]:
        """Compare what the rack leaves: the root circle, and where the involute begins."""
        for flanks, theirs in zip(self.study.flanks, self.theirs.wheels, strict=True):
            if flanks.wheel.internal:
                yield self._of("d_f2", "m", (2 * flanks.root, 2 * theirs.root), 2 * self.slack)
            if found := self.study.generated.get(flanks.wheel.number):
                n = flanks.wheel.number
                root, begin = abs(complex(found.points[0])), abs(complex(np.atleast_1d(found.involute.point)[0]))
                yield Quantity.of((GENERATION, f"d_f{n}", "m"), (2 * root, 2 * theirs.root), 2 * self.slack)
                ends = 2 * begin, 2 * abs(complex(flank(flanks.wheel, theirs.tip, theirs.root, POINTS)[POINTS - 1]))
                yield Quantity.of((GENERATION, f"d_l{n}", "m"), ends, 2 * self._loose(flanks, theirs, 1))

    def left(self) -> Iterator[Quantity]:
        """See that tooth and space fill the operating pitch, and how far whole profiles are from the formulas."""
        first, second = self.ours.wheels
        pitch = math.tau * first.operating / self.study.pair.teeth[0]
        gap = pitch - first.operating_thickness - second.operating_thickness
        yield Quantity.of((MESH, "j_w", "m"), (gap, 0.0), 2 * self.slack, pitch)
        for flanks, theirs in zip(self.study.flanks, self.theirs.wheels, strict=True):
            known = flank(flanks.wheel, theirs.tip, theirs.root, POINTS)
            off = float(np.abs(self.study.profile(flanks) - known).max())
            loose = self._loose(flanks, theirs, 0)
            yield Quantity.of((GENERATION, f"Δ_{flanks.wheel.number}", "m"), (off, 0.0), loose, theirs.tip)

    def _loose(self, flanks: Flanks, theirs: WheelSizes, order: int) -> float:
        """Give how far rounding moves points along a flank, m, or (1) outwards: a low fillet crosses it flatly."""
        low, base = -foot(flanks.wheel, theirs.root), flanks.wheel.base
        return self.slack + (base * min(EPS / low**2, low) * low**order if low > 0 else 0.0)


# The letter of a size, its name, and how often it is told: of circles the diameters.
SIZES = (
    ("d_w", "operating", 2), ("d_a", "tip", 2), ("s_", "thickness", 1), ("s_w", "operating_thickness", 1),
    ("s_a", "tip_thickness", 1), ("s_c", "chord", 1), ("h_c", "height", 1), ("W_", "span", 1), ("M_", "over", 1),
)  # fmt: skip
assert {name for _, name, _ in SIZES} <= set(WheelSizes._fields)


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark: places and lengths are metres."""
    found, board = explained_by(study.comparison(MESH).findings, position, name), study.of(InvoluteStudy).action.board
    if isinstance(found, NoMark) and name in board and name not in found.names:
        return Explanation(message("explain.name", mark=name), tuple(behind(board[name])), {MESH: "m"})
    return found._replace(units={MESH: "m", "ε_α": ""}) if isinstance(found, Explanation) else found
