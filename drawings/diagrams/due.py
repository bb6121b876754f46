"""What the kinematic diagrams and the table of the output must show, by the analysis alone (диаграммы S, v, a)."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import KNOWN, Expected
from drawings.layout.table import cell_name
from drawings.paper.strokes import Kind, Leaf
from plans.diagrams.quantities import DiagramsComparison
from plans.diagrams.study import DiagramsStudy
from plans.linkage.study import LinkageStudy
from plans.model.diagrams import TURN, Axis, Diagrams, OutputRates
from plans.model.motion import Floats
from plans.study import Study

TABLE, DIGITS = "output", 4
KEYS = ("travel", "velocity", "acceleration")
TALLEST = 2.0  # times the largest at a position that a course may go
FLAT = 1e-9  # of what the chords of the row above could tell: a rounding, which has no scale
FINE = 7201  # places of a turn at which a greatest value is sought
TIED = 1e-4  # of the largest: values that are as high
DRAWN = math.radians(0.5)  # the drawn curve has a place in each degree: so far off one may be
NEAR = math.radians(2.0)  # how far off the angle of a greatest value may be told where it is flat
AFTER = 2  # values beyond either end of a turn that a smooth curve looks at


class ExpectedRow(NamedTuple):
    """A row: ordinates at the positions, the thick and the thin curve at any angle, values by chords."""

    key: str
    axis: Axis
    at: Floats  # (M,)
    result: Callable[[Floats], Floats]
    exact: Callable[[Floats], Floats]
    sought: Callable[[Floats], Floats]  # the thick curve between places where it is known, to find its greatest by
    dense: Floats  # the thin curve, closely
    runs: tuple[tuple[float, float], ...]  # from where to where the thick curve goes
    flat: bool
    allowed: float  # what both roads may differ by


def expected(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give the graphs of the output, and its table, where a scene asks for them and they can be drawn."""
    comparison = study.comparison("diagrams") if study.of(DiagramsStudy).wanted else None
    if not isinstance(comparison, DiagramsComparison):
        return
    for row in expected_rows(comparison):
        figure, slack = named(row.key), row.allowed + KNOWN * float(np.nanmax(np.abs(row.at), initial=0.0))
        for k, value in zip(row.axis.numbers, row.at.tolist(), strict=True):
            yield Expected(Kind.VECTOR, figure, str(k), 1j * value, slack, k, may_lack=True)
        for name, course in (("result", row.result), ("exact", row.exact)):
            ends = float(row.runs[0][0]), float(row.runs[-1][1])
            loose = math.inf if name == "exact" and _cut_off(row) else slack
            yield Expected(Kind.CURVE, figure, name, course, loose, may_lack=name == "exact" or row.flat, ends=ends)
        yield from _peaks(row, figure)
    axis, omega = comparison.analysis.axis, abs(study.of(LinkageStudy).mechanism.drive.omega)
    for column, (values, allowed) in enumerate(columns(comparison, omega)):
        slack = allowed + KNOWN * float(np.nanmax(np.abs(values), initial=0.0)) * (omega if column else 0.0)
        for k, number in reversed(list(enumerate(axis.numbers))):
            cell = cell_name(str(number), column)
            yield Expected(Kind.NUMBER, TABLE, cell, float(values[k]), slack, digits=DIGITS, may_lack=True)


def _peaks(row: ExpectedRow, figure: str) -> Iterator[Expected]:
    """Give where the thick curve is greatest and least, degrees; where two places are as high, either may be told."""
    turned = np.linspace(row.runs[0][0], row.runs[-1][1], FINE)
    heights = row.sought(turned)
    for name, sense in (("Δφ greatest", 1.0), ("Δφ least", -1.0)):
        high = np.nan_to_num(sense * heights, nan=-math.inf)
        top = int(np.argmax(high))
        away, lost = np.abs(turned - turned[top]), TIED * np.nanmax(np.abs(heights), initial=0.0)
        ties = away[high >= min(high[top] - lost, high[away <= DRAWN].min())]
        slack = math.inf if row.flat or ties.max() > NEAR else math.degrees(NEAR)
        yield Expected(Kind.PHRASE, figure, name, math.degrees(turned[top]), slack, digits=DIGITS, may_lack=True)


def _cut_off(row: ExpectedRow) -> bool:
    """Tell whether the exact course may be cut off, as beside a gap and near a dead centre, where it goes too far."""
    if len(row.runs) > 1 or not row.axis.closed or np.isnan(row.dense).any():
        return True
    return not np.abs(row.dense).max() <= TALLEST * np.nanmax(np.abs(row.at), initial=0.0)


def named(key: str) -> str:
    """Name the figure of a row."""
    return f"diagrams-{key}"


def expected_rows(comparison: DiagramsComparison) -> tuple[ExpectedRow, ...]:
    """Give the rows from the top."""
    slacks: dict[str, float] = {}
    for finding in comparison.findings:  # of a row those of the plans, of chords and between
        letter = finding.name.split(" ")[0]
        slacks[letter] = slacks.get(letter, 0.0) + float(np.nanmax(finding.allowed, initial=0.0))
    return tuple(_row(comparison, order, allowed) for order, allowed in enumerate(slacks.values()))


