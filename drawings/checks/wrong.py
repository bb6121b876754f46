"""What is wrong with a written sheet, by its key among the words (расхождение)."""

from __future__ import annotations

from typing import TypeAlias

from plans.words.words import ENGLISH, Message, message, words

Wrong: TypeAlias = Message | str


def on(key: str, plan: str, **parts: object) -> Message:
    """Say what is wrong on a plan or a figure, by the names of its marks.

    >>> on("letter", "forces-2-3", name="R_12").worded("ru")
    'буква R_12 (план сил 2-3)'
    """
    return message(f"wrong.{key}", plan=_figure(plan), **parts)


def within(key: str, where: str, **parts: object) -> Message:
    """Say what is wrong in a table or in the notes of a sheet, by the name of its figure.

    >>> str(within("cell", "masses", name="II", text="0.5"))
    '0.5 for II in the table of masses'
    """
    return message(f"wrong.{key}", where=where, **parts)


def _figure(plan: str) -> Wrong:
    """Name the figure of a group of links or a pair; any other by the word for its plan."""
    if f"plan.{plan}" in words(ENGLISH):
        return plan
    kind, _, which = plan.partition("-")
    return message(f"figure.{kind}", which=which) if which and f"figure.{kind}" in words(ENGLISH) else plan
