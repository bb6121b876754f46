"""The sheet of instant centres: schemes, polygon of links, tables (лист мгновенных центров)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import chain
from typing import Final

from drawings.centres import curves, scheme
from drawings.centres.curves import ShownCurves
from drawings.centres.due import CURVATURE, DIGITS, cells_of, expected, length, sizes, spun
from drawings.centres.scheme import CentresScheme, polygon, room
from drawings.layout.contents import Panel
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.words import fixed, with_index
from drawings.linkage.notes import driving, lengths
from drawings.linkage.pose import Pose, pose, shown
from drawings.linkage.positions import of_linkage
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.sheets.kind import FRAME, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Draft, Exhibit, exhibit, figures_facts
from plans.centres.kennedy import CENTRES, letter, pairs
from plans.centres.quantities import CentresComparison
from plans.centres.study import CentresForm, CentresStudy
from plans.quantity import Quantity
from plans.study import Study


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's instant centres."""
    return lay_out(study.scene, [_CentresSheet(study.of(CentresStudy), study.of(CentresComparison)).draft])


@dataclass(frozen=True, eq=False, repr=False)
class _CentresSheet:
    """What the sheets are drawn from."""

    study: CentresStudy
    comparison: CentresComparison

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.study.linkage.scene)

    @cached_property
    def positions(self) -> tuple[int, ...]:
        """The positions that are drawn."""
        linkage = self.study.linkage
        return shown(linkage, self.comparison.plans, CENTRES, linkage.scene.of(CentresForm).centres.positions)

    @property
    def draft(self) -> Draft:
        """Title, figures, tables and notes."""
        linkage, drafting = self.study.linkage, self.drafting
        poses = [(k, pose(linkage, self.comparison.construction, k)) for k in self.positions]
        schemes = (CentresScheme(one, self.study.at(k), k) for k, one in poses)
        shows = [exhibit(scheme, one, drafting, weight=1.5, scale=CENTRES) for one in schemes]
        shows += [exhibit(curves, one, drafting, weight=1.5) for one in self._curves(poses)]
        draw = partial(polygon, self.study.at(self.positions[0]), drafting=drafting)
        shows.append(Exhibit(Panel(room(drafting)), draw))
        title, facts = drafting.word("centres sheet title"), partial(figures_facts, centred=list(self.positions))
        tables, said = tuple(self._tables()), tuple(self._notes())
        return Draft(CENTRES, title, tuple(shows), tables, said, facts, later=lambda scales: {})  # graded by the scales

    def _curves(self, poses: Sequence[tuple[int, Pose]]) -> Iterator[ShownCurves]:
        """Show the centrodes, then the curvature of paths that are asked for."""
        for pair in self.study.centrodes:
            yield from (curves.centrodes(self.study, pair, one, k, self.drafting) for k, one in poses)
        for name in self.study.curving:
            yield from (curves.curvature(self.study, name, one, k, self.drafting) for k, one in poses)

    def _tables(self) -> Iterator[RuledTable]:
        """Tell each centre and each rate in the positions that are drawn."""
        word, text = self.drafting.word, self.drafting.hand.text
        found = [self.study.at(k).found for k in self.positions]
        rows = [
            TableRow(with_index(letter(pair)), tuple(chain(*(cells_of(one.get(pair), self.drafting) for one in found))))
            for pair in pairs(self.study.linkage.mechanism.links)
        ]
        heads = word("found through"), f"x, {word('mm')}", f"y, {word('mm')}"
        yield table(rows, word("centre"), heads, text, self.positions)._replace(name=CENTRES)
        rates = [self._rate(by, plan) for by, plan in spun(self.comparison)]
        if rates:
            heads = word("by centres"), word("by plan"), word("by analysis")
            yield table(rates, word("quantity"), heads, text, self.positions)._replace(name="rates")
        if curved := [self._sized(row) for row in sizes(self.comparison)]:
            both = word("by construction"), word("by analysis")
            yield table(curved, word("quantity"), both, text, self.positions)._replace(name=CURVATURE)

    def _sized(self, size: Quantity) -> TableRow:
        """Write a radius or a diameter by both roads, mm."""
        told = (
            length(float(row[k]), self.drafting) for k in self.positions for row in (size.construction, size.analysis)
        )
        return TableRow(f"{with_index(size.name)}, {self.drafting.word('mm')}", tuple(told))

    def _rate(self, by: Quantity, plan: Quantity) -> TableRow:
        """Write a rate with the decimals of its largest by centres, by plan and by analysis."""
        language, places = self.drafting.language, max(DIGITS - 1 - math.floor(math.log10(plan.largest)), 0)
        rows = by.construction, plan.construction, plan.analysis
        values = (float(row[k].real) for k in self.positions for row in rows)
        told = ("—" if math.isnan(value) else fixed(value, language, places) for value in values)  # an open centre
        return TableRow(f"{with_index(by.name)}, {self.drafting.word('rad/s')}", tuple(told))

    def _notes(self) -> Iterator[str]:
        word, linkage = self.drafting.word, self.study.linkage
        yield driving(linkage, linkage.rates, linkage.language)
        yield from lengths(linkage, linkage.language)
        yield word("centres known")
        through = [one for one in self.study.at(self.positions[0]).found.values() if one.over and not one.infinite]
        for one in through[:1]:
            ends = (letter((min(n, link), max(n, link))) for link in one.over for n in one.pair)
            lines = dict(zip("abcd", map(with_index, ends), strict=True))
            yield word(
                "centres through", centre=with_index(letter(one.pair)), links=cells_of(one, self.drafting)[0], **lines
            )
        yield word("centres read", pole=linkage.mechanism.drive.pivot)
        yield word("centres rates")
        for first, second in self.study.centrodes:
            yield word("centrodes note", first=first, second=second, letter=with_index(letter((first, second))))
        if self.study.curving:
            yield word("curvature note")
            links = {*self.study.curving.values()}
            if none := [k for k in self.positions for link in links if self.study.inflection(k, link) is None]:
                yield word("curvature none", positions=", ".join(map(str, dict.fromkeys(none))))
        every, told = pairs(linkage.mechanism.links), list[str]()
        for k in self.positions:
            if lost := [with_index(letter(pair)) for pair in every if pair not in self.study.at(k).found]:
                told.append(word("centre open", letters=", ".join(lost), position=k))
        if told:
            yield word("centres open", told="; ".join(told))


FORM: Final = {"kennedy-": FRAME, "centrodes-": FRAME, "curvature-": FRAME}
SHEETS: Final = {
    "centres": SheetKind(
        leaves, expected, dict.fromkeys(FORM, "length"), of_linkage, figures=FORM, tables=(CENTRES, "rates", CURVATURE)
    )
}
