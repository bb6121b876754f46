"""The feedback sheet: a student's own sheet, what is wrong marked in red, and beside it where to look again (рецензия).

It tells no value of what is asked for. His sheet is a picture in it: nothing of it is written anew, or runs.
"""

from __future__ import annotations

import base64
import re
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path
from xml.sax.saxutils import escape

from drawings.grading import verdict
from drawings.grading.asked import EXACT, Allowance, PlanAsked
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.curves.figure_records import FigureAsked
from drawings.grading.graded import Graded
from drawings.grading.marking import OTHERS, Marking, keys_of
from drawings.grading.seeing.units import shown
from drawings.grading.sheet_task import SheetTask
from drawings.grading.told import Hints, gathered, plain_name, without_values
from drawings.grading.verdict import RIGHT, Verdict
from plans.words.words import word


def idle_keys(marking: Marking, task: SheetTask) -> tuple[str, ...]:
    """Give the keys of points and of tolerances that are of no quantity of a task, as their tables have them."""
    drawn, cells = list(_drawn(task.plans, task.curves)), list(_cells(task.tables))
    points = {key for one in (*drawn, *cells) for key in keys_of(one)} | {OTHERS}
    read = {key for table in task.tables for cell in table.cells.values() for key in _names(cell.quantity)}
    slips = {key for one in drawn for key in _names(one.name)} | read
    idle = [f"points.{key}" for key in marking.points if key not in points]
    return (*idle, *(f"tolerance.{key}" for key in marking.tolerance if key not in slips))


def _names(name: str) -> tuple[str, str]:
    return name, name.partition("_")[0]


def _drawn(plans: Sequence[PlanAsked], curves: Sequence[FigureAsked]) -> Iterator[Verdict]:
    """Give a verdict on each quantity that is drawn."""
    for plan in plans:
        names = (*(one.name for one in plan.vectors), *plan.senses, *plan.turns)
        yield from (Verdict(plan.plan, plan.position, name, RIGHT) for name in names)
    for curve in curves:
        yield from (Verdict(curve.plan, None, one.called, RIGHT) for one in curve.items)


def _cells(tables: Sequence[TableAsked]) -> Iterator[Verdict]:
    for table in tables:
        yield from (Verdict(table.name, cell.position, cell.name, RIGHT) for cell in table.cells.values())


_WRITTEN = re.compile(r"(\d+(?:[.,]\d+)?)\s*(mm|%)?")
MOST = 5.0  # mm: a hand that slips by more draws nothing


def allowance(text: str) -> Allowance | None:
    """Read a tolerance; None of what is none.

    >>> allowance("0.5 mm"), allowance("2 %").share, allowance("much")
    (Allowance(slip=0.5, share=None), 0.02, None)
    """
    if text.strip() == "exact":
        return EXACT
    match = _WRITTEN.fullmatch(text.strip())
    if match is None:
        return None
    size = float(match[1].replace(",", "."))
    if match[2] == "%":
        return Allowance(share=size / 100) if 0 < size <= 100 else None
    return Allowance(size) if 0 < size <= MOST else None


def written(by: Allowance) -> str:
    """Write a tolerance as it is read.

    >>> written(Allowance(0.2)), written(Allowance(share=0.02)), written(EXACT)
    ('0.2 mm', '2 %', 'exact')
    """
    if by == EXACT:
        return "exact"
    return f"{by.slip:g} mm" if by.share is None else f"{100 * by.share:g} %"


MARGIN, LETTERS = 6.0, 62  # mm beside the notes, and letters of a line of them
SIZE, SHARE = 3.2, 110  # mm, the least size of the notes, and how many times as high a sheet is at the least
LEADING, BREADTH = 1.45, 0.6  # sizes, from line to line, and of a letter
RED, WIDTH, RADIUS = "#d00000", 1.2, 2.6  # of what marks a vector; mm; mm of the circle about its number
_GZIP = b"\x1f\x8b"


def feedback(path: Path, source: bytes, graded: Graded, hints: Hints, language: str) -> bytes:
    """Draw the feedback sheet of a graded one."""
    width, height = graded.paper
    wrong = [one for one in gathered(graded.verdicts) if not one.good and one.kind not in (verdict.DEAD, verdict.SMALL)]
    notes = list(_notes(path, wrong, hints, language))
    size = max(SIZE, height / SHARE)
    tall = max(height, 2 * MARGIN + LEADING * size * (len(notes) + 1))
    marks = "".join(_mark(number, one, height) for number, one in enumerate(wrong, 1) if one.at is not None)
    rows = "".join(
        f'<text x="{width + MARGIN:.2f}" y="{MARGIN + LEADING * size * (k + 1):.2f}">{safe(line)}</text>'
        for k, line in enumerate(notes)
    )
    whole = width + 2 * MARGIN + BREADTH * size * LETTERS
    picture = base64.b64encode(shown(source, graded.box)).decode("ascii")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{whole:.2f}mm" height="{tall:.2f}mm" '
        f'viewBox="0 0 {whole:.2f} {tall:.2f}"><rect width="100%" height="100%" fill="#ffffff"/>'
        f'<image width="{width:.2f}" height="{height:.2f}" href="data:image/svg+xml;base64,{picture}"/>'
        f'<g fill="none" stroke="{RED}" stroke-width="{WIDTH}" stroke-opacity="0.7">{marks}</g>'
        f'<g font-family="sans-serif" font-size="{size:.2f}" fill="{RED}">{_numbers(wrong, height)}{rows}</g></svg>\n'
    ).encode("ascii")


def is_plain(source: bytes) -> bool:
    """Tell whether a sheet can be shown as it is: one that is packed is not."""
    return not source.startswith(_GZIP)


def _notes(path: Path, wrong: Sequence[Verdict], hints: Hints, language: str) -> Iterator[str]:
    yield plain_name(Path(path.name))
    for number, one in enumerate(wrong, 1):
        line = f"{number}. {without_values(one, hints, language)}"
        yield from textwrap.wrap(line, LETTERS, subsequent_indent="    ")
    if not wrong:
        yield word(language, "grade.nothing_wrong")


def _mark(number: int, one: Verdict, height: float) -> str:
    assert one.at is not None  # asked of what has a place
    if one.frames and not one.name:
        return "".join(f'<polygon points="{_points(frame, height)}"/>' for frame in one.frames)
    (start, end), round_ = one.at, one.kind in verdict.OF_DRAWING
    if round_ or start == end:
        return f'<circle cx="{end.real:.3f}" cy="{height - end.imag:.3f}" r="{2 * RADIUS}"/>'
    return (
        f'<line id="wrong-{number}" x1="{start.real:.3f}" y1="{height - start.imag:.3f}" '
        f'x2="{end.real:.3f}" y2="{height - end.imag:.3f}"/>'
    )


def _points(frame: Sequence[complex], height: float) -> str:
    return " ".join(f"{spot.real:.3f},{height - spot.imag:.3f}" for spot in frame)


def _numbers(wrong: Sequence[Verdict], height: float) -> str:
    """Write each mark's number beside the middle of its arrow."""
    spots = ((number, (one.at[0] + one.at[1]) / 2) for number, one in enumerate(wrong, 1) if one.at is not None)
    return "".join(
        f'<text x="{spot.real + RADIUS:.2f}" y="{height - spot.imag - RADIUS:.2f}" font-weight="bold">{number}</text>'
        for number, spot in spots
    )


def safe(line: str) -> str:
    """Write a line so that it is text in any encoding."""
    return escape(line).encode("ascii", "xmlcharrefreplace").decode("ascii")
