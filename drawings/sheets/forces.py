"""Sheet 2, forces: groups cut out, their force plans, the primary link, the lever (силовой расчёт, лист 2)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from drawings.figures.forces import force_polygon, force_table, lever_plan, loading_scheme
from drawings.figures.forces.force_equations import Equations
from drawings.figures.forces.force_letters import lettered
from drawings.figures.graphs import curve_graph, hodograph
from drawings.layout import value_table
from drawings.layout.labels import Ink, Labels
from drawings.layout.picture import Picture, Spot
from drawings.layout.shelves import Composed, Content, compose
from drawings.lettering.words import word
from drawings.page.page import Page, page_of
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Leaf, SheetError, Stroke
from drawings.sheets.choice import position
from drawings.sheets.force_notes import notes
from drawings.sheets.kinematics import KEPT
from drawings.sheets.notes import measured, written
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import Cut, indices
from plans.forces.primary import BALANCING
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Kinetostatics
from plans.model.structure import formula
from plans.study import Study

CHOICES = 12  # positions that a message offers at most
LARGEST = 2.2  # times the least size at which it is legible: a crank is not drawn larger than the mechanism
STEPS = 720  # of a graph over a turn: half a degree, less than the width of a line on any sheet


class Figure(Protocol):
    """A figure placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    @property
    def lines(self) -> tuple[Stroke, ...]: ...  # noqa: D102
    def lettered(self, labels: Labels) -> Group: ...  # noqa: D102


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the force sheets of a scene."""
    return sheets(study["linkage"], study.comparison("forces"), study["forces"])


def sheets(study: LinkageStudy, comparison: ForceComparison, statics: Statics) -> tuple[Leaf, ...]:
    """Lay out the force sheets: one for each position that is asked for, and following ones where one has no room."""
    drafts = [_Draft(study, comparison, statics, k) for k in positions(study, comparison)]
    composed = [(draft, one) for draft in drafts for one in compose(draft.content, draft.page)]
    return tuple(draft.leaf(one, k + 1, len(composed)) for k, (draft, one) in enumerate(composed))


def positions(study: LinkageStudy, comparison: ForceComparison) -> tuple[int, ...]:
    """Give the positions whose forces are drawn: the scene's own, or the one that is shown in full lines."""
    roads = comparison.analysis, comparison.construction
    gone = {gap.position: gap for road in roads for gap in road.gaps}
    have = [k for k in range(len(study.turn)) if k not in gone]
    if not have:
        first = gone[min(gone)]
        raise SheetError(
            f"{study.scene.file}: no position has forces: {first.reason} at {first.where}, in position "
            f"{first.position}: {first.advice}"
        )
    for index, k in enumerate(study.scene.sheet.forces):
        if k in gone:
            line, column = study.scene.place(("sheet", "forces", index))
            raise SheetError(
                f"{study.scene.file}:{line}:{column}: sheet.forces: {gone[k].reason} at {gone[k].where}, so that "
                f"position {k} has no forces. Fix: choose one of {', '.join(map(str, have[:CHOICES]))}"
            )
    if study.scene.sheet.forces:
        return tuple(study.scene.sheet.forces)
    shown = position(study, comparison.motion)
    return (shown if shown in have else have[0],)


