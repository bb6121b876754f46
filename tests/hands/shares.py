"""Shares of chance drawings in which a vector is further out than allowed: as drawn, and as its slips say."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.hand_error import EVEN

Slips = npt.NDArray[np.complex128]
REFUSED = 1e-4  # of what a fair hand draws
# Of a share in so many drawings. With some two thousand vectors at three slips one in a thousand trials is beyond it.
DEVIATIONS = 5.2


class Share(NamedTuple):
    """How many of some drawings are out of what is allowed."""

    out: int
    of: int

    @property
    def part(self) -> float:
        """The share of them."""
        return self.out / self.of

    def agrees(self, other: Share) -> bool:
        """Tell whether two shares may be of the same chance, by the binomial spread of both.

        >>> Share(40, 400).agrees(Share(220, 2000)), Share(40, 400).agrees(Share(500, 2000))
        (True, False)
        """
        both = (self.out + other.out + 1) / (self.of + other.of + 2)  # never sure
        return bool(
            abs(self.part - other.part) <= DEVIATIONS * np.sqrt(both * (1 - both) * (1 / self.of + 1 / other.of))
        )


def slips_of(moved: npt.ArrayLike, pricked: float) -> Slips:
    """Give all that moves a vector: the slips behind it, and those of its own two ends, each `pricked` at most."""
    ends = EVEN * pricked * np.array([1, 1j, 1, 1j])
    return np.concatenate((np.asarray(moved, dtype=np.complex128), ends))


def promised(slips: Slips) -> float:
    """Give how far a vector may be out that a fair hand's slips move so, in all but one of ten thousand drawings.

    It is so far spread every way as along the line on which the slips spread it most.

    >>> round(promised(np.array([1.0, 1.0j])), 4), round(promised(np.array([2.0, 1.0j])), 4)
    (4.2919, 8.5839)
    """
    total, lean = (np.abs(slips) ** 2).sum(), abs((slips**2).sum())
    return float(np.sqrt(-2 * np.log(REFUSED)) * np.sqrt((total + lean) / 2))


def foretold(slips: Slips, allowed: float, drawings: int, chance: np.random.Generator) -> Share:
    """Give the share that is beyond what is allowed where even slips move a vector in proportion.

    >>> share = foretold(np.array([EVEN]), 0.5, 4000, np.random.default_rng(1))
    >>> share.agrees(Share(2000, 4000))
    True
    """
    own = slips[slips != 0]
    even = chance.uniform(-1 / EVEN, 1 / EVEN, (drawings, len(own)))
    return Share(int((np.abs(even @ own) > allowed).sum()), drawings)
