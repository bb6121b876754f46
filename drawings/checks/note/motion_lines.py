"""The self-check of what a report says of a linkage: data, structure, extremes, conditions, plans (текст отчёта).

Each chapter is held line for line, so that a line that nothing calls for is told. Between what a pressure angle goes,
how sharply groups meet and where an output reverses more than twice the construction alone finds: of these the writing
is held, their numbers are those that were constructed.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from drawings.checks.documents_old import chapters
from drawings.checks.note import told_lines
from drawings.checks.note.lines import part
from drawings.checks.note.motion_data import MotionData
from drawings.checks.note.motion_passage import MotionPassage
from drawings.checks.precise import ALL_DIGITS, rounded
from drawings.checks.wrong import Wrong
from drawings.lettering.words import decimal, number
from drawings.paper.limits import MANY
from drawings.report.markdown import header
from plans.analytic.extremes import EQUAL
from plans.checks.compare import MotionComparison, notches
from plans.linkage.pressure import interval
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import Extremes
from plans.model.order import PLANS, VELOCITIES
from plans.model.working import ways
from plans.study import Study
from plans.words.words import message, term, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

# What is said of a meeting whose kappa is so large, the largest first.
GRADES = ((600.0, "not_graded"), (60.0, "warning"), (10.0, "note"))


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Wrong]:
    """Hold each chapter to the lines that are due, one for one; of what is left out to those of a linkage."""
    linkage, comparison, language = study["linkage"], study.comparison("linkage"), study.scene.sheet.language
    due = _Due(linkage, comparison, "extremes" in study.plans)
    own = {key: told_lines.lines(texts) for key, texts in due.chapters().items()}
    for key, texts in own.items():
        yield from told_lines.faults(part(text, word(language, f"report.{key}")), texts)
    heads = [key for key, texts in own.items() if texts]
    yield from chapters.faults(text, language, [*heads[:-1], "values", heads[-1], "left_out"])
    seen = part(text, word(language, "report.left_out"))
    for one in told_lines.lines(_LeftOut(study, linkage, leaves).lines()):
        if sum(told_lines.is_line(line, one) for line in seen) != 1:
            yield message("wrong.missing", name=rounded(one))


def said_first(study: Study) -> Iterator[str]:
    """Give the line that is said first of a motion beside its numbers."""
    yield output_line(study["linkage"])


def output_line(study: LinkageStudy) -> str:
    """Say which link is the output, and who chose it."""
    out, last = study.output, study.groups[-1:]
    framed = any(pair.giver == FRAME for group in last for pair in group.outer_pairs)
    how = "named" if study.mechanism.output is not None else "framed" if framed else "last"
    key = f"report.output_{how}{'_point' if out.point else ''}"
    return word(study.language, key, link=out.link, point=out.point)


class _Due(NamedTuple):
    """What the report must say of a linkage."""

    study: LinkageStudy
    comparison: MotionComparison
    extremes: bool

    def chapters(self) -> Mapping[str, Iterable[str]]:
        """Give the lines of each chapter in their order, numbers with all digits; of one that must not stand none."""
        data = MotionData(self.study, self.comparison)
        return {
            "data": data.data(),
            "structure": data.structure(),
            "extremes": self._extremes() if self.extremes else (),
            "passage": MotionPassage(self.study, self.comparison).lines(),
            "conditions": self._conditions(),
        }

    def _say(self, key: str, **parts: object) -> str:
        return word(self.study.language, f"report.{key}", **parts)

    def _full(self, value: float) -> str:
        return number(value, self.study.language, ALL_DIGITS)

    def _extremes(self) -> Iterator[str]:
        """Tell the output and how far it goes, or that it has no extremes; the pressure angles."""
        yield from self._travel()
        study, found = self.study, self.study.extreme_positions
        if found is None:
            key = "no_extremes" if study.mechanism.drive.turns else "no_extremes_way"
            yield self._say(key, link=study.output.link)
        elif len(found.rests) > 2:
            angles = ", ".join(f"{self._degrees(phi)}°" for phi in found.rests)
            yield self._say("reversals", count=len(found.rests), angles=angles)
        if study.groups and not study.nodes.size:
            yield self._say("no_pressure")
        for group in study.groups if study.nodes.size else ():
            seen = interval(study.sweep, group, study.nodes)
            yield self._say("pressure", group=group.label, low=self._degrees(seen.low), high=self._degrees(seen.high))

    def _travel(self) -> Iterator[str]:
        """Tell the output, its extremes by analysis, the pressure angles."""
        found = self.study.extreme_positions
        yield self._say("output", output=output_line(self.study)[1:])
        extremes = None if found is None else self.comparison.road.extremes(self.study.output)
        if found is not None and extremes is not None:
            way = "by_notches" if found.notched else "by_velocity"
            yield self._say(way, angles=", ".join(f"{self._degrees(phi)}°" for phi in extremes.phi))
            size, swing = self._full(extremes.stroke), self._degrees(extremes.stroke)
            yield self._say("stroke", stroke=size) if extremes.sliding else self._swing(size, swing)
            if self.study.scene.has(("output", "working")):
                yield self._working(extremes)
            if len(found.rests) <= 2:
                yield self._ratio(extremes)

    def _swing(self, size: str, degrees: str) -> str:
        return self._say("swing", stroke=size, degrees=degrees)

    def _working(self, extremes: Extremes) -> str:
        """Tell the working stroke: its way, whether it is the longer one, the crank's angles."""
        work, idle = extremes.angles
        time = "equal" if abs(work - idle) < EQUAL else "slower" if work > idle else "faster"
        way = tuple(message(f"way.{one}") for one in ways(self.study.mechanism, self.study.output, *extremes.reach))
        angles = {"work": self._degrees(work), "idle": self._degrees(idle)}
        return self._say("working", time=message(f"way.{time}"), ways=way, **angles)

    def _ratio(self, extremes: Extremes) -> str:
        turned = extremes.overlap
        ratio = (math.pi + turned) / (math.pi - turned)
        key = "ratio_faster" if extremes.faster else "ratio"
        return self._say(key, overlap=self._degrees(turned), ratio=self._full(ratio))

    def _degrees(self, angle: float) -> str:
        return self._full(math.degrees(angle))

    def _conditions(self) -> Iterator[str]:
        """Tell the worst condition of each group, in which position, and what that means."""
        if not self.study.groups:
            yield self._say("no_meeting")
            return
        yield self._say("kappa")
        heads = (word(self.study.language, f"table.{head}") for head in ("group", "kappa", "in_position"))
        yield from header([*heads, ""])
        rows = np.where(self.study.lost, np.nan, notches(self.study))
        for group, kappas in zip(self.study.groups, rows, strict=True):
            if not np.isnan(kappas).all():
                worst = int(np.nanargmax(kappas))
                told = " | ".join(self._graded(float(kappas[worst]), worst))
                yield f"| {group.label} | {told} |"

    def _graded(self, kappa: float, position: int) -> tuple[str, str, str]:
        """Write the largest kappa of a group with its position, and the word that stands beside it."""
        language = self.study.language
        grade = next((self._say(key) for least, key in GRADES if kappa >= least), "")
        whole = decimal(f"{kappa:.4g}", language) if math.isfinite(kappa) else self._say("unbounded")
        return whole, str(position), grade


