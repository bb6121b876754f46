"""Gaps as lines of warning: those of one plan, reason and place together (разрывы)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from drawings.lettering.words import fixed, runs
from plans.linkage.extreme import EQUAL
from plans.model.mechanism import Drive, Mechanism, Output
from plans.model.motion import Gap
from plans.model.working import ways
from plans.words.words import Message, message, word

PLACES = 4  # decimals of an angle in degrees


def stroke_line(
    mechanism: Mechanism, output: Output, reach: tuple[float, float], angles: tuple[float, float], language: str
) -> str:
    """Say which way the working stroke goes, and how far the crank turns over it and over the idle one."""
    work, idle = (fixed(float(np.degrees(angle)), language, PLACES) for angle in angles)
    way = tuple(message(f"way.{name}") for name in ways(mechanism, output, *reach))
    return word(language, "report.working", time=_time(*angles), ways=way, work=work, idle=idle)


def _time(work: float, idle: float) -> Message:
    """Say whether the working stroke takes longer than the idle one."""
    if abs(work - idle) < EQUAL:
        return message("way.equal")
    return message("way.slower" if work > idle else "way.faster")


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
