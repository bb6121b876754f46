"""The records of a linkage's plans and of a force sheet: which vector is which, by analysis (планы, силы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from drawings.forces.arms import leverages
from drawings.forces.letters import letter_of
from drawings.forces.lever import PLAN as LEVER
from drawings.forces.lever import balance, hanging
from drawings.grading import verdict
from drawings.grading.asked import Found, Letters, Place, Record, Slip, lettered
from drawings.grading.scheme_arrows import arrows_on
from drawings.linkage.due import mass_centres
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.symbols.figure import plain_name
from geometry.board import Board, Mark, Span
from plans.centres.kennedy import CENTRES, letter
from plans.centres.study import CentresStudy
from plans.forces.cut import CutGroup
from plans.forces.drive import BALANCING
from plans.forces.force_template import ForcePlans
from plans.forces.marks import FIGURES
from plans.forces.statics import Statics
from plans.linkage.parts import MotionByHand
from plans.linkage.quantities import MotionComparison
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import ORDERS, POSITIONS
from plans.study import Study
from plans.transfer.study import TransferStudy
from plans.transfer.turned import TRANSFER, turned


def record_of_linkage(study: Study, leaf: Leaf) -> Record:
    """Give the record of the plans of a sheet of kinematics or of positions."""
    linkage, comparison = study.of(LinkageStudy), study.of(MotionComparison)
    shown, drawn = list(leaf.metadata["vectors"]), leaf.metadata["shown"]
    found, boards = _of_plans(study, [k for _, k in shown])
    if drawn is not None:
        plan = linkage.drafts([drawn]).positions
        names = comparison.analysis.points.keys() - linkage.mechanism.links[FRAME].points
        found |= {(POSITIONS.plan, drawn, "", name): Found(name, Span(plan.pole, plan.point(name))) for name in names}
    return Record(found, _plan_scales(leaf.metadata["scales"], shown, drawn), boards)


def _of_plans(study: Study, positions: Sequence[int]) -> tuple[dict[Letters, Found], dict[Place, Board]]:
    """Give how the vectors of the plans of velocities and accelerations of some positions are found, and the boards."""
    linkage, found, boards = study.of(LinkageStudy), dict[Letters, Found](), dict[Place, Board]()
    by_hand = MotionByHand(linkage, study.of(MotionComparison), mass_centres(linkage))
    for k in dict.fromkeys(positions):
        drafts = linkage.drafts([k])
        boards |= {(order.plan, k): drafts.plan(order.number).board for order in ORDERS[1:]}
        spans = ((name, span) for name, span in by_hand.read(drafts).items() if isinstance(span, Span))
        found |= {(span.end.subject, k, span.start.name, span.end.name): Found(name, span) for name, span in spans}
    return found, boards


def record_of_transfer(study: Study, leaf: Leaf) -> Record:
    """Give the record of the turned plans of a sheet, each at the scale of the scheme that it is drawn on."""
    transfer, scales = study.of(TransferStudy), leaf.metadata["scales"]
    shown = {k: scales[f"turned-{k}"] for k in leaf.metadata["turned"] if f"turned-{k}" in scales}
    found, boards = dict[Letters, Found](), dict[Place, Board]()
    names = transfer.unit.motion(0).points.keys() - transfer.unit.mechanism.links[FRAME].points
    for drafts, k in ((transfer.unit.drafts([k]), k) for k in shown):
        boards[TRANSFER, k], plan = turned(drafts.velocities).board, drafts.positions
        found |= {(TRANSFER, k, "", name): Found(name, Span(plan.pole, plan.point(name))) for name in names}
    return Record(found, {TRANSFER: {**shown}, POSITIONS.plan: {**shown}}, boards)


def record_of_centres(study: Study, leaf: Leaf) -> Record:
    """Give the record of the schemes of a sheet with their instant centres."""
    found, centres, scales = dict[Letters, Found](), study.of(CentresStudy), leaf.metadata["scales"]
    shown = {k: scales[f"kennedy-{k}"] for k in leaf.metadata["centred"] if f"kennedy-{k}" in scales}
    for drawn, k in ((centres.at(k), k) for k in shown):
        marks = {letter(pair): centre.mark for pair, centre in drawn.found.items() if not centre.infinite}
        for name, mark in (marks | dict(drawn.plan.letters)).items():
            found[CENTRES, k, "", name] = Found(name, Span(drawn.plan.pole, mark))
    return Record(found, {CENTRES: {**shown}, POSITIONS.plan: {**shown}})


def _plan_scales(
    scales: Mapping[str, float], shown: list[tuple[str, int]], drawn: int | None
) -> dict[str, dict[int | None, float]]:
    found: dict[str, dict[int | None, float]] = {POSITIONS.plan: {}}
    if POSITIONS.plan in scales:
        found[POSITIONS.plan] = dict.fromkeys((drawn, *(k for _, k in shown)), scales[POSITIONS.plan])
    for plan, k in shown:
        found.setdefault(plan, {})[k] = scales[f"{plan}-{k}"]
    return found


FORCES, SCHEME = "forces", FIGURES["positions"]


def record_of_forces(study: Study, leaf: Leaf) -> Record:
    """Give the record of the vectors of one force sheet."""
    statics, k, drafting = study.of(Statics), int(leaf.metadata["position"]), drafting_of(study.scene)
    drawn, found = statics.drafts([k]).plans, dict[Letters, Found]()
    known = dict[str, list[str]]()
    for cut in drawn.plan.cuts:
        plan = f"scheme {cut.label}"
        found |= lettered(f"forces-{cut.label}", k, _sides(drawn, cut))
        found |= lettered(plan, k, _arms(drawn, cut))
        acting = (*(load.name for load in cut.loads), *(couple.name for couple in cut.couples))
        known[plan] = [plain_name(letter_of(name, drafting)) for name in acting if name != BALANCING]
    found |= lettered(LEVER, k, _lever(drawn, drafting))
    known[LEVER] = [name for names in known.values() for name in names]
    shown = {plan: arrows_on(leaf, plan, k).keys() & names for plan, names in known.items()}
    scales, subjects = _scales(leaf)
    plans: dict[str, Mapping[int | None, float]] = {name: {k: mu} for name, mu in scales.items()}
    vectors = list(leaf.metadata["vectors"])
    motion, boards = _of_plans(study, [k for _, k in vectors])
    plans |= {plan: {k: leaf.metadata["scales"][f"{plan}-{k}"]} for plan, k in vectors}
    return Record(found | motion, plans, boards, subjects, shown)


def _scales(leaf: Leaf) -> tuple[dict[str, float], dict[str, str]]:
    """Give the scales of a sheet's plans and, the coarsest, of the boards; and on which board a polygon is drawn."""
    scales: dict[str, float] = {}
    boards: dict[str, str] = {}
    for name, mu in leaf.metadata["scales"].items():
        for board, figure in {**FIGURES, LEVER: LEVER}.items():
            if name.startswith(figure):
                scales |= {name.replace(f"{SCHEME}-", "scheme "): mu, board: max(mu, scales.get(board, 0.0))}
                boards |= {name: board} if board == FORCES else {}
    return scales, boards


