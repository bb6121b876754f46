"""The self-check of a written sheet: everything on it that can be measured or read is held against the analysis."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from drawings.labelled import unlettered
from drawings.limits import Refused
from drawings.measure import Measured, MeasuredVector, check, measure_file
from drawings.strokes import Group, Leaf, Stroke, Text
from drawings.vector_plan import LEAST
from drawings.words import number
from geometry.errors import DraftError
from plans.compare import Comparison
from plans.expected import Expected
from plans.motion import ORDERS, POINT_KEYS
from plans.study import Study

if TYPE_CHECKING:
    from plans.statics import Statics

TOLD = 5  # mismatches told one by one
_NUMBER = re.compile(r"[-−]?\d+(?:[.,]\d+)?")
_SCALE = re.compile(r"(μ|K)\S+ = (\d+(?:[.,]\d+)?) ")  # of a plan, after its letter: mu_v, K_v


class SelfCheckFailed(DraftError):  # noqa: N818  (the exit code's own word)
    """A sheet or a comparison that failed plandraft's own check; the sheet is withheld."""

    exit_code = 5


def verify(path: Path, leaf: Leaf, study: Study, comparison: Comparison, statics: Statics | None = None) -> Measured:
    """Measure a written sheet: all that it must show is there, states what it shows, and is what the analysis gives."""
    try:
        measured = measure_file(path)
    except Refused as refused:
        raise SelfCheckFailed(f"the written sheet cannot be measured: {refused}") from refused
    wrong = [f"{miss.key.name} on {miss.key.plan}" for miss in check(measured)]
    if leaf.metadata["sheet"] == "forces":
        from drawings.verify_forces import forces_of  # noqa: PLC0415  (only a force sheet pays for it)

        assert statics is not None  # a force sheet is drawn from them
        wrong += forces_of(measured, leaf, comparison, statics)
    else:
        wrong += _kinematics(measured, leaf, study, comparison)
        wrong += _scales(leaf)
    for group in leaf.groups:
        if group.name.startswith("values"):
            wrong += _table(group, comparison, tuple(int(k) for k in group.data["positions"].split()))
    wrong += unlettered(leaf)
    if wrong:
        more = f" and {len(wrong) - TOLD} more" if len(wrong) > TOLD else ""
        raise SelfCheckFailed(f"the written sheet does not measure back: {', '.join(wrong[:TOLD])}{more}")
    return measured


def _kinematics(measured: Measured, leaf: Leaf, study: Study, comparison: Comparison) -> Iterator[str]:
    """Hold the plans and the points of a kinematics sheet against the analysis."""
    for k in leaf.metadata["plans"]:
        if not any(gap.position == k for gap in comparison.construction.gaps):
            yield from _plans(measured, study, comparison, k)
    if leaf.metadata["shown"] is not None:
        yield from _points(measured, study, comparison, leaf.metadata["shown"])


def _plans(measured: Measured, study: Study, comparison: Comparison, k: int) -> Iterator[str]:
    """Hold the arrows of one position's plans against the analysis: each that must be there, each that is."""
    drafts = study.drafts()
    letters = {name: drafts.velocities.point(name).name for name in comparison.analysis.points}
    expected = Expected(study.mechanism, comparison.analysis, k, letters)
    arrows = expected.arrows(study.groups)
    seen = {(v.plan, *v.name.split(" ")): v for v in measured.vectors if v.position == k}
    scales = {v.plan: v.scale for v in measured.vectors if v.position == k}
    for (plan, start, end), value in arrows.items():
        found = seen.get((plan, start, end))
        must = start in ("p", "π") and end in letters.values()
        if found is not None:
            if not abs(found.value - value) <= _allowed(comparison, found, measured):
                yield f"{start} {end} on {plan} in position {k} (against the analysis)"
        elif must and not abs(value) <= 2 * LEAST * scales.get(plan, 0.0):
            yield f"{start} {end} on {plan} in position {k} is missing"


