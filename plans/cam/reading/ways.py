"""The way of a follower over the phases: where each begins and by how much S changes, exact (ход по фазам)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import accumulate
from typing import NamedTuple

from plans.cam.reading.entry import Entry, shown
from plans.cam.reading.form import PhaseTable
from plans.model.cam import DWELL, RETURN, RISE


class Way(NamedTuple):
    """S at the start of a phase, and its change; m, or degrees of a follower that rocks."""

    level: Fraction
    change: Fraction


def ways_of(entry: Entry) -> tuple[Way, ...] | None:
    """Give the way of each phase, or nothing where the follower leaves its way, or does not come back."""
    before = len(entry.faults)
    ways = tuple(_ways(entry))
    _returns(entry, ways)
    return ways if len(entry.faults) == before else None


def _ways(entry: Entry) -> Iterator[Way]:
    level = _start(entry)
    for number, phase in enumerate(entry.form.phases):
        change = _change(entry, phase, level)
        end = level + change
        if not 0 <= end <= entry.lift:
            left = entry.lift - level if phase.kind == RISE else level
            entry.fault(("phases", number), "beyond_way", **entry.way(abs(change)), left=_left(entry, left))
        elif change == 0 and phase.kind != DWELL and entry.lift:
            entry.fault(("phases", number, "kind"), "at_top" if phase.kind == RISE else "at_bottom")
        yield Way(level, change)
        level = end


def _start(entry: Entry) -> Fraction:
    """Give S at the start: at the top where the first that moves is a return."""
    kinds = (phase.kind for phase in entry.form.phases if phase.kind != DWELL)
    return entry.lift if next(kinds, RISE) == RETURN else Fraction(0)


def _change(entry: Entry, phase: PhaseTable, level: Fraction) -> Fraction:
    """Give the change of S: a part of the way that is given, or all that is left of it."""
    if phase.kind == DWELL:
        return Fraction(0)
    part = phase.swing if entry.rocks else phase.lift
    if phase.kind == RISE:
        return entry.lift - level if part is None else Fraction(part)
    return -level if part is None else -Fraction(part)


def _returns(entry: Entry, ways: tuple[Way, ...]) -> None:
    """See that the follower comes back (a cam that translates goes back itself), and goes its whole way."""
    levels = [*accumulate((way.change for way in ways), initial=ways[0].level)]
    last = ("phases", len(ways) - 1)
    if levels[-1] != levels[0] and not entry.translates:
        higher = "above" if levels[-1] > levels[0] else "below"
        entry.fault(last, f"ends_{higher}", **entry.way(abs(levels[-1] - levels[0])))
    elif max(levels) - min(levels) < entry.lift:
        went = entry.way(max(levels) - min(levels))
        entry.fault(last, "way_not_whole", **went, lift=_left(entry, entry.lift))


def _left(entry: Entry, size: Fraction) -> str:
    return shown(size if entry.rocks else 1000 * size)
