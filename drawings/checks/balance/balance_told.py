"""The self-check of the notes on a balanced mechanism: word by word, each number to its last digit (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

from drawings.checks.balance.balance_expected import KNOWN, Expected
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, within
from drawings.figures.balance.scheme import AFTER, BEFORE
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import groups, texts
from drawings.report.balance.balance_notes import BalanceNotes

NOTES = "notes"  # the name of their figure
DIGITS = BalanceNotes._field_defaults["digits"]


def notes(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Read the notes of the first sheet back."""
    if not leaf.metadata["notes"]:
        return
    seen = [text.plain for one in groups(leaf.groups) if one.name == NOTES for text in texts((one,))]
    due = [Text(0j, note).plain for note in notes_of(expected, precise(expected.drafting)).all]
    for text, true in zip_longest(_words(seen), _words(due), fillvalue=""):
        if not tells(text, true, (DIGITS,), KNOWN):
            said = within("in", NOTES, text=text) if text else within("missing_from", NOTES, name=true)
            yield said
            return  # what follows stands aside


def _words(lines: list[str]) -> list[str]:
    return " ".join(lines).split()


def notes_of(expected: Expected, drafting: Drafting) -> BalanceNotes:
    """Give the notes by the analysis."""
    after = expected.vectors(AFTER) if expected.after is not None else None
    vectors = expected.vectors(BEFORE), after
    own = expected.own
    return BalanceNotes(expected.mechanism, own.tree, own.machine, expected.balance, vectors, drafting)
