"""How vectors of a polygon are laid off: [m_1D_1] = m_1D_1/μ_mD with the numbers put in (отрезки многоугольника)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.figures.workings.working import SEGMENTS, ScaleFactor, Working, at_scale
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale


def working(sizes: Mapping[str, float], symbol: str, name: str, drafting: Drafting) -> Working:
    """Write beside a polygon how long its vectors are drawn: true sizes by their letters, `symbol` of the scale."""
    return Working(SEGMENTS, name, at_scale(lambda scale: list(_lines(sizes, symbol, scale, drafting))), drafting)


def _lines(
    sizes: Mapping[str, float], symbol: str, scale: Scale | None, drafting: Drafting
) -> Iterator[tuple[str, ...]]:
    factor = ScaleFactor(scale, symbol, drafting)
    for letter, size in sizes.items():
        yield (
            f"[{letter}] = {factor.drawn(letter)}",
            factor.of_true(size),
            f"{factor.length(size)} {drafting.word('mm')}",
        )
