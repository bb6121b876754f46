"""The self-check of the graph of the balancing moment and of hodographs: axes, curves, numbers (проверка графиков)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from drawings.checks.forces.laid_scheme import FINE
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.graphs.scale_line import scale_text
from drawings.checks.letters import NEAREST
from drawings.checks.wrong import Wrong, on
from drawings.lettering.words import word
from drawings.symbols.symbols import TICK
from plans.model.motion import Complexes, Floats

CHORD = 0.1  # mm: a third of a thin line; a curve of half degrees is no further from its chords
ALIKE = 1e-6  # mm: places so near are one
TALLEST = 2.0  # times the largest of the positions: towards a gap a curve is not followed further
NUMBERED = 2  # numbers without which a curve is none over positions


def near_curve(strokes: FigureStrokes, spots: Complexes) -> Floats:
    """Give how far places are from the curves of a figure, mm, (N,)."""
    off = np.full(len(spots), np.inf)
    for chain in strokes.chains:
        points = np.array([*chain.points, *(chain.points[:1] if chain.closed else ())])
        start, run = points[:-1], np.diff(points)
        keep = np.abs(run) > 0
        start, run = start[keep], run[keep]
        if len(start):
            along = np.clip(((spots[:, None] - start) / run).real, 0.0, 1.0)
            off = np.minimum(off, np.abs(spots[:, None] - start - along * run).min(axis=1))
    return off


def numbers(plan: str, strokes: FigureStrokes, feet: Complexes, shown: int, skipped: Sequence[str]) -> Iterator[Wrong]:
    """Hold that each number stands beside its own place, that of the shown position among them, and none is shifted.

    Where places are crowded a number may be nearer to another one; all of them together are nearest to their own.
    """
    known = np.isfinite(feet)
    told = [int(one) for one in strokes.labels if re.fullmatch(r"\d+", one) and one not in skipped]
    strangers = [k for k in told if k >= len(feet) or not known[k]]
    own = [k for k in told if k not in strangers]
    yield from (on("stranger_on", plan, name=str(k)) for k in strangers)
    off = np.array([[strokes.far(str(k), [complex(spot)]) for spot in feet[own]] for k in own]).reshape(
        len(own), len(own)
    )
    yield from (on("differs_on", plan, name=str(own[j])) for j in np.flatnonzero(off.diagonal() > NEAREST))
    shifts = [sum(off[j, (j + step) % len(own)] for j in range(len(own))) for step in (1, -1)]
    if own and off.trace() > min(shifts) + ALIKE:
        yield on("differs_on", plan, name=", ".join(map(str, own)))
    if known[shown] and shown not in told:
        yield on("letter", plan, name=str(shown))
    if known.sum() > NUMBERED and len(told) < NUMBERED:
        yield on("letter", plan, name="0")


@dataclass(frozen=True)
class TurnGraph:
    """The graph of what balances the drive: its strokes, its scales, what it must show at positions and between."""

    strokes: FigureStrokes
    along: float  # degrees, or metres, a mm
    up: float
    axis: tuple[str, str]
    quantity: tuple[str, str]  # letter and unit
    turned: Floats  # of the positions
    sizes: Floats
    between: Floats
    values: Floats
    slack: float
    shown: int
    how: tuple[str, str]

    PLAN = "balancing"

    def faults(self) -> Iterator[Wrong]:
        """Hold axes with their letters and scales, the points of positions, the curve, the numbers."""
        language, _ = self.how
        across = next((one for one in self.strokes.pointings if _level(one.tip - one.start) > 0), None)
        rising = next((one for one in self.strokes.pointings if _level((one.tip - one.start) / 1j) > 0), None)
        if across is None or rising is None:
            yield on("line", self.PLAN)
            return
        letter, unit = self.quantity
        for text, tip in ((self.axis[0], across.tip), (letter, rising.tip), (word(language, unit), rising.tip)):
            if not self.strokes.lettered(text, [tip]):
                yield on("letter", self.PLAN, name=read(text))
        symbol = letter.split("_")[0]
        for scale in (
            scale_text(self.along, *self.axis, self.how),
            scale_text(self.up, symbol, unit, self.how),
        ):
            if not any(scale in text for text in self.strokes.texts):
                yield on("scale_missing", self.PLAN, text=scale)
        yield from self._curve(complex(rising.start.real, across.start.imag))

    def _curve(self, zero: complex) -> Iterator[Wrong]:
        feet = self._feet(zero)
        tips = feet + 1j * self.sizes / self.up
        known = np.isfinite(tips)
        near = CHORD + self.slack / self.up
        if (near_curve(self.strokes, tips[known]) > near).any() or (
            near_curve(self.strokes, self._dense(zero)) > near
        ).any():
            yield on("curve", self.PLAN)
        skipped = [str(len(self.turned))]
        told = [k for k in np.flatnonzero(known) if str(k) in self.strokes.labels]
        dots = np.array([one.centre for one in self.strokes.circles])
        for k in told:
            if not len(dots) or np.abs(dots - tips[k]).min() > FINE + self.slack / self.up:
                yield on("differs_at", self.PLAN, name=str(k), position=int(k))
            ticks = self.strokes.through(complex(feet[k]), 1j, FINE)
            if not any(min(abs(one.start - feet[k]), abs(one.end - feet[k])) > TICK / 2 for one in ticks):
                yield on("line", self.PLAN)
        if known.any():
            yield from numbers(self.PLAN, self.strokes, feet, self.shown, skipped)

    def _feet(self, zero: complex) -> Complexes:
        """Give the feet of the positions on paper."""
        return np.asarray(zero + self.turned / self.along)

    def _dense(self, zero: complex) -> Complexes:
        """Give the places between positions that the curve must go through."""
        most = TALLEST * np.nanmax(np.abs(self.sizes), initial=0.0)
        kept = np.abs(self.values) <= (most if np.isnan(self.values).any() else np.inf)
        return np.asarray(zero + self.between[kept] / self.along + 1j * self.values[kept] / self.up)


@dataclass(frozen=True)
class ReactionHodograph:
    """A hodograph of a reaction: its strokes, its pole and scale, what it must show at positions and between."""

    plan: str
    strokes: FigureStrokes
    pole: complex
    mu: float
    ends: Complexes
    between: Complexes
    slack: float
    shown: int
    letter: str

    def faults(self) -> Iterator[Wrong]:
        """Hold the curve, the points of the positions with their numbers, the vector of the shown one."""
        spots = self.pole + self.ends / self.mu
        known, near = np.isfinite(spots), CHORD + self.slack / self.mu
        most = TALLEST * np.nanmax(np.abs(self.ends), initial=0.0)
        kept = np.abs(self.between) <= (most if np.isnan(self.between).any() else np.inf)
        dense = self.pole + self.between[kept] / self.mu
        if (near_curve(self.strokes, np.concatenate([spots[known], dense])) > near).any():
            yield on("curve", self.plan)
        if known.any():
            yield from numbers(self.plan, self.strokes, spots, self.shown, ())
        if known[self.shown]:
            yield from self._vector(complex(spots[self.shown]), near)

    def _vector(self, end: complex, near: float) -> Iterator[Wrong]:
        if abs(end - self.pole) <= CHORD:
            return
        seen = (one for one in self.strokes.pointings if abs(one.start - self.pole) <= near)
        if not any(abs(one.tip - end) <= near for one in seen):
            yield on("missing_on", self.plan, name=read(self.letter))
        if not self.strokes.lettered(self.letter, [self.pole + (end - self.pole) * k / 10 for k in range(11)]):
            yield on("letter", self.plan, name=read(self.letter))


def _level(run: complex) -> float:
    """Give how far a level run goes to the right, mm; 0 of one that is not level."""
    return run.real if abs(run.imag) <= FINE else 0.0
