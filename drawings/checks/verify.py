"""The self-check of a written sheet: everything on it that can be measured or read is held against the analysis."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from drawings.checks.labelled import unlettered
from drawings.checks.wrong import Wrong, on
from drawings.figures.linkage.vector_plan import LETTERS
from drawings.files.enclosure import Enclosure
from drawings.measure.measure import Measured, check, measure_file
from drawings.measure.measured import MeasuredVector
from drawings.page.page import BLOCK
from drawings.page.title_cell import NUMBERS
from drawings.paper.hand import hand_of
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Leaf
from drawings.paper.walk import groups, texts
from geometry.errors import DraftError
from plans.model.order import ORDERS
from plans.scene.sheet import SheetTable
from plans.words.words import Message, message

TOLD = 5  # mismatches told one by one


class SelfCheckFailed(DraftError):  # noqa: N818  (the exit code's own word)
    """A sheet or a comparison that failed plandraft's own check; the sheet is withheld."""

    exit_code = 5


def verify(path: Path, leaf: Leaf, faults: Callable[[Measured, Leaf], Iterable[Wrong]]) -> Measured:
    """Measure a written sheet: it states what it shows, its marks have letters, and it has no faults of its kind."""
    try:
        measured = measure_file(path)
    except SheetRefused as refused:
        raise SelfCheckFailed(message("check.unmeasured", refusal=refused)) from refused
    wrong: list[Wrong] = [on("on", miss.key.plan, name=miss.key.name) for miss in check(measured)]
    wrong += [*faults(measured, leaf), *unlettered(leaf)]
    if wrong:
        raise SelfCheckFailed(message("check.sheet", marks=_first(wrong)))
    return measured


def verify_enclosure(path: Path, enclosure: Enclosure) -> None:
    """See that a written file beside the sheets has no faults."""
    wrong = list(enclosure.faults(path.read_bytes()))
    if wrong:
        raise SelfCheckFailed(message("check.enclosure", marks=_first(wrong)))


def verify_set(wrong: Iterable[Wrong]) -> None:
    """See that measured sheets have no faults as a set."""
    told = list(wrong)
    if told:
        raise SelfCheckFailed(message("check.sheet", marks=_first(told)))


def verify_report(wrong: Iterable[Wrong]) -> None:
    """See that a report has no faults."""
    told = list(wrong)
    if told:
        raise SelfCheckFailed(message("check.report", marks=_first(told)))


def verify_scales(sheets: Sequence[tuple[Mapping[str, str], Measured]], sheet: SheetTable) -> None:
    """See that measured sheets, each with the keys of its figures, have the scales that are stated, and common ones."""
    wrong: list[Wrong] = list(
        dict.fromkeys((*_not_stated(sheets, dict(sheet.scale.stated)), *_not_common(sheets, sheet)))
    )
    if wrong:
        raise SelfCheckFailed(message("check.sheet", marks=_first(wrong)))


def verify_documents(leaves: Mapping[str, Sequence[Leaf]], sheet: SheetTable) -> None:
    """See that the sheets of a set are numbered through each document, and bear its designation."""
    documents: dict[str, list[tuple[str, Leaf]]] = {}
    for kind, own in leaves.items():
        documents.setdefault(sheet.designated(kind), []).extend((kind, leaf) for leaf in own)
    wrong = [fault for name, own in documents.items() for fault in _misnumbered(name, own, sheet.standard)]
    if wrong:
        raise SelfCheckFailed(message("check.sheet", marks=_first(wrong)))


def _misnumbered(name: str, document: Sequence[tuple[str, Leaf]], standard: str) -> Iterator[Wrong]:
    """Give the sheets of a document whose title block says another number, count or designation."""
    count = len(document)
    for number, (kind, leaf) in enumerate(document, 1):
        gost = [f"{number}"] * (count > 1) + [f"{count}"] * (number == 1)
        block = [group for group in groups(leaf.groups) if group.name in (BLOCK, NUMBERS)]
        told = [text.plain for group in block if group.name == NUMBERS for text in texts(group.strokes)]
        if told != (gost if standard == "GOST" else [f"{number}/{count}"]):
            yield message("wrong.sheet_number", number=number, count=count, kind=kind)
        if name.replace(" ", "") not in "".join(text.plain for text in texts(block)).replace(" ", ""):
            yield message("wrong.designation", name=name, kind=kind)


def _not_stated(sheets: Sequence[tuple[Mapping[str, str], Measured]], stated: Mapping[str, float]) -> Iterator[Message]:
    """Give the figures whose marks have another scale than the scene states for them."""
    for keys, measured in sheets:
        for mark in (*measured.vectors, *measured.points, *measured.profiles):
            figure = f"{mark.plan.replace(' ', '-')}-"
            key = next((key for begin, key in keys.items() if figure.startswith(begin)), "")
            if mark.scale != stated.get(key, mark.scale):
                yield on("scale_stated", mark.plan)


def _not_common(sheets: Sequence[tuple[Mapping[str, str], Measured]], sheet: SheetTable) -> Iterator[Message]:
    """Give the orders of whose plans one has another scale than the others, though it could be read at theirs."""
    letter = hand_of(sheet.format, sheet.standard).letter
    for order in ORDERS[1:] if sheet.scales == "common" else ():
        plans: dict[int | None, list[MeasuredVector]] = {}
        for vector in (one for _, measured in sheets for one in measured.vectors if one.plan == order.plan):
            plans.setdefault(vector.position, []).append(vector)
        common = max((one[0].scale for one in plans.values()), default=0.0)
        if any(one[0].scale != common and _readable(one, common, letter) for one in plans.values()):
            yield on("scale_common", order.plan)


def _readable(plan: Sequence[MeasuredVector], scale: float, letter: float) -> bool:
    """Tell whether a plan that was measured could be lettered at another scale."""
    ends = [end for vector in plan for end in (vector.start, vector.end)]
    names = {name for vector in plan for name in vector.name.split(" ")}
    wide, high = (max(row) - min(row) for row in ([end.real for end in ends], [end.imag for end in ends]))
    return max(wide, high) * plan[0].scale / scale >= letter * max(LETTERS, len(names))


def _first(wrong: list[Wrong]) -> Message | tuple[Wrong, ...]:
    """Name the first of what is wrong, and how much more there is."""
    marks, more = tuple(wrong[:TOLD]), len(wrong) - TOLD
    return message("check.more", marks=marks, count=more) if more > 0 else marks
