"""The notes of a kinematics sheet read back: structure, drive, lengths, stroke, ratio, gaps (проверка пояснений)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from drawings.checks.precise import ALL_DIGITS, KNOWN, rounded, tells
from drawings.checks.reading import NOTES, notes
from drawings.checks.wrong import within
from drawings.lettering.words import fixed, number, runs, word
from drawings.paper.strokes import Leaf, Text
from plans.checks.compare import MotionComparison
from plans.checks.hand.quantity import SLIP
from plans.checks.ram_law import stroke_of
from plans.linkage.pressure import interval
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import Drive
from plans.model.motion import Extremes, Floats
from plans.model.structure import formula, mechanism_class
from plans.words.words import Message

DIGITS = (0, 4)  # of the numbers of notes: fixed decimals, or four digits
MOST = 16  # lengths that a sheet tells


def faults(leaf: Leaf, study: LinkageStudy, comparison: MotionComparison) -> Iterator[Message]:
    """See that each sentence that is due is written, its numbers as the analysis has them."""
    seen = notes(leaf).split()
    if not seen and leaf.metadata["of"] > 1:
        return
    for words in sentences(study, comparison):
        if not among(seen, words):
            yield within("missing_from", NOTES, name=rounded(" ".join(words)))


def sentences(study: LinkageStudy, comparison: MotionComparison) -> Iterator[list[str]]:
    """Give the words of each sentence that is due, their numbers with all digits."""
    for due in _Due(study, comparison).sentences():
        yield Text(0j, due).plain.replace("\N{NO-BREAK SPACE}", " ").split()


def among(seen: list[str], due: list[str]) -> bool:
    """Tell whether a sentence is among words, each of its numbers rounded."""
    return begun(seen, due, DIGITS) is not None


def begun(seen: list[str], due: list[str], digits: Collection[int]) -> int | None:
    """Give where a sentence begins among words, each of its numbers rounded; None where it is not said."""
    true, length = " ".join(due), len(due)
    starts = (k for k, one in enumerate(seen) if one == due[0])
    return next((k for k in starts if tells(" ".join(seen[k : k + length]), true, digits, KNOWN)), None)


class _Due(NamedTuple):
    """What the notes of a study must say, by the analysis."""

    study: LinkageStudy
    comparison: MotionComparison

    @property
    def language(self) -> str:
        return self.study.language

    def sentences(self) -> Iterator[str]:
        """Give the sentences, their numbers with all digits."""
        mechanism, groups = self.study.mechanism, self.study.groups
        n, p = len(mechanism.links) - 1, sum(len(own) - 1 for own in mechanism.hinges.values()) + len(mechanism.slides)
        told = formula(mechanism, groups).replace("->", "→")
        yield word(self.language, "structure", n=n, p=p, w=3 * n - 2 * p, formula=told, klass=mechanism_class(groups))
        yield from self._drive()
        yield from self._lengths()
        extremes = None if self.study.travel is None else self.comparison.road.extremes(self.study.output)
        if extremes is not None:
            yield f"{self._stroke(extremes)};  {self._ratio(extremes)}"
        yield from self._pressures()
        yield from self._gaps()
        if np.isfinite(self.comparison.kappa).any():
            yield word(self.language, "hand note", slip=number(SLIP, self.language))

    def _drive(self) -> Iterator[str]:
        """Tell how the primary link moves."""
        drive = self.study.mechanism.drive
        omega, epsilon = (np.ravel(rate) * drive.unit for rate in self.comparison.road.rates(self.study.turn.phi))
        if drive.ram is not None:
            yield self._cylinder(drive, {"omega": self._span(omega), "epsilon": self._span(epsilon)})
        elif drive.pushed:
            ends = (self._full(1000 * drive.unit * float(phi)) for phi in self.study.turn.phi[[0, -1]])
            rates = {"v": self._span(omega), "a": self._span(epsilon)}
            yield word(self.language, "pushed", point=drive.end, stroke=" … ".join(ends), **rates)
        elif np.any(epsilon):
            told = {"omega": self._span(omega), "epsilon": self._span(epsilon)}
            yield word(self.language, "crank", link=drive.link, **told)
        else:
            yield word(self.language, "even crank", link=drive.link, omega=self._span(omega))

    def _cylinder(self, drive: Drive, rates: Mapping[str, str]) -> str:
        """Tell the law of the cylinder that drives, by its lengths over the stroke."""
        ram = drive.ram
        assert ram is not None  # asked only where there is one
        lengths, *law = stroke_of(self.study.mechanism, len(self.study.turn))
        stroke = " … ".join(self._full(1000 * float(end)) for end in lengths[[0, -1]])
        told = dict(zip("va", map(self._span, law), strict=True))
        line = f"{ram.foot}{ram.point}"
        return word(self.language, "cylinder", link=drive.link, line=line, stroke=stroke, **told, **rates)

    def _lengths(self) -> Iterator[str]:
        """Tell the lengths: as far as the named points of a link are apart, but for those of the sketch's own frame."""
        given = self.study.form.mechanism.lengths
        if 0 < len(given) <= MOST:
            told = (f"l_{{{name}}} = {self._full(1000 * float(size))}" for name, size in given.items())
            yield word(self.language, "lengths", lengths=",  ".join(told))

    def _pressures(self) -> Iterator[str]:
        """Tell between what the pressure angle of each group goes; of one that stays at one value nothing is told."""
        for group in self.study.groups:
            seen = interval(self.study.sweep, group, self.study.nodes)
            ends = math.degrees(seen.low), math.degrees(seen.high)
            if len({fixed(end, self.language) for end in ends}) > 1:
                low, high = map(self._full, ends)
                yield word(self.language, "pressure", group=group.label, low=low, high=high)

    def _stroke(self, extremes: Extremes) -> str:
        if extremes.sliding:
            return word(self.language, "stroke", stroke=self._full(1000 * extremes.stroke))
        return word(
            self.language, "swing", link=self.study.output.link, stroke=self._full(math.degrees(extremes.stroke))
        )

    def _ratio(self, extremes: Extremes) -> str:
        """Tell the time ratio; between two of several reversals there is none."""
        travel = self.study.travel
        if travel is not None and len(travel.rests) > 2:
            return word(self.language, "reversals", count=len(travel.rests))
        key, turned = "overlap faster" if extremes.faster else "overlap", extremes.overlap
        ratio = self._full((math.pi + turned) / (math.pi - turned))
        return word(self.language, key, overlap=self._full(math.degrees(turned)), ratio=ratio)

    def _gaps(self) -> Iterator[str]:
        """Name all positions that have no result, by their reasons."""
        reasons: dict[tuple[str, object], list[int]] = {}
        for gap in self.comparison.construction.gaps:
            reasons.setdefault((gap.reason, gap.where), []).append(gap.position)
        for (reason, where), positions in reasons.items():
            told = word(self.language, reason)
            yield word(self.language, "gap", positions=runs(positions), reason=told, where=where)

    def _full(self, value: float) -> str:
        return number(value, self.language, ALL_DIGITS)

    def _span(self, values: Floats) -> str:
        """Write the least and the greatest of some rates, once where they are written alike."""
        ends = [float(values.min()), float(values.max())]
        alike = number(ends[0], self.language) == number(ends[1], self.language)
        return " … ".join(self._full(end) for end in (ends[:1] if alike else ends))
