"""Enlarged details of a force plan, of the forces that are too small to be lettered on it (выносной элемент)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.figures.forces.force_kinds import WHOLE
from drawings.figures.forces.force_polygon import ForcePolygon
from drawings.layout.parallel_offsets import Segment
from drawings.layout.picture import Picture
from drawings.page.drafting import Drafting
from drawings.paper.limits import SEEN
from drawings.symbols.polygon import ShownVector

USUAL = 2.0  # times its least size: a plan is seldom drawn larger, and what is seen then needs no detail
STUB = 0.2  # of a detail's size: how far the sides on either side of it are followed
LETTERS, MOST = 9.0, 18.0  # a detail is drawn at least so many of its letters large, and at most


def details(shown: ForcePolygon, room: Picture, drafting: Drafting, before: int) -> tuple[ForcePolygon, ...]:
    """Give the details of a force plan: of each run of sides that are not seen where it is drawn at its least size.

    One in which all would be seen at the usual size has none.
    `before` details of other plans have the first letters.
    """
    least = SEEN * max(room.wide, room.high) / room.least if room.least else 0.0
    letters = drafting.word("detail letters")
    sides = [one for one in shown.forces if one.kind != WHOLE]
    runs = [run for run in _runs(sides, least) if min(abs(sides[k].value) for k in run) < least / USUAL]
    named = zip(letters[before:], runs, strict=False)
    return tuple(
        shown._replace(forces=tuple(sides[k] for k in run), rays=tuple(_stubs(sides, run)), detail=letter)
        for letter, run in named
    )


def _runs(sides: Sequence[ShownVector], least: float) -> Iterator[list[int]]:
    """Give the runs of sides one after another that are smaller than a force, N."""
    run: list[int] = []
    for k, one in enumerate(sides):
        if abs(one.value) < least:
            run.append(k)
        elif run:
            yield run
            run = []
    if run:
        yield run


def _stubs(sides: Sequence[ShownVector], run: Sequence[int]) -> Iterator[Segment]:
    """Follow the sides before and after a run a little."""
    first, last = sides[run[0]], sides[run[-1]]
    points = [end for k in run for end in (sides[k].at, sides[k].end)]
    reach = STUB * max(abs(one - other) for one in points for other in points)
    if run[0] > 0:
        yield first.at - sides[run[0] - 1].direction * reach, first.at
    if run[-1] + 1 < len(sides):
        yield last.end + sides[run[-1] + 1].direction * reach, last.end
