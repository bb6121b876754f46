"""What a report must say of gaps and dead centres: change points, barriers, positions that are left out (разрывы).

Why a position has no result both roads say for themselves, and are compared. Where a barrier begins and by how much
loci miss is the construction's to say: of that the writing alone is held here.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.checks.precise import ALL_DIGITS
from drawings.lettering.words import decimal, number
from plans.checks.compare import MotionComparison
from plans.linkage.barrier import Barrier
from plans.linkage.study import LinkageStudy
from plans.model.motion import Gap
from plans.model.order import POSITIONS
from plans.words.words import word

MM = 1000.0


class MotionPassage(NamedTuple):
    """A linkage that does not reach all positions, or passes a change point."""

    study: LinkageStudy
    comparison: MotionComparison

    @property
    def due(self) -> bool:
        """Whether there is anything to be said."""
        return bool(self.study.met or self.study.passed or self.comparison.construction.gaps)

    def lines(self) -> Iterator[str]:
        """Give the lines, numbers with all digits."""
        if not self.due:
            return
        through = self.study.mechanism.through
        for one in self.study.passed:
            at = self._full(math.degrees((one.start + one.end) / 2) % 360)
            yield self._say("carried", where=one.where, angle=at, through=through)
        yield from map(self._barrier, self.study.met)
        lost = {gap.position for gap in self.comparison.analysis.gaps if gap.plan == POSITIONS.plan}
        count = len(self.study.turn)
        yield self._say("assembled", found=count - len(lost), count=count)
        yield from map(self._gap, self.comparison.construction.gaps)

    def _say(self, key: str, **parts: object) -> str:
        return word(self.study.language, f"report.{key}", **parts)

    def _full(self, value: float) -> str:
        return number(value, self.study.language, ALL_DIGITS)

    def _barrier(self, one: Barrier) -> str:
        """Say what bars the drive, between which angles, and by how much loci miss, with as many digits as are told."""
        parts = {"reason": one.kind, "where": one.where}
        if self.study.mechanism.drive.pushed:
            return self._say("barrier_way", **parts)
        ends = dict(zip(("low", "high"), (self._full(math.degrees(end)) for end in (one.start, one.end)), strict=True))
        if not one.miss:
            return self._say("barrier", **parts, **ends)
        return self._say("barrier_miss", **parts, **ends, miss=decimal(f"{one.miss:.6g}", self.study.language))

    def _gap(self, gap: Gap) -> str:
        drive = self.study.mechanism.drive
        parts = {"plan": gap.plan, "reason": gap.reason, "advice": gap.advice, "position": gap.position}
        if drive.pushed:
            return self._say("gap_way", way=self._full(MM * drive.unit * gap.phi), **parts)
        return self._say("gap", angle=self._full(math.degrees(gap.phi)), **parts)