class _LeftOut(NamedTuple):
    """What the report must say that the sheets of a linkage leave out."""

    whole: Study
    study: LinkageStudy
    leaves: Mapping[str, Sequence[Leaf]]

    def lines(self) -> Iterator[str]:
        """Tell of which positions plans are drawn, which have no links, what is not made, which links do not turn."""
        yield from self._drawn()
        count = len(self.study.turn)
        if self._sheets and count > MANY:
            yield self._say("ticks", count=count, most=MANY)
        missing = [plan for plan in ("extremes", *PLANS) if plan not in self.whole.made & self.whole.plans]
        if missing:
            yield self._say("not_made", plans=", ".join(term(self.study.language, "plan", one) for one in missing))
        if VELOCITIES.plan in self.study.made:
            yield from self._still()

    def _say(self, key: str, **parts: object) -> str:
        return word(self.study.language, f"report.{key}", **parts)

    @property
    def _sheets(self) -> list[Leaf]:
        return [leaf for own in self.leaves.values() for leaf in own if "shown" in leaf.metadata]

    def _drawn(self) -> Iterator[str]:
        sheets = self._sheets
        names = [group.name for leaf in sheets for group in leaf.groups]
        drawn = sorted(int(name.rpartition("-")[2]) for name in names if name.startswith(f"{VELOCITIES.plan}-"))
        order = [k for leaf in sheets for k in leaf.metadata["plans"]]  # as the scene has them
        drawn = order if sorted(order) == drawn else drawn
        if drawn and sheets[0].metadata["shown"] is not None:
            parts = {"count": len(self.study.turn), "shown": sheets[0].metadata["shown"]}
            yield self._say("plans_drawn", plans=", ".join(map(str, drawn)), **parts)

    def _still(self) -> Iterator[str]:
        """Tell which links do not turn."""
        still = sorted(n for n, other in self.study.mechanism.turning_with.items() if n != FRAME == other)
        if still:
            yield self._say("still", links=", ".join(map(str, still)))
