"""Where the masses of compensators stand: two shafts that turn against each other, and those of the couple (схема).

Each mass stands as at phi = 0; the gears are as large as the masses ask, the shafts so far below that of the crank.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import NamedTuple

from plans.bank.letters import letters, roman
from plans.model.balance.bank import Compensator

COMPENSATOR = "compensator"  # the names of the figures, before the order
MASS, COUPLED = "m", "m_M,"  # letters of the masses, and of those that make a couple
ROUND, SHARE = 1.25, 0.8  # a gear's radius in that of its mass; where that cannot be drawn, the mass's in the gear's
OF_OFFSET, OF_SHAFTS = 0.5, 0.15  # a gear's radius in offset and distance of shafts at the least
NOMINAL = 0.1  # m, radius of a gear where nothing gives a size
SMALL = 0.4  # of a gear's radius: a mass nearer to its shaft would cover it
UNDER = 1.6  # radii of a gear from the crank's shaft down to the gears of the compensator
PAIR = 2
NEAR = 1e-9  # of a unit direction


def speed(turns: int) -> str:
    """Write the speed of a shaft in that of the crank.

    >>> speed(1), speed(-2)
    ('ω', '−2ω')
    """
    return ("" if turns > 0 else "−") + (f"{abs(turns)}ω" if abs(turns) > 1 else "ω")


class Weight(NamedTuple):
    """A mass of a compensator: its letter, its shaft and its place from that one, m, and how fast it turns."""

    name: str
    shaft: complex
    arm: complex
    turns: int  # times as fast as the crank, against it with a minus
    geared: bool  # with the other one; a mass of the couple's compensator is not


class Layout(NamedTuple):
    """The compensators of one order as the sheet shows them, m from the shaft of the crank."""

    found: Compensator
    turn: complex  # direction of the reference guide on the sheet

    @property
    def name(self) -> str:
        """The name of the figure."""
        return f"{COMPENSATOR}-{self.found.asked.order}"

    @property
    def line(self) -> complex:
        """The line of the largest force of the order, from the shaft to where the guide goes."""
        angles = self.found.with_angle, self.found.against_angle
        if angles[0] is None or angles[1] is None:  # the force of one mass goes round
            return self.turn
        along = cmath.rect(1.0, (angles[0] + angles[1]) / 2)
        back = along.real < -NEAR or (along.real < NEAR and along.imag < 0)
        return self.turn * (-along if back else along)

    @property
    def across(self) -> complex:
        """The direction of a positive offset: to the left of the line."""
        return 1j * self.line

    @property
    def paired(self) -> bool:
        """Whether two masses are needed: one alone stands on the line itself."""
        return self.found.with_angle is not None and self.found.against_angle is not None

    @property
    def radii(self) -> tuple[float, float]:
        """The radii m of the masses that turn with the crank and against it; 0 where no mass is given."""
        mass = self.found.asked.mass
        return (self.found.with_crank / mass, self.found.against / mass) if mass else (0.0, 0.0)

    @property
    def known(self) -> bool:
        """Whether the radii of the masses are to scale: they are given, and none is too small."""
        return min((one for one in self.radii if one), default=0.0) > SMALL * self.gear

    @property
    def offset(self) -> float:
        """The distance m of the line of the compensators from the crank's shaft, on which a counterweight is."""
        return 0.0 if self.found.on_crank else self.found.asked.offset

    @property
    def gear(self) -> float:
        """The radius m of the gears as they are drawn."""
        shafts = (self.found.asked.shafts if self.found.couple_angle is not None else None) or 0.0
        least = max(abs(self.offset) * OF_OFFSET, shafts * OF_SHAFTS)
        return max(max(self.radii) * ROUND, least) or NOMINAL

    @property
    def middle(self) -> complex:
        """The middle between the two shafts, on the line of the compensators; the crank's shaft of a counterweight."""
        return 0j if self.found.on_crank else self.offset * self.across - (1 + UNDER) * self.gear * self.line

    def weights(self) -> Iterator[Weight]:
        """Give the masses that are needed, at phi = 0: the one that turns with the crank on the left."""
        order, found = self.found.asked.order, self.found
        angles = (found.with_angle, found.against_angle)
        for radius, angle, sense in zip(self.radii, angles, (1, -1), strict=True):
            if angle is not None:
                arm = cmath.rect(radius if self.known else SHARE * self.gear, angle) * self.turn
                shaft = self.middle + (sense * self.gear * self.across if self.paired else 0j)
                yield Weight(letters(MASS, sense * order), shaft, arm, sense * order, True)
        yield from self._couple()

    def _couple(self) -> Iterator[Weight]:
        """Give the masses of the couple's compensator, the one farther along the line first."""
        angle, shafts, order = self.found.couple_angle, self.found.asked.shafts, self.found.asked.order
        if angle is not None and shafts:
            beside = self.middle - (PAIR + ROUND) * PAIR * self.gear * self.across
            for side, prime in ((1, ""), (-1, "'")):
                arm = side * cmath.rect(SHARE * self.gear, angle) * self.turn
                yield Weight(
                    f"{COUPLED}{roman(order)}{prime}", beside + side * shafts / 2 * self.line, arm, order, False
                )

    def points(self) -> Iterator[complex]:
        """Give all true points that the figure must hold."""
        yield 0j
        for one in self.weights():
            yield from (one.shaft + side * self.gear for side in (1, -1, 1j, -1j))
