"""The self-check of what a sheet of dynamics tells: equations of the loop, tables, notes (проверка таблиц)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from drawings.checks import reading
from drawings.checks.dynamics import due_tables
from drawings.checks.dynamics.due_notes import DueNotes
from drawings.checks.dynamics.dynamics_expected import KNOWN, Expected
from drawings.checks.dynamics.loop_equations import equations as due_equations
from drawings.checks.dynamics.told_table import DueTable
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.precise import tells
from drawings.checks.reading import NOTES
from drawings.checks.wrong import Wrong, within
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from drawings.paper.walk import group_named, texts
from plans.checks.dynamics_comparison import DynamicsComparison
from plans.model.dynamics import Reduced
from plans.words.words import message

LOOP, EQUATIONS = "loop", "loop-equations"
DIGITS, FEW, FINE = 4, 3, 5  # of numbers in notes; of per cents there; of numbers in equations
_NUMBER = re.compile(r"[−-]?\d+(?:[.,]\d+)?(?P<share>(?=\s%))?")


def equations(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read the equations beside the loop back."""
    own, loop = group_named(leaf.groups, EQUATIONS), group_named(leaf.groups, LOOP)
    if expected.wheel is None:
        return
    scales = written_scales(loop) if loop is not None else {}
    if own is None or not {"J", "T"} <= scales.keys():
        yield message("wrong.missing", name="J_0")
        return
    seen = [text.plain for text in texts((own,))]
    due = [read(line) for line in due_equations(expected.wheel, (scales["J"], scales["T"]), drafting)]
    if len(seen) != len(due):
        yield message("wrong.missing", name="J_0")
    for text, true in zip(seen, due, strict=False):
        if not tells(text, true, (FINE,), KNOWN):
            yield message("wrong.told", text=text)


def positions(leaf: Leaf, expected: Expected, drafting: Drafting) -> DueTable:
    """Give the table of the edges as a sheet must have it, at one of the counts of positions that there are."""
    said = leaf.metadata["positions"]
    most = min((count for count in due_tables.COUNTS if count >= said), default=max(due_tables.COUNTS))
    return due_tables.edges(expected, most, drafting)


def reduction(reduced: Reduced, drafting: Drafting) -> DueTable:
    """Give the table of the reduction, of a machine whose crank cannot turn fully."""
    return due_tables.reduction(reduced, drafting)


def results(expected: Expected, comparison: DynamicsComparison, drafting: Drafting) -> DueTable:
    """Give the table of results."""
    return due_tables.results(expected, comparison, drafting)


def notes(leaf: Leaf, due: DueNotes) -> Iterator[Wrong]:
    """Read the notes back, sentence for sentence, where they stand on a sheet."""
    seen = reading.notes(leaf)
    if seen:
        told, true = ([_spaced(read(line)) for line in one.all()] for one in (due, due.exactly))
        yield from _sentences(_spaced(seen), told, true)


def lost_notes(leaves: Sequence[Leaf]) -> Iterator[Wrong]:
    """See that the notes of a set stand on one of its sheets."""
    if sum(bool(reading.notes(leaf)) for leaf in leaves) != 1:
        yield message("wrong.missing", name=NOTES)


def _sentences(seen: str, told: Sequence[str], true: Sequence[str]) -> Iterator[Wrong]:
    """Hold what is written to the sentences that are due, as they are told and with all digits of their numbers."""
    masked, whole = _NUMBER.sub("#", seen), " ".join(true)
    lost = [line for line in told if _NUMBER.sub("#", line) not in masked]
    yield from (within("missing_from", NOTES, name=line) for line in lost)
    if lost or masked != _NUMBER.sub("#", whole):
        yield message("wrong.notes")
        return
    for one, other in zip(_NUMBER.finditer(seen), _NUMBER.finditer(whole), strict=True):
        if not tells(one[0], other[0], (FEW if other["share"] is not None else DIGITS,), KNOWN):
            yield within("in", NOTES, text=f"...{seen[max(one.end() - AROUND, 0) : one.end()]}")


AROUND = 40  # letters that are told before a number that is wrong


def _spaced(text: str) -> str:
    return " ".join(text.split())
