"""The sheet of transfer functions: schemes with turned plans, graphs, table of values (лист передаточных функций)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import chain
from typing import Final

import numpy as np

from drawings.kinds import curve_graph
from drawings.kinds.curve_graph import NUMBER, GraphCurve, bounded, swing
from drawings.layout import value_table
from drawings.layout.table import RuledTable
from drawings.lettering.transfer_letters import markup, named
from drawings.lettering.words import with_index
from drawings.linkage.pose import pose, shown
from drawings.linkage.positions import of_linkage
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import FRAME, GRAPH, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, exhibit, figures_facts
from drawings.transfer import scheme
from drawings.transfer.due import expected
from drawings.transfer.scheme import TurnedScheme, working
from plans.model.mechanism import FRAME as FIXED
from plans.study import Study
from plans.transfer.quantities import TransferComparison, by_scales, listed
from plans.transfer.study import STEPS, TransferForm, TransferStudy, functions, output_functions
from plans.transfer.turned import TRANSFER

LARGEST = 3.0  # times the least size at which a graph is legible


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's transfer functions."""
    return lay_out(study.scene, [_TransferSheet(study.of(TransferStudy), study.of(TransferComparison)).draft])


@dataclass(frozen=True, eq=False, repr=False)
class _TransferSheet:
    """What the sheets are drawn from."""

    study: TransferStudy
    comparison: TransferComparison

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.study.linkage.scene)

    @cached_property
    def positions(self) -> tuple[int, ...]:
        """The positions whose turned plans are drawn."""
        linkage = self.study.linkage
        return shown(linkage, self.comparison.even, TRANSFER, linkage.scene.of(TransferForm).transfer.positions)

    @property
    def draft(self) -> Draft:
        """Title, figures, table and notes."""
        poses = ((pose(self.study.linkage, self.comparison.construction, k), k) for k in self.positions)
        schemes = [TurnedScheme(bones, self.study.turned, k) for bones, k in poses]
        told = functions(self.study.linkage.mechanism)
        shows: list[Exhibit | Caption] = []
        for one in schemes:
            read = working(one, told, self.drafting)
            shows.append(exhibit(scheme, one, self.drafting, weight=1.5, together=one.name, scale=TRANSFER))
            shows.append(Caption(read.panel._replace(together=one.name), read.write, of=read.of))
        shows += [exhibit(curve_graph, curve, self.drafting, LARGEST) for curve in self._graphs()]
        title, facts = self.drafting.word("transfer sheet title"), partial(figures_facts, turned=list(self.positions))
        tables = tuple(self._tables())
        return Draft(TRANSFER, title, tuple(shows), tables, tuple(self._notes(schemes)), facts, later=self._by_hand)

    def _graphs(self) -> Iterator[GraphCurve]:
        """The output's transfer functions over the turn."""
        course = output_functions(self.study)
        if course is None:
            return
        phi, sense = self.study.linkage.turn.phi, self.study.linkage.sense
        stations, angles = np.degrees(sense * (phi - phi[0])) % 360, np.linspace(0.0, 360.0, STEPS + 1)
        dense, found = course.rows(self.study.around()), course.rows(self.comparison.construction)
        for order, name in enumerate(course.names):
            values, letter = bounded(dense[order], found[order]), markup(name)
            row = (angles, values, stations, found[order])
            curve = swing(GraphCurve(letter, course.unit or NUMBER, *row, shown=self.positions, states=name))
            kind = "slope" if order else "ratio" if isinstance(course.of, int) else "way"
            title = self.drafting.word(f"{kind} {'turn' if curve.closed else 'swing'}", letter=letter)
            title += f" {self.drafting.word('slope against')}" if order and sense < 0 else ""
            yield curve._replace(title=title, name=f"transfer-{order + 1}")

    def _tables(self) -> Iterator[RuledTable]:
        language, rows = self.drafting.language, listed(self.comparison)
        lines = [value_table.value_row(row, named(row, language), self.positions, language) for row in rows]
        if lines:
            yield value_table.table(lines, self.positions, self.drafting)

    def _by_hand(self, scales: Mapping[str, float]) -> Mapping[tuple[str, int], float]:
        found = self.comparison.findings
        return dict(chain(*(by_scales(found, scales, k).items() for k in self.positions)))

    def _notes(self, schemes: Sequence[TurnedScheme]) -> Iterator[str]:
        drive, word = self.study.linkage.mechanism.drive, self.drafting.word
        image = with_index(self.study.turned.images[drive.end].name)
        yield word("transfer read", crank=drive.link)
        yield word("transfer turned", pole=drive.pivot, image=image, end=with_index(drive.end))
        slides = [of.of for of in functions(self.study.linkage.mechanism) if not isinstance(of.of, int)]
        ways = ((one.point, math.degrees(cmath.phase(one.way(FIXED).direction))) for one in slides)
        if told := "; ".join(f"{with_index(name)} {self.drafting.number(round(way, 2))}°" for name, way in ways):
            yield word("transfer along", ways=told)
        yield word("transfer second", crank=drive.link)
        if self.study.linkage.sense < 0:
            yield word("transfer clockwise")
        if any(one.equal for one in schemes):
            yield word("transfer angles")


FORM: Final = {"turned-": FRAME, "transfer-": GRAPH}
SCALES: Final = {"turned-": "length"}
SHEETS: Final = {"transfer": SheetKind(leaves, expected, SCALES, of_linkage, figures=FORM, tables=("values",))}
