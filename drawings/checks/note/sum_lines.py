"""The self-check of the equations of plans in a note: letters of each group, then each position (уравнения планов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, cast

import numpy as np

from drawings.checks.note import due_math
from drawings.checks.note.due_math import NUMBER, Due, DueMath, Quantity
from drawings.checks.note.heads import head_of, split
from drawings.checks.note.lettered_sums import LetteredSums
from drawings.checks.note.plan_numbers import PlanNumbers
from drawings.checks.note.solved_position import SolvedPosition
from drawings.checks.wrong import Wrong
from drawings.lettering.words import word as lettered
from drawings.page.drafting import drafting_of
from drawings.paper.walk import groups
from drawings.report.formula import Formula
from plans.checks.compare import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.dyad import Dyad
from plans.model.order import ACCELERATIONS, PLANS, VELOCITIES
from plans.words.words import message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

MOST = 6  # positions whose numbers a note puts in
UNITS = dict(zip(PLANS, (("l", "{m}/{mm}"), ("v", "({m/s})/{mm}"), ("a", "({m/s2})/{mm}")), strict=True))


@dataclass(frozen=True)
class SumLines:
    """The lines of the chapter, and the sheets whose plans it tells."""

    lines: Sequence[str]
    study: LinkageStudy
    comparison: MotionComparison
    leaves: Mapping[str, Sequence[Leaf]]

    def faults(self) -> Iterator[Wrong]:
        """Hold the equations in letters, the heads of positions in order, and what stands under each."""
        due = self._positions
        before, parts = split(self.lines, [head_of(self.study, k) for k in due])
        letters = LetteredSums(self.study, self._formula).lines() if due else ()
        yield from due_math.faults(before, [(DueMath(one.replace("{,}", ".")),) for one in letters])
        for k, own in zip(due, parts, strict=True):
            if own is None:
                yield message("wrong.missing", name=head_of(self.study, k, 4))
            else:
                yield from due_math.faults(own, list(self._position(k)))

    @property
    def _formula(self) -> Formula:
        return Formula(drafting_of(self.study.scene))

    @property
    def _positions(self) -> list[int]:
        """Give the positions that are due: whose plans of velocities are drawn, or whose forces."""
        told = (
            leaf.metadata["position"] for own in self.leaves.values() for leaf in own if "position" in leaf.metadata
        )
        own = {k for k, scales in self._scales.items() if VELOCITIES.plan in scales} | {int(k) for k in told}
        moves = self.comparison.analysis.points[self.study.mechanism.drive.end]
        if len(moves) <= ACCELERATIONS.number:
            return []
        return [k for k in sorted(own)[:MOST] if not np.isnan(moves.v[k])]

    @cached_property
    def _scales(self) -> dict[int, dict[str, float]]:
        """Give the scales of the plans that are drawn in each position, as their marks state them."""
        found: dict[int, dict[str, float]] = {}
        marks = (one.data for own in self.leaves.values() for leaf in own for one in groups(leaf.groups))
        for data in (one for one in marks if one.get("plan") in PLANS and "position" in one and "scale" in one):
            found.setdefault(int(data["position"]), {})[data["plan"]] = float(data["scale"])
        return found

    def _position(self, k: int) -> Iterator[Due]:
        """Give the lines of a position: scales of its plans, the primary link, each group under its head."""
        scales = self._scales.get(k, {})
        written = self.study.drafts().velocities.written
        told = PlanNumbers(SolvedPosition(self.study.mechanism, self.comparison, k), written, scales, self._formula)
        drive = self.study.mechanism.drive
        if scales:
            yield (self._scaled(scales),)
        yield (DueMath(self._say("primary", link=drive.link)),)
        yield from told.primary(drive)
        for group in self.study.groups:
            yield (DueMath(self._say("numbers_of_group", group=group.label)),)
            yield from told.group(cast(Dyad, group))

    def _scaled(self, scales: Mapping[str, float]) -> DueMath:
        own = [plan for plan in PLANS if plan in scales]
        told = ", ".join(self._scale(plan) for plan in own)
        return DueMath(self._say("scales", scales=told), tuple(Quantity(scales[plan], 0.0) for plan in own))

    def _scale(self, plan: str) -> str:
        letter, unit = UNITS[plan]
        names = {name: lettered(self.study.language, name) for name in ("m", "mm", "m/s", "m/s2")}
        for name, own in names.items():
            unit = unit.replace(f"{{{name}}}", own)
        return f"${self._formula.letter(f'μ_{letter}')} = {NUMBER}{self._formula.unit(unit)}$"

    def _say(self, key: str, **parts: str | int) -> str:
        return word(self.study.language, f"report.{key}", **parts).strip()
