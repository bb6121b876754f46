"""Sheets of balancing, of a mechanism and of a rotor, as roads beside the others: measured back (испытание листа)."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from drawings.balance import hodograph
from drawings.balance.scheme import BEFORE, SCHEME
from drawings.balance.sheet import leaves
from drawings.bench.sheet import MEASURED, NOTE, read
from drawings.lettering.balance_letters import CENTRE
from drawings.rotor import sheet as rotor_sheets
from plans.balance.study import BalanceStudy
from plans.bench.balance import PLACE, SHAKING, Ground, centres, ground
from plans.bench.error import Errors
from plans.bench.roads import NothingToMeasure, prepared
from plans.bench.trial import Found, Order, Road, terms, timed
from plans.bench.unbalance import ROTOR, judged, rotor_roads, rotor_truth
from plans.rotor.balancing import UNBALANCES
from plans.scene.scene import Scene
from plans.study import Study

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
