"""The feedback sheet: a student's own sheet, what is wrong marked in red, and beside it where to look again (рецензия).

It tells no value of what is asked for. His sheet is a picture in it: nothing of it is written anew, or runs.
"""

from __future__ import annotations

import base64
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path
from xml.sax.saxutils import escape

from drawings.grading import verdict
from drawings.grading.graded import Graded
from drawings.grading.seeing.units import shown
from drawings.grading.told import Hints, gathered, plain_name, without_values
from drawings.grading.verdict import Verdict
from plans.words.words import word

MARGIN, LETTERS = 6.0, 62  # mm beside the notes, and letters of a line of them
SIZE, SHARE = 3.2, 110  # mm, the least size of the notes, and how many times as high a sheet is at the least
LEADING, BREADTH = 1.45, 0.6  # sizes, from line to line, and of a letter
RED, WIDTH, RADIUS = "#d00000", 1.2, 2.6  # of what marks a vector; mm; mm of the circle about its number
_GZIP = b"\x1f\x8b"


def feedback(path: Path, source: bytes, graded: Graded, hints: Hints, language: str) -> bytes:
    """Draw the feedback sheet of a graded one."""
    width, height = graded.paper
    wrong = [one for one in gathered(graded.verdicts) if not one.good and one.kind not in verdict.UNGRADED]
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
