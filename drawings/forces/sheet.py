"""Sheets 2, forces: schemes, polygons, lever, table of reactions (силовой расчёт, лист 2)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, Final

import numpy as np

from drawings.forces import lever, load_diagram, loading_scheme, polygon
from drawings.forces.due import expected
from drawings.forces.equations import LeverEquation, SheetEquations, forces_of_masses
from drawings.forces.letters import LAID, force_letter, letter_of
from drawings.forces.lever import of_arm
from drawings.forces.load_diagram import courses
from drawings.forces.notes import notes
from drawings.forces.report import drafting_of_forces
from drawings.forces.scheme import Scheme, scheme
from drawings.kinds import curve_graph, hodograph, working
from drawings.kinds.axes import Part
from drawings.kinds.working import Workings
from drawings.layout import value_table
from drawings.layout.contents import Panel
from drawings.layout.picture import Picture, Spot
from drawings.layout.table import RuledTable, TableRow
from drawings.layout.value_table import value_row
from drawings.lettering.words import word
from drawings.linkage import vector_plan
from drawings.linkage.positions import force_positions, of_linkage, planless
from drawings.linkage.vector_plan import Diagrams, diagram, diagrams
from drawings.page.page import Drafting
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Leaf
from drawings.sheets.documents import letter as lettered
from drawings.sheets.documents import unknown
from drawings.sheets.kind import GRAPH, PLAN, SheetKind
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit, captions, exhibit, see_ordinates
from geometry.board import at
from plans.forces.cut import CutGroup, ForcePlan, indices
from plans.forces.drive import BALANCING, balancing_quantity
from plans.forces.marks import forces_by_hand
from plans.forces.quantities import ForceComparison
from plans.forces.reading.form import ForceForm
from plans.forces.statics import Statics
from plans.linkage import ram
from plans.linkage.study import LinkageStudy
from plans.model.dyad import formula
from plans.model.kinetostatics import Kinetostatics
from plans.model.motion import PLANS, Floats
from plans.quantity import Quantity
from plans.scene.scene import Scene
from plans.study import Study


def of_forces(scene: Scene) -> None:
    """See that the names of loads can be lettered, and what of the linkage is."""
    loads = scene.of(ForceForm).loads
    kinds = ("forces", "moments", "springs") if loads else ()
    named = ((("loads", kind, k), load.name) for kind in kinds for k, load in enumerate(getattr(loads, kind)))
    lettered(scene, (((*path, "name"), name) for path, name in named if name))
    of_linkage(scene)


def label(finding: Quantity, language: str, reactions: str) -> str:
    """Name a finding of the forces as the sheet does, with its unit: "R_{34}, N"."""
    return f"{force_letter(finding.name, language, reactions)}, {word(language, finding.unit)}"


def rows(comparison: ForceComparison, position: int, language: str, reactions: str) -> list[TableRow]:
    """Give the rows of one position; what is zero over the turn has none, other ways to M_bal the report has."""
    nothing = dict(zip(("N", "N*m"), comparison.construction.nothing_over, strict=True))
    return [
        value_row(finding, label(finding, language, reactions), (position,), language)
        for finding in comparison.of("forces")
        if " " not in finding.name
        and np.any(np.abs(comparison.construction.counted(finding.construction)) > nothing[finding.unit])
    ]


LARGEST = 2.2  # times the least size at which it is legible: a crank is not drawn larger than the mechanism
LEVER = "lever"
MOTION, SLIGHT, SMALL = "motion", 0.5, 1.5  # the plans of velocities and accelerations: weight, times their least size
POLYGON = "forces-"  # before a cut's links: the name of its force plan
STEPS = 720  # of a graph over a turn: half a degree, less than the width of a line on any sheet


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the force sheets of a scene."""
    return sheets(study.of(LinkageStudy), study.of(ForceComparison), study.of(Statics))


def sheets(study: LinkageStudy, comparison: ForceComparison, statics: Statics) -> tuple[Leaf, ...]:
    """Lay out the force sheets: one for each position that is asked for, and following ones where one has no room."""
    chosen = force_positions(statics, comparison)
    return lay_out(study.scene, [_ForceSheet(study, comparison, statics, k, chosen).draft for k in chosen])


