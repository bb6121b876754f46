"""The self-check of a written sheet: every vector and point measured back and held against both roads."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from drawings.measure import Key, Measured, check, measure_file
from drawings.strokes import Group, Leaf, Stroke
from geometry.errors import DraftError
from plans.compare import SYMBOLS, Comparison
from plans.study import ORDERS, Study

TOLD = 5  # mismatches told one by one


class SelfCheckFailed(DraftError):  # noqa: N818  (the exit code's own word)
    """A sheet or a comparison that failed plandraft's own check; the sheet is withheld."""


def verify(path: Path, leaf: Leaf, study: Study, comparison: Comparison) -> Measured:
    """Measure a written sheet: all that was drawn is there, is what it states, and is what the analysis gives."""
    measured = measure_file(path)
    wrong = [f"{miss.key.name} on {miss.key.plan}" for miss in check(measured, expected=_keys(leaf.groups))]
    wrong += list(_against_analysis(measured, study, comparison))
    if wrong:
        more = f" and {len(wrong) - TOLD} more" if len(wrong) > TOLD else ""
        raise SelfCheckFailed(f"the written sheet does not measure back: {', '.join(wrong[:TOLD])}{more}")
    return measured


def _keys(strokes: tuple[Stroke, ...]) -> Iterator[Key]:
    for stroke in strokes:
        if isinstance(stroke, Group):
            data = stroke.data
            if data.get("kind") in ("vector", "point"):
                yield Key(data["plan"], data["quantity"], data["name"], int(data["position"]))
            yield from _keys(stroke.strokes)


def _against_analysis(measured: Measured, study: Study, comparison: Comparison) -> Iterator[str]:
    """Hold the measured points, and the vectors from a pole to a named point, against the analytic values."""
    for mark in measured.points:
        yield from _off(mark.key, mark.value, mark.scale, measured, comparison, mark.name)
    for vector in measured.vectors:
        plan = study.drafts().plan(ORDERS.index(vector.plan))
        start, _, end = vector.name.partition(" ")
        letters = {plan.letter(point): point for point in comparison.analysis.points}
        if start == plan.pole.name and end in letters:
            yield from _off(vector.key, vector.value, vector.scale, measured, comparison, letters[end])


def _off(
    key: Key, value: complex, scale: float, measured: Measured, comparison: Comparison, point: str
) -> Iterator[str]:
    order = ORDERS.index(key.plan)
    name = f"{SYMBOLS[order]}_{point}"
    finding = next((found for found in comparison.of(key.plan) if found.name == name), None)
    if finding is None or key.position is None:  # a fixed point: the scene gives it, analysis has nothing to add
        return
    allowed = float(finding.allowed[key.position]) + 2 * measured.quantum * scale
    if not abs(value - complex(finding.analysis[key.position])) <= allowed:
        yield f"{key.name} on {key.plan} (against the analysis)"
