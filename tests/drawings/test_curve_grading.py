"""Grading of curves: our own graphs are right, a mistake is found and named, what follows from it loses nothing."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from drawings.grading.allowance import EXACT, Allowances
from drawings.grading.graded import PASS, grade
from tests.drawings.curve_students import CurveTask, curve_task, made
from tests.rows import over

HAND = Allowances()
CASES = Path(__file__).parents[1] / "cases"
MISTAKES = tomllib.loads((CASES / "curve_mistakes.toml").read_text("utf-8"))["mistake"]


def said(own: CurveTask, source: bytes) -> list[str]:
    wrong = grade(source, (), HAND, own.figures).wrong
    return sorted(" ".join(filter(None, (one.plan, one.name, one.kind))) for one in wrong)


def test_our_own_graphs_are_right() -> None:
    own = curve_task("planer")
    for by in (HAND, Allowances(EXACT)):
        graded = grade(own.originals.drawn(own.originals.sheets[0]), (), by, own.figures)
        assert (graded.outcome, graded.wrong) == (PASS, ())
        assert len(graded.verdicts) > 100


@over("row", MISTAKES)
def test_a_mistake_of_a_curve_is_named_and_costs_once(row: dict[str, Any]) -> None:
    own = curve_task(row["scene"])
    assert said(own, made(own, row)) == sorted(row["says"]), row["name"]
