"""The self-check of a balance in the report: its sentences and all cells of its tables (проверка отчёта)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance_words.balance_sentences import BalanceSentences
from drawings.checks.balance_words.bounds import in_positions, of_largest
from drawings.checks.balance_words.report_lines import head, listed, table, wrong_chapter
from drawings.checks.balance_words.sentences import SIGNED, TURNS, Sentence, is_line, number
from drawings.checks.documents_old import chapters
from drawings.checks.note.lines import in_report
from drawings.checks.precise import KNOWN
from drawings.lettering.balance_letters import CENTRE, FORCE, MOMENT
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from plans.balance.weights import line_of
from plans.forces.cut import indices
from plans.forces.primary import BALANCING
from plans.model.balance.linkage import DISC, Choice, Counterweight, State
from plans.model.kinetostatics import NOTHING
from plans.study import Study
from plans.words.words import Message, message, word

if TYPE_CHECKING:
    from drawings.paper.strokes import Leaf

DIGITS, OF_GIVEN, OF_SHARES, OF_CHANGES, SAID = 10, 4, 6, 3, 5  # of numbers; the last of those said first
NOTHING_THERE = "—"


def faults(text: str, study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Iterator[Message]:
    """Give what the report tells of a balance otherwise than the analysis (row of the table of reports)."""
    yield from _ReportedBalance(study).faults(text)


def headline(study: Study) -> Callable[[str], bool] | None:
    """Give what tells whether a line says what is put on the links, and what it costs; None where nothing is."""
    own = BalanceSentences(_ReportedBalance(study).expected, SAID)
    due = [Sentence(in_report(note)) for note in (*own.put_on(), *own.price())]
    return (lambda line: is_line(line, due)) if due else None


@dataclass(frozen=True)
class _ReportedBalance:
    """What must be told of a study's balance."""

    study: Study

    @cached_property
    def expected(self) -> Expected:
        own = self.study["balance"]
        drafting = drafting_of(self.study.scene)._replace(reactions=own.statics.form.sheet.reactions)
        return Expected(own, self.study.comparison("balance"), drafting, 0, Measured((), ()))

    @cached_property
    def _sentences(self) -> BalanceSentences:
        return BalanceSentences(self.expected, DIGITS)

    def _said(self, key: str) -> str:
        return word(self.study.scene.sheet.language, key)

    def _word(self, key: str, **parts: object) -> str:
        return self.expected.drafting.word(key, **parts)

    def faults(self, text: str) -> Iterator[Message]:
        """Hold each chapter, and what is told to be left out."""
        told = dict(self._chapters())
        for name, lines in told.items():
            alike = 1 + (name == "counterweights" and "rotor" in self.study.techniques)
            yield from wrong_chapter(text, [*head(self._said(f"report.{name}")), *lines], alike)
        shares = self._said("report.shares")
        if self.expected.balance.shares is None and shares in text:
            yield message("wrong.told", text=shares)
        once = [name for name in told if name != "counterweights" or "rotor" not in self.study.techniques]
        yield from chapters.faults(text, self.study.scene.sheet.language, [*once, "left_out", "balance_left_out"])

    def _chapters(self) -> Iterator[tuple[str, list[Sentence]]]:
        balance, told = self.expected.balance, list(map(listed, self._sentences.counterweights()))
        yield "balancing", [*self._given(), *map(listed, self._sentences.points.told())]
        if told:
            yield "counterweights", [*told, *(self._counterweights() if balance.counterweights else ())]
        yield "balance_costs", list(self._costs())
        if balance.shares is not None:
            yield "shares", [*map(listed, self._sentences.choice()), *self._shares()]
        yield "mass_centre", list(self._centres())

    def _given(self) -> Iterator[Sentence]:
        """Give what is asked, and the masses, unless the chapters on forces tell them."""
        yield Sentence(self._said(f"report.aim_{self.expected.balance.task.aim}"))
        if "forces" in self.study.techniques:
            return
        for link, body in sorted(self.expected.own.machine.bodies.items()):
            sizes = {"mass": body.mass, "inertia": body.inertia, "x": body.centre.real, "y": body.centre.imag}
            told = {name: number(value, 0.0, OF_GIVEN) for name, value in sizes.items()}
            yield Sentence(word(self.study.scene.sheet.language, "report.body", link=link, **told))

    def _heads(self, heads: Sequence[tuple[str, str]]) -> list[str]:
        """Write heads with their units."""
        return [f"{name}, {self._word(unit)}" if unit else name for name, unit in heads]

    def _counterweights(self) -> Iterator[Sentence]:
        names = [self._word(key) for key in ("counterweight column", "on link", "from", "shape")]
        sizes = [("m·a", "kg*m"), ("m", "kg"), ("a", "m"), ("∠, °", ""), (names[3], ""), ("R", "m"), ("b", "m")]
        heads = [*names[:3], *self._heads([*sizes, ("J", "kg*m2")])]
        yield from table(heads, map(self._counterweight, self.expected.balance.counterweights))

    def _counterweight(self, one: Counterweight) -> list[str]:
        first = [in_report(f"m_{self._word('counterweight index')}{one.link}"), str(one.link), one.begin]
        if not one.needed:
            return [*first, "0", "0", *[NOTHING_THERE] * 6]
        turned = one.moment / line_of(self.expected.mechanism, one.link, one.begin)
        angle = number(math.degrees(cmath.phase(turned)), math.degrees(2 * KNOWN), DIGITS, TURNS)
        whole = number(math.degrees(2 * one.place.half_angle), 0.0, OF_GIVEN)
        shape = self._word("disc") if one.place.shape == DISC else self._word("sector", angle=whole)
        ours = [abs(one.moment), one.mass, one.distance]
        sizes = [one.outer, one.place.thickness, one.inertia]
        told = [[number(value, KNOWN * value, DIGITS) for value in row] for row in (ours, sizes)]
        return [*first, *told[0], angle, shape, *told[1]]

    def _costs(self) -> Iterator[Sentence]:
        before, after = self.expected.balance.before, self.expected.after
        keys = ("before column", *(("after column", "change column") if after is not None else ()))
        heads = [self._word("largest value", count=before.count), *map(self._word, keys)]
        was, now = dict(self._largest(before)), {} if after is None else dict(self._largest(after))
        rows = ([name, *self._change(*one, now.get(name))] for name, one in was.items())
        yield from table(heads, rows)

    def _largest(self, state: State) -> Iterator[tuple[str, tuple[str, float, float]]]:
        """Give what is largest in a state by its row: the name of its finding, its value, what is but rounding."""
        before, reach = self.expected.balance.before, self._sentences.points.reach
        (force, moment), drive = before.forces.nothing, self.expected.mechanism.drive
        newtons, moments = self._word("N"), self._word("N*m")
        yield self._word("path of S", unit=self._word("m")), ("r_S", state.path, NOTHING * reach)
        yield f"{FORCE}, {newtons}", ("Φ", state.shaking, force)
        about = self._word("moment about", letter=MOMENT, point=drive.pivot, unit=moments)
        yield about, ("M_Φ", state.rocking, moment)
        for key, one in self._sentences.pairs.items():
            name = f"R_{indices(one.giver, one.taker)}"
            yield f"{in_report(self._sentences.letter(key))}, {newtons}", (name, state.reactions[key], force)
        letter = in_report(self.expected.drafting.letter(BALANCING))
        yield f"{letter}, {moments}", (BALANCING, state.balancing, moment)
        yield self._word("moving mass", unit=self._word("kg")), ("", state.centre.mass, 0.0)

    def _change(self, name: str, was: float, least: float, now: tuple[str, float, float] | None) -> list[str]:
        """Give what is largest before, after, and the change in per cent with its sign."""
        pair = [(name, was), *([] if now is None else [(f"{name}'", now[1])])]
        cells = ["0" if one <= least else number(one, of_largest(self.expected, key, one), DIGITS) for key, one in pair]
        if now is None:
            return cells
        if was <= least:
            return [*cells, NOTHING_THERE]
        share = 100 * ((0.0 if now[1] <= least else now[1]) / was - 1)
        slack = 100 * sum(of_largest(self.expected, key, one) for key, one in pair) / was
        return [*cells, number(share, slack + 100 * NOTHING, OF_CHANGES, SIGNED)]

    def _shares(self) -> Iterator[Sentence]:
        shares, newtons = self.expected.balance.shares, self._word("N")
        assert shares is not None
        shaft = in_report(self._sentences.letter(self._sentences.shaft[0]))
        heads = ["k", f"{FORCE} _max, {newtons}", f"{shaft} _max, {newtons}"]
        yield from table(heads, map(self._share, sorted({*shares.curve, shares.least_force, shares.least_reaction})))

    def _share(self, one: Choice) -> list[str]:
        slack = self._sentences.share_slack(one)
        size = KNOWN * self.expected.balance.before.forces.largest
        cells = (number(one.share, slack, OF_SHARES), *(number(value, size, OF_SHARES) for value in one[1:]))
        return list(cells)

    def _centres(self) -> Iterator[Sentence]:
        states = {"": self.expected.balance.before}
        states |= {} if self.expected.after is None else {"'": self.expected.after}
        units = [(CENTRE, "m"), (FORCE, "N"), (MOMENT, "N*m")]
        heads = self._heads([(f"{letter}{mark}", unit) for mark in states for letter, unit in units])
        columns = [cells for mark, state in states.items() for cells in self._columns(mark, state)]
        angles = np.degrees(self.expected.balance.before.centre.phi)
        first = ([str(k), number(float(angle), KNOWN * abs(angle), DIGITS)] for k, angle in enumerate(angles))
        rows = ([*begun, *cells] for begun, *cells in zip(first, *columns, strict=True))
        yield from table([self._said("table.position"), "φ, °", *heads], rows)

    def _columns(self, mark: str, state: State) -> Iterator[list[str]]:
        """Give the cells of place, main vector and main moment in all positions."""
        least = (NOTHING * self._sentences.points.reach, *self.expected.balance.before.forces.nothing)
        rows = state.centre.r, state.centre.force, state.centre.moment
        for name, row, none in zip(("r_S", "Φ", "M_Φ"), rows, least, strict=True):
            slacks = in_positions(self.expected, f"{name}{mark}")
            yield [self._cell(*one, none) for one in zip(row.tolist(), slacks.tolist(), strict=True)]

    def _cell(self, value: complex | float, slack: float, none: float) -> str:
        """Give a cell: what is but rounding is 0, where nothing is known it is a gap."""
        if cmath.isnan(value):
            return self._said("table.gap")
        if abs(value) <= none:
            return "0; 0" if isinstance(value, complex) else "0"
        parts = (value.real, value.imag) if isinstance(value, complex) else (value,)
        return "; ".join(number(part, slack, DIGITS) for part in parts)
