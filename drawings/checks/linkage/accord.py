"""What the notes say of the agreement of both roads, read back: how far they are apart, and the worst condition."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks import reading
from drawings.checks.wrong import Wrong
from drawings.lettering.words import number, word
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts
from plans.checks.comparison import Finding
from plans.checks.hand.quantity import SLIP
from plans.model.motion import Floats
from plans.words.words import message

NOISE = 1e-11  # of the largest: what is less is told as this
LEAST, FARTHEST = 11, 3  # powers of ten between which both roads are said to agree
DIGITS = 2  # of kappa
ALIKE = 1e-6  # conditions of positions that mirror each other differ by their rounding alone
HELD = {"share": r"10−(\d+)|1", "position": r"(\d+)", "kappa": r"([\d.,]+)"}


def faults(leaf: Leaf, findings: Sequence[Finding], kappa: Floats, language: str) -> Iterator[Wrong]:
    """Hold the sentence about both roads against their differences; of a longer set one sheet bears it."""
    told = re.search(_pattern(language), _notes(leaf))
    if told is not None:
        power, position, condition = told.groups()
        close = _is_close(math.pow(10.0, -int(power or 0)), findings)
        if not close or not _is_worst(int(position), condition, kappa):
            yield message("wrong.told", text=told[0])
    elif leaf.metadata["of"] == 1 and np.isfinite(kappa).any():
        yield message("wrong.notes")


def apart(leaf: Leaf, findings: Sequence[Finding], language: str, by_hand: bool = True) -> Iterator[Wrong]:
    """Hold what the notes of a sheet without positions say of both roads and of its column of the hand."""
    notes = _notes(leaf)
    lost = [one for one in due(findings, language, by_hand) if Text(0j, one).plain not in notes]
    if leaf.metadata["notes"] and lost:
        yield message("wrong.notes")


def due(findings: Sequence[Finding], language: str, by_hand: bool) -> Iterator[str]:
    """Give what a sheet without positions must say: how near both roads are, and what its column of the hand tells."""
    if not findings:
        return
    power = max(p for p in range(-FARTHEST, LEAST + 1) if p == -FARTHEST or _is_within(math.pow(10.0, -p), findings))
    yield word(language, "accord of roads", share=f"10^{{−{power}}}" if power else "1")
    if by_hand:
        yield word(language, "polygon hand note", slip=number(SLIP, language))


def _is_within(bound: float, findings: Sequence[Finding]) -> bool:
    return all(_share(one) <= bound for one in findings if one.largest > 0)


def is_told(leaf: Leaf, language: str) -> bool:
    """Tell whether a sheet bears the sentence about both roads."""
    return re.search(_pattern(language), _notes(leaf)) is not None


def cut(said: str, language: str) -> str:
    """Cut the sentence about both roads out of notes, once."""
    return re.sub(_pattern(language), "", said, count=1)


def _notes(leaf: Leaf) -> str:
    """Read the notes of a sheet, its lines as one."""
    lines = [text.plain for group in leaf.groups if group.name == "notes" for text in texts((group,))]
    return " ".join(lines).replace("\N{NO-BREAK SPACE}", " ")


def _is_close(bound: float, findings: Sequence[Finding]) -> bool:
    """Tell whether a power of ten is the least that no difference is beyond."""
    apart = max((_share(one) for one in findings if one.largest > 0), default=0.0)
    return max(apart, NOISE) <= bound * (1 + NOISE) and (bound <= NOISE * (1 + NOISE) or apart > bound / 10)


def _share(one: Finding) -> float:
    """Give the share of a difference, which in a position that all but jams is one of its own value there."""
    known = np.isfinite(one.difference)
    sizes = np.maximum(one.largest, np.abs(one.analysis[known]))
    return float((one.difference[known] / sizes).max(initial=0.0))


def _is_worst(position: int, told: str, kappa: Floats) -> bool:
    """Tell whether a condition is the worst over the positions, and that of its own."""
    worst = float(np.nanmax(kappa))
    own = math.isclose(float(kappa[position]), worst, rel_tol=ALIKE) if position < len(kappa) else False
    return own and reading.reads(told, worst, ALIKE * worst, DIGITS)


def _pattern(language: str) -> str:
    """Give the sentence with its numbers to be read."""
    found = re.escape(word(language, "accord", **{part: f"<{part}>" for part in HELD}))
    for part, told in HELD.items():
        found = found.replace(re.escape(f"<{part}>"), f"(?:{told})")
    return found
