"""The rows of a cyclogram: what each mechanism does over the turn of the main shaft (строки циклограммы)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from plans.model.cam import DWELL, RISE, Cam
from plans.model.cyclogram import BACK, BEGIN, END, ENTRY, EXIT, LEAVE, TURN, BarRow, Cyclogram, Period

# What a span is: of a cam its phases, of the main mechanism its strokes, of its tool what it does to the work.
REST = "rest"  # a dwell of the follower where it began
WORK, IDLE, CUT, OVERRUN, BACK_OVER, FREE = "work", "idle", "cut", "overrun", "back over", "free"
EVERY = "*"  # what the data of a sheet of all cams say instead of one cam's name
STROKES, TOOL, FEED = "strokes", "tool", "feed"  # the names of the rows of a main mechanism


def rows_of(found: Cyclogram, cams: Sequence[Cam]) -> tuple[BarRow, ...]:
    """Give the rows of a machine: main mechanism, tool, cams, or where there are none when one may move."""
    return *rows_of_machine(found), *(rows_of_cams(cams) or (row_of_feed(found),))


def rows_of_cams(cams: Sequence[Cam]) -> tuple[BarRow, ...]:
    """Give a row for each cam that turns: its phases from its setting angle on."""
    return tuple(BarRow(cam.name, tuple(_phases(cam)), cam.setting) for cam in cams if not cam.translates)


def _phases(cam: Cam) -> Iterator[Period]:
    """Give the phases; their labels are the indices of their letters, several of one kind numbered."""
    kinds = [REST if phase.kind == DWELL and not phase.level else phase.kind for phase in cam.phases]
    for k, (kind, phase) in enumerate(zip(kinds, cam.phases, strict=True)):
        label = kind if kinds.count(kind) == 1 else f"{kind}\N{NO-BREAK SPACE}{kinds[: k + 1].count(kind)}"
        yield Period(cam.setting + phase.start, cam.setting + phase.end, kind, label)


def rows_of_machine(found: Cyclogram) -> tuple[BarRow, ...]:
    """Give the rows of a main mechanism: its strokes, its tool, and when an auxiliary mechanism may move."""
    return BarRow(STROKES, tuple(_strokes(found))), BarRow(TOOL, tuple(_tool(found)))


def row_of_feed(found: Cyclogram) -> BarRow:
    """Give the row of an auxiliary mechanism: it moves in the window, the rest of the turn is free for its return."""
    window = found.window
    spans = Period(window.start, window.end, RISE, RISE), Period(window.end, window.start + TURN, FREE)
    return BarRow(FEED, spans, window.start)


def _strokes(found: Cyclogram) -> Iterator[Period]:
    (begin,), (end,) = found.of(BEGIN), found.of(END)
    turn = begin.turned + (end.turned - begin.turned) % TURN
    yield Period(begin.turned, turn, WORK)
    yield Period(turn, begin.turned + TURN, IDLE)


def _tool(found: Cyclogram) -> Iterator[Period]:
    """Give what the tool does from one of its places to the next."""
    stops = [position for position in found.positions if position.role in (BEGIN, ENTRY, EXIT, END, LEAVE, BACK)]
    begin = stops[0].turned
    turned = [begin + (position.turned - begin) % TURN for position in stops]
    for (position, start), (_, end) in pairwise(zip((*stops, stops[0]), (*turned, begin + TURN), strict=True)):
        yield Period(start, end, _doing(found, position.role))


def _doing(found: Cyclogram, role: str) -> str:
    """Tell what the tool does after a position."""
    if role == ENTRY or (role == BEGIN and not found.of(ENTRY)):
        return CUT
    if role == BACK or (role == END and not found.of(BACK)):
        return BACK_OVER
    return OVERRUN
