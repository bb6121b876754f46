"""Assertions about a sheet that is handed in: they say in true units what is wrong, and where (утверждения)."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import TypeAlias

from drawings.files.atomic_files import write
from drawings.grading import verdict
from drawings.grading.allowance import Allowance
from drawings.grading.feedback import annotated, gathered, is_plain, told
from drawings.grading.graded import Graded
from drawings.grading.verdict import Verdict
from drawings.paper.limits import SHEET_BYTES
from drawings.pytest_plugin.assignment import AcceptanceError, Assignment, FilePath, OnPaper, tolerated
from drawings.pytest_plugin.handed_sheet import HandedSheet, ReadVector, handed
from geometry.errors import regular_bytes
from plans.words.words import Message, message

MOST = 40  # places in one picture


WrongPlace: TypeAlias = tuple[str, complex, complex]  # in words, and from where to where it lies, mm, y up


def picture(source: bytes, paper: tuple[float, float], title: str, spots: Sequence[WrongPlace]) -> bytes:
    """Draw a sheet with the places of what is wrong."""
    wrong = [Verdict("", None, told, verdict.WRONG, at=(start, end)) for told, start, end in spots[:MOST]]
    return annotated(source, paper, title, wrong, [said.name for said in wrong])


# Findings of a file that was saved again, with nothing on it changed: a file is no sheet.
RESAVED = ("seal", "set")
TOLD = 30  # lines of what is wrong in one message


def assert_close_to_analysis(
    sheet: HandedSheet | FilePath, scene: Assignment | FilePath | None = None, tolerance: str = "0.2 mm"
) -> None:
    """Fail if a vector, a value or a number is not what the analysis gives, or cannot be read.

    The tolerance is "2 %" of the plan's largest vector, "0.2 mm" by which a hand slips in each act, or "exact".
    """
    __tracebackhide__ = True
    drawn = handed(sheet).of(scene)
    by = tolerated(tolerance)
    graded = _scene(drawn).graded(drawn.path, by)
    wrong = [said for said in (*graded.wrong, *graded.unseen) if said.kind not in verdict.OF_DRAWING]
    _assert_none(drawn, graded, wrong, message("accept.off", sheet=drawn.path.name, tolerance=by.stated))


def assert_well_drawn(sheet: HandedSheet | FilePath, scene: Assignment | FilePath | None = None) -> None:
    """Fail if a scale is not written, arrows do not meet, or letters are missing or swapped."""
    __tracebackhide__ = True
    drawn = handed(sheet).of(scene)
    graded = _scene(drawn).graded(drawn.path, Allowance())
    wrong = [said for said in graded.wrong if said.kind in verdict.OF_DRAWING]
    _assert_none(drawn, graded, wrong, message("accept.ill_drawn", sheet=drawn.path.name))


def assert_sheet_matches(sheet: HandedSheet | FilePath, scene: Assignment | FilePath | None = None) -> None:
    """Fail if anything on a sheet of ours is not as its scene gives it; a file that was only saved again passes."""
    __tracebackhide__ = True
    drawn = handed(sheet).of(scene)
    held = _scene(drawn).held(drawn.path)
    if not isinstance(held, OnPaper):
        raise AssertionError(_rejected(drawn, held))
    wrong = [finding for finding in held.checked.findings if finding.kind not in RESAVED]
    if wrong:
        edits = [said.edit for said in wrong if said.edit is not None]
        spots = [(edit.told.worded(drawn.language), edit.at, edit.at) for edit in edits]
        head = message("accept.other", sheet=drawn.path.name, scene=_scene(drawn).originals.path.name)
        lines = [finding.told.worded(drawn.language) for finding in wrong]
        raise AssertionError(_worded(drawn, head, lines, held.paper, spots))


def _scene(drawn: HandedSheet) -> Assignment:
    if drawn.scene is None:
        raise AcceptanceError(message("accept.sceneless", sheet=drawn.path.name))
    return drawn.scene


def _rejected(drawn: HandedSheet, graded: Graded) -> str:
    return message("accept.rejected", sheet=drawn.path.name, reason=graded.reason).worded(drawn.language)


def _assert_none(sheet: HandedSheet, graded: Graded, wrong: Sequence[Verdict], head: Message) -> None:
    """Fail if anything is wrong, or nothing can be said."""
    __tracebackhide__ = True
    if graded.reason is not None:
        raise AssertionError(_rejected(sheet, graded))
    if wrong:
        lines = [line for said in gathered(wrong) for line in _lines(sheet, graded, said)]
        places = [(told(said, {}, sheet.language, silent=True), said.at) for said in wrong]
        spots = [(what, *at) for what, at in places if at is not None]
        raise AssertionError(_worded(sheet, head, lines, graded.paper, spots))


def _lines(sheet: HandedSheet, graded: Graded, said: Verdict) -> Iterator[str]:
    """Tell of a verdict, and what is drawn and what the analysis gives."""
    hints = _scene(sheet).task.hints
    yield told(said, hints, sheet.language, sheet.silent)
    plan = next((plan for plan in graded.drawn if plan.asked.place == (said.plan, said.position)), None)
    if sheet.silent or plan is None:
        return
    drawn = plan.value(said.letters)
    true = next((asked.true for asked in plan.asked.vectors if asked.letters == said.letters), None)
    if drawn is not None and true is not None and said.name:
        parts = {"drawn": _value(said, drawn), "true": _value(said, true)}
        yield f"  {message('accept.values', **parts).worded(sheet.language)}"


def _value(said: Verdict, value: complex) -> Message:
    """Word a vector by its size and direction; a point by its coordinates."""
    if said.letters[0] == "":
        return message("accept.point", x=f"{value.real:.4g}", y=f"{value.imag:.4g}", unit=said.unit)
    read = ReadVector(said.name, value, said.unit)
    return message("accept.vector", size=f"{read.size:.4g}", angle=f"{read.angle:.1f}", unit=said.unit)


def _worded(
    sheet: HandedSheet, head: Message, lines: Sequence[str], paper: tuple[float, float], spots: Sequence[WrongPlace]
) -> str:
    """Tell what is wrong, line by line, and where its picture lies, if pictures are drawn."""
    left = len(lines) - TOLD
    more = [message("checked.more", count=left).worded(sheet.language)] if left > 0 else []
    pictures = [message("accept.picture", file=path).worded(sheet.language) for path in _pictured(sheet, paper, spots)]
    return "\n  ".join([head.worded(sheet.language), *lines[:TOLD], *more, *pictures])


def _pictured(sheet: HandedSheet, paper: tuple[float, float], spots: Sequence[WrongPlace]) -> Iterator[str]:
    """Draw the places of what is wrong into the report's folder."""
    if sheet.report is None or not spots or not all(paper):
        return
    source = regular_bytes(sheet.path, SHEET_BYTES + 1)
    if is_plain(source):
        sheet.report.mkdir(parents=True, exist_ok=True)
        file = sheet.report / f"{sheet.name or sheet.path.stem}.svg"
        write(file, picture(source, paper, sheet.path.name, spots))
        yield os.fspath(file)
