"""Mass centres off their links' lines, each tied to its link by a thin line (центр масс вне звена)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.figures.linkage.pairs import Joints
from drawings.paper.strokes import Line
from drawings.symbols.symbols import MASS


def ties(joints: Joints) -> Iterator[Line]:
    """Tie each mass centre that its link's lines do not reach to the nearest place of the link."""
    for name, spot in joints.centres.items():
        foot = min(_feet(joints, _link(joints, name), spot), key=lambda foot: abs(foot - spot))
        if abs(foot - spot) > MASS * joints.hand.symbol:
            yield Line(foot, spot, joints.hand.other)


def _link(joints: Joints, name: str) -> int:
    masses, links = joints.bones.masses, joints.bones.mechanism.links
    return masses[name][0] if name in masses else next(n for n in sorted(links) if name in links[n].points)


def _feet(joints: Joints, link: int, spot: complex) -> Iterator[complex]:
    """Give the nearest place of each bar of a link; of a link of one point alone its point."""
    outline = next(one for one in joints.outlines if one.link == link)
    bars = [(start, end) for start, end in joints.placed(outline) if start != end]
    yield from (nearest(start, end, spot) for start, end in bars)
    if not bars:
        numbered, k = joints.bones.numbered, joints.bones.shown
        yield from (joints.place.on(complex(numbered.of(link, own)[k])) for own in numbered.links[link].points.values())


def nearest(start: complex, end: complex, spot: complex) -> complex:
    """Give the place of a piece of a line that is nearest to a spot.

    >>> nearest(0j, 4 + 0j, 3 + 2j), nearest(0j, 4 + 0j, 7 + 2j)
    ((3+0j), (4+0j))
    """
    share = ((spot - start) * (end - start).conjugate()).real / abs(end - start) ** 2
    return start + min(max(share, 0.0), 1.0) * (end - start)
