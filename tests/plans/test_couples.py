"""Couples of compensators off the guide: what takes them has their moment the other way over the whole turn (8.14)."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from plans.model.balance.bank import Asked, Member
from tests.plans.drawn_banks import BOOK, drawn, summed, task


def members(*rows: tuple[int, int]) -> tuple[Member, ...]:
    """Give mechanisms in one plane by crank and guide, degrees."""
    return tuple(
        Member(str(k), Fraction(crank), Fraction(0), Fraction(axis)) for k, (crank, axis) in enumerate(rows, 1)
    )


COUPLED = {
    "along the guide": BOOK,
    "along a line of its own": task(members((0, 0), (100, -40)))._replace(asked=(Asked(2, 2.0, -0.06, 0.5),)),
    "round with the crank": task(members((25, 50), (25, -10)))._replace(asked=(Asked(2, 2.0, 0.06, 0.5),)),
    "round against it": task(members((0, 10), (0, 130), (0, 250)))._replace(asked=(Asked(2, 2.0, 0.06, 0.5),)),
}


@pytest.mark.parametrize("road", [drawn, summed])
def test_a_mass_that_turns_as_the_crank_does_has_no_offset(road) -> None:
    """A V of 90 degrees: the first harmonic goes round with the crank, and a counterweight on the crank takes it."""
    (one,) = road(task(members((25, 45), (25, -45)))._replace(asked=(Asked(1, 2.0, 0.06, 0.5),))).compensators
    assert one.on_crank and one.with_crank > 0 == one.against
    assert (one.residual, one.couple or 0.0, one.couple_angle) == (0.0, 0.0, None)


@pytest.mark.parametrize("road", [drawn, summed])
@pytest.mark.parametrize("case", COUPLED)
def test_the_couple_is_compensated(road, case) -> None:
    """Two masses in antiphase on shafts along the line of force make the couple of the offset, but the other way."""
    bank = COUPLED[case]
    ((one,), phi), (asked,) = (road(bank).compensators, np.linspace(0.0, 6.0, 13)), bank.asked
    angles, n = (one.with_angle, one.against_angle), asked.order
    line = 1.0 if None in angles else np.exp(0.5j * sum(angles))  # of a force that goes round the guide, the real axis
    ahead, back = (
        size * np.exp(1j * (angle or 0.0)) for size, angle in zip((one.with_crank, one.against), angles, strict=True)
    )
    force = ahead * np.exp(1j * n * phi) + back * np.exp(-1j * n * phi)
    offset = (np.conj(1j * asked.offset * line) * force).imag
    pair = one.couple * asked.shafts * (np.conj(line) * np.exp(1j * (n * phi + one.couple_angle))).imag
    assert np.abs(offset).max() > 0.9 * one.residual / (n * bank.speed) ** 2 > 0
    assert np.allclose(pair, -offset, rtol=0, atol=1e-13 * np.abs(offset).max())
