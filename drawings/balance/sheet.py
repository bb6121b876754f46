"""Sheet 5, a mechanism balanced: schemes, static moments, hodographs, tables of what it costs (лист 5)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Final

from drawings.balance import scheme
from drawings.balance.costs import Nothing, costs, counterweights, nothing
from drawings.balance.due import expected
from drawings.balance.graphs import ShakingHodograph, ShareGraph, curve, hodograph
from drawings.balance.report import TELLING, notes_of
from drawings.balance.scheme import AFTER, BEFORE, SCHEME, BalanceScheme, placed_weight
from drawings.forces import load_diagram
from drawings.forces.letters import REACTION, letter_of
from drawings.forces.load_diagram import LoadCourse, courses
from drawings.forces.notes import given, loads_given
from drawings.forces.sheet import of_forces
from drawings.kinds import curve_graph, polygon
from drawings.kinds.polygon import RESULT, SIDE, Letters, Polygon, ShownVector, Sizes
from drawings.kinds.working import Workings
from drawings.layout.contents import Panel
from drawings.layout.picture import Picture
from drawings.layout.table import RuledTable
from drawings.lettering.words import RESULT as SUM
from drawings.lettering.words import lowered
from drawings.linkage.notes import driving
from drawings.linkage.positions import position
from drawings.linkage.skeleton import Skeletons, skeletons
from drawings.linkage.vector_plan import link_working
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf, SheetError
from drawings.sheets.kind import GRAPH, PLAN, SheetKind
from drawings.sheets.leaves import EQUATION, lay_out
from drawings.sheets.stated_scales import Draft, Exhibit, captions, exhibit, figures_facts
from geometry.board import at
from plans.balance.mass_centre import ChainSide
from plans.balance.study import BalanceStudy
from plans.forces.statics import Statics
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.balance.linkage import Balance, State
from plans.model.motion import NOTHING
from plans.scene.scene import Scene
from plans.study import Study
from plans.words.words import message, placed

MOMENTS, SCALE = "static-moments", ("{mr}", "kg*m")
SIZES = Sizes(16.0, 0.0, 5.0, 4.2)
LETTERS = Letters(lowered, lambda _: "")


def static_polygon(position: int, moments: Mapping[str, complex], least: float, drafting: Drafting) -> Polygon:
    """Lay static moments kg*m end to end by their letters; what is no more than `least` has no direction."""
    vectors, end = list[ShownVector](), 0j
    for name, value in moments.items():
        if abs(value) > least:
            vectors.append(ShownVector(name, SIDE, end, value))
            end += value
    closed = abs(end) <= least
    vectors += [] if closed else [ShownVector(SUM, RESULT, 0j, end)]
    title = f"{drafting.word('polygon of static moments')}, {drafting.word('position', position=position)}"
    return Polygon(MOMENTS, title, SCALE, tuple(vectors), closed, LETTERS, SIZES, position)


MAIN = "main"  # what a vector of a scheme is
SCHEMES = "schemes"  # are drawn at one scale
LARGEST = 2.2  # times the least size at which it is legible: no polygon or graph is drawn larger than the schemes


@dataclass(frozen=True)
class ShownBalance:
    """What a balanced mechanism's sheets are drawn from: its links, main points by state, static moments, result."""

    bones: Skeletons
    chains: Mapping[str, tuple[ShownVector, ...]]  # main-point vectors m in the shown position
    moments: Mapping[str, complex]  # static moments kg*m there, by letters
    balance: Balance
    notes: tuple[str, ...] = ()
    reactions: str = REACTION  # the letter of reactions
    loads: tuple[LoadCourse, ...] = ()  # those that are told by diagrams

    @cached_property
    def nothing(self) -> Nothing:
        """What is nothing on the sheets."""
        return nothing(self.states.values(), self.bones.reach)

    @property
    def states(self) -> dict[str, State]:
        """The states by their names."""
        before, after = self.balance.before, self.balance.loaded
        return {BEFORE: before} if after is None else {BEFORE: before, AFTER: after}


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's balanced mechanism."""
    motion = study.of(MotionComparison)
    if study.of(LinkageStudy).lost.all():
        gap = motion.construction.gaps[0]
        where = {"reason": gap.reason, "where": gap.where, "position": gap.position, "advice": gap.advice}
        raise SheetError(placed(study.scene.file, message("refused.no_force", **where)))
    shown, statics = balanced(study.of(BalanceStudy), motion, notes_of(study).all), study.of(Statics)
    if not TELLING & {*study.techniques}:
        language, machine = study.scene.sheet.language, statics.machine
        data = *given(statics, language), *loads_given(machine.loads, statics, language)
        notes = driving(statics.study, statics.study.rates, language), *data, *shown.notes
        drawn = replace(machine, forces=tuple(force for force in machine.forces if force.diagram), moments=())
        shown = replace(shown, notes=notes, loads=tuple(courses(drawn, statics.strokes)))
    return lay_out(study.scene, [_BalancingSheet(study.scene, shown).draft])


def balanced(study: BalanceStudy, motion: MotionComparison, notes: tuple[str, ...] = ()) -> ShownBalance:
    """Read what the sheets show from the records of the construction, in the position in full lines."""
    shown = position(study.linkage, motion.construction)
    drawings = {BEFORE: study.drawing(position=shown)}
    if study.after is not None:
        drawings[AFTER] = study.drawing(after=True, position=shown)
    chains = {state: tuple(map(_vector, drawing.main.sides)) for state, drawing in drawings.items()}
    moments = {side.vector.name: at(side.vector.point, 0) for side in drawings[BEFORE].polygon.sides}
    bones, reactions = skeletons(study.linkage, motion.construction, shown), study.statics.form.sheet.reactions
    return ShownBalance(bones, chains, moments, study.balance, notes, reactions)