def _row(comparison: DiagramsComparison, order: int, allowed: float) -> ExpectedRow:
    found, axis = comparison.analysis, comparison.analysis.axis

    def of(course: OutputRates) -> Floats:
        return (course.s, course.v, course.even(found.lead))[order]

    def exact(turned: Floats) -> Floats:
        return of(comparison.exact.course(turned))

    dense = of(comparison.exact.dense)
    if order == 0:
        runs = tuple((float(axis.turned[run.start]), float(axis.turned[run.stop - 1])) for run in axis.runs)
        followed = partial(_followed, list(_pieces(axis, comparison.exact.nodes, dense)))
        return ExpectedRow(KEYS[0], axis, found.at.s, exact, exact, followed, dense, runs, False, allowed)
    at, places, values = _chorded(found, order)
    pieces = list(_pieces(axis, places, values))
    followed, runs, flat = partial(_followed, pieces), tuple(_spans(axis, pieces)), _flat(comparison, values, order)
    return ExpectedRow(KEYS[order], axis, at, followed, exact, followed, dense, runs, flat, allowed)


def _chorded(found: Diagrams, order: int) -> tuple[Floats, Floats, Floats]:
    """Give the ordinates at the positions, where values by chords belong, and these."""
    if order == 1:
        return found.at.v, found.axis.middles, found.speeds
    return found.at.even(found.lead), found.axis.places, found.growths


def _flat(comparison: DiagramsComparison, values: Floats, order: int) -> bool:
    """Tell whether the values are but roundings of the chords that they come from."""
    found, omega = comparison.analysis, abs(comparison.exact.road.mechanism.drive.omega)
    above = found.at.s if order == 1 else found.speeds
    return bool(np.nanmax(np.abs(values), initial=0.0) <= FLAT * omega * np.nanmax(np.abs(above), initial=0.0))


Piece = tuple[Floats, Floats, tuple[float, float]]


def _pieces(axis: Axis, places: Floats, values: Floats) -> Iterator[Piece]:
    """Give the values of each run that a smooth curve joins, with those beyond the ends of a turn, and its ends."""
    for run in axis.runs:
        bounds = float(axis.turned[run.start]), float(axis.turned[run.stop - 1])
        inside = (places >= bounds[0] - FLAT) & (places <= bounds[1] + FLAT) & ~np.isnan(values)
        x, y = places[inside], values[inside]
        if axis.closed:
            if x[-1] - x[0] > TURN * (1 - FLAT):
                x, y = x[:-1], y[:-1]
            x = np.concatenate([x[-AFTER:] - TURN, x, x[:AFTER] + TURN])
            y = np.concatenate([y[-AFTER:], y, y[:AFTER]])
        if len(x) > 1:
            yield x, y, bounds


def _spans(axis: Axis, pieces: list[Piece]) -> Iterator[tuple[float, float]]:
    for x, _, (low, high) in pieces:
        yield max(low, float(x[0])), min(high, float(x[-1]))


def _followed(pieces: list[Piece], turned: Floats) -> Floats:
    """Give the smooth curve at angles: between two values it goes over from one parabola of neighbours to the next."""
    followed = np.full(len(turned), np.nan)
    for x, y, _ in pieces:
        inside = (turned >= x[0] - FLAT) & (turned <= x[-1] + FLAT)
        at = turned[inside]
        k = np.clip(np.searchsorted(x, at, "right") - 1, 0, len(x) - 2)
        share = (at - x[k]) / (x[k + 1] - x[k])
        if len(x) == 2:
            followed[inside] = y[0] + share * (y[1] - y[0])
            continue
        first, second = np.clip(k - 1, 0, len(x) - 3), np.clip(k, 0, len(x) - 3)
        followed[inside] = (1 - share) * _parabola(x, y, first, at) + share * _parabola(x, y, second, at)
    return followed


def _parabola(x: Floats, y: Floats, k: np.ndarray, at: Floats) -> Floats:
    """Give the parabola through three points from the k-th on, at angles, by Lagrange."""
    ends = x[k], x[k + 1], x[k + 2]
    total = np.zeros(len(at))
    for corner in range(3):
        part = y[k + corner]
        for other in (node for node in range(3) if node != corner):
            part = part * (at - ends[other]) / (ends[corner] - ends[other])
        total = total + part
    return total


def columns(comparison: DiagramsComparison, omega: float) -> list[tuple[Floats, float]]:
    """Give what the columns must say at the positions, and how far each may be off."""
    found, turns = comparison.analysis, comparison.analysis.count.turns
    s, v, a = found.at
    whole = s + turns * found.axis.turned, v + turns * omega, a
    slacks = [float(np.nanmax(finding.allowed, initial=0.0)) for finding in comparison.findings[:3]]
    sizes = [float(np.nanmax(np.abs(row), initial=0.0)) for row in whole]
    sizes = [max(omega**power * size for power, size in enumerate(sizes[k::-1])) for k in range(len(sizes))]
    others = [(row, slack + KNOWN * size) for row, slack, size in zip(whole, slacks, sizes, strict=True)]
    return [(found.axis.turned * 360 / TURN, KNOWN), *others]
