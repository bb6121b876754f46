"""How the lengths of links are laid off: AB = l_AB/μ_l with the numbers put in (длины звеньев на чертеже)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from drawings.figures.workings.working import LENGTHS, ScaleFactor, Working, at_scale
from drawings.lettering.indices import with_index
from drawings.page.drafting import Drafting
from drawings.page.scale import Scale
from plans.model.mechanism import Mechanism


def working(mechanism: Mechanism, links: Sequence[int], name: str, drafting: Drafting) -> Working:
    """Write beside a figure how long some links are drawn on it."""
    return Working(LENGTHS, name, at_scale(lambda scale: list(_lines(mechanism, links, scale, drafting))), drafting)


def _lines(
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
