"""Scatter: within what most drawings are of a value that the slips of a hand move (рассеяние)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from geometry.meet import dot

Slopes = npt.NDArray[np.complex128]  # (sources, N): by the standard deviation of each slip
Sizes = npt.NDArray[np.float64]

SURE, POINT = 0.95, 1.959964  # the share of all drawings that is told of, and the deviations that hold so many
FLAT = 0.1481, 0.1664  # of the cubic in the fourth moment


def number_error(moved: Slopes) -> Sizes:
    """Give within what 95 per cent of the drawings are of a number that the slips move so, (N,)."""
    slips = np.real(moved)
    return np.asarray(_point(slips) * np.sqrt((slips**2).sum(axis=0)))


def size_error(vector: npt.NDArray[np.complex128], moved: Slopes) -> Sizes:
    """Give within what 95 per cent of the drawings are of the size of a vector, (N,); of a vector 0, of its place.

    A vector that is no longer than its error is looked at in a whole cloud of its ends, spread as the slips spread it.
    """
    across = np.sqrt((moved.real**2).sum(axis=0))
    skew = np.divide((moved.real * moved.imag).sum(axis=0), across, out=np.zeros_like(across), where=across != 0)
    up = np.sqrt(np.maximum((moved.imag**2).sum(axis=0) - skew**2, 0.0))
    ends = vector + _CLOUD.real[:, None] * (across + 1j * skew) + 1j * _CLOUD.imag[:, None] * up
    off = np.partition(np.abs(np.abs(ends) - np.abs(vector)), _TOLD, axis=0)[_TOLD]
    return np.asarray(off * _point(np.asarray(dot(np.asarray(vector), moved))) / POINT)


def _point(slips: Sizes) -> Sizes:
    """Give within how many standard deviations of a sum of slips 95 per cent of it are.

    Of many slips they are 1.960, of one alone, which is even within its bounds, 0.95 sqrt 3. Between them it hangs on
    the fourth moment: a cubic through the exact values of one, of three alike and of many, which gives that of two
    alike, 1.9016, and of one with another half as large, 1.834, to 0.3 per cent.
    """
    square = (slips**2).sum(axis=0)
    flat = np.divide((slips**4).sum(axis=0), square**2, out=np.zeros_like(square), where=square != 0)
    return np.asarray(POINT - FLAT[0] * flat**2 - FLAT[1] * flat**3)


_CHANCES = 1000  # points of a cloud
_TOLD = round(SURE * _CHANCES) - 1  # the one of them, by its size, that is told of: 50 lie beyond it


def _cloud(count: int) -> npt.NDArray[np.complex128]:
    """Give points spread about zero as chance spreads them, yet evenly: radii by rank, angles as in a sunflower."""
    rank = (np.arange(count) + 0.5) / count
    return np.asarray(np.sqrt(-2 * np.log1p(-rank)) * np.exp(1j * np.pi * (3 - np.sqrt(5.0)) * np.arange(count)))


_CLOUD = _cloud(_CHANCES)
