"""The bench of drawing by hand: errors by chance hands, of forces and of balancing (черчение от руки)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from drawings.balance import hodograph
from drawings.balance.scheme import BEFORE, SCHEME
from drawings.balance.sheet import leaves
from drawings.bench.sheet import MEASURED, NOTE, DrawnSheets, read
from drawings.forces import sheet as sheets
from drawings.lettering.vector_letters import CENTRE
from drawings.lettering.words import runs
from drawings.measure.measure import Measured
from drawings.rotor import sheet as rotor_sheets
from geometry.draughtsman import DRAWINGS, Draughtsman
from geometry.errors import DraftError
from plans.balance.study import BalanceStudy
from plans.bench.balance import PLACE, SHAKING, Ground, centres, ground
from plans.bench.error import SLIPS, Errors, Toll, toll
from plans.bench.roads import NothingToMeasure, prepared, statics_of
from plans.bench.trial import Found, Order, Road, Row, terms, timed
from plans.bench.truth import Replay, replay
from plans.bench.unbalance import ROTOR, judged, rotor_roads, rotor_truth
from plans.forces.quantities import compare_forces
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.motion import ORDERS, Floats
from plans.rotor.balancing import UNBALANCES
from plans.scene.scene import Scene
from plans.study import Study

BY_HAND = "by hand to {} mm"
FORCES_BY_HAND = f"forces {BY_HAND}"
FORCES = "forces"  # the board of the record, on a sheet a figure of each group: "forces-4-5"
SCALED = (
    "forces by hand: the three plans and then those of forces, arms measured on the plan of positions; all polygons of "
    "a position at the coarsest scale that its sheet has for one"
)
HAND_NOTE = f"median of {DRAWINGS} chance drawings; in brackets 95 of 100 are under"
# Of 73 values that three textbooks print from their drawings (Khurmi and Gupta, Bevan, Sarkar), against exact ones, %.
BOOKS_MEDIAN, BOOKS_MOST = 0.84, 3.9


def of_motion(study: LinkageStudy, drawn: DrawnSheets, largest: Mapping[str, float]) -> tuple[list[Row], Sequence[str]]:
    """Draw the sheet's plans by hand, at the sheet's own scales, with slips of a hand's usual sizes."""
    marked = {(mark.plan, mark.position) for mark in drawn.measured.marks}
    whole = [k for k in drawn.plans if all((order.plan, k) in marked for order in ORDERS[1:])]
    if not whole:
        raise DraftError(f"no plan can be drawn in positions {runs(list(drawn.plans))}")
    tolls = _tolls(BY_HAND, replay(study, whole), _scales(drawn.measured, whole), largest)
    return [_row(name, own, len(drawn.plans)) for name, own in tolls.items()], list(_told(tolls))


def of_forces(study: LinkageStudy, drawn: DrawnSheets, largest: Mapping[str, float]) -> list[Row]:
    """Draw the force sheets' positions by hand; a sheet that is refused leaves its hands out with the reason."""
    statics = Statics(study)
    try:
        coarsest = _polygons(study, statics, drawn)
        positions = [k for k in coarsest if np.isfinite(statics.forces.balancing.moment[k])]
        ready = statics_of(study)
        if ready is None or not positions:
            raise DraftError("no position of a force sheet has forces")
        scales = _scales(drawn.measured, positions) | {FORCES: np.array([coarsest[k] for k in positions])}
        tolls = _tolls(FORCES_BY_HAND, replay(study, positions, ready), scales, largest)
    except DraftError as error:
        return left_out(FORCES_BY_HAND, f"left out: {error}")
    return [_row(name, own, len(positions)) for name, own in tolls.items()]


def left_out(name: str, why: str) -> list[Row]:
    """Give the rows of hands that draw nothing."""
    return [Row(name.format(slip), None, note=why) for slip in SLIPS]


def _tolls(name: str, wanted: Replay, scales: Mapping[str, Floats], largest: Mapping[str, float]) -> dict[str, Toll]:
    truth, own = wanted.truth(), wanted.only_forces if wanted.forces else wanted
    return {name.format(slip): toll(own, Draughtsman(slip, scales), truth, largest) for slip in SLIPS}


def _scales(measured: Measured, positions: Sequence[int]) -> dict[str, Floats]:
    return {order.plan: np.array([scale(measured, order.plan, k) for k in positions]) for order in ORDERS}


def scale(measured: Measured, plan: str, position: int) -> float:
    """Give the scale of a plan in one position, true units a mm; the plan of positions has one for all."""
    own = [mark.scale for mark in measured.marks if mark.plan == plan and mark.position == position]
    return next(iter(own or [mark.scale for mark in measured.marks if mark.plan == plan]))


