"""The self-check of written sheets: each is as it was laid out, and states what the analysis gives (самопроверка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from drawings.checks import hold
from drawings.checks.differences import differences, plain
from drawings.checks.expected import Expected, Wrong, on
from drawings.checks.hold import unlettered
from drawings.checks.readers import block_faults, marked_scales, scale_faults
from drawings.files.atomic_files import Enclosure
from drawings.paper.limits import QUANTUM, SheetRefused
from drawings.paper.strokes import Arc, Key, Leaf, Text
from drawings.reading.covering import COVERED, OUTSIDE, small, veiled
from drawings.reading.items import SheetFigures, items
from drawings.reading.measure import Measured, check
from drawings.reading.sheet import SeenSheet, see
from drawings.symbols.symbols import BLOCK
from geometry.errors import DraftError
from plans.quantity import Comparison
from plans.scene.sheet import SheetTable
from plans.words.words import Message, message

TOLD = 5  # mismatches told one by one
SYMBOL = abs(complex(*BLOCK)) + QUANTUM  # mm: no symbol of a pair is larger, from corner to corner


class SelfCheckFailed(DraftError):  # noqa: N818  (the exit code's own word)
    """A sheet or a comparison that failed plandraft's own check; the sheet is withheld."""

    exit_code = 5


class WrittenSheet(NamedTuple):
    """A sheet as it was laid out, and as it was seen in its file; without being seen it cannot be measured."""

    leaf: Leaf
    seen: SeenSheet | SheetRefused


def written(path: Path, leaf: Leaf) -> WrittenSheet:
    """See a written sheet."""
    try:
        return WrittenSheet(leaf, see(path.read_bytes()))
    except SheetRefused as refused:
        return WrittenSheet(leaf, refused)


def wrongs(sheets: Sequence[WrittenSheet], expected: Mapping[Key, Expected], sheet: SheetTable) -> list[list[Wrong]]:
    """List, for each sheet of a kind, what is wrong with it.

    It is held stroke by stroke to what was laid out, and that with all its digits to the analysis. What stands on no
    sheet lacks on those that bear its figure.
    """
    faults = [[*_wrong(page, expected, sheet)] for page in sheets]
    stated = [hold.stated_keys(page.leaf) for page in sheets]
    lost = [row for key, row in expected.items() if not row.may_lack and not any(key in keys for keys in stated)]
    for row in lost:
        bearing = [k for k, keys in enumerate(stated) if any(key[1] == row.figure for key in keys)]
        for k in bearing or [0]:
            faults[k].append(hold.wrong("missing_on", row.key))
    return faults


def _wrong(page: WrittenSheet, expected: Mapping[Key, Expected], sheet: SheetTable) -> Iterator[Wrong]:
    if isinstance(page.seen, SheetRefused):
        yield message("check.unmeasured", refusal=page.seen)
        return
    yield from differences(plain(page.leaf, page.seen.leaf.lettering, stating=False), page.seen)
    yield from measured_wrongs(page.seen.measured, page.leaf, expected)
    yield from block_faults(page.leaf, sheet)


def measured_wrongs(
    measured: Measured, leaf: Leaf, expected: Mapping[Key, Expected], only: Iterable[Key] = ()
) -> Iterator[Wrong]:
    """List what a measured sheet states otherwise than the analysis; of `only` some none may lack."""
    yield from (on("on", miss.key.plan, name=miss.key.name) for miss in check(measured))
    yield from hold.faults(hold.readings(measured, leaf), expected, frozenset(only))
    yield from unlettered(leaf, {key: row.letter for key, row in expected.items()})
    yield from marked_scales(leaf)


def obscured(sheet: SeenSheet) -> list[Message]:
    """Tell what is right and badly drawn: lettering that is covered, whatever is off the paper or under a large area.

    A line may be short and end under a hinge, an arc be one of those that notch the centre of a cam's roller.
    """
    leaf = sheet.written
    under = {id(unseen.stroke): unseen for unseen in sheet.unseen if unseen.reason in (COVERED, OUTSIDE)}
    notches = {of for of, unseen in under.items() if isinstance(unseen.stroke, Arc) and unseen.reason == COVERED}
    lines = {of for of, unseen in under.items() if not isinstance(unseen.stroke, Text)} - notches
    large = {id(unseen.stroke) for unseen in veiled(leaf, small(leaf, SYMBOL), among=lines)} if lines else ()
    held = [of for of, unseen in under.items() if isinstance(unseen.stroke, Text) or of in large]
    if not held:
        return []
    from drawings.sheet_diff.edit import lone  # noqa: PLC0415  (only what is badly drawn pays for it)

    figures, right = SheetFigures(leaf), {id(item.stroke): item for item in items(leaf)}
    return [lone("hidden", right[of], figures, reason=under[of].reason).told for of in held]


def cramped(figure: str) -> Message:
    """Tell of a figure that it is too small for its letters."""
    return on("cramped", figure)


def scale_wrongs(page: WrittenSheet, keys: Mapping[str, str], sheet: SheetTable) -> list[Wrong]:
    """List the figures of a sheet that have another scale than is stated; `keys` are those of [sheet.scale]."""
    return [] if isinstance(page.seen, SheetRefused) else [*scale_faults([(keys, page.seen.measured)], sheet)]


def enclosure_wrongs(path: Path, enclosure: Enclosure) -> list[Wrong]:
    """List what is wrong with a written file beside the sheets."""
    return list(enclosure.faults(path.read_bytes()))


def first(wrong: Iterable[Wrong]) -> Message | tuple[Wrong, ...]:
    """Name the first of what is wrong, and how much more there is."""
    faults = list(dict.fromkeys(wrong))
    marks, more = tuple(faults[:TOLD]), len(faults) - TOLD
    return message("check.more", marks=marks, count=more) if more > 0 else marks


def disagreement(comparison: Comparison) -> SelfCheckFailed | None:
    """Say in what both roads differ by more than is allowed, or which gap one of them alone names."""
    for gap, by in ((lone.gap, lone.by) for lone in comparison.alone[:1]):
        why = message(f"check.{by}", position=gap.position, plan=gap.plan, reason=gap.reason)
        return SelfCheckFailed(why)
    return SelfCheckFailed(comparison.apart) if comparison.worst > 1.0 else None
