"""What must stand on the sheets of instant centres, by the analysis alone (что должно быть на листе)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks.expected import Cell, Expected, cells
from drawings.lettering.words import fixed, with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.centres.centrodes import named, plan_of, window
from plans.centres.kennedy import CENTRES, InstantCentre, Pair, letter, pairs
from plans.centres.quantities import CentresComparison, SolvedCentrodes, common, placed_with
from plans.centres.study import CentresStudy
from plans.model.mechanism import FRAME
from plans.model.motion import VELOCITIES
from plans.quantity import Quantity
from plans.study import Study

RATES, DIGITS, PLACES = "rates", 5, 2  # digits of a rate; decimals of mm and degrees
HALF = 180.0


def written(value: float, drafting: Drafting) -> str:
    """Write a coordinate in mm, or an angle in degrees."""
    return fixed(value, drafting.language, PLACES)


def cells_of(centre: InstantCentre | None, drafting: Drafting) -> tuple[str, str, str]:
    """Write over which links a centre was found, and where it lies: of one at infinity its direction."""
    if centre is None:
        return "—", "—", "—"
    over = ", ".join(map(str, centre.over)) or drafting.word("centre pair")
    if centre.infinite:
        return over, "∞", f"{written(_angle(centre.place), drafting)}°"
    x, y = (written(1000 * part, drafting) for part in (centre.place.real, centre.place.imag))
    return over, x, y


def _angle(way: complex) -> float:
    return round(math.degrees(cmath.phase(way)), PLACES) % HALF


def spun(comparison: CentresComparison) -> list[tuple[Quantity, Quantity]]:
    """List the rates of the links that turn, by centres and by plan, each beside the analysis."""
    plans = {row.name: row for row in comparison.plans.of(VELOCITIES.plan)}
    both = ((row, plans[row.name]) for row in comparison.findings if row.name in plans)
    return [(by, plan) for by, plan in both if np.nanmax(np.abs(plan.analysis)) > np.nanmax(plan.allowed)]


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give points and centres of each scheme, and the cells of both tables."""
    comparison, found = study.of(CentresComparison), study.of(CentresStudy)
    mechanism, drafting = found.linkage.mechanism, drafting_of(study.scene)
    positions = leaves[0].metadata["centred"] if leaves else ()
    slack = {row.name: row.allowed for row in comparison.findings}
    places = {pair: common(mechanism, comparison.moving.analysis, pair) for pair in pairs(mechanism.links)}
    rough = [
        2 * max(float(row.allowed[k]) for row in comparison.plans.of("positions"))
        for k in range(len(comparison.analysis.phi))
    ]
    for k in positions:
        for name, moved in comparison.analysis.points.items():
            still = name in mechanism.links[FRAME].points  # the one that all places are measured from is no point
            yield Expected(Kind.POINT, CENTRES, name, complex(moved.r[k]), rough[k], k, may_lack=still)
        for pair, place in places.items():
            centre = found.at(k).found.get(pair)
            row = cells_of(centre, drafting)
            told: list[Cell] = [*row]
            if centre is not None and not centre.infinite:
                off = float(slack[letter(pair)][k])
                told = [
                    row[0],
                    *((1000 * part, 1000 * off + 10.0**-PLACES / 2) for part in (place[k].real, place[k].imag)),
                ]
                if centre.over:
                    yield Expected(Kind.POINT, CENTRES, letter(pair), complex(place[k]), off, k, may_lack=True)
            yield from cells(CENTRES, with_index(letter(pair)), told, k)
    for pair in found.centrodes:
        for k in positions:
            yield from _rolling(study, pair, k, rough[k])
    for by, _ in spun(comparison):
        name = f"{with_index(by.name)}, {drafting.word('rad/s')}"
        for k in positions:
            yield from cells(RATES, name, [(float(by.analysis[k]), float(by.allowed[k]))] * 3, k, digits=DIGITS)


def _rolling(study: Study, pair: Pair, k: int, rough: float) -> Iterator[Expected]:
    """Give the points of a scheme with the centrodes of two links, and each piece of both as its link stands there."""
    found, comparison, plan = study.of(CentresStudy), study.of(CentresComparison), plan_of(pair)
    mechanism, moved = found.linkage.mechanism, comparison.analysis
    points = {name: complex(motion.r[k]) for name, motion in moved.points.items()}
    for name, spot in points.items():
        still = name in mechanism.links[FRAME].points
        yield Expected(Kind.POINT, plan, name, spot, rough, k, may_lack=still)
    place = next(row for row in comparison.findings if row.name == letter(pair))
    spot, off = complex(place.analysis[k]), float(place.allowed[k])
    shown = window([*points.values()])
    if abs(spot - shown[0]) <= shown[1]:
        yield Expected(Kind.POINT, plan, letter(pair), spot, off, k)
    solved = SolvedCentrodes.of(found, pair)
    for link, path in solved.paths.items():
        stood = placed_with(mechanism, moved, link, path, k)
        near = np.abs(stood - shown[0]) <= shown[1]
        slack = float(np.max(solved.allowed[near], initial=0.0)) + rough
        for name, piece in named(stood, link, shown).items():
            yield Expected(Kind.CURVE, plan, name, piece, slack, k)
