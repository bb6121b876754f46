"""The stands of hinges, looked for among lines: two legs, a base, and all of its hatching (стойки, штриховка)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from drawings.symbols.symbols import DOUBLE, HATCH, HATCH_STEP, STAND

if TYPE_CHECKING:
    from drawings.checks.linkage.laid_poses import Flags, Segments

ROUNDED = 1e-2  # mm: the size of a symbol is read off strokes that are rounded
ALONE = 1e-6  # of a step of hatching: a length of so nearly whole steps may count as one more or not


class Stand(NamedTuple):
    """A stand: its factor of the sizes of symbols, and which lines it is of."""

    size: float
    own: Flags


def stands(lines: Segments, spot: complex) -> Iterator[Stand]:
    """Give the stands of a place on paper that are whole, whichever way they go."""
    height, half, more = STAND
    for start, end in zip(*(spots.tolist() for spots in lines), strict=True):
        size, off = abs(end - start) / (2 * (half + more)), (start + end) / 2 - spot
        if size and abs(abs(off) - height * size) <= ROUNDED:
            own = _stand(lines, spot, off / abs(off), size)
            if own is not None:
                yield Stand(size, own)


def _stand(lines: Segments, spot: complex, way: complex, size: float) -> Flags | None:
    """Tell which lines a stand of a size consists of; None where it is not whole."""
    height, half, more = (part * size for part in STAND)
    low, high = (spot + way * complex(height, side * (half + more)) for side in (-1, 1))
    base = _joins(lines, low, high)
    legs = [_leg(lines, spot, spot + way * complex(height, side * half), size) for side in (-1, 1)]
    lined = hatching(lines, low, high, way, size)
    if lined is None or not base.any() or not all(one.any() for one in legs):
        return None
    return np.asarray(base | legs[0] | legs[1] | lined)


def _leg(lines: Segments, spot: complex, foot: complex, size: float) -> Flags:
    """Tell which lines run from a hinge's circle to a foot of its stand."""
    way = (foot - spot) / abs(foot - spot)
    found = np.zeros(len(lines.starts), dtype=bool)
    for near, far in ((lines.starts, lines.ends), (lines.ends, lines.starts)):
        off = (near - spot) * np.conj(way)
        begun = (np.abs(off.imag) <= ROUNDED) & (off.real > 0) & (off.real <= DOUBLE[0] * size + ROUNDED)
        found |= begun & (np.abs(far - foot) <= ROUNDED)
    return found


def _joins(lines: Segments, one: complex, other: complex) -> Flags:
    there = np.maximum(np.abs(lines.starts - one), np.abs(lines.ends - other))
    back = np.maximum(np.abs(lines.starts - other), np.abs(lines.ends - one))
    return np.asarray(np.minimum(there, back) <= ROUNDED)


def hatching(lines: Segments, start: complex, end: complex, into: complex, size: float) -> Flags | None:
    """Tell which lines hatch a base on one side: all that must, evenly along it; None where one of them lacks."""
    length = abs(end - start)
    along = (end - start) / length
    lean, side = HATCH * size * math.sqrt(0.5), math.copysign(1.0, (into * along.conjugate()).imag)
    one, other = ((spots - start) * np.conj(along) for spots in lines)
    swapped = np.abs(one.imag) > np.abs(other.imag)
    feet, tips = np.where(swapped, other, one), np.where(swapped, one, other)
    for turn in (-1, 1):
        leaning = np.abs(tips - feet - lean * complex(turn, side)) <= ROUNDED
        for due in _feet(0.0 if turn > 0 else lean, length - lean, HATCH_STEP * size):
            at = leaning & (np.abs(feet[:, None] - due[None, :]) <= 2 * ROUNDED).T
            if at.any(axis=1).all():
                return np.asarray(at.any(axis=0))
    return None


def _feet(first: float, length: float, step: float) -> Iterator[np.ndarray[tuple[int], np.dtype[np.float64]]]:
    """Give where hatching stands along a base: evenly over a length, as many as whole steps of it have room."""
    for count in {max(math.floor(length / step + slack), 1) for slack in (-ALONE, ALONE)}:
        yield first + length * np.arange(count + 1) / count
