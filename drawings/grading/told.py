"""What is told of graded sheets: lines for a teacher, plain data, and a row of the class's table (ведомость)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final, NamedTuple

from drawings.grading.asked import PlanAsked
from drawings.grading.cells.frames import frames
from drawings.grading.curves.figure_records import FigureAsked
from drawings.grading.graded import UNREAD, Graded, plan_named
from drawings.grading.marking import TABLE, Marking, points_of
from drawings.grading.scheme_arrows import COUPLE
from drawings.grading.verdict import FOLLOWS, MISSING, RIGHT, Verdict
from geometry.board import Mark
from plans.words.words import Message, because, message, word

# How the record names lines that no letter names, and the keys of their words.
LINES: Final = {"guide of": "guide", "slot of": "slot", "stone": "stone", "line of action": "action"}


class Hint(NamedTuple):
    """A step to look at again, by what is drawn in it, or by its figure, and why."""

    name: str | Message
    why: Message


def hints(plan: PlanAsked) -> Iterator[tuple[str, tuple[Hint, ...]]]:
    """Give the steps by which the vectors of a plan are found, by their names."""
    for one in plan.vectors:
        if one.found is not None:
            yield one.name, tuple(_steps(max(one.found.span, key=lambda mark: mark.number)))
    couple = Hint(plan_named(plan.plan), because("inertia_moment"))
    yield from ((name, (couple,)) for name in plan.turns if name.startswith(COUPLE))


def curve_hints(figures: Iterable[FigureAsked]) -> Iterator[tuple[str, tuple[Hint, ...]]]:
    """Give by what the values of curves are found, by their names."""
    for figure in figures:
        if figure.why is not None:
            own = Hint(plan_named(figure.plan), figure.why)
            yield from ((one.called, (own,)) for one in figure.items)


def _named(mark: Mark) -> str | Message:
    """Name what is drawn in a step: by its letters, or a line by what it is of.

    The record names its lines in one language.
    """
    for begin, key in LINES.items():
        if mark.name.startswith(begin):
            return message(f"grade.line.{key}", of=mark.name.removeprefix(begin).strip())
    return mark.name


def _steps(end: Mark) -> Iterator[Hint]:
    """Give what a place is found by: the lines that meet there, or the vector that is laid off."""
    for mark in end.step.inputs if end.step.op == "meet" else end.step.inputs[1:]:
        if isinstance(mark.step.why, Message):
            yield Hint(_named(mark), mark.step.why)
    if isinstance(end.step.why, Message):
        yield Hint(_named(end), end.step.why)


def told(own: tuple[Hint, ...]) -> tuple[Message, ...]:
    """Word hints."""
    return tuple(message("grade.hint", name=one.name, why=one.why) for one in own)


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
        return message(
            "grade.refusal" if graded.outcome == UNREAD else f"grade.outcome.{graded.outcome}", reason=graded.reason
        )
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
    points = [f"{won:g}", f"{most:g}"] if graded.reason is None else ["", ""]
    counts = [str(sum(one.kind == kind for one in graded.verdicts)) for kind in (RIGHT, FOLLOWS)]
    lost = [one for one in gathered(graded.verdicts) if one in graded.wrong or not one.name]
    what = graded.reason.worded(language) if graded.reason is not None else _summary(lost, language)
    own = [plain_name(path), graded.outcome, *points, *counts, str(len(graded.wrong)), what]
    return [f"'{cell}" if cell.startswith(_FORMULAS) else cell for cell in own]


def _summary(wrong: Sequence[Verdict], language: str) -> str:
    return "; ".join(_said(one, language) for one in wrong)
