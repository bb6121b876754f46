"""The self-check of the notes on a balanced mechanism: each sentence, each number to its last digit (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance_words.balance_sentences import BalanceSentences
from drawings.checks.balance_words.sentences import Sentence, on_sheet, wrong_notes
from drawings.checks.balance_words.sentences import notes as told
from drawings.checks.wrong import Wrong
from drawings.paper.strokes import Leaf

DIGITS = 5  # of the numbers


def notes(leaf: Leaf, expected: Expected) -> Iterator[Wrong]:
    """Read the notes of the first sheet back."""
    if leaf.metadata["notes"] or told(leaf):
        due = BalanceSentences(expected, DIGITS).all()
        yield from wrong_notes(leaf, [Sentence(on_sheet(one)) for one in due])
