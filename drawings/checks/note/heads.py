"""The heads of positions in a note, and its lines parted by heads (заголовки положений)."""

from __future__ import annotations

import math
from collections.abc import Sequence

from drawings.checks.precise import ALL_DIGITS, KNOWN, tells
from drawings.lettering.words import number
from drawings.lettering.words import word as lettered
from plans.linkage.study import LinkageStudy
from plans.words.words import word


def head_of(study: LinkageStudy, k: int, digits: int = ALL_DIGITS) -> str:
    """Head what is told of a position, with the crank's angle or the drive's way."""
    phi, drive, language = float(study.turn.phi[k]), study.mechanism.drive, study.language
    angle = f"φ = {number(math.degrees(phi) % 360, language, digits)}°"
    way = f"s = {number(1000 * drive.unit * phi, language, digits)} {lettered(language, 'mm')}"
    return word(language, "report.in_position", position=k, station=way if drive.pushed else angle).strip()


def split(lines: Sequence[str], heads: Sequence[str]) -> tuple[list[str], list[list[str] | None]]:
    """Part lines by heads in their order: what stands before the first, then under each; None where one is missing."""
    parts: list[list[str] | None] = [None] * len(heads)
    before, at = list[str](), 0
    current = before
    for line in lines:
        found = next((k for k in range(at, len(heads)) if tells(line, heads[k], (0, 4), KNOWN)), None)
        if found is None:
            current.append(line)
        else:
            parts[found] = current = []
            at = found + 1
    return before, parts