@dataclass(frozen=True)
class _ForceSheet:
    """What the force sheets of one position are drawn from."""

    study: LinkageStudy
    comparison: ForceComparison
    statics: Statics
    position: int
    chosen: tuple[int, ...]  # all positions that the set has sheets of

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of_forces(self.statics)

    @property
    def draft(self) -> Draft:
        """Title, figures, equations, table and notes of the sheets."""
        words = tuple(notes(self.statics, self.comparison, self.position, self.drafting.language))
        columns = (figure for cut in self.plan.cuts for figure in self._column(cut))
        loose = (*self._lever(), *self._loads(), *self._graph(), *self._hodographs())
        title = self.drafting.word("forces sheet title")
        shows = (*columns, *loose, *self._motion(), *captions(self._workings()))
        later = partial(forces_by_hand, self.statics, self.position)
        return Draft("forces", title, shows, (self._table(),), words, self._facts, later=later, remarks=self._remarks)

    @property
    def plan(self) -> ForcePlan:
        return self.statics.drafts().plans.plan

    @property
    def forces(self) -> Kinetostatics:
        """The forces of the construction in the positions in which the analysis has them too."""
        return self.comparison.construction

    @cached_property
    def turned(self) -> Kinetostatics:
        """The forces over a whole turn, dense enough for curves."""
        return self.statics.around(STEPS)

    def _column(self, cut: CutGroup) -> Iterator[Exhibit | Caption]:
        yield from (self._schemes[cut.label][1], self._equations(cut))
        shown = self._polygons[cut.label]
        for figure in (*([shown] if shown.forces else []), *shown.details):
            yield exhibit(polygon, figure, self.drafting, together=cut.label)

    @cached_property
    def _polygons(self) -> dict[str, polygon.ForcePolygon]:
        found, before = dict[str, polygon.ForcePolygon](), 0
        for cut in self.plan.cuts:
            shown = polygon.polygon(self.plan, cut, self.position)
            details = polygon.details(shown, polygon.measure(shown, self.drafting), self.drafting, before)
            found[cut.label], before = shown._replace(details=details), before + len(details)
        return found

    @cached_property
    def _schemes(self) -> dict[str, tuple[Scheme, Exhibit]]:
        found = dict[str, tuple[Scheme, Exhibit]]()
        for cut in self.plan.cuts:
            shown, largest = scheme(self.plan, cut, self.position), LARGEST if cut is self.plan.cuts[-1] else 0.0
            wants = {"together": cut.label, "scale": "schemes"}
            found[cut.label] = shown, exhibit(loading_scheme, shown, self.drafting, largest, **wants)
        return found

    def _remarks(self, spots: Mapping[str, Spot]) -> tuple[str, ...]:
        rooms = ((shown, drawn.panel.item) for shown, drawn in self._schemes.values())
        placed = ((shown, room, spots[room.name]) for shown, room in rooms if isinstance(room, Picture))
        aside = any(loading_scheme.drawn_aside(*each, self.drafting) for each in placed)
        return (self.drafting.word("drawn aside"),) if aside else ()

    def _equations(self, cut: CutGroup) -> Caption:
        equations = SheetEquations(self.plan, cut, self.position, self.drafting, self.forces.nothing_at(self.position))
        passage = equations.passage(f"equations-{cut.label}")
        return Caption(Panel(passage.block(), together=cut.label), partial(passage.write, hand=self.drafting.hand))

    def _lever(self) -> Iterator[Exhibit | Caption]:
        plans = self.statics.drafts().plans
        if plans.lever is None or not self.study.rates.at(self.position)[0]:
            return
        shown = lever.hanging(plans.plan, plans.lever, self.position)
        terms = lever.balance(shown, self.drafting)
        letter = self.drafting.word("detail letters")[sum(len(one.details) for one in self._polygons.values()) :][:1]
        for figure in lever.figures(shown, letter):
            yield exhibit(lever, figure, self.drafting, together=LEVER if terms else "", weight=lever.weight(figure))
        if terms:
            turned = balancing_quantity(self.study.mechanism.drive).name == BALANCING
            moment = at(plans.lever.moment.point, self.position).real if turned else None
            equation = LeverEquation(terms, moment, self.drafting, self.position)
            yield Caption(Panel(equation.block(), together=LEVER), equation.write, of=LEVER)

    @cached_property
    def _shown_plans(self) -> Diagrams:
        shown = planless(self.study, self.comparison.motion, self.chosen)
        every = diagrams(self.study, self.comparison.motion.analysis, [self.position] if self.position in shown else [])
        return {key: plan for key, plan in every.items() if plan.is_whole and any(plan.points)}

    def _motion(self) -> Iterator[Exhibit]:
        for plan in self._shown_plans.values():
            yield exhibit(vector_plan, plan, self.drafting, SMALL, together=MOTION, weight=SLIGHT)

    def _workings(self) -> Iterator[Workings]:
        plan, drafting = self.plan, self.drafting
        for cut in plan.cuts:
            name = f"scheme-{cut.label}"
            yield forces_of_masses(plan, cut.links, self.position, name, drafting)
            yield vector_plan.link_working(plan.mechanism, cut.links, name, drafting)
            yield from self._polygon_workings(cut)
        if self.statics.drafts().plans.lever is not None:
            yield forces_of_masses(plan, list(plan.mechanism.links), self.position, LEVER, drafting)
            yield vector_plan.plan_working(diagram(plan.velocities, self.position), LEVER, drafting)
        for (subject, k), shown in self._shown_plans.items():
            yield vector_plan.plan_working(shown, f"{subject}-{k}", drafting)

    def _polygon_workings(self, cut: CutGroup) -> Iterator[Workings]:
        name, drafting = f"{POLYGON}{cut.label}", self.drafting
        known, found = dict[str, float](), dict[str, float]()
        for force in self._polygons[cut.label].forces:
            (known if force.kind in LAID else found)[letter_of(force.name, drafting)] = abs(force.value)
        if known:
            yield working.segment_working(known, polygon.SYMBOL, name, drafting, SEEN)
        if found:
            yield working.reading(found, polygon.SYMBOL, polygon.UNIT, name, drafting, SEEN)

    def _loads(self) -> Iterator[Exhibit]:
        if self.position != self.chosen[0]:
            return
        for course in courses(self.statics.machine, self.statics.strokes, self.comparison.motion.construction):
            yield exhibit(load_diagram, course._replace(shown=self.chosen), self.drafting)

    def _graph(self) -> Iterator[Exhibit]:
        if self.position != self.chosen[0]:
            return
        curve = self._curve()
        key = "balancing graph" if curve.closed else "balancing swing"
        key = key if self.study.mechanism.drive.turns else "balancing stroke"
        under = self.drafting.word("turned from 0").split("\n") if self.study.mechanism.drive.turns else ()
        curve = curve._replace(title=self.drafting.word(key), name="balancing", under=tuple(under))
        room = curve_graph.measure(curve, self.drafting)
        yield Exhibit(Panel(room), partial(self._draw_graph, curve, room))

    def _draw_graph(self, curve: curve_graph.GraphCurve, room: Picture, spot: Spot) -> Part:
        scene = self.study.scene
        stated = dict(scene.sheet.scale.stated).get("moment", 0.0)
        if stated and curve.unit != "N*m":  # a slider that drives is balanced by a force
            raise unknown(scene, "moment")
        if stated:
            low, high = curve.span
            see_ordinates(scene, "moment", high - low, room.high / spot.scale.mu)
        return curve_graph.draw(curve._replace(stated=stated), room, spot, self.drafting)

    def _curve(self) -> curve_graph.GraphCurve:
        statics, drive = self.statics, self.study.mechanism.drive
        balancing = balancing_quantity(drive)
        given = self.forces.counted(statics.given(self.forces, self.study.motion(2)))
        sizes = statics.given_around(STEPS, self.turned), given
        least = balancing.share * self.forces.nothing[balancing.unit != "N" or drive.pushed]
        dense, ordinates = (np.where(np.abs(row) <= least, 0.0, row) for row in sizes)
        dense, (stations, along) = curve_graph.bounded(dense, ordinates), self._stations()
        letter = letter_of(balancing.name, self.drafting)
        turn = (along, dense, stations, ordinates)
        curve = curve_graph.GraphCurve(letter, balancing.unit, *turn, shown=self.chosen, states=balancing.name)
        return curve_graph.swing(curve) if drive.turns else curve._replace(axis=curve_graph.WAY)

    def _stations(self) -> tuple[Floats, Floats]:
        mechanism, phi = self.study.mechanism, self.forces.phi
        if mechanism.drive.turns:
            turned = np.degrees(self.study.sense * (phi - phi[0])) % 360
            return turned, np.arange(STEPS + 1) * 360 / STEPS
        stations, along = (ram.ways(mechanism, row) for row in (phi, self.turned.phi))
        assert stations is not None and along is not None  # of a drive over a stroke
        return np.abs(stations - stations[0]), np.abs(along - stations[0])

    def _hodographs(self) -> Iterator[Exhibit]:
        for key in self.statics.form.sheet.hodographs:
            dense, reaction = self.turned.reactions[key], self.forces.reactions[key]
            letter = letter_of(f"R_{indices(reaction.giver, reaction.taker)}", self.drafting)
            around = curve_graph.bounded(dense.force, reaction.force)
            shown = hodograph.Hodograph(letter, "F", "N", around, reaction.force, self.position, f"hodograph-{key}")
            yield exhibit(hodograph, shown, self.drafting)

    def _table(self) -> RuledTable:
        drafting = self.drafting
        lines = rows(self.comparison, self.position, drafting.language, drafting.reactions)
        return value_table.table(lines, (self.position,), drafting)

    def _facts(self, names: Collection[str]) -> dict[str, Any]:
        groups = [name.removeprefix(POLYGON) for name in names if name.startswith(POLYGON)]
        structure = formula(self.study.mechanism, self.study.groups)
        vectors = [(subject, k) for subject, k in self._shown_plans if f"{subject}-{k}" in names]
        return {"structure": structure, "position": self.position, "groups": groups, "vectors": vectors}


BY_FORCE = {"scheme-": "scheme", "forces-": "force", "lever": "lever"}
SCALES: Final = {**BY_FORCE, "balancing": "moment", "load_diagram-": "way"}
FORM: Final = dict.fromkeys((*BY_FORCE, "hodograph-", *(f"{plan}-" for plan in PLANS[1:])), PLAN) | dict.fromkeys(
    ("balancing", "load_diagram-"), GRAPH
)
SHEETS: Final = {"forces": SheetKind(leaves, expected, SCALES, of_forces, of_arm, figures=FORM, tables=("values",))}
