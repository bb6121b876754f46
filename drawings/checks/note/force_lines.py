"""The self-check of the equations of forces in a note, position by position (проверка уравнений сил записки)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.note import drawn_order
from drawings.checks.note.cut_note import CutNote
from drawings.checks.note.heads import head_of, split
from drawings.checks.note.lever_note import LeverNote
from drawings.checks.wrong import Wrong
from drawings.page.drafting import drafting_of
from drawings.paper.walk import groups
from drawings.report.formula import Formula
from plans.checks.force_bill import ForceBill
from plans.checks.force_comparison import ForceComparison
from plans.checks.force_expected import ExpectedForces
from plans.forces.statics import Statics
from plans.model.order import VELOCITIES
from plans.words.words import message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

LEVER = "lever"


@dataclass(frozen=True)
class ForceLines:
    """The lines of the chapter, and the sheets whose positions it tells."""

    lines: Sequence[str]
    statics: Statics
    comparison: ForceComparison
    leaves: Mapping[str, Sequence[Leaf]]

    def faults(self) -> Iterator[Wrong]:
        """Hold what marks vectors, the heads of positions in order, and what stands under each."""
        before, parts = split(self.lines, [head_of(self.statics.study, k) for k in sorted(self._scales)])
        if not self._scales:
            return
        if before != [self._say("underlines")]:
            yield message("wrong.told", text=(before or [self._say("underlines")])[0])
        for k, lines in zip(sorted(self._scales), parts, strict=True):
            if lines is None:
                yield message("wrong.missing", name=head_of(self.statics.study, k, 4))
            else:
                yield from self._position(k, lines)

    def _say(self, key: str, **parts: object) -> str:
        return word(self.statics.study.language, f"report.{key}", **parts).strip()

    @cached_property
    def _scales(self) -> dict[int, dict[str, float]]:
        """Give the scales of the plans that are drawn in each position, as their marks state them."""
        found: dict[int, dict[str, float]] = {}
        for leaf in (leaf for own in self.leaves.values() for leaf in own if "position" in leaf.metadata):
            own = found.setdefault(int(leaf.metadata["position"]), {})
            own |= {one.data["plan"]: float(one.data["scale"]) for one in groups(leaf.groups) if "scale" in one.data}
        return found

    def _position(self, k: int, lines: Sequence[str]) -> Iterator[Wrong]:
        """Hold each cut, and the lever where one is drawn."""
        floor, study, scales = self._floor(k), self.statics.study, self._scales[k]
        bills = [ForceBill(self._expected(k), study.groups, one) for one in (*reversed(study.groups), None)]
        labels = ["-".join(map(str, one.links)) for one in bills]
        keys = ["primary_cut" if one.group is None else "cut" for one in bills]
        heads = [self._say(key, links=label) for key, label in zip(keys, labels, strict=True)]
        levered = LEVER in scales and study.mechanism.drive.turns
        before, parts = split(lines, [*heads, *([self._say(LEVER)] if levered else [])])
        yield from (message("wrong.told", text=line) for line in before)
        for head, label, bill, own in zip(heads, labels, bills, parts, strict=False):
            scale = scales.get(f"forces-{label}")
            if own is None:
                yield message("wrong.missing", name=head)
            else:
                note = CutNote(label, list(own), bill, floor, self._formula, scale)
                yield from note.faults()
                yield from drawn_order.faults(note, [leaf for every in self.leaves.values() for leaf in every], k)
        if levered and parts[-1] is None:
            yield message("wrong.missing", name=self._say(LEVER))
        elif levered and parts[-1] is not None:
            yield from LeverNote(parts[-1], bills, floor, self._formula, scales[LEVER], self._speed(k)).faults()

    @property
    def _formula(self) -> Formula:
        return Formula(drafting_of(self.statics.study.scene)._replace(reactions=self.statics.form.sheet.reactions))

    def _speed(self, k: int) -> float:
        """Give what the two roads may differ by in a velocity, m/s."""
        return 2 * max(float(one.allowed[k]) for one in self.comparison.motion.of(VELOCITIES.plan))

    def _floor(self, k: int) -> Floor:
        """Give what is none in a position, beside what the two roads may differ by."""
        found, study = self.comparison.analysis, self.statics.study
        slack = 2 * max(float(one.allowed[k]) for one in self.comparison.of("forces") if one.unit == "N")
        force, moment = found.nothing_at(k)
        return Floor(slack + force, slack * found.size + moment, study.language, self.statics.form.sheet.reactions)

    def _expected(self, k: int) -> ExpectedForces:
        solved = self.comparison.motion.analysis
        loads, study = self.statics.loading(solved), self.statics.study
        return ExpectedForces(study.mechanism, self.statics.machine, solved, loads, self.comparison.analysis, k)
