"""How vectors of a polygon are laid off and read: [G_2] = G_2/μ_F, R_12 = [R_12]·μ_F (отрезки многоугольника)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.figures.workings.working import DIGITS, READING, SEGMENTS, ScaleFactor, Working, at_scale
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale


def working(sizes: Mapping[str, float], symbol: str, name: str, drafting: Drafting, shortest: float = 0.0) -> Working:
    """Write beside a polygon how long its vectors are drawn: true sizes by their letters, `symbol` of the scale.

    Those that are shorter than the `shortest`, mm, are passed over.
    """
    lines = at_scale(lambda scale: list(_laid(_seen(sizes, scale, shortest), ScaleFactor(scale, symbol, drafting))))
    return Working(SEGMENTS, name, lines, drafting)


def reading(
    sizes: Mapping[str, float], symbol: str, unit: str, name: str, drafting: Drafting, shortest: float
) -> Working:
    """Write beside a polygon how large the vectors are that it gives; those that are not to be seen are passed over."""
    lines = at_scale(
        lambda scale: list(_read(_seen(sizes, scale, shortest), unit, ScaleFactor(scale, symbol, drafting)))
    )
    return Working(READING, name, lines, drafting)


def _seen(sizes: Mapping[str, float], scale: Scale | None, shortest: float) -> dict[str, float]:
    """Give the vectors that are long enough on paper; all before their scale is known."""
    return {letter: size for letter, size in sizes.items() if scale is None or size >= shortest * scale.mu}


def _laid(sizes: Mapping[str, float], factor: ScaleFactor) -> Iterator[tuple[str, ...]]:
    mm = factor.drafting.word("mm")
    for letter, size in sizes.items():
        yield f"[{letter}] = {factor.drawn(letter)}", factor.of_true(size), f"{factor.length(size)} {mm}"


def _read(sizes: Mapping[str, float], unit: str, factor: ScaleFactor) -> Iterator[tuple[str, ...]]:
    drafting = factor.drafting
    for letter, size in sizes.items():
        told = f"{drafting.number(size, DIGITS)} {drafting.word(unit)}"
        yield f"{letter} = {factor.true(f'[{letter}]')}", factor.of_drawn(size), told
