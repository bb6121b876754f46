"""What a sheet of a cam tells, read back: notes, sizes in the figure, headings, scale (надписи листа кулачка)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from drawings.checks.cam.cam_expected import Expected, phase_name
from drawings.checks.cam.due_notes import DueNotes
from drawings.checks.documents_old import written_notes
from drawings.checks.graphs.figure_strokes import FigureStrokes, read
from drawings.checks.graphs.scale_line import ratio
from drawings.checks.precise import KNOWN, precise, tells
from drawings.checks.wrong import Wrong
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups, texts
from plans.words.words import message

BLOCK = "title-block"  # the name of its figure
DIGITS = (4, 5)  # of the numbers of the notes; of the phases
MM = 1000.0
_SIZE = re.compile(r"(?P<name>[^=]+?)\s=\s(?P<value>[−\d.,]+)°?")


def notes(leaf: Leaf, expected: Expected, agreed: Iterable[str], drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes back, from the description of every sheet and from where they are written on the first.

    `agreed` is what they must say last, of both roads and of the hand.
    """
    due = (*DueNotes(expected.found, precise(drafting)).all(), *agreed)
    return written_notes.faults(leaf, due, DIGITS)


def sizes(strokes: FigureStrokes, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read the sizes in the figure of the profile back."""
    own, cam = expected.sizes, expected.cam
    true = {"R_0": MM * own.base, "e": MM * own.offset, "L": MM * own.centre}
    true |= {"ψ_0": math.degrees(abs(own.initial))}
    if expected.found.sharpest is not None:
        true["ρ_{min}"] = MM * expected.found.sharpest.value
    phases = {read(phase_name(cam, k, drafting)) for k in range(len(cam.phases))}
    yield from numbers(strokes, {letter: (value,) for letter, value in true.items()}, drafting, phases)


def numbers(
    strokes: FigureStrokes, true: Mapping[str, Sequence[float]], drafting: Drafting, others: Set[str] = frozenset()
) -> Iterator[Wrong]:
    """Read the numbers that stand beside letters back: each is one that its letter has, none is of a strange letter."""
    due = {read(letter): values for letter, values in true.items()}
    for text in strokes.texts:
        found = _SIZE.fullmatch(text)
        if found is None or text in others:
            continue
        exact = (precise(drafting).number(value) for value in due.get(found["name"], ()))
        if not any(tells(found["value"], one, DIGITS[:1], KNOWN) for one in exact):
            yield message("wrong.told", text=text)


def headings(leaf: Leaf, strokes: FigureStrokes, mu: float, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold the title of the figure with its ratio, the title of the sheet and its scale in the title block."""
    written = [text.plain for one in groups(leaf.groups) if one.name == BLOCK for text in texts((one,))]
    told = ratio(mu, drafting.language)
    if told not in written:
        yield message("wrong.scale", text=told)
    if drafting.notation == "mu" and not any(text.endswith(f"({told})") for text in strokes.texts):
        yield message("wrong.scale", text=told)
    if read(drafting.word("cam profile")) not in strokes.texts:
        yield message("wrong.missing", name=drafting.word("cam profile"))
    title = drafting.word("cam sheet title", name=expected.cam.name)
    if title not in " ".join(written) or not leaf.title.endswith(title):
        yield message("wrong.missing", name=title)


def decimals(leaf: Leaf, drafting: Drafting) -> Iterator[Wrong]:
    """See that every number has the decimal mark of the sheet's language."""
    strange = "." if drafting.number(0.5)[1] == "," else ","
    for one in leaf.groups:
        if one.name not in (BLOCK, "frame"):
            yield from (
                message("wrong.told", text=text.plain) for text in texts((one,)) if _marked(text.plain, strange)
            )


def _marked(text: str, mark: str) -> bool:
    return re.search(rf"\d{re.escape(mark)}\d", text) is not None
