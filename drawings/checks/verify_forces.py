"""The self-check of a written force sheet: vectors, arrows, numbers and scales (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from drawings.checks import arrowheads, line_kinds, reading, table_grid
from drawings.checks.documents_old import title_block
from drawings.checks.force_marks import lever_marks, polygon_marks
from drawings.checks.forces import arm_marks
from drawings.checks.forces.attachments import Schemes
from drawings.checks.forces.balancing_graph import PLAN as BALANCING
from drawings.checks.forces.cut_equations import CutEquationsCheck
from drawings.checks.forces.details import Details, Sheets
from drawings.checks.forces.force_rows import row_names
from drawings.checks.forces.force_set import ForceSet
from drawings.checks.forces.headings import Headings
from drawings.checks.forces.lever_equation import LeverCheck
from drawings.checks.forces.lever_forces import LeverForces
from drawings.checks.forces.load_points import loads
from drawings.checks.forces.polygon_chain import PolygonChain
from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.forces.schemes import LoadingSchemes
from drawings.checks.forces.sheet_curves import SheetCurves
from drawings.checks.forces.written_equations import WrittenEquations
from drawings.checks.graphs.figure_strokes import FigureStrokes, figure, read
from drawings.checks.linkage import accord, by_hand
from drawings.checks.linkage.value_rows import TABLE
from drawings.checks.reading import plain, scales
from drawings.checks.seen import repeats
from drawings.checks.verify_friction import friction_of
from drawings.checks.workings import polygon_workings
from drawings.checks.workings.force_workings import ForceWorkings
from drawings.checks.wrong import Wrong, on
from drawings.figures.forces.force_letters import force_letter
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from drawings.page.page import page_of
from drawings.paper.strokes import Leaf, Line, Text
from drawings.paper.walk import groups
from drawings.symbols.force_arrow import plain_name
from geometry import draughtsman, hand_error
from plans.checks.comparison import Finding
from plans.checks.expected import Expected
from plans.checks.force_bill import ForceBill
from plans.checks.force_comparison import ForceComparison
from plans.checks.force_expected import ExpectedForces
from plans.checks.hand.forces import FIGURES, forces_by_hand
from plans.forces.statics import Statics
from plans.model.order import VELOCITIES
from plans.study import Study
from plans.words.words import Message

# The least that an arrow not to scale is turned by to be wrong: its direction is drawn with the coordinates of paper.
ASKEW = 1e-3
KIND = "forces"


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one force sheet shows against the analysis."""
    comparison, statics = study.comparison("forces"), study["forces"]
    check = _Check(measured, leaf, comparison, statics)
    yield from check.plans()
    yield from check.arrows()
    yield from check.told()
    yield from check.scales()
    yield from check.curves()
    yield from check.loads()
    yield from check.lever()
    yield from Schemes(leaf, check.expected(), page_of(study.scene).hand).faults()
    yield from check.figures()
    yield from friction_of(leaf, comparison, check.position, study.scene.sheet.language)
    named = row_names(comparison, check.floor)
    # No figure of a force sheet is foremost: its title block has no ratio.
    yield from title_block.faults(leaf, study.scene, KIND, drafting_of(study.scene).word("forces sheet title"), "")
    yield from reading.tables(leaf, named)
    yield from arrowheads.faults(leaf, drafting_of(study.scene).hand.symbol)
    yield from line_kinds.faults(leaf, drafting_of(study.scene).hand)
    yield from repeats.faults(leaf, drafting_of(study.scene).hand.result.width)
    yield from check.by_hand(named)


def set_faults(sheets: Sheets, study: Study) -> Iterator[Wrong]:
    """Hold what belongs to a figure of a force sheet, and may have gone on to the next sheet of its position."""
    comparison, statics = study.comparison("forces"), study["forces"]
    told = set[int]()
    for measured, leaf in sheets:
        check = _Check(measured, leaf, comparison, statics)
        own = [one for one in sheets if int(one[1].metadata["position"]) == check.position]
        yield from check.set_faults(own)
        if check.position not in told:
            yield from check.complete.faults([one for _, one in own], not told)
        told.add(check.position)


