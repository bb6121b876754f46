"""Judging a plan: each vector held against the analysis, and a mistake found is named once (разбор ошибок)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from drawings.grading import verdict
from drawings.grading.asked import Slip, VectorAsked
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.verdict import Verdict
from drawings.paper.limits import SEEN
from geometry.board import Board, Mark
from geometry.errors import DraftError
from geometry.replay import redraw

SIMILARITIES = ("turn", "similar")  # verbs that carry a figure over


def continued(target: Mark, drawn: Mapping[Mark, complex]) -> complex | None:
    """Give where a mark lies if it is drawn as the record draws it, from another's places of what is before it.

    >>> board = Board("velocities")
    >>> pole, a, ab = board.given("p", 0j), board.given("a", 3 + 0j), board.given("ab", 1j)
    >>> continued(board.lay_off("b", a, ab), {a: 2j})
    3j
    """
    givens = {mark: value for mark, value in drawn.items() if mark is not target}
    return spot_of(redraw([target], givens)[target])


def mirrored(target: Mark, drawn: Mapping[Mark, complex]) -> complex | None:
    """Give where a mark lies whose figure is carried over mirrored; None of one that no figure gives."""
    if target.step.op != "lay_off" or target.step.inputs[1].step.op not in SIMILARITIES:
        return None
    origin, vector = target.step.inputs
    base = vector.step.inputs[0]
    again = redraw([origin, base, vector], {mark: value for mark, value in drawn.items() if mark is not target})
    start, along, there = (spot_of(again[mark]) for mark in (origin, base, vector))
    if start is None or along is None or there is None or along == 0:
        return None
    return start + along * (there / along).conjugate()


def turned_over(meeting: Mark) -> complex | None:
    """Give the other of the two places where the loci of a mark meet; None of one that meets but once."""
    if meeting.step.op != "meet" or not np.any(meeting.step.side):
        return None
    first, second = meeting.step.inputs
    other = Board(meeting.subject).meet(meeting.name, first, second, -meeting.step.side)
    return spot_of(other)


def spot_of(mark: Mark) -> complex | None:
    """Give where a mark lies, if it is a place and known."""
    try:
        value = complex(np.asarray(mark.point).reshape(-1)[0])
    except (DraftError, TypeError):
        return None
    return value if cmath.isfinite(value) else None


def mistaken(force: Mark, drawn: Mapping[Mark, complex]) -> Iterator[Slip]:
    """Give what a force found by moments is by one mistake in them, from what the student has drawn before.

    >>> from geometry.board import Board
    >>> board = Board("forces")
    >>> at, up = board.given("D", 2 + 0j), board.given("up", 1j)
    >>> load = board.moment("C(G)", board.given("C", 0j), board.given("S", 1 + 0j), board.given("G_4", -10j))
    >>> twist, line = board.given("M^Φ_4", 4.0), board.parallel("line", at, up)
    >>> force = board.balance("R", board["C"], line, load, twist)
    >>> [(one.kind, one.of, abs(one.value)) for one in mistaken(force, {})]
    [('moment', 'G_4', 7.0), ('forgotten', 'G_4', 2.0), ('couple', 'M^Φ_4', 7.0), ('forgotten', 'M^Φ_4', 5.0)]
    """
    if force.step.op != "balance":
        return
    terms = force.step.inputs[2:]
    again = redraw(list(terms), drawn)
    for term in terms:
        moment, forced = np.ravel(again[term].point)[0], term.step.op == "moment"
        name = term.step.inputs[2].name if forced else term.name  # what has the moment: a force, or a couple
        for kind, value in ((verdict.MOMENT if forced else verdict.COUPLE, -moment), (verdict.FORGOTTEN, 0 * moment)):
            if (there := continued(force, {**drawn, term: complex(value)})) is not None:
                yield Slip(kind, there, name)


# Parts whose turning to the wrong side has a name of its own, by how their letters begin.
PARTS = {
    "a^n": verdict.NORMAL, "a^k": verdict.CORIOLIS,
    "Φ": verdict.INERTIA, "G": verdict.UPWARD, "R": verdict.REACTION,
}  # fmt: skip
# A plan is drawn to another scale, mirrored or turned as a whole where so many of its vectors say so.
SEVERAL = 2


@dataclass(frozen=True)
class Judge:
    """Judges the vectors of one drawn plan: what each may be out, and what is drawn on all plans of the position."""

    drawn: DrawnPlan
    allowed: Mapping[tuple[str, str], float]
    places: Mapping[Mark, complex]
    without: Mapping[Mark, complex] = field(default_factory=dict)  # what he has left out

    def verdicts(self) -> Iterator[Verdict]:
        """Judge the plan as a whole, then each vector that is asked for."""
        if (whole := self._whole()) is not None:
            yield self._said(whole[0])
            yield from (self._within(vector, whole[1]) for vector in self.drawn.asked.vectors)
            return
        blamed = set[str]()  # a place that is wrong costs once, at the first arrow that ends there
        for vector in sorted(self.drawn.asked.vectors, key=lambda vector: vector.auxiliary):
            said = self._verdict(vector)
            if not said.good and said.kind not in (verdict.MISSING, *verdict.UNGRADED):
                places = self._places(vector)
                if places & blamed:
                    said = said._replace(kind=verdict.FOLLOWS)
                blamed |= places
            yield said

    def _places(self, vector: VectorAsked) -> set[str]:
        """Give the places that a wrong arrow may have from another: its end, or where the sides that close meet."""
        if vector.letter:
            side = vector.found.side if vector.found is not None else None
            return {corner.name for corner in side or () if corner.step.op == "meet"}
        return {vector.end} if self._joined(vector) else set()

    def _joined(self, vector: VectorAsked) -> bool:
        """Tell whether an arrow is drawn between the places of its letters, as its plan has them."""
        there, value = self.drawn.between(*vector.letters), self.drawn.value(vector.letters)
        return there is not None and value is not None and abs(there - value) <= self.allowed[vector.letters]

    def _within(self, vector: VectorAsked, times: Callable[[complex], complex]) -> Verdict:
        """Judge a vector of a plan that is out as a whole: what fits with the others loses nothing more."""
        value = self.drawn.value(vector.letters)
        if value is not None and self._near(vector, times(value)):
            return self._said(verdict.FOLLOWS, vector)
        return self._verdict(vector)

    def _verdict(self, vector: VectorAsked) -> Verdict:
        value, allowed = self.drawn.value(vector.letters), self.allowed[vector.letters]
        if not math.isfinite(allowed):
            return self._said(verdict.DEAD, vector)
        if value is None:
            covered = verdict.FOLLOWS if self.drawn.is_covered(vector) else verdict.MISSING
            return self._said(verdict.SMALL if self.drawn.is_small(vector) else covered, vector)
        off = abs(value - vector.true)
        if self._near(vector, value):
            return self._said(verdict.RIGHT, vector, off)
        if self._follows(vector, value):
            return self._said(verdict.FOLLOWS, vector, off)
        if self.drawn.is_small(vector) and abs(value) < 2 * SEEN * self.drawn.scale:  # one of several as short
            return self._said(verdict.SMALL, vector)
        slip = self._nearest(vector, value, vector.found.slips) if vector.found is not None else None
        if slip is None and vector.found is not None:
            # What is simply turned round may lie near one of them: it is that one only where it is twice as near.
            than = abs(value + vector.true) / 2 if self._near(vector, -value) else math.inf
            slip = self._nearest(vector, value, tuple(mistaken(vector.found.span.end, self.places)), than)
        if slip is not None:
            return self._said(slip.kind, vector, off)._replace(of=slip.of)
        return self._said(self._kind(vector, value), vector, off)

    def _nearest(
        self, vector: VectorAsked, value: complex, slips: tuple[Slip, ...], than: float = math.inf
    ) -> Slip | None:
        """Give the mistake that a vector is drawn by, the nearest of those that are known of it and nearer `than`."""
        near = [slip for slip in slips if abs(value - slip.value) <= min(self.allowed[vector.letters], than)]
        return min(near, key=lambda slip: abs(value - slip.value), default=None)

    def _kind(self, vector: VectorAsked, value: complex) -> str:
        if self._near(vector, -value):
            back = "" if vector.found is None else vector.found.back
            return back or PARTS.get(vector.name.partition("_")[0], verdict.REVERSED)
        if self._carried_mirrored(vector, value):
            return verdict.SIMILAR
        other = None if vector.found is None else turned_over(vector.found.span.end)  # where its loci meet again
        if vector.start == "" and other is not None and abs(value - other) <= self.allowed[vector.letters]:
            return verdict.BRANCH
        allowed = self.allowed[vector.letters]
        if not vector.start and not vector.letter:  # a point
            return verdict.WRONG
        if value and abs(vector.true) > allowed and abs((value / vector.true).imag) * abs(vector.true) <= allowed:
            return verdict.LONG if (value / vector.true).real > 0 else verdict.WRONG
        return verdict.TURNED if abs(abs(value) - abs(vector.true)) <= allowed else verdict.WRONG

    def _near(self, vector: VectorAsked, value: complex) -> bool:
        return abs(value - vector.true) <= self.allowed[vector.letters]

    def _is_due(self, vector: VectorAsked, value: complex) -> bool:
        """Tell whether a vector is right, or what the student's other plans give; a free one also what his own give."""
        if self._near(vector, value) or vector.letter:
            return self._near(vector, value) or self._follows(vector, value)
        here = {mark for vector in self.drawn.asked.vectors if vector.found is not None for mark in vector.found.span}
        before = {mark: place for mark, place in self.places.items() if mark not in here}
        return any(abs(value - there) <= self.allowed[vector.letters] for there in self._going_on(vector, before))

    def _follows(self, vector: VectorAsked, value: complex) -> bool:
        """Tell whether a vector is what its own construction gives from what the student drew before it."""
        ways = (self.places, {**self.places, **self.without}) if self.without else (self.places,)
        gone = (there for places in ways for there in self._going_on(vector, places))
        return any(abs(value - there) <= self.allowed[vector.letters] for there in gone)

    def _going_on(self, vector: VectorAsked, places: Mapping[Mark, complex]) -> Iterator[complex]:
        """Give what a vector is where the later of its ends is found by its construction from the student's places."""
        if vector.found is None:
            return
        later, sign = max((vector.found.span.start, -1), (vector.found.span.end, 1), key=lambda end: end[0].number)
        earlier = vector.found.span.end if sign < 0 else vector.found.span.start
        there, begun = continued(later, places), places.get(earlier, complex(np.ravel(earlier.point)[0]))
        if there is not None:
            yield sign * (there - begun)

    def _carried_mirrored(self, vector: VectorAsked, value: complex) -> bool:
        if vector.found is None:
            return False
        start, end = vector.found.span
        there = mirrored(end, self.places)
        return there is not None and abs(value - (there - self.places.get(start, 0j))) <= self.allowed[vector.letters]

    def _whole(self) -> tuple[str, Callable[[complex], complex]] | None:
        """Tell in what a plan is out as a whole, and how its vectors become right then."""
        pairs = [(vector, value) for vector in self.drawn.asked.vectors if (value := self.drawn.value(vector.letters))]
        if sum(not self._near(vector, value) for vector, value in pairs) < SEVERAL:
            return None
        for kind, times in _wholes([(vector.true, value) for vector, value in pairs]):
            fits = [vector for vector, value in pairs if self._near(vector, times(value))]
            telling = [vector for vector, value in pairs if vector in fits and not self._is_due(vector, value)]
            if len(telling) >= SEVERAL and 2 * len(fits) > len(pairs):
                return kind, times
        return None

    def _said(self, kind: str, vector: VectorAsked | None = None, off: float | None = None) -> Verdict:
        said = Verdict(*self.drawn.asked.place, "", kind, off, unit=self.drawn.asked.unit)
        if vector is None:
            return said
        arrow, allowed = self.drawn.arrows.get(vector.letters), self.allowed[vector.letters]
        at = arrow and (arrow.start, arrow.end)
        return said._replace(name=vector.name, allowed=allowed, at=at, letters=vector.letters)


def _wholes(pairs: list[tuple[complex, complex]]) -> Iterator[tuple[str, Callable[[complex], complex]]]:
    """Give what may be wrong with a plan as a whole, and what undoes it: all the other way, a scale, a turn, a mirror.

    `pairs` are the true and the drawn vectors.
    """
    yield verdict.OPPOSITE, lambda value: -value
    times = _fitted(pairs)
    if times and math.isfinite(abs(times)):
        real, unit = abs(times), times / abs(times)
        yield verdict.SCALE, lambda value: value * real
        yield verdict.ASKEW, lambda value: value * unit
    turn = _fitted([(true, value.conjugate()) for true, value in pairs])
    if turn:
        unit_turn = cmath.rect(1.0, cmath.phase(turn))
        yield verdict.MIRRORED, lambda value: unit_turn * value.conjugate()


def _fitted(pairs: list[tuple[complex, complex]]) -> complex:
    """Give the number that brings drawn vectors onto true ones, by least squares."""
    size = sum(abs(value) ** 2 for _, value in pairs)
    return sum((true * value.conjugate() for true, value in pairs), 0j) / size if size else 0j