def _vector(side: ChainSide) -> ShownVector:
    return ShownVector(side.vector.name, MAIN, at(side.start.point, 0), at(side.vector.point, 0))


@dataclass(frozen=True)
class _BalancingSheet:
    """What the sheets are drawn from."""

    scene: Scene
    shown: ShownBalance

    @cached_property
    def drafting(self) -> Drafting:
        return drafting_of(self.scene)._replace(reactions=self.shown.reactions)

    @property
    def balance(self) -> Balance:
        return self.shown.balance

    @property
    def _shaft(self) -> str:
        return self.shown.bones.mechanism.drive.pivot

    @property
    def draft(self) -> Draft:
        """Title, figures, tables and notes of the sheets."""
        moments = exhibit(polygon, self._moments, self.drafting, LARGEST)
        shows = (*self._schemes(), moments, *self._shaking(), *self._rocking(), *self._shares())
        shows += tuple(exhibit(load_diagram, course, self.drafting, LARGEST) for course in self.shown.loads)
        workings = captions(self._workings())
        facts = partial(figures_facts, position=self.shown.bones.shown)
        title, notes = self.drafting.word("balancing sheet title"), self.shown.notes
        return Draft("balancing", title, (*shows, *workings), self.tables, notes, facts, SCHEME + BEFORE, EQUATION)

    def _schemes(self) -> Iterator[Exhibit]:
        for shown, room in self._rooms:
            draw = partial(scheme.draw, shown, room, drafting=self.drafting)
            yield Exhibit(Panel(room, scale=SCHEMES), draw)

    @cached_property
    def _rooms(self) -> tuple[tuple[BalanceScheme, Picture], ...]:
        """The schemes with the rooms that they take, of one height above their links."""
        schemes = [self._scheme(state) for state in self.shown.states]
        points = [spot for shown in schemes for spot in shown.points]
        return tuple((shown, scheme.measure(shown, points, self.drafting)) for shown in schemes)

    def _scheme(self, state: str) -> BalanceScheme:
        bones, states = self.shown.bones, self.shown.states
        kept = [name for name in (BEFORE, AFTER) if name in states and (name == BEFORE or state == AFTER)]
        paths = {name: states[name].around.r for name in kept if states[name].path > self.shown.nothing.way}
        weights = [weight for weight in self.balance.counterweights if weight.needed and state == AFTER]
        placed = tuple(placed_weight(weight, bones) for weight in weights)
        return BalanceScheme(state, bones, self.shown.chains[state], paths, placed, states[state].whole)

    def _workings(self) -> Iterator[Workings]:
        """How schemes and polygon are laid off: beside them, where paper would stay bare."""
        mechanism = self.shown.bones.mechanism
        for shown, _ in self._rooms:
            yield link_working(mechanism, list(mechanism.links), SCHEME + shown.state, self.drafting)
        yield self._moments.working(self.drafting)

    @property
    def _moments(self) -> Polygon:
        moments = self.shown.moments
        least = NOTHING * sum(map(abs, moments.values()))
        return static_polygon(self.shown.bones.shown, moments, least, self.drafting)

    def _shaking(self) -> Iterator[Exhibit]:
        states, whole = self.shown.states, self.balance.before.whole
        shown = hodograph(states, self.shown.bones.shown, self.shown.nothing.force, whole)
        if shown.vectors:
            yield exhibit(ShakingHodograph, shown, self.drafting, LARGEST)

    def _rocking(self) -> Iterator[Exhibit]:
        bones, least = self.shown.bones, self.shown.nothing.moment
        rocking = curve(self.shown.states, bones.study.sense, bones.shown, least, self.drafting, self._shaft)
        if rocking is not None:
            yield exhibit(curve_graph, rocking, self.drafting, LARGEST)

    def _shares(self) -> Iterator[Exhibit]:
        balance, crank = self.balance, self.shown.bones.mechanism.drive.link
        if balance.shares is not None:
            letter = letter_of(f"R_0{crank}", self.drafting)
            graph = ShareGraph(balance.shares, balance.share, letter, balance.before.reaction(crank))
            yield exhibit(ShareGraph, graph, self.drafting, LARGEST)

    @cached_property
    def tables(self) -> tuple[RuledTable, ...]:
        """What the counterweights change, and which they are."""
        shown, drafting = self.shown, self.drafting
        table = costs(self.balance.before, self.balance.loaded, shown.nothing, drafting, self._shaft)
        weights, mechanism = self.balance.counterweights, shown.bones.mechanism
        rows = [counterweights(weights, mechanism, drafting)] if weights else []
        return (table, *rows)


PLANS: Final = {"scheme-": "scheme", "static-moments": "unbalance", "shaking": "force"}
SCALES: Final = PLANS | {"load_diagram-": "way"}
FORM: Final = dict.fromkeys(PLANS, PLAN) | dict.fromkeys(("rocking", "moment", "share", "load_diagram-"), GRAPH)
TABLES = ("costs", "counterweights")
SHEETS: Final = {"balancing": SheetKind(leaves, expected, SCALES, of_forces, figures=FORM, tables=TABLES)}
