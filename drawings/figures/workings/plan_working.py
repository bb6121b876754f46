"""How velocities and accelerations are read off a plan: v_B = pb·μ_v with the numbers put in (чтение плана)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.figures.linkage.vector_plan import VECTOR, Arrow, VectorDiagram
from drawings.figures.workings.working import DIGITS, READING, ScaleFactor, Working, at_scale
from drawings.lettering.indices import with_index
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale
from plans.model.motion import NOTHING


def working(shown: VectorDiagram, name: str, drafting: Drafting) -> Working:
    """Write beside a plan how each of its vectors is read."""
    return Working(READING, name, at_scale(lambda scale: list(_lines(shown, scale, drafting))), drafting)


def _lines(shown: VectorDiagram, scale: Scale | None, drafting: Drafting) -> Iterator[tuple[str, ...]]:
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
