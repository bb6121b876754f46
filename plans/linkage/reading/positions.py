"""Positions (положения): the sheet names those that there are, and a list of crank angles is one of numbers."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal
from itertools import pairwise

from plans.linkage.reading.survey import Survey
from plans.scene.faults import Path

# Whole numbers some of which a comma without a space joins in pairs, while a space follows the others.
COMMAS = re.compile(r"\[\s*[+-]?\d+(?:,\d+)?(?:\s*,\s+[+-]?\d+(?:,\d+)?)+\s*,?\s*\]")


def check_positions(survey: Survey) -> None:
    """See that the sheet names positions that there are, and that their list has no decimal commas."""
    sheet = survey.form.sheet
    check_numbers(survey, {("sheet", "plans", index): number for index, number in enumerate(sheet.plans)})
    check_numbers(survey, {("sheet", "position"): sheet.position or 0})
    _check_commas(survey)


def check_numbers(survey: Survey, numbers: Mapping[Path, int]) -> None:
    """See that there are positions of some numbers, each told at a key."""
    count = survey.form.drive.count
    if survey.doubtful(("drive", "positions")):
        return
    for path, number in numbers.items():
        if number >= count:
            survey.report(path, "position_number", most=count - 1, count=count)


def _check_commas(survey: Survey) -> None:
    """See that a list of crank angles is none of numbers with decimal commas: [0,5, 30,2] reads as four numbers."""
    path: Path = ("drive", "positions")
    given = survey.form.drive.positions
    if not isinstance(given, tuple) or _one_way(given):
        return
    written = survey.scene.fault(path, "comma_list").value
    pointed = re.sub(r"(?<=\d),(?=\d)", ".", written)
    meant = [Decimal(part) for part in pointed.strip("[] ,").split(",")] if COMMAS.fullmatch(written) else []
    if len(meant) < len(given) and meant and _one_way(meant):
        survey.report(path, "comma_list", written=pointed)


def _one_way(angles: Sequence[Decimal]) -> bool:
    """Tell whether angles only rise or only fall."""
    steps = [low < high for low, high in pairwise(angles)]
    return all(steps) or not any(steps)
