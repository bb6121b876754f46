"""What is told of graded sheets: lines and tables for a teacher, and a student's feedback sheet (рецензия).

The feedback sheet tells no value of what is asked for. The student's own is a picture in it: nothing of it runs.
"""

from __future__ import annotations

import base64
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path
from xml.sax.saxutils import escape

from drawings.grading import verdict
from drawings.grading.asked import plan_told
from drawings.grading.graded import UNREAD, Graded, Hints
from drawings.grading.verdict import FOLLOWS, MISSING, RIGHT, TABLE, Marking, Verdict, points_of
from plans.words.words import Message, message, word

_FORMULAS = ("=", "+", "-", "@", "\t", "\r")  # by which a spreadsheet knows a formula
HEAD = ("sheet", "outcome", "points", "of", "right", "follows", "mistakes", "what")


def lines(path: Path, graded: Graded, marking: Marking, hints: Hints, language: str) -> Iterator[str]:
    """Tell of one sheet, line by line."""
    yield f"{plain_name(path)}: {_heading(graded, marking).worded(language)}"
    yield from (f"  {told(said, hints, language)}" for said in gathered(graded.verdicts) if not said.good)
    follows = (said for said in graded.verdicts if said.kind == FOLLOWS)
    if follow := tuple(said.name if said.position is None else f"{said.name} ({said.position})" for said in follows):
        yield f"  {word(language, 'grade.follow', names=follow)}"


def gathered(verdicts: Sequence[Verdict]) -> Iterator[Verdict]:
    """Give verdicts with those of a plan, of a table or of a column that is not there at all as one."""
    figures: dict[tuple[str, int | None], list[Verdict]] = {}
    for said in verdicts:
        figures.setdefault((said.plan, None if said.plan.startswith(TABLE) else said.position), []).append(said)
    for (plan, position), every in figures.items():
        if all(said.kind == MISSING for said in every):
            yield _as_one(every, "", position)
        else:
            yield from _columns(every) if plan.startswith(TABLE) else every


def _as_one(lost: Sequence[Verdict], name: str, position: int | None = None) -> Verdict:
    cells = tuple(cell for said in lost for cell in said.frames)
    return lost[0]._replace(name=name, position=position, frames=cells)


def _columns(cells: Sequence[Verdict]) -> Iterator[Verdict]:
    """Give the verdicts on cells with those of a quantity all of whose cells are missing as one."""
    left = list(cells)
    for part in (2, 0):  # first by what stands in brackets, the road of a column, then by the quantity
        names: dict[str, list[Verdict]] = {}
        for said in left:
            names.setdefault(said.name.partition(" (")[part], []).append(said)
        left = []
        for name, column in names.items():
            lost = len(column) > 1 and bool(name) and all(said.kind == MISSING for said in column)
            left += [_as_one(column, name.rstrip(")"))] if lost else column
    yield from left


def plain_name(path: Path) -> str:
    """Write the name of a file that may hold anything: without signs that a terminal obeys."""
    return "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in str(path))


def _heading(graded: Graded, marking: Marking) -> Message:
    if graded.reason is not None:
        key = "grade.refusal" if graded.outcome == UNREAD else f"grade.outcome.{graded.outcome}"
        return message(key, reason=graded.reason)
    won, most = points_of(graded.verdicts, marking)
    return message(f"grade.outcome.{graded.outcome}", won=f"{won:g}", most=f"{most:g}")


def told(said: Verdict, hints: Hints, language: str, silent: bool = False) -> str:
    """Tell what is wrong and which step to look at again; beside it by how much of what is allowed.

    What is `silent` has nothing from which the right value can be had.
    """
    text, steps = _worded(said, language), hints.get(said.name)
    if not silent and said.off is not None and said.allowed is not None:
        off, allowed = f"{said.off:.3g}", f"{said.allowed:.2g}"
        text = word(language, "grade.off", told=text, off=off, allowed=allowed, unit=said.unit)
    return word(language, "grade.again", told=text, steps=steps) if steps else text


def _worded(said: Verdict, language: str) -> str:
    kind = word(language, f"grade.kind.{said.kind}")
    kind = word(language, "grade.of", kind=kind, of=said.of) if said.of else kind
    where = plan_told(said.plan, said.position)
    return word(language, "grade.vector" if said.name else "grade.whole", where=where, name=said.name, kind=kind)


def plain(path: Path, graded: Graded, marking: Marking, language: str) -> dict[str, object]:
    """Give one sheet as plain data."""
    won, most = points_of(graded.verdicts, marking)
    return {
        "sheet": str(path),
        "outcome": graded.outcome,
        "reason": None if graded.reason is None else graded.reason.worded(language),
        "points": won if graded.reason is None else None,
        "of": most if graded.reason is None else None,
        "digest": graded.digest,
        "verdicts": [_plain(said) for said in graded.verdicts],
    }


def _plain(said: Verdict) -> dict[str, object]:
    return {
        "plan": said.plan, "position": said.position, "quantity": said.name, "verdict": said.kind,
        "of": said.of, "off": said.off, "allowed": said.allowed, "unit": said.unit,
    }  # fmt: skip


