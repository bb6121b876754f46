"""Assertions about a sheet that is handed in: they say in true units what is wrong, and where (утверждения)."""

from __future__ import annotations

import base64
import os
import textwrap
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

from drawings.files.atomic_files import write
from drawings.grading import verdict
from drawings.grading.allowance import Allowance
from drawings.grading.feedback import RADIUS, RED, WIDTH, gathered, is_plain, safe, with_values, without_values
from drawings.grading.graded import Graded
from drawings.grading.verdict import Verdict
from drawings.paper.limits import SHEET_BYTES
from drawings.pytest_plugin.assignment import AcceptanceError, Assignment, FilePath, OnPaper, tolerated
from drawings.pytest_plugin.handed_sheet import HandedSheet, ReadVector, handed
from geometry.errors import regular_bytes
from plans.words.words import Message, message

MOST = 12  # places in one picture
ACROSS = 3  # places side by side
TILE, GAP, LETTER = 60.0, 6.0, 3.2  # mm: a place's side on the picture, what is left between, letters under it
ROOM = 15.0  # mm of the sheet about what is wrong
LEAST = 40.0  # mm of the sheet that a place shows at the least: what is wrong is told by what is about it
LETTERS, LINES = 34, 2  # of a line under a place, and lines
UNDER = 1.5 * LETTER * LINES  # mm


class WrongPlace(NamedTuple):
    """What is wrong at a place of a sheet: in words, and from where to where it lies, mm, y up."""

    told: str
    start: complex
    end: complex


def picture(source: bytes, paper: tuple[float, float], spots: Sequence[WrongPlace]) -> bytes:
    """Draw the places of a sheet side by side."""
    shown, (width, height) = spots[:MOST], paper
    columns, rows = min(ACROSS, len(shown)), -(-len(shown) // ACROSS)
    wide, high = GAP + columns * (TILE + GAP), GAP + rows * (TILE + UNDER + GAP)
    sheet = base64.b64encode(source).decode("ascii")
    tiles = "".join(_tile(k, spot, height) for k, spot in enumerate(shown))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:g}mm" height="{high:g}mm" '
        f'viewBox="0 0 {wide:g} {high:g}"><defs><image id="sheet" width="{width:g}" height="{height:g}" '
        f'href="data:image/svg+xml;base64,{sheet}"/></defs>'
        f'<rect width="100%" height="100%" fill="#ffffff"/>{tiles}</svg>\n'
    ).encode("ascii")


def _tile(number: int, spot: WrongPlace, height: float) -> str:
    """Draw one place, with what it is under it."""
    x, y = GAP + number % ACROSS * (TILE + GAP), GAP + number // ACROSS * (TILE + UNDER + GAP)
    rows = textwrap.wrap(spot.told, LETTERS, max_lines=LINES, placeholder="…")
    lines = "".join(
        f'<text x="{x:g}" y="{y + TILE + 1.5 * LETTER * (k + 1):g}">{safe(line)}</text>' for k, line in enumerate(rows)
    )
    box = f'x="{x:g}" y="{y:g}" width="{TILE:g}" height="{TILE:g}"'
    return (
        f'<svg {box} viewBox="{" ".join(_window(spot, height))}"><use href="#sheet"/>{_mark(spot, height)}</svg>'
        f'<rect {box} fill="none" stroke="#808080" stroke-width="0.2"/>'
        f'<g font-family="sans-serif" font-size="{LETTER:g}" fill="{RED}">{lines}</g>'
    )


def _window(spot: WrongPlace, height: float) -> Iterator[str]:
    """Give what a place shows of the sheet: left, top and both sides, mm, y down."""
    middle, reach = (spot.start + spot.end) / 2, spot.end - spot.start
    side = max(LEAST, abs(reach.real) + 2 * ROOM, abs(reach.imag) + 2 * ROOM)
    yield from (f"{size:.3f}" for size in (middle.real - side / 2, height - middle.imag - side / 2, side, side))


def _mark(spot: WrongPlace, height: float) -> str:
    look = f'fill="none" stroke="{RED}" stroke-width="{WIDTH}" stroke-opacity="0.7"'
    if spot.start == spot.end:
        return f'<circle cx="{spot.end.real:.3f}" cy="{height - spot.end.imag:.3f}" r="{RADIUS}" {look}/>'
    ends = (spot.start.real, height - spot.start.imag, spot.end.real, height - spot.end.imag)
    return "<line {} {}/>".format(
        " ".join(f'{name}="{size:.3f}"' for name, size in zip(("x1", "y1", "x2", "y2"), ends, strict=True)), look
    )


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
        spots = [WrongPlace(edit.told.worded(drawn.language), edit.at, edit.at) for edit in edits]
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
        say = partial(without_values, hints={}, language=sheet.language)
        spots = [WrongPlace(say(said), *said.at) for said in wrong if said.at is not None]
        raise AssertionError(_worded(sheet, head, lines, graded.paper, spots))


def _lines(sheet: HandedSheet, graded: Graded, said: Verdict) -> Iterator[str]:
    """Tell of a verdict, and what is drawn and what the analysis gives."""
    hints = _scene(sheet).task.hints
    yield (without_values if sheet.silent else with_values)(said, hints, sheet.language)
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
        write(file, picture(source, paper, spots[:MOST]))
        yield os.fspath(file)
