"""The records of a linkage's plans and of a force sheet: which vector is which, by analysis (планы, силы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.forces.letters import letter_of
from drawings.forces.lever_layout import PLAN as LEVER
from drawings.forces.lever_layout import leverages
from drawings.forces.lever_plan import balance, hanging
from drawings.grading import verdict
from drawings.grading.free_plan import senses_of, turns_of
from drawings.grading.marking import Found, Letters, Record, Slip
from drawings.linkage.due import mass_centres
from drawings.page.scale import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.symbols.force_arrow import plain_name
from geometry.board import Board, Mark
from geometry.steps import Span
from plans.forces.bill import ExpectedForces, ForceBill
from plans.forces.cut import Cut
from plans.forces.force_template import ForcePlans
from plans.forces.friction_quantities import FIGURES
from plans.forces.primary import BALANCING
from plans.linkage.by_hand import MotionByHand
from plans.linkage.parts import Expected, findings
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import ORDERS, POSITIONS
from plans.study import Study


def record_of_linkage(study: Study, leaf: Leaf) -> Record:
    """Give the record of the plans of a sheet of kinematics or of positions."""
    linkage, comparison = study["linkage"], study.comparison("linkage")
    shown = list(leaf.metadata["vectors"])
    found = {key: one for k in dict.fromkeys(k for _, k in shown) for key, one in _vectors(linkage, comparison, k)}
    if (k := leaf.metadata["shown"]) is not None:
        found |= dict(_points(linkage, comparison, k))
    return Record(found, _plan_scales(leaf.metadata["scales"], shown, leaf.metadata["shown"]))


def _plan_scales(
    scales: Mapping[str, float], shown: list[tuple[str, int]], drawn: int | None
) -> dict[str, dict[int | None, float]]:
    found: dict[str, dict[int | None, float]] = {POSITIONS.plan: {}}
    if POSITIONS.plan in scales:
        found[POSITIONS.plan] = dict.fromkeys((drawn, *(k for _, k in shown)), scales[POSITIONS.plan])
    for plan, k in shown:
        found.setdefault(plan, {})[k] = scales[f"{plan}-{k}"]
    return found


def _vectors(study: LinkageStudy, comparison: MotionComparison, k: int) -> Iterator[tuple[Letters, Found]]:
    """Give the vectors of the plans of one position by the letters of their ends; what has no name has those."""
    drafts = study.drafts([k])
    expected = Expected(study.mechanism, comparison.analysis, k, drafts.velocities.written)
    boards = {order.plan: drafts.plan(order.number).board for order in ORDERS[1:]}
    for (plan, start, end), value in expected.arrows(study.groups).items():
        if start in boards[plan] and end in boards[plan]:
            yield (plan, k, start, end), Found(f"{start} {end}", value, Span(boards[plan][start], boards[plan][end]))
    masses = mass_centres(study)
    compared = (*comparison.findings, *findings(study, comparison, masses))
    true = {one.name: complex(one.analysis[k]) for one in compared if one.plan in boards}
    for name, told in MotionByHand(study, comparison, masses).read(drafts).items():
        if isinstance(told, Span):
            yield (told.end.subject, k, told.start.name, told.end.name), Found(name, true[name], told)


def _points(study: LinkageStudy, comparison: MotionComparison, k: int) -> Iterator[tuple[Letters, Found]]:
    """Give the points of the plan of positions."""
    plan = study.drafts([k]).positions
    for name, motion in comparison.analysis.points.items():
        if name not in study.mechanism.links[FRAME].points:
            span = Span(plan.pole, plan.point(name))
            yield (POSITIONS.plan, k, "", name), Found(name, complex(motion.r[k]), span)


FORCES, SCHEME = "forces", FIGURES["positions"]


def record_of_forces(study: Study, leaf: Leaf) -> Record:
    """Give the record of the vectors of one force sheet."""
    statics, comparison, k = study["forces"], study.comparison("forces"), int(leaf.metadata["position"])
    solved, linkage = comparison.motion.analysis, statics.study
    loads = statics.loading(solved)
    expected = ExpectedForces(linkage.mechanism, statics.machine, solved, loads, comparison.analysis, k)
    drawn = statics.drafts([k]).plans
    found: dict[Letters, Found] = {}
    senses: dict[str, dict[str, complex]] = {}
    turns: dict[str, dict[str, int]] = {}
    drafting = drafting_of(study.scene)
    for cut in drawn.plan.cuts:
        true = expected.polygon(linkage.groups, cut.group) | expected.parts(cut.group)
        found |= {(f"forces-{cut.label}", k, "", name): one for name, one in _sides(drawn, cut, true)}
        plan = f"scheme {cut.label}"
        found |= {(plan, k, "", one.name): one for one in _arms(drawn, cut)}
        known = {plain_name(letter_of(load.name, drafting)): true[load.name] for load in cut.loads if load.name in true}
        senses[plan] = senses_of(leaf, plan, k, known)
        couples = ForceBill(expected, linkage.groups, cut.group).couples
        moments = {plain_name(letter_of(one.name, drafting)): one.moment for one in couples if one.name != BALANCING}
        turns[plan] = turns_of(leaf, plan, k, moments)
    images = {linkage.drafts().velocities.point(name).name: expected.image(name) for name in solved.points}
    found |= {(LEVER, k, "", one.name): one for one in _lever(drawn, images, drafting)}
    forces = {name: force for own in senses.values() for name, force in own.items()}
    senses[LEVER] = senses_of(leaf, LEVER, k, forces)
    scales, boards = _scales(leaf)
    return Record(found, {name: {k: mu} for name, mu in scales.items()}, boards, senses, turns)


def _scales(leaf: Leaf) -> tuple[dict[str, float], dict[str, str]]:
    """Give the scales of a sheet's plans and, the coarsest, of the boards; and on which board a polygon is drawn."""
    scales: dict[str, float] = {}
    boards: dict[str, str] = {}
    for name, mu in leaf.metadata["scales"].items():
        for board, figure in FIGURES.items():
            if name.startswith(figure):
                scales |= {name.replace(SCHEME, "scheme "): mu, board: max(mu, scales.get(board, 0.0))}
                boards |= {name: board} if board == FORCES else {}
    return scales, boards


