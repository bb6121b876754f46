"""The angles of a cam's phases, exact, their sum a whole turn; travels of a cam that translates (фазовые углы)."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction

from plans.cam.reading.entry import Entry, Exact, shown
from plans.cam.reading.fields import CYCLOGRAM, REST
from plans.model.cam import DWELL

WHOLE = Fraction(360)
SNAPPED = Fraction(1, 10**6)  # degrees: so near a whole turn a sum is taken for one, and that is said
RADIANS = Fraction("6.283185307179586"), Fraction(1, 100)  # a whole turn, and how near it angles in radians are


def turns_of(entry: Entry, window: Fraction | None) -> Exact | None:
    """Give the phases' angles in degrees (travels m), or nothing where they are at fault or wait for the cyclogram."""
    if entry.translates:
        return _travels(entry)
    known, before = [_known(one.angle, window) for one in entry.form.phases], len(entry.faults)
    stated = sum(filter(None, known), Fraction(0))
    _words(entry, window, stated)
    waits = window is None and any(one.angle == CYCLOGRAM for one in entry.form.phases)
    if waits or len(entry.faults) > before:
        return None
    found = [WHOLE - stated if angle is None else angle for angle in known]
    return snapped(found) if _fits(entry, found) else None


def _known(angle: Decimal | str | None, window: Fraction | None) -> Fraction | None:
    """Give an angle that the file or the cyclogram states."""
    return Fraction(angle) if isinstance(angle, Decimal) else window if angle == CYCLOGRAM else None


def _travels(entry: Entry) -> Exact | None:
    for number, one in enumerate(entry.form.phases):
        if one.travel is None:
            entry.fault(("phases", number, "angle"), "mixed_phases")
            return None
    return tuple(Fraction(one.travel or 0) for one in entry.form.phases)


def _words(entry: Entry, window: Fraction | None, stated: Fraction) -> None:
    """See that words stand for one angle each, and that the others leave something to them."""
    angles = [one.angle for one in entry.form.phases]
    places = {word: [k for k, angle in enumerate(angles) if angle == word] for word in (REST, CYCLOGRAM)}
    for word, found in places.items():
        for number in found[1:]:
            entry.fault(("phases", number, "angle"), "word_twice", word=word)
    if places[CYCLOGRAM] and not places[REST]:
        entry.fault(("phases", places[CYCLOGRAM][0], "angle"), "no_rest")
    waiting = [*places[REST], *(places[CYCLOGRAM] if window is None else ())]
    if waiting and stated > WHOLE:
        entry.fault(("phases", waiting[0], "angle"), "nothing_left", found=shown(stated))


def _fits(entry: Entry, found: Sequence[Fraction]) -> bool:
    """See that the angles make a whole turn, and that none but a dwell's is 0."""
    before = len(entry.faults)
    phases = entry.form.phases
    for number, (one, angle) in enumerate(zip(phases, found, strict=True)):
        if angle == 0 and one.kind != DWELL:
            entry.fault(("phases", number, "angle"), "zero_phase")
    total = sum(found, Fraction(0))
    if abs(total - WHOLE) > SNAPPED:
        last = ("phases", len(phases) - 1, "angle")
        kind = "phases_long" if total > WHOLE else "phases_short"
        kind = "phases_radians" if abs(total - RADIANS[0]) < RADIANS[1] else kind
        entry.fault(last, kind, found=shown(total), off=shown(abs(total - WHOLE)))
    return len(entry.faults) == before


def snapped(angles: Sequence[Fraction]) -> Exact:
    """Give angles whose sum is a whole turn exactly: the largest takes what is over.

    >>> [str(one) for one in snapped([Fraction(120), Fraction("240.0000001")])]
    ['120', '240']
    """
    largest = max(range(len(angles)), key=angles.__getitem__)
    over = sum(angles, Fraction(0)) - WHOLE
    return tuple(angle - over if number == largest else angle for number, angle in enumerate(angles))