def _sides(drawn: ForcePlans, cut: CutGroup) -> Iterator[Found]:
    """Give the forces of a cut's polygon, each between its corners, and the whole reactions across it."""
    corners = {side.name: Span(side.start, side.end) for side in cut.sides}
    sides = set(corners)
    for support in cut.reactions:
        if support.force.step.op == "join":
            corners.setdefault(support.force.name, Span(*support.force.step.inputs))
    marks = dict(_marks(drawn, cut))
    for name, side in corners.items():
        if name in marks:
            yield Found(name, Span(drawn.plan.pole, marks[name]), side, name not in sides)


def _marks(drawn: ForcePlans, cut: CutGroup) -> Iterator[tuple[str, Mark]]:
    """Give the marks of the forces of a cut by their names."""
    yield from ((load.name, load.force) for load in cut.loads)
    for support in cut.reactions:
        yield from ((part.name, part) for part in support.parts)
        yield support.force.name, support.force
    if cut.group is None and drawn.plan.drive is not None:
        yield drawn.plan.drive.name, drawn.plan.drive


def _arms(drawn: ForcePlans, cut: CutGroup) -> Iterator[Found]:
    """Give the arms on the scheme of a cut: from the point of moments square to the line of action."""
    for arm in leverages(drawn.plan, cut, 0):
        if arm.dimensioned:
            yield _arm(f"scheme {cut.label}", arm.letter, (arm.pivot, arm.at), arm.direction)


def _lever(drawn: ForcePlans, drafting: Drafting) -> Iterator[Found]:
    """Give the images on the lever, and the arms of the forces there."""
    if drawn.lever is None:
        return
    shown, board = hanging(drawn.plan, drawn.lever, 0), Board(LEVER)
    pole = board.given(shown.pole, 0j)
    yield from (Found(name, Span(pole, board.given(name, place))) for name, _, place in shown.images)
    for term in balance(shown, drafting):
        if term.dimensioned:
            yield _arm(LEVER, term.arm, (0j, term.at), term.direction)


def _arm(plan: str, letter: str, ends: tuple[complex, complex], direction: complex) -> Found:
    """Construct an arm as it is drawn: the line of action through the force's point, the perpendicular to its foot."""
    board, name = Board(plan), plain_name(letter)
    about, at = board.given("about", ends[0]), board.given("at", ends[1])
    along = board.given("along", direction)
    foot = board.meet(name, board.parallel("action", at, along), board.square("square", about, along))
    return Found(name, Span(about, foot), slips=(Slip(verdict.SLANT, ends[1] - ends[0]),))
