"""Workings beside the plans: of a vector measured, of a link's rate from it (вычисления у планов)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from drawings.kinds.working import DIGITS, LENGTHS, READING, ScaleFactor, Working, at_scale
from drawings.lettering.vector_letters import with_index
from drawings.linkage.vector_plan import VECTOR, Arrow, VectorDiagram
from drawings.page.scale import Drafting, Scale
from plans.model.mechanism import Mechanism
from plans.model.motion import NOTHING


def link_working(mechanism: Mechanism, links: Sequence[int], name: str, drafting: Drafting) -> Working:
    """Write beside a figure how long some links are drawn on it."""
    return Working(
        LENGTHS, name, at_scale(lambda scale: list(_link_lines(mechanism, links, scale, drafting))), drafting
    )


def _link_lines(
    mechanism: Mechanism, links: Sequence[int], scale: Scale | None, drafting: Drafting
) -> Iterator[tuple[str, ...]]:
    factor = ScaleFactor(scale, "l", drafting)
    for link in links:
        for (first, start), (last, end) in combinations(mechanism.links[link].points.items(), 2):
            size, ends = abs(end - start), with_index(first) + with_index(last)
            if size > 0:
                letter = f"l_{{{first}{last}}}"
                yield (
                    f"{ends} = {factor.drawn(letter)}",
                    factor.of_true(size),
                    f"{factor.length(size)} {drafting.word('mm')}",
                )


def plan_working(shown: VectorDiagram, name: str, drafting: Drafting) -> Working:
    """Write beside a plan how each of its vectors is read."""
    return Working(READING, name, at_scale(lambda scale: list(_plan_lines(shown, scale, drafting))), drafting)


def _plan_lines(shown: VectorDiagram, scale: Scale | None, drafting: Drafting) -> Iterator[tuple[str, ...]]:
    point = VECTOR[shown.plan.board.subject]
    factor, largest = ScaleFactor(scale, point.symbol, drafting), max(map(abs, shown.points))
    for arrow in shown.arrows:
        size = abs(arrow.ends[1] - arrow.ends[0])
        if size <= NOTHING * largest:
            continue
        segment = with_index(arrow.start.name) + with_index(arrow.end.name)
        for letter in _letters(shown, arrow, point.symbol):
            told = f"{drafting.number(size, DIGITS)} {drafting.word(point.unit)}"
            yield f"{drafting.letter(with_index(letter))} = {factor.true(segment)}", factor.of_drawn(size), told


def _letters(shown: VectorDiagram, arrow: Arrow, symbol: str) -> Iterator[str]:
    """Give all that a vector is: the velocities of the points whose image is its end, and parts."""
    points = (*shown.plan.letters.items(), *shown.centres.items()) if arrow.absolute else ()
    names = [f"{symbol}_{name}" for name, image in points if image is arrow.end]
    yield from dict.fromkeys((*names, *shown.parts.get((arrow.start, arrow.end), ())))
