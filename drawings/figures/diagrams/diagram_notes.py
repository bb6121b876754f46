"""What a sheet says of the diagrams: how they are drawn, how far chords are out, or why there are none (пояснения)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.figures.diagrams.frame import VELOCITY, DiagramRow, letters_of, rows_of
from drawings.page.drafting import Drafting
from plans.diagrams.study import DiagramsStudy
from plans.words.words import said

PER_CENT = 2  # digits of an error


def diagram_notes(own: DiagramsStudy, drafting: Drafting) -> list[str]:
    """Write the notes on the diagrams; nothing where they are not wanted."""
    if not own.wanted:
        return []
    if own.left_out is not None:
        return [drafting.word("diagrams left out", why=said(own.left_out, drafting.language))]
    return [" ".join(_drawn(own, drafting)), *_errors(own, drafting)]


def _drawn(own: DiagramsStudy, drafting: Drafting) -> Iterator[str]:
    """Say how the diagrams are drawn and counted, and what of a crank that gathers speed is left aside."""
    s, v, a = letters_of(own)
    keys = ("diagrams by chords", f"diagrams {own.counted}", *(("diagrams even",) if own.course.lead else ()))
    yield from (drafting.word(key, s=s, v=v, a=a) for key in keys)


def _errors(own: DiagramsStudy, drafting: Drafting) -> Iterator[str]:
    """Tell how far the chords are out at the most, where, and why."""
    told = [_error(row, own, drafting) for row in rows_of(own)[1:] if row.off is not None and not row.flat]
    if told:
        yield drafting.word("diagrams off", told=",  ".join(told))


def _error(row: DiagramRow, own: DiagramsStudy, drafting: Drafting) -> str:
    assert row.off is not None  # asked only where chords are judged
    numbers, k = own.axis.numbers, row.off.at
    place = f"{numbers[k]}–{numbers[k + 1]}" if row.key == VELOCITY else str(numbers[k])
    off = drafting.number(100 * row.off.share, PER_CENT)
    return drafting.word("diagram off", letter=row.letter, off=off, place=place)