def _polygons(study: LinkageStudy, statics: Statics, drawn: DrawnSheets) -> dict[int, float]:
    """Draw the force sheets; give the coarsest scale N/mm of the polygons of each of their positions."""
    found: dict[int, float] = {}
    leaves = sheets.sheets(study, compare_forces(statics, drawn.comparison), statics)
    for leaf, one in zip(leaves, read(leaves), strict=True):
        scales = (vector.scale for vector in one.vectors if vector.plan.startswith(f"{FORCES}-"))
        position = int(leaf.metadata["position"])
        found[position] = max(found.get(position, 0.0), *scales)
    return found


def _row(name: str, own: Toll, count: int) -> Row:
    kinds = {kind: float(np.median(values)) for kind, values in own.kinds.items()}
    errors = Errors(kinds, "", float(np.median(own.worst)))
    return Row(name, None, count, errors, float(np.quantile(own.worst, 0.95)), note=HAND_NOTE)


def _told(tolls: Mapping[str, Toll]) -> Iterator[str]:
    """Hold the hands against real ones, whose printed values are known in shares of themselves."""
    yield (
        "real hands: values that three textbooks print from their drawings are out by "
        f"{BOOKS_MEDIAN}% (median), nine of ten by less than {BOOKS_MOST}% of themselves; here v, a, omega, epsilon are"
    )
    middle = 0.0
    for name, own in tolls.items():
        middle, most = (100 * float(np.quantile(own.single, share)) for share in (0.5, 0.9))
        yield f"  {name}: {middle:.2g}% (median), nine of ten by less than {most:.2g}%"
    if middle > 0:  # an error goes with the slip
        like = SLIPS[-1] * BOOKS_MEDIAN / middle
        yield f"  so the books' hands are like one of {like:.1f} mm on this sheet"


OF_BALANCING = "sheet of balancing: measured back"
ROUNDS = 5  # at most: the plans under a mass centre have sessions of their own
Key = tuple[str, int | None, str]  # plan, position and name of a mark
Marks = Mapping[Key, complex]  # measured, in true units


def balance(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge the balance of a scene's mechanism: mass centre by three ways, best share, sheet."""
    study: BalanceStudy = Study(scene)["balance"]
    rounds = min(order.rounds, ROUNDS)
    tell("the mass centre")
    studies = [prepared(scene, count) for count in order.positions]
    if any(one.lost.all() for one in studies):
        raise NothingToMeasure.of(scene)
    found = centres(study, studies, rounds)
    tell("the sheet of balancing")
    on = ground(study.linkage, study.points())
    sheet = Road(lambda: measured(scene), len(on.study.turn), {OF_BALANCING: lambda marks: judge(marks, on)}, NOTE, 0)
    return found._replace(rows=[*found.rows, *timed([sheet], rounds)])


def measured(scene: Scene) -> Marks:
    """Draw the sheets of a scene, write them, and read the points of scheme and hodograph back."""
    points = (point for one in read(leaves(Study(scene))) for point in one.points)
    own = (point for point in points if point.plan in (SCHEME + BEFORE, hodograph.NAME))
    return {(one.plan, one.position, one.name): one.value for one in own}


def judge(marks: Marks, on: Ground) -> Errors:
    """Hold what was read against the truth at its positions, in shares of the largest there."""
    found: list[tuple[str, str, float]] = []
    for kind, true in zip((PLACE, SHAKING), on.true, strict=True):
        values = np.array([marks.get(_mark(kind, k), np.nan) for k in on.positions])
        off, most = true.off(values), float(np.abs(true.near).max())
        found += [(kind, kind, float(np.nanmax(off)) / most)] if most and np.isfinite(off).any() else []
    return Errors.joined(found)


def _mark(kind: str, position: int) -> Key:
    if kind == PLACE:
        return SCHEME + BEFORE, position, CENTRE
    return hodograph.NAME, position, f"{BEFORE} {position}"


def rotor(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge the balance of a scene's rotor: both roads and the sheet."""
    tell("the rotor")
    own = Study(scene)["rotor"].rotor
    true = rotor_truth(own)
    sheet = Road(lambda: counterweights(scene), None, {MEASURED: lambda values: judged(values, true)})
    return Found(timed([*rotor_roads(own, true), sheet], order.rounds), [*ROTOR, *terms(order)])


def counterweights(scene: Scene) -> dict[str, complex]:
    """Draw, write and measure the sheets; give the counterweights' static moments as they are read."""
    study = Study(scene)
    planes = {one.mark.name for one in study["rotor"].drawing.corrections}
    vectors = (vector for one in read(rotor_sheets.leaves(study)) for vector in one.vectors)
    return {one.name: one.value for one in vectors if one.plan == UNBALANCES and one.name in planes}
