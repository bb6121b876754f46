"""What is told of graded sheets: lines for a teacher, plain data, and a row of the class's table (ведомость)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from drawings.grading.cells.frames import frames
from drawings.grading.graded import MARKED, Graded
from drawings.grading.hints import Hint, told
from drawings.grading.marking import TABLE, Marking, points_of
from drawings.grading.plan_names import plan_named
from drawings.grading.verdict import FOLLOWS, MISSING, RIGHT, Verdict
from plans.words.words import Message, message, word

Hints = Mapping[str, tuple[Hint, ...]]
_FORMULAS = ("=", "+", "-", "@", "\t", "\r")  # by which a spreadsheet knows a formula
HEAD = ("sheet", "outcome", "points", "of", "right", "follows", "mistakes", "what")


def lines(path: Path, graded: Graded, marking: Marking, hints: Hints, language: str) -> Iterator[str]:
    """Tell of one sheet, line by line."""
    yield f"{plain_name(path)}: {_heading(graded, marking).worded(language)}"
    yield from (f"  {with_values(one, hints, language)}" for one in gathered(graded.verdicts) if not one.good)
    if follow := tuple(_placed(one) for one in graded.verdicts if one.kind == FOLLOWS):
        yield f"  {word(language, 'grade.follow', names=follow)}"


def _placed(one: Verdict) -> str:
    """Name a quantity with its position, if it has one."""
    return one.name if one.position is None else f"{one.name} ({one.position})"


def gathered(verdicts: Sequence[Verdict]) -> Iterator[Verdict]:
    """Give verdicts with those of a plan, or of a table, that is not there at all as one."""
    for own in _together(verdicts, lambda one: one.plan if one.plan.startswith(TABLE) else (one.plan, one.position)):
        if own[0].plan.startswith(TABLE) and all(one.kind == MISSING for one in own):
            cells = [cell for one in own for cell in one.frames]
            yield own[0]._replace(name="", position=None, frames=frames(cells))
            continue
        for plan in _together(own, lambda one: one.position):
            yield from [plan[0]._replace(name="")] if all(one.kind == MISSING for one in plan) else plan


def _together(verdicts: Iterable[Verdict], key: Callable[[Verdict], object]) -> Iterable[list[Verdict]]:
    """Lay together what has one key, in the order of the first of each."""
    found: dict[object, list[Verdict]] = {}
    for one in verdicts:
        found.setdefault(key(one), []).append(one)
    return found.values()


def plain_name(path: Path) -> str:
    """Write the name of a file that may hold anything: without signs that a terminal obeys."""
    return "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in str(path))


def _heading(graded: Graded, marking: Marking) -> Message:
    if graded.reason is not None:
        return message(f"grade.outcome.{graded.outcome}", reason=graded.reason)
    won, most = points_of(graded.verdicts, marking)
    return message(f"grade.outcome.{graded.outcome}", won=f"{won:g}", most=f"{most:g}")


def with_values(one: Verdict, hints: Hints, language: str) -> str:
    """Tell what is wrong, by how much of what is allowed, and which step to look at again."""
    told_ = _said(one, language)
    if one.off is not None and one.allowed is not None:
        off, allowed = f"{one.off:.3g}", f"{one.allowed:.2g}"
        told_ = word(language, "grade.off", told=told_, off=off, allowed=allowed, unit=one.unit)
    return _again(one, told_, hints, language)


def without_values(one: Verdict, hints: Hints, language: str) -> str:
    """Tell what is wrong and which step to look at again, and nothing from which the right value can be had."""
    return _again(one, _said(one, language), hints, language)


def _said(one: Verdict, language: str) -> str:
    kind = word(language, f"grade.kind.{one.kind}")
    kind = word(language, "grade.of", kind=kind, of=one.of) if one.of else kind
    where = plan_told(one.plan, one.position)
    return word(language, "grade.vector" if one.name else "grade.whole", where=where, name=one.name, kind=kind)


def plan_told(plan: str, position: int | str | None) -> Message:
    """Name a plan, with its position if it has one."""
    return message("grade.plan" if position is not None else "grade.figure", plan=plan_named(plan), position=position)


def _again(one: Verdict, told_: str, hints: Hints, language: str) -> str:
    steps = told(hints.get(one.name, ()))
    return word(language, "grade.again", told=told_, steps=steps) if steps else told_


def plain(path: Path, graded: Graded, marking: Marking, language: str) -> dict[str, object]:
    """Give one sheet as plain data."""
    won, most = points_of(graded.verdicts, marking)
    return {
        "sheet": str(path),
        "outcome": graded.outcome,
        "reason": None if graded.reason is None else graded.reason.worded(language),
        "points": won if graded.reason is None else None,
        "of": most if graded.reason is None else None,
        "digest": graded.digest,
        "verdicts": [_plain(one) for one in graded.verdicts],
    }


def _plain(one: Verdict) -> dict[str, object]:
    return {
        "plan": one.plan, "position": one.position, "quantity": one.name, "verdict": one.kind,
        "of": one.of, "off": one.off, "allowed": one.allowed, "unit": one.unit,
    }  # fmt: skip


def row(path: Path, graded: Graded, marking: Marking, language: str) -> list[str]:
    """Give one sheet as a row of the class's table; nothing in it is a formula to a spreadsheet."""
    won, most = points_of(graded.verdicts, marking)
    points = [f"{won:g}", f"{most:g}"] if graded.outcome in MARKED else ["", ""]
    counts = [str(sum(one.kind == kind for one in graded.verdicts)) for kind in (RIGHT, FOLLOWS)]
    lost = [one for one in gathered(graded.verdicts) if one in graded.wrong or not one.name]
    what = graded.reason.worded(language) if graded.reason is not None else _summary(lost, language)
    own = [plain_name(path), graded.outcome, *points, *counts, str(len(graded.wrong)), what]
    return [f"'{cell}" if cell.startswith(_FORMULAS) else cell for cell in own]


def _summary(wrong: Sequence[Verdict], language: str) -> str:
    return "; ".join(_said(one, language) for one in wrong)