def _sides(drawn: ForcePlans, cut: Cut, true: Mapping[str, complex]) -> Iterator[tuple[str, Found]]:
    """Give the forces of a cut's polygon, each between its corners, and the whole reactions across it."""
    corners = {side.name: Span(side.start, side.end) for side in cut.sides}
    sides = set(corners)
    for support in cut.reactions:
        if support.force.step.op == "join":
            corners.setdefault(support.force.name, Span(*support.force.step.inputs))
    marks = dict(_marks(drawn, cut))
    for name, side in corners.items():
        if name in marks and name in true:
            yield name, Found(name, true[name], Span(drawn.plan.pole, marks[name]), side, name not in sides)


def _marks(drawn: ForcePlans, cut: Cut) -> Iterator[tuple[str, Mark]]:
    """Give the marks of the forces of a cut by their names."""
    for load in cut.loads:
        yield load.name, load.force
    for support in cut.reactions:
        yield from ((part.name, part) for part in support.parts)
        yield support.force.name, support.force
    if cut.group is None and drawn.plan.drive is not None:
        yield drawn.plan.drive.name, drawn.plan.drive


def _arms(drawn: ForcePlans, cut: Cut) -> Iterator[Found]:
    """Give the arms on the scheme of a cut: from the point of moments square to the line of action."""
    for arm in leverages(drawn.plan, cut, 0):
        if arm.dimensioned:
            yield _arm(f"scheme {cut.label}", arm.letter, (arm.pivot, arm.at), arm.direction)


def _lever(drawn: ForcePlans, images: Mapping[str, complex], drafting: Drafting) -> Iterator[Found]:
    """Give the images on the lever, and the arms of the forces there."""
    if drawn.lever is None:
        return
    shown, board = hanging(drawn.plan, drawn.lever, 0), Board(LEVER)
    pole = board.given(shown.pole, 0j)
    for name, _, place in shown.images:
        yield Found(name, images.get(name, place), Span(pole, board.given(name, place)))
    for term in balance(shown, drafting):
        if term.dimensioned:
            yield _arm(LEVER, term.arm, (0j, term.at), term.direction)


def _arm(plan: str, letter: str, ends: tuple[complex, complex], direction: complex) -> Found:
    """Construct an arm as it is drawn: the line of action through the force's point, the perpendicular to its foot."""
    board, name = Board(plan), plain_name(letter)
    about, at = board.given("about", ends[0]), board.given("at", ends[1])
    along = board.given("along", direction)
    foot = board.meet(name, board.parallel("action", at, along), board.square("square", about, along))
    slant = Slip(verdict.SLANT, ends[1] - ends[0])
    return Found(name, complex(foot.point) - ends[0], Span(about, foot), slips=(slant,))
