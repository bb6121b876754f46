"""The way of a follower over the phases: where each begins and by how much S changes, exact (ход по фазам)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate
from typing import NamedTuple

from plans.cam.reading.entry import Entry
from plans.cam.reading.phase_form import PhaseTable
from plans.model.cam import DWELL, RETURN, RISE


class Way(NamedTuple):
    """S at the start of a phase, and its change; m, or degrees of a follower that rocks."""

    level: Fraction
    change: Fraction


def ways_of(entry: Entry) -> tuple[Way, ...] | None:
    """Give the way of each phase, or nothing where the follower leaves its way, or does not come back."""
    before, ways, level = len(entry.faults), list[Way](), _start(entry)
    for number, phase in enumerate(entry.form.phases):
        ways.append(Way(level, _change(entry, phase, level)))
        level += ways[-1].change
        _keeps(entry, number, phase, ways[-1])
        if len(entry.faults) > before:  # what follows from it is not told as well
            return None
    _returns(entry, ways)
    return tuple(ways) if len(entry.faults) == before else None


def _keeps(entry: Entry, number: int, phase: PhaseTable, way: Way) -> None:
    """See that a phase has some of the way left, and does not go beyond it."""
    if not 0 <= way.level + way.change <= entry.lift:
        left, unit = entry.sized(entry.lift - way.level if phase.kind == RISE else way.level)
        entry.fault(("phases", number), "beyond_way", found=entry.sized(abs(way.change))[0], left=left, unit=unit)
    elif way.change == 0 and phase.kind != DWELL and entry.lift:
        entry.fault(("phases", number, "kind"), "at_top" if phase.kind == RISE else "at_bottom")


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


def _returns(entry: Entry, ways: Sequence[Way]) -> None:
    """See that the follower comes back (a cam that translates goes back itself), and goes its whole way."""
    levels = [*accumulate((way.change for way in ways), initial=ways[0].level)]
    last, over = ("phases", len(ways) - 1), levels[-1] - levels[0]
    if over and not entry.translates:
        found, unit = entry.sized(abs(over))
        entry.fault(last, "ends_above" if over > 0 else "ends_below", found=found, unit=unit)
    elif max(levels) - min(levels) < entry.lift:
        (found, unit), (lift, _) = entry.sized(max(levels) - min(levels)), entry.sized(entry.lift)
        entry.fault(last, "way_not_whole", found=found, lift=lift, unit=unit)
