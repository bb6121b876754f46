"""Rotors for tests: the textbook's, and any that hypothesis draws."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from hypothesis import strategies as st

from plans.model.rotor import Plane, Rotor, Unbalance

# methods.md's worked data of the book's 8.2: mass kg, radius m, angle, place from plane II
BOOK = (("0.8", "0.12", 20, "0.10"), ("1.1", "0.09", 130, "0.25"), ("0.6", "0.15", 250, "0.42"))
STATIC = (Plane("cw", Fraction(0), mass=0.5),)
DYNAMIC = (Plane("I", Fraction("0.5"), mass=0.5), Plane("II", Fraction(0), radius=0.1))


def mass(number: int, mass: str, radius: str, angle: float | Fraction, place: str | Fraction) -> Unbalance:
    """Give an unbalanced mass."""
    moment = float(Fraction(mass) * Fraction(radius))
    return Unbalance(str(number), moment, Fraction(angle), Fraction(place), float(mass), float(radius))


def masses(rows: Sequence[tuple[str, str, float, str]] = BOOK) -> tuple[Unbalance, ...]:
    """Give the masses of a table."""
    return tuple(mass(number, *row) for number, row in enumerate(rows, 1))


def static(**more: object) -> Rotor:
    """Give the textbook's rotor with one plane of correction."""
    return Rotor(masses(), STATIC, **more)  # type: ignore[arg-type]


def dynamic(**more: object) -> Rotor:
    """Give the textbook's rotor with two planes of correction."""
    return Rotor(masses(), DYNAMIC, **more)  # type: ignore[arg-type]


thousandths = st.integers(-1000, 1000).map(lambda k: Fraction(k, 1000))
angles = st.integers(-3599, 3600).map(lambda k: Fraction(k, 10))
moments = st.floats(1e-6, 10, allow_nan=False)


@st.composite
def rotors(draw: st.DrawFn, planes: int = 2) -> Rotor:
    """Draw a rotor of one to seven masses."""
    rows = draw(st.lists(st.tuples(moments, angles, thousandths), min_size=1, max_size=7))
    found = tuple(Unbalance(str(k), m, angle, place) for k, (m, angle, place) in enumerate(rows, 1))
    places = draw(st.lists(thousandths, min_size=planes, max_size=planes, unique=True))
    names = ("I", "II") if planes == 2 else ("cw",)
    return Rotor(found, tuple(map(Plane, names, places)), (Fraction(-1), Fraction(2)), 100.0, 20.0, 6.3)


def sizes(rotor: Rotor) -> float:
    """Give the sum of the static moments that a rotor and its corrections have, as far as its planes magnify them."""
    own = math.fsum(one.moment for one in rotor.masses)
    if not rotor.dynamic:
        return own
    span = abs(rotor.arm(rotor.planes[0].place))
    return own + 2 * math.fsum(one.moment * (abs(rotor.arm(one.place)) + span) for one in rotor.masses) / span
