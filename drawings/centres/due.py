"""What must stand on the sheets of instant centres, by the analysis alone (что должно быть на листе)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TypeAlias

import numpy as np

from drawings.checks.expected import Cell, Expected, cells
from drawings.lettering.words import fixed, with_index
from drawings.page.page import Drafting, drafting_of
from drawings.paper.strokes import Kind, Leaf
from plans.centres.centrodes import Window, named, plan_of, window
from plans.centres.curvature import circle_of, curvature_plan
from plans.centres.kennedy import CENTRES, InstantCentre, Pair, letter, pairs
from plans.centres.quantities import CentresComparison, SolvedCentrodes, common, placed_with
from plans.centres.study import CentresStudy
from plans.model.mechanism import FRAME
from plans.model.motion import VELOCITIES
from plans.quantity import Quantity
from plans.study import Study

RATES, CURVATURE, DIGITS, PLACES = "rates", "curvature", 5, 2  # digits of a rate; decimals of mm and degrees
HALF = 180.0
Points: TypeAlias = Mapping[str, complex]


def written(value: float, drafting: Drafting) -> str:
    """Write a coordinate in mm, or an angle in degrees."""
    return fixed(value, drafting.language, PLACES)


def cells_of(centre: InstantCentre | None, drafting: Drafting) -> tuple[str, str, str]:
    """Write over which links a centre was found, and where it lies: of one at infinity its direction."""
    if centre is None:
        return "—", "—", "—"
    over = ", ".join(map(str, centre.over)) or drafting.word("centre pair")
    if centre.infinite:
        return over, "∞", f"{written(round(math.degrees(cmath.phase(centre.place)), PLACES) % HALF, drafting)}°"
    x, y = (written(1000 * part, drafting) for part in (centre.place.real, centre.place.imag))
    return over, x, y


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
    bounds, count = comparison.plans.of("positions"), len(comparison.analysis.phi)
    rough = [2 * max(float(row.allowed[k]) for row in bounds) for k in range(count)]
    for k in positions:
        points = {name: complex(moved.r[k]) for name, moved in comparison.analysis.points.items()}
        yield from _posed(found, CENTRES, points, k, rough[k])
        for pair, place in places.items():
            centre = found.at(k).found.get(pair)
            row = cells_of(centre, drafting)
            told: list[Cell] = [*row]
            if centre is not None and not centre.infinite:
                off = float(slack[letter(pair)][k])
                parts = place[k].real, place[k].imag
                told = [row[0], *((1000 * part, 1000 * off + 10.0**-PLACES / 2) for part in parts)]
                if centre.over:
                    yield Expected(Kind.POINT, CENTRES, letter(pair), complex(place[k]), off, k, may_lack=True)
            yield from cells(CENTRES, with_index(letter(pair)), told, k)
        yield from _curves(study, k, points, rough[k])
    for by, plan in spun(comparison):
        name = f"{with_index(by.name)}, {drafting.word('rad/s')}"
        for k in positions:
            value: Cell = (float(plan.analysis[k]), float(np.nanmax((by.allowed[k], plan.allowed[k]))))
            told = [None if math.isnan(by.analysis[k]) else value, value, value]  # open centres give no rate
            yield from cells(RATES, name, told, k, digits=DIGITS)


def _rolling(study: Study, pair: Pair, k: int, points: Points, rough: float) -> Iterator[Expected]:
    """Give the points of a scheme with the centrodes of two links, and each piece of both as its link stands there."""
    found, comparison, plan = study.of(CentresStudy), study.of(CentresComparison), plan_of(pair)
    yield from _posed(found, plan, points, k, rough)
    shown = window([*points.values()])
    yield from _marked(comparison, plan, letter(pair), k, shown)
    solved = SolvedCentrodes.of(found, pair)
    for link, path in solved.paths.items():
        stood = placed_with(found.linkage.mechanism, comparison.analysis, link, path, k)
        near = np.abs(stood - shown[0]) <= shown[1]
        slack = float(np.max(solved.allowed[near], initial=0.0)) + rough
        for name, piece in named(stood, f"p_{link}", shown).items():
            yield Expected(Kind.CURVE, plan, name, piece, slack, k)


def _posed(found: CentresStudy, plan: str, points: Points, k: int, rough: float) -> Iterator[Expected]:
    still = found.linkage.mechanism.links[FRAME].points  # the one that all places are measured from is no point
    for name, spot in points.items():
        yield Expected(Kind.POINT, plan, name, spot, rough, k, may_lack=name in still)


def _marked(comparison: CentresComparison, plan: str, name: str, k: int, shown: Window) -> Iterator[Expected]:
    """Give a point of a figure of curves, if it is shown."""
    row = next(row for row in comparison.findings if row.name == name)
    spot, (middle, most) = complex(row.analysis[k]), shown
    if abs(spot - middle) <= most:
        yield Expected(Kind.POINT, plan, name, spot, float(row.allowed[k]), k)


def _curved(study: Study, point: str, k: int, points: Points, rough: float) -> Iterator[Expected]:
    """Give the scheme, pole, inflection pole and centre of curvature of a point, and the inflection circle."""
    found, comparison, plan = study.of(CentresStudy), study.of(CentresComparison), curvature_plan(point)
    yield from _posed(found, plan, points, k, rough)
    link, shown = found.curving[point], window([*points.values()])
    pole, end = letter((FRAME, link)), f"W_{link}"
    for name in (pole, end, f"O_{point}"):
        yield from _marked(comparison, plan, name, k, shown)
    rows = {row.name: row for row in comparison.findings if row.name in (pole, end)}
    places = [complex(rows[name].analysis[k]) for name in (pole, end)]
    slack = float(sum(row.allowed[k] for row in rows.values()))
    for name, piece in named(circle_of(*places), f"i_{link}", shown).items():
        yield Expected(Kind.CURVE, plan, name, piece, slack, k)


def sizes(comparison: CentresComparison) -> list[Quantity]:
    """List the diameters of inflection circles and the radii of curvature."""
    return [row for row in comparison.findings if row.plan == CENTRES and row.name[:2] in ("δ_", "ρ_")]


def length(value: float, drafting: Drafting) -> str:
    """Write a radius in mm; of none a dash."""
    return "—" if math.isnan(value) else written(1000 * value, drafting)


def _curves(study: Study, k: int, points: Points, rough: float) -> Iterator[Expected]:
    """Give all figures of curves in a position, and the cells of radii and diameters."""
    found, drafting = study.of(CentresStudy), drafting_of(study.scene)
    for pair in found.centrodes:
        yield from _rolling(study, pair, k, points, rough)
    for point in found.curving:
        yield from _curved(study, point, k, points, rough)
    for row in sizes(study.of(CentresComparison)):
        true, off = 1000 * float(row.analysis[k]), 1000 * float(row.allowed[k]) + 10.0**-PLACES / 2
        told = [None if math.isnan(true) else (true, off)] * 2
        yield from cells(CURVATURE, f"{with_index(row.name)}, {drafting.word('mm')}", told, k)
