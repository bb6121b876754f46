"""Notes on paper: paragraphs broken between their words, but in no equation and no range (пояснения на листе)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from drawings.layout.block import NARROW, Notes
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import SLOT, template_of
from drawings.page.page import Field
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import LEAN, Group, Stroke, Text
from drawings.paper.walk import stating

TOGETHER = re.compile(r" (=|…|−|[+]) ")
NOTES = "notes"  # the name of their group
CLEAR = 0.5  # mm from a line of notes to the frame
STEP = 1.8  # sizes of the letters from line to line: GOST 2.304-81 asks for 1.7 at least


def measure(paragraphs: Sequence[str], size: float, least: float = 0.0) -> Notes:
    """Measure what notes need on paper, in columns of no less than `least` mm and none too narrow for their letters."""
    lengths = tuple(text_width(Text(0j, _marked(note), size)) for note in paragraphs)
    return Notes(lengths, STEP * size, max(least, NARROW * size))


def write(paragraphs: Sequence[str], field: Field, size: float, edge: float) -> Group:
    """Write notes from the top of their field downwards, a long one broken between its parts, clear of an edge, mm."""
    width = min(field.width, edge - CLEAR - LEAN * size - field.left)  # the last letter leans beyond its width
    broken = [_broken(_marked(note), width, size) for note in paragraphs]
    step = min(STEP * size, field.height / max(sum(map(len, broken)), 1))
    strokes, count = list[Stroke](), 0
    for note, lines in zip(paragraphs, broken, strict=True):
        feet = [complex(field.left, field.top - size - (count + k) * step) for k in range(len(lines))]
        own = [Text(foot, line, size, "start", True) for foot, line in zip(feet, lines, strict=True)]
        strokes += (
            [stating(Statement(Kind.PHRASE, NOTES, told), *own)] if SLOT.search(told := template_of(note)) else own
        )
        count += len(lines)
    return Group(tuple(strokes), NOTES)


def _broken(note: str, width: float, size: float) -> list[str]:
    """Break a note at its spaces where it is wider than its field, but no equation and no range."""
    lines = [""]
    for part in TOGETHER.sub(lambda sign: f"\N{NO-BREAK SPACE}{sign[1]}\N{NO-BREAK SPACE}", note).split(" "):
        trial = f"{lines[-1]} {part}".strip()
        if lines[-1] and text_width(Text(0j, trial, size)) > width:
            lines.append(part)
        else:
            lines[-1] = trial
    return lines


def _marked(note: str) -> str:
    """Lower the kind's number in II2(4,5); the rest of a note stays as it is."""
    out, k = [], 0
    while k < len(note):
        if note.startswith("II", k) and k + 2 < len(note) and note[k + 2].isdigit():
            out.append(f"II_{{{note[k + 2]}}}")
            k += 3
        else:
            out.append(note[k])
            k += 1
    return "".join(out)
