"""What balances the drive in every position, by each way that finds it: plans, lever, powers, energy (таблица)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.lettering import words as lettering
from drawings.lettering.words import number
from drawings.report.markdown import header, row
from plans.checks.comparison import Finding
from plans.checks.force_comparison import ForceComparison
from plans.forces.primary import BalancingQuantity
from plans.model.kinetostatics import FORCES
from plans.words.words import term, word

DIGITS = 6
LEVER = "lever"


def balancing_table(comparison: ForceComparison, told: BalancingQuantity, language: str) -> Iterator[str]:
    """Tell the balancing moment, or force, by force plans and analysis, then by the lever, powers and energy."""
    found = [one for one in comparison.of(FORCES) if one.name.partition(" ")[0] == told.name]
    if not found:
        return
    unit = lettering.word(language, told.unit)
    letter = lettering.letter(language, told.name)
    first, *others = found
    heads = [word(language, f"report.{key}", letter=letter, unit=unit) for key in ("by_plans", "by_equilibrium")]
    heads += [f"{letter} {_way(one, language)}, {unit}" for one in others]
    columns = [first.construction, first.analysis, *(_own(one) for one in others)]
    yield word(language, "report.what_balances")
    yield from header([word(language, "table.position"), *heads])
    least = comparison.construction.nothing_over[1]
    for k in range(len(comparison.construction.phi)):
        yield row([str(k), *(_cell(float(np.real(column[k])), float(least[k]), language) for column in columns)])
    yield ""


def _way(one: Finding, language: str) -> str:
    """Tell in words which way finds it; it has one letter in all columns."""
    return term(language, "quantity_part", one.name.partition(" ")[2])


def _own(one: Finding) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Give what a way finds: the lever is of the construction, powers and energy are of the analysis."""
    return np.real(one.construction if one.name.endswith(LEVER) else one.analysis)


def _cell(value: float, least: float, language: str) -> str:
    if np.isnan(value):
        return word(language, "table.gap")
    return number(value if abs(value) > least else 0.0, language, DIGITS)