@dataclass(frozen=True)
class _Check:
    """One force sheet and what it must show."""

    measured: Measured
    leaf: Leaf
    comparison: ForceComparison
    statics: Statics

    @property
    def position(self) -> int:
        return int(self.leaf.metadata["position"])

    @property
    def slack(self) -> float:
        """What the two roads may differ by in a force, N."""
        return 2 * max(float(one.allowed[self.position]) for one in self.comparison.of("forces") if one.unit == "N")

    def expected(self) -> ExpectedForces:
        study, solved = self.statics.study, self.comparison.motion.analysis
        loads, machine = self.statics.loading(solved), self.statics.machine
        return ExpectedForces(study.mechanism, machine, solved, loads, self.comparison.analysis, self.position)

    def forces(self, label: str) -> dict[str, complex]:
        """Give the forces of a cut and their parts by the names that the sheet writes."""
        expected, cuts = self.expected(), self.statics.drafts().plans.plan.cuts
        group = next(cut.group for cut in cuts if cut.label == label)
        language, letter = self.statics.study.scene.sheet.language, self.statics.form.sheet.reactions
        told = expected.polygon(self.statics.study.groups, group) | expected.parts(group)
        return {plain_name(force_letter(name, language, letter)): value for name, value in told.items()}

    def by_hand(self, named: Mapping[str, Finding]) -> Iterator[Wrong]:
        """Hold what the table says that a hand may be out."""
        scales = self.leaf.metadata["scales"]
        ruled, tried = (
            forces_by_hand(self.statics, self.position, scales, slopes)
            for slopes in (hand_error.slopes, draughtsman.slopes)
        )
        yield from by_hand.wrong_cells(self.leaf, named, by_hand.Told(ruled, tried))
        yield from by_hand.wrong_scales(self.measured, self.leaf, tuple(FIGURES.values()))
        yield from accord.faults(
            self.leaf, self.comparison.exact, self.comparison.motion.kappa, self.statics.study.language
        )
        yield from by_hand.wrong_headings(self.leaf, tuple(FIGURES.values()))
        for table in reading.value_tables(self.leaf):
            yield from table_grid.faults(table, TABLE, by_hand.HEADS, self.statics.study.language)

    def plans(self) -> Iterator[Wrong]:
        """Hold the force plans and the lever's images."""
        study, expected = self.statics.study, self.expected()
        cuts = {cut.label: cut.group for cut in self.statics.drafts().plans.plan.cuts}
        for name in self.leaf.metadata["groups"]:
            yield from polygon_marks(self.measured, expected, study.groups, cuts[name], self.slack)
        chains = [chain for name in self.leaf.metadata["groups"] for chain in self._chain(name)]
        for chain in chains:
            yield from chain.faults()
        speed = 2 * max(float(one.allowed[self.position]) for one in self.comparison.motion.of(VELOCITIES.plan))
        yield from lever_marks(self.measured, expected, self._images, speed)
        drafting = drafting_of(study.scene)
        scales = self.leaf.metadata["scales"]
        due = (polygon_workings.due(one, self.floor, scales.get(one.plan, 0.0), drafting) for one in chains)
        polygons = {name: lines for own in due for name, lines in own.items()}
        yield from ForceWorkings(self.leaf, expected, self.floor, self._images, speed, drafting, polygons).faults()

    def _chain(self, label: str) -> Iterator[PolygonChain]:
        """Give the polygon of a cut on paper."""
        group = figure(self.leaf, f"forces-{label}-{self.position}")
        vectors = [one for one in self.measured.vectors if one.plan == f"forces-{label}"]
        bill = self.bills[tuple(int(link) for link in label.split("-"))]
        order = self._passages[label].order if label in self._passages else ()
        if group is not None:
            yield PolygonChain(group, bill, vectors, order, self.slack)

    def details(self, sheets: Sheets, label: str) -> Details:
        """Give the details of one force plan of the sheet, on the sheets of its position."""
        language, letter = self.statics.study.scene.sheet.language, self.statics.form.sheet.reactions
        expected, groups = self.expected(), self.statics.study.groups
        group = next(cut.group for cut in self.statics.drafts().plans.plan.cuts if cut.label == label)
        must = expected.polygon(groups, group)
        letters = {name: plain(Text(0j, force_letter(name, language, letter)).plain) for name in must}
        known = {**must, **expected.parts(group)}
        names = {read(self.floor.letter(name)): name for name in known}
        return Details(self.measured, sheets, label, known, letters, names, self.slack)

    def arrows(self) -> Iterator[Message]:
        """Hold the directions of arrows that are not to scale, on the schemes and on the lever."""
        whole = {name: value for cut in self._labels() for name, value in self.forces(cut).items()}
        for group in self.leaf.groups:
            cut = group.name.removeprefix("scheme-").rpartition("-")[0] if group.name.startswith("scheme-") else ""
            known = self.forces(cut) if cut else whole
            for arrow in groups((group,)):
                name, shaft = arrow.data.get("name", ""), arrow.strokes[0] if arrow.strokes else None
                if arrow.data.get("kind") != "force" or name not in known or not isinstance(shaft, Line):
                    continue
                along, force = shaft.end - shaft.start, known[name]
                if abs(force) > self.slack and not abs(along / abs(along) - force / abs(force)) <= ASKEW:
                    yield on("direction", group.name, name=name)

    @cached_property
    def bills(self) -> dict[tuple[int, ...], ForceBill]:
        """What acts on each group, and on the primary link, by their links."""
        groups = self.statics.study.groups
        bills = (ForceBill(self.expected(), groups, one) for one in (*groups, None))
        return {bill.links: bill for bill in bills}

    def figures(self) -> Iterator[Wrong]:
        """Hold the loading schemes, the lever, and the headings of all figures."""
        study, position = self.statics.study, self.position
        yield from LoadingSchemes(self.leaf, self.bills, self.floor).faults()
        symbol = drafting_of(study.scene).hand.symbol
        for group in (one for one in self.leaf.groups if one.name.startswith(("scheme-", "lever-"))):
            yield from arm_marks.faults(FigureStrokes(group), group.name, symbol)
        lever = figure(self.leaf, f"lever-{position}")
        points = [one for one in self.measured.points if one.plan == "lever"]
        if lever is not None and points:
            bills = tuple(self.bills.values())
            yield from LeverForces(lever, points, bills, self._images, self.floor, self._vectors).faults()
        notation = study.scene.sheet.notation
        yield from Headings(self.leaf, position, study.mechanism.drive, self.floor, notation).faults()

    @property
    def _images(self) -> dict[str, str]:
        velocities = self.statics.study.drafts().velocities
        return {name: velocities.point(name).name for name in self.comparison.motion.analysis.points}

    @property
    def _vectors(self) -> list[tuple[str, str]]:
        """The vectors of the velocity plan by the names of their ends."""
        study, motion = self.statics.study, self.comparison.motion.analysis
        expected = Expected(study.mechanism, motion, self.position, study.drafts().velocities.written)
        return [ends for plan, *ends in expected.arrows(study.groups) if plan == VELOCITIES.plan]  # type: ignore[misc]

    @cached_property
    def floor(self) -> Floor:
        """What is none on this sheet, and how it is lettered."""
        found, study = self.comparison.analysis, self.statics.study
        force, moment = found.nothing_at(self.position)
        none = self.slack + force, self.slack * found.size + moment
        return Floor(*none, study.language, self.statics.form.sheet.reactions)

    def _labels(self) -> list[str]:
        return [cut.label for cut in self.statics.drafts().plans.plan.cuts]

    def told(self) -> Iterator[Wrong]:
        """Hold the equations of each cut on the sheet."""
        for label, check in self._passages.items():
            yield from check.faults()
            yield from self._arms(label, check)

    def _arms(self, label: str, check: CutEquationsCheck) -> Iterator[Wrong]:
        """Hold that the arms that the equations tell by a letter of their own are on the scheme beside them."""
        plan = f"scheme-{label}-{self.position}"
        group = figure(self.leaf, plan)
        told = {one.name for one in check.written.statements if one.name.startswith("h")}
        if group is not None:
            yield from (on("missing_on", plan, name=name) for name in sorted(told) if name not in group.labels)

    @cached_property
    def _passages(self) -> dict[str, CutEquationsCheck]:
        found = {}
        for links, bill in self.bills.items():
            label = "-".join(map(str, links))
            group = next((one for one in self.leaf.groups if one.name == f"equations-{label}"), None)
            if group is not None:
                found[label] = CutEquationsCheck(label, WrittenEquations(group), bill, self.floor)
        return found

    def scales(self) -> Iterator[Message]:
        """Read the written scale of each figure whose vectors are to one scale."""
        for group in self.leaf.groups:
            stated = {float(s.data["scale"]) for s in groups((group,)) if s.data.get("kind") in ("vector", "point")}
            if len(stated) == 1 and group.name != BALANCING:
                yield from scales(group, stated)

    def curves(self) -> Iterator[Wrong]:
        """Hold the graph of the balancing moment, and the hodographs."""
        yield from SheetCurves(self.measured, self.leaf, self.comparison, self.statics, self.slack).faults()

    def loads(self) -> Iterator[Wrong]:
        """Hold the load diagrams, by the strokes of the analysis."""
        motion = self.comparison.motion
        strokes = self.statics.over(motion.road.extremes)
        drafting = drafting_of(self.statics.study.scene)
        yield from loads(self.measured, self.leaf, self.statics.machine, strokes, motion.analysis, drafting)

    def lever(self) -> Iterator[Wrong]:
        """Hold the lever's equation of moments, and its arms."""
        language = self.statics.study.scene.sheet.language
        yield from LeverCheck(self.measured, self.leaf, self.expected(), language, self.slack).faults()

    @property
    def complete(self) -> ForceSet:
        """What the sheets of its position must have together."""
        return ForceSet(self.statics, self.comparison, self.bills, self.floor, self.position)

    def set_faults(self, sheets: Sheets) -> Iterator[Wrong]:
        """Hold what a figure of the sheet has on any sheet of its position: enlarged details, the lever's equation."""
        for name in self.leaf.metadata["groups"]:
            yield from self.details(sheets, name).faults()
        language = self.statics.study.scene.sheet.language
        leaves = [leaf for _, leaf in sheets]
        yield from LeverCheck(self.measured, self.leaf, self.expected(), language, self.slack).unequalled(leaves)
