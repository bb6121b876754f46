"""An explanation (пояснение): the drafting steps behind a mark, in order, as a technique gives them to be told."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Mark, behind
from geometry.errors import DraftError
from geometry.meet import Meeting
from plans.quantity import Quantity
from plans.words.words import Message, message


class UnknownMark(DraftError, ValueError):  # noqa: N818  (the message's own word)
    """A name that no plan of the scene has."""


class Explanation(NamedTuple):
    """The steps behind a mark, with the units of plans, and of marks that have others, and what follows from them."""

    title: Message
    steps: tuple[Mark, ...]
    units: Mapping[str, str]
    notes: tuple[Message, ...] = ()
    home: str = ""  # the plan whose marks are named without it
    zeros: frozenset[Mark] = frozenset()  # marks whose coordinates are nothing but rounding


class NoMark(NamedTuple):
    """That a technique has no mark of a name: which names it has, in words, and what else it can explain."""

    names: tuple[str, ...]
    listed: Message | None
    examples: tuple[str, ...]


def explained_by(found: Sequence[Quantity], position: int, name: str) -> Explanation | NoMark:
    """Explain any mark behind what shows some quantities; named are those that are no corners of polygons."""
    marks = {mark.name: mark for mark in behind(*(mark for finding in found for mark in finding.marks))}
    if name not in marks:
        names = dict.fromkeys((*(finding.name for finding in found), *(known for known in marks if ":" not in known)))
        return NoMark(tuple(names), message("mark.marks", marks=", ".join(names)), ())
    count = max(len(finding.construction) for finding in found)
    if not 0 <= position < count:
        raise UnknownMark(message("mark.position", position=position, last=count - 1))
    title = message("explain.at", mark=name, position=position) if count > 1 else message("explain.name", mark=name)
    return Explanation(
        title, in_position(behind(marks[name]), position, count), {finding.plan: finding.unit for finding in found}
    )


def in_position(marks: Iterable[Mark], position: int, count: int) -> tuple[Mark, ...]:
    """Give marks of all numbered positions as they are in one of them."""
    return tuple(_in(mark, position, count) for mark in marks)


def _in(mark: Mark, position: int, count: int) -> Mark:
    parts = [_of(part, position, count) for part in (mark.value if isinstance(mark.value, tuple) else (mark.value,))]
    value = type(mark.value)(*parts) if isinstance(mark.value, tuple) else parts[0]
    if mark.meeting is None:
        return mark._replace(value=value)
    return mark._replace(value=value, meeting=mark.meeting._replace(**_sharp(mark.meeting, position, count)))


def _sharp(meeting: Meeting, position: int, count: int) -> dict[str, Any]:
    sides = tuple(_of(side, position, count) for side in meeting.sides)
    return {"across": _of(meeting.across, position, count), "sides": sides}


def _of(value: Any, position: int, count: int) -> Any:
    return value[position] if isinstance(value, np.ndarray) and value.shape == (count,) else value
