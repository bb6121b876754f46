"""The laws of the phases made from the scene: tables and shapes in shares of phase and lift, exact (законы)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate, pairwise
from typing import NamedTuple

from plans.cam.reading.entry import CamEntry, shown
from plans.cam.reading.phase_form import AccelerationShape, LawTable, PhaseTable, cancelled
from plans.model.cam import CUBICS, DWELL, LINES, RETURN, RISE, SHAPE, TABLE, Law
from plans.scene import units
from plans.scene.faults import Path
from plans.scene.units import UnitKind
from plans.words.words import message


class PhaseWay(NamedTuple):
    """S at the start of a phase, and its change; m, or degrees of a follower that rocks."""

    level: Fraction
    change: Fraction


def ways_of(entry: CamEntry) -> tuple[PhaseWay, ...] | None:
    """Give the way of each phase, or nothing where the follower leaves its way, or does not come back."""
    kinds = (phase.kind for phase in entry.form.phases if phase.kind != DWELL)
    level = entry.lift if next(kinds, RISE) == RETURN else Fraction(0)
    before, ways = len(entry.faults), list[PhaseWay]()
    for number, phase in enumerate(entry.form.phases):
        ways.append(PhaseWay(level, _change(entry, phase, level)))
        level += ways[-1].change
        _keeps(entry, number, phase, ways[-1])
        if len(entry.faults) > before:  # what follows from it is not told as well
            return None
    _returns(entry, ways)
    return tuple(ways) if len(entry.faults) == before else None


def _keeps(entry: CamEntry, number: int, phase: PhaseTable, way: PhaseWay) -> None:
    """See that a phase has some of the way left, and does not go beyond it."""
    if not 0 <= way.level + way.change <= entry.lift:
        left, unit = entry.sized(entry.lift - way.level if phase.kind == RISE else way.level)
        entry.fault(("phases", number), "beyond_way", found=entry.sized(abs(way.change))[0], left=left, unit=unit)
    elif way.change == 0 and phase.kind != DWELL and entry.lift:
        entry.fault(("phases", number, "kind"), "at_top" if phase.kind == RISE else "at_bottom")


def _change(entry: CamEntry, phase: PhaseTable, level: Fraction) -> Fraction:
    """Give the change of S: a part of the way that is given, or all that is left of it."""
    if phase.kind == DWELL:
        return Fraction(0)
    part = phase.swing if entry.rocks else phase.lift
    if phase.kind == RISE:
        return entry.lift - level if part is None else Fraction(part)
    return -level if part is None else -Fraction(part)


def _returns(entry: CamEntry, ways: Sequence[PhaseWay]) -> None:
    """See that the follower comes back (a cam that translates goes back itself), and goes its whole way."""
    levels = [*accumulate((way.change for way in ways), initial=ways[0].level)]
    last, over = ("phases", len(ways) - 1), levels[-1] - levels[0]
    if over and not entry.translates:
        found, unit = entry.sized(abs(over))
        entry.fault(last, "ends_above" if over > 0 else "ends_below", found=found, unit=unit)
    elif max(levels) - min(levels) < entry.lift:
        (found, unit), (lift, _) = entry.sized(max(levels) - min(levels)), entry.sized(entry.lift)
        entry.fault(last, "way_not_whole", found=found, lift=lift, unit=unit)


CONSTANT_ACCELERATION = "constant acceleration"
POINTS_LEAST = 2
Plotted = tuple[tuple[Fraction, Fraction], ...]


def law_of(entry: CamEntry, number: int, turned: Fraction, way: PhaseWay) -> Law | None:
    """Give the law of one phase, or nothing of a dwell, or where it is at fault."""
    law = entry.form.phases[number].law
    if not isinstance(law, LawTable):
        return None if law is None else Law(law)
    before = len(entry.faults)
    _owned(entry, number, law)
    if law.name == TABLE:
        return _table(entry, number, law, turned, way)
    if law.name == SHAPE:
        return _shape(entry, number, law)
    return Law(law.name, float(law.first or 0.5)) if len(entry.faults) == before else None


def _owned(entry: CamEntry, number: int, law: LawTable) -> None:
    """See that a law is given nothing that only another takes."""
    path = ("phases", number, "law")
    if law.name != CONSTANT_ACCELERATION:
        entry.spare(("first",), law.given, "constant acceleration", *path)
    if law.name not in (TABLE, SHAPE):
        entry.spare(("points",), law.given, "points", *path)
    if law.name != TABLE:
        entry.spare(("through", "tolerance"), law.given, "table", *path)
    elif law.through == LINES:
        entry.spare(("tolerance",), law.given, "cubics", *path)


def _table(entry: CamEntry, number: int, law: LawTable, turned: Fraction, way: PhaseWay) -> Law | None:
    """Give a law by a table of S over the turn of the cam, in shares."""
    across, up = units.LENGTH if entry.translates else units.ANGLE, units.ANGLE if entry.rocks else units.LENGTH
    points = _plotted(entry, number, law, across, up)
    tolerance = entry.quantity(law.tolerance, up, "phases", number, "law", "tolerance")
    if points is None or not _spans(entry, number, points, turned, way):
        return None
    size = way.change or Fraction(1)
    shares = [((x - points[0][0]) / turned, (y - way.level) / size) for x, y in points]
    allowed = float(Fraction(tolerance or 0) / abs(size))
    ended = (Fraction(0), Fraction(0)), *shares[1:-1], (Fraction(1), Fraction(1))  # rounded points are near them
    return Law(TABLE, 0.5, _floats(ended), law.through or CUBICS, allowed)


def _plotted(entry: CamEntry, number: int, law: LawTable, across: UnitKind, up: UnitKind) -> Plotted | None:
    """Give the points of a law; those that are too few, unsorted or of another kind are at fault."""
    path = ("phases", number, "law", "points")
    found = [
        (entry.quantity(x, across, *path, at, 0), entry.quantity(y, up, *path, at, 1))
        for at, (x, y) in enumerate(law.points)
    ]
    points = tuple((Fraction(x), Fraction(y)) for x, y in found if x is not None and y is not None)
    if len(points) < len(found):
        return None
    if len(points) < POINTS_LEAST:
        entry.fault(path, "few_points", least=POINTS_LEAST)
        return None
    return points if law.name == SHAPE or _sorted(entry, path, points) else None


def _sorted(entry: CamEntry, path: Path, points: Plotted) -> bool:
    """See that a table goes on from point to point, and does not jump."""
    before = len(entry.faults)
    for at, (point, other) in enumerate(pairwise(points), 1):
        if other[0] < point[0]:
            entry.fault((*path, at, 0), "turns_fall", found=shown(other[0]), before=shown(point[0]))
        elif other[0] == point[0]:
            _repeated(entry, (*path, at, 0), other, other[1] - point[1])
    return len(entry.faults) == before


def _repeated(entry: CamEntry, path: Path, point: tuple[Fraction, Fraction], jump: Fraction) -> None:
    if jump:
        size, unit = entry.sized(abs(jump))
        entry.fault(path, "table_jumps", found=shown(point[0]), jump=size, unit=unit)
    else:
        entry.fault(path, "turn_twice", found=shown(point[0]))


NEAR = Fraction(1, 10**9)  # of a phase or a lift: so near its end a point of a table is meant to be at it


def _spans(entry: CamEntry, number: int, points: Plotted, turned: Fraction, way: PhaseWay) -> bool:
    """See that a table goes from the start of its phase to its end, and joins what is before and behind it."""
    before, path = len(entry.faults), ("phases", number, "law", "points")
    ends = ((0, Fraction(0), way.level), (len(points) - 1, turned, way.level + way.change))
    for at, across, level in ends:
        x, y = points[at]
        if abs(x - across) > NEAR * turned:
            entry.fault((*path, at, 0), "table_span", found=shown(x), wanted=shown(across))
        elif abs(y - level) > NEAR * entry.lift:
            (wanted, unit), (found, _) = entry.sized(level), entry.sized(y)
            entry.fault((*path, at, 1), "table_ends", found=found, wanted=wanted, unit=unit)
    return len(entry.faults) == before


def _shape(entry: CamEntry, number: int, law: LawTable) -> Law | None:
    """Give a law by the shape of its acceleration, whose areas above and below cancel."""
    path = ("phases", number, "law", "points")
    points = _plotted(entry, number, law, units.NUMBER, units.NUMBER)
    if points is None or not _shares(entry, path, points):
        return None
    shape = AccelerationShape(points)
    if not shape.cancels:
        factor = shape.factor
        advice = message("advice.shape_factor", factor=shown(factor)) if factor else message("advice.shape_both")
        entry.fault(path, "shape_areas", above=shown(shape.above), below=shown(shape.below), advice=advice)
        return None
    found = cancelled(shape)
    if found.lift <= 0:
        entry.fault(path, "shape_falls")
        return None
    return Law(SHAPE, 0.5, _floats(found.points))


def _shares(entry: CamEntry, path: Path, points: Plotted) -> bool:
    """See that shares go from 0 to 1 without falling, at most two points at one of them."""
    before = len(entry.faults)
    for at, share in ((0, 0), (len(points) - 1, 1)):
        if points[at][0] != share:
            entry.fault((*path, at, 0), "table_span", found=shown(points[at][0]), wanted=str(share))
    for at, (point, other) in enumerate(pairwise(points), 1):
        if other[0] < point[0]:
            entry.fault((*path, at, 0), "turns_fall", found=shown(other[0]), before=shown(point[0]))
        elif at > 1 and other[0] == points[at - 2][0]:
            entry.fault((*path, at, 0), "share_thrice", found=shown(other[0]))
    return len(entry.faults) == before


def _floats(points: Plotted) -> tuple[tuple[float, float], ...]:
    return tuple((float(x), float(y)) for x, y in points)
