"""Marks of a cam by the names that `explain` takes: O, D, K, P, Q, T_1 ..., of one of several cams as K2:P (точки)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from geometry.board import GIVEN, Board, Mark
from geometry.meet import Meeting
from geometry.steps import behind
from plans.cam.study import PROFILE, SIZES, CamDrawing, CamStudy
from plans.explanation import Explanation, NoMark, UnknownMark
from plans.words.words import message

if TYPE_CHECKING:
    from plans.study import Study

OF = ":"  # between the name of a cam and the name of a mark
UNITS = {SIZES: "m", PROFILE: "m", "law": ""}
EXAMPLES = ("P", "Q", "D")


def marks(study: Study, position: int, name: str) -> Explanation | NoMark:
    """Give the steps behind a mark of a cam's profile in one numbered position, or of its sizes."""
    cams: CamStudy = study["cam"]
    drawing, own = _asked(cams, name)
    count = len(drawing.turned)
    if not 0 <= position < count:
        raise UnknownMark(message("mark.position", position=position, last=count - 1))
    found = [one for board in _boards(drawing, position) for one in board if one.name == own]
    mark = min(found, key=lambda one: one.role == GIVEN, default=None)  # what one board is given another may construct
    if mark is None:
        return NoMark(tuple(dict.fromkeys(_names(drawing))), None, EXAMPLES)
    angle = f"{math.degrees(drawing.turned[position]):.4f}"
    steps = tuple(_in(one, position, count) for one in behind(mark))
    return Explanation(message("explain.title", mark=name, position=position, angle=angle), steps, UNITS)


def _in(mark: Mark, position: int, count: int) -> Mark:
    """Give a mark of all numbered positions as it is in one of them."""
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


def _asked(cams: CamStudy, name: str) -> tuple[CamDrawing, str]:
    """Tell which cam's mark is asked for: without a cam's name the first one's."""
    cam, found, own = name.rpartition(OF)
    drawings = [*cams.drawings.values()]
    return (cams.drawings[cam], own) if found and cam in cams.drawings else (drawings[0], name)


def _boards(drawing: CamDrawing, position: int) -> Iterator[Board]:
    """Give the profile drawn at one position alone, then the sizes, then the diagrams of the law."""
    yield from drawing.profile(drawing.turned[position : position + 1]).boards
    yield from drawing.sizing.boards
    yield drawing.diagrams.board


def _names(drawing: CamDrawing) -> Iterator[str]:
    return (mark.name for board in _boards(drawing, 0) for mark in board)
