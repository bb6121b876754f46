"""Lanes beside links: vectors that would lie on a bar, or on one another, are drawn a little aside (сдвиг векторов)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.layout.parallel_offsets import Segment, merging, offset

MOST = 4  # lanes on either side that are tried


def lanes(segments: Sequence[Segment], bars: Sequence[Segment], toward: complex, apart: float) -> list[complex]:
    """Give the shift of each vector, mm, that keeps it off bars and off those before it; most have none.

    The nearest free lane is taken, of two the one on the side of a place `toward` which they go.

    >>> lanes([(0j, 50 + 0j)], [(0j, 90 + 0j)], 50 + 20j, 3.0)
    [3j]
    """
    kept, shifts = list(bars), list[complex]()
    for segment in segments:
        free = (shift for shift in _shifts(segment, toward, apart) if _clear(offset(segment, shift), kept))
        shifts.append(next(free, 0j))
        kept.append(offset(segment, shifts[-1]))
    return shifts


def _clear(segment: Segment, kept: Sequence[Segment]) -> bool:
    return not any(merging(segment, other) for other in kept)


def _shifts(segment: Segment, toward: complex, apart: float) -> Iterator[complex]:
    start, end = segment
    across = 1j * (end - start) / abs(end - start)
    side = across if ((toward - (start + end) / 2) * across.conjugate()).real >= 0 else -across
    yield 0j
    for step in range(1, MOST + 1):
        yield from (step * apart * side, -step * apart * side)
