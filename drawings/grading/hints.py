"""Hints: which step of a construction to look at again, and nothing of what it gives (подсказка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Final, NamedTuple

from drawings.grading.asked import PlanAsked
from drawings.grading.curves.asked_figure import FigureAsked
from drawings.grading.plan_names import plan_named
from drawings.grading.polygons.scheme_arcs import COUPLE
from geometry.board import Mark
from plans.words.words import Message, because, message

# How the record names lines that no letter names, and the keys of their words.
LINES: Final = {"guide of": "guide", "slot of": "slot", "stone": "stone", "line of action": "action"}
Steps = Mapping[tuple[str, int | None, str], tuple[Message, ...]]


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
