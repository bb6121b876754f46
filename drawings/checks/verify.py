"""The self-check of a written sheet: everything on it that can be measured or read is held against the analysis."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

from drawings.checks.documents import numbering, scales
from drawings.checks.labelled import unlettered
from drawings.checks.seen.differences import differences
from drawings.checks.seen.plain import plain
from drawings.checks.wrong import Wrong, on
from drawings.collation.edit import lone
from drawings.collation.figures import Figures
from drawings.collation.items import items
from drawings.eye.covering import COVERED, OUTSIDE, small, veiled
from drawings.eye.sheet import SeenSheet, see
from drawings.files.enclosure import Enclosure
from drawings.measure.measure import Measured, check
from drawings.paper.limits import QUANTUM, SheetRefused
from drawings.paper.strokes import Arc, Leaf, Text
from drawings.symbols.symbols import BLOCK
from geometry.errors import DraftError
from plans.scene.sheet import SheetTable
from plans.words.words import Message, message

TOLD = 5  # mismatches told one by one
SYMBOL = abs(complex(*BLOCK)) + QUANTUM  # mm: no symbol of a pair is larger, from corner to corner


class SelfCheckFailed(DraftError):  # noqa: N818  (the exit code's own word)
    """A sheet or a comparison that failed plandraft's own check; the sheet is withheld."""

    exit_code = 5


def verify(path: Path, leaf: Leaf, faults: Callable[[Measured, Leaf], Iterable[Wrong]]) -> SeenSheet:
    """See and measure a written sheet: it is as it was laid out, it states what it shows, it has no faults of its kind.

    What is drawn on it is held to what was laid out, stroke by stroke, and that to the analysis with all its digits.
    """
    try:
        seen = see(path.read_bytes())
    except SheetRefused as refused:
        raise SelfCheckFailed(message("check.unmeasured", refusal=refused)) from refused
    laid = plain(leaf, seen.leaf.lettering)
    if wrong := [*wrongs(seen.measured, laid, faults), *obscured(laid, seen), *differences(laid, seen)]:
        raise SelfCheckFailed(message("check.sheet", marks=first(list(dict.fromkeys(wrong)))))
    return seen


def wrongs(measured: Measured, leaf: Leaf, faults: Callable[[Measured, Leaf], Iterable[Wrong]]) -> list[Wrong]:
    """List what is wrong with a measured sheet."""
    wrong: list[Wrong] = [on("on", miss.key.plan, name=miss.key.name) for miss in check(measured)]
    return [*wrong, *faults(measured, leaf), *unlettered(leaf)]


def obscured(laid: Leaf, seen: SeenSheet) -> list[Wrong]:
    """List lettering that is covered, and whatever lies off the paper or under an area larger than a symbol.

    A line may be short and end under a hinge, an arc be one of those that notch the centre of a cam's roller.
    """
    if not any(one.reason in (COVERED, OUTSIDE) for one in seen.unseen):
        return []
    figures = Figures(laid)
    right = {id(item.stroke): item for item in items(laid)}
    under = list(veiled(laid))
    own = [(right[id(one.stroke)], one.reason) for one in under]
    large = {id(one.stroke) for one in veiled(laid, small(laid, SYMBOL))}
    large -= {id(one.stroke) for one in under if isinstance(one.stroke, Arc) and one.reason == COVERED}
    held = [(item, why) for item, why in own if isinstance(item.stroke, Text) or id(item.stroke) in large]
    return [lone("hidden", item, figures, reason=reason).told for item, reason in held]


def verify_enclosure(path: Path, enclosure: Enclosure) -> None:
    """See that a written file beside the sheets has no faults."""
    wrong = list(enclosure.faults(path.read_bytes()))
    if wrong:
        raise SelfCheckFailed(message("check.enclosure", marks=first(wrong)))


def verify_set(wrong: Iterable[Wrong]) -> None:
    """See that measured sheets have no faults as a set."""
    told = list(wrong)
    if told:
        raise SelfCheckFailed(message("check.sheet", marks=first(told)))


def verify_report(wrong: Iterable[Wrong]) -> None:
    """See that a report has no faults."""
    told = list(wrong)
    if told:
        raise SelfCheckFailed(message("check.report", marks=first(told)))


def verify_scales(sheets: Sequence[tuple[Mapping[str, str], Measured]], sheet: SheetTable) -> None:
    """See that measured sheets, each with the keys of its figures, have the scales that are stated, and common ones."""
    if wrong := [*dict.fromkeys(scales.faults(sheets, sheet))]:
        raise SelfCheckFailed(message("check.sheet", marks=first(wrong)))


def verify_documents(leaves: Mapping[str, Sequence[Leaf]], sheet: SheetTable) -> None:
    """See that the sheets of a set are numbered through each document, and bear its designation."""
    if wrong := [*numbering.faults(leaves, sheet)]:
        raise SelfCheckFailed(message("check.sheet", marks=first(wrong)))


def first(wrong: list[Wrong]) -> Message | tuple[Wrong, ...]:
    """Name the first of what is wrong, and how much more there is."""
    marks, more = tuple(wrong[:TOLD]), len(wrong) - TOLD
    return message("check.more", marks=marks, count=more) if more > 0 else marks