def row(path: Path, graded: Graded, marking: Marking, language: str) -> list[str]:
    """Give one sheet as a row of the class's table; nothing in it is a formula to a spreadsheet."""
    won, most = points_of(graded.verdicts, marking)
    points = [f"{won:g}", f"{most:g}"] if graded.reason is None else ["", ""]
    counts = [str(sum(said.kind == kind for said in graded.verdicts)) for kind in (RIGHT, FOLLOWS)]
    unlost = (*verdict.GOOD, *verdict.UNGRADED)
    lost = (said for said in gathered(graded.verdicts) if said.kind not in unlost or not said.name)
    reason = graded.reason
    what = "; ".join(_worded(said, language) for said in lost) if reason is None else reason.worded(language)
    cells = [plain_name(path), graded.outcome, *points, *counts, str(len(graded.wrong)), what]
    return [f"'{cell}" if cell.startswith(_FORMULAS) else cell for cell in cells]


MARGIN, LETTERS = 6.0, 62  # mm beside the notes, and letters of a line of them
SIZE, SHARE = 3.2, 110  # mm, the least size of the notes, and how many times as high a sheet is at the least
LEADING, BREADTH = 1.45, 0.6  # sizes, from line to line, and of a letter
RED, WIDTH, RADIUS = "#d00000", 1.2, 2.6  # of what marks a vector; mm; mm of the circle about its number
_GZIP = b"\x1f\x8b"


def feedback(path: Path, source: bytes, graded: Graded, hints: Hints, language: str) -> bytes:
    """Draw the feedback sheet of a graded one."""
    small = (verdict.DEAD, verdict.SMALL)
    wrong = [said for said in gathered(graded.verdicts) if not said.good and said.kind not in small]
    notes = [told(said, hints, language, silent=True) for said in wrong] or [word(language, "grade.nothing_wrong")]
    return annotated(source, graded.paper, plain_name(Path(path.name)), wrong, notes)


def annotated(
    source: bytes, paper: tuple[float, float], title: str, wrong: Sequence[Verdict], notes: Sequence[str]
) -> bytes:
    """Draw a sheet with what is wrong in red and numbered, and beside it what is said of that."""
    width, height = paper
    size = max(SIZE, height / SHARE)
    numbered = [f"{k}. {note}" if wrong else note for k, note in enumerate(notes, 1)]
    rows = [title, *(row for note in numbered for row in textwrap.wrap(note, LETTERS, subsequent_indent="    "))]
    tall = max(height, 2 * MARGIN + LEADING * size * (len(rows) + 1))
    marks = "".join(_mark(number, said, height) for number, said in enumerate(wrong, 1))
    lines = "".join(
        f'<text x="{width + MARGIN:.2f}" y="{MARGIN + LEADING * size * (k + 1):.2f}">{safe(row)}</text>'
        for k, row in enumerate(rows)
    )
    whole = width + 2 * MARGIN + BREADTH * size * LETTERS
    picture = base64.b64encode(source).decode("ascii")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{whole:.2f}mm" height="{tall:.2f}mm" '
        f'viewBox="0 0 {whole:.2f} {tall:.2f}"><rect width="100%" height="100%" fill="#ffffff"/>'
        f'<image width="{width:.2f}" height="{height:.2f}" href="data:image/svg+xml;base64,{picture}"/>'
        f'<g fill="none" stroke="{RED}" stroke-width="{WIDTH}" stroke-opacity="0.7">{marks}</g>'
        f'<g font-family="sans-serif" font-size="{size:.2f}" fill="{RED}">{_numbers(wrong, height)}{lines}</g></svg>\n'
    ).encode("ascii")


def is_plain(source: bytes) -> bool:
    """Tell whether a sheet can be shown as it is: one that is packed is not."""
    return not source.startswith(_GZIP)


def _mark(number: int, said: Verdict, height: float) -> str:
    """Mark what is wrong at a place: with a line along it, about it, or with the frames of cells."""
    if said.at is None:
        return ""
    if said.frames and not said.name:
        frames = (" ".join(f"{spot.real:.3f},{height - spot.imag:.3f}" for spot in frame) for frame in said.frames)
        return "".join(f'<polygon points="{points}"/>' for points in frames)
    start, end = said.at
    if said.kind in verdict.OF_DRAWING or start == end:
        return f'<circle cx="{end.real:.3f}" cy="{height - end.imag:.3f}" r="{2 * RADIUS}"/>'
    return (
        f'<line id="wrong-{number}" x1="{start.real:.3f}" y1="{height - start.imag:.3f}" '
        f'x2="{end.real:.3f}" y2="{height - end.imag:.3f}"/>'
    )


def _numbers(wrong: Sequence[Verdict], height: float) -> str:
    """Write each mark's number beside the middle of its arrow."""
    spots = ((number, (said.at[0] + said.at[1]) / 2) for number, said in enumerate(wrong, 1) if said.at is not None)
    return "".join(
        f'<text x="{spot.real + RADIUS:.2f}" y="{height - spot.imag - RADIUS:.2f}" font-weight="bold">{number}</text>'
        for number, spot in spots
    )


def safe(line: str) -> str:
    """Write a line so that it is text in any encoding."""
    return escape(line).encode("ascii", "xmlcharrefreplace").decode("ascii")
