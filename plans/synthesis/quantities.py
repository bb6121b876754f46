"""A task of synthesis by both roads: lengths beside closed forms, and what was asked, measured on the drawing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Mark, Reading, behind, between
from plans.analytic.synthesis import analysed, best
from plans.explanation import Explanation, NoMark, explained_by
from plans.model.synthesis import ANALYSIS, EPS, CrankRocker, RockerTask, SliderCrank, Synthesis
from plans.quantity import Comparison, Numbers, Quantity, Shown
from plans.study import Study
from plans.synthesis.chord import SYNTHESIS, Drawn
from plans.synthesis.rocker import PLACED, DrawnRocker
from plans.synthesis.slider import DrawnSlider
from plans.synthesis.study import SynthesisStudy

WEAR = 32.0  # roundings of what is read off several lines


def compare_synthesis(study: SynthesisStudy) -> Comparison:
    """Put every mechanism of every reading by both roads beside each other, and what was asked beside what is drawn."""
    ours, theirs = study.synthesis, analysed(study.task)
    return Comparison(ours, theirs, tuple(_findings(study, theirs)))


def _findings(study: SynthesisStudy, theirs: Synthesis) -> Iterator[Quantity]:
    for number, (first, drawn) in enumerate(_parts(study)):
        known = theirs.readings[0 if isinstance(study.task, RockerTask) else number].found[first:]
        pairs: Sequence[tuple[Drawn, CrankRocker | SliderCrank]] = drawn.found
        for k, (marks, made) in enumerate(pairs):
            other = known[k] if k < len(known) else None
            yield from _Designed(drawn, marks, made, other, suffix(number, k)).quantities()
    if study.sought and isinstance(study.task, RockerTask):
        chosen = study.chosen
        assert isinstance(chosen, CrankRocker)  # the task is of one
        found = max(best(study.task._replace(place=None), side) for side in (1, -1))
        yield Quantity.of((SYNTHESIS, "μ_best", "rad"), (chosen.transmission, found), 10.0**-PLACED)


def _parts(study: SynthesisStudy) -> Iterator[tuple[int, DrawnRocker | DrawnSlider]]:
    """Give each construction with the number of mechanisms of its reading that were found before it."""
    before = 0
    for drawn in study.drawn:
        yield (before if isinstance(drawn, DrawnRocker) else 0), drawn
        before += len(drawn.found)


def suffix(number: int, place: int) -> str:
    """Tell the mechanisms of a task apart: the first has none, those of other constructions a letter.

    >>> suffix(0, 0), suffix(0, 1), suffix(1, 0)
    ('', "'", ',b')
    """
    return "'" * place + (f",{letter_of(number)}" if number else "")


def letter_of(number: int) -> str:
    """Letter a construction of a task.

    >>> letter_of(0), letter_of(2)
    ('a', 'c')
    """
    return "abcdefgh"[number]


class _Designed(NamedTuple):
    """A mechanism by both roads, and the record that it was read off."""

    drawn: DrawnRocker | DrawnSlider
    marks: Drawn
    ours: CrankRocker | SliderCrank
    theirs: CrankRocker | SliderCrank | None
    suffix: str

    def quantities(self) -> Iterator[Quantity]:
        """Compare its lengths, then what was asked of it."""
        for letter, name, shown in self._lengths:
            other = math.nan if self.theirs is None else getattr(self.theirs, name)
            yield self._of(letter, "m", (getattr(self.ours, name), other), self.slack, shown)
        yield from self._angles()

    @property
    def _lengths(self) -> tuple[tuple[str, str, Shown | None], ...]:
        # A similar mechanism is drawn with a crank of length 1: its lengths are not read off.
        marks = (self.marks.crank, self.marks.coupler) if "B_1" in self.drawn.board else (None, None)
        rocker = isinstance(self.ours, CrankRocker)
        crank, coupler = ("l_1", "crank", marks[0]), ("l_2", "coupler" if rocker else "rod", marks[1])
        return crank, coupler, ("l_4", "frame", None) if rocker else ("e", "offset", None)

    def _angles(self) -> Iterator[Quantity]:
        """Measure the overlap on the drawing, and the angles that tell how well the force is led."""
        task, theirs = self.drawn.task, self.theirs
        if "B_1" in self.drawn.board:
            both = [self.drawn.board[name] for name in ("B_1", "B_2")]
            far, near = (complex(between(self.marks.pivot, end)) for end in both)
            asked = task.overlap if task.overlap is not None else getattr(theirs, "overlap", math.nan)
            yield self._of("θ", "rad", (abs(np.angle(near / far)), asked), self._turned(abs(near)), self._seen(*both))
        if isinstance(self.ours, CrankRocker) and (theirs is None or isinstance(theirs, CrankRocker)):
            other = math.nan if theirs is None else theirs.transmission
            flat = math.sin(self.ours.transmission) * min(self.ours.coupler, self.ours.rocker)
            yield self._of("μ_min", "rad", (self.ours.transmission, other), self._turned(flat))
        if isinstance(self.ours, SliderCrank) and (theirs is None or isinstance(theirs, SliderCrank)):
            other = math.nan if theirs is None else theirs.pressures[1]
            flat = math.cos(self.ours.pressures[1]) * self.ours.rod
            yield self._of("α_max", "rad", (self.ours.pressures[1], other), self._turned(flat))

    def _seen(self, stretched: Mark, folded: Mark) -> Reading:
        """Give how the overlap is read: the way to B2, and that to B1 turned into it."""
        board, name = self.drawn.board, self.marks.pivot.name
        far, near = (board[f"{name}{one.name}"] for one in (stretched, folded))
        way = complex(near.point) / abs(complex(near.point))
        turned = board.turn(f"{name}:θ", far, way / complex(far.point))
        return Reading(turned, board.turn(f"{name}:w", near, 1 / abs(complex(near.point))))

    @property
    def slack(self) -> float:
        """How far rounding may move a length, m: more where loci meet flatly."""
        met = (mark.meeting for mark in behind(self.marks.coupler) if mark.meeting is not None)
        sharp = min((float(np.abs(np.asarray(one.sharpness))) for one in met), default=1.0)
        points = (abs(complex(mark.point)) for mark in self.drawn.board if not isinstance(mark.value, tuple))
        arcs = [self.ours.crank, max(points)]
        return WEAR * EPS * sum(arcs) / sharp

    def _turned(self, arm: float) -> float:
        return WEAR * EPS + self.slack / arm

    def _of(self, letter: str, unit: str, pair: tuple[Any, Any], off: float, shown: Shown | None = None) -> Quantity:
        return Quantity.of((SYNTHESIS, f"{letter}{self.suffix}", unit), pair, off, shown=shown)


def numbers(study: Study, by: str) -> Numbers:
    """Give by a road every mechanism of every reading as plain data."""
    ours = study.of(SynthesisStudy)
    found = analysed(ours.task) if by == ANALYSIS else ours.synthesis
    rows = [
        {"demands": list(reading.kept), "mechanisms": [told(one) for one in reading.found]}
        for reading in found.readings
    ]
    return Numbers({"scene": study.scene.heading(), "by": by, SYNTHESIS: rows})


def told(made: CrankRocker | SliderCrank) -> dict[str, Any]:
    """Give a mechanism as plain data, SI."""
    if isinstance(made, SliderCrank):
        sizes = {"crank": made.crank, "rod": made.rod, "offset": made.offset}
        return {**sizes, "stroke": made.stroke, "overlap": made.overlap, "pressure": list(made.pressures)}
    names = "crank", "coupler", "rocker", "frame"
    pivot = [made.pivot.real, made.pivot.imag]
    return {**dict(zip(names, made.lengths, strict=True)), "pivot": pivot, "transmission": made.transmission}


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark: places and lengths are metres."""
    found = explained_by(study.comparison(SYNTHESIS).findings, position, name)
    return found._replace(units={SYNTHESIS: "m"}) if isinstance(found, Explanation) else found
