"""The mass centre of a scene's mechanism by three ways and the best share, timed and judged (испытание).

The truth is the record of the main points carried out in 50 digits at exact crank angles.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Mark
from geometry.replay import digits, exact
from plans.analytic.balance.mass_centre import mass_centre
from plans.analytic.kinematics import Analysis
from plans.balance.mass_centre import MainPoints, by_links, by_main_points
from plans.balance.shares import Superposition
from plans.balance.study import BalanceStudy
from plans.bench.error import Errors
from plans.bench.trial import Found, Road, timed
from plans.bench.truth import Exact, crank_direction, sample, split
from plans.linkage.drafts import Drafts
from plans.linkage.study import LinkageStudy
from plans.model.balance.linkage import Choice, MassCentre
from plans.model.motion import ACCELERATIONS, Complexes

MAIN_POINTS, LINKS, SUMS = "construction: main points", "construction: links' polygons", "analysis: direct sums"
SUPERPOSED = "construction: best share"
PLACE, SHAKING, LEAST = "r_S", "Φ", "least force"
SAMPLE = 12  # positions at which the truth is found
DEFINED = (
    "error of the mass centre: the largest difference from the truth of its place, in shares of its farthest place "
    "from the datum, and of the main vector of the inertia forces, in shares of the largest one"
)
TRUE = "truth of the mass centre: the record of the main points in 50 digits, from exact crank angles"
SHARE_DEFINED = (
    "error of the best share: of the largest forces that are superposed against those of the machine drawn anew, "
    "in shares of them"
)


class Centre(NamedTuple):
    """The place of the mass centre m and the main vector N over positions."""

    place: Complexes
    force: Complexes


class Ground(NamedTuple):
    """What the ways at one number of positions stand on: a study without plans, main points, and the truth."""

    study: LinkageStudy
    points: MainPoints
    positions: tuple[int, ...]
    true: tuple[Exact, Exact]  # of the place, and of the main vector

    def judge(self, found: Centre) -> Errors:
        """Judge what a way has found at the positions of the truth."""
        return Errors.joined(
            (kind, kind, float(true.off(values[list(self.positions)]).max()) / (float(np.abs(true.near).max()) or 1.0))
            for kind, values, true in zip((PLACE, SHAKING), found, self.true, strict=True)
        )


def ground(study: LinkageStudy, points: MainPoints) -> Ground:
    """Find the truth at a sample of the positions of a study."""
    chosen = tuple(sample(copy(study).lost, SAMPLE))
    plan = Drafts(study, study.turn.part(list(chosen))).plan(ACCELERATIONS.number)
    main, turned = by_main_points(points, plan)
    crank = plan.positions.board["φ"]
    told = [_exact(study, [main.end, turned.end], crank, *at) for at in enumerate(chosen)]
    mass = digits().fsum(body.mass for body in points.bodies.values())
    true = split([place for place, _ in told]), split([-mass * force for _, force in told])
    return Ground(study, points, chosen, true)


def _exact(study: LinkageStudy, marks: list[Mark], crank: Mark, column: int, position: int) -> list[Any]:
    true = exact(marks, column, {crank: crank_direction(digits(), study, position)})
    return [true[mark] for mark in marks]


def roads(on: Ground) -> list[Road]:
    """List the ways to the mass centre, each with its own plans or its own motion."""
    study, points, count = on.study, on.points, len(on.study.turn)

    def drawn(chains: Callable[..., Any], place: float, force: float) -> Centre:
        first, second = chains(points, Drafts(copy(study), study.turn).plan(ACCELERATIONS.number))
        return Centre(place * _row(first.end, count), force * _row(second.end, count))

    def summed() -> Centre:
        road = Analysis(study.mechanism, first=study.first, pace=study.pace)
        found: MassCentre = mass_centre(study.mechanism, list(points.bodies.values()), road.motion(study.turn.phi))
        return Centre(found.r, found.force)

    ways: dict[str, Callable[[], Centre]] = {
        MAIN_POINTS: partial(drawn, by_main_points, 1.0, -points.mass),
        LINKS: partial(drawn, by_links, 1 / points.mass, 1.0),
        SUMS: summed,
    }
    return [Road(run, count, {name: on.judge}) for name, run in ways.items()]


def _row(mark: Mark, count: int) -> Complexes:
    return np.broadcast_to(np.asarray(mark.point, dtype=complex), count)


def centres(balance: BalanceStudy, studies: Sequence[LinkageStudy], rounds: int) -> Found:
    """Time and judge the mass centre at several numbers of positions, and the best share where one is sought."""
    rows = [row for study in studies for row in timed(roads(ground(study, balance.points())), rounds)]
    if balance.best is None:
        return Found(rows, [DEFINED, TRUE])
    error = _share_error(balance, balance.best)
    rows += timed(
        [Road(lambda: _searched(balance), None, {SUPERPOSED: lambda _: Errors({LEAST: error}, LEAST)})], rounds
    )
    return Found(rows, [DEFINED, TRUE, SHARE_DEFINED])


def _share_error(balance: BalanceStudy, best: Choice) -> float:
    """Judge the forces at the best share by the machine balanced with it and drawn anew."""
    found = Superposition(balance.statics, balance.tree, balance.at_share).drawn(best.share)
    # Where nothing is left at sliders the forces may be none: the difference is told itself.
    return max(abs(one - other) / (other or 1.0) for one, other in zip(best[1:], found[1:], strict=True))


def _searched(balance: BalanceStudy) -> Any:
    return BalanceStudy(balance.linkage, balance.statics, balance.task).shares
