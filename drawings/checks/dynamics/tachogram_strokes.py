"""The strokes of a tachogram: heading, instants, axes, curve, ends of stages, mean speed (линии тахограммы)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.graphs.figure_strokes import FLUSH, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Polyline, Text
from plans.model.run import RUN_DOWN, RUN_UP, STEADY, Run
from plans.words.words import message, word

TACHOGRAM = "tachogram"
CLOSE = 0.1  # mm: rows that lie nearer are one point of the curve
SHORT = 0.05  # mm: a shorter ordinate is a point
DIGITS = 4
STAGES = {RUN_UP: "run.run_up", STEADY: "run.steady", RUN_DOWN: "run.run_down"}


@dataclass(frozen=True)
class TachogramStrokes:
    """A tachogram on a sheet with the run that it shows: its zero on paper, mm, its scales, s and rad/s a mm."""

    group: Group
    run: Run
    zero: complex
    across: float
    up: float
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(TACHOGRAM, (self.group,))

    def faults(self) -> Iterator[Wrong]:
        """Hold all of it."""
        self._words()
        self._axes()
        self.inventory.take(Polyline, self._follows, on("curve", TACHOGRAM))
        for k in range(len(self.run.stages)):
            self._stage(k)
        self._mean()
        return self.inventory.faults()

    def _on(self, t: float, omega: float = 0.0) -> complex:
        return self.zero + t / self.across + 1j * omega / self.up

    def _words(self) -> None:
        """Hold heading, scales, the instants at which the stages end, the steady speed that is reached."""
        own, title = self.inventory, self.drafting.word("tachogram")
        own.text(title, on("title", TACHOGRAM, text=title))
        lines = scale_line(self.across, "t", "s", self.drafting), scale_line(self.up, "ω", "rad/s", self.drafting)
        under = ";  ".join(lines)
        own.text(under, on("scale_missing", TACHOGRAM, text=under))
        for line in map(read, self._numbers()):
            own.take(
                Text,
                lambda one, line=line: tells(one.plain, line, (DIGITS,)),  # type: ignore[misc]
                message("wrong.missing", name=line.split(" = ")[0]),
            )

    def _numbers(self) -> Iterator[str]:
        number, steady = precise(self.drafting).number, self.run.steady
        instants = (float(self.run.t[stage.last]) for stage in self.run.stages)
        told = ";  ".join(f"t_{k} = {number(instant)}" for k, instant in enumerate(instants, 1))
        yield f"{told} {self.drafting.word('s')}"
        if steady is not None:
            low, high = steady.extremes
            mean, delta = (low + high) / 2, 2 * (high - low) / (high + low)
            yield self.drafting.word("steady speed", mean=number(mean), delta=number(delta))

    def _axes(self) -> None:
        """Hold both axes past all of the run, with their heads and letters."""
        own, wrong, word_of = self.inventory, on("axis_line", TACHOGRAM), self.drafting.word
        reaches = (
            (float(self.run.t[-1]) / self.across, f"t, {word_of('s')}"),
            (
                float(self.run.omega.max()) / self.up,
                f"ω, {word_of('rad/s')}",
            ),
        )
        for way, (reach, letter) in zip((1 + 0j, 1j), reaches, strict=True):
            tip = own.arrow(self.zero, lambda tip, way=way, reach=reach: self._beyond(tip, way, reach), wrong)  # type: ignore[misc]
            if tip is not None:
                own.letter(letter, [tip], on("letter", TACHOGRAM, name=letter))

    def _beyond(self, tip: complex, way: complex, least: float) -> bool:
        gone = (tip - self.zero) / way
        return abs(gone.imag) <= self.inventory.near and gone.real > least

    def _follows(self, one: Polyline) -> bool:
        """Tell whether a thick chain goes through rows of the run alone, never back, from its first to its last."""
        points, rows = np.array(one.points), self.zero + self.run.t / self.across + 1j * self.run.omega / self.up
        if one.style.width != self.drafting.hand.main or (np.diff(points.real) < -FLUSH).any():
            return False
        after = np.clip(np.searchsorted(rows.real, points.real - FLUSH), 0, len(rows) - 1)
        beside = np.min([np.abs(rows[np.clip(after + k, 0, len(rows) - 1)] - points) for k in (-1, 0, 1, 2)], axis=0)
        ends = abs(points[0] - rows[0]), abs(points[-1] - rows[-1])
        return bool((beside <= FLUSH).all()) and max(ends) <= CLOSE

    def _stage(self, k: int) -> None:
        """Hold the end of a stage by tick, thin ordinate and letter; the stage by its name in its middle."""
        own, run, stage = self.inventory, self.run, self.run.stages[k]
        name, end, omega = f"t{k + 1}", float(run.t[stage.last]), float(run.omega[stage.last])
        foot, tip = self._on(end), self._on(end, omega)
        wrong = on("foot", TACHOGRAM, name=name)
        own.tick(foot, wrong)
        if abs(tip - foot) > SHORT:
            line = own.line(foot, tip, wrong)
            if line is not None and line.style.width >= self.drafting.hand.main:
                own.wrong.append(wrong)
        own.letter(name, [foot], on("letter", TACHOGRAM, name=name))
        middle = self._on((float(run.t[stage.first]) + end) / 2, float(run.omega.max()) / 4)
        told = word(self.drafting.language, STAGES[stage.name.replace("-", "_")])
        own.letter(told, [middle], on("letter", TACHOGRAM, name=told))

    def _mean(self) -> None:
        """Hold the mean of the steady motion over the whole run, with its letter."""
        if self.run.steady is None:
            return
        own, mean, last = self.inventory, sum(self.run.steady.extremes) / 2, float(self.run.t[-1])
        letter = read(self.drafting.letter("ω_{st}"))
        line = own.line(self._on(0.0, mean), self._on(last, mean), on("line_named", TACHOGRAM, name=letter))
        if line is not None:
            own.letter(letter, [line.end], on("letter", TACHOGRAM, name=letter))
