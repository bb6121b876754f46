"""Tasks of positions: of a rod, of crank and rocker, of a point that dwells; SI: m, rad (синтез по положениям)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import Final, NamedTuple

TWO, THREE = 2, 3
FAR: Final = 3.0  # times the way between two positions: a pole farther off is not shown
TIED: Final = 9  # decimals of a merit: of mechanisms alike but for rounding the first is taken
MOST_TIMES: Final = 1000.0  # the way of a hinge: a longer link is one for a hinge that goes straight


class RodTask(NamedTuple):
    """A four-bar is wanted that guides its rod through two or three positions: places of a point D, and angles rad.

    Its hinges A and B in the first position are known, or the pivots O and C; of two positions also both arms m.
    """

    places: tuple[complex, ...]
    angles: tuple[float, ...]
    hinges: tuple[complex, complex] | None = None
    pivots: tuple[complex, complex] | None = None
    arms: tuple[float, float] | None = None

    @property
    def asked(self) -> Mapping[str, float]:
        """The demands by the letters of their sizes: where the rod lies, and what is chosen of the links."""
        spots = {f"D{k}": place for k, place in enumerate(self.places, 1)}
        spots |= zip("AB", self.hinges or (), strict=False)
        spots |= zip("OC", self.pivots or (), strict=False)
        places = {
            f"{axis}_{name}": part for name, at in spots.items() for axis, part in (("x", at.real), ("y", at.imag))
        }
        arms = zip(("l_1", "l_3"), self.arms or (), strict=False)
        return places | {f"β_{k}": angle for k, angle in enumerate(self.angles, 1)} | dict(arms)

    @property
    def moves(self) -> tuple[tuple[complex, complex], ...]:
        """How the rod goes from its first position to each: a point z to u z + shift."""
        turns = [cmath.rect(1.0, angle - self.angles[0]) for angle in self.angles]
        return tuple((turn, at - turn * self.places[0]) for turn, at in zip(turns, self.places, strict=True))

    def turn(self, i: int, j: int) -> float:
        """Give by how much the rod turns from one position to another, rad, by the shorter way."""
        return math.remainder(self.angles[j] - self.angles[i], math.tau)

    @property
    def poles(self) -> tuple[tuple[int, int], ...]:
        """The pairs of positions whose pole is not too far off to be shown."""
        return tuple((i, j) for i, j in combinations(range(len(self.places)), 2) if self._near(i, j))

    def _near(self, i: int, j: int) -> bool:
        size = max(abs(one - other) for one, other in combinations(self.places, 2)) + sum(self.arms or ())
        size += sum(abs(one - self.places[0]) for one in self.hinges or self.pivots or ())
        return abs(self.places[j] - self.places[i]) < 2 * FAR * size * abs(math.sin(self.turn(i, j) / 2))


class FunctionTask(NamedTuple):
    """A four-bar is wanted whose rocker turns with the crank as asked: angles rad of both in two or three positions.

    The crank's are from the line OC on, of the rocker's only the differences count. Crank and frame m are chosen, of
    two positions the rocker too.
    """

    inputs: tuple[float, ...]
    outputs: tuple[float, ...]
    crank: float
    frame: float
    rocker: float | None = None

    @property
    def asked(self) -> Mapping[str, float]:
        """The demands by the letters of their sizes."""
        turns = {f"ψ_1{k}": angle - self.outputs[0] for k, angle in enumerate(self.outputs[1:], 2)}
        crank = {f"φ_{k}": angle for k, angle in enumerate(self.inputs, 1)}
        lengths = {"l_1": self.crank, "l_4": self.frame} | ({"l_3": self.rocker} if self.rocker else {})
        return lengths | crank | turns


class DwellTask(NamedTuple):
    """A rocker is wanted that rests while a point K of a four-bar's coupler goes round a circle nearly.

    The four-bar's lengths m, the place of K by AK m and the angle BAK rad, the crank's angles rad from the line OC on
    where the dwell begins and ends, and the length m of the rocker that rests.
    """

    lengths: tuple[float, float, float, float]
    arm: float
    lean: float
    dwell: tuple[float, float]
    output: float
    crossed: bool = False

    @property
    def asked(self) -> Mapping[str, float]:
        """The demands by the letters of their sizes: the four-bar, K on its coupler, the dwell."""
        lengths = {f"l_{k}": length for k, length in enumerate(self.lengths, 1)}
        return lengths | {"l_K": self.arm, "β": self.lean, "φ_1": self.dwell[0], "φ_5": self.dwell[1]}

    @property
    def stations(self) -> tuple[float, ...]:
        """The five crank angles of the dwell whose places are drawn."""
        begin, end = self.dwell
        return tuple(begin + (end - begin) * k / 4 for k in range(5))


TOUCH: Final = 1e-6  # sine of the angle of two loci: flatter ones touch, and no digit of where they do is sure
PATH: Final = 181  # crank angles of a turn that the path of K is drawn by


def bent(places: Sequence[complex]) -> bool:
    """Tell whether three places are on an arc, not all but on a line: its radius is no endless length.

    >>> bent([0j, 1 + 0j, 2 + 0j]), bent([0j, 1 + 0.1j, 2 + 0j])
    (False, True)
    """
    u, v = places[1] - places[0], places[-1] - places[0]
    return abs(u * v * (u - v)) < 2 * abs((u.conjugate() * v).imag) * MOST_TIMES * max(abs(u), abs(v))


def real(lengths: Sequence[float]) -> bool:
    """Tell whether no link of a four-bar is of no length."""
    return min(lengths) > TOUCH**2 * max(lengths)
