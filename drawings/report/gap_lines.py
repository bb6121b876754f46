"""Gaps as lines of warning: those of one plan, reason and place together (разрывы)."""

from __future__ import annotations

import math
from collections.abc import Sequence

from drawings.lettering.words import fixed, runs
from plans.model.mechanism import Drive
from plans.model.motion import Gap
from plans.words.words import Message, message, word


def gap_lines(gaps: Sequence[Gap]) -> list[Message]:
    """Say why positions have no result; those of one gap are told with the advice for the first of them."""
    kinds: dict[tuple[str, str, object], list[Gap]] = {}
    for gap in gaps:
        kinds.setdefault((gap.plan, gap.reason, gap.where), []).append(gap)
    return [_line(together) for together in kinds.values()]


def _line(together: Sequence[Gap]) -> Message:
    first = together[0]
    parts = {"plan": first.plan, "reason": first.reason, "where": first.where, "advice": first.advice}
    key = "verdict.gap" if len({gap.advice for gap in together}) == 1 else "verdict.gap_in"
    return message(key, **positions([gap.position for gap in together]), first=first.position, **parts)


def gap_line(key: str, gap: Gap, drive: Drive, language: str) -> str:
    """Tell one gap in the report, by the key of its line, or of a slider that drives by `key_way`."""
    parts = {"plan": gap.plan, "reason": gap.reason, "advice": gap.advice, "position": gap.position}
    if drive.pushed:
        return word(language, f"{key}_way", way=fixed(1000 * drive.unit * gap.phi, language, 3), **parts)
    return word(language, key, angle=fixed(math.degrees(gap.phi), language, 3), **parts)


def positions(numbers: Sequence[int]) -> dict[str, object]:
    """Give numbers of positions, runs of them by their ends, as the parts of a message: how many, and which."""
    return {"count": len(numbers), "positions": runs(numbers, "-")}