@dataclass(frozen=True)
class _Draft:
    """What the force sheets of one position are drawn from."""

    study: LinkageStudy
    comparison: ForceComparison
    statics: Statics
    position: int

    @cached_property
    def page(self) -> Page:
        return page_of(self.study.scene)

    @property
    def hand(self) -> Hand:
        return self.page.hand

    @property
    def language(self) -> str:
        return self.study.scene.sheet.language

    @property
    def reactions(self) -> str:
        return self.study.scene.sheet.reactions

    @cached_property
    def cuts(self) -> tuple[Cut, ...]:
        return tuple(self.statics.drafts().plans.plan.cuts)

    @cached_property
    def schemes(self) -> dict[str, loading_scheme.Scheme]:
        plan = self.statics.drafts().plans.plan
        return {f"scheme-{cut.label}": loading_scheme.scheme(plan, cut, self.position) for cut in self.cuts}

    @cached_property
    def polygons(self) -> dict[str, force_polygon.Polygon]:
        plan = self.statics.drafts().plans.plan
        return {f"forces-{cut.label}": force_polygon.polygon(plan, cut, self.position) for cut in self.cuts}

    @cached_property
    def equations(self) -> dict[str, Equations]:
        plan, nothing = self.statics.drafts().plans.plan, self.forces.nothing
        return {
            f"equations-{cut.label}": Equations(plan, cut, self.position, self.language, self.reactions, nothing)
            for cut in self.cuts
        }

    @cached_property
    def hanging(self) -> lever_plan.Hanging | None:
        plans = self.statics.drafts().plans
        return None if plans.lever is None else lever_plan.hanging(plans.plan, plans.lever, self.position)

    @property
    def forces(self) -> Kinetostatics:
        """The forces of the construction in the positions in which the analysis has them too."""
        return self.comparison.construction

    @cached_property
    def turned(self) -> Kinetostatics:
        """The forces over a whole turn, dense enough for curves."""
        return self.statics.around(STEPS)

    @cached_property
    def curve(self) -> curve_graph.Curve:
        """The balancing moment over the turn, or the swing, of the crank."""
        letter = lettered(BALANCING, self.language)
        own, least = self.forces, self.forces.nothing[1]
        stations = np.degrees(self.study.sense * (own.phi - own.phi[0])) % 360
        angles = np.arange(STEPS + 1) * 360 / STEPS
        dense, told = (
            np.where(np.abs(row) <= least, 0.0, row) for row in (self.turned.balancing.moment, own.balancing.moment)
        )
        dense = curve_graph.bounded(dense, told)
        return curve_graph.swing(curve_graph.Curve(letter, "N*m", angles, dense, stations, told))

    @property
    def graphed(self) -> str:
        """The title of the balancing moment's graph."""
        return word(self.language, "balancing graph" if self.curve.closed else "balancing swing")

    @cached_property
    def hodographs(self) -> dict[str, hodograph.Hodograph]:
        """The reactions whose hodographs the scene asks for."""
        found = {}
        for key in self.study.scene.sheet.hodographs:
            dense, own = self.turned.reactions[key], self.forces.reactions[key]
            letter = lettered(f"R_{indices(own.giver, own.taker)}", self.language, self.reactions)
            around = curve_graph.bounded(dense.force, own.force)
            found[f"hodograph-{key}"] = hodograph.Hodograph(letter, "F", "N", around, own.force, self.position)
        return found

    @cached_property
    def said(self) -> list[str]:
        return notes(self.statics, self.position, self.language)

    @cached_property
    def pictures(self) -> dict[str, Picture]:
        """All figures, measured, by name."""
        hand, language = self.hand, self.language
        found = {name: loading_scheme.measured(one, name, hand, language) for name, one in self.schemes.items()}
        crank = f"scheme-{self.cuts[-1].label}"
        found[crank] = found[crank]._replace(most=LARGEST * found[crank].least or math.inf)
        found |= {name: force_polygon.measured(one, name, hand, language) for name, one in self.polygons.items()}
        if self.hanging is not None:
            found["lever"] = lever_plan.measured(self.hanging, "lever", hand, language)
        found["balancing"] = curve_graph.measured(self.curve, "balancing", self.graphed, hand)
        for name, one in self.hodographs.items():
            found[name] = hodograph.measured(one, name, word(language, "hodograph", letter=one.letter), hand)
        return found

    @cached_property
    def content(self) -> Content:
        """All that the sheets of this position must show, measured."""
        columns = tuple(
            (
                self.pictures[f"scheme-{cut.label}"],
                self.equations[f"equations-{cut.label}"].passage(f"equations-{cut.label}", self.hand).block(),
                self.pictures[f"forces-{cut.label}"],
            )
            for cut in self.cuts
        )
        named = [name for name in self.pictures if not name.startswith(("scheme-", "forces-"))]
        lines = force_table.rows(self.comparison, self.position, self.language, self.reactions)
        table = value_table.table(lines, (self.position,), self.hand.text, self.language)
        loose = tuple(self.pictures[name] for name in named)
        return Content(columns, loose, table, measured(self.said, self.hand.text))

    def leaf(self, composed: Composed, number: int, count: int) -> Leaf:
        """Draw one sheet: the lines of all its figures first, then the letters among them."""
        page, language = self.page, self.language
        ink = Ink(*page.size)
        ink.bar(page.field.inset(KEPT))
        still = [*self._still(composed, number, count), *self._blocks(composed)]
        figures = list(self._figures(composed))
        ink.draw([*still, *(stroke for one in figures for stroke in one.lines)])
        labels = Labels(ink, page.hand.drafted)
        return Leaf(
            *page.size,
            (page.frame(), page.corners(), *still, *(one.lettered(labels) for one in figures)),
            title=f"{self.study.scene.title}: {word(language, 'forces sheet title')}",
            description=" ".join(self.said),
            metadata=self._metadata(composed, number, count),
        )

    def _still(self, composed: Composed, number: int, count: int) -> Iterator[Group]:
        """Draw the title block, the table and the notes."""
        page, table = self.page, composed.content.table
        yield page.title_block(self._entries(number, count), self.language)
        if table is not None and composed.table is not None and composed.setting is not None:
            yield from table.drawn(composed.table, composed.setting, page.hand, self.language)
        if composed.notes is not None:
            yield written(self.said, composed.notes, page.hand.text)

    def _blocks(self, composed: Composed) -> Iterator[Group]:
        for name, box in composed.blocks.items():
            yield self.equations[name].passage(name, self.hand).drawn(box, self.hand)

    def _figures(self, composed: Composed) -> Iterator[Figure]:
        hand, language = self.hand, self.language
        for name, spot in composed.pictures.items():
            measure, scale = self.pictures[name], self._scale(spot)
            if name in self.schemes:
                shown = self.schemes[name]
                yield loading_scheme.figure(shown, measure, spot, scale, hand, language, self.reactions)
            elif name in self.polygons:
                closed = self.polygons[name]
                scale = self._with_faint(scale, closed.faint(spot.scale.mu))
                yield force_polygon.figure(closed, measure, spot, scale, hand, language, self.reactions)
            elif name in self.hodographs:
                vector = self.hodographs[name]
                title = word(language, "hodograph", letter=vector.letter)
                yield hodograph.figure(vector, measure, spot, title, scale, hand)
            elif name == "lever":
                assert self.hanging is not None  # else it is not measured
                yield lever_plan.figure(self.hanging, measure, spot, scale, hand, language, self.reactions)
            else:
                standard = self.study.scene.sheet.standard
                yield curve_graph.figure(self.curve, measure, spot, self.graphed, standard, hand, language)

    def _with_faint(self, scale: str, names: Sequence[str]) -> str:
        """Name beside its scale the forces of a plan that are too short to bear a letter."""
        letters = ", ".join(lettered(name, self.language, self.reactions) for name in names)
        return f"{scale};  {word(self.language, 'unlettered', names=letters)}" if names else scale

    def _scale(self, spot: Spot) -> str:
        return spot.scale.written(self.language, self.study.scene.sheet.notation)

    def _entries(self, number: int, count: int) -> dict[str, str]:
        table, language = self.study.scene.sheet, self.language
        kept = ("designation", "drawn", "checked", "approved", "date", "group", "organisation")
        return {
            "title": self.study.scene.title,
            "subtitle": word(language, "forces sheet title"),
            **{key: getattr(table, key) for key in kept},
            "scale": "",
            "sheet": str(number),
            "sheets": str(count),
        }

    def _metadata(self, composed: Composed, number: int, count: int) -> dict[str, Any]:
        return {
            "sheet": "forces",
            "title": self.study.scene.title,
            "structure": formula(self.study.mechanism, self.study.groups),
            "position": self.position,
            "groups": _labels(composed.pictures),
            "number": number,
            "of": count,
        }


def _labels(names: Sequence[str] | dict[str, Spot]) -> list[str]:
    """Give the groups whose force plans stand on a sheet."""
    return [name.removeprefix("forces-") for name in names if name.startswith("forces-")]
