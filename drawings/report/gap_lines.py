"""Gaps as lines of warning: those of one plan, reason and place together (разрывы)."""

from __future__ import annotations

from collections.abc import Sequence

from drawings.lettering.words import runs
from plans.model.motion import Gap


def gap_lines(gaps: Sequence[Gap]) -> list[str]:
    """Say why positions have no result; those of one gap are told with the advice for the first of them."""
    kinds: dict[tuple[str, str, str], list[Gap]] = {}
    for gap in gaps:
        kinds.setdefault((gap.plan, gap.reason, gap.where), []).append(gap)
    return [_line(together) for together in kinds.values()]


def _line(together: Sequence[Gap]) -> str:
    first = together[0]
    alone = len({gap.advice for gap in together}) == 1
    where = first.where if alone else f"{first.where}, in position {first.position}"
    numbers = position_numbers([gap.position for gap in together])
    return f"{numbers}: {first.plan}: {first.reason} at {where}: {first.advice}"


def position_numbers(numbers: Sequence[int]) -> str:
    """Name positions, runs of them by their ends."""
    return f"position {numbers[0]}" if len(numbers) == 1 else f"positions {runs(numbers, '-')}"
