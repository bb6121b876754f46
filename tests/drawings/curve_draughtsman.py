"""A draughtsman at curves: every figure drawn by a hand that slips, each from what the same hand drew before."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.grading.allowance import Allowances
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.curves.figure_judge import allowed_of, figure_verdicts
from drawings.grading.curves.figure_records import BEARINGS, LENGTHS, ORDINATES, FigureAsked
from drawings.grading.drawn_plan import Arrow
from drawings.grading.verdict import Verdict
from geometry.board import Board
from geometry.calculus import integral
from plans.model.motion import Complexes, Floats
from tests.draughtsman import Draughtsman, copies

NOWHERE = Arrow(0j, 0j)


def graded_by_hand(figures: tuple[FigureAsked, ...], slip: float, seed: int) -> tuple[Verdict, ...]:
    """Grade a drawing of all figures by a hand that slips by so many mm."""
    hand = _Hand(slip, np.random.default_rng(seed))
    own: dict[str, Complexes] = {}
    drawn: dict[str, list[DrawnFigure]] = {}
    for one in figures:
        own[one.key] = hand.values(one, own)
        there = np.isin(np.arange(len(one.true)), one.places) | (one.kind == ORDINATES)  # between marks by the curve
        values = np.where(there, own[one.key], complex(np.nan, np.nan))
        arrows = dict.fromkeys(one.places.tolist(), NOWHERE)
        drawn.setdefault(one.sheet, []).append(DrawnFigure(one, values, arrows))
    return tuple(figure_verdicts(drawn, figures, (), (), lambda one: allowed_of(one, Allowances(), 0.0)))


class _Hand:
    def __init__(self, slip: float, chance: np.random.Generator) -> None:
        self.slip, self.chance = slip, chance

    def values(self, asked: FigureAsked, own: dict[str, Complexes]) -> Complexes:
        """Draw a figure: by its course from what is measured of those before it, or as it is known."""
        if asked.course is None or not set(asked.behind) <= own.keys():
            return asked.true + self._pricked(asked)
        if asked.stepped:
            return asked.course(own) + 1j * self._chords(asked)
        figures = {one.key: one for one in self.known}
        measured = {key: own[key] + self._pricked(figures[key]) for key in asked.behind}
        return asked.course({**own, **measured}) + self._pricked(asked)

    known: tuple[FigureAsked, ...] = ()

    def _pricked(self, asked: FigureAsked) -> Complexes:
        """Give by how much what lies between two pricked points is out, true units; between marks as at these."""
        x, y = self.chance.uniform(-self.slip, self.slip, (2, 2, len(asked.true))).sum(axis=1) * asked.scale
        places = np.sort(asked.places)
        x, y = (np.interp(np.arange(len(x)), places, row[places]) for row in (x, y))
        if asked.kind == ORDINATES:
            return np.asarray(asked.way * x)
        if asked.kind in (BEARINGS, LENGTHS):
            unit = asked.true / np.abs(asked.true)
            return np.asarray(unit * (1j * x if asked.kind == BEARINGS else x))
        return np.asarray(x + 1j * y)

    def _chords(self, asked: FigureAsked) -> Floats:
        """Give by how much a curve is out whose chords are ruled one after another, true units."""
        assert asked.paper is not None  # of every graph
        wide = np.abs(np.diff(asked.paper.feet))
        rises = np.diff(asked.true.imag) / asked.scale
        pole = 40.0  # mm, as they are usual
        board = integral(Board("chords"), "y", np.concatenate(([0.0], np.cumsum(wide))), rises / wide * pole, pole)
        found = copies(Draughtsman(self.slip, {"chords": np.ones(1)}, 1, self.chance), *board.points)
        off = np.array([(np.ravel(found[one])[0] - np.ravel(one.point)[0]).imag for one in board.points]) * asked.scale
        # Where nothing is marked the value is nothing, and he lets his curve come back to its axis.
        known = np.setdiff1d(np.flatnonzero(np.abs(asked.true) <= 0.1 * asked.scale), asked.places)
        return off - np.interp(np.arange(len(off)), known, off[known]) if len(known) > 1 else off


def drawings(figures: tuple[FigureAsked, ...], slip: float, count: int) -> Iterator[tuple[Verdict, ...]]:
    """Grade several drawings by chance, each of another hand."""
    _Hand.known = figures
    for seed in range(count):
        yield graded_by_hand(figures, slip, seed)
