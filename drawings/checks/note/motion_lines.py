"""The self-check of what a report says of a linkage: data, structure, extremes, conditions, plans (текст отчёта)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from drawings.checks.precise import ALL_DIGITS, rounded, tells
from drawings.lettering.words import number
from drawings.lettering.words import word as lettered
from drawings.page.drafting import drafting_of
from drawings.report.formula import Formula
from plans.checks.compare import MotionComparison, notches
from plans.checks.ram_law import stroke_of
from plans.linkage.pressure import interval
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import pairs
from plans.model.mechanism import FRAME, Ram
from plans.model.motion import Extremes
from plans.model.order import VELOCITIES
from plans.model.structure import formula, mechanism_class
from plans.model.working import ways
from plans.study import Study
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS = (0, 4, 10)  # of the numbers of a report: fixed decimals, or so many digits
ROUNDED = 1e-9  # share of a number that both roads differ by at the most
GRADED = 10.0  # kappa from which a word stands beside it
EQUAL = 1e-7  # rad: strokes whose angles differ by less are equal in any machine


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """See that each line that is due is written, its numbers as the analysis has them, and each but once."""
    seen = [_plain(line) for line in text.splitlines()]
    for due in _Due(study["linkage"], study.comparison("linkage"), "extremes" in study.plans).lines(leaves):
        for line in (_plain(one) for one in due.splitlines() if one.strip()):
            if sum(tells(one, line, DIGITS, ROUNDED) for one in seen) != 1:
                yield message("wrong.missing", name=rounded(line))


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


def _plain(line: str) -> str:
    return line.strip().replace("{,}", ",")


class _Due(NamedTuple):
    """What the report must say of a linkage."""

    study: LinkageStudy
    comparison: MotionComparison
    extremes: bool

    def lines(self, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[str]:
        """Give the lines, their numbers with all digits."""
        yield from self._data()
        yield from self._structure()
        if self.extremes:
            yield from self._travel()
        yield from self._conditions()
        yield from self._plans(leaves)

    def _say(self, key: str, **parts: object) -> str:
        return word(self.study.language, f"report.{key}", **parts)

    def _full(self, value: float) -> str:
        return number(value, self.study.language, ALL_DIGITS)

    @property
    def _formula(self) -> Formula:
        return Formula(drafting_of(self.study.scene))

    def _data(self) -> Iterator[str]:
        mechanism, letters = self.study.mechanism, self._formula
        for link in mechanism.links.values():
            name = str(link.number) if link.number != FRAME else self._say("frame")
            yield f"| {name} | {', '.join(f'${letters.line(point)}$' for point in link.points)} |"
        given = self.study.form.mechanism
        sizes = (
            f"${letters.letter(f'l_{{{name}}}')} = {letters.quantity(1000 * float(size), 'mm')}$"
            for name, size in given.lengths.items()
        )
        if given.lengths:
            yield self._say("lengths", lengths=", ".join(sizes))
        places = {name: [float(str(part)) for part in place] for name, place in given.frame.items()}
        told = (rf"${letters.line(name)} {self._spot(place)}$" for name, place in places.items())
        yield self._say("fixed_points", points=", ".join(told))
        for slide in (one for one in mechanism.slides if one.label):
            line = message("report.line_of", owner=slide.owner, line=f"${letters.line(slide.label)}$")
            yield self._say("slide", link=slide.slider, line=line, point=f"${letters.line(slide.point)}$")
        yield self._drive()
        if mechanism.drive.ram is not None:
            yield self._cylinder(mechanism.drive.ram)

    def _spot(self, place: Sequence[float]) -> str:
        x, y = (self._formula.number(1000 * part) for part in place)
        return rf"({x}; {y})\text{{ {lettered(self.study.language, 'mm')}}}"

    def _drive(self) -> str:
        drive, turn = self.study.mechanism.drive, self.study.turn
        rates = (np.ravel(rate) * drive.unit for rate in self.comparison.road.rates(turn.phi))
        told = dict(zip(("omega", "epsilon"), map(self._span, rates), strict=True))
        return self._say("drive_way" if drive.pushed else "drive", link=drive.link, count=len(turn), **told)

    def _cylinder(self, ram: Ram) -> str:
        """Tell the law of the cylinder that drives, by its lengths over the stroke."""
        lengths, *law = stroke_of(self.study.mechanism, len(self.study.turn))
        told = dict(zip("va", map(self._span, law), strict=True))
        stroke = " … ".join(self._full(1000 * float(end)) for end in lengths[[0, -1]])
        return self._say("cylinder", line=f"{ram.foot}{ram.point}", stroke=stroke, **told)

    def _span(self, rates: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> str:
        """Write the least and the greatest rate, once where they are written alike."""
        ends = [float(rates.min()), float(rates.max())]
        alike = number(ends[0], self.study.language) == number(ends[1], self.study.language)
        return " … ".join(self._full(end) for end in (ends[:1] if alike else ends))

    def _structure(self) -> Iterator[str]:
        mechanism, groups, language = self.study.mechanism, self.study.groups, self.study.language
        for pair in pairs(mechanism, groups):
            kind = self._say("turning_pair" if pair.joint in mechanism.hinges else "sliding_pair")
            yield f"| {pair.key} | {kind} | {pair.point} |"
        n, p = len(mechanism.links) - 1, sum(len(own) - 1 for own in mechanism.hinges.values()) + len(mechanism.slides)
        yield self._say("counted_pairs", n=n, p=p)
        yield rf"$$W = 3n - 2p_{{5}} - p_{{4}} = 3 \cdot {n} - 2 \cdot {p} - 0 = {3 * n - 2 * p}$$"
        for group, side in zip(groups, self.study.sweep.sides, strict=True):
            yield self._say("group", group=group.label, joints=group.kind, order=group.order, side=f"{side:+.0f}")
        told = formula(mechanism, groups).replace("->", "→")
        yield word(language, "report.formula", formula=told, klass=mechanism_class(groups))

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
        for group in self.study.groups if self.study.nodes.size else ():
            seen = interval(self.study.sweep, group, self.study.nodes)
            low, high = (self._degrees(angle) for angle in (seen.low, seen.high))
            yield self._say("pressure", group=group.label, low=low, high=high)

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
        """Tell the worst condition of each group, and in which position."""
        rows = np.where(self.study.lost, np.nan, notches(self.study)) if self.study.groups else np.empty((0, 0))
        for group, kappas in zip(self.study.groups, rows, strict=True):
            worst = int(np.nanargmax(kappas)) if not np.isnan(kappas).all() else None
            if worst is not None and math.isfinite(kappas[worst]) and kappas[worst] < GRADED:
                yield f"| {group.label} | {self._full(float(kappas[worst]))} | {worst} |  |"

    def _plans(self, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[str]:
        """Tell of which positions plans are drawn, and in which one the pairs; which links do not turn."""
        sheets = [leaf for own in leaves.values() for leaf in own if "shown" in leaf.metadata]
        names = [group.name for leaf in sheets for group in leaf.groups]
        drawn = sorted(int(name.rpartition("-")[2]) for name in names if name.startswith(f"{VELOCITIES.plan}-"))
        order = [k for leaf in sheets for k in leaf.metadata["plans"]]  # as the scene has them
        drawn = order if sorted(order) == drawn else drawn
        if drawn and sheets[0].metadata["shown"] is not None:
            parts = {"count": len(self.study.turn), "shown": sheets[0].metadata["shown"]}
            yield self._say("plans_drawn", plans=", ".join(map(str, drawn)), **parts)
        if VELOCITIES.plan in self.study.made:
            yield from self._still()

    def _still(self) -> Iterator[str]:
        """Tell which links do not turn."""
        still = sorted(n for n, other in self.study.mechanism.turning_with.items() if n != FRAME == other)
        if still:
            yield self._say("still", links=", ".join(map(str, still)))