def _allowed(comparison: Comparison, vector: MeasuredVector, measured: Measured) -> float:
    """Allow the paper's resolution, and twice the largest difference that the plan's own points are allowed."""
    position = vector.position or 0
    own = max((float(finding.allowed[position]) for finding in comparison.of(vector.plan)), default=0.0)
    return 2 * own + 2 * measured.quantum * vector.scale


def _points(measured: Measured, study: Study, comparison: Comparison, shown: int) -> Iterator[str]:
    """Hold the points of the shown position against the analysis; none may be missing."""
    seen = {mark.name: mark for mark in measured.points if mark.position == shown}
    for finding in comparison.of(ORDERS[0]):
        symbol, _, name = finding.name.partition("_")
        true = complex(finding.analysis[shown])
        if symbol != POINT_KEYS[0] or math.isnan(true.real):
            continue
        mark = seen.get(name)
        if mark is None:
            yield f"{name} on the plan of positions is missing"
        elif not abs(mark.value - true) <= float(finding.allowed[shown]) + 2 * measured.quantum * mark.scale:
            yield f"{name} on the plan of positions (against the analysis)"


def _table(table: Group, comparison: Comparison, positions: tuple[int, ...]) -> Iterator[str]:
    """Read a table's numbers back: each value is the analysis's, to the half of its last digit."""
    rows: dict[float, list[Text]] = {}
    for text in (stroke for stroke in _strokes(table) if isinstance(stroke, Text)):
        rows.setdefault(round(text.at.imag, 3), []).append(text)
    named = {finding.name.replace("_", ""): finding for finding in comparison.findings}
    for row in rows.values():
        finding, j = None, 0
        for text in sorted(row, key=lambda text: text.at.real):
            begins = named.get(text.plain.rpartition(", ")[0])
            if begins is not None:  # a table of several blocks has several names in a line
                finding, j = begins, 0
                continue
            if finding is not None and j < 3 * len(positions):
                true, slack = finding.analysis[positions[j // 3]], float(finding.allowed[positions[j // 3]])
                if j % 3 < 2 and not _reads(text.plain, abs(true) if isinstance(true, complex) else float(true), slack):
                    yield f"{text.plain} for {finding.name} of position {positions[j // 3]} in the table"
                j += 1


def _reads(text: str, true: float, slack: float) -> bool:
    """Tell whether a cell is a value to the half of its last digit, beside what the two roads may differ by."""
    if text == "—":
        return math.isnan(true)
    if not _NUMBER.fullmatch(text):
        return False
    plain = text.replace("−", "-").replace(",", ".")
    places = len(plain.partition(".")[2])
    return abs(float(plain) - true) <= 0.5000001 * 10.0**-places + 1e-9 * abs(true) + slack


def _scales(leaf: Leaf) -> Iterator[str]:
    """Read each plan's written scale: mu is the one that its vectors are drawn to, and K is 1/mu to its own digits."""
    for group in leaf.groups:
        stated = {float(s.data["scale"]) for s in _groups(group) if s.data.get("kind") in ("vector", "point")}
        for text in (text.plain for text in _texts(leaf, group.name)):
            found = _SCALE.match(text)
            if found is None and not text.startswith("μ"):
                continue
            symbol, read = (found[1], found[2].replace(",", ".")) if found else ("", "")
            if not all(read == number(1 / mu if symbol == "K" else mu) for mu in stated):
                yield f"the scale {text}"


def _texts(leaf: Leaf, name: str) -> list[Text]:
    return [s for group in leaf.groups if group.name == name for s in _strokes(group) if isinstance(s, Text)]


def _groups(group: Group) -> Iterator[Group]:
    yield group
    for stroke in group.strokes:
        if isinstance(stroke, Group):
            yield from _groups(stroke)


def _strokes(group: Group) -> Iterator[Stroke]:
    for stroke in group.strokes:
        if isinstance(stroke, Group):
            yield from _strokes(stroke)
        else:
            yield stroke
